# The pages in headless Chromium, at the width of a desk and of a phone: they render, stay in their width, ask for nothing and log
# nothing. Left out where Chromium is not installed.
. "$(dirname "$0")/../cli/check.sh"
browser=
for name in chromium chromium-browser google-chrome; do
  if command -v $name >/dev/null 2>&1; then browser=$name && break; fi
done
if [ -z "$browser" ]; then
  echo "left out: no Chromium (Debian package chromium)"
  exit 0
fi

# look PAGE WIDTH: puts the page into a frame of that width, unscripted as it is, and asks what became of it; to `out`, what was
# logged to `err`. The frame's own address is no request.
look() {
  {
    printf '<!doctype html><meta charset=utf-8><body><iframe style="border:0;width:%spx;height:9000px"></iframe><pre id=said></pre><script>\n' "$2"
    printf 'const page = new TextDecoder().decode(Uint8Array.from(atob("%s"), c => c.charCodeAt(0)));\n' "$(base64 -w 0 "$1")"
    cat <<'SCRIPT'
const frame = document.querySelector('iframe');
frame.onload = () => {
  const inner = frame.contentDocument, root = inner.documentElement;
  const boxes = [...inner.querySelectorAll('svg')].map(svg => svg.getBoundingClientRect());
  const requests = frame.contentWindow.performance.getEntriesByType('resource').map(r => r.name).filter(n => !n.startsWith('data:'));
  document.querySelector('#said').textContent = JSON.stringify({
    title: inner.title, overflow: root.scrollWidth > frame.clientWidth, rows: inner.querySelectorAll('tbody tr').length,
    pictures: boxes.length, empty: boxes.filter(b => b.width < 50 || b.height < 30).length, requests});
};
frame.srcdoc = page;
</script>
SCRIPT
  } >framed.html
  timeout 60 $browser --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" --enable-logging=stderr --v=0 \
    --virtual-time-budget=5000 --dump-dom "file://$work/framed.html" >dom 2>log
  status=$?
  sed -n 's/.*<pre id="said">\(.*\)<\/pre>.*/\1/p' dom >out
  grep 'CONSOLE' log >err
}

# fine NAME TITLE PICTURES: the last look found a whole page.
fine() {
  if [ "$status" != 0 ]; then fail "$1: the browser ends well"; fi
  grep -q "\"title\":\"$2\",\"overflow\":false,\"rows\":[1-9][0-9]*,\"pictures\":$3,\"empty\":0,\"requests\":\[\]" out || fail "$1"
  if [ -s err ]; then fail "$1: nothing is logged"; fi
}

"$graze" certify --cases 300 --html pass.html >/dev/null
"$graze" certify --cases 300 --kernel cramer --html fail.html >/dev/null
"$graze" certify --cases 100 --compare graze textbook-stable cramer --families far-small,edge-corner,random --html compared.html >/dev/null
for width in 390 1200; do
  look pass.html $width
  fine "a pass, $width pixels" "graze certify: graze" 2
  look fail.html $width
  fine "a failure, $width pixels" "graze certify: cramer" 14
  look compared.html $width
  fine "kernels side by side, $width pixels" "graze certify: 3 kernels" 2
done

# The look sees what it is to see.
sed 's#<h1>#<img src="https://example.invalid/x.png"><script>console.error("planted")</script><h1>#' pass.html >planted.html
look planted.html 1200
grep -q 'requests":\["https://example.invalid/x.png' out || fail "a request is seen"
grep -q planted err || fail "an error is seen"
sed 's#<h1>#<h1 style="width:3000px">#' pass.html >planted.html
look planted.html 390
grep -q '"overflow":true' out || fail "an overflow is seen"
finish

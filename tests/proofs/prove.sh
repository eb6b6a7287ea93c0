#!/bin/sh
# prove.sh SCRIPT: every goal of a Gappa script must be proven, and no longer all of them once any one of its bounds is halved.
# A script is definitions, then goals, each from a line that opens with `{`; gappa takes one goal at a time, with all definitions. Where a
# definition says `# and VALUE`, each goal is proven with that value too.
# Exit status: 0 so it is, 1 not, 2 the script cannot be read.
set -eu
script=$1
[ -r "$script" ] || {
  echo "prove.sh: $script cannot be read" >&2
  exit 2
}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# fails FILE: the first goal that is not proven, and why; status 1 if all are.
fails() {
  fails_once "$1" && return 0
  grep -q '; *# and ' "$1" || return 1
  sed 's|^\([a-z]* = \)[0-9b-]*;\( *# and \)\(.*\)|\1\3;\2it|' "$1" >"$folder/other"
  fails_once "$folder/other"
}
fails_once() {
  rm -f "$folder"/goal*
  awk -v folder="$folder" '
    /^{/ { ++goals }
    goals == 0 { definitions = definitions $0 "\n"; next }
    { text[goals] = text[goals] $0 "\n" }
    END { for (i = 1; i <= goals; ++i) printf "%s%s", definitions, text[i] > sprintf("%s/goal%03d", folder, i) }' "$1"
  [ -e "$folder/goal001" ] || {
    echo "there is no goal in it"
    return 0
  }
  for goal in "$folder"/goal*; do
    timeout 60 gappa -Eprecision=150 "$goal" >"$folder/said" 2>&1 && continue
    sed -n '/^{/,$p' "$goal"
    grep -v '^Warning' "$folder/said" || :
    return 0
  done
  return 1
}

if fails "$script"; then
  echo "$script is not proven"
  exit 1
fi
count=0
for bound in $(sed -n 's/^\([a-z0-9_]*\) = [0-9b-]*; *# bound: .*/\1/p' "$script"); do
  sed "s|^$bound = \([0-9b-]*\);|$bound = \1 / 2;|" "$script" >"$folder/halved"
  if ! fails "$folder/halved" >/dev/null; then
    echo "$script: proven with half of $bound too: the constant is too large, or the script does not use it"
    exit 1
  fi
  count=$((count + 1))
done
[ "$count" -gt 0 ] || {
  echo "$script: proves no bound"
  exit 1
}
echo "$script: proven; with half of any of its $count bounds it is not"

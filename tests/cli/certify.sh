# graze certify: verdict, table, replay, report, exit status, and what it refuses.
. "$(dirname "$0")/check.sh"

# json FILE FIELD: a field of a report, or FIELD;FIELD;... of fields within; an error where the file is not JSON. CMake is there, a JSON tool need not be.
cat >json.cmake <<'SCRIPT'
file(READ ${FILE} text)
string(JSON value GET "${text}" ${FIELD})
message("${value}")
SCRIPT
json() { cmake "-DFILE=$1" "-DFIELD=$2" -P json.cmake 2>&1; }

run certify --cases 200 --json report.json </dev/null
expect_like "the kernel passes" 0 out "PASS  graze: "
expect_like "no number is misrounded" 0 out "0 wrong kinds, 0 with a number not correctly rounded, worst error <= 0.5 ulp, 0 lost rays"
if [ "$(head -n 1 out | cut -c 1-4)" != PASS ]; then fail "the verdict comes first"; fi
expect_like "families are told" 0 out "quaternion-tangent"
expect_like "generated meshes are told" 0 out "icosphere-4: edge midpoints"
if [ -s err ]; then fail "nothing wanted on stderr"; fi
if [ "$(json report.json verdict)" != pass ] || [ "$(json report.json 'scope;seed')" != 1 ]; then fail "the report is JSON and says the same"; fi

run certify --cases 200 --families edge-corner,coplanar </dev/null
expect_like "families by name run alone" 0 out "edge-corner"
if grep -q -e icosphere -e random out; then fail "other rows are not wanted"; fi
cp out first
run certify --cases 200 --families edge-corner,coplanar </dev/null
sed 's/ [0-9.]* s)//' first >a; sed 's/ [0-9.]* s)//' out >b
cmp -s a b || fail "the same seed gives the same table"

run certify --cases 500 --kernel textbook-naive --families quaternion-tangent,implicit </dev/null
expect_like "a textbook kernel fails" 1 out "FAIL  textbook-naive: "
expect_like "its offenders are told" 1 out "lost hit"
expect_replays "a textbook kernel"

# Floating-point modes: the kernel is called in them, the oracles are not.
run certify --cases 500 --kernel textbook-naive --families random --float-mode nearest </dev/null
grep "^random  *double" out >nearest
if grep -q "mode" out; then fail "the default mode is not worth a word"; fi
for mode in up down zero; do
  run certify --cases 500 --kernel textbook-naive --families random --float-mode $mode --json report.json </dev/null
  expect_like "misrounded where rounding is $mode" 1 out ", rounding "
  grep "^random  *double" out >other
  if cmp -s nearest other; then fail "rounding $mode changes what a textbook kernel answers"; fi
  if [ "$(json report.json 'scope;float_modes;0')" != $mode ]; then fail "the report says $mode"; fi
  expect_replays "rounding $mode"
  grep -q -e "--float-mode $mode" command || fail "the replay command says $mode"
done
run certify --cases 500 --kernel textbook-naive --families range --float-mode ftz-daz </dev/null
expect_like "subnormal numbers are flushed" 1 out "FAIL  textbook-naive"
expect_replays "with subnormal numbers flushed"
run certify --cases 100 --families range --json report.json </dev/null
expect_like "graze promises all modes" 0 out "(seed 1, all 5 floating-point modes, "
expect_like "an answer in each" 0 out "range                  double           500"
if [ "$(json report.json 'scope;float_modes' | tr -d ' \n')" != '["nearest","up","down","zero","ftz-daz"]' ]; then fail "all modes are told"; fi
run certify --cases 100 --families range --float-mode down,nearest </dev/null
expect_like "some modes" 0 out "(seed 1, the default rounding mode, rounding downward, "
run certify --cases 100 --families range --float-mode sideways </dev/null
expect_like "no such mode" 2 err "graze: --float-mode sideways: there are nearest, up, down, zero, ftz-daz, all"

for kernel in textbook-stable textbook-repaired haines-sphere goualard-quadratic pbrt-interval woop-watertight cgal-epick \
  cramer moller-trumbore; do
  run certify --cases 200 --kernel $kernel </dev/null
  expect_like "$kernel fails" 1 out "FAIL  $kernel: "
done
expect_like "and loses rays" 1 out "icosphere-4: corners"

run certify --kernel nonesuch </dev/null
expect_like "unknown kernel" 2 err "no kernel is named 'nonesuch'; there are: graze, "
run certify --families nonesuch </dev/null
expect_like "unknown family" 2 err "no family is named 'nonesuch'; there are: quaternion-tangent, "
run certify --cases 0 </dev/null
expect_like "no cases" 2 err "--cases"
run certify --cases many </dev/null
expect_like "cases that are no number" 2 err "--cases"
run certify --json no/such/folder/report.json --cases 10 --families pell </dev/null
expect_like "a report that cannot be written" 2 err "no/such/folder/report.json: cannot be written"

run certify --mesh missing.off </dev/null
expect_like "no such mesh" 2 err "missing.off: no such file"
mkdir folder.off
run certify --mesh folder.off </dev/null
expect_like "a folder for a mesh" 2 err "folder.off: is a folder"
echo "not a mesh" >broken.off
run certify --mesh broken.off </dev/null
expect_like "not a mesh" 2 err "broken.off:1: an integer is wanted where"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >open.off
run certify --mesh open.off </dev/null
expect_like "an open mesh" 2 err "open.off: is not closed: the edge from point 0 to point 1 has no reverse"
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' >closed.off
run certify --mesh closed.off --families pell --cases 10 </dev/null
expect_like "a mesh of one's own" 0 out "closed.off: corners"
printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 2 1\n3 0 1 2\n' >flat.off
run certify --mesh flat.off --families pell --cases 10 </dev/null
expect_like "a closed mesh without an inside" 2 out "no point inside the mesh was found"
expect_like "is no pass" 2 out "INCOMPLETE  graze"
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 7\n3 0 3 2\n3 1 2 3\n' >index.off
run certify --mesh index.off </dev/null
if [ "$status" != 2 ] || ! grep -qF index.off err; then fail "an index out of range is refused by name"; fi
printf 'OFF\n4 4 0\n0 0 nan\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' >nan.off
run certify --mesh nan.off </dev/null
if [ "$status" != 2 ] || ! grep -qF nan.off err; then fail "a mesh with NaN is refused by name"; fi

# An interrupted run tells what it has and leaves a whole report.
"$graze" certify --cases 100000000 --families random --json partial.json >out 2>err &
runner=$!
sleep 1
kill -INT $runner
wait $runner
status=$?
expect_like "interrupted" 2 out "INCOMPLETE  graze: "
if [ "$(json partial.json complete)" != OFF ]; then fail "the interrupted report is whole"; fi
if [ "$(json partial.json 'totals;answers')" -lt 1 ]; then fail "the interrupted report counts what was done"; fi
finish

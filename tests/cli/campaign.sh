# Campaigns in shards: merge, what it refuses, interruption and resumption, GNU parallel.
docs=$(cd "$(dirname "$0")/../../docs" && pwd)
schema=$docs/report.schema.json
. "$(dirname "$0")/check.sh"
# Quick, and wrong often enough that the worst offenders matter.
campaign='--kernel cramer --cases 3000 --families edge-corner,coplanar,rounding'

# The options are separate words.
# shellcheck disable=SC2086
certify() { run certify $campaign "$@" </dev/null; }

certify --json whole.json
expect_like "a campaign in one" 1 out "FAIL  cramer: "
for i in 1 2 3; do
  certify --shard $i/3 --json $i.json
  expect_like "shard $i" 1 out "shard $i/3, "
done
run merge 3.json 1.json 2.json -o merged.json
expect_like "merged" 1 out "FAIL  cramer: "
cmp -s merged.json whole.json || fail "the shards merged are the campaign in one, byte for byte"
run merge whole.json 2.json merged.json --json again.json
cmp -s again.json whole.json || fail "what is there already counts once"

run merge 1.json 3.json
expect "a missing shard" 2 "" "graze: missing: shards 2/3; --partial merges what there is"
run merge 1.json 3.json --partial -o part.json
expect_like "a missing shard that is allowed" 1 out "shard 1/3 3/3"
run merge part.json 2.json -o merged.json
cmp -s merged.json whole.json || fail "parts merge further"
certify --json part.json --resume
expect_like "a merged part, another shard" 1 out "FAIL  cramer: "
cmp -s part.json whole.json || fail "a merged part can be gone on with"

certify --shard 2/3 --seed 2 --json other.json
run merge 1.json other.json 3.json
expect "another seed" 2 "" "graze: 1.json and other.json cannot be merged: scope/seed: 1 and 2"
certify --shard 2/3 --float-mode up --json up.json
run merge 1.json up.json 3.json
expect "another floating-point mode" 2 "" 'graze: 1.json and up.json cannot be merged: scope/float_modes/0: "nearest" and "up"'
run merge 1.json 2.json other.json 3.json
expect_like "the file at fault is named" 2 err "1.json and other.json cannot be merged"
sed 's/"misrounded": [1-9]/&0/' 2.json >forged.json
run merge 1.json forged.json 3.json
expect_like "a forged report" 2 err "forged.json: does not fit together"
run merge 1.json nonesuch.json
expect_like "no such file" 2 err "nonesuch.json: cannot be read: No such file or directory"
head -c 1000 2.json >cut.json
run merge cut.json
expect_like "half a file" 2 err "cut.json: is not JSON to its end"
run merge .
expect_like "a folder" 2 err ".: is a folder"
run merge
expect_like "no files" 2 err "FILES"
run merge 1.json 2.json 3.json -o no/such/folder.json
expect_like "a report that cannot be written" 2 err "no/such/folder.json: cannot be written"

for shard in 0/3 4/3 3 x /3 1/; do
  certify --shard $shard
  expect "--shard $shard" 2 "" "graze: --shard $shard: is no shard; 1/4 to 4/4 are the four of four"
done
certify --resume
expect_like "nothing to resume from" 2 err "--resume goes on from the file of --json"
certify --json 1.json --shard 1/3 --seed 5 --resume
expect_like "another campaign to resume" 2 err "1.json: is of another campaign, so it cannot be resumed; now and in the file, scope/seed: 5 and 1"
certify --json 1.json --shard 2/3 --resume
expect "another shard to resume" 2 "" "graze: 1.json: is of another shard, so it cannot be resumed"
certify --json fresh.json --resume
cmp -s fresh.json whole.json || fail "where there is no file, a resumed run is a fresh one"

# Interrupted once it has judged something, the report says so and can be gone on with.
# wait_for FILE TEXT: half a minute at most.
wait_for() {
  tries=0
  until grep -q "$2" "$1" 2>/dev/null || [ $tries -eq 300 ]; do
    tries=$((tries + 1))
    sleep 0.1
  done
}
long='--kernel textbook-naive --families quaternion-tangent --second-oracle-every 1 --cases'
# shellcheck disable=SC2086
"$graze" certify $long 15000 --json whole.json >out 2>err
# shellcheck disable=SC2086
"$graze" certify $long 15000 --json cut.json >out 2>err &
runner=$!
sleep 0.5
kill -INT $runner
wait $runner
status=$?
expect_like "interrupted" 1 out "interrupted, the rest is not known"
grep -q '"complete": false' cut.json || fail "the report is partial"
run merge cut.json
expect_like "is refused as missing" 2 err "graze: missing: case"
# shellcheck disable=SC2086
run certify $long 15000 --json cut.json --resume </dev/null
cmp -s cut.json whole.json || fail "gone on with, it is the uninterrupted one, byte for byte"

# Killed without a word, the last save stands.
# shellcheck disable=SC2086
"$graze" certify $long 100000000 --json killed.json >out 2>err &
runner=$!
wait_for killed.json '"judged": [1-9]'
kill -KILL $runner
wait $runner 2>/dev/null
status=$?
run merge --partial killed.json
if [ "$status" != 1 ]; then fail "the last save of a killed run can be read"; fi

# A broken-off shard among the others.
certify --shard 2/3 --json late.json
run merge 1.json late.json 3.json -o merged.json
certify --json whole.json
cmp -s merged.json whole.json || fail "late shards are shards"

# Other forms of the same report: by the run and by the merge, the same bytes.
certify --html run.html --junit run.xml
expect_like "a page and a JUnit file" 1 out "FAIL  cramer: "
run merge 1.json 2.json 3.json --html merged.html --junit merged.xml
cmp -s run.html merged.html || fail "the page of the merged report is the run's"
cmp -s run.xml merged.xml || fail "the JUnit file of the merged report is the run's"
grep -q '<title>graze certify: cramer</title>' run.html || fail "a page"
if python3 -c 'import xml.etree.ElementTree' 2>/dev/null; then
  cases=$(python3 -c 'import sys, xml.etree.ElementTree as t
print(len(t.parse(sys.argv[1]).findall("testsuite/testcase/failure")))' run.xml)
  [ "$cases" = 6 ] || fail "JUnit XML has a failure a row"
else
  echo "left out: no python3 to read XML"
fi
certify --html no/such/folder.html
expect_like "a page that cannot be written" 2 err "no/such/folder.html: cannot be written"

# Side by side.
run certify --compare graze cramer --families fan,random --cases 100 --html both.html </dev/null
expect_like "one of two is wrong" 1 out "cramer"
[ "$(sed -n 's/^\(graze\|cramer\)  *\([a-z]*\) .*/\2/p' out | tr '\n' ' ')" = "pass fail " ] || fail "both verdicts in one table"
grep -q '^fan  *double  *0 %, <= 0.5 ' out || fail "families against kernels"
run certify --compare graze --families fan --cases 100 </dev/null
expect_like "all are right" 0 out "pass"
run certify --compare graze cramer --families fan --cases 100 --float-mode all </dev/null
expect_like "side by side in all modes" 1 out "1,000 "
run certify --compare graze nonesuch </dev/null
expect_like "an unknown kernel to compare" 2 err "no kernel is named 'nonesuch'"
for option in '--json x' '--junit x' '--shard 1/2' '--resume' '--kernel graze'; do
  # shellcheck disable=SC2086
  run certify --compare graze $option </dev/null
  expect_like "--compare with $option" 2 err " excludes --"
done

# The progress line: on a terminal, and nowhere else.
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
  # shellcheck disable=SC2086
  script -qec "'$graze' certify $long 15000" /dev/null </dev/null >terminal 2>&1
  grep -q 'cases, [0-9]* %, [0-9,]* a second, [0-9]* s left, [0-9,]* discrepancies' terminal || fail "a terminal sees the progress"
else
  echo "left out: no terminal: script (Debian package bsdutils) is not there, or has no /dev/pts"
fi

if command -v parallel >/dev/null 2>&1; then
  # The options are separate words; {} is for parallel.
  # shellcheck disable=SC2086
  parallel --will-cite -j 2 "'$graze'" certify $campaign --shard '{}/4' --json 'shard-{}.json' ::: 1 2 3 4 >out 2>err </dev/null
  run merge shard-1.json shard-2.json shard-3.json shard-4.json -o merged.json
  expect_like "shards by GNU parallel" 1 out "FAIL  cramer: "
  cmp -s merged.json whole.json || fail "shards by GNU parallel merge to the campaign in one"
else
  echo "left out: no GNU parallel (Debian package parallel)"
fi

# What a Slurm array would run, one task after the other.
mkdir bin slurm
ln -s "$graze" bin/graze
sed 's/^shards=64/shards=3/' "$docs/campaign.slurm" >slurm.sh
for task in 1 2 3; do
  # shellcheck disable=SC2086
  (cd slurm && PATH=$work/bin:$PATH SLURM_ARRAY_TASK_ID=$task sh ../slurm.sh $campaign) >out 2>err
done
run merge slurm/shards/1.json slurm/shards/2.json slurm/shards/3.json -o merged.json
cmp -s merged.json whole.json || fail "the tasks of a Slurm array merge to the campaign in one"

if python3 -c 'import jsonschema; jsonschema.Draft202012Validator' 2>/dev/null; then
  run certify --cases 50 --json passed.json </dev/null
  status=0
  python3 - "$schema" whole.json 1.json part.json passed.json killed.json >out 2>err <<'PYTHON' || status=$?
import json, sys
import jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
wrong = 0
for name in sys.argv[2:]:
    report = json.load(open(name))
    for error in validator.iter_errors(report):
        print(name, list(error.absolute_path), error.message[:200])
        wrong = 1
    # The schema does refuse something.
    report["rows"][0]["offended"] = []
    if validator.is_valid(report):
        print(name, "is valid with a field too many")
        wrong = 1
sys.exit(wrong)
PYTHON
  if [ "$status" != 0 ]; then fail "reports are by the schema"; fi
else
  echo "left out: no JSON Schema validator (Debian package python3-jsonschema)"
fi
finish

# Measures which way finds which planted bug, and how fast, and writes docs/planted_bugs.md:
#   sh tests/mutants/measure.sh [SECONDS]
# The certifier's way: a default campaign of graze certify on all cores until the first discrepancy (mutant_NAME --certify). The fuzzers'
# way: each target of cases by libFuzzer from its seed corpus, SECONDS (20) at most each, on one core. Both presets are built as
# needed. What was measured is kept in build/planted and not measured again.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-20}
rows=build/planted
mkdir -p "$rows"

certify() {
  nice cmake --build --preset release --target "mutant_$1" >"$rows/$1.log" 2>&1
  nice build/release/bin/mutant_"$1" --certify >"$rows/$1.log" || true
  tail -n 1 "$rows/$1.log" >"$rows/$1.certifier"
}

fuzz() {
  found=''
  tried=0
  for target in triangle sphere implicit; do
    # A bug of another compiler is not planted here.
    if ! nice cmake --build --preset fuzz --target "fuzz_$1_$target" >"$rows/$1.log" 2>&1; then
      grep -q "unknown target" "$rows/$1.log" || exit 1
      found='g++ alone'
      break
    fi
    empty=$(mktemp -d)
    nice "build/fuzz/bin/fuzz_$1_$target" -max_total_time="$seconds" -max_len=140 -print_final_stats=1 -artifact_prefix="$empty/" \
      "$empty" "fuzz/corpus/$target" >"$rows/$1.log" 2>&1 || found=$target
    rm -rf "$empty"
    units=$(sed -n 's/^stat::number_of_executed_units: *//p' "$rows/$1.log")
    rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$rows/$1.log")
    [ -z "$found" ] || {
      spent=$(awk "BEGIN { printf \"%.1f\", $units / ($rate > 0 ? $rate : $units) }")
      found="$target: $units inputs, $spent s"
      break
    }
    tried=$((tried + units))
  done
  [ -n "$found" ] || found="not in $tried inputs, $((3 * seconds)) s"
  echo "$found" >"$rows/$1.fuzzer"
}

names=$(sed -n '/graze_mutant($/{n;s/^ *\([a-z0-9_]*\).*/\1/p}' tests/mutants/table.cmake)
[ -d build/release ] || cmake --preset release >/dev/null
[ -d build/fuzz ] || cmake --preset fuzz >/dev/null
for name in $names; do
  [ -s "$rows/$name.fuzzer" ] || fuzz "$name"
  [ -s "$rows/$name.certifier" ] || certify "$name"
done

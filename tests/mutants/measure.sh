# Measures which way finds which planted bug, and how fast, and writes docs/planted_bugs.md:
#   sh tests/mutants/measure.sh [SECONDS]
# The certifier's way: the cases of a default campaign in its default floating-point mode, one after the other, family by turns, on one core
# (mutant_NAME --one-mode); for what shows in other modes alone, in all of them. The fuzzers' way: each target of cases by libFuzzer
# from its seed corpus, SECONDS (20) at most each, on one core. What was measured is kept in build/planted and not measured again.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-20}
rows=build/planted
mkdir -p "$rows"

measure() {
  name=$1
  found=$(build/release/bin/mutant_"$name" --one-mode | tail -n 1)
  how=''
  case "$found" in
    caught*) ;;
    *)
      found=$(build/release/bin/mutant_"$name" | tail -n 1)
      how=', in all modes'
      ;;
  esac
  certifier=$(echo "$found" | sed -n 's/^caught after \([0-9]*\) cases, \(.*\)$/\1 cases, \2/p')
  fuzzer=''
  tried=0
  for target in triangle sphere implicit; do
    # A bug of another compiler is not planted here.
    if ! cmake --build --preset fuzz --target "fuzz_${name}_$target" >"$rows/$name.log" 2>&1; then
      grep -q "unknown target" "$rows/$name.log" || exit 1
      fuzzer='g++ alone'
      break
    fi
    empty=$(mktemp -d)
    "build/fuzz/bin/fuzz_${name}_$target" -max_total_time="$seconds" -max_len=140 -print_final_stats=1 -artifact_prefix="$empty/" \
      "$empty" "fuzz/corpus/$target" >"$rows/$name.log" 2>&1 || fuzzer=$target
    rm -rf "$empty"
    units=$(sed -n 's/^stat::number_of_executed_units: *//p' "$rows/$name.log")
    rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$rows/$name.log")
    [ -z "$fuzzer" ] || {
      spent=$(awk "BEGIN { printf \"%.1f\", $units / ($rate > 0 ? $rate : $units) }")
      fuzzer="$target: $units inputs, $spent s"
      break
    }
    tried=$((tried + units))
  done
  [ -n "$fuzzer" ] || fuzzer="not in $tried inputs, $((3 * seconds)) s"
  models=$(sed -n "/^  *$name\( FMA\)*\$/,/MODELS/s/^ *MODELS \"\(.*\)\"$/\1/p" tests/mutants/table.cmake | head -n 1)
  echo "| \`$name\` | $models | ${certifier:-not found}$how | $fuzzer |" >"$rows/$name.row"
}

names=$(sed -n '/graze_mutant($/{n;s/^ *\([a-z0-9_]*\).*/\1/p}' tests/mutants/table.cmake)
for name in $names; do [ -s "$rows/$name.row" ] || measure "$name"; done
{
  cat <<'TEXT'
# Planted bugs

Each is a small change of the kernel, built by [`tests/mutants/table.cmake`](../tests/mutants/table.cmake); every test run plants them all and
sees them caught. Here is which way finds which, and how fast, as `sh tests/mutants/measure.sh` measured it on one core that others shared.

- **Families**: the cases of a default `graze certify` (seed 1, 10,000 a family and precision) in turn, in the default floating-point mode,
  until the first disagreement. A bug that shows in other modes alone is found by the same cases in all modes.
- **libFuzzer**: the targets triangle, sphere and implicit one after the other, from their seed corpora, with the sanitizers on, until one finds it.

| bug | what it models | families | libFuzzer |
|---|---|---|---|
TEXT
  for name in $names; do cat "$rows/$name.row"; done
} >docs/planted_bugs.md

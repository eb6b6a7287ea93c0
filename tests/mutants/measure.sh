# Measures which way finds which planted bug, and how fast, and writes docs/planted_bugs.md:
#   sh tests/mutants/measure.sh [SECONDS]
# The certifier's way: what graze certify does without options, until the first discrepancy. The fuzzer's way: each target of cases by
# libFuzzer from its seed corpus, SECONDS (20) at most each, on one core. Both presets are built as needed. What was measured is
# kept in build/planted and not measured again.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-20}
rows=build/planted
mkdir -p "$rows"

# build PRESET TARGET: 1 where there is no such target, because the bug is planted for other compilers.
build() {
  if nice cmake --build --preset "$1" --target "$2" >"$rows/log" 2>&1; then return 0; fi
  grep -q "unknown target" "$rows/log" && return 1
  cat "$rows/log" >&2
  exit 1
}

certify() {
  found='other compilers alone'
  if build release "certify_$1"; then
    status=0
    found=$(build/release/bin/certify_"$1") || status=$?
    # The bug writes where it may not.
    [ "$status" -le 1 ] || found='the program crashes'
  fi
  echo "$found" >"$rows/$1.certifier"
}

fuzz() {
  tried=0
  for target in triangle sphere implicit; do
    build fuzz "fuzz_$1_$target" || {
      echo 'other compilers alone' >"$rows/$1.fuzzer"
      return
    }
    empty=$(mktemp -d)
    is_found=no
    nice "build/fuzz/bin/fuzz_$1_$target" -max_total_time="$seconds" -max_len=140 -print_final_stats=1 -artifact_prefix="$empty/" \
      "$empty" "fuzz/corpus/$target" >"$rows/log" 2>&1 || is_found=yes
    rm -rf "$empty"
    inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$rows/log")
    rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$rows/log")
    if [ $is_found = yes ]; then
      # It counts whole seconds.
      spent='< 1 s'
      [ "$rate" -eq 0 ] || spent="$((inputs / rate)) s"
      echo "$target, after $inputs inputs, $spent" >"$rows/$1.fuzzer"
      return
    fi
    tried=$((tried + inputs))
  done
  echo "not found in $tried inputs, $((3 * seconds)) s" >"$rows/$1.fuzzer"
}

names=$(sed -n '/graze_mutant($/{n;s/^ *\([a-z0-9_]*\).*/\1/p}' tests/mutants/table.cmake)
[ -d build/release ] || cmake --preset release >/dev/null
[ -d build/fuzz ] || cmake --preset fuzz >/dev/null
for name in $names; do
  [ -s "$rows/$name.certifier" ] || certify "$name"
  [ -s "$rows/$name.fuzzer" ] || fuzz "$name"
done
{
  cat <<'TEXT'
# Planted bugs

Each is a small change of the kernel, built by [`tests/mutants/table.cmake`](../tests/mutants/table.cmake); every test run plants them all and
sees them caught. Here is which way finds which, and how fast, as `sh tests/mutants/measure.sh` measured it.

- **`graze certify`**: without options, on two cores that others used too: the row in which the first discrepancy shows, and the cases judged by then.
  oneTBB gives one core the first rows and the other those from the middle on; work is looked at in pieces of 1,024 cases, so a bug may have shown in
  earlier ones of these cases. The whole campaign takes 20 seconds.
- **libFuzzer**: the targets triangle, sphere and implicit one after the other, on one core, from their seed corpora, with the sanitizers on, until one
  finds it.

| bug | what it models | `graze certify` | libFuzzer |
|---|---|---|---|
TEXT
  for name in $names; do
    models=$(sed -n "/^  *$name\( FMA\)*\$/,/MODELS/s/^ *MODELS \"\(.*\)\"\$/\1/p" tests/mutants/table.cmake)
    echo "| \`$name\` | $models | $(cat "$rows/$name.certifier") | $(cat "$rows/$name.fuzzer") |"
  done
} >docs/planted_bugs.md

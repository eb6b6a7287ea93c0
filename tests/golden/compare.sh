# The kept tables of all built-in kernels against what comes out now: compare.sh PROGRAM, or compare.sh PROGRAM --update to keep
# what comes out. A table that depends on a library is compared where that is the same version.
set -u
program=$1
folder=$(cd "$(dirname "$0")" && pwd)
now=$(mktemp) || exit 2
trap 'rm -f "$now"' EXIT
failures=0
for kernel in $("$program"); do
  kept=$folder/$kernel.txt
  "$program" "$kernel" >"$now" || exit 2
  if [ "${2:-}" = --update ]; then
    cat "$now" >"$kept"
  elif [ ! -f "$kept" ]; then
    echo "FAILED: $kernel has no table in tests/golden"
    failures=$((failures + 1))
  elif [ "$(head -n 1 "$kept")" != "$(head -n 1 "$now")" ]; then
    echo "left out: $(head -n 1 "$kept"); here it $(head -n 1 "$now" | cut -d ' ' -f 2-)"
  elif ! diff "$kept" "$now"; then
    echo "FAILED: $kernel: < was kept, > comes out now"
    failures=$((failures + 1))
  fi
done
[ "$failures" = 0 ] || {
  echo "If the change is meant: sh tests/golden/compare.sh build/release/bin/golden_table --update"
  exit 1
}

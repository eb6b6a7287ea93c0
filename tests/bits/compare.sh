#!/bin/sh
# The same bits from every compiler: builds the kernel, its caller and the families anew with each compiler and each set of flags, and holds the
# digest of the answers against golden.txt.
#   tests/bits/compare.sh [COMPILER...]     g++ and clang++-19 unless said otherwise; a compiler that is missing is told and left out
# BITS_FOLDER, build/bits unless set, holds the builds. Exit status: 0 all the same, 1 a difference, 2 something could not be built.
set -eu
cd "$(dirname "$0")/../.."
folder=${BITS_FOLDER:-build/bits}
[ $# -gt 0 ] || set -- g++ clang++-19

status=0
printf '%-14s %-42s %s\n' compiler flags bits
for compiler in "$@"; do
  if ! command -v "$compiler" >/dev/null 2>&1; then
    printf '%-14s %-42s %s\n' "$compiler" - 'not installed'
    continue
  fi
  # The kernel's own files always add -ffp-contract=off; the last set is a caller who asks for contraction.
  for flags in '-O0' '-O3' '-O3 -march=native' '-O3 -march=native -ffp-contract=fast'; do
    build=$folder/$(printf '%s%s' "$compiler" "$flags" | tr -c 'A-Za-z0-9+\n' _)
    log=$build/log
    mkdir -p "$build"
    if ! { cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" &&
      cmake --build "$build" --target answers_digest --parallel "$(nproc)"; } >"$log" 2>&1; then
      printf '%-14s %-42s %s\n' "$compiler" "$flags" "not built, see $log"
      status=2
    elif "$build/bin/answers_digest" tests/bits/golden.txt >"$log" 2>&1; then
      printf '%-14s %-42s %s\n' "$compiler" "$flags" same
    else
      printf '%-14s %-42s %s\n' "$compiler" "$flags" "$(grep -c ': the answers are' "$log" || :) streams with other answers, $(grep -c ': the answers depend' "$log" || :) that depend on the mode, $(grep -c ': the cases' "$log" || :) with other cases; see $log"
      [ "$status" -ne 0 ] || status=1
    fi
  done
done
exit "$status"

#!/bin/sh
# The same bits from one compiler and its flags: builds the kernel's single queries and their caller by hand, and replays the cases.
#   row.sh CASES FOLDER RUNNER COMPILER [FLAG...]     RUNNER: `native`, or the emulator that runs the program
# The kernel's own files have the flags that kernel/CMakeLists.txt adds, after the others. Prints `same`, or what is not.
# Exit status: 0 the same, 1 a difference, 2 it could not be built or run; 77 where compiler or emulator is missing.
set -eu
cd "$(dirname "$0")/../.."
cases=$1 folder=$2 runner=$3 compiler=$4
shift 4

for tool in "$compiler" "$runner"; do
  [ "$tool" = native ] || command -v "$tool" >/dev/null 2>&1 || {
    echo "$tool is not installed"
    exit 77
  }
done
mkdir -p "$folder"
log=$folder/log
own='-ffp-contract=off'
case $("$compiler" "$@" -dumpmachine) in
  x86_64* | i?86*) own="$own -msse2 -mfpmath=sse" ;;
esac

objects=
compile() {
  object=$folder/$(echo "$1" | tr / _).o
  objects="$objects $object"
  shift
  "$@" -std=c++20 -I . -I kernel/include -I kernel/src -Wno-psabi -c -o "$object" >>"$log" 2>&1 || {
    echo "not built, see $log"
    exit 2
  }
}
: >"$log"
# What single queries need.
for source in $(find kernel/src -name '*.cpp' | grep -vE '/(batch|scene)/|/exact/(order|parity)\.cpp' | sort); do
  # shellcheck disable=SC2086
  compile "$source" "$compiler" "$@" $own "$source"
done
for source in fuzz/kernel_calls.cpp tests/bits/answers_replay.cpp; do
  compile "$source" "$compiler" "$@" "$source"
done
# Static, so that an emulator needs none of the target's libraries.
# shellcheck disable=SC2086
"$compiler" "$@" -static -o "$folder/answers_replay" $objects >>"$log" 2>&1 || {
  echo "not linked, see $log"
  exit 2
}
[ "$runner" != native ] || runner=
status=0
$runner "$folder/answers_replay" "$cases" tests/bits/golden.txt >>"$log" 2>&1 || status=$?
case $status in
  0) echo same ;;
  1)
    echo "$(grep -c ': the answers are' "$log" || :) streams with other answers, $(grep -c ': the answers depend' "$log" || :) that depend on the mode; see $log"
    exit 1
    ;;
  *)
    echo "ended with status $status, see $log"
    exit 2
    ;;
esac

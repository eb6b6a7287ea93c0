#!/bin/sh
# The same bits from one compiler and its flags: builds the kernel's single queries and their caller by hand, and replays the cases.
#   row.sh CASES FOLDER PROGRAM RUNNER COMPILER [FLAG...]
# PROGRAM: `answers_replay`, or `batch_replay` for the batches, or `scene_digest` for scenes, which have cases of their own. The last two
# take Highway: natively all its instruction sets, elsewhere what the flags say. RUNNER: `native`, or the emulator that runs the program.
# The kernel's own files have the flags that kernel/CMakeLists.txt adds, after the others. Prints `same`, or what is not.
# Exit status: 0 the same, 1 a difference, 2 it could not be built or run; 77 where compiler or emulator is missing.
set -eu
cd "$(dirname "$0")/../.."
cases=$1 folder=$2 program=$3 runner=$4 compiler=$5
shift 5

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
left_out='/(batch|scene)/|/exact/(order|parity)\.cpp'
libraries='-static' # so that an emulator needs none of the target's
case $program in
  batch_replay) left_out='/scene/|/exact/parity\.cpp' ;;
  scene_digest) left_out='/batch/' ;;
esac
if [ "$program" != answers_replay ]; then
  if [ "$runner" = native ]; then
    libraries='-lhwy'
  else
    set -- "$@" -DHWY_COMPILE_ONLY_STATIC -idirafter /usr/include
  fi
fi
for source in $(find kernel/src -name '*.cpp' | grep -vE "$left_out" | sort); do
  # shellcheck disable=SC2086
  compile "$source" "$compiler" "$@" $own "$source"
done
for source in fuzz/kernel_calls.cpp "tests/bits/$program.cpp"; do
  compile "$source" "$compiler" "$@" "$source"
done
# shellcheck disable=SC2086
"$compiler" "$@" -o "$folder/$program" $objects $libraries >>"$log" 2>&1 || {
  echo "not linked, see $log"
  exit 2
}
[ "$runner" != native ] || runner=
set -- "$cases" tests/bits/golden.txt
[ "$program" != scene_digest ] || set -- tests/bits/scenes.txt
status=0
$runner "$folder/$program" "$@" >>"$log" 2>&1 || status=$?
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

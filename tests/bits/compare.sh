#!/bin/sh
# The same bits from every compiler, its flags and machine: builds the kernel and its caller anew for each row and replays the cases of
# answers_digest, in all rounding modes and with flush-to-zero; a table of what comes of it.
#   compare.sh DIGEST FOLDER [COMPILER...]     DIGEST: the program answers_digest; FOLDER: for the builds; all compilers unless said otherwise
# What is not installed is told and left out. Exit status: 0 all the same, 1 a difference, 2 something could not be built.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
digest=$1 folder=$2
shift 2
wanted=$*
mkdir -p "$folder"
"$digest" "$here/golden.txt" # The cases must be those of the golden file.
"$digest" --cases >"$folder/cases"

# The kernel's own files always add -ffp-contract=off and, on x86, -mfpmath=sse: the last flags speak for the caller's inline functions.
rows() {
  for compiler in g++-12 clang++-14 clang++-19; do
    for flags in -O0 -O1 -O2 -O3 '-O3 -mavx2 -mfma -ffp-contract=off' '-O3 -march=native' '-O3 -march=native -ffp-contract=fast'; do
      echo "answers_replay native $compiler $flags"
    done
  done
  echo 'answers_replay native g++-12 -O2 -mfpmath=387'
  for flags in -O0 -O2 -O3 '-O2 -msse2 -mfpmath=sse'; do echo "answers_replay native i686-linux-gnu-g++ $flags"; done
  for flags in -O0 -O3; do
    echo "answers_replay qemu-aarch64 aarch64-linux-gnu-g++ $flags"
    echo "answers_replay qemu-s390x s390x-linux-gnu-g++ $flags"
  done
  echo 'answers_replay qemu-aarch64 clang++-19 -O3 --target=aarch64-linux-gnu'
  # Batches: all instruction sets that the processor has; on Arm Neon.
  for compiler in g++-12 clang++-14 clang++-19; do echo "batch_replay native $compiler -O2"; done
  echo 'batch_replay qemu-aarch64 aarch64-linux-gnu-g++ -O2'
  # Scenes on Neon; natively they are tested as they are built.
  echo 'scene_digest qemu-aarch64 aarch64-linux-gnu-g++ -O2'
}

status=0
printf '%-8s %-24s %-42s %s\n' queries compiler flags bits
rows >"$folder/rows"
while read -r program runner compiler flags; do
  case " $wanted " in '  ' | *" $compiler "*) ;; *) continue ;; esac
  row=$folder/$(echo "$program$compiler$flags" | tr -c 'A-Za-z0-9+\n' _)
  result=0
  # shellcheck disable=SC2086
  said=$(sh "$here/row.sh" "$folder/cases" "$row" "$program" "$runner" "$compiler" $flags) || result=$?
  queries=single
  [ "$program" != batch_replay ] || queries=batches
  [ "$program" != scene_digest ] || queries=scenes
  printf '%-8s %-24s %-42s %s\n' "$queries" "$compiler" "$flags" "$said"
  case $result in
    0 | 77) ;;
    1) [ "$status" -ne 0 ] || status=1 ;;
    *) status=2 ;;
  esac
done <"$folder/rows"
exit "$status"

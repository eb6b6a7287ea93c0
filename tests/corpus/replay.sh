# replay.sh PROGRAM PRECISION FILE.case: the program's answers, byte for byte those of FILE.answers.
set -u
program=$1
precision=$2
cases=$3
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
if ! "$program" answer --details --precision "$precision" "$cases" >"$work/found"; then
  echo "FAILED: $program answer --details --precision $precision $cases"
  exit 1
fi
if ! cmp "${cases%.case}.answers" "$work/found"; then
  echo "FAILED: the answers to $cases are not those that are kept beside it"
  diff "${cases%.case}.answers" "$work/found" | head -n 20
  exit 1
fi

# Sourced by the tests: $1 is the program. Works in a directory of its own; `finish` tells the outcome.
set -u
graze=$1
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
failures=0
LC_ALL=C
export LC_ALL

# run ARGUMENT...: the program on standard input; its output, messages and status go to `out`, `err` and $status.
run() {
  "$graze" "$@" >out 2>err
  status=$?
}

fail() {
  failures=$((failures + 1))
  echo "FAILED: $1"
  echo "  status $status"
  echo "  stdout: $(head -c 500 out)"
  echo "  stderr: $(head -c 500 err)"
}

# expect NAME STATUS OUTPUT MESSAGE: all of the last run, to the letter, ends of line aside.
expect() {
  if [ "$status" != "$2" ]; then fail "$1: status $2 wanted"; fi
  if [ "$(cat out)" != "$3" ]; then fail "$1: wanted on stdout: $3"; fi
  if [ "$(cat err)" != "$4" ]; then fail "$1: wanted on stderr: $4"; fi
}

# expect_like NAME STATUS FILE TEXT: the status, and the text somewhere in out or err.
expect_like() {
  if [ "$status" != "$2" ]; then fail "$1: status $2 wanted"; fi
  if ! grep -qF -e "$4" "$3"; then fail "$1: wanted in $3: $4"; fi
}

# replay NUMBER: runs that replay command of the last report, as it is printed in `out`, its words to `replayed` and `err`.
replay() {
  if [ ! -e replay_path/graze ]; then mkdir -p replay_path && ln -s "$graze" replay_path/graze; fi
  sed -n "s/^    \\(echo '.* | graze answer .*\\)/\\1/p" out | sed -n "$1p" >command
  PATH=$work/replay_path:$PATH sh ./command >replayed 2>err </dev/null
  status=$?
}

# expect_replays NAME: the first replay command gives the answer that the report prints above it.
expect_replays() {
  answer=$(sed -n 's/^    answers  //p' out | head -n 1)
  replay 1
  if [ "$status" != 0 ] || [ -z "$answer" ] || [ "$answer" != "$(cat replayed)" ]; then
    fail "$1: the replay command repeats '$answer', not '$(cat replayed)': $(cat command)"
  fi
}

finish() {
  if [ "$failures" -ne 0 ]; then
    echo "$failures failed"
    exit 1
  fi
  exit 0
}

# Kernels of users: a shared library and a program, good ones and each kind of bad one.
# plugins.sh GRAZE FOLDER_OF_PLUGINS
plugins=$(cd "$2" && pwd) || exit 2
. "$(dirname "$0")/../cli/check.sh"

# json FILE FIELD...: a value of a report.
cat >json.cmake <<'SCRIPT'
file(READ ${FILE} text)
string(JSON value GET "${text}" totals ${FIELD})
message("${value}")
SCRIPT
json() { cmake "-DFILE=$1" "-DFIELD=$2" -P json.cmake 2>&1; }

# certify KERNEL OPTION...: double alone is offered by the libraries, so a row of float holds nothing.
certify() {
  kernel=$1
  shift
  rm -f report.json
  run certify --families random --cases 4000 --json report.json --kernel "$kernel" "$@" </dev/null
}

# The example.
certify "$plugins/my_kernel.so"
expect_like "the example passes where it declares enough" 0 out "PASS  "
expect_like "its deviations are listed" 0 out "edges-are-faces"
expect_like "its limits are listed" 0 out "t within 4096 ulps, u and v within 4096"
answers=$(json report.json answers)
if [ "$answers" -lt 1000 ]; then fail "the example answers 1000 cases or more, not $answers"; fi
run certify --families edge-corner --cases 500 --kernel "$plugins/my_kernel.so" </dev/null
expect_like "and fails at edges" 1 out "FAIL  "

# The same from many places at once, in any order of threads.
sed 's/ [0-9.]* s)//' out >first
run certify --families edge-corner --cases 500 --kernel "$plugins/my_kernel.so" </dev/null
sed 's/ [0-9.]* s)//' out >second
cmp -s first second || fail "the same seed gives the same table"

# fails NAME KERNEL MESSAGE OPTION...: some cases have no answer, the others are counted, each failure is told with its case.
fails() {
  name=$1 kernel_at_fault=$2 message=$3
  shift 3
  certify "$kernel_at_fault" "$@"
  expect_like "$name: found" 1 out "FAIL  "
  expect_like "$name: told" 1 out "answers  $message"
  failed=$(json report.json "disagreements;failed")
  if [ "$failed" -lt 1 ] || [ "$failed" -gt 40 ]; then fail "$name: some cases are at fault, not $failed"; fi
  if [ "$(json report.json answers)" != "$answers" ]; then fail "$name: the others are counted: $answers"; fi
  # The case at fault, alone, brings the fault about again.
  replay 1
  expect_like "$name: replayed" 2 err "$message"
}
fails "a library that crashes" "$plugins/crash.so" "crashed (signal 6, Aborted)"
crashes=$failed
fails "a library that answers garbage" "$plugins/garbage.so" "answered the kind 77, which is none of ray_triangle"
if [ "$failed" != "$crashes" ]; then fail "garbage on as many cases as crashes, $crashes, not $failed"; fi
fails "a library that answers too few" "$plugins/too_few.so" "answered 0 of 1 cases"
if [ "$failed" != "$crashes" ]; then fail "too few on as many cases as crashes, $crashes, not $failed"; fi
fails "a library that leaves" "$plugins/leave.so" "ended with status 3 and gave no answer"
if [ "$failed" != "$crashes" ]; then fail "left on as many cases as crashes, $crashes, not $failed"; fi
fails "a library that hangs" "$plugins/hang.so" "hung: no answer within 0.2 s" --time-limit 0.2

certify "$plugins/lie.so"
expect_like "a library that lies" 1 out "wrong detail"
if [ "$(json report.json wrong_kinds)" != "$crashes" ]; then fail "it lies on as many cases as another crashes: $crashes"; fi
certify "$plugins/only_in_batches.so"
if [ "$(json report.json answers)" != "$answers" ]; then fail "failures of batches are told of cases that are offered"; fi
expect_like "a library that crashes only in batches" 1 out "answers  crashed (signal 6, Aborted) and gave no answer, but only when it was asked"

# Programs.
run certify --families random,implicit --cases 500 --kernel "exec:'$graze' answer --details --precision {precision}" </dev/null
expect_like "the kernel as a program" 0 out "PASS  exec:"
expect_like "in both precisions" 0 out "random                 float            500"
run certify --families random --cases 500 --kernel "exec:'$graze' answer --details" </dev/null
expect_like "without {precision} it is asked in double" 0 out "PASS  exec:"
if grep -q "float" out; then fail "and not in float"; fi
run certify --families edge-corner --cases 500 --kernel "exec:'$graze' answer --details --kernel moller-trumbore" \
  --declare ray_triangle,coplanar-is-miss,degenerate-is-miss </dev/null
expect_like "a program declares" 1 out "coplanar-is-miss"
expect_replays "a program that declares"
run certify --families edge-corner --cases 50 --json declared.json --kernel "exec:'$graze' answer --details --kernel moller-trumbore" \
  --declare 'ray_triangle, t-ulps=8' --time-limit 30 </dev/null
expect_replays "and with blanks"
grep -q -e "--declare 'ray_triangle, t-ulps=8' --time-limit 30\$" command || fail "what was declared is in the replay command"
grep -q '"options": "--declare .ray_triangle, t-ulps=8. --time-limit 30"' declared.json || fail "and in the report"
run merge declared.json
expect_replays "a report that was read"

# Floating-point modes: a library is called in them, a program is told of them.
of_double() { grep "^random  *double" out; }
run certify --families random --cases 2000 --kernel "$plugins/my_kernel.so" </dev/null
of_double >nearest
run certify --families random --cases 2000 --kernel "$plugins/my_kernel.so" --float-mode up </dev/null
of_double >up
if cmp -s nearest up; then fail "a library is called in another mode"; fi
for mode in up ftz-daz; do
  run certify --families random,range --cases 300 --kernel textbook-naive --float-mode $mode </dev/null
  grep -e '^random' -e '^range' out >built_in
  run certify --families random,range --cases 300 --float-mode $mode \
    --kernel "exec:'$graze' answer --details --precision {precision} --kernel textbook-naive --float-mode {float-mode}" \
    --declare ray_sphere,point_line,point_plane,point_sphere </dev/null
  grep -e '^random' -e '^range' out >as_program
  cmp -s built_in as_program || fail "a program that takes the mode $mode answers as the kernel does in it: $(diff built_in as_program)"
  expect_replays "a program in the mode $mode"
done
run certify --families random --cases 10 --kernel "exec:cat" --float-mode up </dev/null
expect_like "a program that does not take the mode" 2 err "exec:cat: a program sets its own floating-point mode: take {float-mode} into the command"

certify "exec:'$plugins/talker' honest"
expect_like "an honest talker loses hits" 1 out "lost hit"
answers=$(json report.json answers)
if [ "$(json report.json "disagreements;failed")" != 0 ]; then fail "an honest talker answers all"; fi
fails "a program that crashes" "exec:'$plugins/talker' crash" "crashed (signal 11, Segmentation fault)"
crashes=$failed
fails "a program that writes garbage" "exec:'$plugins/talker' garbage" "answered what is no answer: "
if [ "$failed" != "$crashes" ]; then fail "garbage on as many lines as crashes, $crashes, not $failed"; fi
fails "a program that leaves" "exec:'$plugins/talker' leave" "ended with status 3 and gave no answer"
if [ "$failed" != "$crashes" ]; then fail "left on as many lines as crashes, $crashes, not $failed"; fi
fails "a program that skips a line" "exec:'$plugins/talker' quiet" "ended with status 0 and gave no answer"
if [ "$failed" != "$crashes" ]; then fail "skipped on as many lines as crashes, $crashes, not $failed"; fi
fails "a program that answers twice" "exec:'$plugins/talker' chatty" "answered more lines than there were cases"
if [ "$failed" != "$crashes" ]; then fail "twice on as many lines as crashes, $crashes, not $failed"; fi
fails "a program that hangs" "exec:'$plugins/talker' hang" "hung: no answer within 0.2 s" --time-limit 0.2
fails "a line without end" "exec:'$plugins/talker' endless" "answered a line without end"
certify "exec:'$plugins/talker' unflushed"
if [ "$(json report.json "disagreements;failed")" != 0 ]; then fail "a program need not flush"; fi

# What hangs for ever is ended with all that it has started, and however the certifier ends.
cat >hang.sh <<'SCRIPT'
while read -r line; do
  sleep 1000 &
  echo "$! $$" >>pids
  while :; do :; done
done
SCRIPT
# A process that nobody has waited for yet is as good as gone.
is_alive() { kill -0 "$1" 2>/dev/null && ! grep -q '^State:[[:space:]]*Z' "/proc/$1/status" 2>/dev/null; }
# expect_all_gone NAME NUMBER: at least so many processes have noted themselves, and none of them is left after some seconds.
expect_all_gone() {
  tries=0
  while [ $tries -lt 100 ]; do
    alive=
    for pid in $(cat pids); do if is_alive "$pid"; then alive="$alive $pid"; fi; done
    if [ -z "$alive" ]; then break; fi
    tries=$((tries + 1))
    sleep 0.1
  done
  if [ -n "$alive" ]; then fail "$1: left running:$alive" && kill -KILL $alive; fi
  if [ "$(wc -w <pids)" -lt "$2" ]; then fail "$1: the processes noted themselves"; fi
  rm -f pids
}
run certify --families random --cases 6 --kernel 'exec:sh hang.sh' --time-limit 0.2 </dev/null
expect_like "a program that hangs with a child" 1 out "hung: no answer within 0.2 s"
expect_all_gone "after the end" 12
# begin: the certifier in the background, until a program of it hangs.
begin() {
  "$graze" certify --families random --kernel 'exec:sh hang.sh' --time-limit 100 >out 2>err </dev/null &
  certifier=$!
  tries=0
  until [ -s pids ] || [ $tries -eq 100 ]; do
    tries=$((tries + 1))
    sleep 0.1
  done
}
begin
is_alive "$(cut -d ' ' -f 1 pids | head -n 1)" || fail "the child of what hangs is seen"
kill -KILL $certifier
wait $certifier 2>/dev/null
status=$?
expect_all_gone "after SIGKILL" 2
begin
kill -TERM $certifier
sleep 0.3
kill -TERM $certifier
wait $certifier 2>/dev/null
status=$?
expect_all_gone "after the second interrupt" 2

# What can't be opened.
refused() {
  run certify --families random --cases 10 --kernel "$2" </dev/null
  expect_like "$1" 2 err "$3"
  if [ -s out ]; then fail "$1: nothing wanted on stdout"; fi
}
refused "no such library" ./nonesuch.so "graze: ./nonesuch.so: no such file"
refused "a folder" . "graze: no kernel is named '.'"
refused "a folder with a slash" ./ "graze: ./: is a folder, not a shared library"
echo "no library" >text.so
refused "no library at all" text.so "graze: text.so: cannot be loaded: "
refused "no such symbol" "$plugins/no_symbol.so" "does not define graze_subject, the function that graze/subject.h asks for"
refused "another version" "$plugins/wrong_abi.so" "speaks version 7 of graze/subject.h, and this program version 1; compile it again"
refused "no name" "$plugins/no_name.so" "has no name in its description"
refused "a crash while it is loaded" "$plugins/crash_at_load.so" "crashed (signal 6, Aborted) while it was loaded"
refused "no such program" "exec:./nonesuch --flags" "graze: exec:./nonesuch --flags: the program is not found; check the path"
echo "no program" >plain
refused "a file that is no program" "exec:./plain" "graze: exec:./plain: the program may not be run; allow it with chmod u+x"
refused "no program named" "exec: " "names no program; exec:./mine --flags does"
run certify --families random --kernel "exec:cat" --declare sideways </dev/null
expect_like "a declaration that there is not" 2 err "graze: --declare sideways: 'sideways' can't be declared; there are: ray_sphere, "
run certify --families random --kernel "exec:cat" --declare t-ulps=0.1 </dev/null
expect_like "a limit that is none" 2 err "'t-ulps=0.1' wants a number of ulps, 0.5 or more"
run certify --families random --kernel cramer --declare no-facing </dev/null
expect_like "a declaration for a built-in kernel" 2 err "--declare is for a program of your own"
run certify --families random --kernel "$plugins/my_kernel.so" --declare no-facing </dev/null
expect_like "a declaration for a library" 2 err "a library declares for itself"

# graze answer takes them too.
echo 'ray_triangle 0.25 0.5 1  0 0 -1  0 0 0  1 0 0  0 1 0' >triangle
run answer --details --kernel "$plugins/my_kernel.so" triangle </dev/null
expect "the example answers" 0 "face 1 0.25 0.5 facing=front" ""
run answer --kernel "$plugins/my_kernel.so" --precision float triangle </dev/null
expect_like "in double alone" 2 err "does not answer ray_triangle; these do: graze, "
finish

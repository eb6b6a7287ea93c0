# Output that can't be written, and answers that are waited for.
. "$(dirname "$0")/check.sh"

echo 'point_line 3 6 2 3 4' >cases
message='graze: cannot write to standard output: it is closed, full or no longer read'
: >out

"$graze" answer cases >&- 2>err </dev/null
status=$?
expect "standard output closed" 2 "" "$message"
if [ -w /dev/full ]; then
  "$graze" answer cases >/dev/full 2>err </dev/null
  status=$?
  expect "a full device" 2 "" "$message"
  "$graze" --version >/dev/full 2>err </dev/null
  status=$?
  expect "a full device for the version" 2 "" "$message"
fi

# The reader goes away while cases keep coming without end.
{ yes 'point_line 3 6 2 3 4' | { "$graze" answer 2>err; echo $? >reader_status; } | head -n 1 >out; } 2>/dev/null
status=$(cat reader_status)
expect "a reader that goes away" 2 "positive" "$message"

# A coprocess: the answer comes before the input ends.
mkfifo ask tell
"$graze" answer <ask >tell 2>err &
exec 3>ask 4<tell
echo 'point_line 3 6 2 3 4' >&3
read -r first <&4
echo 'point_line -11 6 2 3 4' >&3
read -r second <&4
exec 3>&-
wait $!
status=$?
echo "$first, $second" >out
expect "answers as they are asked for" 0 "positive, on" ""
finish

# Hostile and odd input: nothing is undefined, no answer is lost.
. "$(dirname "$0")/check.sh"

: >empty
run answer empty </dev/null
expect "an empty file" 0 "" ""
run answer </dev/null
expect "empty standard input" 0 "" ""
printf '\n\n# only comments' >comments
run answer comments </dev/null
expect "comments alone" 0 "" ""

printf 'point_line 3 6 2 3 4' >unended
run answer unended </dev/null
expect "no newline at the end" 0 "positive" ""
printf 'point_line 3 6 2 3 4\npoint_line' >cut
run answer cut </dev/null
expect "cut off" 2 "positive" "cut:2: point_line takes 5 numbers, px py a b c; this line has 0"

printf '# from elsewhere\r\n\r\npoint_line 3 6 2 3 4\r\npoint_line -11 6 2 3 4\r\n' >crlf
run answer crlf </dev/null
expect "CRLF" 0 "positive
on" ""

printf 'point_line 3 6 2 3 4\npoint_line 1\0 2 3 4 5\n' >nul
run answer nul </dev/null
expect "NUL in a number" 2 "positive" "nul:2: '1\\x00' is no number (px of point_line)"
head -c 100000 /dev/zero >zeros
run answer zeros </dev/null
expect_like "NULs alone" 2 err "zeros:1: unknown query '\\x00\\x00"

printf '\377\376\001\002 \033[31m\n' >binary
run answer binary </dev/null
expect_like "binary garbage" 2 err "binary:1: unknown query '\\xff\\xfe\\x01\\x02'"
printf '\357\273\277point_line 3 6 2 3 4\n' >bom
run answer bom </dev/null
expect_like "a byte order mark" 2 err "bom:1: unknown query '\\xef\\xbb\\xbfpoint_line'"
cat "$graze" >program
run answer program </dev/null
expect_like "a program" 2 err "program:1: unknown query '\\x7fELF"
if [ "$(wc -c <err)" -gt 1000 ]; then fail "a program: a short message wanted"; fi

# Long lines: blanks, digits and words up to 2^20 bytes are read, more are refused.
blanks=$(printf '%*s' 1000 '')
i=0
while [ $i -lt 1000 ]; do
  printf '%s' "$blanks"
  i=$((i + 1))
done >million
{ printf 'point_line 3 6'; cat million; printf ' 2 3 4\n'; } >long
run answer long </dev/null
expect "a million blanks" 0 "positive" ""
{ printf 'point_line 3.'; tr ' ' 0 <million; printf '1 6 2 3 4\n'; } >digits
run answer digits </dev/null
expect "a million digits" 0 "positive" ""
{ printf 'point_line '; tr ' ' z <million; printf ' 6 2 3 4\n'; } >word
run answer word </dev/null
expect "a million letters" 2 "" "word:1: 'zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz...' is no number (px of point_line)"
{ printf 'point_line'; sed 's/ / 1/g' million | head -c 1000000; printf '\n'; } >numbers
run answer numbers </dev/null
expect "half a million numbers" 2 "" "numbers:1: point_line takes 5 numbers, px py a b c; this line has 500000"
{ printf 'point_line 3 6 2 3 4\n'; cat million million; printf '\npoint_line 3 6 2 3 4\n'; } >huge
run answer huge </dev/null
expect "too long a line" 2 "positive" "huge:2: the line is longer than 1048576 bytes"
{ printf '#'; tail -c 48576 million; cat million; printf '\n'; } | head -c 1048576 >limit
printf '\npoint_line 3 6 2 3 4\n' >>limit
run answer limit </dev/null
expect "a comment as long as may be" 0 "positive" ""
{ printf '#'; tail -c 48576 million; cat million; printf '\npoint_line 3 6 2 3 4\n'; } >beyond
run answer beyond </dev/null
expect "a comment one byte longer" 2 "" "beyond:1: the line is longer than 1048576 bytes"

# All answers of a long input, in order.
i=0
while [ $i -lt 3000 ]; do
  echo "ray_sphere 0 0 0 1 0 0 $((i + 2)) 0 0 1"
  i=$((i + 1))
done >many
i=0
while [ $i -lt 3000 ]; do
  echo "secant $((i + 1)) $((i + 3))"
  i=$((i + 1))
done >wanted
run answer many </dev/null
if [ "$status" -ne 0 ] || ! cmp -s out wanted; then fail "many lines"; fi
finish

# What is wrong, where, and what stands before it.
. "$(dirname "$0")/check.sh"

good='point_line 3 6 2 3 4'
queries='ray_sphere, ray_triangle, point_line, point_plane, point_sphere'

# refused NAME LINE MESSAGE: the line after a comment, a blank line and a good one, from a file and from standard input.
refused() {
  printf '%s\n' '# comment' '' "$good" "$2" "$good" >cases
  run answer cases </dev/null
  expect "$1" 2 "positive" "cases:4: $3"
  run answer <cases
  expect "$1, standard input" 2 "positive" "<stdin>:4: $3"
}
refused "unknown query" 'ray_cube 1 2 3' "unknown query 'ray_cube'; the queries are $queries"
refused "no query" '1 2 3' "unknown query '1'; the queries are $queries"
refused "too few numbers" 'point_line 1 2 3 4' 'point_line takes 5 numbers, px py a b c; this line has 4'
refused "too many numbers" 'point_plane 1 2 3 4 5 6 7 8' 'point_plane takes 7 numbers, px py pz a b c d; this line has 8'
refused "half a range" 'ray_sphere 1 2 3 4 5 6 7 8 9 10 11' \
  'ray_sphere takes 10 numbers, ex ey ez dx dy dz cx cy cz r, or 12 with t_min t_max; this line has 11'
refused "no number" 'point_sphere 1 2 3 4 5 six 7' "'six' is no number (cz of point_sphere)"
refused "a comment at the end" "$good # comment" 'point_line takes 5 numbers, px py a b c; this line has 7'
refused "a decimal comma" 'point_line 1,5 2 3 4 5' "'1,5' is no number (px of point_line)"

echo 'point_line 3 6 2 3 4' >line
run answer --kernel cramer line </dev/null
expect "a query that the kernel lacks" 2 "" "line:1: kernel cramer does not answer point_line; these do: graze, textbook-naive"
echo 'ray_triangle 0 0 0 1 0 0 1 0 0 2 0 0 2 1 0' >triangle
run answer --kernel textbook-naive --precision float triangle </dev/null
expect_like "a triangle for a sphere's kernel" 2 err \
  "triangle:1: kernel textbook-naive does not answer ray_triangle; these do: graze, cramer, moller-trumbore, "

run answer nonesuch </dev/null
expect "no such file" 2 "" \
  "graze: cannot read 'nonesuch': No such file or directory; check the path, or leave it out to read standard input"
run answer "" </dev/null
expect_like "an empty name" 2 err "cannot read ''"
run answer . </dev/null
expect "a directory" 2 "" "graze: cannot read '.': it is a directory; name a file in it"
run answer <.
expect "a directory as standard input" 2 "" "graze: cannot read <stdin>: Is a directory; give a file that can be read"
run answer <&-
expect "standard input closed" 2 "" "graze: cannot read <stdin>: Bad file descriptor; give a file that can be read"
: >locked
chmod 000 locked
if [ ! -r locked ]; then # not for root, who reads all
  run answer locked </dev/null
  expect "a file without permission" 2 "" "graze: cannot read 'locked': Permission denied; allow it with chmod u+r"
fi
finish

# graze shrink: the simplest case of the same failure, from a line, a file and standard input; what does not fail; what is refused.
. "$(dirname "$0")/check.sh"

# The stable quadratic with sgn(0) = 0 divides zero by zero from the center of a sphere.
center='ray_sphere 3.25 -1.5 7.125  0.3 0.7 -1.9  3.25 -1.5 7.125  2.4'
run shrink --kernel textbook-stable "$center" </dev/null
expect_like "a failure is told" 1 out "ray_sphere, double, where textbook-stable answers"
if [ -s err ]; then fail "nothing wanted on stderr"; fi
cp out first
printf '# a comment\n\n%s\n' "$center" >cases
run shrink --kernel textbook-stable cases </dev/null
cmp -s out first || fail "a file gives the same"
run shrink --kernel textbook-stable <cases
cmp -s out first || fail "standard input gives the same"

# The output is a case file, on which the kernel still answers what is told, and which does not shrink further.
answer=$(sed -n 's/^# answers  //p' first)
exact=$(sed -n 's/^# exact    //p' first)
run answer --details --kernel textbook-stable first </dev/null
expect "the wrong answer is repeated" 0 "$answer" ""
run answer --details first </dev/null
expect "the right one too" 0 "$exact" ""
run shrink --kernel textbook-stable first </dev/null
cmp -s out first || fail "what is minimal stays"
if [ "$(grep -c -v '^#' first)" != 1 ] || grep -v '^#' first | grep -q '[2-9a-f]p'; then fail "small numbers are wanted"; fi

run shrink --kernel textbook-stable --precision float --test "$center" </dev/null
expect_like "a test in C++" 1 out "TEST_CASE(\""
expect_like "of floats" 1 out "const graze::Ray<float> ray{{0x0p+0F, "

run shrink "$center" </dev/null
expect "what does not fail" 0 "" "graze: kernel graze does not fail on this case in double: there is nothing to shrink"
printf '%s\n%s\n' 'point_line 3 6 2 3 4' "$center" >two
run shrink --kernel textbook-stable two </dev/null
expect_like "a query that is not offered does not fail" 1 err "two:1: kernel textbook-stable does not fail"
expect_like "and the next line does" 1 out "ray_sphere"

# In another floating-point mode another case fails.
third='ray_sphere 0 0 0  1 2 2  1 1 0  1'
run shrink --kernel graze --float-mode up "$third" </dev/null
expect_like "the kernel fails in no mode" 0 err "does not fail"
run shrink --kernel textbook-repaired --float-mode up 'ray_sphere 0 0 0  3 0 0  4 0 0  3' </dev/null
expect_like "one that fails where rounding is up alone" 1 out "rounding upward, where textbook-repaired answers"
run shrink --kernel textbook-repaired 'ray_sphere 0 0 0  3 0 0  4 0 0  3' </dev/null
expect_like "and not by default" 0 err "does not fail"
run shrink --kernel textbook-repaired --test --float-mode up "$third" </dev/null
expect_like "no test in another mode" 2 err "graze: --test writes tests that run in the default floating-point mode"
run shrink --float-mode sideways "$third" </dev/null
expect_like "no such mode" 2 err "'sideways' is none of nearest, up, down, zero, ftz-daz"

run shrink --kernel textbook-stable --trials 3 "$center" </dev/null
expect_like "bounded trials" 1 err "the trials ran out"
run shrink --trials 0 "$center" </dev/null
expect_like "no trials" 2 err "--trials"
run shrink --kernel nonesuch "$center" </dev/null
expect_like "unknown kernel" 2 err "no kernel is named 'nonesuch'; there are: graze, "
run shrink 'ray_sphere 1 2' </dev/null
expect_like "a line that cannot be read" 2 err "graze: ray_sphere takes 10 numbers"
printf '\nray_cube 1\n' >bad
run shrink bad </dev/null
expect_like "in a file" 2 err "bad:2: unknown query 'ray_cube'"
run shrink missing </dev/null
expect_like "no such file" 2 err "graze: cannot read 'missing'"
finish

# The program's own options and its usage errors.
. "$(dirname "$0")/check.sh"

run --version </dev/null
expect_like "version" 0 out "graze "
if [ -s err ]; then fail "version: nothing wanted on stderr"; fi

run --help </dev/null
expect_like "help" 0 out "answer"
run answer --help </dev/null
expect_like "help of answer: precision" 0 out "--precision"
expect_like "help of answer: cases" 0 out "ray_triangle ex ey ez"
expect_like "help of answer: kernels" 0 out "moller-trumbore"

run </dev/null
expect_like "no command" 2 err "a command is wanted"
run frobnicate </dev/null
expect_like "unknown command" 2 err "frobnicate"
run --frobnicate </dev/null
expect_like "unknown option" 2 err "--frobnicate"
run answer --frobnicate </dev/null
expect_like "unknown option of answer" 2 err "--frobnicate"
run answer --precision half </dev/null
expect_like "unknown precision" 2 err "half not in {double,float}"
run answer --precision </dev/null
expect_like "precision left out" 2 err "--precision"
run answer one two </dev/null
expect_like "two files" 2 err "two"

run answer --kernel nonesuch </dev/null
expect_like "unknown kernel" 2 err "graze: no kernel is named 'nonesuch'; there are: graze, textbook-naive, "
finish

# Writes a Catch2 suite of what `graze shrink --test` prints, one test for each query and precision: shrunk_tests.sh GRAZE OUTPUT
set -eu
graze=$1 output=$2
# The command says with status 1 that the kernel fails, which is wanted here.
shrunk() {
  status=0
  "$graze" shrink --test "$@" >>"$output.part" || status=$?
  [ "$status" -eq 1 ] || { echo "status $status of: shrink --test $*" >&2; exit 1; }
}
cat >"$output.part" <<'SOURCE'
#include <limits>

#include "graze/implicit.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "tests/catch.hpp"
SOURCE
for precision in float double; do
  echo "namespace of_$precision {" >>"$output.part"
  shrunk --precision $precision --kernel textbook-stable 'ray_sphere 3.25 -1.5 7.125  0.3 0.7 -1.9  3.25 -1.5 7.125  2.4'
  # So small that products of two vanish.
  if [ $precision = float ]; then e=e-30; else e=e-300; fi
  for kernel in cramer moller-trumbore; do
    shrunk --precision $precision --kernel $kernel "ray_triangle 0 0 1 0 0 -1 -1$e -1$e 0 2$e -1$e 0 0 2$e 0"
  done
  shrunk --precision $precision --kernel textbook-naive "point_sphere 1$e 0 0 0 0 0 2$e"
  shrunk --precision $precision --kernel textbook-naive 'point_line 0.1 0.2 10 5 -2'
  shrunk --precision $precision --kernel textbook-naive 'point_plane 0.1 0.2 0.3 10 5 1 -2.3'
  echo "}" >>"$output.part"
done
mv "$output.part" "$output"

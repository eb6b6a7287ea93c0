# Pictures: what is drawn, where another kernel disagrees, and what is refused.
. "$(dirname "$0")/check.sh"

# A square of two triangles, seen face on.
printf 'OFF\n4 2 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n3 0 1 2\n3 0 2 3\n' >square.off
run render square.off -o square.png --size 9 --from 0 0 1 --kinds --at-corners
expect_like "a square: its corners" 0 out "vertex: 4"
expect_like "a square: its faces" 0 out "face: "
if [ "$(head -n 1 out)" != "pixels: 9 x 9" ]; then fail "a square: 9 x 9 pixels wanted"; fi
if [ "$(od -An -tx1 -N8 square.png | tr -d ' ')" != 89504e470d0a1a0a ]; then fail "a square: no PNG"; fi
cp square.png kinds.png
run render square.off -o square.png --size 9 --from 0 0 1 --at-corners
expect_like "without kinds" 0 out "vertex: 4"
if cmp -s square.png kinds.png; then fail "without kinds: another picture wanted"; fi
# From the side it is a line, in whose plane the rays run.
run render square.off -o square.png --size 5 --from 1 0 0 --kinds
expect "from the side" 0 "pixels: 1 x 5
coplanar: 5" ""
printf '0 0 0 1\n' >ball.spheres
run render ball.spheres -o ball.png --size 16 --zoom 3
expect_like "a sphere" 0 out "secant: "
# Width and height of the picture, from its header.
if [ "$(od -An -tu1 -j16 -N8 ball.png | tr -s ' ')" != " 0 0 0 48 0 0 0 48" ]; then fail "a sphere: 48 x 48 wanted"; fi

# A ball of triangles whose coordinates have no short form: rays at its corners slip through for a kernel in float.
awk 'BEGIN {
  n = 24; m = 48; print "OFF"; print n * m, 2 * (n - 1) * m, 0
  for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
    a = 0.02 + 3.1 * i / (n - 1); b = 6.283185307179586 * j / m
    printf "%.9g %.9g %.9g\n", sin(a) * cos(b), cos(a), sin(a) * sin(b)
  }
  for (i = 0; i + 1 < n; ++i) for (j = 0; j < m; ++j) {
    p = i * m + j; q = i * m + (j + 1) % m
    print 3, p, q, q + m; print 3, p, q + m, p + m
  }
}' >ball.off
run render ball.off -o ball.png --size 60 --precision float --at-corners --kernel moller-trumbore
expect_like "another kernel loses rays" 1 out "lost: "
run render ball.off -o ball.png --size 60 --precision float --at-corners --kernel graze
expect_like "ours loses none" 0 out "agrees: "
if [ "$(wc -l <out)" -ne 2 ]; then fail "ours: agreement alone wanted"; fi
run render ball.off -o ball.png --size 60 --at-corners --kernel graze
expect_like "in double" 0 out "agrees: "

# What is refused; no picture is left behind.
rm -f none.png
run render square.off
expect_like "no output" 2 err "--output is required"
run render nonesuch.off -o none.png
expect "no such file" 2 "" "nonesuch.off: no such file"
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >empty.off
run render empty.off -o none.png
expect_like "no triangles" 2 err "empty.off: "
run render square.off -o none.png --from 0 0 0
expect_like "no direction" 2 err "--from takes a direction"
run render square.off -o none.png --size 10000 --zoom 60
expect_like "too large" 2 err "pixels a side"
run render square.off -o none.png --size 0
expect_like "no pixel" 2 err "--size"
run render square.off -o none.png --kernel nonesuch
expect_like "no such kernel" 2 err "graze: no kernel is named 'nonesuch'"
run render square.off -o none.png --kernel haines-sphere
expect_like "a kernel of spheres" 2 err "does not answer ray_triangle in double"
run render square.off -o none.png --kernel graze --kinds
expect_like "both" 2 err "excludes"
printf 'OFF\n3 1 0\n-1e308 0 0\n1e308 0 0\n0 1e308 0\n3 0 1 2\n' >large.off
run render large.off -o none.png
expect_like "too large for a camera" 2 err "too large for a camera"
if [ -e none.png ]; then fail "a refused picture was written"; fi
run render square.off -o nowhere/none.png
expect_like "a folder that is not there" 2 err "nowhere/none.png"
finish

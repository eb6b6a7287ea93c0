# The answers of the contract, from files and from standard input.
. "$(dirname "$0")/check.sh"

cat >cases <<'END'
# a tangent, a secant and their relatives
ray_sphere 0 1 0  1 0 0  5 0 0  1
ray_sphere 0 0 0  1 0 0  5 0 0  1

ray_sphere 0 0 0  1 0 0  5 0 0  1  4.5 inf
ray_sphere 0 0 0  1 0 0  5 0 0  1  0 0x1.2p2
ray_sphere 5 0 0  1 0 0  5 0 0  1
ray_sphere 0 2 0  1 0 0  5 0 0  1
   # triangles
ray_triangle 0.25 0.5 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 0.25 0.75 -1.5  0 0 1  0 0 0  1 0 0  0 1 0
ray_triangle 0.25 0 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 0 0.25 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 0 0 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 1 0 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 0 1 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 1 1 1  0 0 -1  0 0 0  1 0 0  0 1 0
ray_triangle 0 0 0  1 0 0  1 0 0  2 0 0  2 1 0
# sides
point_line 3 6  2 3 4
point_line -11 6  2 3 4
point_line -12 6  2 3 4
point_line 1 1  0 0 -1
point_plane 3 0 0  1 -2 2 -3
point_sphere 1 2 3  1 2 3  3
point_sphere 2 4 5  1 2 3  3
point_sphere 9 9 9  1 2 3  3
# invalid
ray_sphere 0 0 0  0 0 0  5 0 0  1
ray_sphere 0 0 0  1 0 0  5 0 0  -1
ray_sphere 0 0 0  1 0 0  5 0 0  1  2 1
ray_sphere 0 0 0  1 0 0  5 0 0  1e400
ray_sphere 0 0 0  0 0 0  5 0 0  -1  2 nan
ray_sphere 0 0 0  1 0 0  5 0 0  1  0 -inf
ray_triangle 0 0 0  0 0 0  1 0 0  2 0 0  2 1 0
point_line inf 0  1 0 0
point_sphere 0 0 0  0 0 0  -1
END
answers="tangent 5
secant 4 6
secant 6
secant 4
secant 1
miss
face 1 0.25 0.5
edge_bc 1.5 0.25 0.75
edge_ab 1 0.25 0
edge_ca 1 0 0.25
vertex_a 1 0 0
vertex_b 1 1 0
vertex_c 1 0 1
miss
coplanar 1 2
positive
on
negative
negative
on
inside
on
outside
invalid zero_direction
invalid negative_radius
invalid empty_range
invalid non_finite
invalid non_finite
invalid non_finite
invalid zero_direction
invalid non_finite
invalid negative_radius"
run answer cases </dev/null
expect "from a file" 0 "$answers" ""
run answer <cases
expect "from standard input" 0 "$answers" ""
run answer - <cases
expect "from -" 0 "$answers" ""
run answer --precision double --kernel graze cases </dev/null
expect "with the defaults named" 0 "$answers" ""
run answer --precision float cases </dev/null
expect "in float" 0 "$answers" ""

details="tangent 5 origin=outside root=both
secant 4 6 origin=outside root=both
secant 6 origin=outside root=second
secant 4 origin=outside root=first
secant 1 origin=inside root=second
miss origin=outside
face 1 0.25 0.5 facing=front
edge_bc 1.5 0.25 0.75 facing=back
edge_ab 1 0.25 0 facing=front
edge_ca 1 0 0.25 facing=front
vertex_a 1 0 0 facing=front
vertex_b 1 1 0 facing=front
vertex_c 1 0 1 facing=front
miss facing=front
coplanar 1 2 facing=none
$(printf '%s\n' "$answers" | tail -n +16)"
run answer --details cases </dev/null
expect "with details" 0 "$details" ""

# One third, in each precision.
echo 'ray_sphere 0 0 0 3 0 0 2 0 0 1' >third
run answer third
expect "one third in double" 0 "secant 0.3333333333333333 1" ""
run answer --precision float third
expect "one third in float" 0 "secant 0.33333334 1" ""

# A number that is finite in double and not in float.
echo 'point_line 1e39 0 1 0 0' >large
run answer large
expect "1e39 in double" 0 "positive" ""
run answer --precision float large
expect "1e39 in float" 0 "invalid non_finite" ""

# Another kernel: the stable form loses the roots of a ray from the center.
echo 'ray_sphere 0 0 0 1 0 0 0 0 0 2' >center
run answer center
expect "from the center" 0 "secant 2" ""
run answer --kernel textbook-repaired center
expect "from the center, repaired" 0 "secant 2" ""
run answer --kernel textbook-stable center
expect "from the center, stable" 0 "secant -0 inf" ""
finish

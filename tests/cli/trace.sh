# Scenes: what rays hit, where points lie, and what is refused.
. "$(dirname "$0")/check.sh"

# A tetrahedron, as OFF, OBJ and PLY; corner (0, 0, 0).
corners='0 0 0
1 0 0
0 1 0
0 0 1'
faces='3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2'
printf '%s\n' OFF '4 4 0' "$corners" "$faces" >tetra.off
{
  printf '%s\n' "$corners" | sed 's/^/v /'
  printf '%s\n' 'f 1 3 2' 'f 1 2 4' 'f 2 3 4' 'f 1 4 3'
} >tetra.obj
cat >tetra.ply <<'END'
ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
element face 4
property list uchar int vertex_indices
end_header
END
printf '%s\n' "$corners" "$faces" >>tetra.ply
cat >tetra.stl <<'END'
solid tetra
facet normal 0 0 -1
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 -1 0
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 0 1
endloop
endfacet
facet normal 1 1 1
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
facet normal -1 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
endsolid tetra
END
cat >rays <<'END'
# down at a face, at an edge and at a corner, past it, along a face
0.25 0.25 2  0 0 -1
0.25 0 2  0 0 -1
0 0 2  0 0 -2

2 2 2  0 0 1
-1 0.25 0  1 0 0
0.25 0.25 2  0 0 -1  1.75 1.9
0.25 0.25 2  0 0 0
0.25 0.25 2  0 nan 0
0.25 0.25 2  0 0 -1  2 1
END
closest="2 face 1.5 0.25 0.5
1 coplanar 1.25 2
1 coplanar 0.5 1
miss
0 coplanar 1 1.75
miss
invalid zero_direction
invalid non_finite
invalid empty_range"
run trace tetra.off <rays
expect "closest hits" 0 "$closest" ""
for mesh in tetra.obj tetra.ply tetra.stl; do
  run trace $mesh <rays
  expect "closest hits of $mesh" 0 "$closest" ""
done
run trace --precision float --query closest tetra.off <rays
expect "in float" 0 "$closest" ""
run trace --query any tetra.off <rays
expect "any" 0 "hit
hit
hit
miss
hit
miss
invalid zero_direction
invalid non_finite
invalid empty_range" ""
run trace --query count tetra.off <rays
expect "count" 0 "2
3
4
0
3
0
invalid zero_direction
invalid non_finite
invalid empty_range" ""

# Two files: primitives are numbered through them.
printf '# two spheres\n0.25 0.25 5 1\n\n0.25 0.25 2 0x1p0\n' >two.spheres
echo '0.25 0.25 9 0 0 -1' >down
run trace --query all two.spheres tetra.off <down
expect "all" 0 "0 secant 3 5; 1 secant 6 8; 4 face 8.5 0.25 0.5; 2 face 9 0.25 0.25" ""
run trace --stats two.spheres tetra.off <down
expect_like "stats" 0 err "roundings: 1"
expect_like "stats: size" 0 err "scene: 6 primitives"

# A polygon is a fan.
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >square.off
printf '0.75 0.25 1 0 0 -1\n0.25 0.75 1 0 0 -1\n0.5 0.5 1 0 0 -1\n' >three
run trace square.off <three
expect "a fan" 0 "0 face 1 0.5 0.25
1 face 1 0.25 0.5
0 edge_ca 1 0 0.5" ""

cat >points <<'END'
0.1 0.1 0.1
0 0 0
0.5 0.5 0
0.25 0.25 0.25
1 1 1
0.5 0.25 0.25
0.5 0.25 0.25000000000000006
0.5 0.25 0.24999999999999997
inf 0 0
END
run inside tetra.off <points
expect "inside" 0 "inside
boundary
boundary
inside
outside
boundary
outside
inside
invalid non_finite" ""

# What is refused, before the first answer.
run inside square.off <points
expect_like "an open mesh" 2 err "square.off: is not closed: triangle "
expect_like "an open mesh: its edge" 2 err "has an edge from ("
run trace nonesuch.off <rays
expect "no such file" 2 "" "nonesuch.off: no such file"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >index.off
run trace index.off <rays
expect_like "a bad index" 2 err "index.off: "
if [ -s out ]; then fail "a bad index: no answer wanted"; fi
printf '0 0 0 1\n0 0 0 -1\n' >negative.spheres
run trace negative.spheres <rays
expect "a negative radius" 2 "" "negative.spheres:2: the sphere's radius is negative"
printf '0 0 0 1e999\n' >large.spheres
run trace large.spheres <rays
expect "a radius that is not finite" 2 "" "large.spheres:1: a number of the sphere is not finite"
printf '0 0 0\n' >short.spheres
run trace short.spheres <rays
expect "three numbers" 2 "" "short.spheres:1: a sphere takes 4 numbers, cx cy cz r; this line has 3"
printf 'OFF\n3 1 0\n0 0 0\n1e39 0 0\n0 1 0\n3 0 1 2\n' >large.off
run trace --precision float large.off <rays
expect "too large for float" 2 "" "large.off: point 1 has a coordinate that is too large for float"
printf '0 0 2 0 0 -1\n0 0 2 0 0\n' >shortray
run trace tetra.off <shortray
expect_like "a ray of five numbers" 2 err "<stdin>:2: a ray takes 6 numbers, ex ey ez dx dy dz, or 8 with t_min t_max; this line has 5"
expect_like "the answers before it stand" 2 out "1 coplanar 1 2"
printf '0 0 2 0 0 x\n' >badray
run trace tetra.off <badray
expect "a ray with a word" 2 "" "<stdin>:1: 'x' is no number (dz of a ray)"
run trace <rays
expect_like "no mesh" 2 err "mesh"
run trace --query some tetra.off <rays
expect_like "an unknown query" 2 err "some"
finish

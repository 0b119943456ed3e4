#!/bin/sh
# planecut-region.t - what of a mesh is cut: the side of the tool, a box, some surfaces, some
# steepness; and what planes may cost.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# A box 30 x 20 x 10 with a round hole of radius 4 through it.
nurbs2mesh -e 0.005 "$SRC/tests/data/box.step" >"$TMP/box.ply" 2>/dev/null
surface() { # K: the number of surface K of the mesh
	sed -n 's/^comment surface .*:\([0-9]*\)$/\1/p' "$TMP/box.ply" | sed -n "$1p"
}

# Contact points of a path: where they are and where they face.
contacts() { # NAME ARGS...
	name=$1
	shift
	planecut -r 1 -s 1 --avoid --paper --up 0,0,1 "$@" "$TMP/box.ply" >"$TMP/$name.cl" 2>"$TMP/$name.err" &&
		sed -n 's/^\$\$-> CONTCT\///p' "$TMP/$name.cl" | tr , ' ' >"$TMP/$name"
}
every() { # DESC NAME CONDITION: there are contacts, and all of them are so
	ok "$1" awk "!($3) { bad++ } END { exit !(NR > 0 && bad == 0) }" "$TMP/$2"
}

planecut -r 1 -s 1 --avoid "$TMP/box.ply" >"$TMP/all.cl" 2>"$TMP/err"
sed -n 's/^\$\$-> CONTCT\///p' "$TMP/all.cl" | tr , ' ' >"$TMP/all"
every "nothing that faces away from above is cut" all '$6 >= -1e-6'
planecut -r 1 -s 1 --avoid --up 0,-1,0 "$TMP/box.ply" 2>/dev/null |
	sed -n 's/^\$\$-> CONTCT\///p' | tr , ' ' >"$TMP/side"
every "nor from another side" side '$5 <= 1e-6'
ok "the wall on that side is" awk '$2 < 1e-6 { n++ } END { exit !(n > 10) }' "$TMP/side"

contacts box --box 5,5,8,12.5,15,11
every "--box: inside it" box '$1 > 5 - 1e-6 && $1 < 12.5 + 1e-6 && $2 > 5 - 1e-6 && $2 < 15 + 1e-6 && $3 > 8 - 1e-6'
ok "up to its sides" awk '$1 < 5 + 1e-5 { a++ } $1 > 12.5 - 1e-5 { b++ } END { exit !(a > 5 && b > 3) }' "$TMP/box"
# An L with a hole, by a file of polygons
printf '# an L\n2 2\n28 2\n28 8\n10 8\n10 18\n2 18\n\n4 4\n8 4\n8 6\n4 6\n' >"$TMP/region"
inside='($1 > 2 - 1e-6 && $1 < 28 + 1e-6 && $2 > 2 - 1e-6 && $2 < 18 + 1e-6 && ($2 < 8 + 1e-6 || $1 < 10 + 1e-6) && !($1 > 4 + 1e-6 && $1 < 8 - 1e-6 && $2 > 4 + 1e-6 && $2 < 6 - 1e-6))'
contacts l --region "$TMP/region" --steep 0:45
every "--region: inside its polygons" l "$inside"
ok "up to their sides" awk '$1 > 28 - 1e-4 { a++ } $1 < 2 + 1e-4 { b++ } $2 > 17 { c++ } $1 > 4 - 1e-4 && $1 < 4 + 1e-4 && $2 > 4 && $2 < 6 { d++ }
	END { exit !(a > 3 && b > 5 && c > 3 && d > 0) }' "$TMP/l"
ok "on both sides of the hole in it" awk '$2 > 4.1 && $2 < 5.9 && $1 < 4 + 1e-4 { a++ } $2 > 4.1 && $2 < 5.9 && $1 > 8 - 1e-4 && $1 < 28 { b++ } END { exit !(a > 0 && b > 0) }' "$TMP/l"
top=$(surface 2)
contacts top --faces "$top"
every "--faces: one, the top" top '$3 > 10 - 1e-6 && $6 > 1 - 1e-6'
contacts two --faces "$(surface 2),$(surface 7)-$(surface 7)"
every "two, the top and the hole" two '$6 > 1 - 1e-6 || ($1 - 15) ^ 2 + ($2 - 10) ^ 2 < 16 + 1e-4'
ok "and both" awk '$6 < 0.5 { a++ } $6 > 0.5 { b++ } END { exit !(a > 5 && b > 5) }' "$TMP/two"
contacts flat --steep 0:45
every "--steep 0:45: the top" flat '$6 > 0.707'
contacts steep --steep 45:90
every "--steep 45:90: the walls" steep '$6 < 0.707 && $6 > -1e-6'

# Options together, and planes of which some run along what is cut.
contacts both --faces "$(surface 2),$(surface 7)" --box 0,0,5,15,20,11 --steep 0:45
every "--faces, --box and --steep together" both '$6 > 0.707 && $1 < 15 + 1e-6 && $3 > 10 - 1e-6'
ok "reach the sides of the box" awk '$1 > 15 - 1e-5 { a++ } END { exit !(a > 5) }' "$TMP/both"
contacts wall --faces "$(surface 3)" --up 0,-1,0 -a auto
every "a wall from its side: planes that cross it are found" wall '$2 < 1e-6 && $5 < -1 + 1e-6'
ok "and go over all of it" awk 'NR == 1 { a = A = $1; c = C = $3 }
	{ if ($1 < a) a = $1; if ($1 > A) A = $1; if ($3 < c) c = $3; if ($3 > C) C = $3 }
	END { exit !(a < 0.6 && A > 29.4 && c < 0.6 && C > 9.4) }' "$TMP/wall"

# The exact border of a slope: a ball, of which 30 to 60 degrees are cut, on a cone.
cat <<'END2' | { cat; echo "REP ADVANCED_BREP_SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})"; } |
s1 SPHERICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)
b1 FACE_BOUND('',{l1},.T.)
l1 VERTEX_LOOP('',{v 0 0 -10})
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
shell CLOSED_SHELL('',({f1}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END2
	awk -f "$SRC/tests/lib/step.awk" >"$TMP/ball.step"
nurbs2mesh -e 0.002 "$TMP/ball.step" >"$TMP/ball.ply" 2>/dev/null
cp "$TMP/box.ply" "$TMP/hole.ply"
cp "$TMP/ball.ply" "$TMP/box.ply"
contacts slope --steep 30:60
every "a ball's slope of 30 to 60 degrees" slope '$6 < 0.8664 && $6 > 0.4998'
ok "all of it" awk '$6 > 0.8650 { a++ } $6 < 0.5010 { b++ } END { exit !(a > 10 && b > 10) }' "$TMP/slope"
planecut -v -r 1 -s 1 "$TMP/box.ply" >/dev/null 2>"$TMP/v"
has "the largest ball that fits is told" "a ball of any radius fits" "$TMP/v"

# A ball that rolls over the edges of a box and down its walls, fitted: no arc swings out between the
# corners of facets that are as long as a wall.
planecut -q -r 3 -s 4 --avoid "$TMP/hole.ply" 2>/dev/null | biarcfit -q -e 0.01 2>/dev/null | ncpost -q -c siemens >"$TMP/box.mpf" 2>/dev/null
ncverify --partial -c siemens -g "$TMP/hole.ply" "$TMP/box.mpf" >"$TMP/out" 2>/dev/null
has "a program for long facets is accepted" "^verdict *accepted" "$TMP/out"

# What slopes and faces leave out is said, by its outline: the judge asks for the rest, and for all of
# that.
awk 'BEGIN { for (y = -15; y <= 15.001; y += 0.5) for (x = -15; x <= 15.001; x += 0.5)
	printf "%.5f %.5f %.5f\n", x, y, 2.2 * sin(x / 4) * cos(y / 5) + 8 }' >"$TMP/waves.xyz"
cloud2mesh -q -t 0.5 "$TMP/waves.xyz" -o "$TMP/waves.ply"
cd "$TMP" || exit 1
for steep in 0:18 15:40; do
	status 0 "--steep $steep of a scan" planecut -q -r 3 --scallop 0.02 --steep $steep --avoid waves.ply -o waves.cl
	has "... the path says its outline" '^\$\$-> REGION/POLYGON,' waves.cl
	status 0 "... is fitted" bsplfit -q -e 0.01 waves.cl -o waves.spline
	status 0 "... is a program" ncpost -q -c siemens waves.spline -o waves.mpf
	status 0 "... is accepted" ncverify -q -g waves.xyz --partial waves.mpf
	has "... in the region that is to be cut" 'in the region that is to be cut' out
done
half=$(awk -F/ '/PASS/ { n++ } END { print int(n / 2) }' waves.cl)
awk -v half="$half" '/PASS/ { n++ } n < half || n > half + 2 || /FINI/' waves.cl | ncpost -q -c siemens -o less.mpf 2>/dev/null
status 3 "three passes fewer are not" ncverify -q -g waves.xyz --partial less.mpf
has "... for they are left" 'fault .* of material is left' out
planecut -q -r 3 -s 1 --faces "$top" --avoid hole.ply >top.cl 2>/dev/null
ncpost -q -c siemens top.cl >top.mpf
grep '^; REGION' top.mpf | sed 's/^[^:]*: //' | tr '\n' ' ' >top
has "--faces: the outline of the top has its hole" '^BORDER 1.125 POLYGON [0-9. ]* POLYGON [0-9. ]*$' top
has "... and its corners" ' 0 20 0 0 30 0 30 20 $' top

# ---- what is refused

box() {
	status "$1" "$2" planecut -r 1 "$3" "$4" "$5" "$6" "$TMP/box.ply"
	has "$2: says why" "$7" "$TMP/err"
	empty "$2: nothing is written" "$TMP/out"
}
box 2 "a box without inside" -s 1 --box 0,0,0,0,1,1 "lower bound first"
box 2 "no angles" -s 1 --steep 45 "expected two angles"
printf '1 1\n2 2\n' >"$TMP/two"
printf '1 1\n2 2\n3 x\n' >"$TMP/word"
: >"$TMP/empty"
box 1 "a polygon of two corners" -s 1 --region "$TMP/two" "two:2: found a polygon of 2 corners"
box 1 "a corner that is none" -s 1 --region "$TMP/word" "word:3: found no two numbers"
box 1 "no polygon" -s 1 --region "$TMP/empty" "found no polygon"
box 1 "no such file" -s 1 --region "$TMP/nothing" "nothing: "
box 2 "a surface that there is not" -s 1 --faces 1 "expected the number of a surface"
box 2 "no number" -s 1 --faces top "expected numbers"
box 1 "nothing in the box" -s 1 --box 50,50,50,60,60,60 "nothing of the mesh"
box 1 "too many planes" -s 0.0001 --up 0,0,1 "would make [0-9]* planes, expected at most"

# ---- from a STEP file to a program that is checked

status 0 "samples/step.sh, a larger ball" sh "$SRC/samples/step.sh" "$SRC/tests/data/box.step" 4 2
has "its program is accepted" "^verdict *accepted" "$TMP/out"

# Slopes that all of the mesh has are the whole: what holes leave of it is cut and judged, too, and no
# outline is needed.
awk 'BEGIN { for (y = -8; y <= 8; y += 0.8) for (x = -8; x <= 8; x += 0.8)
	printf "%.3f %.3f %.3f\n", x, y, (x * x - y * y) / 60 }' >saddle.xyz
cloud2mesh -q -t 0.8 --max-gap 1.3 saddle.xyz -o saddle.ply
planecut -q -r 2 --scallop 0.05 --avoid -o whole.cl saddle.ply
status 0 "slopes that are all of the part" planecut -q -r 2 --scallop 0.05 --avoid --steep 0:60 \
	-o slopes.cl saddle.ply
cmp -s whole.cl slopes.cl
result $? "are cut as it is"
ncpost -q -c siemens -o slopes.mpf slopes.cl
status 0 "... and judged" ncverify -q -g saddle.xyz slopes.mpf
planecut -q -r 2 --scallop 0.05 --avoid --steep 0:10 -o flat.cl saddle.ply
cmp -s whole.cl flat.cl
result $((!$?)) "slopes that some of it has are not"

# The floor of a pit that the ball does not go into: what rides on its rim cuts nothing of it.
awk 'BEGIN { for (x = -10; x <= 10; x += 0.5) for (y = -10; y <= 10; y += 0.5) {
	a = x < 0 ? -x : x; b = y < 0 ? -y : y; m = a > b ? a : b
	z = m >= 3.5 ? 0 : m <= 2.5 ? -6 : 6 * (m - 3.5); print x, y, z } }' >pit.xyz
cloud2mesh -q -o pit.ply pit.xyz
status 3 "a place where the ball does not fit" planecut -r 8 --avoid --box -2,-2,-8,2,2,-5 \
	--scallop 0.05 -o pit.cl pit.ply
has "is told: nothing is cut" "nothing is cut: the ball comes to none of the points" "$TMP/err"
has "... and its head says so" "UNMET/planecut,nothing is cut" pit.cl
run planecut -r 1 --avoid --box -2,-2,-8,2,2,-5 --scallop 0.05 -o pit.cl pit.ply
hasnt "a smaller one does fit" "nothing is cut" "$TMP/err"

# The slopes of a ring, on both sides of its crest: they have no outline, lying over others, and no
# judge knows that the crest between them is not theirs.
cat <<'END' | iges ring
axis 110 0 0,0,0,0,0,9
upright 124 0 1,0,0,0,0,0,-1,0,0,1,0,0
round 100 0@upright 0,8,0,10.5,0,10.5,0
ring 120 0 {axis},{round},0.,6.283185307179586
END
nurbs2mesh -q -e 0.05 -o ring.ply ring.igs
status 0 "slopes that lie over others" planecut -r 3 --scallop 0.02 --avoid --steep 30:90 \
	-o ring.cl ring.ply
has "have no outline, which is said" "no outline, .*: the head promises no scallop" "$TMP/err"
has "... and what the facets are off is off surfaces" "off what it is of" "$TMP/err"
hasnt "the head promises none" '^\$\$-> SCALLOP' ring.cl
ncpost -q -c fanuc -o ring.nc ring.cl
status 0 "so that what stays between them is no fault" ncverify -q --partial -g ring.ply ring.nc

# A closed cylinder on three axes: its floor is out of reach, for no ball comes under it from above.
# As if a tool could lie there, rest passes went for the floor, and the path ended with 3.
cat <<'END' | iges post
axis 110 0 0,0,0,0,0,9
side 106 12 2,4,0,0,0,6,0,0,6,0,4,0,0,4
post 120 0 {axis},{side},0.,6.283185307179586
END
nurbs2mesh -q -e 0.05 -o post.ply post.igs
status 0 "a post with a floor" planecut -r 3 --scallop 0.05 --avoid --fixed 0,0,1 -m three-axis \
	-o post.cl post.ply
has "... whose floor is out of reach" "out of reach of ball and tool" "$TMP/err"
hasnt "... and nothing within" "within reach" "$TMP/err"
biarcfit -q post.cl | ncpost -q -c fanuc -m three-axis -o post.nc
status 0 "... and its program is accepted" ncverify -q -m three-axis -g post.ply post.nc
done_testing

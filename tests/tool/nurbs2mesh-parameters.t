#!/bin/sh
# nurbs2mesh-parameters.t - trimming that is given in the parameters of a surface alone, as IGES counts
# them on surfaces made of curves, and as STEP does on pcurves; offset curves; areas are known.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

reach() { # the least and largest x, y and z of the last model
	awk '/end_header/ { on = 1; next } !on || NF != 7 { next }
		{ for (k = 1; k < 4; k++) { if (!n || $k < l[k]) l[k] = $k; if (!n || $k > h[k]) h[k] = $k } n++ }
		END { for (k = 1; k < 4; k++) printf "%.2f %.2f%s", l[k] + 0, h[k] + 0, k < 3 ? " " : "" }' "$TMP/model.ply"
}

# ---- IGES: surfaces of curves

# on SURFACE-LINES LOOP...: a face of the surface {s}, trimmed by the curves {a} {b} ... in its parameters
on() { # NAME CURVES
	name=$1
	{
		cat
		echo "loop 102 0 $2"
		echo "out 142 0 0,{s},{loop},0,1"
		echo "face 144 0 {s},1,0,{out}"
	} | iges "$name"
}
rectangle() { # U V TO-U TO-V
	echo "a 110 0 $1,$2,0,$3,$2,0"
	echo "b 110 0 $3,$2,0,$3,$4,0"
	echo "c 110 0 $3,$4,0,$1,$4,0"
	echo "d 110 0 $1,$4,0,$1,$2,0"
}
sides='4,{a},{b},{c},{d}'

{
	rectangle 0.25 1 0.75 3
	cat <<'END'
axis 110 0 0,0,-5,0,0,9
g 110 0 10,0,0,10,0,20
s 120 0 {axis},{g},0.,6.283185307179586
END
} | on cylinder "$sides"
model "120: along the line, and the angle" "$(calc '10 * 2 * 10')" - -e 0.001 "$TMP/cylinder.igs"
ok "where it is" test "$(reach)" = "-9.90 5.40 1.41 10.00 5.00 15.00"

{
	rectangle 0.2 0.5 1.3 2.5
	cat <<'END'
axis 110 0 0,0,-5,0,0,9
turn 124 0 1,0,0,0,0,0,-1,0,0,1,0,0
g 100 0@turn 0,0,0,10,0,0,10
s 120 0 {axis},{g},0.,6.283185307179586
END
} | on sphere "$sides"
model "120: an arc's parameter is its angle" "$(calc '100 * 2 * (sin(1.3) - sin(0.2))')" - -e 0.0005 "$TMP/sphere.igs"

# Loops whose curves do not meet: far apart, which is said, and near, which is joined.
open_to() { # V NAME: a loop in the range of a plane of 40 by 30 that ends at 0, V
	cat <<END | on "$2" "1,{k}"
s 128 0 1,1,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1,0,0,0,40,0,0,0,30,0,40,30,0,0,1,0,1
k 106 11 1,5,0,0,0,1,0,1,1,0,1,0,$1
END
}
open_to 0.9 open
status 3 "a loop that is open" nurbs2mesh -e 0.01 -o "$TMP/x.ply" "$TMP/open.igs"
has "it is said, where" \
	'open.igs: surface [0-9]*: the curves .* are 27 mm apart at 0.000 13.500 0.000' "$TMP/err"
has "and it is in the mesh" 'unmet.*1 surfaces have a trimming loop' "$TMP/x.ply"
status 0 "--partial accepts it" nurbs2mesh --partial -e 0.01 -o "$TMP/x.ply" "$TMP/open.igs"
has "and it is said" 'are 27 mm apart' "$TMP/err"
# Who judges by the same file is told the same.
planecut -q -r 2 -s 2 --fixed 0,0,1 "$TMP/x.ply" | ncpost -q -c siemens -o "$TMP/x.mpf"
run ncverify -g "$TMP/open.igs" "$TMP/x.mpf"
has "ncverify says it" \
	'^ncverify: .*open.igs: surface [0-9]*: the curves .* are 27 mm apart' "$TMP/err"
run ncverify -q -g "$TMP/open.igs" "$TMP/x.mpf"
hasnt "but with -q" 'apart' "$TMP/err"
plane='nurbs 1 surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1
	points 0 0 0 40 0 0 0 30 0 40 30 0'
echo "$plane loop 0 0 1 0 0 1 1 1 end" >"$TMP/crossed.nurbs"
run ncverify -g "$TMP/crossed.nurbs" "$TMP/x.mpf"
has "that a loop crosses itself" \
	'^ncverify: .*crossed.nurbs: surface 1: its trimming crosses itself, in [0-9]+ ' "$TMP/err"
echo "$plane end" >"$TMP/sound.nurbs"
run ncverify -g "$TMP/sound.nurbs" "$TMP/x.mpf"
hasnt "and nothing of a sound surface" 'sound.nurbs: surface' "$TMP/err"
open_to 0.0004 little
status 0 "0.012 mm of 140 are joined" nurbs2mesh -e 0.001 -o "$TMP/x.ply" "$TMP/little.igs"
hasnt "nothing is said" apart "$TMP/err"
open_to 0.0006 more
status 3 "0.018 mm are not" nurbs2mesh -e 0.001 -o "$TMP/x.ply" "$TMP/more.igs"
status 0 "with a tolerance of 0.02 they are" nurbs2mesh -e 0.02 -o "$TMP/x.ply" "$TMP/more.igs"

cat <<'END' | on disc "1,{k}"
g 100 0 0,0,0,10,0,0,10
s 122 0 {g},10,0,15
k 100 0 0,0.5,0.5,0.8,0.5,0.8,0.5
END
model "122: a circle in the parameters" "$(calc '5 * p * 15 * p * 0.09')" - -e 0.0002 "$TMP/disc.igs"

# A line of 10 and a quarter circle of 10: the parameter of the whole runs from 0 to 1 and on to pi/2 more.
{
	rectangle 0.2 0.1 0.7 0.9
	cat <<'END'
g1 110 0 10,-10,0,10,0,0
g2 100 0 0,0,0,10,0,0,10
g 102 0 2,{g1},{g2}
s 122 0 {g},10,-10,20
END
} | on joined "$sides"
model "122: of a line and an arc" "$(calc '16 * (10 * (1 - 0.2 * (1 + p / 2)) + 10 * (0.7 * (1 + p / 2) - 1))')" - -e 0.001 "$TMP/joined.igs"

{
	rectangle 0.25 0.2 0.75 0.7
	cat <<'END'
g1 100 0 0,0,0,10,0,0,10
g2 100 0 0,0,0,20,0,0,20
s 118 1 {g1},{g2},0,0
END
} | on ruled "$sides"
model "118: between two arcs" "$(calc 'p / 4 * (17 ^ 2 - 12 ^ 2) / 2')" - -e 0.0005 "$TMP/ruled.igs"

{
	rectangle 0.25 0.2 0.75 0.7
	cat <<'END'
g 100 0 0,0,0,10,0,0,10
base 122 0 {g},10,0,15
s 140 0 -1,0,0,2,{base}
END
} | on offset "$sides"
model "140: in the parameters of what it is an offset of" "$(calc '8 * p / 4 * 7.5')" - -e 0.0005 "$TMP/offset.igs"

# A B-spline's own parameters are taken as they are.
{
	rectangle 0.25 0.2 0.75 0.7
	echo 's 128 0 2,1,1,1,0,0,1,0,0,0,0,0.5,1,1,0,0,1,1,1,1,1,1,1,1,0,0,0,5,0,0,10,0,0,0,8,0,5,8,0,10,8,0,0,1,0,1'
} | on spline "$sides"
model "128: trimmed in its parameters" 20 - -e 0.001 "$TMP/spline.igs"

# ---- IGES: holes in whole surfaces, drawn both in space and in the parameters

# The loop around the whole range runs along seams there and back, which bounds nothing in space.
holed() { # NAME: a face of {s} with the loops {whole} and {hole}, in the order that OpenCASCADE has
	{
		cat
		echo "in 142 0 0,{s},{hp},{hs},3"
		echo "out 142 0 0,{s},{wp},{ws},3"
		echo "face 144 0 {s},1,1,{in},{out}"
	} | iges "$1"
}

# A torus without a quarter of a quarter of it.
{
	rectangle 1.5707963268 1.5707963268 3.1415926536 3.1415926536
	cat <<'END'
axis 110 0 0,0,-5,0,0,9
up 124 0 1,0,0,20,0,0,-1,0,0,1,0,0
down 124 0 1,0,0,20,0,0,1,0,0,-1,0,0
flip 124 0 1,0,0,0,0,-1,0,0,0,0,-1,0
back 124 0 -1,0,0,-20,0,0,1,0,0,1,0,0
side 124 0 0,0,1,0,1,0,0,20,0,1,0,0
g 100 0@up 0,0,0,6,0,6,0
s 120 0 {axis},{g},0.,6.283185307179586
k 106 12 2,5,0,0,0,6.2831853,0,0,6.2831853,6.2831853,0,0,6.2831853,0,0,0,0
wp 102 0 1,{k}
w1 100 0@up 0,0,0,6,0,6,0
w2 100 0 0,0,0,26,0,26,0
w3 100 0@down 0,0,0,6,0,6,0
w4 100 0@flip 0,0,0,26,0,26,0
ws 102 0 4,{w1},{w2},{w3},{w4}
hp 102 0 4,{a},{b},{c},{d}
h1 100 0 6,0,0,0,20,-20,0
h2 100 0@back 0,0,0,0,6,-6,0
h3 100 0 0,0,0,0,14,-14,0
h4 100 0@side 0,0,0,0,6,-6,0
hs 102 0 4,{h1},{h2},{h3},{h4}
END
} | holed torus
model "120: a hole in a torus" "$(calc '4 * p ^ 2 * 120 - p / 2 * 6 * (20 * p / 2 - 6)')" - -e 0.001 "$TMP/torus.igs"

# A sphere whose generatrix begins at an angle of three halves of pi, and the curves at minus a half.
{
	awk 'BEGIN { p = atan2(0, -1); printf "hp 106 12 2,101"
		for (i = 0; i <= 100; i++) { y = 4 * cos(p * i / 50); z = 4 * sin(p * i / 50)
			t = atan2(y, -sqrt(84)); printf ",%.9f,%.9f,0", atan2(z, sqrt(100 - z * z)), t < 0 ? t + 2 * p : t }
		print "" }'
	cat <<'END'
axis 110 0 0,0,-5,0,0,9
up 124 0 1,0,0,0,0,0,-1,0,0,1,0,0
down 124 0 1,0,0,0,0,0,1,0,0,-1,0,0
across 124 0 0,0,1,-9.165151389911680,1,0,0,0,0,1,0,0
g 100 0@up 0,0,0,0,-10,0,10
s 120 0 {axis},{g},0.,6.283185307179586
k1 110 0 -1.5707963268,0,0,1.5707963268,0,0
k2 110 0 1.5707963268,6.2831853,0,-1.5707963268,6.2831853,0
wp 102 0 2,{k1},{k2}
w1 100 0@up 0,0,0,0,-10,0,10
w2 100 0@down 0,0,0,0,-10,0,10
ws 102 0 2,{w1},{w2}
hs 100 0@across 0,0,0,4,0,4,0
END
} | holed ball
model "120: a hole in a sphere" "$(calc '2 * p * 10 * (10 + sqrt(84))')" - -e 0.0005 "$TMP/ball.igs"

# ---- IGES: offset curves

moved() { # NAME OFFSET-PARAMETERS: the offset of the quarter circle {c}, moved along z
	name=$1
	{
		cat
		echo "o 130 0 {c},$2"
		echo "face 122 0 {o},$3,15"
	} | iges "$name"
}
quarter='c 100 0 0,0,0,10,0,0,10'
echo "$quarter" | moved part "1,0,0,0,2,0,0,0,0,0,1,0.5,1.25" "7.0206604951,3.8354042887"
model "130: between two parameters" "$(calc '8 * 0.75 * 15')" - -e 0.0005 "$TMP/part.igs"
# r = 10 - d with d rising from 1 to 3 evenly over the angle (or the length, which is the same)
spiral=$(awk 'BEGIN { p = atan2(0, -1) / 2; n = 2000; s = 2 / p
	for (i = 0; i <= n; i++) { t = p * i / n; r = 9 - s * t; w = i == 0 || i == n ? 1 : i % 2 ? 4 : 2; a += w * sqrt(r * r + s * s) }
	printf "%.9f", a * p / n / 3 * 15 }')
echo "$quarter" | moved by-angle "2,0,0,2,1,0,3,1.5707963267948966,0,0,1,0,1.5707963267948966" "9,0"
model "130: a distance that rises over the parameter" "$spiral" - -e 0.0005 "$TMP/by-angle.igs"
echo "$quarter" | moved by-length "2,0,0,1,1,0,3,15.707963267948966,0,0,1,0,1.5707963267948966" "9,0"
model "130: over the length" "$spiral" - -e 0.0005 "$TMP/by-length.igs"
{
	echo "$quarter"
	echo 'f 110 0 7,1,0,5,3,0' # its parameter is 0 to 1, and so are the angles used
} | moved by-curve "3,{f},2,2,0,0,0,0,0,0,1,0,1" "9,0"
model "130: as a coordinate of another curve" "$(awk 'BEGIN { n = 2000
	for (i = 0; i <= n; i++) { r = 9 - 2 * i / n; w = i == 0 || i == n ? 1 : i % 2 ? 4 : 2; a += w * sqrt(r * r + 4) }
	printf "%.9f", a / n / 3 * 15 }')" - -e 0.0005 "$TMP/by-curve.igs"
# Beside a corner the offset jumps: no curve is near it, which is told.
echo 'c 106 12 2,3,0,0,0,10,0,0,10,10,0' | moved corner "1,0,0,0,2,0,0,0,0,0,1,0,2" "0,2"
status 3 "an offset with a gap" nurbs2mesh -e 0.01 "$TMP/corner.igs"
has "how far it is off is told" "surface [0-9]*: it or its trimming is approximated, up to [0-9.]* mm off" "$TMP/err"

# ---- STEP: pcurves that are bare lines, offset curves

# The edges of a part of a cylinder: two lines, two arcs, in its parameters alone.
cat <<'END' | step lines
v1 VERTEX_POINT('',{p 5.4030230586813977 8.4147098480789651 5})
v2 VERTEX_POINT('',{p -9.8999249660044546 1.4112000805986721 5})
v3 VERTEX_POINT('',{p -9.8999249660044546 1.4112000805986721 15})
v4 VERTEX_POINT('',{p 5.4030230586813977 8.4147098480789651 15})
pa PCURVE('',{s},{ra})
pb PCURVE('',{s},{rb})
pc PCURVE('',{s},{rc})
pd PCURVE('',{s},{rd})
ra DEFINITIONAL_REPRESENTATION('',({la}),{CONTEXT})
rb DEFINITIONAL_REPRESENTATION('',({lb}),{CONTEXT})
rc DEFINITIONAL_REPRESENTATION('',({lc}),{CONTEXT})
rd DEFINITIONAL_REPRESENTATION('',({ld}),{CONTEXT})
la LINE('',{qa},{we})
lb LINE('',{qb},{wn})
lc LINE('',{qc},{we})
ld LINE('',{qa},{wn})
qa CARTESIAN_POINT('',(1.,5.))
qb CARTESIAN_POINT('',(3.,-7.))
qc CARTESIAN_POINT('',(0.,15.))
we VECTOR('',{de},1.)
wn VECTOR('',{dn},1.)
de DIRECTION('',(1.,0.))
dn DIRECTION('',(0.,1.))
e1 EDGE_CURVE('',{v1},{v2},{pa},.T.)
e2 EDGE_CURVE('',{v2},{v3},{pb},.T.)
e3 EDGE_CURVE('',{v4},{v3},{pc},.T.)
e4 EDGE_CURVE('',{v1},{v4},{pd},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
o2 ORIENTED_EDGE('',*,*,{e2},.T.)
o3 ORIENTED_EDGE('',*,*,{e3},.F.)
o4 ORIENTED_EDGE('',*,*,{e4},.F.)
l EDGE_LOOP('',({o1},{o2},{o3},{o4}))
b FACE_OUTER_BOUND('',{l},.T.)
s CYLINDRICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)
f ADVANCED_FACE('',({b}),{s},.T.)
open OPEN_SHELL('',({f}))
SOLID SHELL_BASED_SURFACE_MODEL('',({open}))
END
model "LINEs as PCURVEs of a cylinder" "$(calc '10 * 2 * 10')" - -e 0.001 "$TMP/lines.step"
ok "where it is" test "$(reach)" = "-9.90 5.40 1.41 10.00 5.00 15.00"

# A ring: outside a circle that lies 2 outside one of 8, inside a spline's offset.
cat <<'END' | step ring
k CIRCLE('',{a 0,0,0 0,0,1 1,0,0},8.)
z DIRECTION('',(0.,0.,1.))
c OFFSET_CURVE_3D('',{k},-2.,.F.,{z})
v VERTEX_POINT('',{p 10 0 0})
e EDGE_CURVE('',{v},{v},{c},.T.)
o ORIENTED_EDGE('',*,*,{e},.T.)
l EDGE_LOOP('',({o}))
b FACE_OUTER_BOUND('',{l},.T.)
k2 ELLIPSE('',{a 0,0,0 0,0,1 1,0,0},4.,2.)
c2 OFFSET_CURVE_3D('',{k2},1.,.F.,{z})
v2 VERTEX_POINT('',{p 3 0 0})
e2 EDGE_CURVE('',{v2},{v2},{c2},.T.)
o2 ORIENTED_EDGE('',*,*,{e2},.F.)
l2 EDGE_LOOP('',({o2}))
b2 FACE_BOUND('',{l2},.T.)
s PLANE('',{a 0,0,0 0,0,1 1,0,0})
f ADVANCED_FACE('',({b},{b2}),{s},.T.)
open OPEN_SHELL('',({f}))
SOLID SHELL_BASED_SURFACE_MODEL('',({open}))
END
# inside an offset inwards: the ellipse's area less length plus pi (no place is bent more than by 1/1)
model "OFFSET_CURVE_3D of a circle and of an ellipse" "$(awk 'BEGIN { p = atan2(0, -1); n = 20000
	for (i = 0; i < n; i++) { t = 2 * p * (i + 0.5) / n; l += sqrt(16 * sin(t) ^ 2 + 4 * cos(t) ^ 2) * 2 * p / n }
	printf "%.9f", 100 * p - (8 * p - l + p) }')" - -e 0.001 "$TMP/ring.step"

done_testing

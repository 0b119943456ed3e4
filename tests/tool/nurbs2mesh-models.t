#!/bin/sh
# nurbs2mesh-models.t - models of CAD systems, as IGES and STEP: areas and volumes that are known, no
# open edge, what is left out named, and files that are broken refused.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

. "$SRC/tests/lib/model.sh"

# ---- IGES: surfaces as they are

iges revolution <<'END'
axis 110 0 0,0,-5,0,0,9
line 110 0 10,0,0,4,0,20
face 120 0 {axis},{line},0.,6.283185307179586
END
model "120: a cone's side" "$(calc 'p * 14 * sqrt(36 + 400)')" - -e 0.002 "$TMP/revolution.igs"

iges quarter <<'END'
axis 110 0 0,0,-5,0,0,9
line 110 0 10,0,0,10,0,20
face 120 0 {axis},{line},0.,1.5707963267948966
END
model "120: a quarter of a cylinder" "$(calc 'p / 2 * 10 * 20')" - -e 0.004 "$TMP/quarter.igs"

iges ruled <<'END'
a 110 0 0,0,0,10,0,0
b 110 0 10,8,0,0,8,0
face 118 1 {a},{b},1,0
END
model "118: a rectangle, its second curve backwards" 80 - -e 0.01 "$TMP/ruled.igs"

iges ruled2 <<'END'
a 100 0 0,0,0,10,0,-10,0
b 100 0 7,0,0,10,0,-10,0
face 118 1 {a},{b},0,0
END
model "118: between two half circles" "$(calc 'p * 10 * 7')" - -e 0.004 "$TMP/ruled2.igs"

iges tabulated <<'END'
c 100 0 0,0,0,10,0,0,10
face 122 0 {c},10,0,15
END
model "122: a quarter circle moved along" "$(calc 'p / 2 * 10 * 15')" - -e 0.004 "$TMP/tabulated.igs"

# x = u, y = v, z = u v / 20 over 0..10 x 0..10 as 2 x 1 patches; one unused patch a column, of which the
# last is left out.
awk 'function patch(u0,   i, s) { s = ""
	for (i = 0; i < 16; i++) s = s (i == 0 ? u0 : i == 1 ? 1 : 0) ","
	for (i = 0; i < 16; i++) s = s (i == 4 ? 1 : 0) ","
	for (i = 0; i < 16; i++) s = s (i == 4 ? u0 / 20 : i == 5 ? 1 / 20 : 0) ","
	return s }
	BEGIN { for (i = 0; i < 48; i++) none = none "0,"
	text = "3,1,2,1,0,5,10,0,10," patch(0) none patch(5)
	print "face 114 0 " substr(text, 1, length(text) - 1) }' | iges spline
# the integral of sqrt(1 + (x^2 + y^2) / 400) by Simpson's rule
model "114: a saddle of two patches" "$(awk 'BEGIN { n = 200; h = 10 / n
	for (i = 0; i <= n; i++) for (k = 0; k <= n; k++) { a = i == 0 || i == n ? 1 : i % 2 ? 4 : 2
		b = k == 0 || k == n ? 1 : k % 2 ? 4 : 2; s += a * b * sqrt(1 + (i * i + k * k) * h * h / 400) }
	printf "%.9f\n", s * h * h / 9 }')" - -e 0.001 "$TMP/spline.igs"

iges plane <<'END'
plane 108 0 0,0,2,10,0,0,0,5,1
outer 106 63 1,5,5,0,0,10,0,10,10,0,10,0,0
hole 100 0 5,5,5,7,5,7,5
out 142 0 0,{plane},0,{outer},2
in 142 0 0,{plane},0,{hole},2
face 144 0 {plane},1,1,{out},{in}
END
model "108: a square with a round hole" "$(calc '100 - 4 * p')" - -e 0.001 "$TMP/plane.igs"

# ---- IGES: solids

cylinder_solid() {
	cylinder_shell
	echo 'solid 186 0 {shell},1,0'
}
cylinder_solid | iges solid
model "186: a cylinder" "$(calc '2 * p * 10 * 40')" "$(calc 'p * 100 * 30')" -e 0.003 "$TMP/solid.igs"
cylinder_solid | iges inches -v unit=1
model "in inches" "$(calc '2 * p * 10 * 40 * 25.4 * 25.4')" "$(calc 'p * 100 * 30 * 25.4 ^ 3')" -e 0.06 "$TMP/inches.igs"

iges cone <<'END'
origin 116 0 0,0,0,0
z 123 0 0,0,1
c0 100 0 0,0,0,10,0,10,0
c1 100 0 8,0,0,4,0,4,0
seam 110 0 10,0,0,4,0,8
vertices 502 1 2,10,0,0,4,0,8
edges 504 1 3,{c0},{vertices},1,{vertices},1,{c1},{vertices},2,{vertices},2,{seam},{vertices},1,{vertices},2
side 194 0 {origin},{z},10,-36.86989764584402
top 116 0 0,0,8,0
floor 190 0 {origin},{z}
lid 190 0 {top},{z}
l1 508 1 4,0,{edges},1,1,0,0,{edges},3,1,0,0,{edges},2,0,0,0,{edges},3,0,0
l2 508 1 1,0,{edges},1,0,0
l3 508 1 1,0,{edges},2,1,0
f1 510 1 {side},1,1,{l1}
f2 510 1 {floor},1,1,{l2}
f3 510 1 {lid},1,1,{l3}
shell 514 1 3,{f1},1,{f2},0,{f3},1
solid 186 0 {shell},1,0
END
model "186: a cone cut off" "$(calc 'p * (14 * 10 + 100 + 16)')" "$(calc 'p * 8 / 3 * (100 + 40 + 16)')" -e 0.002 "$TMP/cone.igs"

# ---- STEP

# side SURFACE: a solid of revolution between a circle of radius A at z 0 and one of B at z H, with a
# seam between them
turned() { # SURFACE A B H
	cat <<END
va VERTEX_POINT('',{p $2 0 0})
vb VERTEX_POINT('',{p $3 0 $4})
ca CIRCLE('',{a 0,0,0 0,0,1 1,0,0},$2)
cb CIRCLE('',{a 0,0,$4 0,0,1 1,0,0},$3)
li LINE('',{p $2 0 0},{ve})
ve VECTOR('',{d $(($3 - $2)) 0 $4},1.)
ea EDGE_CURVE('',{va},{va},{ca},.T.)
eb EDGE_CURVE('',{vb},{vb},{cb},.T.)
es EDGE_CURVE('',{va},{vb},{li},.T.)
oa ORIENTED_EDGE('',*,*,{ea},.T.)
os ORIENTED_EDGE('',*,*,{es},.T.)
ob ORIENTED_EDGE('',*,*,{eb},.F.)
ot ORIENTED_EDGE('',*,*,{es},.F.)
oc ORIENTED_EDGE('',*,*,{ea},.F.)
od ORIENTED_EDGE('',*,*,{eb},.T.)
l1 EDGE_LOOP('',({oa},{os},{ob},{ot}))
l2 EDGE_LOOP('',({oc}))
l3 EDGE_LOOP('',({od}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
b2 FACE_OUTER_BOUND('',{l2},.T.)
b3 FACE_OUTER_BOUND('',{l3},.T.)
s1 $1
s2 PLANE('',{a 0,0,0 0,0,1 1,0,0})
s3 PLANE('',{a 0,0,$4 0,0,1 1,0,0})
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
f2 ADVANCED_FACE('',({b2}),{s2},.F.)
f3 ADVANCED_FACE('',({b3}),{s3},.T.)
shell CLOSED_SHELL('',({f1},{f2},{f3}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END
}
turned "CYLINDRICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)" 10 10 30 | step solid
model "STEP: a cylinder" "$(calc '2 * p * 10 * 40')" "$(calc 'p * 100 * 30')" -e 0.003 "$TMP/solid.step"
turned "CYLINDRICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)" 10 10 30 | step inches -v unit=INCH
model "STEP: in inches" "$(calc '2 * p * 10 * 40 * 25.4 * 25.4')" "$(calc 'p * 100 * 30 * 25.4 ^ 3')" -e 0.06 "$TMP/inches.step"
turned "CONICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.,-0.64350110879328438680)" 10 4 8 | step cone
model "STEP: a cone cut off" "$(calc 'p * (14 * 10 + 100 + 16)')" "$(calc 'p * 8 / 3 * (100 + 40 + 16)')" -e 0.002 "$TMP/cone.step"
turned "SURFACE_OF_REVOLUTION('',{li},{ax})
ax AXIS1_PLACEMENT('',{p 0 0 0},{d 0 0 1})" 10 4 8 | step revolved
model "STEP: the same by revolution" "$(calc 'p * (14 * 10 + 100 + 16)')" "$(calc 'p * 8 / 3 * (100 + 40 + 16)')" -e 0.002 "$TMP/revolved.step"
turned "SURFACE_OF_LINEAR_EXTRUSION('',{ca},{vz})
vz VECTOR('',{d 0 0 1},1.)" 10 10 30 | step extruded
model "STEP: a cylinder by extrusion" "$(calc '2 * p * 10 * 40')" "$(calc 'p * 100 * 30')" -e 0.003 "$TMP/extruded.step"

# whole: one face, bounded by a vertex or by its seams
whole() { # SURFACE BOUNDS
	echo "s1 $1"
	echo "f1 ADVANCED_FACE('',($2),{s1},.T.)"
	echo "shell CLOSED_SHELL('',({f1}))"
	echo "SOLID MANIFOLD_SOLID_BREP('',{shell})"
}
{
	whole "SPHERICAL_SURFACE('',{a 1,2,3 0,0,1 1,0,0},10.)" "{b1}"
	echo "b1 FACE_BOUND('',{l1},.T.)"
	echo "l1 VERTEX_LOOP('',{v 1 2 -7})"
} | step sphere
model "STEP: a sphere" "$(calc '4 * p * 100')" "$(calc '4 / 3 * p * 1000')" -e 0.0005 "$TMP/sphere.step"
{
	whole "TOROIDAL_SURFACE('',{a 1,2,3 0,0,1 1,0,0},20.,5.)" "{b1}"
	cat <<'END'
v1 VERTEX_POINT('',{p 26 2 3})
c1 CIRCLE('',{a 1,2,3 0,0,1 1,0,0},25.)
c2 CIRCLE('',{a 21,2,3 0,-1,0 1,0,0},5.)
e1 EDGE_CURVE('',{v1},{v1},{c1},.T.)
e2 EDGE_CURVE('',{v1},{v1},{c2},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
o2 ORIENTED_EDGE('',*,*,{e2},.T.)
o3 ORIENTED_EDGE('',*,*,{e1},.F.)
o4 ORIENTED_EDGE('',*,*,{e2},.F.)
l1 EDGE_LOOP('',({o1},{o2},{o3},{o4}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
END
} | step torus
model "STEP: a torus" "$(calc '4 * p * p * 100')" "$(calc '2 * p * p * 20 * 25')" -e 0.0005 "$TMP/torus.step"

# Half a ball and a cone with its apex: circles that go once round, poles.
cat <<'END' | step ball
v1 VERTEX_POINT('',{p 10 0 0})
c1 CIRCLE('',{a 0,0,0 0,0,1 1,0,0},10.)
e1 EDGE_CURVE('',{v1},{v1},{c1},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
o2 ORIENTED_EDGE('',*,*,{e1},.F.)
l1 EDGE_LOOP('',({o1}))
l2 EDGE_LOOP('',({o2}))
l3 VERTEX_LOOP('',{v 0 0 -20})
b1 FACE_OUTER_BOUND('',{l1},.T.)
b2 FACE_OUTER_BOUND('',{l2},.T.)
b3 FACE_BOUND('',{l3},.T.)
s1 SPHERICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)
s2 CONICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.,0.46364760900080611621)
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
f2 ADVANCED_FACE('',({b2},{b3}),{s2},.T.)
shell CLOSED_SHELL('',({f1},{f2}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END
model "STEP: half a ball on a cone" "$(calc '200 * p + p * 10 * sqrt(500)')" "$(calc 'p * 2000 / 3 + p * 2000 / 3')" -e 0.001 "$TMP/ball.step"

# A box 30 x 20 x 10 with a round hole of radius 4 through it.
box() {
	awk 'BEGIN {
		split("0 30 30 0 0 30 30 0", x); split("0 0 20 20 0 0 20 20", y); split("0 0 0 0 10 10 10 10", z)
		for (i = 1; i <= 8; i++) printf "v%d VERTEX_POINT(\047\047,{p %d %d %d})\n", i, x[i], y[i], z[i]
		n = split("1 2 2 3 3 4 4 1 5 6 6 7 7 8 8 5 1 5 2 6 3 7 4 8", e)
		for (i = 1; i < n; i += 2) { a = e[i]; b = e[i + 1]; k = (i + 1) / 2; key[a " " b] = k
			printf "g%d LINE(\047\047,{p %d %d %d},{h%d})\n", k, x[a], y[a], z[a], k
			printf "h%d VECTOR(\047\047,{d %d %d %d},1.)\n", k, x[b] - x[a], y[b] - y[a], z[b] - z[a]
			printf "e%d EDGE_CURVE(\047\047,{v%d},{v%d},{g%d},.T.)\n", k, a, b, k }
		split("1 4 3 2|5 6 7 8|1 2 6 5|2 3 7 6|3 4 8 7|4 1 5 8", f, "|")
		split("0,0,0 0,0,-1 1,0,0|0,0,10 0,0,1 1,0,0|0,0,0 0,-1,0 1,0,0|30,0,0 1,0,0 0,1,0|0,20,0 0,1,0 1,0,0|0,0,0 -1,0,0 0,1,0", s, "|")
		for (i = 1; i <= 6; i++) { split(f[i], c, " "); loop = ""
			for (k = 1; k <= 4; k++) { a = c[k]; b = c[k % 4 + 1]; on = (a " " b) in key
				printf "o%d%d ORIENTED_EDGE(\047\047,*,*,{e%d},.%s.)\n", i, k, on ? key[a " " b] : key[b " " a], on ? "T" : "F"
				loop = loop (k > 1 ? "," : "") "{o" i k "}" }
			printf "l%d EDGE_LOOP(\047\047,(%s))\nb%d FACE_OUTER_BOUND(\047\047,{l%d},.T.)\n", i, loop, i, i
			printf "s%d PLANE(\047\047,{a %s})\n", i, s[i]
			printf "f%d ADVANCED_FACE(\047\047,({b%d}%s),{s%d},.T.)\n", i, i, i < 3 ? ",{w" i "}" : "", i } }'
	cat <<'END'
vp VERTEX_POINT('',{p 19 10 0})
vq VERTEX_POINT('',{p 19 10 10})
cp CIRCLE('',{a 15,10,0 0,0,1 1,0,0},4.)
cq CIRCLE('',{a 15,10,10 0,0,1 1,0,0},4.)
ep EDGE_CURVE('',{vp},{vp},{cp},.T.)
eq EDGE_CURVE('',{vq},{vq},{cq},.T.)
op ORIENTED_EDGE('',*,*,{ep},.T.)
oq ORIENTED_EDGE('',*,*,{eq},.F.)
or ORIENTED_EDGE('',*,*,{ep},.F.)
ot ORIENTED_EDGE('',*,*,{eq},.T.)
lp EDGE_LOOP('',({op}))
lq EDGE_LOOP('',({oq}))
lr EDGE_LOOP('',({or}))
lt EDGE_LOOP('',({ot}))
w1 FACE_BOUND('',{lp},.T.)
w2 FACE_BOUND('',{lq},.T.)
w3 FACE_BOUND('',{lr},.T.)
w4 FACE_BOUND('',{lt},.T.)
s7 CYLINDRICAL_SURFACE('',{a 15,10,0 0,0,1 1,0,0},4.)
f7 ADVANCED_FACE('',({w3},{w4}),{s7},.F.)
shell CLOSED_SHELL('',({f1},{f2},{f3},{f4},{f5},{f6},{f7}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END
}
box | step box
box_area=$(calc '2 * (600 - 16 * p) + 2 * 10 * 50 + 2 * p * 4 * 10')
box_volume=$(calc '6000 - 160 * p')
model "STEP: a box with a hole" "$box_area" "$box_volume" -e 0.003 "$TMP/box.step"

nurbs2mesh -v -e 0.003 "$TMP/box.step" 2>"$TMP/report" >/dev/null
has "the hole is a handle, and the body closed" 'body 1: closed, genus 1, area 2350\.796[0-9]* mm2, volume 5497\.345' "$TMP/report"
hasnt "nothing is open" '^nurbs2mesh: open: ' "$TMP/report"
grep -v '^l5 \|^b5 \|^s5 \|^f5 ' <<END | { cat; echo "REP ADVANCED_BREP_SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})"; } |
$(box | sed 's/,{f5}//')
END
	awk -f "$SRC/tests/lib/step.awk" >"$TMP/lidless.step"
nurbs2mesh -v -e 0.003 "$TMP/lidless.step" 2>"$TMP/report" >/dev/null
has "a side taken out is a loop" 'open: [0-9]* edges, 80\.0000 mm long' "$TMP/report"

two_places() { # the box, and where an assembly has it twice
	box
	cat <<'END'
A SHAPE_REPRESENTATION('',({a1},{a2}),{CONTEXT})
P SHAPE_REPRESENTATION('',({a0}),{CONTEXT})
a0 AXIS2_PLACEMENT_3D('',{p 0 0 0},{d 0 0 1},{d 1 0 0})
a1 AXIS2_PLACEMENT_3D('',{p 100 0 0},{d 0 1 0},{d 1 0 0})
a2 AXIS2_PLACEMENT_3D('',{p -100 5 5},{d 0 0 1},{d 0 1 0})
same SHAPE_REPRESENTATION_RELATIONSHIP('','',{P},{REP})
END
}

# The same twice in an assembly, one turned and moved; the sum is twice the box.
{
	two_places
	cat <<'END'
r1 (REPRESENTATION_RELATIONSHIP('','',{P},{A})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({t1})SHAPE_REPRESENTATION_RELATIONSHIP())
r2 (REPRESENTATION_RELATIONSHIP('','',{P},{A})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({t2})SHAPE_REPRESENTATION_RELATIONSHIP())
t1 ITEM_DEFINED_TRANSFORMATION('','',{a0},{a1})
t2 ITEM_DEFINED_TRANSFORMATION('','',{a0},{a2})
END
} | step assembly
model "STEP: an assembly of two" "$(calc "2 * $box_area")" "$(calc "2 * $box_volume")" -e 0.003 "$TMP/assembly.step"
ok "placed where it says" test "$(awk '/end_header/ { on = 1; next } on && NF == 7 { if ($1 > m) m = $1; if ($1 < l) l = $1 }
	END { printf "%.3f %.3f", l, m }' "$TMP/model.ply")" = "-120.000 130.000"

# The same with its product structure, by which the whole is told from its parts: as systems write
# it, with the whole first in each relation, with the axes of each other, and with the part's solid
# once more in a representation of its own, which a volume belongs to.
structure() { # FIRST SECOND AXES-OF-FIRST AXES-OF-SECOND
	same=SHAPE_REPRESENTATION_RELATIONSHIP
	with=REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION
	two_places
	cat <<END
r1 (REPRESENTATION_RELATIONSHIP('','',{$1},{$2})${with}({t1})$same())
r2 (REPRESENTATION_RELATIONSHIP('','',{$1},{$2})${with}({t2})$same())
t1 ITEM_DEFINED_TRANSFORMATION('','',{$(echo "$3" | sed s/k/1/)},{$(echo "$4" | sed s/k/1/)})
t2 ITEM_DEFINED_TRANSFORMATION('','',{$(echo "$3" | sed s/k/2/)},{$(echo "$4" | sed s/k/2/)})
part PRODUCT_DEFINITION('','',$,$)
all PRODUCT_DEFINITION('','',$,$)
partshape PRODUCT_DEFINITION_SHAPE('','',{part})
allshape PRODUCT_DEFINITION_SHAPE('','',{all})
d1 SHAPE_DEFINITION_REPRESENTATION({partshape},{P})
d2 SHAPE_DEFINITION_REPRESENTATION({allshape},{A})
u1 NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','','',{all},{part},$)
u2 NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','','',{all},{part},$)
useshape1 PRODUCT_DEFINITION_SHAPE('','',{u1})
useshape2 PRODUCT_DEFINITION_SHAPE('','',{u2})
c1 CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({r1},{useshape1})
c2 CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({r2},{useshape2})
about PROPERTY_DEFINITION('','solid that a volume belongs to',{partshape})
its SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})
d3 SHAPE_DEFINITION_REPRESENTATION({about},{its})
END
}
placed() { # DESC
	model "STEP: $1" "$(calc "2 * $box_area")" "$(calc "2 * $box_volume")" \
		-e 0.003 "$TMP/structure.step"
	ok "$1: placed where it says" test "$(awk '/end_header/ { on = 1; next }
		on && NF == 7 { if ($1 > m) m = $1; if ($1 < l) l = $1 }
		END { printf "%.3f %.3f", l, m }' "$TMP/model.ply")" = "-120.000 130.000"
}
structure P A a0 ak | step structure
placed "an assembly by its products"
structure A P ak a0 | step structure
placed "the whole first in each relation"
structure P A ak a0 | step structure
placed "with the axes of each other"

# A rational B-spline face (a quarter of a cylinder) as a shell, its edges splines too.
cat <<'END' | step shell
c1 (BOUNDED_CURVE()B_SPLINE_CURVE(2,({q1},{q2},{q3}),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.70710678118654757,1.))REPRESENTATION_ITEM(''))
c3 (BOUNDED_CURVE()B_SPLINE_CURVE(2,({q4},{q5},{q6}),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.70710678118654757,1.))REPRESENTATION_ITEM(''))
q1 CARTESIAN_POINT('',(10.,0.,0.))
q2 CARTESIAN_POINT('',(10.,10.,0.))
q3 CARTESIAN_POINT('',(0.,10.,0.))
q4 CARTESIAN_POINT('',(10.,0.,15.))
q5 CARTESIAN_POINT('',(10.,10.,15.))
q6 CARTESIAN_POINT('',(0.,10.,15.))
c2 B_SPLINE_CURVE_WITH_KNOTS('',1,({q3},{q6}),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.)
c4 LINE('',{q1},{up})
up VECTOR('',{d 0 0 1},1.)
k1 VERTEX_POINT('',{q1})
k2 VERTEX_POINT('',{q3})
k3 VERTEX_POINT('',{q6})
k4 VERTEX_POINT('',{q4})
e1 EDGE_CURVE('',{k1},{k2},{c1},.T.)
e2 EDGE_CURVE('',{k2},{k3},{c2},.T.)
e3 EDGE_CURVE('',{k4},{k3},{c3},.T.)
e4 EDGE_CURVE('',{k1},{k4},{c4},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
o2 ORIENTED_EDGE('',*,*,{e2},.T.)
o3 ORIENTED_EDGE('',*,*,{e3},.F.)
o4 ORIENTED_EDGE('',*,*,{e4},.F.)
l1 EDGE_LOOP('',({o1},{o2},{o3},{o4}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
s1 (BOUNDED_SURFACE()B_SPLINE_SURFACE(2,1,(({q1},{q4}),({q2},{q5}),({q3},{q6})),.UNSPECIFIED.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,1.),(0.70710678118654757,0.70710678118654757),(1.,1.)))REPRESENTATION_ITEM('')SURFACE())
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
open OPEN_SHELL('',({f1}))
SOLID SHELL_BASED_SURFACE_MODEL('',({open}))
END
model "STEP: a rational B-spline face" "$(calc 'p / 2 * 10 * 15')" - -e 0.004 "$TMP/shell.step"

# The same model as IGES and as STEP: no vertex of one mesh is farther than the tolerance from the other's
# surface (here: a cylinder of radius 10 and height 30).
for kind in igs step; do
	nurbs2mesh -e 0.01 "$TMP/solid.$kind" 2>/dev/null | awk '/end_header/ { on = 1; next } on && NF == 7 {
		r = sqrt($1 * $1 + $2 * $2); d = r - 10; e = $3 * ($3 - 30)
		if (!(d * d < 1e-11 || (r < 10 && e * e < 1e-9))) far++ } END { print far + 0 }' >"$TMP/far"
	ok "$kind: every vertex is on the cylinder" test "$(cat "$TMP/far")" -eq 0
	nurbs2mesh -e 0.01 "$TMP/cone.$kind" 2>/dev/null | awk '/end_header/ { on = 1; next } on && NF == 7 {
		r = sqrt($1 * $1 + $2 * $2); d = r - (10 - 0.75 * $3); e = $3 * ($3 - 8)
		if (!(d * d < 1e-11 || (d < 0 && e * e < 1e-9))) far++ } END { print far + 0 }' >"$TMP/far"
	ok "$kind: every vertex is on the cone cut off" test "$(cat "$TMP/far")" -eq 0
done

# ---- broken STEP: one line with the line of the file

bad_step() { # DESC WORDS SED: the box, edited
	sed "$3" "$TMP/box.step" >"$TMP/bad.step"
	status 1 "$1" nurbs2mesh -n 2 "$TMP/bad.step"
	has "$1: says why" "bad.step:[0-9]*: .*$2" "$TMP/err"
	ok "$1: in one line" test "$(wc -l <"$TMP/err")" -eq 1
}
bad_step "cut short" "cut short" '60,$d'
bad_step "a number that is none" "expected a number" 's/,4\.)/,4.4.4)/'
bad_step "a list without its end" "expected" 's/))/)/'
bad_step "a text without its end" "cut short" "40s/'/x/"
bad_step "an instance twice" "a second time" '30s/.*/#1=PLANE();/'
bad_step "a reference to nothing" "expected an instance that there is" 's/ORIENTED_EDGE(\(.*\)#[0-9]*,/ORIENTED_EDGE(\1#99999,/'
bad_step "a point instead of a plane's axes" "no axis placement" 's/PLANE(.*,#[0-9]*)/PLANE(0,#1)/;1,/^#2=/s/^#1=.*/#1=CARTESIAN_POINT(0,(0,0,0));/'
bad_step "a radius of nothing" "radius" 's/\(CIRCLE.*\),4\.)/\1,0.)/'
bad_step "a number beyond all bounds" "too large" 's/CARTESIAN_POINT(\(.*\)(30,/CARTESIAN_POINT(\1(1e300,/'
bad_step "an instance without a name" "the name of an entity" '25s/=[A-Z_0-9]*/=/'
bad_step "an instance number of nothing" "number of an instance" '25s/#[0-9]*=/#=/'
bad_step "no sections" "cut short" '2,$d'

# An assembly whose part is part of itself, and one that doubles at every level.
{
	box
	echo "t0 ITEM_DEFINED_TRANSFORMATION('','',{a0},{a0})"
	echo "a0 AXIS2_PLACEMENT_3D('',{p 0 0 0},{d 0 0 1},{d 1 0 0})"
	for k in 1 2 3 4 5 6 7 8 9; do for twice in a b; do
		echo "r$k$twice (REPRESENTATION_RELATIONSHIP('','',{R$((k + 1))},{R$k})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({t0})SHAPE_REPRESENTATION_RELATIONSHIP())"
	done; done
	echo "r10 (REPRESENTATION_RELATIONSHIP('','',{R10},{R10})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({t0})SHAPE_REPRESENTATION_RELATIONSHIP())"
	for k in 1 2 3 4 5 6 7 8 9 10; do echo "R$k SHAPE_REPRESENTATION('',({a0}),{CONTEXT})"; done
} | step endless
status 1 "an assembly that is part of itself" nurbs2mesh "$TMP/endless.step"
has "is named" "parts within parts without end" "$TMP/err"

# ---- what is left out

iges block <<'END'
a 110 0 0,0,0,10,0,0
b 110 0 0,8,0,10,8,0
face 118 1 {a},{b},0,0
box 150 0 10,10,10,0,0,0,1,0,0,0,0,1
END
status 3 "a block of a constructive solid is left out" nurbs2mesh "$TMP/block.igs"
has "named with its count" "1 surface of type 150 left out, the first is entity 7" "$TMP/err"
has "and the mesh says so" "^comment unmet nurbs2mesh part of the model is left out" "$TMP/out"
model "--partial goes on" 80 - --partial -e 0.01 "$TMP/block.igs"

# ---- trims that are not on their surface, or cross themselves

# A disc of radius 10 in the plane z = 0, its edge OFF above it, beside a square with the corners given.
disc_and_square() { # OFF X1,Y1 X2,Y2 X3,Y3 X4,Y4
	cat <<END
v1 VERTEX_POINT('',{p 10 0 $1})
c1 CIRCLE('',{a 0,0,$1 0,0,1 1,0,0},10.)
e1 EDGE_CURVE('',{v1},{v1},{c1},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
l1 EDGE_LOOP('',({o1}))
q1 CARTESIAN_POINT('',($2,0.))
q2 CARTESIAN_POINT('',($3,0.))
q3 CARTESIAN_POINT('',($4,0.))
q4 CARTESIAN_POINT('',($5,0.))
l2 POLY_LOOP('',({q1},{q2},{q3},{q4}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
b2 FACE_OUTER_BOUND('',{l2},.T.)
s1 PLANE('',{a 0,0,0 0,0,1 1,0,0})
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
f2 ADVANCED_FACE('',({b2}),{s1},.T.)
shell OPEN_SHELL('',({f1},{f2}))
SOLID SHELL_BASED_SURFACE_MODEL('',({shell}))
END
}
disc_and_square 0.02 20.,0. 30.,0. 30.,10. 20.,10. | step near
model "a trim 0.02 off its surface, put onto it" "$(calc '100 * p + 100')" - -n 200 --gap 0.05 "$TMP/near.step"
nurbs2mesh -v --gap 0.05 "$TMP/near.step" >/dev/null 2>"$TMP/err"
has "and told" "lie up to 0.02 mm off it and were put" "$TMP/err"
status 1 "too far for a finer tolerance" nurbs2mesh -e 0.01 "$TMP/near.step"
has "the face is named" "near.step: surface [0-9]*: its trimming curves in space lie up to 0.02 mm off it" "$TMP/err"
empty "and nothing is written" "$TMP/out"
status 0 "--partial leaves it out" nurbs2mesh --partial -e 0.01 "$TMP/near.step"
cp "$TMP/out" "$TMP/partial.ply"
below "the square is left" "$(measure "$TMP/partial.ply" | awk '{ print ($1 - 100) ^ 2 }')" 1e-12
disc_and_square 0 20.,0. 30.,10. 30.,0. 20.,10. | step bow
status 1 "a loop that crosses itself" nurbs2mesh -e 0.01 "$TMP/bow.step"
has "the face is named" "bow.step: surface [0-9]*: its trimming crosses itself" "$TMP/err"
status 0 "--partial leaves it out" nurbs2mesh --partial -e 0.01 "$TMP/bow.step"

# ---- headers

quarter='axis 110 0 0,0,-5,0,0,9
line 110 0 10,0,0,10,0,20
face 120 0 {axis},{line},0.,1.5707963267948966'
header() { # DESC WORDS GLOBAL
	echo "$quarter" | iges header -v global="$3"
	status 1 "$1" nurbs2mesh "$TMP/header.igs"
	has "$1: where and what" "header.igs:[0-9]*: .*$2" "$TMP/err"
}
tail=',1.,2,2HMM,1,0.01,13H261121.101010,1E-6,0.,,,11,0;'
header "a count one too small" "after a text" "1H,,1H;,4Hmodel,5Hmodel,4Htest,1H1,32,38,6,308,15,5Hmodel$tail"
header "a count that swallows a comma" "parameter 6 of the global section" \
	"1H,,1H;,13Hmodel,5Hmodel,4Htest,1H1,32,38,6,308,15,5Hmodel$tail"
header "a field missing" "parameter 11 of the global section" \
	"1H,,1H;,5Hmodel,5Hmodel,4Htest,1H1,32,38,6,308,5Hmodel$tail"
echo "$quarter" | iges small
nurbs2mesh -u um -n 4 "$TMP/small.igs" >"$TMP/out" 2>"$TMP/err"
has "a part of a fiftieth of a mm" 'the part is 0\.0[0-9]* mm long, expected 1 to 3000: is the unit right' "$TMP/err"

done_testing

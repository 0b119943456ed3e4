#!/bin/sh
# nurbs2mesh-entities.t - every kind of curve and surface that IGES and STEP files have, in models whose
# areas and volumes are known.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# ---- IGES: curves and surfaces of other kinds

bounded() { # NAME CURVES: a plane bounded by these curves of those from standard input
	name=$1
	{
		cat
		echo "plane 108 0 0,0,2,10,0,0,0,5,1"
		echo "outer 102 0 $2"
		echo "out 142 0 0,{plane},0,{outer},2"
		echo "face 144 0 {plane},1,0,{out}"
	} | iges "$name"
}
# (x - 1)^2 / 9 + y^2 / 4 = 1 turned by 30 degrees: the conic's six numbers
awk 'BEGIN { c = cos(atan2(0, -1) / 6); s = 0.5; a = 9; b = 4
	A = c * c / a + s * s / b; B = 2 * c * s * (1 / a - 1 / b); C = s * s / a + c * c / b
	D = -2 * A; E = -B; F = A - 1
	printf "a 104 1 %.17g,%.17g,%.17g,%.17g,%.17g,%.17g,5,%.17g,%.17g,%.17g,%.17g\n", A, B, C, D, E, F,
		1 + 3 * c, 3 * s, 1 + 3 * c, 3 * s }' | bounded ellipse "1,{a}"
model "104: an ellipse that is turned" "$(calc 'p * 6')" - -e 0.0002 "$TMP/ellipse.igs"
bounded parabola "2,{a},{b}" <<'END'
a 104 3 0,0,1,-4,0,0,5,4,-4,4,4
b 110 0 4,4,5,4,-4,5
END
model "104: a parabola" "$(calc '2 / 3 * 4 * 8')" - -e 0.0002 "$TMP/parabola.igs"
bounded hyperbola "2,{a},{b}" <<'END'
a 104 2 0.25,0,-1,0,0,-1,5,4,-1.7320508075688772,4,1.7320508075688772
b 110 0 4,1.7320508075688772,5,4,-1.7320508075688772,5
END
model "104: a hyperbola" "$(calc '4 * sqrt(3) - 2 * log(2 + sqrt(3))')" - -e 0.0001 "$TMP/hyperbola.igs"
iges spline112 <<'END'
c 112 0 3,1,2,2,0,4,10,0,1,0,0,0,0,0.1,0,0,0,0,0,4,1,0,0,1.6,0.8,0.1,0,0,0,0,0,10,1,0,0,10,2,0.2,0,0,0,0,0
face 122 0 {c},0,0,5
END
model "112: a parabola of two pieces moved along" "$(calc '5 * (5 * sqrt(5) + 2.5 * log(2 + sqrt(5)))')" - -e 0.0005 "$TMP/spline112.igs"
iges offset130 <<'END'
c 100 0 0,0,0,10,0,0,10
o 130 0 {c},1,0,0,1,2,0,0,0,0,0,1,0,1.5707963267948966
face 122 0 {o},8,0,15
END
model "130: a quarter circle moved inwards" "$(calc 'p / 2 * 8 * 15')" - -e 0.001 "$TMP/offset130.igs"
iges offset140 <<'END'
axis 110 0 0,0,-5,0,0,9
line 110 0 10,0,0,10,0,20
base 120 0 {axis},{line},0.,1.5707963267948966
face 140 0 1,0,0,2,{base}
END
model "140: a quarter of a cylinder moved outwards" "$(calc 'p / 2 * 12 * 20')" - -e 0.001 "$TMP/offset140.igs"

# Ruled surfaces: a line joins places at the same part of the file's parameters (form 1) or of the lengths
# (form 0) of two curves.  Every point of a grid against expressions of u and v, p being pi.
ruled() { # DESC X Y Z: of $TMP/ruled.igs
	nurbs2mesh --grid 21 "$TMP/ruled.igs" >"$TMP/grid"
	below "118: $1" "$(awk -F, 'BEGIN { p = atan2(0, -1); worst = -1 } NR == 1 { next }
		{ u = $2; v = $3; d = sqrt(($4 - ('"$2"')) ^ 2 + ($5 - ('"$3"')) ^ 2 + ($6 - ('"$4"')) ^ 2)
			if (d > worst) worst = d; n++ }
		END { print (n == 441 ? worst : 1) }' "$TMP/grid")" 2e-8
}
iges ruled <<'END'
a 100 0 0,0,0,10,0,0,10
b 110 0 10,0,10,0,10,10
face 118 1 {a},{b},0,0
END
ruled "between an arc and a line" '(1 - v) * 10 * cos(u * p / 2) + v * 10 * (1 - u)' \
	'(1 - v) * 10 * sin(u * p / 2) + v * 10 * u' '10 * v'
# the integral of |Su x Sv|
model "118: between an arc and a line" "$(awk 'BEGIN { p = atan2(0, -1); n = 200
	for (i = 0; i <= n; i++) for (k = 0; k <= n; k++) { u = i / n; v = k / n; c = cos(u * p / 2); s = sin(u * p / 2)
		w = (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * (k == 0 || k == n ? 1 : k % 2 ? 4 : 2)
		ux = -(1 - v) * 5 * p * s - 10 * v; uy = (1 - v) * 5 * p * c + 10 * v; vx = 10 * (1 - u - c); vy = 10 * (u - s)
		a += w * sqrt((uy * 10) ^ 2 + (ux * 10) ^ 2 + (ux * vy - uy * vx) ^ 2) }
	printf "%.9f", a / n / n / 9 }')" - -e 0.001 "$TMP/ruled.igs"
iges ruled <<'END'
a 100 0 0,0,0,10,0,0,10
b 110 0 10,0,10,0,10,10
face 118 1 {a},{b},1,0
END
ruled "the line backwards" '(1 - v) * 10 * cos(u * p / 2) + v * 10 * u' \
	'(1 - v) * 10 * sin(u * p / 2) + v * 10 * (1 - u)' '10 * v'
iges ruled <<'END'
a 100 0 0,0,0,10,0,0,10
b 100 0 6,0,0,20,0,0,-20
face 118 0 {a},{b},0,0
END
ruled "between arcs of one and three quarters" '(1 - v) * 10 * cos(u * p / 2) + v * 20 * cos(u * 3 * p / 2)' \
	'(1 - v) * 10 * sin(u * p / 2) + v * 20 * sin(u * 3 * p / 2)' '6 * v'
uneven() { # FORM
	iges ruled <<END
a 126 0 2,2,0,0,1,0,0,0,0,1,1,1,1,1,1,0,0,0,1,0,0,10,0,0,0,1,0,0,1
b 110 0 0,0,7,10,0,7
face 118 $1 {a},{b},0,0
END
}
uneven 0
ruled "by length, a curve of uneven speed" '10 * u' 0 '7 * v'
uneven 1
ruled "by parameter, a curve of uneven speed" '(1 - v) * (2 * u * (1 - u) + 10 * u * u) + v * 10 * u' 0 '7 * v'
# y = x^2, of which the length up to x is (2 x w + log(2 x + w)) / 4 with w = sqrt(1 + 4 x^2)
iges ruled <<'END'
a 110 0 0,0,5,1,0,5
b 126 0 2,2,0,0,1,0,0,0,0,1,1,1,1,1,1,0,0,0,0.5,0,0,1,1,0,0,1,0,0,1
face 118 0 {b},{a},0,0
END
nurbs2mesh --grid 21 "$TMP/ruled.igs" >"$TMP/grid"
below "118: by length, a parabola" "$(awk -F, '
	function s(x,   w) { w = sqrt(1 + 4 * x * x); return (2 * x * w + log(2 * x + w)) / 4 }
	NR > 1 && $3 == 0 { d = s($4) / s(1) - $2; d = d < 0 ? -d : d; if (d > m) m = d; n++ }
	END { print (n == 21 ? m : 1) }' "$TMP/grid")" 1e-8
# A line of 10 and a quarter of a circle are 1 and pi/2 of the parameters of both.
iges ruled <<'END'
l 110 0 10,-10,0,10,0,0
q 100 0 0,0,0,10,0,0,10
a 102 0 2,{l},{q}
b 110 0 30,-10,0,30,20,0
face 118 1 {a},{b},0,0
END
k='(u * (1 + p / 2) - 1)'
ruled "a line and an arc in one" "(1 - v) * ($k < 0 ? 10 : 10 * cos($k)) + 30 * v" \
	"(1 - v) * ($k < 0 ? 10 * $k : 10 * sin($k)) + v * (30 * u - 10)" 0
# Trimmed in its parameters.
iges ruled <<'END'
g1 100 0 0,0,0,10,0,0,10
g2 110 0 10,0,10,0,10,10
s 118 1 {g1},{g2},0,0
a 110 0 0.25,0.2,0,0.75,0.2,0
b 110 0 0.75,0.2,0,0.75,0.7,0
c 110 0 0.75,0.7,0,0.25,0.7,0
d 110 0 0.25,0.7,0,0.25,0.2,0
loop 102 0 4,{a},{b},{c},{d}
out 142 0 0,{s},{loop},0,1
face 144 0 {s},1,0,{out}
END
nurbs2mesh -e 0.001 "$TMP/ruled.igs" >"$TMP/model.ply"
least=$(calc '0.3 * 10 * cos(3 * p / 8) + 0.7 * 2.5' | cut -c 1-5) most=$(calc '0.8 * 10 * cos(p / 8) + 0.2 * 7.5' | cut -c 1-5)
ok "118: trimmed in the parameters" test "$(vertex_box "$TMP/model.ply")" = "$least $least 2.000 $most $most 7.000"

# A flat patch from a parabola to a straight line: its border bends, the surface does not; trimmed by
# nothing, by that border in the parameters, and by it in space.
corners=0,0,0,5,-10,0,10,0,0,0,10,0,5,10,0,10,10,0
cat >"$TMP/rim" <<END
s 128 0 2,1,2,1,0,0,1,0,0,0,0,0,1,1,1,0,0,1,1,1,1,1,1,1,1,$corners,0,1,0,1
l 106 11 1,5,0,0,0,1,0,1,1,0,1,0,0
p 126 0 2,2,0,0,1,0,0,0,0,1,1,1,1,1,1,0,0,0,5,-10,0,10,0,0,0,1,0,0,1
q 106 12 2,4,10,0,0,10,10,0,0,10,0,0,0,0
c 102 0 2,{p},{q}
o 142 0 0,{s},{l},{c},1
f 144 0 {s},1,0,{o}
END
sed 1q "$TMP/rim" | iges rim-none
iges rim-parameters <"$TMP/rim"
sed 's/{c},1/{c},2/' "$TMP/rim" | iges rim-space
for rim in none parameters space; do
	model "128: flat within a border that bends, trimmed by it: $rim" "$(calc '400 / 3')" - \
		-e 0.0005 "$TMP/rim-$rim.igs"
done

# A quarter turn, placed by a matrix that mirrors: it is turned where it is drawn, then mirrored.
iges mirrored <<'END'
axis 110 0 0,0,-5,0,0,9
line 110 0 10,0,0,10,0,20
face 120 0@mirror {axis},{line},0.,1.5707963267948966
mirror 124 1 -1,0,0,0,0,1,0,0,0,0,1,0
END
model "120: a quarter turn, mirrored" "$(calc 'p / 2 * 10 * 20')" - -e 0.0005 "$TMP/mirrored.igs"
ok "it is where the mirror shows it" test \
	"$(vertex_box "$TMP/model.ply")" = "-10.000 0.000 0.000 0.000 10.000 20.000"

# A ball whose profile comes to the axis within the last digit of the file, bounded by its seam twice
# and its equator: there is a pole, not a hole.
iges pole <<'END'
axis 110 0 0,0,0,0,0,1
curve 126 2 2,2,0,0,0,0,0,0,0,1,1,1,1,0.70710678118654757,1,0.000001,0,20,20,0,20,20,0,0,0,1,0,1,0
half 120 0 {axis},{curve},0.,6.2831853071795865
disc 108 0 0,0,1,0,0,0,0,0,1
up 126 2 2,2,0,0,0,0,0,0,0,1,1,1,1,0.70710678118654757,1,20,0,0,20,0,20,0.000001,0,20,0,1,0,1,0
rim 100 0 0,0,0,20,0,20,0
seam 102 0 3,{up},{curve},{rim}
edge 142 0 0,{half},0,{seam},2
face 144 0 {half},1,0,{edge}
floor 142 0 0,{disc},0,{rim},2
under 144 0 {disc},1,0,{floor}
END
model "120: half a ball to its pole" "$(calc '3 * p * 400')" "$(calc '2 / 3 * p * 8000')" \
	-e 0.001 "$TMP/pole.igs"

# Twice the same subfigure, one of them twice as large; the definition itself is no part of the model.
iges figures <<'END'
a 110 0 0,0,0,10,0,0
b 110 0 0,8,0,10,8,0
face 118 1 {a},{b},0,0
def 308 0 0,4Hpart,1,{face}
one 408 0 {def},0,0,0,1
two 408 0@turn {def},20,0,0,2
turn 124 0 0,-1,0,0,1,0,0,0,0,0,1,50
END
model "408: two instances" 400 - -e 0.01 "$TMP/figures.igs"
ok "placed where they say" test "$(awk '/end_header/ { on = 1; next } on && NF == 7 { if ($1 < l) l = $1; if ($2 > m) m = $2; if ($3 > h) h = $3 }
	END { printf "%.3f %.3f %.3f", l, m, h }' "$TMP/model.ply")" = "-16.000 40.000 50.000"

# The same cylinder three times: a solid that is turned, and two instances of it.
{
	cylinder_shell
	cat <<'END'
solid 186 0@lie {shell},1,0
lie 124 0 1,0,0,0,0,0,-1,0,0,1,0,50
i1 430 0 {solid}
i2 430 0@away {solid}
away 124 0 1,0,0,100,0,1,0,0,0,0,1,0
END
} | iges solids
model "430: two instances of a solid that has a place" "$(calc '4 * p * 10 * 40')" "$(calc '2 * p * 100 * 30')" -e 0.003 "$TMP/solids.igs"
ok "placed where they say" test "$(awk '/end_header/ { on = 1; next } on && NF == 7 { if ($1 > l) l = $1; if ($2 < m) m = $2; if ($3 > h) h = $3 }
	END { printf "%.3f %.3f %.3f", l, m, h }' "$TMP/model.ply")" = "110.000 -30.000 60.000"
nurbs2mesh -v -e 0.01 "$TMP/solids.igs" 2>"$TMP/report" >/dev/null
has "two bodies, closed" "body 2: closed, genus 0" "$TMP/report"

# ---- STEP: planes bounded by curves of all kinds

# part NAME: a plane z = 5 bounded by the edges {e1} {e2} of standard input
part_of() { # NAME EDGES
	name=$1
	{
		cat
		loop=
		for edge in $2; do
			echo "o$edge ORIENTED_EDGE('',*,*,{$edge},.T.)"
			loop="$loop,{o$edge}"
		done
		echo "loop EDGE_LOOP('',(${loop#,}))"
		echo "bound FACE_OUTER_BOUND('',{loop},.T.)"
		echo "plane PLANE('',{a 0,0,5 0,0,1 1,0,0})"
		echo "face ADVANCED_FACE('',({bound}),{plane},.T.)"
		echo "open OPEN_SHELL('',({face}))"
		echo "SOLID SHELL_BASED_SURFACE_MODEL('',({open}))"
	} | step "$name"
}
# A square whose loop runs into it and back along one edge, and beyond it, and one with a hole that
# touches its border: neither crosses itself.
part_of spur "e1 e2 e3 e4 f1 f2" <<'END'
p1 CARTESIAN_POINT('',(0.,0.,5.))
p2 CARTESIAN_POINT('',(10.,0.,5.))
p3 CARTESIAN_POINT('',(10.,10.,5.))
p4 CARTESIAN_POINT('',(0.,10.,5.))
p5 CARTESIAN_POINT('',(14.,6.,5.))
l1 POLYLINE('',({p1},{p2}))
l2 POLYLINE('',({p2},{p3}))
l3 POLYLINE('',({p3},{p4}))
l4 POLYLINE('',({p4},{p1}))
l5 POLYLINE('',({p1},{p5}))
v1 VERTEX_POINT('',{p1})
v2 VERTEX_POINT('',{p2})
v3 VERTEX_POINT('',{p3})
v4 VERTEX_POINT('',{p4})
v5 VERTEX_POINT('',{p5})
e1 EDGE_CURVE('',{v1},{v2},{l1},.T.)
e2 EDGE_CURVE('',{v2},{v3},{l2},.T.)
e3 EDGE_CURVE('',{v3},{v4},{l3},.T.)
e4 EDGE_CURVE('',{v4},{v1},{l4},.T.)
f1 EDGE_CURVE('',{v1},{v5},{l5},.T.)
f2 EDGE_CURVE('',{v5},{v1},{l5},.F.)
END
model "a loop with a spur" 100 - -e 0.01 "$TMP/spur.step"
part_of touch "e1 e2 k e3 e4 e5" <<'END'
p1 CARTESIAN_POINT('',(0.,0.,5.))
p2 CARTESIAN_POINT('',(10.,0.,5.))
p3 CARTESIAN_POINT('',(10.,10.,5.))
p4 CARTESIAN_POINT('',(0.,10.,5.))
p5 CARTESIAN_POINT('',(10.,5.,5.))
l1 POLYLINE('',({p1},{p2}))
l2 POLYLINE('',({p2},{p5}))
l3 POLYLINE('',({p5},{p3}))
l4 POLYLINE('',({p3},{p4}))
l5 POLYLINE('',({p4},{p1}))
c CIRCLE('',{a 7,5,5 0,0,1 1,0,0},3.)
v1 VERTEX_POINT('',{p1})
v2 VERTEX_POINT('',{p2})
v3 VERTEX_POINT('',{p3})
v4 VERTEX_POINT('',{p4})
v5 VERTEX_POINT('',{p5})
e1 EDGE_CURVE('',{v1},{v2},{l1},.T.)
e2 EDGE_CURVE('',{v2},{v5},{l2},.T.)
k EDGE_CURVE('',{v5},{v5},{c},.F.)
e3 EDGE_CURVE('',{v5},{v3},{l3},.T.)
e4 EDGE_CURVE('',{v3},{v4},{l4},.T.)
e5 EDGE_CURVE('',{v4},{v1},{l5},.T.)
END
model "a hole that touches the border" "$(calc '100 - 9 * p')" - -e 0.0005 "$TMP/touch.step"
part_of ellipse "e1" <<'END'
c ELLIPSE('',{a 1,2,5 0,0,1 0.6,0.8,0},3.,2.)
v VERTEX_POINT('',{p 2.8 4.4 5})
e1 EDGE_CURVE('',{v},{v},{c},.T.)
END
model "ELLIPSE" "$(calc '6 * p')" - -e 0.0002 "$TMP/ellipse.step"
part_of half "e1 e2" <<'END'
c ELLIPSE('',{a 1,2,5 0,0,1 1,0,0},3.,2.)
l LINE('',{p -2 2 5},{lv})
lv VECTOR('',{d 1 0 0},2.)
v VERTEX_POINT('',{p 4 2 5})
w VERTEX_POINT('',{p -2 2 5})
e1 EDGE_CURVE('',{v},{w},{c},.T.)
e2 EDGE_CURVE('',{w},{v},{l},.T.)
END
model "half an ELLIPSE" "$(calc '3 * p')" - -e 0.0002 "$TMP/half.step"
part_of parabola "e1 e2" <<'END'
c PARABOLA('',{a 0,0,5 0,0,1 1,0,0},1.)
l LINE('',{p 4 4 5},{lv})
lv VECTOR('',{d 0 -1 0},2.)
v VERTEX_POINT('',{p 4 -4 5})
w VERTEX_POINT('',{p 4 4 5})
e1 EDGE_CURVE('',{w},{v},{c},.F.)
e2 EDGE_CURVE('',{v},{w},{l},.F.)
END
model "PARABOLA, run backwards" "$(calc '2 / 3 * 4 * 8')" - -e 0.0002 "$TMP/parabola.step"
part_of hyperbola "e1 e2" <<'END'
c HYPERBOLA('',{a 0,0,5 0,0,1 1,0,0},2.,1.)
l LINE('',{p 4 1.7320508075688772 5},{lv})
lv VECTOR('',{d 0 -1 0},2.)
v VERTEX_POINT('',{p 4 -1.7320508075688772 5})
w VERTEX_POINT('',{p 4 1.7320508075688772 5})
e1 EDGE_CURVE('',{w},{v},{c},.F.)
e2 EDGE_CURVE('',{v},{w},{l},.F.)
END
model "HYPERBOLA" "$(calc '4 * sqrt(3) - 2 * log(2 + sqrt(3))')" - -e 0.0001 "$TMP/hyperbola.step"
part_of spline "e1 e2 e3" <<'END'
c BEZIER_CURVE('',2,({q1},{q2},{q3}),.UNSPECIFIED.,.F.,.F.)
u QUASI_UNIFORM_CURVE('',1,({q3},{q4},{q5}),.POLYLINE_FORM.,.F.,.F.)
w UNIFORM_CURVE('',1,({q5},{q1}),.POLYLINE_FORM.,.F.,.F.)
q1 CARTESIAN_POINT('',(0.,0.,5.))
q2 CARTESIAN_POINT('',(5.,-6.,5.))
q3 CARTESIAN_POINT('',(10.,0.,5.))
q4 CARTESIAN_POINT('',(10.,10.,5.))
q5 CARTESIAN_POINT('',(0.,10.,5.))
v1 VERTEX_POINT('',{q1})
v2 VERTEX_POINT('',{q3})
v3 VERTEX_POINT('',{q5})
e1 EDGE_CURVE('',{v1},{v2},{c},.T.)
e2 EDGE_CURVE('',{v2},{v3},{u},.T.)
e3 EDGE_CURVE('',{v3},{v1},{w},.T.)
END
model "BEZIER_CURVE, QUASI_UNIFORM_CURVE, UNIFORM_CURVE" 120 - -e 0.001 "$TMP/spline.step"
part_of composite "e1 e2" <<'END'
k CIRCLE('',{a 0,0,5 0,0,1 1,0,0},10.)
t TRIMMED_CURVE('',{k},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.5707963267948966)),.T.,.PARAMETER.)
l POLYLINE('',({p -10 10 5},{p 0 10 5}))
c COMPOSITE_CURVE('',({s1},{s2}),.F.)
s1 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{t})
s2 COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.F.,{l})
r TRIMMED_CURVE('',{g},(PARAMETER_VALUE(2.)),(PARAMETER_VALUE(0.)),.F.,.PARAMETER.)
b COMPOSITE_CURVE('',({s3},{s4}),.F.)
s3 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{m})
s4 COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.F.,{r})
m POLYLINE('',({p -10 10 5},{p -10 0 5}))
g LINE('',{p -10 0 5},{gv})
gv VECTOR('',{d 1 0 0},10.)
v VERTEX_POINT('',{p 10 0 5})
w VERTEX_POINT('',{p -10 10 5})
e1 EDGE_CURVE('',{v},{w},{c},.T.)
e2 EDGE_CURVE('',{w},{v},{b},.T.)
END
model "COMPOSITE_CURVE of TRIMMED_CURVEs and POLYLINEs" "$(calc '100 + 25 * p')" - -e 0.002 "$TMP/composite.step"
part_of pcurve "e1" <<'END'
c PCURVE('',{plane},{rep})
rep DEFINITIONAL_REPRESENTATION('',({k}),{CONTEXT})
k CIRCLE('',{ax},10.)
ax AXIS2_PLACEMENT_2D('',{o},{x})
o CARTESIAN_POINT('',(3.,4.))
x DIRECTION('',(1.,0.))
v VERTEX_POINT('',{p 13 4 5})
e1 EDGE_CURVE('',{v},{v},{c},.T.)
END
model "PCURVE as an edge" "$(calc '100 * p')" - -e 0.002 "$TMP/pcurve.step"

# ---- STEP: surfaces of other kinds

# free SURFACE: a surface in a set without faces
free() { # NAME
	name=$1
	{
		cat
		echo "SOLID GEOMETRIC_SET('',({s}))"
	} | step "$name"
}
free rectangle <<'END'
s RECTANGULAR_TRIMMED_SURFACE('',{b},0.5,2.,3.,18.,.T.,.T.)
b CYLINDRICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)
END
model "RECTANGULAR_TRIMMED_SURFACE of a cylinder" "$(calc '1.5 * 10 * 15')" - -e 0.001 "$TMP/rectangle.step"
free curves <<'END'
s CURVE_BOUNDED_SURFACE('',{b},({o},{i}),.F.)
b PLANE('',{a 0,0,5 0,0,1 1,0,0})
o OUTER_BOUNDARY_CURVE('',({s1}),.F.)
i BOUNDARY_CURVE('',({s2}),.F.)
s1 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{k})
s2 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{l})
k CIRCLE('',{a 0,0,5 0,0,1 1,0,0},10.)
l CIRCLE('',{a 1,0,5 0,0,1 1,0,0},3.)
END
model "CURVE_BOUNDED_SURFACE" "$(calc '91 * p')" - -e 0.001 "$TMP/curves.step"
free bezier <<'END'
s (BEZIER_SURFACE()BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,(({p 0 0 0},{p 0 8 0}),({p 10 0 0},{p 10 8 0})),.UNSPECIFIED.,.F.,.F.,.F.)GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')SURFACE())
END
model "BEZIER_SURFACE" 80 - -e 0.01 "$TMP/bezier.step"
for kind in QUASI_UNIFORM UNIFORM; do
	echo "s ${kind}_SURFACE('',1,1,(({p 0 0 0},{p 0 8 0}),({p 10 0 0},{p 10 8 0}),({p 10 0 5},{p 10 8 5})),.UNSPECIFIED.,.F.,.F.,.F.)" | free "$kind"
	model "${kind}_SURFACE" 120 - -e 0.01 "$TMP/$kind.step"
done
free offset <<'END'
s RECTANGULAR_TRIMMED_SURFACE('',{b},0.,1.,0.,1.,.T.,.T.)
b OFFSET_SURFACE('',{q},2.,.F.)
q (BOUNDED_SURFACE()B_SPLINE_SURFACE(2,1,(({p 10 0 0},{p 10 0 15}),({p 10 10 0},{p 10 10 15}),({p 0 10 0},{p 0 10 15})),.UNSPECIFIED.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,1.),(0.70710678118654757,0.70710678118654757),(1.,1.)))REPRESENTATION_ITEM('')SURFACE())
END
model "OFFSET_SURFACE of a quarter of a cylinder" "$(calc 'p / 2 * 12 * 15')" - -e 0.001 "$TMP/offset.step"

# A torus that cuts itself: its outer part, which turns the circle's arc from the axis to the axis.
whole() { # SURFACE
	cat <<END
s1 $1
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
b1 FACE_BOUND('',{l1},.T.)
l1 VERTEX_LOOP('',{v 0 0 4})
shell CLOSED_SHELL('',({f1}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END
}
whole "DEGENERATE_TOROIDAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},3.,5.,.T.)" | step apple
# the arc's angle q has cos q = -3/5: the area is 2 p (3 * 5 * 2 q + 25 * 2 sin q) of it
model "DEGENERATE_TOROIDAL_SURFACE, outer" "$(awk 'BEGIN { p = atan2(0, -1); q = atan2(4, -3)
	print 2 * p * 5 * (3 * 2 * q + 5 * 2 * sin(q)) }')" "$(awk 'BEGIN { p = atan2(0, -1); q = atan2(4, -3); n = 20000
	for (i = 0; i < n; i++) { t = -q + 2 * q * (i + 0.5) / n; r = 3 + 5 * cos(t); s += p * r * r * 5 * cos(t) * 2 * q / n }
	print s }')" -e 0.0002 "$TMP/apple.step"
whole "DEGENERATE_TOROIDAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},3.,5.,.F.)" | step lemon
model "DEGENERATE_TOROIDAL_SURFACE, inner" "$(awk 'BEGIN { p = atan2(0, -1); q = p - atan2(4, -3)
	print 2 * p * 5 * (5 * 2 * sin(q) - 3 * 2 * q) }')" - -e 0.0002 "$TMP/lemon.step"

# ---- STEP: a part of a sphere between meridians, its edges through both poles

meridians() { # NAME ANGLES: from angle 0 to 90 degrees, or the rest
	cat <<END
v1 VERTEX_POINT('',{p 0 0 -10})
v2 VERTEX_POINT('',{p 0 0 10})
c1 CIRCLE('',{a 0,0,0 0,-1,0 0,0,-1},10.)
c2 CIRCLE('',{a 0,0,0 1,0,0 0,0,-1},10.)
e1 EDGE_CURVE('',{v1},{v2},{c1},.T.)
e2 EDGE_CURVE('',{v1},{v2},{c2},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.$2.)
o2 ORIENTED_EDGE('',*,*,{e2},.$1.)
l1 EDGE_LOOP('',({o1},{o2}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
s1 SPHERICAL_SURFACE('',{a 0,0,0 0,0,1 1,0,0},10.)
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
open OPEN_SHELL('',({f1}))
SOLID SHELL_BASED_SURFACE_MODEL('',({open}))
END
}
meridians T F | step quarter
meridians F T | step rest
model "part of a sphere through both poles" "$(calc '100 * p')" - -e 0.001 "$TMP/quarter.step"
model "and the rest of it" "$(calc '300 * p')" - -e 0.001 "$TMP/rest.step"

# ---- positions to 1e-9 of the size, and the smallest concave radii

# exact DESC FORMULA FILE: an awk expression of x, y, z that is the distance from the exact surface
exact() {
	nurbs2mesh --grid 23 "$3" | awk -F, "NR > 1 { x = \$4; y = \$5; z = \$6; d = $2; if (d < 0) d = -d; if (d > m) m = d }
		END { print (NR > 500 ? m : 1) }" >"$TMP/far"
	below "$1" "$(cat "$TMP/far")" 2e-8
}
whole "SPHERICAL_SURFACE('',{a 1,2,3 0,0,1 1,0,0},10.)" | step sphere
exact "a sphere" "sqrt((x - 1) ^ 2 + (y - 2) ^ 2 + (z - 3) ^ 2) - 10" "$TMP/sphere.step"
whole "TOROIDAL_SURFACE('',{a 1,2,3 0,0,1 1,0,0},20.,5.)" | step torus
exact "a torus" "sqrt((sqrt((x - 1) ^ 2 + (y - 2) ^ 2) - 20) ^ 2 + (z - 3) ^ 2) - 5" "$TMP/torus.step"
exact "a torus that cuts itself" "sqrt((sqrt(x ^ 2 + y ^ 2) - 3) ^ 2 + z ^ 2) - 5" "$TMP/apple.step"
exact "an offset cylinder of STEP" "sqrt(x ^ 2 + y ^ 2) - 12" "$TMP/offset.step"
nurbs2mesh --grid 23 "$TMP/offset140.igs" | awk -F, 'NR > 1 && $1 == 7 { d = sqrt($4 ^ 2 + $5 ^ 2) - 12; if (d < 0) d = -d
	if (d > m) m = d; n++ } END { print (n > 500 ? m : 1) }' >"$TMP/far"
below "an offset cylinder of IGES" "$(cat "$TMP/far")" 2e-8

radius() { # FILE RADIUS DESC
	nurbs2mesh -k -n 20 "$1" 2>/dev/null >"$TMP/out"
	below "$3" "$(awk -v r="$2" '/largest ball/ { print ($5 / r - 1) ^ 2 }' "$TMP/out")" 1e-10
}
radius "$SRC/tests/data/box.step" 4 "the smallest concave radius of a hole"
radius "$TMP/torus.step" 15 "that of a torus, at its waist"

done_testing

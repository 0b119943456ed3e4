#!/bin/sh
# nurbs2mesh-same.t - the same model as IGES and as STEP gives the same skin: area and volume exact
# within 1e-4, nothing open, every vertex on the analytic surface; fillets, voids, mapped items,
# angles in degrees, inches.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# The farthest place of a grid or mesh from the profile's lines and circles (mm), x y z from column $2.
off_profile() { # PROFILE COLUMN FILE: of a grid (,) or of vertices
	awk -F'[ ,]' -v c="$2" '
	NR == FNR { if ($1 == "at") { r = $2; z = $3; next }
		n++; p[n] = r; q[n] = z; a[n] = $2 - r; b[n] = $3 - z; l[n] = sqrt(a[n] ^ 2 + b[n] ^ 2)
		arc[n] = $1 == "arc"; mr[n] = $4; mz[n] = $5; radius[n] = sqrt((r - $4) ^ 2 + (z - $5) ^ 2)
		r = $2; z = $3; next }
	/end_header/ || /^entity/ { on = 1; next }
	!on || NF != (c > 1 ? 9 : 7) { next }
	{ r = sqrt($c * $c + $(c + 1) * $(c + 1)); z = $(c + 2); least = 1e9
		for (i = 1; i <= n; i++) {
			d = arc[i] ? sqrt((r - mr[i]) ^ 2 + (z - mz[i]) ^ 2) - radius[i] : ((r - p[i]) * b[i] - (z - q[i]) * a[i]) / l[i]
			d = d < 0 ? -d : d
			if (d < least) least = d }
		if (least > most) most = least; count++ }
	END { print (count > 100 ? most + 0 : 1) }' "$1" "$3"
}

# reported DESC AREA VOLUME ARGS...: what -v tells is of the surfaces, however coarse the triangles are
reported() {
	what=$1 want_area=$2 want_volume=$3
	shift 3
	nurbs2mesh -v "$@" 2>&1 >/dev/null | sed -n 's/.*body 1: closed.* area \([^ ]*\) mm2, volume \([^ ]*\) mm3, [0-9]* facets$/\1 \2/p' >"$TMP/told"
	read -r area volume <"$TMP/told"
	usual=${within:-0.0001} within=0.000001
	part "$what: the area that is told" "$area" "$want_area"
	part "$what: and the volume" "$volume" "$want_volume"
	within=$usual
}

# both NAME E: the profile $TMP/NAME as IGES and STEP
both() {
	name=$1 e=$2
	awk -v kind=exact -f "$SRC/tests/lib/turned.awk" "$TMP/$name" >"$TMP/exact"
	read -r want_a want_v <"$TMP/exact"
	awk -v kind=igs -f "$SRC/tests/lib/turned.awk" "$TMP/$name" | iges "$name"
	awk -v kind=step -f "$SRC/tests/lib/turned.awk" "$TMP/$name" | step "$name"
	for kind in igs step; do
		model "$name.$kind" "$want_a" "$want_v" -e "$e" "$TMP/$name.$kind"
		below "$name.$kind: every vertex is on it" "$(off_profile "$TMP/$name" 1 "$TMP/model.ply")" 2e-6
		reported "$name.$kind" "$want_a" "$want_v" -e 0.3 "$TMP/$name.$kind"
		nurbs2mesh --grid 19 "$TMP/$name.$kind" >"$TMP/grid"
		below "$name.$kind: and the surfaces, within 1e-9 of the size" "$(off_profile "$TMP/$name" 4 "$TMP/grid")" 3e-8
	done
}

printf 'at 0 0\nline 10 0\nline 10 30\nline 0 30\n' >"$TMP/cylinder"
printf 'at 0 0\nline 10 0\nline 4 8\nline 0 8\n' >"$TMP/cone"
printf 'at 0 -5\narc 10 5 0 5 ccw\nline 10 25\narc 0 35 0 25 ccw\n' >"$TMP/capsule"
printf 'at 15 0\narc 25 0 20 0 ccw\narc 15 0 20 0 ccw\n' >"$TMP/ring"
printf 'at 0 0\nline 20 0\nline 20 5\nline 11 5\narc 8 8 11 8 cw\nline 8 15\nline 0 15\n' >"$TMP/fillet"
printf 'at 0 0\nline 20 0\nline 20 8\narc 18 10 18 8 ccw\nline 12 10\narc 10 8 12 8 ccw\narc 8 6 8 8 cw\nline 0 6\n' >"$TMP/dish"
both cylinder 0.0013
both cone 0.0008
within=0.001 # chords of what bends both ways are that much shorter; more would take many facets
both capsule 0.008
both ring 0.004
both dish 0.008
unset within
both fillet 0.0015
for kind in igs step; do
	nurbs2mesh -k -n 20 "$TMP/fillet.$kind" 2>/dev/null >"$TMP/out"
	below "fillet.$kind: the smallest concave radius is the rolling ball's" \
		"$(awk '/largest ball/ { print ($5 / 3 - 1) ^ 2 }' "$TMP/out")" 1e-10
done

# The profile turned is a B-spline: degree 3, with its weights.
cat <<'END' | iges spline
axis 110 0 0,0,-1,0,0,1
c 126 0 3,3,0,0,0,0,0,0,0,0,1,1,1,1,1,2,2,1,10,0,0,16,0,6,4,0,14,9,0,20,0,1,0,0,1
g1 110 0 0,0,0,10,0,0
g2 110 0 9,0,20,0,0,20
f0 120 0 {axis},{c},0.,6.2831853071795865
f1 120 0 {axis},{g1},0.,6.2831853071795865
f2 120 0 {axis},{g2},0.,6.2831853071795865
END
cat <<'END' | step spline
c (BOUNDED_CURVE()B_SPLINE_CURVE(3,({q1},{q2},{q3},{q4}),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((4,4),(0.,1.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,2.,2.,1.))REPRESENTATION_ITEM(''))
q1 CARTESIAN_POINT('',(10.,0.,0.))
q2 CARTESIAN_POINT('',(16.,0.,6.))
q3 CARTESIAN_POINT('',(4.,0.,14.))
q4 CARTESIAN_POINT('',(9.,0.,20.))
ax AXIS1_PLACEMENT('',{p 0 0 0},{d 0 0 1})
s0 SURFACE_OF_REVOLUTION('',{c},{ax})
s1 PLANE('',{a 0,0,0 0,0,1 1,0,0})
s2 PLANE('',{a 0,0,20 0,0,1 1,0,0})
v1 VERTEX_POINT('',{q1})
v4 VERTEX_POINT('',{q4})
k1 CIRCLE('',{a 0,0,0 0,0,1 1,0,0},10.)
k4 CIRCLE('',{a 0,0,20 0,0,1 1,0,0},9.)
e1 EDGE_CURVE('',{v1},{v1},{k1},.T.)
e4 EDGE_CURVE('',{v4},{v4},{k4},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
o2 ORIENTED_EDGE('',*,*,{e4},.F.)
o3 ORIENTED_EDGE('',*,*,{e1},.F.)
o4 ORIENTED_EDGE('',*,*,{e4},.T.)
l1 EDGE_LOOP('',({o1}))
l2 EDGE_LOOP('',({o2}))
l3 EDGE_LOOP('',({o3}))
l4 EDGE_LOOP('',({o4}))
b1 FACE_BOUND('',{l1},.T.)
b2 FACE_BOUND('',{l2},.T.)
b3 FACE_BOUND('',{l3},.T.)
b4 FACE_BOUND('',{l4},.T.)
f0 ADVANCED_FACE('',({b1},{b2}),{s0},.T.)
f1 ADVANCED_FACE('',({b3}),{s1},.F.)
f2 ADVANCED_FACE('',({b4}),{s2},.T.)
shell CLOSED_SHELL('',({f0},{f1},{f2}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END
# the integrals over the curve by Simpson's rule
awk 'function at(t, m, k,   u, s, x, w) { u = 1 - t; w = u ^ 3 + 6 * u * u * t + 6 * u * t * t + t ^ 3
	s = k == 0 ? 10 * u ^ 3 + 96 * u * u * t + 24 * u * t * t + 9 * t ^ 3 : 36 * u * u * t + 84 * u * t * t + 20 * t ^ 3
	return s / w }
	BEGIN { p = atan2(0, -1); n = 4000; h = 1 / n; d = 1e-6
	for (i = 0; i <= n; i++) { t = i * h; f = (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * h / 3
		r = at(t, 0, 0); a = (at(t + d, 0, 0) - at(t - d, 0, 0)) / 2 / d; b = (at(t + d, 0, 1) - at(t - d, 0, 1)) / 2 / d
		area += 2 * p * r * sqrt(a * a + b * b) * f; volume += p * r * r * b * f }
	printf "%.9f %.9f\n", area + p * 100 + p * 81, volume }' >"$TMP/exact"
read -r want_a want_v <"$TMP/exact"
model "spline.igs" "$want_a" "$want_v" -e 0.001 "$TMP/spline.igs"
model "spline.step" "$want_a" "$want_v" -e 0.001 "$TMP/spline.step"

# A box with a hole: planes and a cylinder, trimmed.
cat <<'END' | iges box
bottom 108 0 0,0,-1,0,0,0,0,0,1
top 108 0 0,0,1,10,0,0,0,10,1
front 108 0 0,-1,0,0,0,0,0,0,1
right 108 0 1,0,0,30,0,30,0,0,1
back 108 0 0,1,0,20,0,0,20,0,1
left 108 0 -1,0,0,0,0,0,0,0,1
r1 106 12 2,5,0,0,0,30,0,0,30,20,0,0,20,0,0,0,0
r2 106 12 2,5,0,0,10,30,0,10,30,20,10,0,20,10,0,0,10
r3 106 12 2,5,0,0,0,30,0,0,30,0,10,0,0,10,0,0,0
r4 106 12 2,5,30,0,0,30,20,0,30,20,10,30,0,10,30,0,0
r5 106 12 2,5,0,20,0,30,20,0,30,20,10,0,20,10,0,20,0
r6 106 12 2,5,0,0,0,0,20,0,0,20,10,0,0,10,0,0,0
h1 100 0 0,15,10,19,10,19,10
h2 100 0 10,15,10,19,10,19,10
t1 142 0 0,{bottom},0,{r1},2
t2 142 0 0,{top},0,{r2},2
t3 142 0 0,{front},0,{r3},2
t4 142 0 0,{right},0,{r4},2
t5 142 0 0,{back},0,{r5},2
t6 142 0 0,{left},0,{r6},2
i1 142 0 0,{bottom},0,{h1},2
i2 142 0 0,{top},0,{h2},2
f1 144 0 {bottom},1,1,{t1},{i1}
f2 144 0 {top},1,1,{t2},{i2}
f3 144 0 {front},1,0,{t3}
f4 144 0 {right},1,0,{t4}
f5 144 0 {back},1,0,{t5}
f6 144 0 {left},1,0,{t6}
axis 110 0 15,10,-5,15,10,5
g 110 0 19,10,0,19,10,10
f7 120 0 {axis},{g},0.,6.2831853071795865
END
area=$(calc '2 * (600 - 16 * p) + 2 * 10 * 50 + 2 * p * 4 * 10') volume=$(calc '6000 - 160 * p')
model "box.igs" "$area" "$volume" -e 0.003 "$TMP/box.igs"
model "box.step" "$area" "$volume" -e 0.003 "$SRC/tests/data/box.step"

# ---- units

awk -v kind=exact -f "$SRC/tests/lib/turned.awk" "$TMP/cone" >"$TMP/exact"
read -r want_a want_v <"$TMP/exact"
awk -v kind=step -v angle=57.29577951308232 -f "$SRC/tests/lib/turned.awk" "$TMP/cone" | step degrees -v degrees=1
model "STEP: a cone's angle in degrees" "$want_a" "$want_v" -e 0.0008 "$TMP/degrees.step"
awk -v kind=step -f "$SRC/tests/lib/turned.awk" "$TMP/fillet" | step inch -v unit=INCH
awk -v kind=igs -f "$SRC/tests/lib/turned.awk" "$TMP/fillet" | iges inch -v unit=1
awk -v kind=exact -f "$SRC/tests/lib/turned.awk" "$TMP/fillet" >"$TMP/exact"
read -r want_a want_v <"$TMP/exact"
for kind in igs step; do
	model "inch.$kind" "$(calc "$want_a * 25.4 ^ 2")" "$(calc "$want_v * 25.4 ^ 3")" -e 0.05 "$TMP/inch.$kind"
done

# ---- a part of a tenth of a millimetre: what is told and written has the digits for it

awk '$1 == "arc" { printf "arc %g %g %g %g %s\n", $2 / 200, $3 / 200, $4 / 200, $5 / 200, $6; next }
	{ print $1, $2 / 200, $3 / 200 }' "$TMP/fillet" >"$TMP/tiny"
awk -v kind=exact -f "$SRC/tests/lib/turned.awk" "$TMP/fillet" >"$TMP/exact"
read -r want_a want_v <"$TMP/exact"
for kind in igs step; do
	make=$([ $kind = igs ] && echo iges || echo step)
	awk -v kind=$kind -f "$SRC/tests/lib/turned.awk" "$TMP/tiny" | $make tiny
	model "tiny.$kind" "$(awk "BEGIN { printf \"%.12g\", $want_a / 40000 }")" \
		"$(awk "BEGIN { printf \"%.12g\", $want_v / 8000000 }")" -v -e 0.0000075 "$TMP/tiny.$kind"
	told=$(sed -n 's/.*genus 0.* volume \([^ ]*\) mm3.*/\1/p' "$TMP/model.err")
	part "tiny.$kind: the volume told" "$told" "$(awk "BEGIN { printf \"%.12g\", $want_v / 8000000 }")"
done

# ---- a void, and the same solid used several times

void() {
	awk -v kind=step -f "$SRC/tests/lib/turned.awk" "$TMP/cylinder" | grep -v '^SOLID'
	cat <<'END'
vs SPHERICAL_SURFACE('',{a 0,0,15 0,0,1 1,0,0},6.)
vb FACE_BOUND('',{vl},.T.)
vl VERTEX_LOOP('',{v 0 0 9})
vf ADVANCED_FACE('',({vb}),{vs},.T.)
inner CLOSED_SHELL('',({vf}))
turned ORIENTED_CLOSED_SHELL('',*,{inner},.F.)
SOLID BREP_WITH_VOIDS('',{shell},({turned}))
END
}
void | step void
nurbs2mesh -v -e 0.003 "$TMP/void.step" >"$TMP/model.ply" 2>"$TMP/report"
has "STEP: a void is a body of its own" "closed about a void, genus 0" "$TMP/report"
measure "$TMP/model.ply" >"$TMP/measure"
read -r area volume open <"$TMP/measure"
part "its volume is taken off" "$volume" "$(calc 'p * 100 * 30 - 4 / 3 * p * 216')"
part "its area counts" "$area" "$(calc '2 * p * 10 * 40 + 4 * p * 36')"
ok "nothing is open" test "$open" -eq 0

{
	cylinder_shell
	cat <<'END'
middle 116 0 0,0,15
ball 196 0 {middle},6
vface 510 1 {ball},0,0
inner 514 1 1,{vface},0
solid 186 0 {shell},1,1,{inner},0
END
} | iges void
nurbs2mesh -v -e 0.003 "$TMP/void.igs" >"$TMP/model.ply" 2>"$TMP/report"
measure "$TMP/model.ply" >"$TMP/measure"
read -r area volume open <"$TMP/measure"
part "IGES: a void's volume is taken off" "$volume" "$(calc 'p * 100 * 30 - 4 / 3 * p * 216')"
ok "nothing is open" test "$open" -eq 0

{
	awk -v kind=step -f "$SRC/tests/lib/turned.awk" "$TMP/cone"
	cat <<'END'
a0 AXIS2_PLACEMENT_3D('',{p 0 0 0},{d 0 0 1},{d 1 0 0})
a1 AXIS2_PLACEMENT_3D('',{p 50 0 0},{d 0 1 0},{d 1 0 0})
a2 AXIS2_PLACEMENT_3D('',{p -50 5 5},{d 0 0 -1},{d 0 1 0})
map REPRESENTATION_MAP({a0},{REP})
i1 MAPPED_ITEM('',{map},{a1})
i2 MAPPED_ITEM('',{map},{a2})
i3 MAPPED_ITEM('',{map},{a0})
TOP SHAPE_REPRESENTATION('',({i1},{i2},{i3}),{CONTEXT})
END
} | step mapped
awk -v kind=exact -f "$SRC/tests/lib/turned.awk" "$TMP/cone" >"$TMP/exact"
read -r want_a want_v <"$TMP/exact"
within=0.0003
model "STEP: three mapped items" "$(calc "3 * $want_a")" "$(calc "3 * $want_v")" -e 0.003 "$TMP/mapped.step"
ok "placed where they say" test "$(awk '/end_header/ { on = 1; next } on && NF == 7 { if ($1 > m) m = $1; if ($1 < l) l = $1 }
	END { printf "%.2f %.2f", l, m }' "$TMP/model.ply")" = "-60.00 60.00"

done_testing

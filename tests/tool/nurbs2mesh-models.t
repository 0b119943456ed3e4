#!/bin/sh
# nurbs2mesh-models.t - models of CAD systems, as IGES and STEP: areas and volumes that are known, no
# open edge, what is left out named, and files that are broken refused.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# Area, volume and border edges by place.
measure() { # FILE
	awk '
	BEGIN { n = 0 }
	/^element vertex/ { nv = $3 }
	!body { if ($0 == "end_header") body = 1; next }
	n < nv { x[n] = $1; y[n] = $2; z[n] = $3
		key = $1 " " $2 " " $3; if (!(key in place)) place[key] = n; at[n] = place[key]; n++; next }
	{ i = $2; j = $3; k = $4
		ux = x[j] - x[i]; uy = y[j] - y[i]; uz = z[j] - z[i]
		vx = x[k] - x[i]; vy = y[k] - y[i]; vz = z[k] - z[i]
		nx = uy * vz - uz * vy; ny = uz * vx - ux * vz; nz = ux * vy - uy * vx
		area += sqrt(nx * nx + ny * ny + nz * nz) / 2
		volume += (x[i] * nx + y[i] * ny + z[i] * nz) / 6
		edge[at[i] " " at[j]]++; edge[at[j] " " at[k]]++; edge[at[k] " " at[i]]++ }
	END { for (e in edge) { split(e, q, " "); if (edge[e] != edge[q[2] " " q[1]]) open++ }
		printf "%.6f %.6f %d\n", area, volume, open }' "$1"
}

# model DESC AREA VOLUME ARGS...: exact area and volume (- for an open surface) within 1e-4 of them
model() {
	what=$1 want_area=$2 want_volume=$3
	shift 3
	nurbs2mesh "$@" >"$TMP/model.ply" 2>"$TMP/model.err"
	ok "$what: is read" test $? -eq 0
	measure "$TMP/model.ply" >"$TMP/measure"
	read -r area volume open <"$TMP/measure"
	part "$what: area" "$area" "$want_area"
	[ "$want_volume" = - ] && return
	part "$what: volume" "$volume" "$want_volume"
	ok "$what: is closed" test "$open" -eq 0
}

part() { # DESC VALUE WANT: within 1e-4 of it
	below "$1 ($2, expected $3)" "$(awk -v a="$2" -v b="$3" 'BEGIN { d = (a - b) / b; print d < 0 ? -d : d }')" 0.0001
}

calc() { # EXPRESSION of p (pi)
	awk "BEGIN { p = atan2(0, -1); printf \"%.9f\\n\", $1 }"
}

iges() { # NAME [-v ...]: from standard input
	name=$1
	shift
	awk -f "$SRC/tests/lib/iges.awk" "$@" >"$TMP/$name.igs"
}

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
model "120: a quarter of a cylinder" "$(calc 'p / 2 * 10 * 20')" - -e 0.0005 "$TMP/quarter.igs"

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
model "118: between two half circles" "$(calc 'p * 10 * 7')" - -e 0.0005 "$TMP/ruled2.igs"

iges tabulated <<'END'
c 100 0 0,0,0,10,0,0,10
face 122 0 {c},10,0,15
END
model "122: a quarter circle moved along" "$(calc 'p / 2 * 10 * 15')" - -e 0.0005 "$TMP/tabulated.igs"

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
model "108: a square with a round hole" "$(calc '100 - 4 * p')" - -e 0.0002 "$TMP/plane.igs"

# ---- IGES: solids

cylinder_solid() {
	cat <<'END'
origin 116 0 0,0,0,0
top 116 0 0,0,30,0
z 123 0 0,0,1
c0 100 0 0,0,0,10,0,10,0
c1 100 0 30,0,0,10,0,10,0
seam 110 0 10,0,0,10,0,30
vertices 502 1 2,10,0,0,10,0,30
edges 504 1 3,{c0},{vertices},1,{vertices},1,{c1},{vertices},2,{vertices},2,{seam},{vertices},1,{vertices},2
side 192 0 {origin},{z},10
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
}
cylinder_solid | iges solid
model "186: a cylinder" "$(calc '2 * p * 10 * 40')" "$(calc 'p * 100 * 30')" -e 0.0005 "$TMP/solid.igs"
cylinder_solid | iges inches -v unit=1
model "in inches" "$(calc '2 * p * 10 * 40 * 25.4 * 25.4')" "$(calc 'p * 100 * 30 * 25.4 ^ 3')" -e 0.01 "$TMP/inches.igs"

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
model "186: a cone cut off" "$(calc 'p * (14 * 10 + 100 + 16)')" "$(calc 'p * 8 / 3 * (100 + 40 + 16)')" -e 0.0003 "$TMP/cone.igs"

# ---- what is left out

iges offset <<'END'
a 110 0 0,0,0,10,0,0
b 110 0 0,8,0,10,8,0
face 118 1 {a},{b},0,0
off 140 0 0,0,1,2.,{face}
END
status 3 "140 is left out" nurbs2mesh "$TMP/offset.igs"
has "named with its count" "1 surface of type 140 left out, the first is entity 7" "$TMP/err"
empty "writes nothing" "$TMP/out"
model "--partial goes on" 80 - --partial -e 0.01 "$TMP/offset.igs"

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
has "a part of a fiftieth of a mm" 'the part is 0\.0[0-9]* mm large: is the unit right' "$TMP/err"

done_testing

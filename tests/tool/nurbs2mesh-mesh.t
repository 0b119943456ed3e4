#!/bin/sh
# nurbs2mesh-mesh.t - surfaces to a mesh: counts, trimming, joined edges, the side that is outside,
# the hollow radii that are known, refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
s1=$SRC/samples/paper2_s1_a.igs
s2=$SRC/samples/paper2_s2_a.igs

# Vertices, faces, area (mm2), volume below (mm3), border edges by place, normals off unit, and the
# smallest cosine between a facet of some area and a normal of its corners.
measure() { # FILE
	"$READBACK" --mesh "$1" | cut -d' ' -f1-4,6-8
}

mesh() { # NAME ARGS...: the mesh in $TMP/NAME.ply and its figures
	name=$1
	shift
	nurbs2mesh "$@" >"$TMP/$name.ply" 2>"$TMP/$name.err"
	measure "$TMP/$name.ply" >"$TMP/measure"
	read -r vertices faces area volume open off worst <"$TMP/measure"
}

near() { # DESC VALUE WANT WITHIN
	below "$1 ($2, expected $3)" "$(awk -v a="$2" -v b="$3" 'BEGIN { d = a - b; print d < 0 ? -d : d }')" "$4"
}

# ---- one surface

mesh s1 "$s1"
ok "200 x 200 cells by default" test "$vertices $faces $open" = "40401 80000 800"
below "normals are unit vectors" "$off" 0.000000003
below "and look out of the facets" 0.98 "$worst"
has "kmax is there" '^property double kmax' "$TMP/s1.ply"
mesh n "$s1" -n 7
ok "-n 7" test "$vertices $faces" = "64 98"
mesh e "$s1" -v -e 0.01
below "-e 0.01 takes fewer" "$vertices" 12000
has "and says what it kept" 'off the surfaces by 0\.00[0-9]* mm at worst' "$TMP/e.err"
has "the ledger has it" '^comment ledger nurbs2mesh 0\.0[01]' "$TMP/e.ply"
nurbs2mesh -e 0.01 -j 1 "$s1" "$s2" >"$TMP/one.ply" 2>"$TMP/err"
nurbs2mesh -e 0.01 -j 7 "$s1" "$s2" >"$TMP/many.ply" 2>"$TMP/err"
same "the same bytes with any number of threads" "$TMP/one.ply" "$TMP/many.ply"
nurbs2mesh -n 9 <"$s1" | grep -v '^comment s' >"$TMP/stdin.ply"
nurbs2mesh -n 9 "$s1" | grep -v '^comment s' >"$TMP/file.ply"
same "standard input" "$TMP/stdin.ply" "$TMP/file.ply"
mesh inch -u inch -n 7 "$s1"
near "-u takes the place of the file's unit" "$area" "$(nurbs2mesh -n 7 "$s1" >"$TMP/mm.ply" && measure "$TMP/mm.ply" | awk '{ print $3 * 25.4 * 25.4 }')" 5

# ---- points and normals of an evaluator of its own (tests/data, 6 decimals)

for name in paper2_s1_a paper2_s2_a; do
	nurbs2mesh --grid 20 "$SRC/samples/$name.igs" | tail -n +2 | tr , ' ' >"$TMP/ours"
	tail -n +2 "$SRC/tests/data/$name.csv" | tr , ' ' | paste -d ' ' - "$TMP/ours" | awk '
		function far(a, b) { d = a - b; if (d < 0) d = -d; if (d > most) most = d }
		{ for (i = 1; i <= 9; i++) far($i, $(i + 9)); n++ }
		END { print n == 400 ? most : 9 }' >"$TMP/figures"
	below "$name: 400 places as the reference has them" "$(cat "$TMP/figures")" 0.00000051
done

# ---- the smallest hollow radius, the figures that the surfaces were made for

nurbs2mesh -k "$s1" "$s2" >"$TMP/k" 2>"$TMP/err"
near "S1: smallest hollow radius" "$(awk -F, 'NR == 2 { print $2 }' "$TMP/k")" 4.634 0.0000015
near "S1: its u" "$(awk -F, 'NR == 2 { print $3 }' "$TMP/k")" 0.093 0.0005
near "S1: its v" "$(awk -F, 'NR == 2 { print $4 }' "$TMP/k")" 0.078 0.0005
near "S2: smallest hollow radius" "$(awk -F, 'NR == 3 { print $2 }' "$TMP/k")" 12.844 0.0000015
near "S2: its u" "$(awk -F, 'NR == 3 { print $3 }' "$TMP/k")" 0.8 0.0005
near "S2: its v" "$(awk -F, 'NR == 3 { print $4 }' "$TMP/k")" 0.467 0.0005
has "the largest ball" '^# largest ball: radius 4\.634000 ' "$TMP/k"
nurbs2mesh -k --up 0,0,-1 "$s1" >"$TMP/k" 2>"$TMP/err"
hasnt "from below other places are hollow" ',4\.634000,' "$TMP/k"

# ---- a groove: a kink of one surface, which its knots allow, or two that meet

head='nurbs 1 unit mm surface degree 1 1 poles'
echo "$head 3 2 knots_u 0 0 0.5 1 1 knots_v 0 0 1 1 points
	0 0 5 10 0 0 20 0 5 0 20 5 10 20 0 20 20 5 end" >"$TMP/kink.nurbs"
echo "$head 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points 0 0 5 10 0 0 0 20 5 10 20 0
	surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1
	points 10 0 0 20 0 5 10 20 0 20 20 5 end" >"$TMP/two.nurbs"
awk '{ gsub(/10 0 0/, "10 0 9"); gsub(/10 20 0/, "10 20 9") } 1' \
	"$TMP/two.nurbs" >"$TMP/ridge.nurbs"
edge='^# hollow edge: 53\.130 degrees at 10\.0+ [0-9.]+ 0\.0+'
nurbs2mesh -k "$TMP/kink.nurbs" >"$TMP/k" 2>"$TMP/err"
has "the radius of a kink is 0" \
	'kink\.nurbs:[0-9]+,0\.000000,0\.5,[0-9.]+,10\.000000,[0-9.]+,0\.000000$' "$TMP/k"
has "its angle" "$edge \\([^ ]*kink.nurbs:[0-9]+\\): no ball fits there\$" "$TMP/k"
has "no ball fits it" '^# largest ball: none; but for hollow edges any, nothing is hollow$' "$TMP/k"
nurbs2mesh -k "$TMP/two.nurbs" >"$TMP/k" 2>"$TMP/err"
has "between two surfaces: neither is hollow" 'two\.nurbs:2,none,' "$TMP/k"
has "the edge is" "$edge \\([^ ]*two.nurbs:1 and [^ ]*two.nurbs:2\\): no ball fits there\$" "$TMP/k"
has "no ball fits it" '^# largest ball: none; but' "$TMP/k"
nurbs2mesh -k --up 0,0,-1 "$TMP/kink.nurbs" >"$TMP/k" 2>"$TMP/err"
hasnt "from below it is a ridge" '# hollow edge|,0\.000000,' "$TMP/k"
nurbs2mesh -k "$TMP/ridge.nurbs" >"$TMP/k" 2>"$TMP/err"
has "nor is a ridge hollow" '^# largest ball: any, nothing is hollow$' "$TMP/k"
for part in kink two ridge; do
	nurbs2mesh -q -n 20 -o "$TMP/$part.ply" "$TMP/$part.nurbs"
	want=3
	[ $part = ridge ] && want=0
	status $want "planecut of $part: what is left is no success" \
		planecut -r 3 --scallop 0.05 -o "$TMP/$part.cl" "$TMP/$part.ply"
	[ $part = ridge ] && continue
	has "... it is told" \
		'planecut: the ball does not fit at [0-9]+ points .* at (9\.9|10\.0)' "$TMP/err"
	has "... in the path, too" 'UNMET/planecut,the ball does not fit at' "$TMP/$part.cl"
	status 0 "... unless it is accepted" \
		planecut -q -r 3 --scallop 0.05 --avoid -o "$TMP/$part.cl" "$TMP/$part.ply"
	hasnt "... then it is not in the path" 'UNMET' "$TMP/$part.cl"
	status 0 "... or the published way is asked for" \
		planecut -q -r 3 --scallop 0.05 --paper -o "$TMP/$part.cl" "$TMP/$part.ply"
	status 3 "... meshnorm does the same" \
		meshnorm -r 3 --scallop 0.05 -o "$TMP/$part.cl" "$TMP/$part.ply"
	has "... and tells it" 'meshnorm: the ball does not fit at' "$TMP/err"
done

# ---- surfaces as text: a bowl, a sphere, a box of six faces

flat() { # POINTS...: a bilinear patch
	echo "surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points $*"
}

{
	echo "nurbs 1"
	flat 0 0 0 10 0 0 0 10 0 10 10 0
	echo "loop 0.2 0.2 0.8 0.2 0.8 0.8 0.2 0.8"
	echo "loop 0.45 0.45 0.55 0.45 0.55 0.55 0.45 0.55 end"
} >"$TMP/frame.nurbs"
for n in 1 3 10 64; do
	mesh frame -n $n "$TMP/frame.nurbs"
	near "a square less a square, n $n" "$area" 35 0.0001
done
awk 'BEGIN { print "nurbs 1 surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1"
	print "points -5 -5 0 5 -5 0 -5 5 0 5 5 0 loop"
	for (i = 0; i < 720; i++) { a = i * atan2(0, -1) / 360; print 0.5 + 0.4 * cos(a), 0.5 + 0.4 * sin(a) }
	print "end" }' >"$TMP/disc.nurbs"
for n in 1 8 31; do
	mesh disc -n $n "$TMP/disc.nurbs"
	near "a disc, n $n" "$area" "$(awk 'BEGIN { a = atan2(0, -1) / 360; print 720 / 2 * 16 * sin(a) }')" 0.001
done

# Faces of a cube in parameters of both hands: outside is found, twelve edges are shared.
{
	echo "nurbs 1"
	flat 0 0 0 10 0 0 0 10 0 10 10 0
	flat 0 0 10 10 0 10 0 10 10 10 10 10
	flat 0 0 0 10 0 0 0 0 10 10 0 10
	flat 0 10 0 0 10 10 10 10 0 10 10 10
	flat 0 0 0 0 10 0 0 0 10 0 10 10
	flat 10 0 0 10 10 0 10 0 10 10 10 10
	echo end
} >"$TMP/cube.nurbs"
mesh cube -n 4 "$TMP/cube.nurbs"
ok "a cube is closed" test "$open" -eq 0
near "its volume, with its outside out" "$volume" 1000 0.0001
ok "at sharp edges each side keeps its normals" test "$vertices" -eq 150
below "normals of facets" 0.999 "$worst"

# Halves with other counts along the common edge: one is given the vertices of the other.
{
	echo "nurbs 1"
	flat 0 0 0 10 0 0 0 10 0 10 10 0
	echo "surface degree 1 1 poles 2 6 knots_u 0 0 1 1 knots_v 0 0 1 3 6 7 9 9"
	echo "points 10 0 0 20 0 0 10 1 0 20 1 0 10 3 0 20 3 0 10 6 0 20 6 0 10 7 0 20 7 0 10 10 0 20 10 0"
	echo end
} >"$TMP/two.nurbs"
mesh two -n 3 "$TMP/two.nurbs"
near "two halves" "$area" 200 0.0001
ok "no crack between them" test "$open" -eq "$(awk 'BEGIN { print 2 * 3 + 2 * 3 + 3 + 5 }')"
ok "all normals up" test "$(awk '/end_header/ { on = 1; next } on && NF > 6 && $6 != 1' "$TMP/two.ply" | wc -l)" -eq 0

# Two that meet in a curve, with other knots and counts, and 0.02 mm apart in the middle of it: every
# open edge of the mesh is on the outline, and no vertex is further off than half of that.
inner_open() { # FILE: open edges off the outline, |x| = 50 and |y| = 50, and vertices off the curve
	awk 'BEGIN { n = 0 } !body { if ($1 " " $2 == "element vertex") nv = $3; if ($0 == "end_header") body = 1; next }
		n < nv { x[n] = $1; y[n] = $2; key = $1 " " $2 " " $3; if (!(key in first)) first[key] = n
			at[n] = first[key]; n++; next }
		{ for (k = 2; k <= 4; k++) edge[at[$k] " " at[$(k == 4 ? 2 : k + 1)]]++ }
		END { for (e in edge) { split(e, q, " "); if (edge[e] == edge[q[2] " " q[1]]) continue
			a = x[q[1]]; b = x[q[2]]; c = y[q[1]]; d = y[q[2]]
			if (a == b && a * a > 2499) continue
			if (c == d && c * c > 2499) continue
			open++ } print open + 0 }' "$1"
}
awk 'function hill(y) { return 12 * sin(y / 20) }
	BEGIN { print "nurbs 1"
	print "surface degree 1 3 poles 2 9 knots_u 0 0 1 1 knots_v 0 0 0 0 1 2 3 4 5 6 6 6 6 points"
	for (j = 0; j < 9; j++) { y = -50 + 12.5 * j; print -50, y, 0, 0, y, hill(y) }
	print "surface degree 1 3 poles 2 9 knots_u 0 0 1 1 knots_v 0 0 0 0 1 2 3 4 5 6 6 6 6 points"
	for (j = 8; j >= 0; j--) { y = -50 + 12.5 * j; print 0, y, hill(y) + (j == 4 ? 0.02 : 0), 50, y, 30 * (j % 2) }
	print "end" }' >"$TMP/meet.nurbs"
for how in "-n 40" "-n 13" "-e 0.05" "-e 0.02"; do
	# shellcheck disable=SC2086 # words
	mesh meet -v $how "$TMP/meet.nurbs"
	ok "surfaces 0.02 mm apart, $how: no edge is open but the outline" \
		test "$(inner_open "$TMP/meet.ply")" -eq 0
	below "$how: for that vertices move by half of it" \
		"$(sed -n 's/.*moved by at most \([^ ]*\) mm.*/\1/p' "$TMP/meet.err")" 0.0101
done
mesh meet --gap 0.001 "$TMP/meet.nurbs"
ok "with --gap 0.001 the middle is open" test "$(inner_open "$TMP/meet.ply")" -gt 0

# A sphere of eight quarters: exact, with its poles.
sphere=$TMP/sphere.nurbs
awk 'BEGIN { r = sqrt(0.5); print "nurbs 1 surface degree 2 2 poles 9 5"
	print "knots_u 0 0 0 1 1 2 2 3 3 4 4 4 knots_v 0 0 0 1 1 2 2 2"
	split("1 1 0 -1 -1 -1 0 1 1", x, " "); split("0 1 1 1 0 -1 -1 -1 0", y, " ")
	split("0 1 1 1 0", q, " "); split("-1 -1 0 1 1", z, " ")
	print "points"; for (j = 1; j <= 5; j++) for (i = 1; i <= 9; i++) print 10 * x[i] * q[j], 10 * y[i] * q[j], 10 * z[j]
	print "weights"; for (j = 1; j <= 5; j++) for (i = 1; i <= 9; i++) print (i % 2 ? 1 : r) * (j % 2 ? 1 : r)
	print "end" }' >"$sphere"
mesh sphere -e 0.01 "$sphere"
ok "a sphere is closed at its seam and poles" test "$open" -eq 0
near "its volume" "$volume" 4188.79 8
awk '/end_header/ { on = 1; next } on && NF == 7 { d = $1 * $4 + $2 * $5 + $3 * $6 - 10
	if (d < 0) d = -d; if (d > off) off = d; k = $7 + 0.1; if (k < 0) k = -k; if (k > bent) bent = k }
	END { print off, bent }' "$TMP/sphere.ply" >"$TMP/figures"
below "its normals are its radii" "$(cut -d' ' -f1 "$TMP/figures")" 0.000003
below "its curvature is 0.1, humped" "$(cut -d' ' -f2 "$TMP/figures")" 0.000001
nurbs2mesh -k "$sphere" >"$TMP/k" 2>&1
has "nothing of it is hollow" ',none,' "$TMP/k"
mesh bowl --up 0,0,1 -e 0.01 "$SRC/samples/saddle.nurbs"
near "a saddle with an opening" "$area" 1220.9 0.2

# The chord error of meshes with -e, at 78 places of each triangle: a torus has no flat place, and
# its true distance is known.
awk 'BEGIN { r = sqrt(0.5); print "nurbs 1 surface degree 2 2 poles 9 9"
	print "knots_u 0 0 0 1 1 2 2 3 3 4 4 4 knots_v 0 0 0 1 1 2 2 3 3 4 4 4 points"
	split("1 1 0 -1 -1 -1 0 1 1", x, " "); split("0 1 1 1 0 -1 -1 -1 0", y, " ")
	for (j = 1; j <= 9; j++) for (i = 1; i <= 9; i++) { d = 20 + 5 * x[j]; print d * x[i], d * y[i], 5 * y[j] }
	print "weights"; for (j = 1; j <= 9; j++) for (i = 1; i <= 9; i++) print (i % 2 ? 1 : r) * (j % 2 ? 1 : r)
	print "end" }' >"$TMP/torus.nurbs"
chord() { # FILE AWK-FUNCTION: off(u, v, w), how far a place is from the surface; prints the most
	awk "$2"' BEGIN { n = 0 }
		!body { if ($1 " " $2 == "element vertex") nv = $3; if ($0 == "end_header") body = 1; next }
		n < nv { x[n] = $1; y[n] = $2; z[n] = $3; n++; next }
		{ a = $2; b = $3; c = $4; for (i = 0; i <= 11; i++) for (k = 0; k <= 11 - i; k++) {
			p = i / 11; q = k / 11; r = 1 - p - q
			d = off(p * x[a] + q * x[b] + r * x[c], p * y[a] + q * y[b] + r * y[c],
				p * z[a] + q * z[b] + r * z[c])
			if (d < 0) d = -d; if (d > most) most = d } }
		END { printf "%.6f\n", most }' "$1"
}
off_torus='function off(u, v, w,   d) { d = sqrt(u * u + v * v) - 20; return sqrt(d * d + w * w) - 5 }'
# the sample: z = 4 + 16 s (1 - s) - 8 t (1 - t) with x = 40 s, y = 30 t, trimmed and with an opening
off_saddle='function off(u, v, w,   s, t, a, b) { s = u / 40; t = v / 30
	a = 16 * (1 - 2 * s) / 40; b = -8 * (1 - 2 * t) / 30
	return (4 + 16 * s * (1 - s) - 8 * t * (1 - t) - w) / sqrt(1 + a * a + b * b) }'
for e in 1 0.2 0.03; do
	mesh torus -e $e "$TMP/torus.nurbs"
	ok "-e $e: a torus is closed" test "$open" -eq 0
	most=$(chord "$TMP/torus.ply" "$off_torus")
	below "-e $e: no place of a triangle is farther off" "$most" $e
	below "-e $e: nor are there many too many" "$(awk -v e=$e 'BEGIN { print e / 2 }')" "$most"
done
for e in 0.3 0.05 0.004; do
	mesh opened -e $e "$SRC/samples/saddle.nurbs"
	most=$(chord "$TMP/opened.ply" "$off_saddle")
	below "-e $e: none of a trimmed saddle either" "$most" $e
	below "-e $e: nor many too many" "$(awk -v e=$e 'BEGIN { print e / 4 }')" "$most"
done

# ---- refusals

status 2 "-n and -e" nurbs2mesh -n 3 -e 1 "$s1"
status 2 "--up without a direction" nurbs2mesh --up 0,0,0 "$s1"
head -c 2000 "$s1" >"$TMP/cut.igs"
status 1 "a file that is cut" nurbs2mesh "$TMP/cut.igs"
empty "writes nothing" "$TMP/out"
refused() { # DESC WORDS TEXT
	echo "$3" >"$TMP/bad.nurbs"
	status 1 "$1" nurbs2mesh "$TMP/bad.nurbs"
	has "$1: says why" "bad.nurbs:[0-9]*: .*$2" "$TMP/err"
}
refused "text without end" "end" "nurbs 1 $(flat 0 0 0 1 0 0 0 1 0 1 1 0)"
refused "a pole too few" "coordinate" "nurbs 1 $(flat 0 0 0 1 0 0 0 1 0 1 1) end"
refused "another version" "version" "nurbs 2 end"
refused "knots that fall" "knot" "nurbs 1 surface degree 1 1 poles 2 2 knots_u 0 1 0 1 knots_v 0 0 1 1 points 0 0 0 1 0 0 0 1 0 1 1 0 end"
refused "a weight of nothing" "weight" "nurbs 1 $(flat 0 0 0 1 0 0 0 1 0 1 1 0) weights 1 1 0 1 end"
refused "knots beyond all bounds" "knot" "nurbs 1 surface degree 1 1 poles 2 2 knots_u 0 0 1e99 1e99 knots_v 0 0 1e308 1e308 points 0 0 0 1 0 0 0 1 0 1 1 0 end"
refused "a word that is none" "frobnicate" "nurbs 1 $(flat 0 0 0 1 0 0 0 1 0 1 1 0) frobnicate end"
refused "no surface" "surface" "nurbs 1 end"
# Poles a million times as far away as the surface is wide, and one that stands out: no hang.
echo "nurbs 1 $(flat 0 0 0 1 0 0 0 1 0 1 1 0) range 0 1e-7 0 1e-7 end" >"$TMP/tiny.nurbs"
status 1 "a range so small that on six decimals it has no area" nurbs2mesh -n 3 "$TMP/tiny.nurbs"
echo "nurbs 1 $(flat 3 3 3 3 3 3 3 3 3 3 3 3) end" >"$TMP/point.nurbs"
status 1 "a surface that is one point" nurbs2mesh "$TMP/point.nurbs"
empty "gives no mesh" "$TMP/out"
status 1 "a tolerance out of reach" nurbs2mesh -e 1e-9 "$s1"
has "names the surface" 'surface 1: more than 4 million cells' "$TMP/err"

done_testing

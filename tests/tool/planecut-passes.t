#!/bin/sh
# planecut-passes.t - counts and places on known surfaces, planes of any direction, foreign meshes,
# what does not fit.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"
cd "$TMP" || exit 1

panel=$SRC/samples/panel_17036.xyz

# Of a face, what is about its eyes and its nose.
face=$TMP/face.xyz
awk '$2 > -30 && $2 < 10' "$SRC/samples/face_nefertiti_26493.xyz" >"$face"

# The cutting points of a path, one a line: pass, tip, axis, contact, normal.
cuts() {
	awk -F'[/,]' '/PASS\// { pass = $2 }
		/CONTCT\// { c = $2; for (i = 3; i <= 7; i++) c = c " " $i }
		/^GOTO\// && c != "" { print pass, $2, $3, $4, $5, $6, $7, c; c = "" }' "$1"
}

# grid SURFACE X0 Y0 X1 Y1 COLUMNS ROWS: a PLY with exact normals; SURFACE is `dome` (a sphere of
# radius 60), `bowl` (one of 12 from inside) or `wave` (a bicubic); KMAX, HOLE (half its side).
grid() {
	awk -v s="$1" -v x0="$2" -v y0="$3" -v x1="$4" -v y1="$5" -v m="$6" -v n="$7" \
		-v kmax="${KMAX:-}" -v hole="${HOLE:-0}" 'BEGIN {
		for (j = 0; j < n; j++) for (i = 0; i < m; i++) {
			x = x0 + (x1 - x0) * (i + 0.5) / m; y = y0 + (y1 - y0) * (j + 0.5) / n
			if (x * x < hole * hole && y * y < hole * hole) continue
			a = j * (m + 1) + i; b = a + m + 1
			face[f++] = a " " a + 1 " " b + 1; face[f++] = a " " b + 1 " " b
		}
		print "ply\nformat ascii 1.0\nelement vertex " (m + 1) * (n + 1)
		c = split("x y z nx ny nz" (kmax == "" ? "" : " kmax"), name, " ")
		for (k = 1; k <= c; k++) print "property double " name[k]
		print "element face " f "\nproperty list uchar int vertex_indices\nend_header"
		for (j = 0; j <= n; j++) for (i = 0; i <= m; i++) {
			x = x0 + (x1 - x0) * i / m; y = y0 + (y1 - y0) * j / n
			if (s == "dome") { z = sqrt(3600 - x * x - y * y); a = x / 60; b = y / 60; c = z / 60 }
			if (s == "bowl") { z = sqrt(144 - x * x - y * y); a = -x / 12; b = -y / 12; c = z / 12; z = -z }
			if (s == "wave") {
				u = x / 44; v = y / 51; g = 10 - 12 * v + 20 * v * v - 8 * v * v * v
				h = 1 + 2 * u - 7 * u * u + 5 * u * u * u; z = h * g
				a = -(2 - 14 * u + 15 * u * u) / 44 * g; b = -(-12 + 40 * v - 24 * v * v) / 51 * h
				c = 1 / sqrt(a * a + b * b + 1); a *= c; b *= c
			}
			printf "%.6f %.6f %.6f %.9f %.9f %.9f%s\n", x, y, z, a, b, c, kmax == "" ? "" : " " kmax
		}
		for (k = 0; k < f; k++) print 3, face[k]
	}'
}

# ---- counts: paper 2, table 1: 9,023 = 22 * 401 + 201 points at step 2 and 90 degrees

KMAX=0.2 grid wave 0 0 44 51 200 200 >wave.ply
status 0 "a bicubic of 200 x 200 cells" planecut -v -r 4 -s 2 -a 90 --fixed 0,0,1 -o wave.cl wave.ply
has "has 23 planes" ': 23 planes$' err
has "no point of it is lifted" ' 0 points lifted' err
cuts wave.cl >points
ok "it has the paper's 9,023 points" test "$(wc -l <points)" = 9023
awk '{ n[$1]++; if (!($1 in x)) x[$1] = $8; d = $8 - x[$1]; if (d * d > 1e-12) bad++
	if ($7 != 1) bad++ }
	END { if (n[1] != 201) bad++; for (p = 2; p <= 23; p++) { if (n[p] != 401) bad++
		d = x[p] - x[p - 1] - 43.98 / 22; if (d * d > 1e-11) bad++ }
	if (x[1] != 0 || x[23] != 43.98) bad++; print bad + 0 }' points >figures
below "the first on the border, the others at equal distances, the last just inside" "$(cat figures)" 0
awk '{ u = $8 / 44; v = $9 / 51; g = 10 - 12 * v + 20 * v * v - 8 * v * v * v
	h = 1 + 2 * u - 7 * u * u + 5 * u * u * u; d = $10 - h * g; if (d < 0) d = -d; if (d > w) w = d
	x = $2 - $8 - 4 * $11; y = $3 - $9 - 4 * $12; z = $4 + 4 - $10 - 4 * $13
	e = sqrt(x * x + y * y + z * z); if (e > q) q = e } END { printf "%.7f %.7f\n", w, q }' points >figures
read -r off centre <figures
below "every point is on the surface" "$off" 0.000002
below "the tip is contact + r n - r u (eq 4)" "$centre" 0.000003
awk '{ if ($1 == last && (($9 > y) != ($1 % 2))) bad++; last = $1; y = $9 } END { print bad + 0 }' points >figures
below "odd passes go up y, even ones down" "$(cat figures)" 0
planecut -q -r 4 -s 2 -a 90 --oneway wave.ply | cuts - >oneway
awk '{ if ($1 == last && $9 <= y) bad++; last = $1; y = $9 } END { print bad + 0 }' oneway >figures
below "one way: all go up" "$(cat figures)" 0
planecut -q -r 4 -s 2 -a 90 --one-way wave.ply | cuts - >oneway2
same "--one-way is the same" oneway oneway2
KMAX=0.2 grid wave 0 0 102 160 200 200 >wave2.ply
planecut -q -r 10 --avoid --paper -s 5 wave2.ply | cuts - >points
ok "13,033 at step 5 and 0 degrees" test "$(wc -l <points)" = 13033

# ---- planes of any direction, on a dome where all is known

grid dome -20 -20 20 20 40 40 >dome.ply
# off_dome FILE RADIUS NX NY NZ: worst of contact off the sphere, centre off the larger one, contact
# off its pass's plane, and axis off 15 degrees
off_dome() {
	cuts "$1" | awk -v r="$2" -v nx="$3" -v ny="$4" -v nz="$5" '
		function worst(i, e) { if (e < 0) e = -e; if (e > w[i]) w[i] = e }
		{ worst(1, sqrt($8 * $8 + $9 * $9 + $10 * $10) - 60)
		x = $2 + r * $5; y = $3 + r * $6; z = $4 + r * $7; worst(2, sqrt(x * x + y * y + z * z) - 60 - r)
		h = $8 * nx + $9 * ny + $10 * nz; if (!($1 in at)) at[$1] = h; worst(3, h - at[$1])
		worst(4, $5 * $11 + $6 * $12 + $7 * $13 - cos(atan2(0, -1) / 12)) }
		END { printf "%.7f %.7f %.7f %.9f\n", w[1], w[2], w[3], w[4] }' >figures
	read -r contact centre plane lean <figures
}
for view in "-a 0 0 1 0" "-a 30 -0.5 0.866025404 0" "-a 90 1 0 0" "--plane 0,0,1 0 0 1" \
	"--plane 1,2,2 0.333333333 0.666666667 0.666666667"; do
	# shellcheck disable=SC2086 # words
	set -- $view
	status 0 "the dome, $1 $2" planecut -q -r 5 -s 3 --axis-play 0 "$1" "$2" -o dome.cl dome.ply
	off_dome dome.cl 5 "$3" "$4" "$5"
	below "$1 $2: contact on the sphere" "$contact" 0.00001
	below "$1 $2: centre one radius off" "$centre" 0.00001
	below "$1 $2: every pass in its plane" "$plane" 0.000002
	below "$1 $2: axis 15 degrees off the normal" "$lean" 0.000001
	has "$1 $2: the path is complete" '^FINI$' dome.cl
done
planecut -q -r 5 -s 3 --normal 0,0,1 --oneway dome.ply | cuts - >points
awk '{ if (!($1 in x)) { x[$1] = $8; y[$1] = $9 } u[$1] = $8; v[$1] = $9 }
	END { p = 5; d = (u[p] - x[p]) ^ 2 + (v[p] - y[p]) ^ 2; print d < 1e-9 ? 0 : 1 }' points >figures
below "a ring at constant height is closed" "$(cat figures)" 0
# the axis leans to the next plane (up) and feeds along the ring: never a component against it
planecut -q -r 5 -s 3 --normal 0,0,1 --tilt 20 --lead 0 dome.ply | cuts - |
	awk '{ if ($13 < 0.98 && $7 <= $13) bad++ } END { print bad + 0 }' >figures
below "on level planes the tilt leans up" "$(cat figures)" 0
planecut -q -r 5 -s 3 -a 30 --tilt 0 --lead 20 dome.ply | cuts - |
	awk '{ if ($1 == last && l != "") { d = ($8 - x) * a + ($9 - y) * b + ($10 - z) * c; if (d <= 0) bad++ }
		last = $1; l = 1; x = $8; y = $9; z = $10; a = $5 - $11 * 0.94; b = $6 - $12 * 0.94; c = $7 - $13 * 0.94 }
		END { print bad + 0 }' >figures
below "a lead leans the way the tool feeds" "$(cat figures)" 0

# scallop: the cusp between balls of radius 5 on the dome, from the contact points of two passes
planecut -q -r 5 --scallop 0.01 --paper dome.ply | cuts - >points
awk '$8 * $8 < 0.25 && !seen[$1]++ { a = atan2($9, sqrt(3600 - $9 * $9))
	if (n++) { h = (a - b) / 2; c = 65 * cos(h) - sqrt(25 - (65 * sin(h)) ^ 2) - 60
		if (c > w) w = c; if (n > 2 && (m == "" || c < m) && $9 < 18) m = c }
	b = a } END { printf "%.6f %.6f\n", w, m }' points >figures
read -r most least <figures
below "no cusp is higher than the scallop" "$most" 0.0102
below "nor much lower" 0.007 "$least"
planecut -q -r 5 dome.ply >default.cl
planecut -q -r 5 --scallop 0.01 dome.ply >scallop.cl
same "0.01 is the default" default.cl scallop.cl

# ---- what does not fit

KMAX=0.083333333 grid bowl -6 -6 6 6 30 30 >bowl.ply
status 0 "a ball of 11.9 fits a hollow of 12" planecut -q -r 11.9 -s 1 -o bowl.cl bowl.ply
status 1 "one of 13 does not" planecut -r 13 -s 1 bowl.ply
has "that is told with radius and place" 'hollow of radius 12\.000 at -?[0-9.]+ -?[0-9.]+ -?[0-9.]+,.*13' err
empty "and nothing is written" out
status 1 "nor with -o" planecut -r 13 -s 1 -o bowl13.cl bowl.ply
fails "no file appears" test -e bowl13.cl
status 0 "--avoid lifts it" planecut -v -r 13 -s 1 --avoid -o bowl13.cl bowl.ply
has "and says so" '[1-9][0-9]* points lifted' err
cuts bowl13.cl | awk '{ x = $2 + 13 * $5; y = $3 + 13 * $6; z = $4 + 13 * $7
	for (i = -1; i <= 1; i += 2) for (k = -1; k <= 1; k += 2) {
		d = 13 - sqrt((x - 6 * i) ^ 2 + (y - 6 * k) ^ 2 + (z + sqrt(72)) ^ 2); if (d > w) w = d }
	} END { printf "%.6f\n", w }' >figures
below "clear of the corners of the bowl" "$(cat figures)" 0.001
grid bowl -6 -6 6 6 30 30 >bare.ply
status 3 "without kmax it is lifted by itself" planecut -r 13 -s 1 -o bare.cl bare.ply
has "and that is said" 'no curvatures \(kmax\)' err
has "as is what it leaves" \
	'the ball does not fit at [0-9]+ points of the path and leaves material' err
# two surfaces in one mesh: the tighter one is named, with the radius that it was made for
s1=$SRC/samples/paper2_s1_a.igs s2=$SRC/samples/paper2_s2_a.igs
nurbs2mesh -q -n 9 -o both.ply "$s2" "$s1"
status 1 "a ball of 4.6341 for a surface of 4.634" planecut -r 4.6341 -s 5 both.ply
has "surface, place and radius, though no vertex is there" \
	'radius 4\.634 at 4\.103 3\.987 4\.730 in surface [^ ]*paper2_s1_a.igs:1,.*\(1 surface' err
empty "and nothing is written" out
status 1 "a ball of 13" planecut -r 13 -s 5 both.ply
has "is too large for both" 'paper2_s1_a.igs:1,.*\(2 surfaces too tight' err
# they are in each other's way, and what stays there is told
status 3 "4.634 itself fits" planecut -q -r 4.634 -s 5 -e 0.01 -o both.cl both.ply
ok "the path is there" grep -q '^FINI' both.cl
hasnt "neither surface is too hollow" 'expected none below' err
status 3 "the face, with a ball of 10" sh -c "cloud2mesh -q -t 4 '$face' | planecut -r 10 -s 4"
status 0 "guarded by its scan, every point of it" sh -c \
	"cloud2mesh -q -t 4 '$face' | planecut -q -r 10 -s 6 -a 30 --avoid -g '$face' --noise 0 -o face.cl"
"$READBACK" -c none face.cl --scan "$face" >out
below "it does not gouge, anywhere on its way" \
	"$(sed -n '/^ball:/s/.*deepest \([-0-9.]*\) mm.*/\1/p' out)" 0.012

# ---- chains: holes, adjoining surfaces, gaps

runs() { # how many rows of contact points without another move between
	awk '/CONTCT/ { c = 1 } /^GOTO/ { if (c && !on) n++; on = c; c = 0 } /^RAPID/ { on = 0 } END { print n }' "$1"
}
HOLE=6 grid dome -20 -20 20 20 40 40 >hole.ply
planecut -q -r 5 -s 4 --fixed 0,0,1 hole.ply >hole.cl
ok "11 passes" test "$(grep PASS/ hole.cl | sort -u | wc -l)" = 11
ok "a hole breaks those three that meet it" test "$(runs hole.cl)" = 14
# two sheets, 0.05 apart, in one PLY
sheets() { # GAP
	awk -v gap="$1" 'BEGIN { print "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y"
		print "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header"
		for (k = 0; k < 2; k++) for (j = 0; j < 2; j++) for (i = 0; i < 3; i++)
			print k * 20 + (k ? gap : 0) + (k ? i * 10 : i * 10), j * 20, 0
		for (k = 0; k < 2; k++) { print 4, 6 * k, 6 * k + 1, 6 * k + 4, 6 * k + 3
			if (k) print 4, 6 * k + 1, 6 * k + 4, 6 * k + 5, 6 * k + 2; else print 4, 1, 2, 5, 4 } }'
}
sheets 0.05 >gap.ply
planecut -q -r 5 -s 5 --fixed 0,0,1 gap.ply >gap.cl
ok "sheets 0.05 mm apart are cut in one" test "$(runs gap.cl)" = "$(grep -c PASS/ gap.cl)"
planecut -q -r 5 -s 5 --fixed 0,0,1 --gap 0.01 gap.ply >nogap.cl
below "unless the gap allowed is smaller" "$(grep -c PASS/ nogap.cl)" "$(($(runs nogap.cl) - 1))"

# ---- several faces: in one order, without jumps

# flats RECTANGLES: corners of a rectangle a line, as surfaces of their own
flats() {
	awk 'BEGIN { print "nurbs 1" }
		{ print "surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points " $0 }
		END { print "end" }' >flats.nurbs
	nurbs2mesh -q -e 0.01 -o flats.ply flats.nurbs
}
# The walls of a box and its top: a plane cuts a wall, the top and the other wall in one, and goes back.
flats <<-END
	0 0 10 30 0 10 0 20 10 30 20 10
	0 0 0 30 0 0 0 0 10 30 0 10
	30 0 0 30 20 0 30 0 10 30 20 10
	30 20 0 0 20 0 30 20 10 0 20 10
	0 20 0 0 0 0 0 20 10 0 0 10
END
for angle in 0 30 90; do
	planecut -v -r 2 -s 1 -a $angle -o flats.cl flats.ply 2>err
	planes=$(sed -n 's/.*: \([0-9]*\) planes$/\1/p' err)
	has "-a $angle: walls and top of a box in one" \
		" $((planes - 1)) links with the tool down, 1 over the clearance plane" err
done
# Six separate squares: each is cut whole before the next.
flats <<-END
	0 0 0 10 0 0 0 10 0 10 10 0
	20 3 0 30 3 0 20 13 0 30 13 0
	40 6 0 50 6 0 40 16 0 50 16 0
	0 20 0 10 20 0 0 30 0 10 30 0
	20 23 0 30 23 0 20 33 0 30 33 0
	40 26 0 50 26 0 40 36 0 50 36 0
END
for angle in 0 30 90; do
	planecut -q -r 2 -s 1 -a $angle -o flats.cl flats.ply
	cuts flats.cl | awk 'BEGIN { last = -1 }
		{ square = int($8 / 20) + 3 * int(($9 - 3 * int($8 / 20)) / 20 + 1e-4)
		if (square != last) { n++; last = square } } END { print n }' >figures
	below "-a $angle: as many squares one after the other as there are" "$(cat figures)" 6
done

# ---- foreign meshes: a block in every format

cat >block.off <<-END
	OFF
	8 6 0
	0 0 0
	10 0 0
	10 10 0
	0 10 0
	0 0 5
	10 0 5
	10 10 5
	0 10 5
	4 3 2 1 0
	4 4 5 6 7
	4 0 1 5 4
	4 1 2 6 5
	4 2 3 7 6
	4 3 0 4 7
END
status 0 "a block" planecut -r 3 -s 2 --fixed 0,0,1 -o block.cl block.off
has "its lower side is left out" 'points face away from the tool' err
# the ball along every line at feed, against the box itself
awk -F'[/,]' '/^RAPID/ { rapid = 1 } /^GOTO\// { x = $2; y = $3; z = $4 + 3
	if (n++ && !rapid) for (k = 0; k <= 20; k++) { s = k / 20
		u = a + s * (x - a); v = b + s * (y - b); w = c + s * (z - c)
		p = u < 0 ? u : u > 10 ? u - 10 : 0; q = v < 0 ? v : v > 10 ? v - 10 : 0
		r = w < 0 ? w : w > 5 ? w - 5 : 0; d = 3 - sqrt(p * p + q * q + r * r); if (d > m) m = d }
	a = x; b = y; c = z; rapid = 0 } END { printf "%.4f\n", m }' block.cl >figures
below "rolled over its edges, without a gouge" "$(cat figures)" 0.0025
cuts block.cl | awk '{ a = $11 * $11; b = $12 * $12; c = $13 * $13; if (a > 0.999 || b > 0.999 || c > 0.999) next
	if (($8 > 1e-6 && $8 < 9.999999)) bad++ } END { print bad + 0 }' >figures
below "faces keep their normals up to the edge" "$(cat figures)" 0
awk 'NR == 2 { next } NR > 2 && NR <= 10 { v[NR - 3] = $1 " " $2 " " $3 }
	NR > 10 { for (k = 3; k <= 4; k++) print "facet normal 0 0 0\nouter loop\nvertex " v[$2] "\nvertex " v[$k] "\nvertex " v[$(k + 1)] "\nendloop\nendfacet" }' \
	block.off | { echo solid block; cat; echo endsolid block; } >block.stl
status 0 "the same as STL" planecut -q -r 3 -s 2 --fixed 0,0,1 -o stl.cl block.stl
sed -i '/MESH\/.*block.off$/d' block.cl
sed -i '/MESH\/.*block.stl$/d' stl.cl
same "has the same path, but for the mesh's name" block.cl stl.cl
status 0 "on five axes too" planecut -q -r 3 -s 2 -o block5.cl block.off
for mesh in one-flipped all-flipped doubled degenerate; do
	ok "mesh-$mesh.ply is mended" planecut -r 4 -s 2 "$SRC/tests/data/awkward/mesh-$mesh.ply"
	has "which is said" 'flipped|twice|without area' err
done

# ---- vertices on planes, facets in them, twice, three on an edge, none: a plane z = x / 2 of 10 x 10
# cells, whose lines of vertices are the planes themselves: 21 points a pass, 11 on the border

slope() { # FACETS-OUT (a condition on column i and row j) MORE-VERTEX MORE-FACETS...
	awk -v out="$1" -v vertex="$2" -v more="$3" 'BEGIN {
		for (j = 0; j < 10; j++) for (i = 0; i < 10; i++) {
			if (out && i >= 3 && i <= 6 && j >= 3 && j <= 6) continue
			a = 11 * j + i; face[f++] = a " " a + 1 " " a + 12; face[f++] = a " " a + 12 " " a + 11 }
		if (more == "twice") { m = f; for (k = 0; k < 20; k++) face[m++] = face[k]; f = m }
		if (more == "third") face[f++] = "60 61 121"
		print "ply\nformat ascii 1.0\nelement vertex " 121 + (vertex != "")
		print "property double x\nproperty double y\nproperty double z\nelement face " f
		print "property list uchar int vertex_indices\nend_header"
		for (j = 0; j <= 10; j++) for (i = 0; i <= 10; i++) print i, j, i / 2
		if (vertex != "") print vertex
		for (k = 0; k < f; k++) print 3, face[k] }'
}
slope_is() { # DESC POINTS: all on the slope, with its normal
	cuts slope.cl | awk -v want="$2" '{ d = $10 - $8 / 2; e = $11 + 0.447213595; if (d * d > 1e-12 || e * e > 1e-16) bad++ }
		END { print NR == want ? bad + 0 : "points " NR }' >figures
	below "$1: $2 points, all on the slope" "$(cat figures)" 0
}
slope 0 "" "" >slope.ply
for s in 1 0.5; do
	status 0 "planes through vertices, step $s" planecut -q -r 1 -s $s --fixed 0,0,1 -o slope.cl slope.ply
	slope_is "step $s" "$(awk -v s=$s 'BEGIN { print 11 + 21 * 10 / s }')"
done
slope 0 "" twice >slope.ply
status 0 "facets twice" planecut -q -r 1 -s 1 --fixed 0,0,1 -o slope.cl slope.ply
slope_is "facets twice" 221
slope 1 "" "" >slope.ply
status 0 "a hole" planecut -q -r 1 -s 1 --fixed 0,0,1 -o slope.cl slope.ply
slope_is "a hole" 193
slope 0 "5 5 9" third >slope.ply
status 0 "an edge of three facets" planecut -r 1 -s 1 --paper --fixed 0,0,1 -o slope.cl slope.ply
has "is told" 'more than two facets' err
has "and the path is whole" '^FINI$' slope.cl
slope 0 "" "" >slope.ply
status 1 "planes along the facets" planecut -r 1 -s 1 --normal -1,0,2 slope.ply
has "cross nothing" 'nothing that the planes cross' err
empty "and nothing is written" out

# ---- a groove hardly wider than the ball

# Its centre goes 4 mm in a row that cuts 11, whose neighbours cut it, but not what is about it.
cat <<'END' | iges groove
axis 110 0 0,0,0,0,12.3,0
line 110 0 5.7,0,-3.7,5.7,12.3,-3.7
groove 120 0 {axis},{line},0.,2.
END
nurbs2mesh -q -e 0.005 -o groove.ply groove.igs
status 0 "a groove" planecut -r 5 --scallop 0.1 -o groove.cl groove.ply
sed -n 's/^\$\$-> CONTCT\///p' groove.cl | cut -d, -f2 | sort -n >rows
below "all its rows are cut: none lies farther from the next" \
	"$(awk 'NR > 1 && $1 - y > d { d = $1 - y } { y = $1 } END { print d }' rows)" 2
ncpost -q -c fanuc -o groove.nc groove.cl
status 0 "... and its program is accepted" ncverify -q -g groove.ply groove.nc

# ---- refusals

status 2 "no radius" planecut -s 2 dome.ply
status 2 "two steps" planecut -r 4 -s 2 --scallop 0.01 dome.ply
status 2 "two directions" planecut -r 4 -a 3 --normal 0,1,0 dome.ply
status 2 "a normal of no length" planecut -r 4 --normal 0,0,0 dome.ply
status 2 "a step of nothing" planecut -r 4 -s 0 dome.ply
status 1 "a step for millions of planes" planecut -r 4 -s 0.000001 dome.ply
status 2 "a scallop larger than the ball" planecut -r 4 --scallop 5 dome.ply
status 2 "a lean on three axes" planecut -r 4 --fixed 0,0,1 --lean-limit 9 -m three-axis dome.ply
has "... which is told" 'an axis it has, and no --lean-limit' "$TMP/err"
status 2 "two meshes" planecut -r 4 dome.ply dome.ply
empty "and nothing is written" out
status 1 "a cloud" planecut -r 4 "$panel"
empty "and nothing is written" out
head -c 9000 dome.ply >half.ply
status 1 "half a mesh" planecut -r 4 half.ply
empty "and nothing is written" out

done_testing

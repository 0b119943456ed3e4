#!/bin/sh
# meshnorm-rows.t - figures on the panel and the face, the axis, order and links, refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz
face=$SRC/samples/face_nefertiti_26493.xyz

# The cutting points of a path, one a line: tip, axis, contact, normal; the pass in front.
cuts() {
	awk -F'[/,]' '/PASS\// { pass = $2 }
		/CONTCT\// { c = $2; for (i = 3; i <= 7; i++) c = c " " $i }
		/^GOTO\// && c != "" { print pass, $2, $3, $4, $5, $6, $7, c; c = "" }' "$1"
}

# A dome of radius 60 on a triangular grid of 4 mm, with its exact normals: rows and columns of a
# disc, the row `hole` without its middle.
dome() {
	awk -v hole="${1:--1}" -v rows="${2:-yes}" 'BEGIN {
		n = f = 0; t = 4; h = t * sqrt(3) / 2
		for (j = -6; j <= 6; j++) for (i = -10; i <= 10; i++) {
			x = i * t + j * t / 2; y = j * h
			if (x * x + y * y > 625 || (j == hole && x * x < 50)) continue
			at[i, j] = n; px[n] = x; py[n] = y; pz[n] = sqrt(3600 - x * x - y * y)
			row[n] = j + 6; col[n++] = i + 10
		}
		for (j = -6; j <= 6; j++) for (i = -10; i <= 10; i++) {
			if ((i, j) in at && (i + 1, j) in at && (i, j + 1) in at)
				face[f++] = at[i, j] " " at[i + 1, j] " " at[i, j + 1]
			if ((i + 1, j) in at && (i + 1, j + 1) in at && (i, j + 1) in at)
				face[f++] = at[i + 1, j] " " at[i + 1, j + 1] " " at[i, j + 1]
		}
		print "ply\nformat ascii 1.0\ncomment cloudmill mesh 1\ncomment spacing 4"
		print "element vertex " n
		split("x y z nx ny nz", name, " ")
		for (k = 1; k <= 6; k++) print "property double " name[k]
		if (rows == "yes") print "property int row\nproperty int col"
		print "element face " f "\nproperty list uchar int vertex_indices\nend_header"
		for (k = 0; k < n; k++) {
			printf "%.9f %.9f %.9f %.9f %.9f %.9f", px[k], py[k], pz[k], px[k] / 60, py[k] / 60, pz[k] / 60
			print rows == "yes" ? " " row[k] " " col[k] : ""
		}
		for (k = 0; k < f; k++) print 3, face[k]
	}'
}

dome >"$TMP/dome.ply"

# ---- offsets and axes, on the dome where they are known

status 0 "a path from the dome" meshnorm -q -r 5 --rows mesh --axis-play 0 -o "$TMP/dome.cl" "$TMP/dome.ply"
cuts "$TMP/dome.cl" >"$TMP/cuts"
ok "every node is a contact point" test "$(wc -l <"$TMP/cuts")" = "$(sed -n 's/^element vertex //p' "$TMP/dome.ply")"
awk '{ x = $2 + 5 * $5; y = $3 + 5 * $6; z = $4 + 5 * $7
	d = sqrt(x * x + y * y + z * z) - 65; if (d < 0) d = -d; if (d > w) w = d
	a = $5 * $11 + $6 * $12 + $7 * $13 - cos(atan2(0, -1) / 12); if (a < 0) a = -a; if (a > v) v = a }
	END { printf "%.9f %.9f\n", w, v }' "$TMP/cuts" >"$TMP/figures"
read -r off lean <"$TMP/figures"
below "the ball's centre is one radius off the dome" "$off" 0.000002
below "the axis leans 15 degrees off the normal" "$lean" 0.000001
awk '{ side = $6 - $12; if (side <= 0) bad++ } END { print bad + 0 }' "$TMP/cuts" >"$TMP/figures"
below "to the next row on zig and on zag" "$(cat "$TMP/figures")" 0
awk '{ if ($1 == last && (($8 > x) != ($1 % 2))) bad++; last = $1; x = $8 } END { print bad + 0 }' \
	"$TMP/cuts" >"$TMP/figures"
below "odd passes go up the columns, even ones down" "$(cat "$TMP/figures")" 0
has "the head has the tool" '^CUTTER/10.000000,5.000000,0.000000,5.000000,0.000000,0.000000,60.000000$' "$TMP/dome.cl"
has "and five axes" '^MULTAX/ON$' "$TMP/dome.cl"
has "and the clearance plane" 'CLEAR/75.000000$' "$TMP/dome.cl"
has "and what straight lines leave" 'CHORD/0\.[0-9]*[1-9]' "$TMP/dome.cl"
has "the end mark is there" '^FINI$' "$TMP/dome.cl"

status 0 "one way" meshnorm -q -r 5 --rows mesh --one-way --axis-play 0 -o "$TMP/one.cl" "$TMP/dome.ply"
cuts "$TMP/one.cl" | awk '{ if ($1 == last && $8 <= x) bad++; last = $1; x = $8 } END { print bad + 0 }' >"$TMP/figures"
below "all passes go up the columns" "$(cat "$TMP/figures")" 0
cuts "$TMP/one.cl" | cut -d' ' -f8- | sort >"$TMP/one.points"
cut -d' ' -f8- "$TMP/cuts" | sort >"$TMP/zigzag.points"
same "on the same points" "$TMP/one.points" "$TMP/zigzag.points"

meshnorm -q -r 5 --rows mesh --axis-play 0 --tilt 0 --lead 20 "$TMP/dome.ply" >"$TMP/lead.cl"
cuts "$TMP/lead.cl" | awk '{ ahead = ($5 - $11) * ($1 % 2 ? 1 : -1); if (ahead <= 0) bad++ } END { print bad + 0 }' >"$TMP/figures"
below "a lead leans the way the tool feeds" "$(cat "$TMP/figures")" 0
meshnorm -q -r 5 --rows mesh --fixed 0,0,2 "$TMP/dome.ply" >"$TMP/fixed.cl"
has "a fixed axis is the same everywhere" '^GOTO/.*,0.000000000,0.000000000,1.000000000$' "$TMP/fixed.cl"
hasnt "and needs no five axes" "^MULTAX/ON$" "$TMP/fixed.cl"
meshnorm -q -r 5 --rows mesh --axis-play 0 --to-point 10,0,400 "$TMP/dome.ply" >"$TMP/point.cl"
cuts "$TMP/point.cl" | awk '{ s = (400 - $4) / $7; x = $2 + s * $5 - 10; y = $3 + s * $6
	d = sqrt(x * x + y * y); if (d > w) w = d } END { printf "%.6f\n", w }' >"$TMP/figures"
below "the axis goes through a point" "$(cat "$TMP/figures")" 0.00001
status 0 "through a circle" meshnorm -q -r 5 --rows mesh --circle 0,0,300,0,0,1,50 -o "$TMP/circle.cl" "$TMP/dome.ply"
status 0 "away from a point" meshnorm -q -r 5 --rows mesh --from-point 0,0,0 -o "$TMP/from.cl" "$TMP/dome.ply"
status 3 "a shank that would touch is told" meshnorm -r 5 --rows mesh --fixed 1,0,0 --ball-only --lean-limit 0 \
	-o "$TMP/shank.cl" "$TMP/dome.ply"
has "with its area" 'no direction of the axis keeps .* clear at [0-9]+ points, about [0-9.]+ mm2' "$TMP/err"
meshnorm -q -r 5 --rows mesh --fixed 1,0,0 -o "$TMP/shank.cl" "$TMP/dome.ply"
cuts "$TMP/shank.cl" | awk '{ c = $5 * $11 + $6 * $12 + $7 * $13; if (c < 0) bad++ } END { print bad + 0 }' >"$TMP/figures"
below "unless the axis may lean: then it does not" "$(cat "$TMP/figures")" 0

# ---- layers, holes, links

meshnorm -q -r 5 --rows mesh --axis-play 0 --layers 3 --depth 0.5 "$TMP/dome.ply" >"$TMP/layers.cl"
cuts "$TMP/layers.cl" | awk '{ x = $2 + 5 * $5; y = $3 + 5 * $6; z = $4 + 5 * $7
	d = sqrt(x * x + y * y + z * z) - 65; layer = $1 <= 13 ? 1 : $1 <= 26 ? 0.5 : 0
	e = d - layer; if (e < 0) e = -e; if (e > w) w = e } END { printf "%.9f %d\n", w, $1 }' >"$TMP/figures"
read -r off last <"$TMP/figures"
below "layers stand off by their depth, the outermost first" "$off" 0.000002
ok "passes go on counting" test "$last" = 39
dome 0 >"$TMP/hole.ply"
meshnorm -q -r 5 --rows mesh "$TMP/hole.ply" >"$TMP/hole.cl"
ok "a hole breaks a row but not its pass" test "$(grep -c PASS/ "$TMP/hole.cl")" = 13
# rapid moves: the ball stays clear of the dome
awk -F'[/,]' '/^RAPID/ { rapid = 1 } /^GOTO\// { x = $2 + 5 * $5; y = $3 + 5 * $6; z = $4 + 5 * $7
	if (rapid && n) for (k = 0; k <= 50; k++) { s = k / 50
		u = a + s * (x - a); v = b + s * (y - b); w = c + s * (z - c)
		d = sqrt(u * u + v * v + w * w) - 65; if (m == "" || d < m) m = d }
	a = x; b = y; c = z; rapid = 0; n++ } END { print (m > 1 ? 0 : 1) }' "$TMP/hole.cl" >"$TMP/figures"
below "no rapid move comes near the part" "$(cat "$TMP/figures")" 0

# ---- the panel: nodes against the exact surface

cloud2mesh -q -t 4 -o "$TMP/panel.ply" "$panel"
status 0 "the panel" meshnorm -v -r 8 --rows mesh --no-guard --axis-play 0 -o "$TMP/panel.cl" "$TMP/panel.ply"
has "none of its nodes is lifted" ' 0 points lifted' "$TMP/err"
status 0 "with facet normals as in the paper" meshnorm -q -r 8 --paper --normals facet -o "$TMP/paper.cl" "$TMP/panel.ply"

# deepest WHAT PATH OPTION...: how deep the ball goes at the contact points (`nodes`) or anywhere on
# the path (`way`), as the tests' own reader finds it, mm
deepest() {
	case $1 in nodes) what='contact points' ;; *) what='^ball' ;; esac
	shift
	"$READBACK" -c none "$@" | sed -n "/$what: deepest/s/.*deepest \([-0-9.]*\) mm.*/\1/p"
}

below "nodes of the panel" "$(deepest nodes "$TMP/panel.cl" --panel)" 0.005
below "as published they gouge" 0.01 "$(deepest nodes "$TMP/paper.cl" --panel)"
below "but no more than that" "$(deepest nodes "$TMP/paper.cl" --panel)" 0.025
status 0 "the panel with points between" meshnorm -q -r 8 --rows mesh -e 0.01 -o "$TMP/dense.cl" "$TMP/panel.ply"
below "its straight lines" "$(deepest way "$TMP/dense.cl" --panel)" 0.01
cloud2mesh -q -t 4 -o "$TMP/face.ply" "$face"
status 0 "the face as in the paper" meshnorm -q -r 10 --paper -o "$TMP/f0.cl" "$TMP/face.ply"
below "gouges by more than a millimetre" 1 "$(deepest nodes "$TMP/f0.cl" --scan "$face")"
status 0 "the face, guarded by its scan" meshnorm -v -r 10 --rows mesh --avoid -g "$face" -o "$TMP/f1.cl" "$TMP/face.ply"
has "lifts" '[1-9][0-9]* points lifted' "$TMP/err"
below "and does not, anywhere on its way" "$(deepest way "$TMP/f1.cl" --scan "$face")" 0.012
status 3 "what it leaves standing is not accepted" meshnorm -r 10 --rows mesh -j 1 -g "$face" -o "$TMP/f2.cl" "$TMP/face.ply"
has "and told with its pass, depth and place" "leaves material there, worst in pass [0-9]+ [0-9.]+ mm at" "$TMP/err"
same "but the path is the same, on one thread as on all" "$TMP/f1.cl" "$TMP/f2.cl"
status 3 "a lift that is not allowed" meshnorm -r 10 --rows mesh --limit 0.5 -g "$face" -o "$TMP/f3.cl" "$TMP/face.ply"
has "is told with its pass and place" "cannot reach [0-9]+ points.* in pass [0-9]+ by [0-9.]+ mm at" "$TMP/err"
has "and the path is complete" '^FINI$' "$TMP/f3.cl"

# a scan in inches, turned
awk '{ printf "%.6f %.6f %.6f\n", $1 / 25.4, $2 / 25.4, $3 / 25.4 }' "$panel" >"$TMP/inch.xyz"
cloud2mesh -q -u inch -t 4 -o "$TMP/inch.ply" "$TMP/inch.xyz"
status 0 "a scan in inches guards its mesh" meshnorm -r 8 --rows mesh -g "$TMP/inch.xyz" -o "$TMP/inch.cl" "$TMP/inch.ply"
has "and that is said" 'placed as the mesh was' "$TMP/err"
status 1 "a scan that lies elsewhere" meshnorm -r 8 -g "$TMP/inch.xyz" "$TMP/panel.ply"
has "is refused" 'further than .* mm from the scan' "$TMP/err"
empty "and nothing is written" "$TMP/out"

# ---- rows by the scallop, and their direction

status 0 "rows for cusps of 0.05 mm" meshnorm -v -r 5 --scallop 0.05 -o "$TMP/cusp.cl" "$TMP/dome.ply"
cuts "$TMP/cusp.cl" | sort -s -k1,1n >"$TMP/cuts"
# on the dome all rows are circles in planes y = constant; the cusp between two of them on the dome
# at a distance d of their contact points: 8 h R / (1 + R / 60) = d^2
# (the rest passes after them run otherwise)
awk '{ x = $2 + 5 * $5; y = $3 + 5 * $6; z = $4 + 5 * $7
	d = sqrt(x * x + y * y + z * z) - 65; if (d < 0) d = -d; if (d > w) w = d
	if ($1 == last && ($9 - at > 0.01 || at - $9 > 0.01)) rest = 1
	if ($1 != last && !rest && (n == 0 || $9 > at)) { if (n++ && n > 4) { s = 60 * ($9 - at) / sqrt(3600 - $9 * $9)
		if (s > widest) widest = s; if ($9 * $9 < 400 && (narrow == "" || s < narrow)) narrow = s }
		at = $9; last = $1 } }
	END { printf "%.6f %.4f %.4f\n", w, widest, narrow }' "$TMP/cuts" >"$TMP/figures"
read -r off widest narrow <"$TMP/figures"
below "the ball's centre is one radius off the dome" "$off" 0.01
below "rows no further apart than 1.36 mm" "$widest" 1.37
below "and not much nearer" 1.1 "$narrow"

# ---- coverage: what rows leave is cut by rest passes; what they can't is told

# left PATH SCAN R: the most that stays on a point of the scan: its distance from the ball's centre
# on the straight moves at feed, less the radius, mm; and how many points have more than `limit`
left() {
	awk -F'[/, ]' -v r="$3" -v limit="$4" 'NR == FNR { if (/^RAPID/) rapid = 1
			if (/^GOTO/) { x = $2 + r * $5; y = $3 + r * $6; z = $4 + r * $7
				if (n && !rapid) { d = sqrt((x - a) ^ 2 + (y - b) ^ 2 + (z - c) ^ 2); m = int(d / 0.25) + 1
					for (k = 1; k <= m; k++) { u = a + (x - a) * k / m; v = b + (y - b) * k / m
						i = int(u + 500) * 1000 + int(v + 500); p[i, h[i]++] = u " " v " " c + (z - c) * k / m } }
				n++; rapid = 0; a = x; b = y; c = z } next }
		{ best = 1e9; for (i = -r - 1; i <= r + 1; i++) for (j = -r - 1; j <= r + 1; j++) {
				q = (int($1 + 500) + i) * 1000 + int($2 + 500) + j
				for (k = 0; k < h[q]; k++) { split(p[q, k], e, " ")
					d = (e[1] - $1) ^ 2 + (e[2] - $2) ^ 2 + (e[3] - $3) ^ 2; if (d < best) best = d } }
			d = sqrt(best) - r; if (d > worst) worst = d; many += d > limit }
		END { printf "%.4f %d\n", worst, many }' "$1" "$2"
}
# a hill with a flank along x that stands at up to 80 degrees, too steep for rows along x
awk 'BEGIN { for (x = -8; x <= 8; x += 0.25) for (y = -8; y <= 8; y += 0.25)
	printf "%.4f %.4f %.6f\n", x, y, 6 * atan2(y + sin(x / 4), 1) }' >"$TMP/hill.xyz"
cloud2mesh -q -t 2 -o "$TMP/hill.ply" "$TMP/hill.xyz"
status 0 "a steep flank along the rows" meshnorm -v -r 3 -g "$TMP/hill.xyz" -o "$TMP/hill.cl" "$TMP/hill.ply"
has "gets rest passes" 'rest passes: [1-9]' "$TMP/err"
left "$TMP/hill.cl" "$TMP/hill.xyz" 3 0.03 >"$TMP/figures"
below "and is cut everywhere, to scallop and tolerance" "$(cut -d' ' -f1 "$TMP/figures")" 0.032
status 0 "with the rows of the mesh, which promise nothing" meshnorm -r 3 --rows mesh -g "$TMP/hill.xyz" \
	-o "$TMP/hill0.cl" "$TMP/hill.ply"
has "what they leave is told" 'left though within reach: [0-9]+ of [0-9]+ points, [0-9.]+ mm2' "$TMP/err"
left "$TMP/hill0.cl" "$TMP/hill.xyz" 3 0.03 >"$TMP/figures"
below "and is a lot" 500 "$(cut -d' ' -f2 "$TMP/figures")"
# a slot 3 mm wide in a plane: a ball of 3 sinks in by 3 - sqrt(9 - 2.25) and no more
awk 'BEGIN { for (x = -8; x <= 8; x += 0.25) for (y = -8; y <= 8; y += 0.25)
	print x, y, (y > -1.5 && y < 1.5 && x > -5 && x < 5 ? -2 : 0) }' >"$TMP/slot.xyz"
cloud2mesh -q -o "$TMP/slot.ply" "$TMP/slot.xyz"
status 0 "a slot narrower than the ball" meshnorm -r 3 --avoid -g "$TMP/slot.xyz" -o "$TMP/slot.cl" "$TMP/slot.ply"
has "is out of its reach, with the area" 'out of reach of ball and tool: [0-9]+ of 4225 points, [0-9.]+ mm2' "$TMP/err"
sed -n 's/.*points, \([0-9.]*\) mm2, where up to \([0-9.]*\) mm.*/\1 \2/p' "$TMP/err" >"$TMP/figures"
below "of 3 by 10 mm" 22 "$(cut -d' ' -f1 "$TMP/figures")"
below "or so" "$(cut -d' ' -f1 "$TMP/figures")" 45
below "where all but the sag of the ball stays" "$(cut -d' ' -f2 "$TMP/figures")" 2.05
below "or so" 1.59 "$(cut -d' ' -f2 "$TMP/figures")"

# tube BEND: a quarter of a cylinder about x, hollow (-1) or convex (1), radius 20
tube() {
	awk -v bend="$1" 'BEGIN {
		print "ply\nformat ascii 1.0\ncomment cloudmill mesh 1\ncomment spacing 1"
		print "element vertex 1271"
		split("x y z nx ny nz", name, " ")
		for (k = 1; k <= 6; k++) print "property double " name[k]
		print "property int row\nproperty int col"
		print "element face 2400\nproperty list uchar int vertex_indices\nend_header"
		for (j = 0; j <= 30; j++) for (i = 0; i <= 40; i++) {
			a = (j - 15) / 20
			print i, 20 * sin(a), bend * 20 * cos(a), 0, bend * sin(a), cos(a), j, i
		}
		for (j = 0; j < 30; j++) for (i = 0; i < 40; i++) {
			v = 41 * j + i
			print 3, v, v + 1, v + 41
			print 3, v + 1, v + 42, v + 41
		}
	}'
}
tube 1 >"$TMP/convex.ply"
tube -1 >"$TMP/hollow.ply"
status 0 "directions on a convex tube" meshnorm -r 5 --scallop 0.02 --direction auto -o "$TMP/o.cl" "$TMP/convex.ply"
has "across it, or nearly, rows may be further apart" 'planes at (75|90|105) degrees' "$TMP/err"
status 0 "on a hollow one" meshnorm -r 5 --scallop 0.02 --direction auto -o "$TMP/o.cl" "$TMP/hollow.ply"
has "along it" 'planes at 0 degrees' "$TMP/err"
status 0 "planecut finds the same" planecut -r 5 --scallop 0.02 --direction auto -o "$TMP/p.cl" "$TMP/hollow.ply"
has "direction" 'planes at 0 degrees' "$TMP/err"
meshnorm -q -r 5 --scallop 0.02 --direction 90 -o "$TMP/q.cl" "$TMP/hollow.ply"
length() {
	cuts "$1" | awk '{ if ($1 == last) s += sqrt(($2 - x) ^ 2 + ($3 - y) ^ 2 + ($4 - z) ^ 2)
		last = $1; x = $2; y = $3; z = $4 } END { print s }'
}
below "which is shorter than across" "$(length "$TMP/o.cl")" "$(length "$TMP/q.cl")"
status 2 "a direction that is none" meshnorm -r 5 --scallop 0.02 --direction up "$TMP/dome.ply"
status 2 "a direction of the mesh's own rows" meshnorm -r 5 --rows mesh --direction auto "$TMP/dome.ply"
status 2 "a scallop of them" meshnorm -r 5 --rows mesh --scallop 0.02 "$TMP/dome.ply"
status 2 "planes as published" meshnorm -r 5 --rows scallop --paper "$TMP/dome.ply"
status 0 "rows by default" meshnorm -r 5 -o "$TMP/default.cl" "$TMP/dome.ply"
has "are as close as scallops of 0.02 mm ask" 'no higher than 0.02 mm' "$TMP/err"
has "which the head says" '^\$\$-> SCALLOP/0.020000$' "$TMP/default.cl"
meshnorm -q -r 5 --scallop 0.02 -o "$TMP/asked.cl" "$TMP/dome.ply"
same "as if they had been asked for" "$TMP/default.cl" "$TMP/asked.cl"
biarcfit -q -e 0.01 -o "$TMP/arcs.cl" "$TMP/default.cl"
has "and fitters carry it on" '^\$\$-> SCALLOP/0.020000$' "$TMP/arcs.cl"
hasnt "rows of the mesh promise none" 'SCALLOP' "$TMP/dome.cl"
status 2 "a scallop higher than the ball" meshnorm -r 5 --scallop 6 "$TMP/dome.ply"

# ---- calm axes

# fastest PATH: the fastest turn of the axis between points of a pass, degrees for a mm of the tip
fastest() {
	cuts "$1" | awk '{ c = $5 * a + $6 * b + $7 * e; if ($1 == last && n++) {
			s = sqrt(($6 * e - $7 * b) ^ 2 + ($7 * a - $5 * e) ^ 2 + ($5 * b - $6 * a) ^ 2)
			d = sqrt(($2 - x) ^ 2 + ($3 - y) ^ 2 + ($4 - z) ^ 2)
			v = atan2(s, c) * 45 / atan2(1, 1); if (v / d > w) w = v / d; sum += v }
		last = $1; x = $2; y = $3; z = $4; a = $5; b = $6; e = $7 }
		END { printf "%.4f %.1f\n", w, sum }'
}
fastest "$TMP/panel.cl" >"$TMP/figures"
read -r fast _ <"$TMP/figures"
below "by the normals, axes turn faster than 1.5 degrees a mm" 1.5 "$fast"
# rotary PATH: how far a machine with A and C turns them, its angles from the axes alone
rotary() {
	awk -F '[/,]' '/^GOTO/ { r = sqrt($5 * $5 + $6 * $6); a = atan2(r, $7); c = r > 1e-6 ? atan2($6, $5) : last
		if (n++) { d = c - last; while (d > 3.14159265) d -= 6.2831853; while (d < -3.14159265) d += 6.2831853
			if (d < 0) d = -d; e = a > lean ? a - lean : lean - a; f = a + lean + 3.14159265 - d
			sum += d + e < f ? d + e : f }
		last = c; lean = a } END { printf "%.1f\n", sum * 180 / 3.14159265 }' "$1"
}
status 0 "no faster than 0.8" meshnorm -q -r 8 --rows mesh --axis-play 0 --axis-rate 0.8 -o "$TMP/rate.cl" "$TMP/panel.ply"
below "and they don't, on the digits that are printed" "$(fastest "$TMP/rate.cl" | cut -d' ' -f1)" 0.8
below "the ball is where it was" "$(deepest nodes "$TMP/rate.cl" --panel)" 0.005
status 0 "with a play of 10 degrees" meshnorm -q -r 8 --rows mesh --axis-play 10 -o "$TMP/play.cl" "$TMP/panel.ply"
below "rotary axes turn less than half as much" "$(rotary "$TMP/play.cl")" \
	"$(rotary "$TMP/panel.cl" | awk '{ print 0.5 * $1 }')"
cuts "$TMP/play.cl" | awk '{ c = $5 * $11 + $6 * $12 + $7 * $13; a = atan2(sqrt(1 - c * c), c) * 45 / atan2(1, 1)
	if (a > w) w = a } END { print w }' >"$TMP/figures"
below "and are no more than 25 degrees off the normals" "$(cat "$TMP/figures")" 25.0001

# ---- lead and tilt chosen

status 0 "lead and tilt that turn least" meshnorm -r 8 --rows mesh --axis-play 0 --least-turn 25 -o "$TMP/turn.cl" "$TMP/panel.ply"
has "are told" 'lead .* tilt .*rotary axes turn' "$TMP/err"
below "rotary axes turn a quarter less" "$(rotary "$TMP/turn.cl")" \
	"$(rotary "$TMP/panel.cl" | awk '{ print 0.75 * $1 }')"
below "the ball is where it was, whatever the lean" "$(deepest nodes "$TMP/turn.cl" --panel)" 0.005
status 2 "with an axis that is given" meshnorm -r 8 --least-turn 25 --fixed 0,0,1 "$TMP/panel.ply"

# ---- shank and holder: a post beside a floor, and a holder wider than the ball

awk 'BEGIN { for (i = 0; i <= 80; i++) for (j = 0; j <= 40; j++) print i / 2, j / 2, 0
	for (k = 0; k <= 100; k++) for (a = 0; a < 12; a++) print 20 + cos(a * 0.5236), 25 + sin(a * 0.5236), k / 2 }' \
	>"$TMP/post.xyz"
head -n 3321 "$TMP/post.xyz" | cloud2mesh -q -t 2 -o "$TMP/floor.ply" -
status 0 "a path beside the post" meshnorm -q -r 4 --rows mesh --tilt 0 -g "$TMP/post.xyz" -o "$TMP/none.cl" "$TMP/floor.ply"
status 0 "its holder leans away" meshnorm -v -r 4 --rows mesh --tilt 0 --holder 4:25+15:30 --lean-limit 45 \
	-g "$TMP/post.xyz" -o "$TMP/lean.cl" "$TMP/floor.ply"
has "by so much" 'axes at most [1-9][0-9.]* degrees off' "$TMP/err"
# pierced PATH: how deep points of the post are in a cylinder of radius 15 from 25 to 55 mm above
# the ball's centre
pierced() {
	cuts "$1" >"$TMP/cuts"
	awk 'NR == FNR { if (FNR > 3321) { px[n] = $1; py[n] = $2; pz[n++] = $3 } next }
		{ x = $2 + 4 * $5; y = $3 + 4 * $6; z = $4 + 4 * $7
		for (k = 0; k < n; k += 3) { u = px[k] - x; v = py[k] - y; w = pz[k] - z
			h = u * $5 + v * $6 + w * $7; if (h < 25 || h > 55) continue
			d = 15 - sqrt(u * u + v * v + w * w - h * h); if (d > h - 25) d = h - 25
			if (d > deep) deep = d } } END { printf "%.4f\n", deep }' "$TMP/post.xyz" "$TMP/cuts"
}
below "upright it would go through the post" 5 "$(pierced "$TMP/none.cl")"
below "leaned it does not" "$(pierced "$TMP/lean.cl")" 0.0101
status 3 "where it may not lean it is told" meshnorm -r 4 --rows mesh --tilt 0 --holder 4:25+15:30 --lean-limit 0 \
	-g "$TMP/post.xyz" -o "$TMP/held.cl" "$TMP/floor.ply"
has "with its pass and place" 'keeps flute, shank and holder clear at [0-9]+ points, about [0-9.]+ mm2: .*in pass [0-9]+ at' "$TMP/err"
below "and these points are left out" "$(pierced "$TMP/held.cl")" 0.0101
status 0 "or accepted" meshnorm -q -r 4 --rows mesh --tilt 0 --holder 4:25+15:30 --lean-limit 0 --avoid \
	-g "$TMP/post.xyz" -o "$TMP/avoid.cl" "$TMP/floor.ply"
status 0 "the same in planecut" planecut -q -r 4 --tilt 0 -s 2 --holder 4:25+15:30 --lean-limit 45 \
	-g "$TMP/post.xyz" -o "$TMP/plane.cl" "$TMP/floor.ply"
below "which leans too" "$(pierced "$TMP/plane.cl")" 0.0101
status 2 "a holder that is none" meshnorm -r 4 --holder big "$TMP/floor.ply"
has "is told" 'option --holder: found .big' "$TMP/err"

# ---- refusals

status 2 "no radius" meshnorm "$TMP/dome.ply"
status 2 "a radius of zero" meshnorm -r 0 "$TMP/dome.ply"
status 2 "two rules for the axis" meshnorm -r 5 --tilt 10 --fixed 0,0,1 "$TMP/dome.ply"
status 2 "an axis of no length" meshnorm -r 5 --fixed 0,0,0 "$TMP/dome.ply"
status 2 "the paper with a guard" meshnorm -r 5 --paper -g "$panel" "$TMP/dome.ply"
status 2 "two meshes" meshnorm -r 5 "$TMP/dome.ply" "$TMP/dome.ply"
status 2 "a clearance plane inside the part" meshnorm -r 5 --clearance 50 "$TMP/dome.ply"
empty "and nothing is written" "$TMP/out"
dome -1 no >"$TMP/norows.ply"
status 1 "a mesh without rows" meshnorm -r 5 --rows mesh "$TMP/norows.ply"
has "is sent to planecut" 'use planecut' "$TMP/err"
head -c 4000 "$TMP/dome.ply" >"$TMP/half.ply"
status 1 "half a mesh" meshnorm -r 5 "$TMP/half.ply"
empty "and nothing is written" "$TMP/out"
status 1 "a guard that is not there" meshnorm -r 5 -g "$TMP/none.xyz" "$TMP/dome.ply"
if [ -w /dev/full ]; then
	fails "a full disk" sh -c 'meshnorm -q -r 5 --rows mesh "$1" >/dev/full' sh "$TMP/dome.ply"
else
	skip "a full disk" "no /dev/full"
fi

done_testing

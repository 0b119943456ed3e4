#!/bin/sh
# meshnorm-rows.t - figures on the panel and the face, the axis by its rule, order and
# links, refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz
face=$TMP/face.xyz

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
meshnorm -q -r 5 --rows mesh --fixed 1,0,0 --lean-limit 85 -o "$TMP/shank.cl" "$TMP/dome.ply"
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
cloud2mesh -q -t 8 -o "$TMP/wide.ply" "$panel"
status 0 "the panel with points between" \
	meshnorm -q -r 8 --rows mesh -e 0.01 -o "$TMP/dense.cl" "$TMP/wide.ply"
below "its straight lines" "$(deepest way "$TMP/dense.cl" --panel)" 0.01
# of the face, what is about its eyes and its nose
awk '$2 > -30 && $2 < 10' "$SRC/samples/face_nefertiti_26493.xyz" >"$face"
cloud2mesh -q -t 4 -o "$TMP/face.ply" "$face"
status 0 "the face as in the paper" meshnorm -q -r 10 --paper -o "$TMP/f0.cl" "$TMP/face.ply"
below "gouges by more than a millimetre" 1 "$(deepest nodes "$TMP/f0.cl" --scan "$face")"
status 0 "the face, guarded by its scan" meshnorm -v -r 10 --rows mesh --ball-only --avoid -g "$face" -o "$TMP/f1.cl" "$TMP/face.ply"
has "lifts" '[1-9][0-9]* points lifted' "$TMP/err"
below "and does not, anywhere on its way" "$(deepest way "$TMP/f1.cl" --scan "$face")" 0.012
status 3 "what it leaves standing is not accepted" meshnorm -r 10 --rows mesh --ball-only -j 1 -g "$face" -o "$TMP/f2.cl" "$TMP/face.ply"
has "and told with its pass, depth and place" \
	"leaves material there, worst in pass [0-9]+, [0-9.]+ mm at" "$TMP/err"
grep -v '^\$\$-> UNMET/' "$TMP/f2.cl" >"$TMP/f3.cl"
same "but the path is the same, on one thread as on all" "$TMP/f1.cl" "$TMP/f3.cl"
status 3 "a lift that is not allowed" meshnorm -r 10 --rows mesh --ball-only --limit 0.5 -g "$face" -o "$TMP/f3.cl" "$TMP/face.ply"
has "is told with its pass and place" \
	"cannot reach [0-9]+ points of the path.* in pass [0-9]+ by [0-9.]+ mm at" "$TMP/err"
has "and the path is complete" '^FINI$' "$TMP/f3.cl"

# a scan in inches, turned
awk '{ printf "%.6f %.6f %.6f\n", $1 / 25.4, $2 / 25.4, $3 / 25.4 }' "$panel" >"$TMP/inch.xyz"
cloud2mesh -q -u inch -t 8 -o "$TMP/inch.ply" "$TMP/inch.xyz"
status 0 "a scan in inches guards its mesh" meshnorm -r 8 --rows mesh -g "$TMP/inch.xyz" -o "$TMP/inch.cl" "$TMP/inch.ply"
has "and that is said" 'placed as the mesh was' "$TMP/err"
status 1 "a scan that lies elsewhere" meshnorm -r 8 -g "$TMP/inch.xyz" "$TMP/panel.ply"
has "is refused" 'further than .* mm from the scan' "$TMP/err"
empty "and nothing is written" "$TMP/out"

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

#!/bin/sh
# meshnorm-scallop.t - rows by the scallop, what they leave and how it is told, their direction.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

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

dome -1 yes >"$TMP/dome.ply"

# ---- rows by the scallop, and their direction

# facets of 4 mm lie up to 0.04 mm below the dome: who takes them for the part finds that left, too
status 3 "rows for cusps of 0.05 mm" meshnorm -v -r 5 --scallop 0.05 -o "$TMP/cusp.cl" "$TMP/dome.ply"
has "what its facets are below it is told" 'who judges by the facets of the mesh alone' "$TMP/err"
cuts "$TMP/cusp.cl" | sort -s -k1,1n >"$TMP/cuts"
# on the dome all rows are circles in planes y = constant; the cusp between two of them on the dome
# at a distance d of their contact points: 8 h R / (1 + R / 60) = d^2
# (the rest passes after them run otherwise)
awk '{ x = $2 + 5 * $5; y = $3 + 5 * $6; z = $4 + 5 * $7
	if ($1 == last && ($9 - at > 0.01 || at - $9 > 0.01)) rest = 1
	if ($1 != last && n && $9 <= at) rest = 1
	d = sqrt(x * x + y * y + z * z) - 65; if (d < 0) d = -d; if (!rest && d > w) w = d
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
						i = int(u + 500) * 1000 + int(v + 500); px[++all] = u; py[all] = v
						pz[all] = c + (z - c) * k / m; before[all] = last[i]; last[i] = all } }
				n++; rapid = 0; a = x; b = y; c = z } next }
		{ best = 1e9; for (i = -r - 1; i <= r + 1; i++) for (j = -r - 1; j <= r + 1; j++) {
				q = (int($1 + 500) + i) * 1000 + int($2 + 500) + j
				for (k = last[q]; k > 0; k = before[k]) {
					d = (px[k] - $1) ^ 2 + (py[k] - $2) ^ 2 + (pz[k] - $3) ^ 2
                    if (d < best) best = d } }
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
has "what they leave is told" \
	'left though within reach: [0-9]+ of [0-9]+ points .* %, the rows promise no scallop' "$TMP/err"
left "$TMP/hill0.cl" "$TMP/hill.xyz" 3 0.03 >"$TMP/figures"
below "and is a lot" 500 "$(cut -d' ' -f2 "$TMP/figures")"
# centres are lifted where there is room: between the points of a scan, where rows meet, too
waves() { # STEP MARGIN
	awk -v t="$1" -v m="$2" 'BEGIN { for (i = m / t; i <= (30 - m) / t + 1e-6; i++)
		for (j = m / t; j <= (24 - m) / t + 1e-6; j++) { x = i * t; y = j * t
			printf "%.6f %.6f %.6f\n", x, y, 3 * sin(x / 8) * cos(y / 9) + 0.01 * x * y } }'
}
waves 0.5 0 >"$TMP/waves.xyz"
waves 0.1 1.5 >"$TMP/between.xyz"
cloud2mesh -q -t 2 -o "$TMP/waves.ply" "$TMP/waves.xyz"
status 0 "rows over waves" \
	meshnorm -r 8 --scallop 0.02 -g "$TMP/waves.xyz" -o "$TMP/waves.cl" "$TMP/waves.ply"
ncpost -q -c siemens -o "$TMP/waves.mpf" "$TMP/waves.cl"
ncverify -r 8 -g "$TMP/between.xyz" --band 1 "$TMP/waves.mpf" >"$TMP/figures" 2>&1
below "their scallops are no higher where the scan has no points" \
	"$(sed -n 's/^left .*worst \([0-9.]*\) mm.*/\1/p' "$TMP/figures")" 0.0215
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
length() { # of the contacts' way: the tip's depends on what the axis does
	cuts "$1" | awk '{ if ($1 == last) s += sqrt(($8 - x) ^ 2 + ($9 - y) ^ 2 + ($10 - z) ^ 2)
		last = $1; x = $8; y = $9; z = $10 } END { print s }'
}
below "which is shorter than across" "$(length "$TMP/o.cl")" "$(length "$TMP/q.cl")"
status 2 "a direction that is none" meshnorm -r 5 --scallop 0.02 --direction up "$TMP/dome.ply"
status 2 "a direction of the mesh's own rows" meshnorm -r 5 --rows mesh --direction auto "$TMP/dome.ply"
status 2 "a scallop of them" meshnorm -r 5 --rows mesh --scallop 0.02 "$TMP/dome.ply"
status 2 "planes as published" meshnorm -r 5 --rows scallop --paper "$TMP/dome.ply"
status 3 "rows by default" meshnorm -r 5 -o "$TMP/default.cl" "$TMP/dome.ply"
has "are as close as scallops of 0.02 mm ask" 'no higher than 0.02 mm' "$TMP/err"
has "which the head says" '^\$\$-> SCALLOP/0.020000$' "$TMP/default.cl"
meshnorm -q -r 5 --scallop 0.02 -o "$TMP/asked.cl" "$TMP/dome.ply"
same "as if they had been asked for" "$TMP/default.cl" "$TMP/asked.cl"
biarcfit -q -e 0.01 -o "$TMP/arcs.cl" "$TMP/default.cl"
has "and fitters carry it on" '^\$\$-> SCALLOP/0.020000$' "$TMP/arcs.cl"
meshnorm -q -r 5 --rows mesh -o "$TMP/dome.cl" "$TMP/dome.ply"
hasnt "rows of the mesh promise none" 'SCALLOP' "$TMP/dome.cl"
status 2 "a scallop higher than the ball" meshnorm -r 5 --scallop 6 "$TMP/dome.ply"

# ---- a mesh that is farther off its scan than scallop and tolerance: what stays is judged by that

awk 'BEGIN { for (i = 0; i < 20; i++) for (j = 0; j < 20; j++) { c = (3 * i + 1.2 * j) / 14
	print 3 * i, 3 * j, (c - int(c) < 0.5 ? 3 : 0) } }' >"$TMP/steps.xyz"
cloud2mesh -q -o "$TMP/steps.ply" "$TMP/steps.xyz" 2>"$TMP/err"
meshnorm -r 12 --avoid --scallop 0.02 -g "$TMP/steps.xyz" -o "$TMP/steps.cl" "$TMP/steps.ply" \
	2>"$TMP/err"
has "steps that no surface explains" \
	'the mesh is up to 0[.][0-9]* mm off what it is of: so much may stay' "$TMP/err"
meshnorm -r 12 --avoid --scallop 2 -g "$TMP/steps.xyz" -o "$TMP/steps.cl" "$TMP/steps.ply" \
	2>"$TMP/err"
hasnt "nothing is said where the scallops are higher" 'off what it is of' "$TMP/err"

done_testing

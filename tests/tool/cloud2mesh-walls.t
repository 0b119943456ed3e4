#!/bin/sh
# cloud2mesh-walls.t - walls and creases of a scan, from outside, against the exact shapes.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz

# A roof of slope 0.5 and a wall 6 mm high, along a line 12 degrees off y; 7,000 points each, spread
# by a low-discrepancy sequence (Roberts), noise none or 0.02.
shape() {
	LC_ALL=C awk -v kind="$1" -v noise="$2" 'BEGIN {
		c = cos(12 * atan2(0, -1) / 180); s = sin(12 * atan2(0, -1) / 180)
		n = 7000
		for (i = 1; i <= n; i++) {
			u = i * 0.7548776662466927 % 1; v = i * 0.5698402909980532 % 1
			e = noise * (i * 0.3247 % 1 + i * 0.7143 % 1 + i * 0.1379 % 1 - 1.5) * 2
			x = 40 * u - 20; y = 30 * v - 15; d = x * c + y * s
			if (kind == "roof")
				printf "%.4f %.4f %.4f\n", x, y, 12 - 0.5 * (d > 0 ? d : -d) + e
			else
				printf "%.4f %.4f %.4f\n", x, y, (d > 0 ? 6 : 0) + e
		}
		for (i = 1; kind == "wall" && i <= 1000; i++) {
			y = 30 * (i * 0.7548776662466927 % 1) - 15; z = 6 * (i * 0.5698402909980532 % 1)
			printf "%.4f %.4f %.4f\n", -y * s / c + e * c, y + e * s, z
		}
	}'
}

# The largest distance of places on all facets from the shape, and of places on its edges from the
# nearest one of them: "off edge".
measure() {
	awk -v kind="$1" 'function least(a, b) { return a < b ? a : b }
	function off(x, y, z,   d, low, high, wall, w) {
		d = x * c + y * s
		if (kind == "roof")
			return (z - 12 + 0.5 * (d > 0 ? d : -d)) / sqrt(1.25)
		low = sqrt((d > 0 ? d * d : 0) + z * z)
		high = sqrt((d < 0 ? d * d : 0) + (z - 6) * (z - 6))
		w = z < 0 ? z : z > 6 ? z - 6 : 0
		wall = sqrt(d * d + w * w)
		return least(wall, least(low, high))
	}
	BEGIN { c = cos(12 * atan2(0, -1) / 180); s = sin(12 * atan2(0, -1) / 180) }
	/^element vertex/ { n = $3 }
	/^end_header/ { from = NR; next }
	from && NR <= from + n { k = NR - from - 1; X[k] = $1; Y[k] = $2; Z[k] = $3 }
	from && NR > from + n {
		for (i = 0; i <= 6; i++)
			for (j = 0; j <= 6 - i; j++) {
				a = i / 6; b = j / 6
				x = a * X[$2] + b * X[$3] + (1 - a - b) * X[$4]
				y = a * Y[$2] + b * Y[$3] + (1 - a - b) * Y[$4]
				z = a * Z[$2] + b * Z[$3] + (1 - a - b) * Z[$4]
				d = off(x, y, z); d = d < 0 ? -d : d; worst = d > worst ? d : worst
				d = x * c + y * s
				if (d * d > 0.04) continue
				t = -x * s + y * c
				for (edge = kind == "roof" ? 12 : 0; edge <= 12; edge += kind == "roof" ? 1 : 6) {
					if (kind == "wall" && edge == 12) break
					h = (z - edge) * (z - edge) + d * d
					if (h < 0.04) seen[edge, int((t + 13) / 0.2)] = 1
				}
			}
	}
	END {
		gaps = 0
		for (edge = kind == "roof" ? 12 : 0; edge <= 12; edge += 6)
			for (i = 0; i < 130 && !(kind == "wall" && edge == 12); i++)
				gaps += !((edge, i) in seen)
		printf "off %.4f gaps %d\n", worst, gaps
	}' "$2"
}

for kind in roof wall; do
	for noise in 0 0.02; do
		shape $kind $noise >"$TMP/$kind.xyz"
		ok "$kind, noise $noise: a mesh" cloud2mesh --nodes scan -v "$TMP/$kind.xyz" -o "$TMP/$kind.ply"
		measure $kind "$TMP/$kind.ply" >"$TMP/off"
		below "$kind, noise $noise: within 0.1 mm" "$(awk '{ print $2 }' "$TMP/off")" 0.1
		has "$kind, noise $noise: its edges are there from end to end" 'gaps 0$' "$TMP/off"
		cloud2mesh --nodes scan -q --no-features "$TMP/$kind.xyz" -o "$TMP/smooth.ply"
		below "$kind: --no-features leaves more" 0.2 "$(measure $kind "$TMP/smooth.ply" | awk '{ print $2 }')"
	done
done

# From an error: fewer vertices than the grid, the edges as sharp, and what is said of it is true of
# walls too.
for kind in roof wall; do
	for noise in 0 0.02; do
		shape $kind $noise >"$TMP/$kind.xyz"
		ok "$kind, noise $noise: within 0.05 mm" cloud2mesh --nodes scan -v -e 0.05 "$TMP/$kind.xyz" -o "$TMP/$kind.ply"
		has "it has said so" 'within 0\.0[0-4][0-9]* mm of the mesh' "$TMP/err"
		measure $kind "$TMP/$kind.ply" >"$TMP/off"
		below "$kind, noise $noise: within 0.1 mm of the shape" "$(awk '{ print $2 }' "$TMP/off")" 0.1
		has "$kind, noise $noise: all of its edges" 'gaps 0$' "$TMP/off"
	done
	# by then the noise is out of all points: only vertices beside an edge are moved once more
	beside=$(sed -n 's/.*: [0-9]* of \([0-9]*\) vertices moved.*/\1/p' "$TMP/err" | tail -n 1)
	below "$kind: few vertices are beside its edges" "$((2 * beside))" \
		"$(sed -n 's/^element vertex //p' "$TMP/$kind.ply")"
	# nor are points beside an edge moved, where the scan itself counts
	away=$(sed -n 's/.*: [0-9]* of \([0-9]*\) vertices moved.*/\1/p' "$TMP/err" | head -n 1)
	below "$kind: points beside its edges are not moved" "$((away + 100))" "$(wc -l <"$TMP/$kind.xyz")"
done

# The rows go over it, and the ball stays clear of all points.
for kind in roof wall; do
	shape $kind 0 >"$TMP/$kind.xyz"
	cloud2mesh --nodes scan -q "$TMP/$kind.xyz" -o "$TMP/$kind.ply"
	ok "$kind: a path" meshnorm -q -r 3 --rows mesh --avoid -g "$TMP/$kind.xyz" "$TMP/$kind.ply" -o "$TMP/$kind.cl"
	ncpost -q -c siemens "$TMP/$kind.cl" -o "$TMP/$kind.mpf"
	ok "$kind: no gouge" ncverify --ball-only -r 3 -g "$TMP/$kind.xyz" "$TMP/$kind.mpf"
done

# A rib 0.8 mm high and about 1 mm wide under noise of 0.02 mm: smoothing leaves it as high as it is,
# along its whole length.
rib() {
	LC_ALL=C awk -v noise="$1" 'BEGIN {
		c = cos(25 * atan2(0, -1) / 180); s = sin(25 * atan2(0, -1) / 180)
		for (i = 1; i <= 20000; i++) {
			x = 28 * (i * 0.7548776662466927 % 1) - 14; y = 28 * (i * 0.5698402909980532 % 1) - 14
			e = noise * (i * 0.3247 % 1 + i * 0.7143 % 1 + i * 0.1379 % 1 - 1.5) * 2
			d = (x * c + y * s - 1) / 0.6
			printf "%.4f %.4f %.4f\n", x, y, 5 - 0.005 * (x * x + y * y) + 0.8 * exp(-d * d) + e
		}
	}'
}
# How high the facets stand over the crest: the least of the highest in each half millimetre.
kept() {
	LC_ALL=C awk 'BEGIN { c = cos(25 * atan2(0, -1) / 180); s = sin(25 * atan2(0, -1) / 180) }
	/^element vertex/ { n = $3 }
	/^end_header/ { from = NR; next }
	from && NR <= from + n { k = NR - from - 1; X[k] = $1; Y[k] = $2; Z[k] = $3 }
	from && NR > from + n {
		for (i = 0; i <= 8; i++)
			for (j = 0; j <= 8 - i; j++) {
				a = i / 8; b = j / 8
				x = a * X[$2] + b * X[$3] + (1 - a - b) * X[$4]
				y = a * Y[$2] + b * Y[$3] + (1 - a - b) * Y[$4]
				d = x * c + y * s - 1; t = int((y * c - x * s + 20) * 2)
				if (d * d > 0.09 || t < 18 || t > 62) continue
				h = a * Z[$2] + b * Z[$3] + (1 - a - b) * Z[$4] - 5 + 0.005 * (x * x + y * y)
				top[t] = h > top[t] ? h : top[t]
			}
	}
	END { least = 1; for (t = 18; t <= 62; t++) least = top[t] < least ? top[t] : least; print least }' "$1"
}
for noise in 0 0.02; do
	rib $noise >"$TMP/rib.xyz"
	ok "rib, noise $noise: within 0.05 mm" cloud2mesh --nodes scan -v -e 0.05 "$TMP/rib.xyz" -o "$TMP/rib.ply"
	has "rib, noise $noise: by points between the rows alone" 'ribs and grooves 0$' "$TMP/err"
	below "rib, noise $noise: all of it is kept" 0.74 "$(kept "$TMP/rib.ply")"
	cloud2mesh --nodes scan -q "$TMP/rib.xyz" -o "$TMP/rib.ply"
	below "rib, noise $noise: by a grid too" 0.74 "$(kept "$TMP/rib.ply")"
done

# A face has steep flanks and jumps under the chin, and no wall: no normal more points down than
# without the search, and the job comes to a program on both controls.
face=$SRC/samples/face_nefertiti_26493.xyz
down() {
	awk '/^element vertex/ { n = $3 } /^end_header/ { from = NR }
		from && NR > from && NR <= from + n && $6 < 0.1 { down++ } END { print down + 0 }' "$1"
}
cloud2mesh --nodes scan -q -t 2 "$face" -o "$TMP/face.ply"
cloud2mesh --nodes scan -q -t 2 --no-features "$face" -o "$TMP/smooth.ply"
below "face: normals that point aside or down" "$(down "$TMP/face.ply")" "$(down "$TMP/smooth.ply")"
below "face: none points down" "$(awk '/^element vertex/ { n = $3 } /^end_header/ { from = NR }
	from && NR > from && NR <= from + n && $6 < 0 { d++ } END { print d + 0 }' "$TMP/face.ply")" 0
ok "face: a path" meshnorm -q -r 5 --rows mesh --avoid -g "$face" "$TMP/face.ply" -o "$TMP/face.cl"
for control in fanuc siemens; do
	ok "face: a program for $control" ncpost -q -c $control "$TMP/face.cl" -o "$TMP/face.nc"
done

# Nothing is found where there is nothing, and the same whatever the threads.
cloud2mesh --nodes scan -v -t 4 "$panel" -o "$TMP/panel.ply" 2>"$TMP/err"
has "panel: no creases" 'creases cross 0 edges of the mesh, walls 0' "$TMP/err"
cloud2mesh --nodes scan -q --no-features -t 4 "$panel" -o "$TMP/smooth.ply"
same "panel: as with --no-features" "$TMP/smooth.ply" "$TMP/panel.ply"
cloud2mesh --nodes scan -q -j 1 "$TMP/wall.xyz" -o "$TMP/one.ply"
cloud2mesh --nodes scan -q -j 5 "$TMP/wall.xyz" -o "$TMP/five.ply"
same "wall: the same for any number of threads" "$TMP/one.ply" "$TMP/five.ply"

done_testing

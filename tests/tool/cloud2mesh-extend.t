#!/bin/sh
# cloud2mesh-extend.t - rows run out over the border along the surface, and the ball stays clear.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A square cap of a sphere of 60 mm, 40 mm wide, 7,000 points, with a hole of 6 mm radius.
LC_ALL=C awk 'BEGIN {
	for (i = 1; i <= 7000; i++) {
		x = 40 * (i * 0.7548776662466927 % 1) - 20; y = 40 * (i * 0.5698402909980532 % 1) - 20
		if (x * x + y * y > 36)
			printf "%.4f %.4f %.4f\n", x, y, sqrt(3600 - x * x - y * y)
	}
}' >"$TMP/cap.xyz"

# The furthest out of the vertices, the largest distance of any from the sphere, those in the hole.
figures() {
	awk '/^element vertex/ { n = $3 } /^end_header/ { from = NR }
		from && NR > from && NR <= from + n {
			o = $1 > $2 ? $1 : $2; if (o > out) out = o
			d = sqrt($1 * $1 + $2 * $2 + $3 * $3) - 60; d = d < 0 ? -d : d; if (d > off) off = d
			if ($1 * $1 + $2 * $2 < 30) hole++
		}
		END { printf "%.3f %.4f %d\n", out - 20, off, hole }' "$1"
}

ok "a mesh with its border extended by 2 mm" cloud2mesh --extend 2 "$TMP/cap.xyz" -o "$TMP/cap.ply"
has "which the mesh says" "^comment extended 2" "$TMP/cap.ply"
has "what was added is said" 'extended by 2 mm beyond the border, by [1-9][0-9]* points' "$TMP/err"
figures "$TMP/cap.ply" >"$TMP/figures"
below "rows run out" 1.2 "$(cut -d' ' -f1 "$TMP/figures")"
below "no further than asked for" "$(cut -d' ' -f1 "$TMP/figures")" 2
below "along the sphere" "$(cut -d' ' -f2 "$TMP/figures")" 0.03
has "the hole stays open" ' 0$' "$TMP/figures"

ok "a path" meshnorm -q -r 5 --rows mesh -g "$TMP/cap.xyz" "$TMP/cap.ply" -o "$TMP/cap.cl"
ncpost -q -c siemens "$TMP/cap.cl" -o "$TMP/cap.mpf"
ok "no gouge" ncverify -r 5 -g "$TMP/cap.xyz" "$TMP/cap.mpf"

# A small scan extended by nearly its own width: most of the mesh is far from the scan for the ball,
# and it is this scan nevertheless; not where another one is given.
cd "$TMP" || exit 1
awk 'BEGIN { for (i = 0; i < 12; i++) for (j = 0; j < 12; j++)
	print i / 2, j / 2, i * j / 100 }' >small.xyz
awk '{ print $1 - 7, $2 - 7, $3 }' small.xyz >beside.xyz
cloud2mesh -q --extend 5.4 -t 0.8 -o small.ply small.xyz
for tool in "planecut -r 0.5 -s 0.3" "meshnorm -r 1"; do
	status 0 "${tool%% *}: a mesh that is mostly beyond its scan" $tool -q -o small.cl small.ply
	status 0 "${tool%% *}: the scan given" $tool -q -g small.xyz -o given.cl small.ply
	for fit in biarcfit bsplfit; do
		status 0 "$fit takes the path of ${tool%% *}" $fit -q -o small.fit small.cl
	done
	status 1 "${tool%% *}: another scan" $tool -q -g beside.xyz small.ply
	has "is told" 'beside.xyz: found [0-9]+ of [0-9]+ mesh vertices further than' err
done
awk '/end_header/ { body = 1; print; next }
	body && NF > 4 { $1 += 30 } { print }' small.ply >moved.ply
status 1 "its own scan, and a mesh that was moved since" planecut -q -r 0.5 -s 0.3 moved.ply
has "is told" 'small.xyz: found [0-9]+ of [0-9]+ mesh vertices further than' err

status 2 "not with --paper" cloud2mesh --extend 2 --paper "$TMP/cap.xyz"
status 2 "not with --subdivide" cloud2mesh --extend 2 --subdivide "$TMP/cap.xyz"
status 2 "a length, not none" cloud2mesh --extend 0 "$TMP/cap.xyz"

done_testing

#!/bin/sh
# cloud2mesh-subdivide.t - the whole of a half-ball in 5 axes, judged by the program that comes of
# it.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz

# A ball of radius R down to z = LOW, n points by the golden angle, their places shaken so that they
# are no pattern; noise along the normal.
ball() { # R LOW N NOISE
	LC_ALL=C awk -v R="$1" -v low="$2" -v n="$3" -v noise="$4" 'BEGIN {
		for (i = 0; i < n; i++) {
			z = low + (R - low) * (i + i * 0.7548776662466927 % 1) / n
			a = i * 2.399963 + i * 0.5698402909980532 % 1 * 0.05; r = sqrt(R * R - z * z)
			k = 1 + noise * (i * 0.3247 % 1 + i * 0.7143 % 1 + i * 0.1379 % 1 - 1.5) * 2 / R
			printf "%.4f %.4f %.4f\n", k * r * cos(a), k * r * sin(a), k * z
		}
	}'
}

# What the verdict says: worst gouge, worst left, whether all points are cut or out of reach.
figures() {
	awk '/^coverage +left/ { whole = $3 == 0 ? "whole" : "part" } /^gouge +worst/ { g = $3 }
		/^left +worst/ { l = $3 } END { print g, l, whole }' "$1"
}

judge() { # DESC R GOUGE LEFT
	ncpost -q -c siemens -m table-ac "$TMP/ball.cl" -o "$TMP/ball.mpf"
	run ncverify -r "$2" -m table-ac -g "$TMP/ball.xyz" "$TMP/ball.mpf"
	figures "$TMP/out" >"$TMP/figures"
	has "$1: all of it is judged" 'whole$' "$TMP/figures"
	below "$1: no gouge" "$(awk '{ print $1 }' "$TMP/figures")" "$3"
	below "$1: nothing left standing" "$(awk '{ print $2 }' "$TMP/figures")" "$4"
}

ball 4 0 9000 0 >"$TMP/ball.xyz"
ok "half-ball: a mesh" cloud2mesh --subdivide "$TMP/ball.xyz" -o "$TMP/ball.ply"
has "it is divided" 'divided into [5-9] parts' "$TMP/err"
has "its parts are in the head" '^comment part [1-9][0-9]* ' "$TMP/ball.ply"
ok "half-ball: a path" meshnorm -r 3 --rows mesh -g "$TMP/ball.xyz" "$TMP/ball.ply" -o "$TMP/ball.cl"
judge "half-ball" 3 0.015 0.03
ok "rows by a scallop in each of the parts" meshnorm -r 3 -g "$TMP/ball.xyz" --scallop 0.01 \
	"$TMP/ball.ply" -o "$TMP/ball.cl"
judge "half-ball by a scallop" 3 0.012 0.05

ball 5 -1 9000 0.005 >"$TMP/ball.xyz"
ok "beyond the equator, noise: a mesh" cloud2mesh --nodes scan --subdivide "$TMP/ball.xyz" \
	-o "$TMP/ball.ply"
grep '^cloud2mesh: noise ' "$TMP/err" >"$TMP/noise"
ok "noise is said of all parts at once" test "$(wc -l <"$TMP/noise")" -eq 1
has "with the least and the most of them" \
	'in [5-9] parts [0-9]* of .* to within 0\.00[0-9]* to 0\.00[0-9]* mm' "$TMP/noise"
vertices=$(sed -n 's/^element vertex //p' "$TMP/ball.ply")
moved=$(sed 's/.* parts \([0-9]*\) of .*/\1/' "$TMP/noise")
ok "and their vertices are summed" test "$moved" -gt $((vertices / 2))
ok "beyond the equator, noise: a path" meshnorm -r 2 --rows mesh -g "$TMP/ball.xyz" "$TMP/ball.ply" -o "$TMP/ball.cl"
judge "beyond the equator" 2 0.03 0.05

ball 5 -2.5 12000 0 >"$TMP/deep.xyz"
cloud2mesh --nodes scan -q --subdivide "$TMP/deep.xyz" -o "$TMP/deep.ply"
ok "30 degrees under the equator: a path" meshnorm -r 2 --rows mesh -g "$TMP/deep.xyz" "$TMP/deep.ply" -o "$TMP/deep.cl"
hasnt "nothing out of reach" "cannot reach" "$TMP/err"
ncpost -q -c siemens -m table-ac "$TMP/deep.cl" -o "$TMP/ball.mpf"
run ncverify -r 2 -m table-ac -g "$TMP/deep.xyz" "$TMP/ball.mpf"
figures "$TMP/out" >"$TMP/figures"
has "under the equator: all of it is judged" 'whole$' "$TMP/figures"
below "under the equator: no gouge" "$(awk '{ print $1 }' "$TMP/figures")" 0.015
below "under the equator: nothing left standing" "$(awk '{ print $2 }' "$TMP/figures")" 0.06

# A box of 20 x 16 x 10 mm, its walls 5 degrees off upright; random points (a linear congruence).
LC_ALL=C awk 'function u() { s = (s * 16807) % 2147483647; return s / 2147483647 }
	BEGIN {
		s = 4711 + 7919 * ENVIRON["SEED"]; k = 0.0874887
		for (i = 0; i < 9000; i++) {
			a = u() * 2 - 1; b = u() * 2 - 1; z = 10 * u(); f = u() * 1040
			x = 10 + (10 - z) * k; y = 8 + (10 - z) * k
			if (f < 320) print a * 10, b * 8, 10
			else if (f < 520) print a * x, y, z
			else if (f < 720) print a * x, -y, z
			else if (f < 880) print x, b * y, z
			else print -x, b * y, z
		}
	}' >"$TMP/box.xyz"
ok "a box: a mesh" cloud2mesh --subdivide -t 1 "$TMP/box.xyz" -o "$TMP/box.ply"
has "a part for each of its sides" 'divided into 5 parts' "$TMP/err"
hasnt "no word of points in none" 'belong to no part' "$TMP/err"
ok "the box: a path" meshnorm -r 3 --rows mesh -g "$TMP/box.xyz" "$TMP/box.ply" -o "$TMP/ball.cl" --avoid
ncpost -q -c siemens -m table-ac "$TMP/ball.cl" -o "$TMP/box.mpf"
# judged by points on its edges too, which the scan has none of
LC_ALL=C awk 'BEGIN {
	k = 0.0874887
	for (i = -40; i <= 40; i++) { print i / 4, 8, 10; print i / 4, -8, 10
		print 10, i / 5, 10; print -10, i / 5, 10 }
	for (z = 1; z < 10; z += 0.25) for (a = -1; a < 2; a += 2) for (b = -1; b < 2; b += 2)
		print a * (10 + (10 - z) * k), b * (8 + (10 - z) * k), z
	}' >"$TMP/edges.xyz"
run ncverify -r 3 -m table-ac --left 0.1 -g "$TMP/box.xyz" "$TMP/box.mpf"
figures "$TMP/out" >"$TMP/figures"
# rows of the mesh promise nothing: beside an edge, from which the guard goes on, a few points may
below "the box: all of it is judged" "$(awk '/^coverage +left/ { print $3 }' "$TMP/out")" 9
below "the box: no gouge" "$(awk '{ print $1 }' "$TMP/figures")" 0.012
run ncverify -r 3 -m table-ac -g "$TMP/edges.xyz" "$TMP/box.mpf"
figures "$TMP/out" >"$TMP/figures"
below "the edges of the box: no gouge" "$(awk '{ print $1 }' "$TMP/figures")" 0.04
below "the edges of the box: nothing left standing" "$(awk '{ print $2 }' "$TMP/figures")" 0.1

cloud2mesh --nodes scan -q -j 1 --subdivide "$TMP/ball.xyz" -o "$TMP/one.ply"
same "the same for any number of threads" "$TMP/one.ply" "$TMP/ball.ply"

ok "without it" cloud2mesh "$TMP/ball.xyz" -o "$TMP/flat.ply"
has "steep parts are said" '% of the surface is steeper than 70 degrees' "$TMP/err"
cloud2mesh "$panel" -o "$TMP/flat.ply" 2>"$TMP/err"
hasnt "but not on the panel" 'steeper' "$TMP/err"
cloud2mesh --nodes scan -q --subdivide -t 4 "$panel" -o "$TMP/parts.ply"
has "and one part serves it" '^comment part 0 1' "$TMP/parts.ply"
hasnt "alone" '^comment part [1-9]' "$TMP/parts.ply"

sed 's/^comment part .*/comment part 0 1 0 0 1 0/' "$TMP/parts.ply" >"$TMP/bad.ply"
status 1 "a part with six numbers" meshnorm -r 3 "$TMP/bad.ply"
sed 's/^comment part .*/comment part 0 1 0 0 1 0 0/' "$TMP/parts.ply" >"$TMP/bad.ply"
status 1 "directions that are not perpendicular" meshnorm -r 3 "$TMP/bad.ply"

done_testing

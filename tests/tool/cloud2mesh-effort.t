#!/bin/sh
# cloud2mesh-effort.t - --effort, what is left out of a large scan: told where it binds, with the
# effort that leaves nothing out; and with that effort the result of a search without bounds.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# Roofs side by side, a rib across them and a wall at the end; noise none or 0.02.
shape() {
	LC_ALL=C awk -v noise="$1" 'function u() { seed = seed * 16807 % 2147483647; return seed / 2147483647 }
	BEGIN {
		seed = 7 + 7919 * ENVIRON["SEED"]
		for (i = 1; i <= 9000; i++) {
			x = 24 * (i * 0.7548776662466927 % 1); y = 24 * (i * 0.5698402909980532 % 1)
			e = noise * (u() + u() + u() - 1.5) * 2
			r = (x - 5) / 0.6; d = x % 8 - 4
			printf "%.4f %.4f %.4f\n", x, y, (x < 8 ? 0.8 * exp(-r * r) : 2 - 0.5 * (d > 0 ? d : -d)) + e
		}
		for (i = 1; i <= 9000; i++) {
			x = 24 + 8 * (i * 0.7548776662466927 % 1); y = 24 * (i * 0.5698402909980532 % 1)
			e = noise * (u() + u() + u() - 1.5) * 2
			if (i <= 3000)
				printf "%.4f %.4f %.4f\n", x, y, 6 + e
			else if (i <= 4500)
				printf "%.4f %.4f %.4f\n", 24 + e, y, 6 * (i * 0.7548776662466927 % 1)
		}
	}'
}

# enough FILE OPTIONS: raises the effort as it is told to until nothing is left out; $effort
enough() {
	effort=$1
	shift
	for _ in 1 2 3 4 5 6; do
		cloud2mesh --effort "$effort" "$@" -o "$TMP/enough.ply" 2>"$TMP/err"
		next=$(sed -n 's/.*--effort \([0-9.e-]*\) covers all.*/\1/p' "$TMP/err" | sort -g | tail -n 1)
		[ -n "$next" ] || return
		effort=$next
	done
}

for noise in 0 0.02; do
	scan=$TMP/scan$noise.xyz
	shape $noise >"$scan"
	cloud2mesh -q --effort 1000000 -o "$TMP/all.ply" "$scan"
	ok "noise $noise: with little effort" cloud2mesh --effort 0.0001 -o "$TMP/little.ply" "$scan"
	cp "$TMP/err" "$TMP/said$noise"
	has "it says what it leaves out" 'edges that may cross a crease, more than 1: they are not checked; --effort [0-9.]* covers all' "$TMP/err"
	has "and of ribs" 'ribs are detected only where it bends; --effort' "$TMP/err"
	ok "and the mesh is another one" test "$(cksum <"$TMP/little.ply")" != "$(cksum <"$TMP/all.ply")"
	enough 0.0001 "$scan"
	below "the effort it asks for is not without bounds" "$effort" 100
	hasnt "with it nothing is left out" 'covers all' "$TMP/err"
	same "and the mesh is that of a search without bounds" "$TMP/all.ply" "$TMP/enough.ply"
done
has "where there is noise, of what is fitted along ribs" 'no surface is fitted along ribs and grooves; --effort' "$TMP/said0.02"
has "and of how many points surfaces go through" 'surfaces are fitted to fewer; --effort' "$TMP/said0.02"

# A scan that guards: its noise stays in, and points that are far apart get none between.
awk '$1 < 8' "$TMP/scan0.02.xyz" >"$TMP/rib.xyz"
cloud2mesh --nodes scan -q -o "$TMP/mesh.ply" "$TMP/rib.xyz"
ok "meshnorm says that too" meshnorm -r 2 --rows mesh --avoid --effort 0.001 -g "$TMP/rib.xyz" -o "$TMP/path.cl" "$TMP/mesh.ply"
has "of the noise" 'points of the scan, more than 400: their noise is not removed; --effort 0.0[0-9]* covers all' "$TMP/err"
status 2 "an effort of nothing" cloud2mesh --effort 0 "$TMP/scan0.xyz"
done_testing

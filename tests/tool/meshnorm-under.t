#!/bin/sh
# meshnorm-under.t - a scan is a shell, and what is under it is material: no path leads there, and a
# program that does is refused, with its block and the place.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A plate with a hole narrower than the ball; only its top and the hole's floor are seen.
awk 'BEGIN { for (j = -20; j <= 20; j++) for (i = -20; i <= 20; i++) {
		x = i / 2; y = j / 2; printf "%.3f %.3f %.3f\n", x, y, x * x + y * y < 2.25 ? -10 : 0 } }' >hole.xyz
ok "a mesh" cloud2mesh -q -o hole.ply hole.xyz

# deepest RADIUS PATH: of all places of the ball's centre, half a millimetre apart, how far the
# deepest is under the plate's level where the plate's border is at least a millimetre off
deepest() {
	awk -F '[/,]' -v r="$1" '$1 == "GOTO" {
		x = $2 + r * $5; y = $3 + r * $6; z = $4 + r * $7
		n = begun++ ? int(2 * sqrt((x - a) ^ 2 + (y - b) ^ 2 + (z - c) ^ 2)) + 1 : 1
		for (k = 1; k <= n; k++) {
			u = a + (x - a) * k / n; v = b + (y - b) * k / n; w = c + (z - c) * k / n
			if (u > -9 && u < 9 && v > -9 && v < 9 && -w > most) most = -w }
		a = x; b = y; c = z } END { print most + 0 }' "$2"
}
for r in 3 5; do
	status 0 "R $r: a path" meshnorm -q -r $r --avoid -o hole.cl hole.ply
	below "R $r: never under the plate" "$(deepest $r hole.cl)" 0.001
	status 0 "R $r: fitted" biarcfit -q -e 0.01 -o fitted.cl hole.cl
	ok "R $r: a program" ncpost -q -c siemens -o hole.mpf fitted.cl
	status 0 "R $r: accepted" ncverify -g hole.xyz -r $r -e 0.012 hole.mpf
	hasnt "R $r: nothing under the scan" 'under the scan' "$TMP/err"
done

# under Z: a program that goes from beside the plate to its middle, the tool level and its tip at Z
under() {
	printf '%s\n' '%_N_UNDER_MPF' 'N10 G90 G17 G71 G40 G94 G54' 'N15 SUPA G0 Z0 D0' 'N20 T="BALL" D1 M6' \
		'N30 S8000 M3' 'N40 TRAORI' 'N50 ORIWKS ORIAXES' 'N55 G0 A90 C90' "N60 G0 X30 Y5 Z60" \
		"N65 G0 X30 Y5 Z$1" "N70 G1 X20 Y5 Z$1 A90 C90 F800" "N80 G1 X4 Y5 Z$1" "N90 G0 X30 Y5 Z$1" \
		'N100 TRAFOOF' 'N105 SUPA G0 Z0 D0' 'N110 M5' 'N120 M30'
}
under -6 >under.mpf
status 3 "a program that goes under the plate" ncverify -g hole.xyz -r 3 -e 0.01 --partial under.mpf
has "is refused in a block, with depth and place" \
	'N[89]0 .*the (ball|shaft) goes (2\.[5-9]|3\.0)[0-9]* mm deep under the scan at [0-9.]+ [0-9.]+ -6\.000' "$TMP/err"
under 3.01 >over.mpf
ncverify -g hole.xyz -r 3 -e 0.01 --partial over.mpf >"$TMP/out" 2>"$TMP/err"
hasnt "one that goes over it is not" 'under the scan' "$TMP/err"

# Below its lowest point a scan knows of nothing, but under what faces up there is the part.
awk '$3 > -1' hole.xyz >low.xyz
under -6 >under.mpf
status 3 "a program that goes under the lowest point" \
	ncverify -g low.xyz -r 3 -e 0.01 --partial under.mpf
has "is refused, too" \
	'N[89]0 .*the (ball|shaft) goes [23]\.[0-9]* mm deep under the scan' "$TMP/err"

# A rib 2 mm high, up to the border, on a plate scanned in lines: beside it, on the last line, a
# ball has room from below alone.
awk 'BEGIN { for (l = -12; l <= 12; l++) for (k = -48; k <= 48; k++) {
	x = k / 4 + 0.12 * sin(7.3 * k + 3.1 * l + 2); y = l + 0.09 * sin(5.7 * k + 1.7 * l + 4)
	d = 0.93969 * x + 0.34202 * y
	printf "%.4f %.4f %.4f\n", x, y, (d > -0.4 && d < 0.4) ? 2 : 0 } }' >rib.xyz
ok "a rib" cloud2mesh -q -t 2 -o rib.ply rib.xyz
status 0 "a path over it" meshnorm -q -r 2.5 --avoid -o rib.cl rib.ply
below "from above" "$(awk -F'[/,]' '$1 == "GOTO" { z = -$4 - 2.5 * $7; if (z > most) most = z }
	END { print most + 0 }' rib.cl)" 0.001
ok "is fitted" biarcfit -q -e 0.01 -o ribs.cl rib.cl
ok "is a program" ncpost -q -c siemens -o rib.mpf ribs.cl
status 0 "that is accepted" ncverify -q -g rib.xyz -r 2.5 rib.mpf

# A hole of 20 mm, half of its wall scanned: an axis that leans from below the plate onto the wall
# would have the shaft under the other side, 10 mm below the lowest point.
awk 'BEGIN { for (j = -34; j <= 34; j++) for (i = -34; i <= 34; i++) {
		x = 0.7 * i + 0.1 * sin(7.3 * i + 3.1 * j); y = 0.7 * j + 0.1 * sin(5.7 * i + 1.7 * j)
		if (x * x + y * y > 104) printf "%.4f %.4f %.4f\n", x, y, 0.2 * cos(x / 4)
	}
	for (a = 1.7; a < 4.6; a += 0.06) for (z = -0.3; z > -2.6; z -= 0.5) {
		r = 10 + 0.12 * z
		printf "%.4f %.4f %.4f\n", r * cos(a), r * sin(a), z
	} }' >cellar.xyz
ok "a plate with a hole" cloud2mesh -q -o cellar.ply cellar.xyz
status 3 "a path whose axis leans below it" \
	meshnorm -q -r 3 --fixed 0.9,0,-0.44 --avoid -o cellar.cl cellar.ply
has "cuts the wall" '^GOTO' cellar.cl
status 3 "is a program" ncpost -q -c fanuc -o cellar.nc cellar.cl
ncverify --partial -g cellar.xyz -r 3 cellar.nc >"$TMP/out" 2>"$TMP/err"
hasnt "under the plate it never comes" 'under the scan' "$TMP/err"

# Under an overhang whose lower side was scanned too is no material.
awk 'BEGIN { for (j = -20; j <= 20; j++) for (i = -20; i <= 20; i++) for (k = 0; k < 3; k++)
	if (k < 1 || i <= 8) printf "%.3f %.3f %.3f\n", i / 2, j / 2, k == 0 ? -14 : k == 1 ? 0 : 3 }' >over.xyz
under -6 >between.mpf
ncverify -g over.xyz -r 3 -e 0.01 --partial between.mpf >"$TMP/out" 2>"$TMP/err"
hasnt "under an overhang whose lower side is known" 'under the scan' "$TMP/err"
done_testing

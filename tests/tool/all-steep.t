#!/bin/sh
# all-steep.t - a wall that a scan from above has few points on: between these the ball stays out of
# it, and a program that goes in is refused.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A wall of 88.3 degrees, 20 mm high, over the whole width: anywhere over 24 x 16 mm (a point to 0.25
# mm2), and as it is (every 0.5 mm up and along).
awk 'BEGIN {
	state = 7
	for (i = 0; i < 1536; i++) {
		state = (state * 16807) % 2147483647; x = 24 * state / 2147483647 - 12
		state = (state * 16807) % 2147483647; y = 16 * state / 2147483647 - 8
		z = 20 - x / 0.03; printf "%.4f %.4f %.4f\n", x, y, (z < 0 ? 0 : (z > 20 ? 20 : z))
	} }' >"$TMP/scan.xyz"
awk 'BEGIN { for (z = 1; z < 20; z += 0.5) for (y = -6; y <= 6; y += 0.5)
	printf "%.4f %.4f %.4f\n", 0.03 * (20 - z), y, z }' >"$TMP/truth.xyz"

cd "$TMP" || exit 1
status 0 "it is meshed" cloud2mesh -q -t 2 -o mesh.ply scan.xyz
for fitter in biarcfit bsplfit; do
	status 0 "passes for it" meshnorm -q -r 3 --avoid -o path.cl mesh.ply
	status 0 "$fitter takes them" "$fitter" -q -e 0.01 -o fit.cl path.cl
	status 0 "and ncpost" ncpost -q -c siemens -o program.mpf fit.cl
	status 0 "ncverify accepts the program" ncverify -q -g scan.xyz program.mpf
	"$READBACK" --scan truth.xyz fit.cl >reading
	deep=$(sed -n 's/^ball: deepest \([-0-9.]*\).*/\1/p' reading)
	below "the ball stays out of the wall ($deep)" "$deep" 0.12
done

# Points in rows, at its rim and at its foot and beside: along the wall, half up, the ball is nowhere
# near a point.
awk 'BEGIN { for (x = -8.05; x < 9; x += 0.7) for (y = -8; y <= 8; y += 0.7)
	printf "%.4f %.4f %d\n", x, y, (x < 0 ? 20 : 0) }' >rows.xyz
cut() { # DEPTH FILE: a ball of 3 in the wall
	awk -v depth="$1" 'BEGIN { x = 0.03 * 10 + 3 - depth
		print "G21 G90 G94 G40 G17 G54\nT1 M6\nS9000 M3\nG43 H1\nG0 Z60"
		printf "G0 X%.3f Y-5 A0 C0\nG0 Z30\nG1 Z7 F500\nG1 Y5\nG1 Z30\nG0 Z60\nG49 M5\nM30\n", x }' >"$2"
}
cut 1.2 deep.ngc
status 3 "a program in the wall is refused" ncverify -r 3 --partial -g rows.xyz -c linuxcnc deep.ngc
has "with the depth and the place" 'the ball is [01]\.[0-9]* mm deep between points of a steep flank at' err
cut -0.4 clear.ngc
ncverify -r 3 --partial -g rows.xyz -c linuxcnc clear.ngc >out 2>err
hasnt "one beside it is not" 'steep flank' err

# A link over a hollow is part of a cut: how far it is off the part the points tell as well as they
# are dense.
awk 'BEGIN { for (x = -10; x <= 10; x++) for (y = -10; y <= 10; y++) print x, y, 0 }' >flat.xyz
link() { # HEIGHT FILE OPTION...: a half circle amid a cut
	awk -v up="$1" 'BEGIN { print "G21 G90 G94 G40 G17 G54\nT1 M6\nS9000 M3\nG43 H1\nG0 Z60"
		print "G0 X-9 Y0 A0 C0\nG0 Z5\nG1 Z0 F500\nG1 X-4"
		printf "G18 G3 X%s Z0 I%s K0\nG17\n", 2 * up - 4, up
		print "G1 X9\nG1 Z30\nG0 Z60\nG49 M5\nM30" }' >"$2"
	program=$2
	shift 2
	ncverify -r 3 -g flat.xyz -c linuxcnc "$@" "$program" >out 2>err
}
link 3.5 low.ngc --left 0.1
hasnt "3.5 mm are a radius and less than the points are apart" 'leaves the part' err
link 4.5 high.ngc --left 0.1
has "4.5 are more" 'line 10: the ball leaves the part amid a cut, 4.5' err

# Where what is left is not judged, three times what the points are apart, by which an edge may be
# beyond them: of a fine scan still a quarter of the radius.
link 2.8 low.ngc --partial
hasnt "2.8 mm over points 1 mm apart" 'leaves the part' err
link 3.5 high.ngc --partial
has "3.5 are more" 'line 10: the ball leaves the part amid a cut, 3.5' err
awk 'BEGIN { for (x = -10; x <= 10; x += 0.2) for (y = -1; y <= 1; y += 0.2)
	print x, y, 0 }' >flat.xyz
link 1 fine.ngc --partial
has "1 mm over points 0.2 mm apart" 'line 10: the ball leaves the part amid a cut, 0.99' err

# A cliff on no row of points, cut in planes: at its edge the ball is kept off as if the upper side
# went on to the next points.
awk 'BEGIN { for (i = 0; i < 22; i++) for (j = 0; j < 16; j++) {
	x = 1.5 * i; y = 1.5 * j; print x, y, (x + 0.1 * y > 16.049 ? 5 : 0) } }' >cliff.xyz
cloud2mesh -q cliff.xyz | planecut -r 4 -s 1.5 --avoid 2>err | bsplfit -q |
	ncpost -q -c siemens -o cliff.mpf
has "an edge that is not resolved" 'edge not resolved' err
status 0 "the ball off it leaves no cut" ncverify -q -g cliff.xyz cliff.mpf
status 0 "nor in a part of a program" ncverify -q --partial -g cliff.xyz cliff.mpf

done_testing

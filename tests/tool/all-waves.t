#!/bin/sh
# all-waves.t - a tight wave, a hump of random points, laser lines: how deep does the ball go, and what
# does it leave?  With the ball alone, as in all-shapes.t.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A tight wave (hollow radius 2.5, the ball 2), its points anywhere: as it is, and with noise.  WAVE SIGMA
# SEED makes a scan, without them the truth inside its border.
wave() {
	awk -v sigma="$1" -v seed="$2" 'function uniform() {
			seed = (seed * 16807) % 2147483647
			return seed / 2147483647
		}
		function put(x, y, g, a, b, u, v, s) {
			a = 8 * atan2(1, 1) * x / 20
			b = 8 * atan2(1, 1) * y / 30
			u = -4 * 8 * atan2(1, 1) / 20 * cos(a) * cos(b)
			v = 4 * 8 * atan2(1, 1) / 30 * sin(a) * sin(b)
			s = g / sqrt(1 + u * u + v * v)
			printf "%.4f %.4f %.4f\n", x + s * u, y + s * v, 4 * sin(a) * cos(b) + s
		}
		BEGIN {
			for (x = -8; sigma == "" && x <= 8; x += 0.05) for (y = -8; y <= 8; y += 0.05) put(x, y, 0)
			for (i = 0; sigma != "" && i < 2200; i++) {
				x = 20 * uniform() - 10
				y = 20 * uniform() - 10
				g = -6
				for (k = 0; k < 12; k++)
					g += uniform()
				put(x, y, sigma * g)
			}
		}'
}
wave >wave.true
for sigma in 0 0.02; do
	wave $sigma $((4711 + 7919 * ${SEED:-0})) >wave.xyz
	deep=$(echo $sigma | awk '{ print 0.01 + 1.5 * $1 }')
	ok "a wave, noise $sigma: a mesh" cloud2mesh -q -t 2 -o shape.ply wave.xyz
	ok "a path" meshnorm -q --ball-only -r 2 --scallop 0.02 -e 0.01 -g wave.xyz --avoid -o shape.cl shape.ply
	ok "B-splines" bsplfit -q -e 0.01 -g wave.xyz -o fitted.cl shape.cl
	for cl in shape fitted; do
		status 0 "$cl: no deeper than $deep mm in what is true" \
			"$READBACK" --scan wave.true --deeper "$deep" $cl.cl
		grep ^ball: out | sed 's/^/# /'
	done
	ok "a program" ncpost -q -c siemens -o program.mpf fitted.cl
	left=$(echo $sigma | awk '{ print 0.03 + 1.5 * $1 }')
	# The scan is larger than what is judged: passes beside that come and go up to 0.9 mm over it.
	status 0 "and leaves no more than $left mm" \
		ncverify -q -r 2 -g wave.true -e 0.04 --band 1 --left "$left" program.mpf
done

# Rows run out to the border of the scan, whose random points no grid of nodes reaches: what is left
# is within the scallop and the tolerance at every point beside and under the ball's ways.
awk 'function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	BEGIN { seed = 31 + 7919 * ENVIRON["SEED"]; for (i = 0; i < 3000; i++) {
		x = 30 * uniform() - 15; y = 24 * uniform() - 12
		printf "%.4f %.4f %.4f\n", x, y, 10 - x * x / 70 - y * y / 50 + x * y / 90 } }' >hump.xyz
ok "a hump: a mesh" cloud2mesh -q -t 2 -o hump.ply hump.xyz
for tool in meshnorm planecut; do
	ok "a hump: a path by $tool" $tool -v --ball-only -r 6 --scallop 0.02 -e 0.01 -g hump.xyz -o hump.cl hump.ply
	more=$(sed -n 's/.*mm more, \([0-9]*\) planes more/\1/p' "$TMP/err")
	[ "$tool" = meshnorm ] || below "a hump: planes beside those over the mesh" "$more" 15
	ok "a hump: a program" ncpost -q -c siemens -o hump.mpf hump.cl
	status 0 "$tool: no more than 0.03 mm is left, up to the border" \
		ncverify -q -r 6 -g hump.xyz -e 0.01 --left 0.03 hump.mpf
done

# Laser lines, the last of them cut off short: no facet hangs on its end, and rows end with the scan.
awk 'function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	function put(x, y) { printf "%.4f %.4f %.4f\n", x, y, 2 * sin(x / 4) * cos(y / 5) + x / 10 }
	BEGIN { seed = 5 + 7919 * ENVIRON["SEED"]; for (j = 0; j <= 24; j++) for (i = 0; i <= (j < 24 ? 140 : 9); i++)
		put(0.2 * (i + uniform() - 0.5), 0.8 * j + 0.16 * (uniform() - 0.5)) }' >lines.xyz
awk 'BEGIN { for (x = -1; x <= 29; x += 0.1) for (y = -1; y <= 20.5; y += 0.1)
	printf "%.4f %.4f %.5f\n", x, y, 2 * sin(x / 4) * cos(y / 5) + x / 10 }' >lines.true
ok "laser lines: a mesh" cloud2mesh -q -e 0.05 -o lines.ply lines.xyz
status 0 "laser lines: a path" meshnorm -q --ball-only -r 4 --scallop 0.02 -e 0.01 -g lines.xyz -o lines.cl lines.ply
# Beside the last line nothing says how the surface goes on: not as close there.
status 0 "laser lines: no deeper than 0.02 mm, beyond the last of them too" \
	"$READBACK" --scan lines.true --deeper 0.02 lines.cl
done_testing

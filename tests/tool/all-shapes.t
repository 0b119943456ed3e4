#!/bin/sh
# all-shapes.t - shapes whose points are worked out here: how deep does the ball go, and what does it
# leave?  With the ball alone, for speed; the whole tool is tested in meshnorm-tool.t and -links.t.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# SHAPE SIGMA makes a scan, without sigma the truth
# that it is judged by, finely.
shape() {
	awk -v shape="$1" -v sigma="${2:-0}" -v step="${3:-0.25}" -v edge="${4:-13}" 'BEGIN {
		seed = 7
		for (x = -edge; x <= edge + 1e-9; x += step) for (y = -edge; y <= edge + 1e-9; y += step) {
			if (shape == "bowl") { z = (x * x + y * y) / 20; u = x / 10; v = y / 10 }
			else { z = (x * x - y * y) / 40; u = x / 20; v = -y / 20 }
			g = 0
			for (k = 0; k < 12 && sigma > 0; k++) {
				seed = (seed * 16807) % 2147483647
				g += seed / 2147483647
			}
			g = sigma > 0 ? sigma * (g - 6) / sqrt(1 + u * u + v * v) : 0
			printf "%.4f %.4f %.4f\n", x - g * u, y - g * v, z + g
		}
	}'
}
for what in saddle bowl; do
	shape $what "" 0.1 11 >$what.true
	shape $what 0.02 0.5 >$what.xyz
done
shape saddle "" 0.1 10 >inner.true
# ball, depth allowed: the tolerance and one and a half sigma; a ball of 12 does not fit the bowl
for what in saddle:8:0 bowl:12:3; do
	# shellcheck disable=SC2046 # three words
	set -- $(echo $what | tr : ' ')
	ok "$1: a mesh" cloud2mesh -q -t 1.5 -o shape.ply "$1.xyz"
	status "$3" "$1, a ball of $2" meshnorm -q --ball-only -r "$2" --scallop 0.02 -g "$1.xyz" -o shape.cl shape.ply
	for fitter in biarcfit bsplfit; do
		status 0 "$1, $fitter" $fitter -q -e 0.01 -g "$1.xyz" -o fitted.cl shape.cl
		status 0 "$1, ball of $2, $fitter: no deeper than 0.04 mm in what is true" \
			"$READBACK" --scan "$1.true" --deeper 0.04 fitted.cl
		grep ^ball: out | sed 's/^/# /'
	done
	ok "$1: a program" ncpost -q -c siemens -o program.mpf fitted.cl
	if [ "$3" = 0 ]; then
		status 0 "$1: and leaves no more than 0.06 mm" ncverify -q -r "$2" -g "$1.true" -e 0.04 --left 0.06 program.mpf
	fi
done

# A point among noisy ones that is off by five sigma is noise still: no hill is left under it.
{ cat saddle.xyz; echo "0.25 0.25 0.108"; } >off.xyz
ok "a point off: a mesh" cloud2mesh -q -t 1.5 -o shape.ply off.xyz
ok "a point off: a path" meshnorm -q --ball-only -r 8 --scallop 0.02 -e 0.01 -g off.xyz --avoid -o shape.cl shape.ply
ok "a point off: arcs" biarcfit -q -e 0.01 -o fitted.cl shape.cl
ok "a point off: a program" ncpost -q -c siemens -o program.mpf fitted.cl
status 0 "a point off: no more than 0.06 mm is left" \
	ncverify -q -r 8 -g inner.true -e 0.04 --left 0.06 program.mpf

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
	wave $sigma 4711 >wave.xyz
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
	BEGIN { seed = 31; for (i = 0; i < 3000; i++) {
		x = 30 * uniform() - 15; y = 24 * uniform() - 12
		printf "%.4f %.4f %.4f\n", x, y, 10 - x * x / 70 - y * y / 50 + x * y / 90 } }' >hump.xyz
ok "a hump: a mesh" cloud2mesh -q -t 2 -o hump.ply hump.xyz
for tool in meshnorm planecut; do
	ok "a hump: a path by $tool" $tool -q --ball-only -r 6 --scallop 0.02 -e 0.01 -g hump.xyz -o hump.cl hump.ply
	ok "a hump: a program" ncpost -q -c siemens -o hump.mpf hump.cl
	status 0 "$tool: no more than 0.03 mm is left, up to the border" \
		ncverify -q -r 6 -g hump.xyz -e 0.01 --left 0.03 hump.mpf
done

# Laser lines, the last of them cut off short: no facet hangs on its end, and rows end with the scan.
awk 'function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	function put(x, y) { printf "%.4f %.4f %.4f\n", x, y, 2 * sin(x / 4) * cos(y / 5) + x / 10 }
	BEGIN { seed = 5; for (j = 0; j <= 24; j++) for (i = 0; i <= (j < 24 ? 140 : 9); i++)
		put(0.2 * (i + uniform() - 0.5), 0.8 * j + 0.16 * (uniform() - 0.5)) }' >lines.xyz
awk 'BEGIN { for (x = -1; x <= 29; x += 0.1) for (y = -1; y <= 20.5; y += 0.1)
	printf "%.4f %.4f %.5f\n", x, y, 2 * sin(x / 4) * cos(y / 5) + x / 10 }' >lines.true
ok "laser lines: a mesh" cloud2mesh -q -e 0.05 -o lines.ply lines.xyz
status 0 "laser lines: a path" meshnorm -q --ball-only -r 4 --scallop 0.02 -e 0.01 -g lines.xyz -o lines.cl lines.ply
status 0 "laser lines: no deeper than 0.01 mm, beyond the last of them too" \
	"$READBACK" --scan lines.true --deeper 0.01 lines.cl

# Points that float over the scan lift no path, whatever they are over.
for where in "0.3 0.4 1.5" "-6.2 3.1 3" "5.1 5.2 1.2"; do echo "$where"; done >strays
cat saddle.xyz strays >strayed.xyz
ok "strays: a mesh" cloud2mesh -q -t 1.5 -o shape.ply strayed.xyz
ok "strays: a path" meshnorm -v --ball-only -r 8 --scallop 0.02 -e 0.01 -g strayed.xyz --avoid -o shape.cl shape.ply
has "they are counted" 'left out 3 outliers of the scan that guards' err
ok "strays: a program" ncpost -q -c siemens -o program.mpf shape.cl
status 0 "strays: no more than 0.06 mm is left" \
	ncverify -q -r 8 -g inner.true -e 0.04 --left 0.06 program.mpf
done_testing

#!/bin/sh
# all-shapes.t - shapes whose points are worked out here: how deep does the ball go, and what does it
# leave?  With the ball alone, for speed; the whole tool is tested in meshnorm-tool.t and -links.t.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# SHAPE SIGMA makes a scan, without sigma the truth
# that it is judged by, finely.
shape() {
	awk -v shape="$1" -v sigma="${2:-0}" -v step="${3:-0.25}" -v edge="${4:-13}" 'BEGIN {
		seed = 7 + 7919 * ENVIRON["SEED"]
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
	shape $what "" 0.15 11 >$what.true
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
		status "$3" "$1, $fitter" $fitter -q -e 0.01 -g "$1.xyz" -o fitted.cl shape.cl
		status 0 "$1, ball of $2, $fitter: no deeper than 0.04 mm in what is true" \
			"$READBACK" --scan "$1.true" --deeper 0.04 fitted.cl
		grep ^ball: out | sed 's/^/# /'
	done
	status "$3" "$1: a program" ncpost -q -c siemens -o program.mpf fitted.cl
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

#!/bin/sh
# all-odd.t - a dome of facets, its points 1 mm apart with noise: the surfaces that guard and who
# judges take the noise out in ways of their own, and put some points elsewhere.  What ends with
# status 0 is accepted all the same.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# SEED: 625 points with a noise of 0.02 on planes that touch a ball of 20 mm at sixty places, turned
# and moved.
facets() {
	awk -v seed="$1" 'function uniform() {
			seed = (seed * 16807) % 2147483647
			return seed / 2147483647
		}
		function plane(x, y, k, r, t, u, v, h) {
			r = 13 * sqrt((k + 0.5) / 60)
			t = 2.39996 * k
			u = r * cos(t)
			v = r * sin(t)
			h = sqrt(400 - u * u - v * v)
			return h + (u * (u - x) + v * (v - y)) / h
		}
		BEGIN {
			turn = 6.2831853 * uniform()
			c = cos(turn)
			d = sin(turn)
			left = 3 * uniform() - 1.5
			low = 3 * uniform() - 1.5
			for (x = -12; x <= 12; x++) for (y = -12; y <= 12; y++) {
				z = 1e9
				for (k = 0; k < 60; k++) {
					h = plane(c * (x - left) + d * (y - low), c * (y - low) - d * (x - left), k)
					z = h < z ? h : z
				}
				g = -6
				for (k = 0; k < 12; k++)
					g += uniform()
				printf "%d %d %.4f\n", x, y, z - 10 + 0.02 * g
			}
		}'
}

# Of the first who judges found four points left, at most three may be, where all had ended with 0.
# By default these are unmet, for a part of what is taken for noise is edges; with a noise that is
# told they are not.
for seed in 23 1 5 12 59; do
	facets $((9973 * seed + 17 + 7919 * ${SEED:-0})) >scan.xyz
	ok "$seed: a mesh" cloud2mesh -q -t 2 -o mesh.ply scan.xyz
	status 3 "$seed: edges in the noise" meshnorm -q -r 2.5 --avoid -g scan.xyz -o path.cl mesh.ply
	meshnorm -q -r 2.5 --avoid --noise 0.032 -g scan.xyz -o path.cl mesh.ply 2>err
	made=$?
	ok "$seed: status 0, or 3 with what is left ($made)" \
		test $made = 0 -o "$(grep -cE 'for left though|^meshnorm: left though' err)" -gt 0
	[ $made = 0 ] || continue
	ok "$seed: a fit" biarcfit -q -e 0.01 --noise 0.032 -g scan.xyz -o fit.cl path.cl
	ok "$seed: a program" ncpost -q -c siemens -o program.mpf fit.cl
	status 0 "$seed: accepted" ncverify -q -r 2.5 --noise 0.032 -g scan.xyz program.mpf
done
done_testing

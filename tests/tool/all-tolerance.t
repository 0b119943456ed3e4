#!/bin/sh
# all-tolerance.t - what the whole pipe writes at a tolerance, the judge accepts at that tolerance: the
# straight pieces that a control gets for arcs lie on the part's side of a hump, and have their share.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	BEGIN { seed = 77 + 7919 * ENVIRON["SEED"]; for (i = 0; i < 3500; i++) {
		x = 40 * uniform(); y = 36 * uniform()
		z = 6 + 2.5 * sin(x / 7 + 0.3 * sin(y / 5)) + 1.5 * cos(y / 4.3) + 0.02 * x
		printf "%.4f %.4f %.4f\n", x, y, z } }' >dunes.xyz
ok "dunes: a mesh" cloud2mesh -q -o dunes.ply dunes.xyz
ok "a path" meshnorm -q -r 4 --avoid -o dunes.cl dunes.ply
for fitter in biarcfit bsplfit; do
	ok "$fitter" $fitter -q -o fitted.cl dunes.cl
	for control in fanuc heidenhain; do
		ok "$control" ncpost -q -c $control -o program.nc fitted.cl
		status 0 "$fitter, $control: accepted at the tolerance of the fit" \
			ncverify -q -c $control -g dunes.xyz -r 4 -e 0.01 program.nc
	done
done
done_testing

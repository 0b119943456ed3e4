#!/bin/sh
# all-rounded.t - scans whose heights were rounded to steps, coarse against what the points are
# apart, as those of a terrain: no stairs, whose edges would keep the ball off.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# STEP ROUGH: rough ground of 24 waves, its heights rounded.
ground() {
	awk -v step="$1" -v rough="$2" 'function random() {
			seed = (seed * 16807) % 2147483647
			return 6.2832 * seed / 2147483647
		}
		BEGIN {
			seed = 11
			for (k = 0; k < 24; k++) {
				turn = random()
				phase[k] = random()
				length_of[k] = 24 * exp(-k / 8.5)
				along[k] = 6.2832 / length_of[k] * cos(turn)
				across[k] = 6.2832 / length_of[k] * sin(turn)
			}
			for (x = 0; x <= 20; x += 0.5) for (y = 0; y <= 20; y += 0.5) {
				z = 50
				for (k = 0; k < 24; k++)
					z += rough * length_of[k] * sin(along[k] * x + across[k] * y + phase[k])
				printf "%.4f %.4f %.4f\n", x, y, step * int(z / step + 0.5)
			}
		}'
}

for case in "0.1 0.012" "0.05 0.01" "0.05 0.03"; do
	ground $case >scan.xyz
	ok "$case: a mesh" cloud2mesh -q -o mesh.ply scan.xyz
	status 0 "... a path" meshnorm -r 3 --avoid -o path.cl mesh.ply 2>err
	for fit in biarcfit bsplfit; do
		status 0 "... $fit" $fit -q -o fit.cl path.cl
		ok "... a program" ncpost -q -c fanuc -o program fit.cl
		status 0 "... that is accepted" ncverify -q -g scan.xyz -r 3 program
	done
	[ "$case" = "0.1 0.012" ] || continue
	is "... it says that heights were rounded" "$(grep -c 'were rounded to 0.1 mm' err)" 1
	ncverify -g scan.xyz -r 3 program >/dev/null 2>err
	is "... and so does who judges" "$(grep -c 'were rounded to 0.1 mm' err)" 1
	meshnorm -r 3 --avoid --noise 0 -o path.cl mesh.ply 2>err
	is "... but not where each point is believed" "$(grep -c 'were rounded' err)" 0
done
done_testing

#!/bin/sh
# all-guarded.t - the panel with noise: paths and what is fitted to them kept clear of a scan.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# The middle of the panel.
panel=panel.xyz
awk '$1 * $1 < 676 && $2 * $2 < 361' "$SRC/samples/panel_17036.xyz" >$panel

# Guarded by the scan, on the points and along all that is fitted, arcs and curves: no deeper in the
# panel than the tolerance and what the scan's noise is good for.
awk 'BEGIN { seed = 7 + 7919 * ENVIRON["SEED"] } { s = 0
	for (i = 0; i < 12; i++) { seed = (seed * 16807) % 2147483647; s += seed / 2147483647 }
	printf "%.4f %.4f %.4f\n", $1, $2, $3 + 0.02 * (s - 6) }' $panel >noise.xyz
ok "a noisy scan: a mesh" cloud2mesh -q -t 6 -o guarded.ply noise.xyz
status 0 "a path clear of it" meshnorm -q -r 8 --rows mesh --ball-only -g noise.xyz -o guarded.cl guarded.ply
for fitter in biarcfit bsplfit; do
	status 0 "$fitter: clear of it too" $fitter -v -e 0.01 -g noise.xyz -o fitted.cl guarded.cl
	has "looked at again" "guarded by $(wc -l <$panel) points" err
	status 0 "$fitter: 0.04 mm deep in the panel at most, anywhere" \
		"$READBACK" --panel --deeper 0.04 fitted.cl
	grep ball out | sed 's/^/# /'
done

# A scan that a run can't be kept clear of: its end stays where it was.
awk '{ print $1, $2, $3 + 0.1 }' $panel >higher.xyz
for fitter in biarcfit bsplfit; do
	status 3 "$fitter: ends in the scan are told" $fitter -e 0.01 -g higher.xyz -o fitted.cl guarded.cl
	has "with pass, depth and place" 'goes deeper than 0.01 mm into the part, worst in pass [0-9]+ the ball by 0\.[0-9]+ mm with' err
	awk '{ print $1 + 300, $2, $3 }' $panel >elsewhere.xyz
	status 1 "$fitter: a scan that lies elsewhere" $fitter -q -g elsewhere.xyz guarded.cl
	has "is refused" 'points of the path further than' err
done

done_testing

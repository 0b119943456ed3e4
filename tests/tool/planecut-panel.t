#!/bin/sh
# planecut-panel.t - the panel all the way to programs; points put on the surfaces of a model.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# The middle of the panel.
panel=middle.xyz
awk '$1 * $1 < 676 && $2 * $2 < 361' "$SRC/samples/panel_17036.xyz" >$panel

# The cutting points of a path, one a line: pass, tip, axis, contact, normal.
cuts() {
	awk -F'[/,]' '/PASS\// { pass = $2 }
		/CONTCT\// { c = $2; for (i = 3; i <= 7; i++) c = c " " $i }
		/^GOTO\// && c != "" { print pass, $2, $3, $4, $5, $6, $7, c; c = "" }' "$1"
}

# ---- the panel, all the way: two fitters, two controls, three and five axes

cloud2mesh -q -t 2 -o panel.ply $panel
for axis in "--fixed 0,0,1" "--tilt 15"; do
	# shellcheck disable=SC2086 # words
	status 0 "the panel, $axis" planecut -q -r 8 -s 12 -a 0 -e 0.005 $axis -o none.cl panel.ply
	"$READBACK" -c none none.cl --panel >out
	below "$axis: the ball goes no deeper than" "$(sed -n '/^ball:/s/.*deepest \([-0-9.]*\) mm.*/\1/p' out)" 0.005
	biarcfit -q -e 0.01 -o biarcfit.cl none.cl
	bsplfit -q -e 0.01 -o bsplfit.cl none.cl
	for fitter in biarcfit bsplfit; do
		for control in fanuc siemens; do
			status 0 "$axis, $fitter: $control" ncpost -q -c $control -o program $fitter.cl
			status 0 "$axis, $fitter: $control, read back" "$READBACK" -c $control -e 0.006 --axis 0.0505 \
				--path $fitter.cl --panel program
			below "$axis, $fitter: $control, gouge in the panel" \
				"$(sed -n '/^ball:/s/.*deepest \([-0-9.]*\) mm.*/\1/p' out)" 0.02
		done
	done
done
planecut -q -r 8 -s 6 -j 1 panel.ply >one.cl
planecut -q -r 8 -s 6 -j 4 panel.ply >four.cl
same "threads change nothing" one.cl four.cl
planecut -q -r 8 -s 6 <panel.ply >stdin.cl
same "nor does standard input" one.cl stdin.cl

# ---- put on the surfaces that a coarse mesh was made from

surface=$SRC/tests/data/awkward/surface.igs
nurbs2mesh -q -n 12 -o coarse.ply "$surface"
planecut -q -r 1 -s 3.1 -a 20 --fixed 0,0,1 coarse.ply -o off.cl
status 0 "on the surface itself" planecut -r 1 -s 3.1 -a 20 --fixed 0,0,1 --surface "$surface" \
	-o on.cl coarse.ply
ends=$((2 * $(grep -c 'PASS/' on.cl)))
has "all points have one but the ends of passes, on its border" \
	"^planecut: $ends points have no surface" err
has "what the mesh was off counts without it" 'LEDGER/nurbs2mesh' off.cl
hasnt "and no more with it" 'LEDGER/nurbs2mesh' on.cl
cuts off.cl >off
cuts on.cl >on
# How far contacts of the second path lie from the first's passes: points inserted may differ.
apart() {
	awk 'FNR == NR { k = ++n[$1]; for (i = 0; i < 3; i++) p[$1, k, i] = $(8 + i); next }
	{ least = 1e9
	  for (k = 1; k < n[$1]; k++) {
		length2 = along = d2 = 0
		for (i = 0; i < 3; i++) {
			d[i] = p[$1, k + 1, i] - p[$1, k, i]
			length2 += d[i] ^ 2
			along += d[i] * ($(8 + i) - p[$1, k, i]) }
		t = length2 > 0 ? along / length2 : 0
		t = t < 0 ? 0 : t > 1 ? 1 : t
		for (i = 0; i < 3; i++) d2 += ($(8 + i) - p[$1, k, i] - t * d[i]) ^ 2
		if (d2 < least) least = d2 }
	  if (least > w) w = least }
	END { printf "%.6f\n", sqrt(NR > FNR ? w : 1e18) }' "$1" "$2"
}
off=$(sed -n 's|.*LEDGER/nurbs2mesh,||p' off.cl)
below "points move by less than the mesh is off" "$(apart off on)" "$off"
below "those of the mesh too" "$(apart on off)" "$off"
below "but move" 0.000001 "$(apart on off)"

done_testing

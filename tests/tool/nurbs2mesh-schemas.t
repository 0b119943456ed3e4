#!/bin/sh
# nurbs2mesh-schemas.t - one model as AP203, AP214, AP242, in inches, as trimmed surfaces and as a
# solid of IGES: exit status 0, area and volume exact, and every edge of what is written has two
# facets, at coarse and fine tolerances.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

within=0.000001

each_form() { # NAME AREA VOLUME TOLERANCES: in each form
	name=$1 exact_area=$2 exact_volume=$3
	shift 3
	for form in ap203.step ap214.step ap242.step inch.step 144.igs 144in.igs 186.igs; do
		for e; do
			what="$name-$form -e $e"
			nurbs2mesh -v -e "$e" -o "$TMP/form.ply" "$SRC/tests/data/cad/$name-$form" 2>"$TMP/told"
			ok "$what: is sound" test $? -eq 0
			sed -n 's/.*body 1: closed.* area \([^ ]*\) mm2, volume \([^ ]*\) mm3, [0-9]* facets$/\1 \2/p' \
				"$TMP/told" >"$TMP/figures"
			read -r area volume <"$TMP/figures"
			part "$what: area" "$area" "$exact_area"
			part "$what: volume" "$volume" "$exact_volume"
			measure "$TMP/form.ply" >"$TMP/figures"
			read -r area volume open <"$TMP/figures"
			ok "$what: two facets at every edge" test "$open" -eq 0
		done
	done
}

each_form lens4 576 1152 0.01 0.001
# The fillet's arc turns about the axis: radius R of its middle's way, r of its own; Pappus.
R=0.001 r=4.999
each_form capsule \
	"$(calc "2 * p * 5 * 20.002 + 2 * (2 * p * $r * ($R * p / 2 + $r)) + 2 * p * $R ^ 2")" \
	"$(calc "p * 25 * 20.002 + 2 * (p * $R ^ 2 * $r + p ^ 2 * $R * $r ^ 2 / 2 + 2 * p * $r ^ 3 / 3)")" \
	0.01 0.002
each_form chamfer 2048.001190 5817.135652 0.05

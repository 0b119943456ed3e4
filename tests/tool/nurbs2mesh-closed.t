#!/bin/sh
# nurbs2mesh-closed.t - bodies that are closed in their file are closed as meshes, whatever the
# tolerance: chords of an edge that end elsewhere on its two faces, shells in hollow bodies.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

closed() { # DESC GENUS ARGS...: every body is closed, and facets are turned alike
	what=$1 genus=$2
	shift 2
	nurbs2mesh -v "$@" >"$TMP/model.ply" 2>"$TMP/report"
	ok "$what: is read" test $? -eq 0
	has "$what: is closed" "^nurbs2mesh: body [0-9]+: closed, genus $genus," "$TMP/report"
	hasnt "$what: nothing is open" '^nurbs2mesh: (open: |body [0-9]*: open)' "$TMP/report"
	hasnt "$what: nor turned against its neighbours" \
		'turned differently|more than two facets' "$TMP/report"
}

# An arc of which each face has other chords: their corners are off the other's by what chords are.
for x in -16 16 30; do
	dprism 44 $x 6 | step prism
	for e in 0.2 0.1 0.05; do
		closed "a cylinder cut off at $x, -e $e" 0 -e $e "$TMP/prism.step"
	done
done

# A face that a representation names by itself, as for a tolerance, is a face of the shell, not
# another.
{
	dprism 44 16 6
	echo "named SHAPE_REPRESENTATION('',({f2}),{CONTEXT})"
} | step named
closed "a face named once more" 0 -e 0.1 "$TMP/named.step"
has "is read once" '4 surfaces in' "$TMP/report"

# A box of which one side ends askew, so that a needle is open between it and its neighbour:
# narrower than the gap, but long.  And a strip of the neighbour folded back along it.
box_with() { # NAME Y: the side at y 0 is at Y where x is 30; the others are not
	awk -v y="$2" 'function flat(t) {
		print "surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points " t }
		BEGIN { print "nurbs 1"
		flat("0 0 0 0 20 0 30 0 0 30 20 0"); flat("0 0 10 30 0 10 0 20 10 30 20 10")
		flat("0 0 0 30 " y " 0 0 0 10 30 " y " 10"); flat("30 0 0 30 20 0 30 0 10 30 20 10")
		flat("30 20 0 0 20 0 30 20 10 0 20 10"); flat("0 20 0 0 0 0 0 20 10 0 0 10")
		print "end" }' >"$TMP/$1.nurbs"
}
for y in 0 0.004 0.012; do
	box_with askew $y
	for e in 0.1 0.02; do
		closed "a box whose side is $y mm askew, -e $e" 0 -e $e --gap 0.01 "$TMP/askew.nurbs"
	done
done
box_with apart 0.5
nurbs2mesh -v -e 0.02 --gap 0.01 "$TMP/apart.nurbs" >"$TMP/model.ply" 2>"$TMP/report"
has "a side half a millimetre askew stays open" '^nurbs2mesh: open: ' "$TMP/report"

# Two cubes that touch along an edge, in one set of faces: what they enclose is told.
two_cubes 10 | iges cubes
status 3 "two cubes that touch along an edge are no sound skin" \
	nurbs2mesh -e 0.01 -o "$TMP/cubes.ply" "$TMP/cubes.igs"
nurbs2mesh -v -e 0.01 "$TMP/cubes.igs" >/dev/null 2>"$TMP/report"
has "it is told" '[0-9]+ edges have more than two facets, expected none' "$TMP/report"
has "two cubes that touch along an edge are closed" \
	"closed, touches itself along [0-9]+ edges, area 1200.* volume 2000" "$TMP/report"

# A surface that the model has twice, of one or of other parameters: one is used, and it is told;
# its facets were taken for folds, and both were gone.
surface() {
	echo "surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points $*"
}
box_of() { # X: a box of 10 from there on
	a=$1 b=$(($1 + 10))
	surface $a 0 0 $a 10 0 $b 0 0 $b 10 0
	surface $a 0 10 $b 0 10 $a 10 10 $b 10 10
	surface $a 0 0 $b 0 0 $a 0 10 $b 0 10
	surface $a 10 0 $a 10 10 $b 10 0 $b 10 10
	surface $a 0 0 $a 0 10 $a 10 0 $a 10 10
	surface $b 0 0 $b 10 0 $b 0 10 $b 10 10
}
cd "$TMP" || exit 1
{ echo nurbs 1 && surface 0 0 10 10 0 10 0 10 10 10 10 12 && echo end; } >one.nurbs
sed '/^surface/p' one.nurbs >both.nurbs
nurbs2mesh -q -e 0.01 -o one.ply one.nurbs
status 0 "a surface twice" nurbs2mesh -e 0.01 -o both.ply both.nurbs
has "is told" 'both.nurbs: surface 2 coincides with both.nurbs:1, which is used' err
for name in one both; do # without the number of the surface
	awk 'on { print (NF > 5 ? $0 : $2 " " $3 " " $4) } /end_header/ { on = 1 }' \
		$name.ply >$name.facets
done
same "and is the surface" one.facets both.facets
for again in '0 0 10 10 0 10 0 10 10 10 10 10' '0 0 10 0 10 10 10 0 10 10 10 10'; do
	{ echo nurbs 1 && box_of 0 && surface "$again" && echo end; } >box.nurbs
	closed "a box with a side twice, $again" 0 -e 0.01 box.nurbs
	has "... is told" 'surface 7 coincides with box.nurbs:2, which is used' report
	has "... and has all sides" 'area 600 mm2, volume 1000 mm3' report
done
nurbs2mesh -v -e 0.01 -o both.ply box.nurbs box.nurbs 2>report
has "a whole box twice is one" 'body 1: closed, genus 0, area 600 mm2, volume 1000 mm3' report
{ echo nurbs 1 && box_of 0 && box_of 10 && echo end; } >boxes.nurbs
closed "two boxes that touch" 0 -e 0.01 boxes.nurbs
has "... have no wall between them" 'area 1000 mm2, volume 2000 mm3' report
hasnt "... and nothing is told" coincides report

# A shell that its file calls closed, without its lid.
printf 'at 0 0\nline 10 0\nline 10 30\nline 0 30\n' >"$TMP/profile"
awk -v kind=step -f "$SRC/tests/lib/turned.awk" "$TMP/profile" |
	sed '/CLOSED_SHELL/s/({f1},{f2},{f3})/({f1},{f2})/' | step lidless
status 3 "a closed shell that stays open is told" \
	nurbs2mesh -e 0.01 -o "$TMP/lidless.ply" "$TMP/lidless.step"
nurbs2mesh -e 0.01 "$TMP/lidless.step" >/dev/null 2>"$TMP/report"
has "with its edges" "[1-9][0-9]* edges of shells that the file calls closed are open" "$TMP/report"

done_testing

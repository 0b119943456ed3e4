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

# A shell that its file calls closed, without its lid.
printf 'at 0 0\nline 10 0\nline 10 30\nline 0 30\n' >"$TMP/profile"
awk -v kind=step -f "$SRC/tests/lib/turned.awk" "$TMP/profile" |
	sed '/CLOSED_SHELL/s/({f1},{f2},{f3})/({f1},{f2})/' | step lidless
status 3 "a closed shell that stays open is told" \
	nurbs2mesh -e 0.01 -o "$TMP/lidless.ply" "$TMP/lidless.step"
nurbs2mesh -e 0.01 "$TMP/lidless.step" >/dev/null 2>"$TMP/report"
has "with its edges" "[1-9][0-9]* edges of shells that the file calls closed are open" "$TMP/report"

done_testing

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
	hasnt "$what: nor turned against its neighbours" 'turned differently|more than two facets' "$TMP/report"
}

# An arc of which each face has other chords: their corners are off the other's by what chords are.
for x in -16 16 30; do
	dprism 44 $x 6 | step prism
	for e in 0.2 0.1 0.05; do
		closed "a cylinder cut off at $x, -e $e" 0 -e $e "$TMP/prism.step"
	done
done

done_testing

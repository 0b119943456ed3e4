#!/bin/sh
# nurbs2mesh-planes.t - planes of IGES files that have a border of their own.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# A plane whose border is a pointer of its own (form 1); its place moves both.  A hole (form -1)
# belongs to another plane and is named.
iges bounded108 <<'END'
turn 124 0 0,-1,0,7,1,0,0,0,0,0,1,3
ring 100 0 5,1,2,4,2,4,2
face 108 1@turn 0,0,1,5,{ring},0,0,0,0
END
model "108: a plane with a border of its own" "$(calc '9 * p')" - -e 0.0002 "$TMP/bounded108.igs"
nurbs2mesh -q -e 0.0002 -o "$TMP/x.ply" "$TMP/bounded108.igs"
ok "where the file places it" \
	test "2.000 -2.000 8.000 8.000 4.000 8.000" = "$(vertex_box "$TMP/x.ply")"
iges hole108 <<'END'
ring 100 0 5,1,2,4,2,4,2
hole 100 0 5,1,2,2,2,2,2
face 108 1 0,0,1,5,{ring},0,0,0,0
without 108 -1 0,0,1,5,{hole},0,0,0,0
END
status 3 "108: a hole of another plane is left out" \
	nurbs2mesh -e 0.01 -o "$TMP/x.ply" "$TMP/hole108.igs"
nurbs2mesh -e 0.01 "$TMP/hole108.igs" >/dev/null 2>"$TMP/report"
has "and named" '1 surface of type 108 left out, the first is entity 7' "$TMP/report"

done_testing

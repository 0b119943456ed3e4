#!/bin/sh
# nurbs2mesh-groups.t - loose faces of IGES files in groups (402): parts of an assembly that touch.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# boxes GROUP...: two boxes of 10 that touch in a face, their twelve faces f1 to f12, and groups
boxes() {
	two_cubes 0
	for group in "$@"; do
		echo "g$((at += 1)) 402 7 $group"
	done
}
one='6,{f1},{f2},{f3},{f4},{f5},{f6}' two='6,{f7},{f8},{f9},{f10},{f11},{f12}'

boxes "$one" "$two" | iges apart
status 0 "two boxes that touch, each in a group" \
	nurbs2mesh -v -e 0.01 -o "$TMP/x.ply" "$TMP/apart.igs"
has "stay apart" 'all 2 bodies: area 1200 mm2, volume 2000 mm3' "$TMP/err"
has "and are told" 'groups of loose faces are bodies of their own' "$TMP/err"
ok "their surfaces are made triangles once" \
	test "$(grep -c "triangles are off the surfaces" "$TMP/err")" -eq 1
boxes | iges loose
status 3 "without groups they meet in four edges" \
	nurbs2mesh -e 0.01 -o "$TMP/x.ply" "$TMP/loose.igs"

# Groups that are no bodies, three faces of a box each, are joined.
boxes '3,{f1},{f2},{f3}' '3,{f4},{f5},{f6}' | sed '/^[a-z]*\(7\|8\|9\|1[0-2]\) /d' | iges halves
status 0 "a box in two groups" nurbs2mesh -v -e 0.01 -o "$TMP/x.ply" "$TMP/halves.igs"
has "is one" 'body 1: closed, genus 0, area 600 mm2, volume 1000 mm3' "$TMP/err"
done_testing

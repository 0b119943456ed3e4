#!/bin/sh
# nurbs2mesh-groups.t - loose faces of IGES files in groups (402): parts of an assembly that touch.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# boxes GROUP...: two boxes of 10 that touch in a face, their twelve faces f1 to f12, and groups
boxes() {
	awk 'function face(n, x, y, z, i,   k, c, text, p, q) {
			p[0] = x; p[1] = y; p[2] = z; text = ""
			for (c = 0; c < 5; c++) { for (k = 0; k < 3; k++) q[k] = p[k]
				q[(i + 1) % 3] += 10 * (c == 1 || c == 2); q[(i + 2) % 3] += 10 * (c == 2 || c == 3)
				text = text "," q[0] "," q[1] "," q[2] }
			print "p" n " 108 0 " (i == 0) "," (i == 1) "," (i == 2) "," p[i] ",0,0,0,0,1"
			print "r" n " 106 12 2,5" text
			print "o" n " 142 0 0,{p" n "},0,{r" n "},2"
			print "f" n " 144 0 {p" n "},1,0,{o" n "}" }
		BEGIN { for (c = 0; c < 2; c++) for (i = 0; i < 3; i++) for (far = 0; far < 20; far += 10)
			face(++n, 10 * c + (i == 0) * far, (i == 1) * far, (i == 2) * far, i) }'
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
boxes | iges loose
status 3 "without groups they meet in four edges" \
	nurbs2mesh -e 0.01 -o "$TMP/x.ply" "$TMP/loose.igs"

# Groups that are no bodies, three faces of a box each, are joined.
boxes '3,{f1},{f2},{f3}' '3,{f4},{f5},{f6}' | sed '/^[a-z]*\(7\|8\|9\|1[0-2]\) /d' | iges halves
status 0 "a box in two groups" nurbs2mesh -v -e 0.01 -o "$TMP/x.ply" "$TMP/halves.igs"
has "is one" 'body 1: closed, genus 0, area 600 mm2, volume 1000 mm3' "$TMP/err"
done_testing

#!/bin/sh
# planecut-order.t - the order of passes over several faces.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# Three plates of 20 x 40, 30 apart along the passes: each is cut whole, from the end of it that is
# nearest to the one before, and not from where the passes begin.
awk 'BEGIN { print "ply\nformat ascii 1.0\nelement vertex 12\nproperty double x\nproperty double y"
	print "property double z\nelement face 6\nproperty list uchar int vertex_indices\nend_header"
	for (p = 0; p < 3; p++) for (i = 0; i < 4; i++) print 50 * p + 20 * (i % 2), 40 * int(i / 2), 0
	for (a = 0; a < 12; a += 4) print 3, a, a + 1, a + 3 "\n" 3, a, a + 3, a + 2 }' >plates.ply
status 0 "three plates" planecut -q -r 2 -s 1 -a 0 -o plates.cl plates.ply
# links with a rapid motion between two cuts, and the longest of them in plan
awk -F'[/,]' '/^RAPID/ { rapid = 1 }
	/CONTCT\// { if (rapid && known) { n++; d = sqrt(($2 - x) ^ 2 + ($3 - y) ^ 2)
			if (d > far) far = d }
		x = $2; y = $3; known = 1; rapid = 0 }
	END { printf "%d %d\n", n, far + 0.5 }' plates.cl >jumps
ok "are cut one after the other, each from where it is near" test "2 30" = "$(cat jumps)"

done_testing

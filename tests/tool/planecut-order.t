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

# A cone's stump on a plate, sparse, with two holes: rows go on to the border of the scan and meet
# there, each point of them farther on than the one before. Where a strip grew past the end of the
# next one the row went 0.7 mm back and forth.
awk -v s=1 'function u() { s = (s * 16807) % 2147483647; return s / 2147483647 }
	BEGIN { for (i = 0; i < 500; i++) { x = 24 * u() - 12; y = 14 * u() - 7; z = 4 - sqrt(x * x + y * y)
		if (sqrt((x - 7) ^ 2 + (y - 3) ^ 2) < 2.5 || sqrt((x + 8) ^ 2 + (y + 2) ^ 2) < 2) continue
		printf "%.4f %.4f %.4f\n", x, y, (z > 0 ? 0 : (z < -3 ? -3 : z)) } }' >stump.xyz
cloud2mesh -q -a 20 -o stump.ply stump.xyz 2>/dev/null
planecut -q -r 0.5 --avoid -s 0.125 -g stump.xyz -o stump.cl stump.ply 2>/dev/null
awk -F'[/,]' '/PASS/ { n = 0 } /CONTCT/ { x = $2 + 0
		if (n > 1 && (x - a) * (a - b) < 0 && (x - a) ^ 2 > 0.01 && (a - b) ^ 2 > 0.01) back++
		b = a; a = x; n++; all++ }
	END { print back + 0, (all > 1000) }' stump.cl >back
ok "rows that are grown to the border of a scan do not go back" test "0 1" = "$(cat back)"

done_testing

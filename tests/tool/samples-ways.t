#!/bin/sh
# samples-ways.t - samples/ways.sh on a small scan: a program by each of the seven ways, all accepted.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A wave on a lattice of 0.6 mm, some of it hollow.
awk 'BEGIN { for (i = 0; i < 1600; i++) { x = (i % 40) * 0.6; y = int(i / 40) * 0.6
	printf "%.3f %.3f %.4f\n", x, y, 6 + 0.8 * sin(x / 5) * cos(y / 6) } }' >wave.xyz
status 0 "samples/ways.sh wave.xyz" sh "$SRC/samples/ways.sh" wave.xyz
cp out table
ok "a line for each way, under its head" test "$(wc -l <table)" -eq 8
for way in direct lin lai choi bspline ferguson bezier; do
	has "$way: accepted" "^wave +$way .* accepted$" table
done
below "the deepest gouge of all" "$(awk 'NR > 1 && $7 > most { most = $7 } END { print most }' table)" 0.02
below "the B-spline holds fewer control points than the grid nodes" \
	"$(awk '$2 == "bspline" { print $5 }' table)" "$(awk '$2 == "direct" { print $5 }' table)"
ok "two of the ways" sh -c "WAYS='lin lai' sh '$SRC/samples/ways.sh' wave.xyz | awk 'END { exit NR != 3 }'"
status 2 "no such scan" sh "$SRC/samples/ways.sh" nothing.xyz
done_testing

#!/bin/sh
# cloud2mesh-ways.t - the ways to a mesh that paper 1 reviews: what they make of known surfaces and
# of the panel, holes, what they refuse, and that a path follows.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz
cd "$TMP" || exit 1

# cloud HOLE Z: about 6,400 uneven points over 40 x 40 mm, none nearer than HOLE to the middle
cloud() {
	awk -v hole="$1" 'BEGIN { seed = 3 + 7919 * ENVIRON["SEED"]
		for (i = 0; i < 80; i++) for (j = 0; j < 80; j++) {
			seed = (seed * 16807) % 2147483647; x = (i + 0.7 * seed / 2147483647) / 2
			seed = (seed * 16807) % 2147483647; y = (j + 0.7 * seed / 2147483647) / 2
			if ((x - 20) ^ 2 + (y - 20) ^ 2 > hole ^ 2) printf "%.5f %.5f %.5f\n", x, y, '"$2"'
		} }'
}
# off Z FILE: the largest distance along z of a vertex from the surface z = Z
off() {
	awk '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next }
		body && k++ < n { x = $1; y = $2; d = $3 - ('"$1"'); if (d < 0) d = -d; if (d > w) w = d }
		END { printf "%.6f\n", w }' "$2"
}
# nearest X Y FILE: of a vertex to a place
nearest() {
	awk -v x="$1" -v y="$2" '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next }
		body && k++ < n { d = sqrt(($1 - x) ^ 2 + ($2 - y) ^ 2); if (k == 1 || d < w) w = d }
		END { print w }' "$3"
}
facets() { sed -n 's/^element face //p' "$1"; }

plane='5 + 0.3 * x - 0.2 * y'
wave='3 * sin(x / 7) * cos(y / 9)'
cloud 0 "$plane" >plane.xyz
cloud 0 "$wave" >wave.xyz
cloud 6 "$plane" >hole.xyz

# Lin and Liu: rows and columns
status 0 "lin: a plane" cloud2mesh --method lin -t 2 --noise 0 -o plane.ply plane.xyz
below "its vertices are on it" "$(off "$plane" plane.ply)" 0.00002
has "rows and columns" '^property int row$' plane.ply
result "$(awk '/^element vertex/ { exit !($3 == 441) }' plane.ply; echo $?)" "21 x 21 nodes, border to border"
has "the mesh names its scan" '^comment scan 6400 [0-9a-f]* plane.xyz$' plane.ply
status 0 "lin: a wave" cloud2mesh --method lin -t 1 --noise 0 -o wave.ply wave.xyz
below "by straight lines between points 0.5 mm apart" "$(off "$wave" wave.ply)" 0.05
has "how far the points are is said" 'the points are within 0\.[0-9]* mm of the mesh at worst' err
status 0 "lin: turned" cloud2mesh --method lin -t 1 -a 30 --noise 0 -o turned.ply plane.xyz
below "on the plane, too" "$(off "$plane" turned.ply)" 0.0002
has "the direction is said" '^comment direction 30$' turned.ply
status 0 "lin: a hole" cloud2mesh --method lin -t 1 --noise 0 -o hole.ply hole.xyz
below "it stays open" 4 "$(nearest 20 20 hole.ply)"
for threads in 1 3; do
	status 0 "$threads threads" cloud2mesh -j $threads --method lin -t 2 -o j$threads.ply "$panel"
done
same "the same bytes" j1.ply j3.ply
status 0 "lin: the panel's path" meshnorm -q -r 5 -o lin.cl j1.ply
has "it is guarded by the scan that the mesh names" 'SCAN/17036,' lin.cl
status 0 "its program" sh -c 'ncpost -q -c siemens lin.cl >lin.mpf'
status 0 "is accepted" ncverify -g "$panel" -r 5 -e 0.02 lin.mpf
status 2 "lin has no error" cloud2mesh --method lin -e 0.1 "$panel"
status 2 "and is not as published here" cloud2mesh --method lin --paper "$panel"
status 1 "far too fine" cloud2mesh --method lin -t 0.01 plane.xyz
has "is told" 'expected a wider spacing' err

# Delaunay: points of the scan
status 0 "delaunay: all points" cloud2mesh --method delaunay --noise 0 -o all.ply hole.xyz
has "are its vertices" "^element vertex $(wc -l <hole.xyz | tr -d ' ')\$" all.ply
below "the hole stays open" 5.99 "$(nearest 20 20 all.ply)"
hasnt "it has no rows" '^property int row$' all.ply
status 0 "delaunay: a wave within 0.02 mm" cloud2mesh --method delaunay --noise 0 -e 0.02 -o wave.ply wave.xyz
below "its vertices are points" "$(off "$wave" wave.ply)" 0.00002
below "few of them" "$(sed -n 's/^element vertex //p' wave.ply)" 1500
has "how far the others are" 'within 0\.0(1[0-9]*|200) mm of the mesh at worst' err
status 0 "delaunay: 500 of them" cloud2mesh --method delaunay --noise 0 --keep 500 -o keep.ply hole.xyz
has "are kept" '^element vertex 500$' keep.ply
below "the hole stays open" 5.5 "$(nearest 20 20 keep.ply)"
for threads in 1 3; do
	status 0 "$threads threads" cloud2mesh -j $threads --method delaunay -e 0.01 -o j$threads.ply "$panel"
done
same "the same bytes" j1.ply j3.ply
status 0 "delaunay: the panel's path" meshnorm -q -r 5 -o delaunay.cl j1.ply
has "it is guarded by the scan that the mesh names" 'SCAN/17036,' delaunay.cl
status 0 "its program" sh -c 'ncpost -q -c siemens delaunay.cl >delaunay.mpf'
status 0 "is accepted" ncverify -g "$panel" -r 5 -e 0.03 delaunay.mpf
status 2 "delaunay has no spacing" cloud2mesh --method delaunay -t 2 "$panel"
status 2 "parts without rows" cloud2mesh --method delaunay --subdivide "$panel"
status 2 "a count or an error" cloud2mesh --method delaunay -e 0.1 --keep 50 "$panel"
status 2 "a count is for it alone" cloud2mesh --keep 50 "$panel"

done_testing

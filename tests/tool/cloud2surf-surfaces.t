#!/bin/sh
# cloud2surf-surfaces.t - surfaces fitted to points of known ones, holes, what comes back from text
# and IGES, and the panel.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz
cd "$TMP" || exit 1

# cloud HOLE: about 3,600 uneven points of a wave over 30 x 30 mm, none nearer than HOLE to the middle
cloud() {
	awk -v hole="$1" 'BEGIN { seed = 3 + 7919 * ENVIRON["SEED"]
		for (i = 0; i < 60; i++) for (j = 0; j < 60; j++) {
			seed = (seed * 16807) % 2147483647; x = (i + 0.7 * seed / 2147483647) / 2
			seed = (seed * 16807) % 2147483647; y = (j + 0.7 * seed / 2147483647) / 2
			if ((x - 15) ^ 2 + (y - 15) ^ 2 > hole ^ 2)
				printf "%.6f %.6f %.6f\n", x, y, 2 * sin(x / 6) * cos(y / 5)
		} }'
}
# off FILE: the largest distance along z of the vertices of a mesh from the wave
off() {
	awk '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next }
		body && k++ < n { d = $3 - 2 * sin($1 / 6) * cos($2 / 5); if (d < 0) d = -d; if (d > w) w = d }
		END { printf "%.6f\n", w }' "$1"
}
# nearest FILE: of a vertex to the middle
nearest() {
	awk '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next }
		body && k++ < n { d = sqrt(($1 - 15) ^ 2 + ($2 - 15) ^ 2); if (k == 1 || d < w) w = d }
		END { print w }' "$1"
}
poles() { sed -n 's/.* = \([0-9]*\) control points$/\1/p' "$1"; }

cloud 0 >wave.xyz
cloud 5 >hole.xyz
for kind in bspline ferguson bezier; do
	status 0 "$kind" cloud2surf --$kind --noise 0 -e 0.005 -o $kind.nurbs hole.xyz
	has "the worst and the mean distance are told" 'within 0\.00[0-5][0-9]* mm of the surface at worst .* mm rms' err
	has "and the border" 'trimmed by the border of the scan: 2 loops' err
	ok "as a mesh" nurbs2mesh -q -e 0.005 -o $kind.ply $kind.nurbs
	below "it is the wave" "$(off $kind.ply)" 0.012
	below "the hole stays open" 4.5 "$(nearest $kind.ply)"
	status 0 "as IGES" cloud2surf -q --$kind --noise 0 -e 0.005 -o $kind.igs hole.xyz
	ok "read back" nurbs2mesh -q -e 0.005 -o igs.ply $kind.igs
	grep -v '^comment' $kind.ply >a.txt
	grep -v '^comment' igs.ply >b.txt
	same "to the same mesh" a.txt b.txt
	result "$(awk 'length($0) != 80 { bad = 1 } END { exit bad }' $kind.igs; echo $?)" "in lines of 80"
done
status 0 "untrimmed" cloud2surf --untrimmed --noise 0 -o whole.nurbs hole.xyz
hasnt "there is no loop" '^loop' whole.nurbs
status 0 "--iges to standard output" sh -c 'cloud2surf -q --iges --noise 0 -e 0.01 hole.xyz >out.igs'
has "is IGES" '^S +[0-9]+G +[0-9]+D +[0-9]+P +[0-9]+ +T +1$' out.igs
status 0 "turned" cloud2surf -q -a 40 --noise 0 -e 0.005 -o turned.nurbs wave.xyz
ok "as a mesh" nurbs2mesh -q -e 0.005 -o turned.ply turned.nurbs
below "it is the wave" "$(off turned.ply)" 0.012
status 0 "a net of 3 mm" cloud2surf --ferguson -t 3 --noise 0 -o net.nurbs wave.xyz
has "is one" '22 x 22 = 484 control points' err
status 3 "an error below what points carry" cloud2surf --ferguson -e 0.0000001 --noise 0 -o no.nurbs hole.xyz
has "is told" 'off the surface, expected 1e-07 mm' err

# the panel: fewer control points than any uniform net that comes as near
status 0 "the panel within 0.01 mm" cloud2surf -e 0.01 -o panel.nurbs "$panel"
has "at worst" 'within 0\.0(0[0-9]*|100) mm of the surface at worst' err
few=$(poles err)
status 0 "with equal distances" cloud2surf -e 0.01 --knots uniform -o uniform.nurbs "$panel"
below "control points" "$few" "$(poles err)"
status 0 "one thread" cloud2surf -q -j 1 -e 0.01 -o j.nurbs "$panel"
same "the same bytes" panel.nurbs j.nurbs

# by way of each kind of surface to a program, straight lines in planes a scallop of 0.1 mm apart,
# within 0.01 mm of the surface, that within 0.01 mm of the points: the middle of the panel
awk '$1 * $1 < 576 && $2 * $2 < 324' "$panel" >middle.xyz
for kind in bspline ferguson bezier; do
	ok "$kind of the panel" cloud2surf -q --$kind -e 0.01 -o $kind.nurbs middle.xyz
	ok "as a mesh" nurbs2mesh -q -e 0.005 -o $kind.ply $kind.nurbs
	status 0 "its path" planecut -q -r 5 --scallop 0.1 -o $kind.cl $kind.ply
	status 0 "its program" sh -c "ncpost -q -c siemens $kind.cl >$kind.mpf"
	status 0 "is accepted at 0.02 mm" ncverify -g middle.xyz -r 5 -e 0.02 $kind.mpf
done

# the surface names its scan: later tools guard by it, where it lies now
cloud2mesh -q -t 10 -u cm -o points.ply "$panel"
grep -E '^comment (scan|place)' points.ply >named
for kind in nurbs igs; do
	cloud2surf -q -u cm --bspline -e 0.3 -o named.$kind "$panel"
	nurbs2mesh -q -n 8 -o named.ply named.$kind
	grep -E '^comment (scan|place)' named.ply >got
	same "the mesh of .$kind names it as a mesh of the points does" named got
	nurbs2mesh -q -u inch -n 8 -o named.ply named.$kind 2>/dev/null
	hasnt "not where its unit is said to be another" '^comment scan' named.ply
done
result "$(awk 'length($0) != 80 { bad = 1 } END { exit bad }' named.igs; echo $?)" "lines of 80 all the same"
has "planecut, given no scan, names it in the path" \
	"SCAN.*$(wc -l <middle.xyz).*middle.xyz" bspline.cl

status 2 "two kinds" cloud2surf --bezier --ferguson wave.xyz
status 2 "a net for a B-spline" cloud2surf -t 2 wave.xyz
status 2 "knots for a net" cloud2surf --bezier --knots uniform wave.xyz
status 2 "a net and an error" cloud2surf --bezier -t 2 -e 0.1 wave.xyz
printf '0 0 0\n1 0 0\n2 0 0\n3 0 0\n' >line.xyz
status 1 "points on a line" cloud2surf line.xyz
done_testing

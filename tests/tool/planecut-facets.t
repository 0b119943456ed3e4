#!/bin/sh
# planecut-facets.t - meshes of long facets: what planecut ends with 0 for, who judges by the mesh
# accepts.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# cap SIGN NORMALS: a sphere of 20 down to 40 degrees from its top (1) or its bottom (-1), facets
# of 15 degrees; STL, or with NORMALS a PLY that has those of the sphere.
cap() {
	awk -v s="$1" -v normals="$2" 'function at(i, j, k, p, t) {
			t = 13.333333333 * i / 57.29577951; p = (j + i % 2 / 2) * 15 / 57.29577951
			k = i == 0 ? 0 : 24 * (i - 1) + j % 24 + 1
			x[k] = sin(t) * cos(p); y[k] = sin(t) * sin(p); z[k] = s * cos(t)
			return k
		}
		function facet(a, b, c) { face[f++] = s > 0 ? a " " b " " c : a " " c " " b }
		BEGIN {
		for (i = 0; i < 3; i++) for (j = 0; j < 24; j++) {
			a = at(i, j); b = at(i, j + 1); c = at(i + 1, j + i % 2); d = at(i + 1, j + 1 + i % 2)
			if (i == 0) { facet(a, c, d); continue }
			if (i % 2) { facet(a, at(i + 1, j), at(i + 1, j + 1)); facet(a, at(i + 1, j + 1), b) }
			else { facet(a, at(i + 1, j), b); facet(at(i + 1, j), at(i + 1, j + 1), b) }
		}
		if (normals) {
			print "ply\nformat ascii 1.0\nelement vertex 73"
			split("x y z nx ny nz", name, " ")
			for (k = 1; k <= 6; k++) print "property double " name[k]
			print "element face " f "\nproperty list uchar int vertex_indices\nend_header"
			for (k = 0; k < 73; k++)
				printf "%.9f %.9f %.9f %.9f %.9f %.9f\n", 20 * x[k], 20 * y[k], 20 * z[k],
					s * x[k], s * y[k], s * z[k]
			for (k = 0; k < f; k++) print 3, face[k]
			exit
		}
		print "solid cap"
		for (k = 0; k < f; k++) {
			split(face[k], v, " "); print "facet normal 0 0 0\nouter loop"
			for (i = 1; i <= 3; i++)
				printf "vertex %.9f %.9f %.9f\n", 20 * x[v[i]], 20 * y[v[i]], 20 * z[v[i]]
			print "endloop\nendfacet"
		}
		print "endsolid"
	}'
}

cap 1 "" >dome.stl
cap 1 1 >dome.ply
cap -1 1 >bowl.ply

# program MESH STATUS: its path ends with that, and the program of it is left in MESH.mpf.
program() {
	status "$2" "$1: a path" planecut -r 4 --scallop 0.03 --avoid -o "$1.cl" "$1"
	biarcfit -q -e 0.01 -o "$1.arc" "$1.cl"
	ncpost -q -c siemens -o "$1.mpf" "$1.arc"
}

# Facets of an STL are all that is known of the part: smooth between them, 0.3 mm of a dome stayed.
program dome.stl 0
status 0 "dome.stl: by the mesh the program is accepted" ncverify -g dome.stl dome.stl.mpf

# By its normals a hollow is below its facets: the ball went 0.4 mm into these.
program bowl.ply 0
status 0 "bowl.ply: by the mesh the program is accepted" ncverify -g bowl.ply bowl.ply.mpf

# A dome is above them, and both cannot be: what stays is told.
program dome.ply 3
has "dome.ply: what stays is told" 'who judges by the facets of the mesh alone takes' err

# The same of surfaces: what their facets are off is in the ledger, and no more than 0.05 mm deep.
# A quarter of the sample's, up to half of both its parameters, has its tightest hollow.
sed 's/^1\.,0\.,1\.;/.5,0.,.5;/' "$SRC/samples/paper2_s1_a.igs" >long.igs
status 0 "a hollow model of long facets" nurbs2mesh -q -e 0.1 -o long.ply long.igs
status 0 "its path" planecut -q -r 4 -s 2 -o long.cl long.ply
biarcfit -q -e 0.01 -o long.arc long.cl
ncpost -q -c siemens -o long.mpf long.arc
for judge in long.ply long.igs; do
	status 0 "accepted by $judge" ncverify -g $judge long.mpf
done

# A block between two corners, X Y Z each, two facets a side; OFF.
block() {
	cat <<END
OFF
8 12 0
$1 $2 $3
$4 $2 $3
$4 $5 $3
$1 $5 $3
$1 $2 $6
$4 $2 $6
$4 $5 $6
$1 $5 $6
3 0 2 1
3 0 3 2
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 1 2 6
3 1 6 5
3 2 3 7
3 2 7 6
3 3 0 4
3 3 4 7
END
}

# Walls that planes cannot follow are cut by rest passes, and measured.
block 0 0 0 10 8 3 >block.off
status 0 "a block with walls along the planes" \
	planecut -r 2 --scallop 0.05 --avoid -o block.cl block.off
biarcfit -q -e 0.01 -o block.arc block.cl
ncpost -q -c siemens -o block.mpf block.arc
status 0 "accepted by its mesh" ncverify -g block.off block.mpf

# So are those of a model, whose mesh has normals.
status 0 "a box with a chamfer" \
	nurbs2mesh -q -e 0.01 -o box.ply "$SRC/tests/data/cad/chamfer-ap214.step"
status 0 "its path" planecut -q -r 4 --scallop 0.2 --avoid -o box.cl box.ply
biarcfit -q -e 0.01 -o box.arc box.cl
ncpost -q -c siemens -o box.mpf box.arc
status 0 "accepted by its surfaces" ncverify -g "$SRC/tests/data/cad/chamfer-ap214.step" box.mpf

# What is left of a part of the mesh is measured, too, and cut: 0.09 mm stayed at its border.
status 0 "the lid and its chamfer" \
	planecut -q -r 2 --scallop 0.05 --avoid --steep 0:50 -o lid.cl box.ply
biarcfit -q -e 0.01 -o lid.arc lid.cl
ncpost -q -c siemens -o lid.mpf lid.arc
status 0 "accepted by the mesh as a part" ncverify -g box.ply --partial lid.mpf

# Where a path takes long, that is said before.
# ---- facets that the file's counts leave out would neither be cut nor guard; what stands before
awk 'NR == 2 { $2 -= 2 } { print }' block.off >less.off
status 1 "an OFF of more faces than it says" planecut -r 2 --avoid -o less.cl less.off
has "is refused with its line" 'less.off:[0-9]+: more than the [0-9]+ faces of the OFF' "$TMP/err"
ok "nothing is written" [ ! -e less.cl ]
{ head -c 80 /dev/zero && printf '\001\000\000\000' && head -c 100 /dev/zero; } >less.stl
status 1 "a binary STL of more facets than it says" planecut -r 2 --avoid less.stl
has "is refused" 'less.stl: more than the 1 facets of the binary STL.s count' "$TMP/err"
{ echo '# a block' && echo && sed '1s/.*/OFF # with words/' block.off; } >said.off
planecut -q -r 2 --scallop 0.05 --avoid -o said.cl said.off
sed 's/said\.off/block.off/' said.cl >said
same "words before an OFF" block.cl said

printf 'OFF\n4 2 0\n0 0 0\n20 0 0\n20 20 0\n0 20 0\n3 0 1 2\n3 0 2 3\n' >flat.off
status 0 "very many rows" planecut -r 0.4 -s 0.04 --ball-only -o flat.cl flat.off
has "are said" '10 m in [0-9]* strips, much for a ball of radius 0.4' err
status 0 "fewer" planecut -r 0.4 -s 0.1 --ball-only -o flat.cl flat.off
hasnt "are not" 'much for a ball' err

# Of vertices far closer than rows are, what is left is told by points half a row apart: as many
# square millimetres as the share of 24 x 24 mm that they are.
awk 'BEGIN {
	n = 240; print "OFF\n" (n + 1) * (n + 1), 2 * n * n, 0
	for (j = 0; j <= n; j++) for (i = 0; i <= n; i++)
		printf "%.1f %.1f %.6f\n", i / 10, j / 10, 4 * sin(i / 90) * cos(j / 140)
	for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
		k = j * (n + 1) + i; print 3, k, k + 1, k + n + 2; print 3, k, k + n + 2, k + n + 1
	}
}' >fine.off
run planecut -r 4 -s 2 -o fine.cl fine.off
told=$(sed -n 's/.*left though.*: \([0-9]*\) of \([0-9]*\) points[^)]*), \([0-9.]*\) mm2.*/\1 \2 \3/p' err)
below "points are half a row apart" "$(echo "$told" | cut -d' ' -f2)" 20000
below "area and share are alike" "$(echo "$told" |
	awk '{ a = $3 / 576; b = $1 / $2; print (b == 0 ? 9 : a > b ? a / b : b / a) }')" 1.1

# A box of another program, each side with corners and normals of its own: at its edges the ball
# rolls from one side to the other, and straight lines went 0.3 mm through them.
awk 'BEGIN {
	print "ply\nformat ascii 1.0\nelement vertex 24"
	split("x y z nx ny nz", word)
	for (k = 1; k <= 6; k++) print "property float " word[k]
	print "element face 12\nproperty list uchar int vertex_indices\nend_header"
	size[0] = 16; size[1] = 12; size[2] = 6
	for (side = 0; side < 6; side++) {
		a = int(side / 2); b = (a + 1) % 3; c = (a + 2) % 3
		for (k = 0; k < 4; k++) {
			n[a] = 2 * (side % 2) - 1; n[b] = n[c] = 0
			p[a] = side % 2 * size[a]; p[b] = (k == 1 || k == 2) * size[b]; p[c] = (k > 1) * size[c]
			print p[0], p[1], p[2], n[0], n[1], n[2]
		}
	}
	for (k = 0; k < 24; k += 4)
		print k % 8 ? "3 " k " " k + 1 " " k + 2 "\n3 " k " " k + 2 " " k + 3 : \
			"3 " k " " k + 2 " " k + 1 "\n3 " k " " k + 3 " " k + 2
}' >box.ply
status 0 "a box whose sides have normals" planecut -q -r 3 --scallop 0.05 --avoid -o box.cl box.ply
ncpost -q -c fanuc -o box.nc box.cl
status 0 "its edges are not cut" ncverify -q -e 0.02 --left 0.3 -g box.ply box.nc

# Below what is closed is no material, below a sheet there is; as -g, and as OFF.
ring() { # so many of the 24 strips of a ring, the first 12 are its upper half
	awk -v strips="$1" 'BEGIN {
		n = 48; m = 24; r = 8; t = atan2(0, -1) / 12
		print "OFF\n" n * m, 2 * n * strips, 0
		for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
			q = 20 + r * cos(j * t); print q * cos(i * t / 2), q * sin(i * t / 2), r * sin(j * t) }
		for (i = 0; i < n; i++) for (j = 0; j < strips; j++) {
			a = i * m + j; b = (i + 1) % n * m + j; c = (i + 1) % n * m + (j + 1) % m
			print 3, a, b, c; print 3, a, c, i * m + (j + 1) % m }
	}'
}
ring 24 >closed.off
ring 12 >open.off
for part in closed open; do
	status 0 "$part: a ring guards itself" \
		planecut -v -r 2 -s 4 --avoid -g $part.off -o $part.cl $part.off
	cp err $part.err
	has "by its facets" "^planecut: $part.off: a mesh: guarded by [0-9]+ points on its facets" err
	has "the path names it" "^..-> SCAN/1152,[0-9a-f]{16},$part.off\$" $part.cl
done
# A bar, all of whose facets are slender: where two of them meet is an edge, and not only corners.
block -30 -1.5 -2 30 1.5 2 >bar.off
status 0 "a bar" planecut -q -r 8 -a 70 --tilt 12 --avoid --scallop 0.2 -o bar.cl bar.off
ncpost -q -c linuxcnc -o bar.nc bar.cl
status 0 "its edges are not cut" ncverify -q -g bar.off -r 8 bar.nc
has "material under the border" 'and by [0-9]+ points under the rims' open.err
hasnt "none where there is no border" 'under the rims' closed.err
done_testing

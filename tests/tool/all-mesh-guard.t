#!/bin/sh
# all-mesh-guard.t - a mesh in place of a scan: of a few large facets too the tool keeps clear, not
# of their corners alone, whatever the file is called, and who judges takes it for the same.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A pyramid of four facets, 40 mm wide and 12 high, and the same as PLY, as OFF and in inches.
cat >pyramid.off <<'EOF'
OFF
5 4 0
-20 -20 0
20 -20 0
20 20 0
-20 20 0
0 0 12
3 0 1 4
3 1 2 4
3 2 3 4
3 3 0 4
EOF
ply() { # UNIT
	awk -v unit="$1" 'NR == 2 { printf "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\n" \
		"property double y\nproperty double z\nelement face 4\nproperty list uchar int vertex_indices\n" \
		"end_header\n"; next }
	NR > 2 && NR < 8 { print $1 / unit, $2 / unit, $3 / unit; next } NR >= 8' pyramid.off
}
ply 1 >pyramid.ply
ply 25.4 >inch.ply
awk 'NR > 2 && NR < 8 { v[NR - 3] = $0 }
	NR >= 8 { print "facet normal 0 0 0\nouter loop"; for (i = 2; i <= 4; i++) print "vertex", v[$i]
		print "endloop\nendfacet" }
	NR == 1 { print "solid pyramid" } END { print "endsolid pyramid" }' pyramid.off >pyramid.stl

tr a-z A-Z <pyramid.stl >capitals.stl

for part in pyramid.ply pyramid.stl capitals.stl; do
	status 0 "planecut guards by $part" planecut -r 3 --scallop 0.03 --avoid -g $part -o path.cl \
		pyramid.off
	has "and says how" "$part: a mesh: guarded by [0-9]+ points on its facets, too" "$TMP/err"
	ncpost -q -c siemens -o part.mpf path.cl
	grep -v '^; SCAN:' part.mpf >$part.blocks
	case $part in # by its name, by another of the same surface, by what is in it
	pyramid.ply) judges="pyramid.ply pyramid.off named" ;;
	pyramid.stl) judges=named ;;
	capitals.stl) judges=capitals.stl ;;
	esac
	cp $part named
	for judge in $judges; do
		status 0 "ncverify accepts it by $judge" ncverify -v -g "$judge" part.mpf
		has "which is a mesh" "$judge: points 0\.[0-9]+ mm apart on its faces" "$TMP/err"
	done
done
same "guarded by either it is the same program" pyramid.ply.blocks pyramid.stl.blocks
same "and by one in capitals" pyramid.ply.blocks capitals.stl.blocks
status 0 "planecut of one in capitals" \
	planecut -q -r 3 --scallop 0.03 --avoid --partno PYRAMID -o capitals.cl capitals.stl
planecut -r 3 --scallop 0.03 --avoid --partno PYRAMID -o small.cl pyramid.stl 2>said
sed -i '/MESH\/.*pyramid.stl$/d' small.cl
sed -i '/MESH\/.*capitals.stl$/d' capitals.cl
same "is the same path, but for the mesh's name" small.cl capitals.cl
has "the size of a mesh without units is said" \
	'^planecut: pyramid.stl: 40 x 40 x 12 mm, its unit taken as mm$' said
sed '2s/$/\ncomment Units: inches/' inch.ply >units.ply
run planecut -r 0.1 -s 0.1 --avoid -o units.cl units.ply
has "and that a comment says another" \
	'units.ply: a comment calls the unit .inches., which is not' err
status 0 "ncplot of it" ncplot -o capitals.svg capitals.stl

# A smaller one is cut as well where a mesh guards as where none does: the part ends at its border,
# no mean of normals lifts the ball beside its sharp edges, and what is left is measured at close
# points of its facets.  Before, 0.13 mm stayed, planecut ended with 0, and it was refused.
awk 'NR > 2 && NR < 8 { print $1 / 2, $2 / 2, $3 / 2; next } { print }' pyramid.off >half.off
awk '/vertex/ { print $1, $2 / 2, $3 / 2, $4 / 2; next } { print }' pyramid.stl >half.stl
status 0 "planecut cuts a pyramid of 20 mm" planecut -v -r 3 --scallop 0.03 --avoid -g half.stl \
	-o half.cl half.off
hasnt "whose border is that of the part" 'rim of the scan' "$TMP/err"
has "nor is the ball lifted beside its crest" 'points lifted, at most by 0.00[0-9]+ mm' "$TMP/err"
has "what is left is measured on its facets" 'all of [0-9]{5} points within reach' "$TMP/err"
ncpost -q -c siemens -o half.mpf half.cl
status 0 "ncverify accepts it" ncverify -q -g half.stl half.mpf
status 0 "bsplfit fits it" bsplfit -q -e 0.01 -g half.stl -o half.curves half.cl
ncpost -q -c siemens -o half.mpf half.curves
status 0 "ncverify accepts that, too" ncverify -q -g half.stl half.mpf
# A sloped roof on walls.
awk 'BEGIN { split("0 0 0 9 0 0 9 6 0 0 6 0 0 0 3 9 0 6 9 6 6 0 6 3", p)
	split("3 2 1 3 1 0 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7 4 5 6 4 6 7", v)
	print "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y"
	print "property double z\nelement face 12\nproperty list uchar int vertex_indices\nend_header"
	for (i = 0; i < 8; i++) print p[3 * i + 1], p[3 * i + 2], p[3 * i + 3]
	for (i = 0; i < 12; i++) print 3, v[3 * i + 1], v[3 * i + 2], v[3 * i + 3] }' >roof.ply
status 0 "planecut cuts a sloped roof on walls" planecut -q -r 3 --scallop 0.03 --avoid \
	-g roof.ply -o roof.cl roof.ply
ncpost -q -c siemens -o roof.mpf roof.cl
status 0 "ncverify accepts it" ncverify -q -g roof.ply roof.mpf

# A path 0.3 mm too deep in the middle of a facet, far from its corners.
awk 'BEGIN { print "PARTNO/deep\nUNITS/MM\nMULTAX/ON\nCUTTER/6,3,0,3,0,0,60\nFEDRAT/MMPM,500"
	for (x = 6; x <= 14; x += 0.5)
		printf "GOTO/%.4f,0,%.4f,0,0,1\n", x, (20 - x) * 0.6 + 3 * sqrt(1.36) - 3 - 0.3
	print "FINI" }' >deep.cl
for fit in biarcfit bsplfit; do
	for part in pyramid.stl pyramid.ply; do
		$fit -v -e 0.01 -g $part -o fitted.cl deep.cl 2>log
		has "$fit keeps off $part" 'points lifted by at most 0\.3|deep' log
	done
done
ncverify -r 3 -g - -o verdict part.mpf <pyramid.ply 2>log
has "of a mesh that is piped in the corners are a scan, and this is said" \
	'^ncverify: -: a mesh that is piped in: the corners of its 4 facets are taken' log

# A scan with facets, in inches: the mesh made of its points names it, and its facets guard in mm.
awk 'BEGIN { print "ply\nformat ascii 1.0\nelement vertex 121\nproperty double x\nproperty double y"
	print "property double z\nelement face 200\nproperty list uchar int vertex_indices"
	print "end_header"
	for (j = 0; j <= 10; j++) for (i = 0; i <= 10; i++) printf "%.5f %.5f %.5f\n", i * 3 / 25.4, \
		j * 3 / 25.4, (5 - ((i - 5) ^ 2 + (j - 5) ^ 2) / 20) / 25.4
	for (j = 0; j < 10; j++) for (i = 0; i < 10; i++) { a = 11 * j + i
		printf "3 %d %d %d\n3 %d %d %d\n", a, a + 1, a + 12, a, a + 12, a + 11 } }' >dome.ply
status 0 "cloud2mesh takes its corners" cloud2mesh -u inch -t 3 -o mesh.ply dome.ply
has "and says so" 'dome.ply: a mesh: the corners of its 200 facets are taken as points' "$TMP/err"
meshnorm -r 3 -o path.cl mesh.ply 2>log
has "its facets guard, in mm" \
	'dome.ply: a mesh: guarded by [0-9]+ points on its facets, too, 0.75 mm apart' log
# And moved: it is judged where the program's head says.
printf '0 -1 0 40\n1 0 0 -7\n0 0 1 3\n0 0 0 1\n' >matrix
cloud2mesh -q -u inch --matrix matrix -t 1 -o mesh.ply dome.ply 2>/dev/null
meshnorm -q -r 3 --avoid -o path.cl mesh.ply
for c in fanuc siemens; do
	biarcfit -q -e 0.01 path.cl 2>/dev/null | ncpost -q -c $c -o part.nc
	status 0 "$c: ncverify accepts it by the scan as it stands" ncverify -v -g dome.ply part.nc
	has "for it is placed" 'dome.ply: placed as the program.s head says' "$TMP/err"
	status 0 "$c: and by the mesh, where that is" ncverify -v -g mesh.ply part.nc
	hasnt "which is not placed" 'placed as' "$TMP/err"
done

# A gentle wave as a mesh of 1 mm: its flanks alone, rows whose ends roll over the mesh's border, where
# between corners a ball of 6 mm sank 0.014 mm into the facets. So narrow a part has no outline: the
# head promises no scallop, and none is asked for.
awk -v s=6 'function u() { s = (s * 16807) % 2147483647; return s / 2147483647 }
	BEGIN { for (i = 0; i < 300; i++) { x = 10 * u() - 5; y = 6 * u() - 3
		printf "%.4f %.4f %.4f\n", x, y, 0.5 * sin((x + 0.5 * y) / 2) } }' >wave.xyz
cloud2mesh -q -t 1 -o wave.ply wave.xyz
status 0 "planecut cuts the flanks of a wave" planecut -r 6 --avoid --tilt 0 --steep 10:45 \
	--scallop 0.01 -g wave.ply -o flanks.cl wave.ply
has "that are too narrow to be judged, which is said" 'no outline, .*: what stays of it' "$TMP/err"
hasnt "with no scallop promised" '^\$\$-> SCALLOP' flanks.cl
ncpost -q -c siemens -o flanks.mpf flanks.cl
status 0 "ncverify accepts them by the facets" ncverify -q --partial -g wave.ply flanks.mpf

# A mesh through points as they are, with noise: its facets are the part. What was put between its
# corners for noise kept the ball off, and where noise was taken out the ball went into the facets.
awk -v s=3 'function u() { s = (s * 16807) % 2147483647; return s / 2147483647 }
	BEGIN { for (i = 0; i < 400; i++) { x = 24 * u() - 12; y = 24 * u() - 12
		printf "%.4f %.4f %.4f\n", x, y, 0.06 * x * y + 0.1 * (u() + u() + u() - 1.5) } }' >rough.xyz
cloud2mesh -q -t 2 --noise 0 -o rough.ply rough.xyz 2>/dev/null
status 0 "meshnorm guards by a rough mesh" meshnorm -v -r 6 --avoid -g rough.ply -o rough.cl rough.ply
has "by its facets alone" '^meshnorm: guarded by the facets of a mesh: [0-9]+ points' "$TMP/err"
status 0 "biarcfit, too" biarcfit -q -e 0.01 -o rough.arcs rough.cl
ncpost -q -c siemens -o rough.mpf rough.arcs
status 0 "ncverify accepts it" ncverify -q -g rough.ply rough.mpf
done_testing

#!/bin/sh
# cloud2mesh-clean.t - which points of a scan are believed: --clean writes them as they were read and
# the others apart, later tools believe the same, and two sheets are told.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A hill with noise of 0.01 and five strays, in no order; row 100 and so on.
awk 'function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) }
	BEGIN { srand(5 + ENVIRON["SEED"]); for (i = 0; i < 6000; i++) { x = 30 * rand(); y = 20 * rand()
		z = 3 + sin(x / 5) * cos(y / 6) + 0.01 * normal(); if (i % 1200 == 100) z += 2 + i / 1000
		printf "%.4f %.4f %.4f\n", x, y, z > (i % 1200 == 100 ? "strays" : "good"); printf "%.4f %.4f %.4f\n", x, y, z } }' >scan.xyz

rows() { # FILE: without comments, numbers as awk has them
	awk '!/^#/ { printf "%.4f %.4f %.4f\n", $1, $2, $3 }' "$1"
}

status 0 "a scan with strays" cloud2mesh -q -t 2 --clean clean.xyz -o mesh.ply scan.xyz
rows clean.xyz >a
rows clean.xyz.outliers >b
same "what is believed, as it was read" a good
same "the outliers apart" b strays
has "it says how many" '^# 5995 points believed of scan.xyz$' clean.xyz
has "both say how many" '^# 5 outliers of scan.xyz$' clean.xyz.outliers
has "the mesh names the scan that was given" '^comment scan 6000 [0-9a-f]* scan.xyz$' mesh.ply
meshnorm -r 3 --rows mesh -o of.cl mesh.ply 2>log
has "the guard finds the same" 'left out 5 outliers of the scan that guards' log
meshnorm -r 3 --rows mesh --noise 0 -o of.cl mesh.ply 2>log
hasnt "--noise 0: all points guard" 'outliers of the scan' log
cloud2mesh -t 2 clean.xyz -o cleaned.ply 2>log
hasnt "nothing is left out of a clean scan" 'outlier' log

status 0 "--noise 0 believes all" cloud2mesh -q -t 2 --noise 0 --clean all.xyz -o all.ply scan.xyz
rows all.xyz >a
same "all of them" a scan.xyz
has "and no outliers" '^# 0 outliers' all.xyz.outliers

status 0 "other units and places" cloud2mesh -q -t 50 -u inch --origin --clean inch.xyz -o inch.ply scan.xyz
same "the same are believed, in the units of the scan" inch.xyz clean.xyz
cloud2mesh -q -t 2 --clean piped.xyz <scan.xyz >piped.ply 2>/dev/null
has "a scan that was piped in is named by what is believed" '^comment scan 5995 [0-9a-f]* piped.xyz$' piped.ply
status 2 "not to standard output" cloud2mesh --clean - scan.xyz

# What is believed of a scan takes the place of no scan.
cp scan.xyz kept.xyz
ln -s scan.xyz link.xyz
status 2 "a scan is no place for what is believed of it" \
	cloud2mesh -q --clean scan.xyz -o m.ply scan.xyz
has "is told" 'option --clean: found scan.xyz, which is read, expected another file' "$TMP/err"
status 2 "nor by another name" cloud2mesh -q --clean link.xyz -o m.ply scan.xyz
same "the scan is as it was" scan.xyz kept.xyz
status 2 "two results in one file" cloud2mesh -q --clean x.ply -o x.ply scan.xyz
ok "nothing is there then" [ ! -e x.ply ]

# The right half was scanned twice, the second time 0.06 mm too high.
awk '{ print } $1 > 15 { printf "%.4f %.4f %.4f\n", $1 + 0.11, $2 + 0.07, $3 + 0.06 }' good >twice.xyz
cloud2mesh -t 2 twice.xyz -o twice.ply 2>log
has "two sheets are told" 'two sheets of points lie over each other, 0\.0[567][0-9]* mm apart .* at (1[4-9]|2[0-9]|30)\.' log
meshnorm -r 3 --rows mesh -o twice.cl twice.ply 2>log
has "by the guard too" 'two sheets of points' log
hasnt "their distance is no noise" 'taken out' log
cloud2mesh -t 2 good -o good.ply 2>log
hasnt "one scan has one sheet" 'two sheets' log
done_testing

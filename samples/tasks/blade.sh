#!/bin/sh
# blade.sh [FOLDER] - the side of a turbine blade as a NURBS surface, written here as text (cloudmill-nurbs(5)):
# a bicubic with a hollow that twists along the blade; cut along it on a Siemens, as B-splines.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"

# 7 poles across the chord of 40 mm, 6 along the span of 60; the sections turn by 6 degrees each.
awk 'BEGIN {
	print "nurbs 1 surface degree 3 3 poles 7 6"
	print "knots_u 0 0 0 0 1 2 3 4 4 4 4 knots_v 0 0 0 0 1 2 3 3 3 3\npoints"
	split("0 4 6.5 7 5.5 3 0", camber, " ")
	for (j = 0; j < 6; j++) for (i = 0; i < 7; i++) {
		x = (i - 3) * 40 / 6; z = camber[i + 1]; a = (j - 2.5) * 6 * 3.14159265 / 180
		printf "%.6f %.6f %.6f\n", x * cos(a) - z * sin(a), j * 12, 20 + x * sin(a) + z * cos(a)
	}
	print "end" }' >blade.nurbs

nurbs2mesh -q -e 0.003 blade.nurbs -o blade.ply
planecut -q -r 4 --scallop 0.01 -a 90 blade.ply -o blade.cl
bsplfit -q -e 0.01 blade.cl -o splines.cl
ncpost -q -c siemens -m table-bc splines.cl -o blade.mpf
check blade blade.mpf -m table-bc -g blade.ply -r 4 -e 0.02
figure splines "$(grep -cE 'BSPLINE|POLY' blade.mpf)"

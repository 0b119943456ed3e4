#!/bin/sh
# normals.sh [FOLDER] - a stage of one's own between two of ours: normals.py, a few lines of Python, takes
# the mesh from cloud2mesh and gives it other normals for meshnorm.  The angle between both is the
# figure; the program is checked as any other.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"
scan=$samples/panel_17036.xyz
cloud2mesh -q -t 2 "$scan" -o ours.ply
python3 "$here/normals.py" <ours.ply >theirs.ply
meshnorm -q -r 6 --scallop 0.05 -g "$scan" theirs.ply | biarcfit -q -e 0.01 | ncpost -q -c siemens -o theirs.mpf
check theirs theirs.mpf -g "$scan" -r 6 -e 0.02
awk 'FNR == 1 { body = 0 } /^element vertex/ { n = $3 } /^end_header/ { body = FNR; next }
	body && FNR <= body + n {
		if (FILENAME == "ours.ply") { a[FNR - body] = $4 " " $5 " " $6; next }
		split(a[FNR - body], m, " "); dot = m[1] * $4 + m[2] * $5 + m[3] * $6
		angle = dot < 1 ? atan2(sqrt(1 - dot * dot), dot) * 57.29578 : 0
		if (angle > worst) worst = angle }
	END { print "figure degrees", worst }' ours.ply theirs.ply

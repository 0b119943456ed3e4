#!/bin/sh
# face.sh [FOLDER] - a scanned face on a Fanuc and on a Siemens: one path, one fit of arcs, two programs,
# each checked.  Of the scan the first POINTS points (6000; `make samples` takes all 26,493, with a
# scallop of 0.15 mm instead of 0.4).  The path is planned for the machine with the narrower limits:
# its table tilts to B-5 alone, and its Z ends just above the part, hence the low clearance plane.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"
points=${POINTS:-6000} scallop=0.4
[ "$points" -le 6000 ] || scallop=0.15
head -n "$points" "$samples/face_nefertiti_26493.xyz" >face.xyz

cloud2mesh -q face.xyz -o face.ply
meshnorm -q -r 5 --scallop $scallop --avoid -m dmg-dmu50 --clearance 65 face.ply -o face.cl
biarcfit -q -e 0.01 face.cl -o arcs.cl
ncpost -q -c fanuc arcs.cl -o face.nc
ncpost -q -c siemens -m dmg-dmu50 arcs.cl -o face.mpf
check fanuc face.nc -g face.xyz -r 5 -e 0.02
check siemens face.mpf -m dmg-dmu50 -g face.xyz -r 5 -e 0.02
figure arcs "$(grep -c 'I1=' face.mpf)"

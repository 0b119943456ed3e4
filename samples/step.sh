#!/bin/sh
# step.sh [MODEL [RADIUS [STEP]]] - from a CAD model (STEP or IGES) to an NC program in one pipe of
# three tools, and the program checked; by default a box with a round hole, of which what is flat is
# cut.  BIN: where the tools are.
dir=$(cd "$(dirname "$0")" && pwd) || exit 1
BIN=${BIN:-$dir/../build/bin}
CLOUDMILL_MACHINES=${CLOUDMILL_MACHINES:-$dir/../machines}
export CLOUDMILL_MACHINES
tmp=$(mktemp -d "${TMPDIR:-/tmp}/step.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
model=${1:-$dir/../tests/data/box.step}

radius=${2:-2}

"$BIN/nurbs2mesh" -e 0.01 "$model" |
	"$BIN/planecut" -r "$radius" -s "${3:-1}" --steep 0:45 --avoid |
	"$BIN/ncpost" -c fanuc -m head-ca >"$tmp/program.nc" || exit 1
echo "$(wc -l <"$tmp/program.nc") lines"
"$BIN/nurbs2mesh" -q -e 0.01 -o "$tmp/model.ply" "$model" &&
	"$BIN/ncverify" -c fanuc -m head-ca --partial -r "$radius" -g "$tmp/model.ply" "$tmp/program.nc"

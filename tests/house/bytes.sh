#!/bin/sh
# bytes.sh - a chain of small jobs through all tools, for mutate.sh: does a changed tool still write
# the same bytes, with the same exit status?  What freeze.sh asks of thousands of jobs in half an
# hour, in seconds; it says that a change is noticed, not which of the two is right.
#
#	BIN=build/bin sh tests/house/bytes.sh --make DIR    runs all jobs there
#	BIN=build/bin sh tests/house/bytes.sh DIR NAME      runs one again: exit 0 if it is the same
#	sh tests/house/bytes.sh --names
SRC=$(cd "$(dirname "$0")/../.." && pwd)
PATH=${BIN:-$SRC/build/bin}:$PATH
CLOUDMILL_MACHINES=$SRC/machines
CLOUDMILL_CONTROLS=$SRC/controls
LC_ALL=C
export SRC PATH CLOUDMILL_MACHINES CLOUDMILL_CONTROLS LC_ALL
# shellcheck source=tests/house/inputs.sh
. "$SRC/tests/house/inputs.sh"

# NAME COMMAND: its standard output is the file of that name, for the lines after it
jobs() {
	cat <<-'END'
		wave.xyz shape wave 16 12 0.5
		noise.xyz shape dome 16 12 0.5 0.02 lines
		roof.xyz shape roof 14 12 0.5 0.01 random
		rib.xyz shape rib 14 14 0.4 0 random
		wall.xyz shape wall 14 12 0.6 0 random
		hole.xyz shape hole 24 24 0.8 0 random
		ball.xyz ball 4 0 1500
		wave.ply cloud2mesh --nodes scan wave.xyz
		wave-e.ply cloud2mesh -e 0.02 wave.xyz
		noise.ply cloud2mesh noise.xyz
		noise-e.ply cloud2mesh -e 0.05 --extend 1 noise.xyz
		roof.ply cloud2mesh roof.xyz
		rib.ply cloud2mesh rib.xyz
		wall.ply cloud2mesh wall.xyz
		hole.ply cloud2mesh --extend 1 hole.xyz
		ball.ply cloud2mesh --subdivide ball.xyz
		paper.ply cloud2mesh --paper -t 1.5 wave.xyz
		lin.ply cloud2mesh --method lin wave.xyz
		delaunay.ply cloud2mesh --method delaunay --keep 100 wave.xyz
		wave.nurbs cloud2surf --bspline -e 0.02 wave.xyz
		bezier.nurbs cloud2surf --bezier wave.xyz
		patches.igs iges trimmed
		torus.nurbs surface torus
		meet.nurbs surface meet
		trimmed.ply nurbs2mesh -n 8 --partial patches.igs
		torus.ply nurbs2mesh -e 0.5 torus.nurbs
		meet.ply nurbs2mesh -n 8 meet.nurbs
		box.ply nurbs2mesh -n 4 "$SRC/tests/data/box.step"
		wave.cl meshnorm -r 2 --rows mesh -g wave.xyz wave.ply
		scallop.cl meshnorm -r 2 --scallop 0.05 --avoid -g wave.xyz wave.ply
		noise.cl meshnorm -r 4 --lead 5 --tilt 10 -g noise.xyz noise.ply
		fixed.cl meshnorm -r 3 --fixed 0,0,1 --layers 2 noise.ply
		holder.cl meshnorm -r 2 --holder 1.5:6+4:20 --lean-limit 40 -g wave.xyz wave.ply
		roof.cl meshnorm -r 2 --avoid -g roof.xyz roof.ply
		ball.cl meshnorm -r 2 -g ball.xyz ball.ply
		cut.cl planecut -r 2 -s 1.5 -g wave.xyz wave.ply
		cut-scallop.cl planecut -r 3 --scallop 0.05 --direction auto noise.ply
		torus.cl planecut -r 4 -s 4 --normal 0,0,1 --avoid torus.ply
		arcs.cl biarcfit -e 0.02 wave.cl
		arcs-f.cl biarcfit -e 0.02 --no-guard fixed.cl
		arcs-paper.cl biarcfit --paper -e 0.05 fixed.cl
		splines.cl bsplfit -e 0.02 wave.cl
		splines-f.cl bsplfit -e 0.02 --no-guard fixed.cl
		splines-paper.cl bsplfit --paper -e 0.05 fixed.cl
		shapes.cl path shapes
		tools.cl path tools | sed /FROB/d
		holes.cl path holes
		winding.cl path winding
		tilted.cl path tilted
		nx.cl path nx
		catia.cl path catia
		creo.cl path creo
	END
	for control in fanuc siemens heidenhain linuxcnc; do
		for path in arcs splines shapes tools holes winding tilted; do
			echo "$path.$control ncpost -c $control --no-spindle $path.cl"
			echo "$path.$control.txt ncverify -c $control -g wave.xyz -r 2 $path.$control"
		done
		echo "notcp.$control ncpost -c $control --set tcp=no shapes.cl"
		echo "head.$control ncpost -c $control -m head-ca splines.cl"
		echo "plane.$control ncpost -c $control --plane tilted.cl"
	done
	cat <<-'END'
		nx.nc ncpost -c fanuc nx.cl
		catia.nc ncpost -c siemens catia.cl
		creo.nc ncpost -c fanuc creo.cl
		explain.txt ncpost -c fanuc --explain 20 shapes.cl
		from.nc ncpost -c fanuc --from 2 shapes.cl
		map.ply ncverify -c fanuc -g wave.xyz -r 2 --map /dev/stdout splines.fanuc
		page.html ncverify -c fanuc -g wave.xyz -r 2 --report /dev/stdout arcs.fanuc
		wave.svg ncplot wave.xyz wave.ply arcs.cl
		program.svg ncplot --speed shapes.fanuc
		compare.svg ncplot --compare wave.ply noise.ply
		splines.svg ncplot --poles --axes --normals splines.cl
	END
}

case ${1:-} in
--names)
	jobs | cut -d ' ' -f 1
	;;
--make)
	mkdir -p "$2" && cd "$2" || exit 1
	jobs | while read -r name command; do
		(eval "$command") >"$name" 2>/dev/null </dev/null
		echo $? >"$name.status"
	done
	: >made
	;;
*)
	cd "$1" || exit 1
	command=$(jobs | awk -v name="$2" '$1 == name { sub(/^[^ ]+ /, ""); print }')
	again=$(mktemp "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
	trap 'rm -f "$again"' EXIT
	(eval "$command") >"$again" 2>/dev/null </dev/null
	[ $? -eq "$(cat "$2.status")" ] && cmp -s "$again" "$2"
	;;
esac

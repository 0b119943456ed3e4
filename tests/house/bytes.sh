#!/bin/sh
# bytes.sh - a chain of small jobs through all tools, for mutate.sh: does a changed tool still write
# the same bytes, with the same exit status and words on standard error?  What freeze.sh asks of
# thousands of jobs in half an hour, in seconds; it says that a change is noticed, not which of the
# two is right.
#
#	BIN=build/bin sh tests/house/bytes.sh --make DIR    runs all jobs there
#	BIN=build/bin sh tests/house/bytes.sh DIR NAME      runs one again: exit 0 if it is the same
#
# DIR/list has for each its seconds of processor time, its name and the tools that it runs.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
PATH=${BIN:-$SRC/build/bin}:$PATH
CLOUDMILL_MACHINES=$SRC/machines
CLOUDMILL_CONTROLS=$SRC/controls
CLOUDMILL_TOOLS=$SRC/tools
LC_ALL=C
export SRC PATH CLOUDMILL_MACHINES CLOUDMILL_CONTROLS CLOUDMILL_TOOLS LC_ALL
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
		wave.arcs.compare ncverify -c fanuc -r 2 -g wave.xyz -p wave.cl arcs.fanuc
		wave.splines.compare judged siemens -p wave.cl --map /dev/stdout splines.siemens
		stock.txt judged fanuc --stock box,1 --cell 0.5 splines.fanuc
		stock-holder.txt judged fanuc --stock offset,1 --holder 2:5+8:30 --map /dev/stdout arcs.fanuc
		stock-page.html judged fanuc --stock box --cell 0.6 --report /dev/stdout splines.fanuc
		partial.txt judged fanuc --partial -e 0.001 --left 0.01 --flute 20 splines.fanuc
		surfaces.txt ncverify -c fanuc -r 2 -g wave.nurbs splines.fanuc
		stream.ply cloud2mesh --stream -t 2 noise.xyz
		stray.xyz { cat noise.xyz; echo 1 1 30; echo 2 2 -9; cat noise.xyz | head -n 9; }
		stray.ply cloud2mesh stray.xyz
		stray-keep.ply cloud2mesh --outliers keep --normals facet -t 2 stray.xyz
		inch.ply cloud2mesh -u inch --origin -t 30 wave.xyz
		roof-free.ply cloud2mesh --no-features -t 1.5 roof.xyz
		block.xyz shape block 20 16 0.5 0 random
		block.ply cloud2mesh -t 2 block.xyz
		corner.xyz shape corner 16 16 0.5 0 random
		corner.ply cloud2mesh -t 4 corner.xyz
		box.xyz box
		box-parts.ply cloud2mesh --subdivide -t 2 box.xyz
		meet.igs cloud2surf --bspline -e 0.02 --iges wave.xyz
		igs.ply nurbs2mesh -n 12 meet.igs
		bezier.igs cloud2surf --bezier -t 12 --iges wave.xyz
		down.ply nurbs2mesh --up 0,0,-1 -n 10 bezier.igs
		grid nurbs2mesh --grid 6 meet.nurbs
		radii nurbs2mesh -k torus.nurbs
		both nurbs2mesh -n 4 -e 0.1 torus.nurbs
	END
	for kind in bounded placed cylinder; do
		echo "$kind.igs iges $kind"
		echo "$kind.ply nurbs2mesh -e 0.1 $kind.igs"
	done
	for kind in sphere cube frame disc part; do
		echo "$kind.nurbs surface $kind"
		echo "$kind.ply nurbs2mesh -n 6 $kind.nurbs"
	done
	cat <<-'END'
		region.txt printf -- '-5 -4\n5 -4\n5 4\n-5 4\n\n-2 -2\n2 -2\n0 2\n'
		region.cl meshnorm -r 2 --region region.txt wave.ply
		region-cut.cl planecut -r 2 -s 1 --region region.txt wave.ply
		boxed.cl meshnorm -r 2 --box -4,-4,-9,4,4,9 wave.ply
		boxed-cut.cl planecut -r 2 -s 1 --box -4,-4,-9,4,4,9 -a 30 wave.ply
		from-point.cl meshnorm --rows mesh -r 3 --from-point 0,0,-90 --one-way noise.ply
		to-point.cl planecut -r 3 -s 2 --to-point 0,0,99 --tool 3 --coolant off noise.ply
		circle.cl meshnorm --rows mesh -r 3 --circle 0,0,90,0,0,1,20 noise.ply
		least-turn.cl meshnorm --rows mesh -r 3 --lead 10 --least-turn 20 noise.ply
		rate.cl meshnorm --rows mesh -r 2 --axis-rate 3 --axis-play 4 wave.ply
		gouraud.cl meshnorm --rows mesh -r 2 --normals gouraud --limit 0.3 --avoid wave.ply
		cube.cl planecut -r 2 -s 2 -a 30 cube.ply
		on.cl planecut -r 2 -s 3 --surface meet.nurbs --avoid meet.ply
		frame.cl planecut -r 2 -s 1 --gap 1 frame.ply
		wall.cl meshnorm -r 2 --avoid -g wall.xyz wall.ply
		rib.cl planecut -r 1.5 -s 1 --avoid -g rib.xyz --holder 1.5:3+6:20 rib.ply
		table biarcfit -q --table wave.cl
		arcs-g.cl biarcfit -e 0.02 -g wave.xyz --noise 0.02 wave.cl
		arcs-tilt.cl biarcfit -e 0.02 --tilt 30 --linear-arcs fixed.cl
		splines-table bsplfit -q --table wave.cl
		uniform.cl bsplfit -e 0.05 --knots uniform --params chord fixed.cl
		average.cl bsplfit -e 0.05 --knots average --params centripetal --degree 2 fixed.cl
		free.cl bsplfit -e 0.05 --knots free --degree 5 --track tip fixed.cl
		contact.cl bsplfit -e 0.05 --track contact fixed.cl
		interpolate.cl bsplfit --interpolate fixed.cl
		centre.cl bsplfit -e 0.05 --track centre fixed.cl
		arcs-centre.cl biarcfit -e 0.05 centre.cl
		words.cl path words
		steep.cl path steep
		leaning.cl path leaning
		spiral.cl path spiral
	END
	for control in fanuc siemens heidenhain linuxcnc; do
		for path in words steep leaning spiral; do
			echo "$path.$control ncpost -c $control $path.cl"
			echo "$path.$control.txt ncverify -c $control -g wave.xyz -r 2 $path.$control"
		done
		for machine in head-cb table-bc table-ac-notcp nutating-head; do
			echo "$machine.$control ncpost -c $control -m $machine shapes.cl"
		done
		echo "three-axis.$control ncpost -c $control -m three-axis fixed.cl"
		echo "self.$control ncpost -c $control -m head-table-bc --self-test"
		echo "inch.$control ncpost -c $control --inch --vectors winding.cl"
		echo "rotary.$control ncpost -c $control --rotary --inch --set c.min=-360 spiral.cl"
		echo "split.$control split $control spiral.cl"
		echo "own.$control program $control"
		echo "own.$control.txt ncverify -c $control -r 4 -g noise.xyz own.$control"
		echo "own.$control.svg ncplot own.$control"
		echo "words.$control.line ncpost -c $control --set arcs=no --set cycles=no words.cl"
		echo "feeds.$control ncpost -c $control --set feeds=inverse --set tcp=no --strict shapes.cl"
	done
	cat <<-'END'
		awkward-clouds awkward '^(cloud|las|e57)|[.](xyz|csv|asc|txt)$'
		awkward-meshes awkward '^mesh|^not-ply|^empty[.]ply'
		awkward-surfaces awkward '[.](igs|nurbs|step)$'
		awkward-paths awkward '^path|[.]cl$'
		awkward-machines awkward '^machine'
		seeds-clouds each cloud2mesh fuzz/seeds/cloud fuzz/seeds/cloud-ply fuzz/seeds/las
		seeds-others each cloud2mesh fuzz/seeds/obj fuzz/seeds/pcd fuzz/seeds/ptx
		seeds-meshes each 'planecut -r 4 -s 2' fuzz/seeds/off fuzz/seeds/stl
		seeds-surfaces each 'nurbs2mesh -n 4 --partial' fuzz/seeds/step
		seeds-paths each 'ncpost -c siemens' fuzz/seeds/cl fuzz/seeds/cl-others
		seeds-systems each 'ncpost -c siemens' fuzz/seeds/cl-creo fuzz/seeds/cl-nx
		seeds-fanuc each 'ncverify -c fanuc -r 4 -g noise.xyz' fuzz/seeds/nc-fanuc
		seeds-heidenhain each 'ncverify -c heidenhain -r 4 -g noise.xyz' fuzz/seeds/nc-heidenhain
		seeds-linuxcnc each 'ncverify -c linuxcnc -r 4 -g noise.xyz' fuzz/seeds/nc-linuxcnc
		foreign-fanuc each 'ncpost -c fanuc' data/cl
		foreign-heidenhain each 'ncpost -c heidenhain' data/cl
		foreign-programs each 'ncverify -r 4 -g noise.xyz' data/foreign
		bad-options bad_options
	END
	more_scans
	more_surfaces
	more_paths
	more_programs
}

# Options and shapes that the jobs above have not.
more_scans() {
	cat <<-'END'
		few.xyz shape wave 6 5 1
		matrix.txt printf '0 -1 0 5\n1 0 0 0\n0 0 1 -2\n0 0 0 1\n'
		moved.ply cloud2mesh --matrix matrix.txt -a 30 --max-gap 2 wave.xyz
		known.ply cloud2mesh --noise 0.01 --neighbours 25 --effort 2 noise.xyz
		clean.ply cloud2mesh --clean clean.txt stray.xyz
		clean.all cat clean.txt clean.txt.outliers
		effort.ply cloud2mesh --effort 0.01 -t 0.8 rib.xyz
		facet.ply cloud2mesh --normals facet --nodes grid -t 1.2 noise.xyz
		delaunay-all.ply cloud2mesh --method delaunay noise.xyz
		lin-noise.ply cloud2mesh --method lin -t 1 -a 20 noise.xyz
		scan-noise.ply cloud2mesh --nodes scan -e 0.05 noise.xyz
	END
	for kind in bowl saddle valley pyramid groove step plateau terraces folds islands; do
		echo "$kind.xyz shape $kind 16 14 0.5 0 random"
		echo "$kind-rough.xyz shape $kind 14 12 0.5 0.02 lines"
		echo "$kind.mesh cloud2mesh $kind.xyz"
		echo "$kind-rough.mesh cloud2mesh -e 0.05 --extend 1 $kind-rough.xyz"
		echo "$kind.way meshnorm -r 2 --scallop 0.1 --avoid -g $kind.xyz $kind.mesh"
	done
}

more_surfaces() {
	cat <<-'END'
		ferguson.nurbs cloud2surf --ferguson -t 3 wave.xyz
		stiff.nurbs cloud2surf --bending 0.01 --knots uniform -a 30 -e 0.05 noise.xyz
		open.nurbs cloud2surf --untrimmed --noise 0.01 --origin -e 0.1 noise.xyz
		gap.nurbs cloud2surf --max-gap 2 --matrix matrix.txt --outliers keep -e 0.1 hole.xyz
		inch.nurbs cloud2surf -u inch -t 60 --bezier wave.xyz
		ferguson.ply nurbs2mesh -e 0.02 --gap 0.01 ferguson.nurbs
		inch-unit.ply nurbs2mesh -u inch -n 8 patches.igs
		step-fine.ply nurbs2mesh -e 0.01 "$SRC/tests/data/box.step"
		box.cl planecut -r 3 -s 3 --faces 88,90-182 --avoid box.ply
		step-radii nurbs2mesh -k "$SRC/tests/data/box.step"
		saddle-one.ply nurbs2mesh -e 0.05 "$SRC/samples/saddle.nurbs"
		paper2.ply nurbs2mesh -n 12 "$SRC/samples/paper2_s1_a.igs" "$SRC/samples/paper2_s2_a.igs"
	END
}

more_paths() {
	cat <<-'END'
		machine.cl meshnorm -r 2 --scallop 0.1 -m head-ca --smooth 0 --flute 3 -e 0.02 noise.ply
		tool.cl meshnorm -r 4 --scallop 0.1 --tool-file ball-8 --tool-file hsk-a63-er20 wave.ply
		ball-only.cl meshnorm -r 3 --scallop 0.1 --ball-only --no-guard -a auto rib.ply
		deep.cl meshnorm -r 3 --scallop 0.2 --depth 0.5 --layers 3 --approach 2 --clearance 40 wave.ply
		words.path meshnorm -r 3 --scallop 0.2 --feed 900 --plunge 90 --spindle 0 --tool 7 --coolant mist --partno X wave.ply
		left.cl meshnorm -r 4 --scallop 0.2 --left-share 20 --noise 0.02 -g noise.xyz noise.ply
		paper.cl meshnorm -r 2 --rows mesh --paper --normals central lin.ply
		to.cl meshnorm -r 3 --scallop 0.2 -a 40 --to-point 0,0,60 --effort 3 wave.ply
		steep.way planecut -r 2 -s 2 --steep 0:40 --up 0,0,1 --avoid roof.ply
		lead.cut planecut -r 2 -s 2 --lead 10 --tilt 5 --least-turn 15 --axis-rate 3 wave.ply
		from.cut planecut -r 2 -s 2 -a 20 --from-point 0,0,-80 --one-way --layers 2 --depth 0.4 wave.ply
		circle.cut planecut -r 2 -s 2 --circle 0,0,80,0,0,1,15 --axis-play 3 --lean-limit 30 noise.ply
		fixed.cut planecut -r 2 -s 2 --fixed 0.2,0,1 --limit 0.5 --smooth 0.01 --machine table-bc rib.ply
		tool.cut planecut -r 4 -s 3 --tool-file ball-8 --holder 3:10+8:40 --flute 8 --effort 2 wave.ply
		words.cut planecut -r 4 -s 3 --feed 900 --plunge 90 --spindle 500 --coolant on --approach 1 --clearance 50 --partno Y --paper wave.ply
		noise.cut planecut -r 3 --scallop 0.1 -g noise.xyz --noise 0.02 --left-share 5 -e 0.02 --ball-only noise.ply
		half.cl biarcfit -e 0.02 --part 1/2 --min-length 0.5 --axis-tolerance 0.2 wave.cl
		half.spline bsplfit -e 0.02 --part 2/2 --min-length 0.5 --axis-tolerance 0.2 wave.cl
		ends.spline bsplfit --interpolate --ends clamped -e 0.1 fixed.cl
		bessel.spline bsplfit --interpolate --ends bessel -e 0.1 wave.cl
		long.arcs biarcfit --min-length 0 --effort 2 -e 0.005 noise.cl
		noise.spline bsplfit -g noise.xyz --noise 0.02 -e 0.02 --min-length 0 noise.cl
		holder.arcs biarcfit -e 0.02 holder.cl
		holder.spline bsplfit -e 0.02 holder.cl
		region.arcs biarcfit region.cl
		torus.spline bsplfit -e 0.05 torus.cl
	END
	for kind in roof rib wall valley groove step folds; do
		echo "$kind.cut planecut -r 1.5 -s 1 --avoid -g $kind.xyz $kind.$(case $kind in r* | w*) echo ply ;; *) echo mesh ;; esac)"
		echo "$kind.arcs biarcfit -e 0.02 $kind.cut"
		echo "$kind.spline bsplfit -e 0.02 $kind.cut"
		echo "$kind.nc ncpost -c siemens $kind.spline"
		echo "$kind.verdict ncverify -c siemens -r 1.5 -g $kind.xyz $kind.nc"
	done
}

more_programs() {
	for control in fagor grbl haas hurco mach3 mazak okuma tormach heidenhain-530; do
		echo "shapes.$control ncpost -c $control --accept shapes.cl"
		echo "winding.$control ncpost -c $control --accept winding.cl"
		echo "fixed.$control ncpost -c $control -m three-axis fixed.cl"
		echo "fixed.$control.txt ncverify -c $control -m three-axis -r 3 -g noise.xyz fixed.$control"
	done
	for machine in dmg-dmu50 haas-umc750 hermle-c42u linuxcnc-xyzac linuxcnc-xyzbc mazak-variaxis-i600 \
		nutating-head-table nutating-table table-a table-bc-notcp; do
		case $machine in nut* | table*) control=siemens ;; *) control= ;; esac
		echo "on-$machine ncpost ${control:+-c $control} -m $machine --accept splines.cl"
		echo "on-$machine.verdict ncverify ${control:+-c $control} -m $machine -r 2 -g wave.xyz on-$machine"
	done
	for control in fanuc siemens heidenhain linuxcnc; do
		for path in holder scallop noise torus deep; do
			echo "$path.$control.nc ncpost -c $control $path.cl"
			echo "$path.$control.verdict judged $control --holder 1.5:6+4:20 $path.$control.nc"
		done
		echo "chord.$control ncpost -c $control --chord 0.02 --axis-tolerance 1 -e 0.1 --contact-feed arcs.cl"
		echo "insert.$control ncpost -c $control --insert comment --program $([ $control = siemens ] && echo AB77 || echo 77) --feed 321 words.cl"
		echo "part.$control ncpost -c $control --part 2/3 splines.cl"
		echo "units.$control ncpost -c $control -u inch holes.cl"
		echo "head.$control.txt judged $control -m head-ca head.$control"
		echo "notcp.$control.txt judged $control --set tcp=no notcp.$control"
		echo "vectors.$control.txt judged $control inch.$control"
	done
	cat <<-'END'
		centre.nc ncpost -c fanuc --set tcp=no -m three-axis fixed.cl
		centre.txt ncverify -c fanuc -m three-axis --centre -r 3 -g noise.xyz centre.nc
		ball.txt judged fanuc --ball-only --noise 0.01 --left-share 30 --band 0.1 --partial splines.fanuc
		tool.txt ncverify -c fanuc --tool-file ball-4 --tool-file hsk-a63-er16 -g wave.xyz --scallop 0.1 arcs.fanuc
		stock-box.txt judged fanuc --stock box:-9,-7,-4,9,7,4 --cell 0.7 --map /dev/stdout arcs.fanuc
		mesh-part.txt ncverify -c fanuc -r 2 -g wave.ply -u mm arcs.fanuc
		box-part.txt ncverify -c fanuc -r 2 -g saddle-one.ply arcs.fanuc
		broken-fanuc broken own.fanuc ncverify -q -c fanuc -r 4 -g few.xyz
		broken-siemens broken own.siemens ncverify -q -c siemens -r 4 -g few.xyz
		broken-heidenhain broken own.heidenhain ncverify -q -c heidenhain -r 4 -g few.xyz
		broken-linuxcnc broken own.linuxcnc ncverify -q -c linuxcnc -r 4 -g few.xyz
		broken-path broken words.cl ncpost -q -c siemens
		broken-tools broken tools.cl ncpost -q -c fanuc
		broken-holes broken holes.cl ncpost -q -c heidenhain
		broken-shapes broken shapes.cl ncpost -q -c linuxcnc
		broken-iges broken bounded.igs nurbs2mesh -q -n 3
		broken-cylinder broken cylinder.igs nurbs2mesh -q -n 3 --partial
		all.svg ncplot --view all --width 500 --title T --cut arcs.cl
		kind.svg ncplot --colour kind --joints --view plan splines.cl
		normals.svg ncplot --show-normals --view side noise.ply
		machine.svg ncplot --view front --axes on-dmg-dmu50
		paths.svg ncplot --compare wave.cl arcs.cl splines.cl
		surface.svg ncplot --view iso torus.ply rib.xyz
	END
}

# What the tools say and write for these files of tests/data/awkward, with the commands there.
awkward() { # REGEX
	cd "$SRC/tests/data/awkward" || return
	awk -F, -v these="$1" 'NR > 1 && $1 ~ these && !seen[$1]++ {
		command = $2; sub(/@/, $1 ~ /^machine/ ? "./" $1 : $1, command)
		sub(/^nurbs2mesh/, "& -n 6", command); print command }' expected.csv |
		while read -r command; do
			(eval "$command -q") 2>&1 </dev/null
			echo "exit $?"
		done
}

# The same for all files in these folders of tests.
each() { # COMMAND FOLDER...
	command=$1
	shift
	for folder; do
		for file in "$SRC/tests/$folder"/*.*; do
			$command "$file" 2>&1
		done
	done
}

# What a tool makes of a file of which one line is gone, is there twice, or has another number.
broken() { # FILE COMMAND...: the file is its last word
	file=$1 n=0 lines=$(wc -l <"$1")
	shift
	# shellcheck disable=SC2068 # words
	while [ $n -lt "$lines" ]; do
		n=$((n + 1))
		for change in "${n}d" "${n}p" "${n}s/[0-9]/8&/" "${n}s/[0-9.]*\$//" "${n}s/\([A-Z]\)\([0-9.-]\)/\1-\2/"; do
			sed "$change" "$file" >broken.$$
			cmp -s "$file" broken.$$ || {
				echo "$change"
				$@ broken.$$ 2>&1 </dev/null | sed "s/broken\.$$/broken/g"
			}
		done
	done
	rm broken.$$
}

# Options that are help, wrong or lack something.
bad_options() {
	for tool in $all_tools; do
		$tool --help && $tool --help all && $tool -V
		for option in -o -r --frob '-r six' '-e -1' '--fixed 0,1' '--coolant much' nowhere; do
			# shellcheck disable=SC2086 # words
			$tool $option 2>&1
			echo "exit $?"
		done
	done
}

judged() { # CONTROL ARGUMENT...
	control=$1
	shift
	ncverify -c "$control" -r 2 -g wave.xyz "$@"
}

split() { # CONTROL PATH: all parts of its program
	ncpost -c "$1" --split 70 -o "split.$1.part" "$2" && cat split."$1"-*
}

# What is only told with -v is compared too.
all_tools='cloud2mesh cloud2surf nurbs2mesh meshnorm planecut biarcfit bsplfit ncpost ncverify ncplot'
for tool in $all_tools; do
	eval "$tool() { command $tool -v \"\$@\"; }"
done

# the tools of a command
tools_of() {
	case $1 in
	awkward* | bad_options*) echo "$all_tools" ;;
	judged*) echo ncverify ;;
	split*) echo ncpost ;;
	*) for tool in $all_tools; do case " $1" in *[!a-z0-9-]"$tool"[!a-z0-9.-]*) echo "$tool" ;; esac done ;;
	esac | tr '\n' ' '
}

# of `times` on standard input: of the children, seconds
seconds() {
	awk -F'[ms ]' 'NR == 2 { printf "%.2f", 60 * $1 + $2 + 60 * $4 + $5 }'
}

case ${1:-} in
--make)
	mkdir -p "$2" && cd "$2" || exit 1
	jobs | cut -d ' ' -f 1 | sort | uniq -d | sed 's/^/two jobs called /' >&2
	jobs | while read -r name command; do
		(
			(eval "$command") >"$name" 2>"$name.err" </dev/null
			echo $? >"$name.status"
			times >"$name.times"
		)
		echo "$(seconds <"$name.times") $name $(tools_of "$command")"
	done >list
	: >made
	;;
*)
	cd "$1" || exit 1
	command=$(jobs | awk -v name="$2" '$1 == name { sub(/^[^ ]+ /, ""); print }')
	again=$(mktemp "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
	trap 'rm -f "$again" "$again.err"' EXIT
	(eval "$command") >"$again" 2>"$again.err" </dev/null
	[ $? -eq "$(cat "$2.status")" ] && cmp -s "$again" "$2" && cmp -s "$again.err" "$2.err"
	;;
esac

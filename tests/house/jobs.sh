# jobs.sh - what freeze.sh runs; sourced by it.  A line is a name and a command, whose standard output
# is the file of that name for the lines that name it too.  A command runs in a folder with nothing
# in it but those files.
#
# shellcheck shell=sh disable=SC2016 # $samples in lines is for freeze.sh --job to see

samples=$SRC/samples
awkward=$SRC/tests/data/awkward # input as users have it, and in its expected.csv a command for each
foreign=$SRC/tests/data/cl # CL files of CAM systems
export samples awkward foreign

jobs() {
	clouds
	meshes
	surfaces
	paths
	fits
	programs
	verdicts
	pictures
	threads
	manners
	awkward_input
}

clouds() {
	cat <<-'END'
		panel.xyz cat "$samples/panel_17036.xyz"
		face.xyz cat "$samples/face_nefertiti_26493.xyz"
		half.xyz awk '$2 > 0' face.xyz
		little.xyz awk 'NR % 3 == 0' panel.xyz
		flat.xyz shape flat 20 16 0.5
		wave.xyz shape wave 30 24 0.4
		wave-noise.xyz shape wave 30 24 0.4 0.02
		dome.xyz shape dome 36 24 0.5
		dome-random.xyz shape dome 36 24 0.5 0 random
		dome-noise.xyz shape dome 36 24 0.5 0.03 lines
		bowl.xyz shape bowl 24 20 0.4
		saddle.xyz shape saddle 30 30 0.5 0 lines
		roof.xyz shape roof 30 24 0.4
		roof-noise.xyz shape roof 30 24 0.4 0.02 random
		valley.xyz shape valley 30 24 0.5
		pyramid.xyz shape pyramid 26 26 0.4 0 random
		corner.xyz shape corner 26 26 0.4
		corner-noise.xyz shape corner 26 26 0.4 0.01 random
		rib.xyz shape rib 28 28 0.3 0 random
		rib-noise.xyz shape rib 24 24 0.25 0.02 random
		groove.xyz shape groove 24 24 0.3 0 random
		wall.xyz shape wall 30 24 0.5 0 random
		wall-noise.xyz shape wall 30 24 0.4 0.02 random
		block.xyz shape block 30 30 0.5
		step.xyz shape step 30 24 0.5
		plateau.xyz shape plateau 30 30 0.5
		terraces.xyz shape terraces 32 20 0.5
		folds.xyz shape folds 30 20 0.4 0.005 random
		hole.xyz shape hole 40 40 0.6 0 random
		islands.xyz shape islands 40 20 0.5
		ball.xyz ball 4 0 4000
		ball-deep.xyz ball 5 -2 5000 0.005
		box.xyz box
		outliers.xyz cat dome.xyz; echo 3 3 35; echo 4 4 -9; echo 5 5 19.4
		dome.pts as pts dome.xyz
		dome.ptx as ptx dome.xyz
		dome.pcd as pcd dome.xyz
		dome.obj as obj dome.xyz
		dome.csv as csv dome.xyz
		dome-points.ply as ply dome.xyz
		dome.inch as inch dome.xyz
		turn.matrix printf '0.6 -0.8 0 10\n0.8 0.6 0 -5\n0 0 1 2.5\n0 0 0 1\n'
	END
}

# mesh LINES: a shape's name, a suffix, and options of cloud2mesh
meshes() {
	for cloud in panel flat wave wave-noise dome dome-random dome-noise bowl saddle roof roof-noise valley \
		pyramid corner corner-noise rib rib-noise groove wall wall-noise block step plateau terraces folds hole islands; do
		echo "$cloud.ply cloud2mesh --nodes scan -q $cloud.xyz"
		case $cloud in panel) e=0.05 ;; *) e=0.03 ;; esac
		echo "$cloud-e.ply cloud2mesh --nodes scan -q -e $e $cloud.xyz"
	done
	for format in pts ptx pcd obj csv; do
		echo "dome-$format.ply cloud2mesh --nodes scan -q dome.$format"
	done
	for unit in cm m um in; do
		echo "dome-$unit.ply cloud2mesh --nodes scan -q -u $unit dome.xyz"
	done
	cat <<-'END'
		dome-ply.ply cloud2mesh --nodes scan -q dome-points.ply
		dome-inch.ply cloud2mesh --nodes scan -q -u inch dome.inch
		panel-4.ply cloud2mesh --nodes scan -q -t 4 panel.xyz
		panel-paper.ply cloud2mesh -q --paper -t 4 panel.xyz
		face-paper.ply cloud2mesh -q --paper -t 3.8 face.xyz
		face-2.ply cloud2mesh --nodes scan -q -t 2 face.xyz
		face-smooth.ply cloud2mesh --nodes scan -q -t 2 --no-features face.xyz
		half-e.ply cloud2mesh --nodes scan -q -e 0.3 half.xyz
		panel-20.ply cloud2mesh --nodes scan -q -a 20 -t 3 panel.xyz
		panel-et.ply cloud2mesh --nodes scan -q -e 0.02 -t 2 little.xyz
		wave-paper-e.ply cloud2mesh -q --paper -e 0.1 wave.xyz
		wave-paper.ply cloud2mesh -q --paper -t 1 --origin -a 30 wave.xyz
		wave-facet.ply cloud2mesh --nodes scan -q --normals facet wave.xyz
		wave-paper-quadric.ply cloud2mesh -q --paper --normals quadric wave.xyz
		wave-12.ply cloud2mesh --nodes scan -q --neighbours 12 -t 0.8 wave.xyz
		wave-coarse.ply cloud2mesh --nodes scan -q -t 5 wave.xyz
		wave-smooth.ply cloud2mesh --nodes scan -q --no-features -t 1.5 wave-noise.xyz
		wave-known.ply cloud2mesh --nodes scan -q --noise 0.02 wave-noise.xyz
		wave-rough.ply cloud2mesh --nodes scan -q --noise 0 wave-noise.xyz
		wave-e-smooth.ply cloud2mesh --nodes scan -q --no-features -e 0.05 wave-noise.xyz
		wave-tight.ply cloud2mesh --nodes scan -q -e 0.001 wave.xyz
		wave-turned.ply cloud2mesh --nodes scan -q --matrix turn.matrix -t 1.5 wave.xyz
		hole-gap.ply cloud2mesh --nodes scan -q --max-gap 20 hole.xyz
		hole-extend.ply cloud2mesh --nodes scan -q --extend 2 hole.xyz
		dome-extend.ply cloud2mesh --nodes scan -q --extend 3 -e 0.02 dome-noise.xyz
		islands-extend.ply cloud2mesh --nodes scan -q --extend 1 islands.xyz
		islands-two.ply cloud2mesh --nodes scan -q dome.xyz islands.xyz
		outliers.ply cloud2mesh --nodes scan -q outliers.xyz
		outliers-keep.ply cloud2mesh --nodes scan -q --outliers keep outliers.xyz
		outliers-paper.ply cloud2mesh -q --paper --outliers drop outliers.xyz
		ball-parts.ply cloud2mesh --nodes scan -q --subdivide ball.xyz
		ball-flat.ply cloud2mesh --nodes scan -q ball.xyz
		deep-parts.ply cloud2mesh --nodes scan -q --subdivide ball-deep.xyz
		box-parts.ply cloud2mesh --nodes scan -q --subdivide -t 1 box.xyz
		box-parts-e.ply cloud2mesh --nodes scan -q --subdivide -e 0.1 box.xyz
		panel-parts.ply cloud2mesh --nodes scan -q --subdivide -t 4 panel.xyz
		roof-smooth.ply cloud2mesh --nodes scan -q --no-features roof.xyz
		wall-smooth.ply cloud2mesh --nodes scan -q --no-features wall.xyz
		face-keep.ply cloud2mesh --nodes scan -q -t 4 --outliers keep --normals facet face.xyz
		corner-coarse.ply cloud2mesh --nodes scan -q -t 4 corner.xyz
		block-coarse.ply cloud2mesh --nodes scan -q -t 3 block.xyz
		pyramid-coarse.ply cloud2mesh --nodes scan -q -t 5 pyramid.xyz
		wave-none.ply cloud2mesh --nodes scan -q -t 0.1 wave.xyz
		wave-wrong.ply cloud2mesh -q --extend 2 --paper wave.xyz
	END
}

surfaces() {
	for kind in trimmed bounded placed cylinder; do
		partial=
		[ $kind = trimmed ] && partial=--partial # a trimming curve of type 112
		echo "$kind.igs iges $kind"
		echo "$kind-n.ply nurbs2mesh -q -n 12 $partial $kind.igs"
		echo "$kind-e.ply nurbs2mesh -q -e 0.05 $partial $kind.igs"
		echo "$kind.k nurbs2mesh -q -k $partial $kind.igs"
	done
	for kind in torus sphere cube frame disc meet part; do
		echo "$kind.nurbs surface $kind"
		echo "$kind-n.ply nurbs2mesh -q -n 12 $kind.nurbs"
		echo "$kind-e.ply nurbs2mesh -q -e 0.1 $kind.nurbs"
		echo "$kind.k nurbs2mesh -q -k $kind.nurbs"
	done
	cat <<-'END'
		s1.igs cat "$samples/paper2_s1_a.igs"
		s2.igs cat "$samples/paper2_s2_a.igs"
		saddle.nurbs cat "$samples/saddle.nurbs"
		s1.ply nurbs2mesh -q -n 60 s1.igs
		s2.ply nurbs2mesh -q -n 60 s2.igs
		s1-e.ply nurbs2mesh -q -e 0.01 s1.igs
		saddle-n.ply nurbs2mesh -q -n 20 saddle.nurbs
		saddle-e2.ply nurbs2mesh -q -e 0.005 saddle.nurbs
		wave-surface.nurbs cloud2surf -q --bspline -e 0.02 wave.xyz
		wave-bezier.nurbs cloud2surf -q --bezier wave.xyz
		wave-lin.ply cloud2mesh -q --method lin wave.xyz
		wave-delaunay.ply cloud2mesh -q --method delaunay --keep 400 wave.xyz
		s1.k nurbs2mesh -q -k s1.igs
		s1.grid nurbs2mesh -q --grid 20 s1.igs
		s2.grid nurbs2mesh -q --grid 9 s2.igs
		s1-fine.ply nurbs2mesh -q -n 110 s1.igs
		s1-inch.ply nurbs2mesh -q -u inch -n 10 s1.igs
		s1-down.ply nurbs2mesh -q --up 0,0,-1 -n 10 s1.igs
		meet-gap.ply nurbs2mesh -q --gap 0.001 -n 12 meet.nurbs
		all.ply nurbs2mesh -q -e 0.2 s1.igs saddle.nurbs torus.nurbs
		wide.ply nurbs2mesh -q --gap 0.1 -e 0.05 meet.nurbs
	END
}

paths() {
	for mesh in panel wave wave-noise dome dome-noise bowl saddle roof pyramid rib wall block plateau terraces hole; do
		echo "$mesh.cl meshnorm --rows mesh -q -r 3 --avoid $mesh.ply"
		echo "$mesh-g.cl meshnorm --rows mesh -q -r 3 --avoid -g $mesh.xyz $mesh.ply"
		echo "$mesh-p.cl planecut -q -r 3 -s 2 --avoid $mesh.ply"
	done
	cat <<-'END'
		panel-8.cl meshnorm --rows mesh -q -r 8 panel-4.ply
		panel-paper.cl meshnorm -q --paper -r 8 panel-paper.ply
		panel-gs.cl meshnorm -q -r 8 --scallop 0.02 -e 0.01 -g panel.xyz panel-4.ply
		panel-auto.cl meshnorm -q -r 8 --scallop 0.05 --direction auto panel-4.ply
		panel-30.cl meshnorm -q -r 8 --scallop 0.05 --direction 30 panel-4.ply
		wave-2.cl meshnorm --rows mesh -q -r 2 wave.ply
		wave-5.cl meshnorm --rows mesh -q -r 5 wave.ply
		wave-5g.cl meshnorm --rows mesh -q -r 5 -g wave.xyz wave.ply
		wave-limit.cl meshnorm --rows mesh -q -r 5 --avoid --limit 0.3 wave.ply
		wave-e.cl meshnorm --rows mesh -q -r 2 -e 0.005 wave-coarse.ply
		wave-noise-0.cl meshnorm --rows mesh -q -r 2 -g wave-noise.xyz --noise 0 wave-noise.ply
		wave-noise-2.cl meshnorm --rows mesh -q -r 2 -g wave-noise.xyz --noise 0.02 wave-noise.ply
		wave-facet.cl meshnorm --rows mesh -q -r 2 --normals facet wave.ply
		wave-gouraud.cl meshnorm --rows mesh -q -r 2 --normals gouraud wave.ply
		wave-central.cl meshnorm --rows mesh -q -r 2 --normals central wave.ply
		wave-mesh.cl meshnorm --rows mesh -q -r 2 --normals mesh wave.ply
		dome-lead.cl meshnorm --rows mesh -q -r 6 --tilt -10 --lead 5 dome.ply
		dome-fixed.cl meshnorm --rows mesh -q -r 6 --fixed 0,0,1 dome.ply
		dome-3plus2.cl meshnorm --rows mesh -q -r 6 --fixed 0.3,0.2,0.9 dome.ply
		dome-to.cl meshnorm --rows mesh -q -r 6 --to-point 0,0,120 dome.ply
		dome-from.cl meshnorm --rows mesh -q -r 6 --from-point 0,0,-90 dome.ply
		dome-circle.cl meshnorm --rows mesh -q -r 6 --circle 0,0,90,0,0,1,20 dome.ply
		dome-turn.cl meshnorm --rows mesh -q -r 6 --least-turn 25 dome.ply
		dome-play.cl meshnorm --rows mesh -q -r 6 --axis-play 5 dome.ply
		wave-rate.cl meshnorm --rows mesh -q -r 2 --axis-rate 3 wave.ply
		wave-holder.cl meshnorm --rows mesh -q -r 2 -g wave.xyz --holder 1.5:6+4:20 --lean-limit 40 wave.ply
		valley-holder.cl meshnorm --rows mesh -q -r 2 --tilt 50 --holder 2:5+2:12:8+12:20 valley.ply
		block-holder.cl meshnorm --rows mesh -q -r 1.5 --avoid -g block.xyz --holder 1.5:3+6:20 block.ply
		dome-oneway.cl meshnorm --rows mesh -q -r 6 --one-way --clearance 60 --approach 2 --feed 1200 --plunge 100 --spindle 12000 --tool 7 --coolant mist --partno 'A part' dome.ply
		dome-layers.cl meshnorm --rows mesh -q -r 6 --layers 3 --depth 0.5 --coolant off dome.ply
		dome-layers-g.cl meshnorm --rows mesh -q -r 6 --layers 2 -g dome.xyz dome-extend.ply
		ball.cl meshnorm --rows mesh -q -r 3 -g ball.xyz ball-parts.ply
		ball-scallop.cl meshnorm -q -r 3 -g ball.xyz --scallop 0.02 ball-parts.ply
		ball-deep.cl meshnorm --rows mesh -q -r 2 -g ball-deep.xyz deep-parts.ply
		box.cl meshnorm --rows mesh -q -r 3 --avoid -g box.xyz box-parts.ply
		box-holder.cl meshnorm --rows mesh -q -r 3 --avoid --holder 3:10+10:20 box-parts.ply
		hole-extend.cl meshnorm --rows mesh -q -r 4 -g hole.xyz hole-extend.ply
		islands.cl meshnorm -q -r 4 --scallop 0.02 islands-extend.ply
		face.cl meshnorm --rows mesh -q -r 5 --avoid --axis-rate 20 face-2.ply
		turned.cl meshnorm --rows mesh -q -r 2 -g wave.xyz wave-turned.ply
		origin.cl meshnorm --rows mesh -q -r 2 --avoid -g wave.xyz wave-paper.ply
		roof-steep.cl meshnorm --rows mesh -q -r 3 --tilt 80 roof.ply
		none.cl meshnorm --rows mesh -q -r 3 s1.ply
		s1.cl planecut -q -r 4 -s 4 -a 90 s1.ply
		s1-paper.cl planecut -q --paper --fixed 0,0,1 -r 4 -s 4 -a 90 s1.ply
		s1-on.cl planecut -q -r 4 -s 4 --surface s1.igs s1.ply
		s1-refused.cl planecut -q -r 6 -s 4 s1.ply
		s1-avoid.cl planecut -q -r 6 -s 4 --avoid s1.ply
		s2.cl planecut -q -r 10 -s 10 s2.ply
		s2-scallop.cl planecut -q -r 10 --scallop 0.1 s2.ply
		s2-auto.cl planecut -q -r 10 -s 10 --direction auto s2.ply
		torus.cl planecut -q -r 4 -s 3 --normal 0,0,1 --avoid torus-e.ply
		sphere.cl planecut -q -r 4 -s 3 --fixed 0,0,1 sphere-e.ply
		cube.cl planecut -q -r 2 -s 2 -a 30 cube-n.ply
		cube-layers.cl planecut -q -r 2 -s 3 --normal 0,0,1 --layers 2 cube-n.ply
		frame.cl planecut -q -r 2 -s 1 --gap 1 frame-n.ply
		frame-wide.cl planecut -q -r 2 -s 1 --gap 3 --oneway frame-n.ply
		saddle-trim.cl planecut -q -r 4 -s 2 -e 0.005 --surface saddle.nurbs saddle-n.ply
		cylinder.cl planecut -q -r 3 -s 4 --normal 0,0,1 --avoid cylinder-e.ply
		trimmed.cl planecut -q -r 3 -s 3 -e 0.01 --surface trimmed.igs --avoid trimmed-e.ply
		meet.cl planecut -q -r 3 -s 5 -a 15 --avoid meet-e.ply
		panel-cut.cl planecut -q -r 8 --scallop 0.02 -a 30 -g panel.xyz panel-4.ply
		panel-cut3.cl planecut -q -r 8 -s 2 --fixed 0,0,1 panel-4.ply
		wave-cut.cl planecut -q -r 5 -s 1 -g wave.xyz wave.ply
		wave-cut-limit.cl planecut -q -r 5 -s 2 --avoid --limit 0.5 wave.ply
		wave-cut-noise.cl planecut -q -r 2 -s 1 -g wave-noise.xyz --noise 0.02 wave-noise.ply
		wave-cut-turn.cl planecut -q -r 2 -s 2 --least-turn 20 --axis-rate 10 wave.ply
		wave-cut-play.cl planecut -q -r 2 -s 2 --axis-play 4 --lead 10 wave.ply
		wave-cut-holder.cl planecut -q -r 2 -s 1 --holder 1.5:6+4:20 --lean-limit 40 wave.ply
		wave-cut-z.cl planecut -q -r 2 -s 0.7 --normal 0,0,1 wave.ply
		dome-cut.cl planecut -q -r 6 -s 3 --to-point 0,0,99 --one-way --feed 500 --clearance 50 --approach 1 --plunge 90 --spindle 5000 --tool 3 --coolant off --partno CUT dome.ply
		dome-cut-circle.cl planecut -q -r 6 -s 3 --circle 0,0,90,0,0,1,20 --layers 2 --depth 0.4 dome.ply
		dome-cut-from.cl planecut -q -r 6 -s 3 --from-point 0,0,-90 dome.ply
		block-cut.cl planecut -q -r 2 -s 1.5 --avoid -g block.xyz --tilt 5 block.ply
		nothing.cl planecut -q dome.ply
	END
}

fits() {
	for path in wave-5g wave-facet dome-fixed dome-lead dome-to rib bowl-g roof-g wall s1 s2 torus cube frame box; do
		echo "$path-arcs.cl figures biarcfit -q --table $path.cl"
		echo "$path-splines.cl figures bsplfit -q --table $path.cl"
	done
	cat <<-'END'
		panel-arcs.cl biarcfit -q panel-8.cl
		panel-splines.cl bsplfit -q panel-8.cl
		wave-arcs.cl biarcfit -q wave-2.cl
		wave-splines.cl bsplfit -q wave-2.cl
		dome-arcs.cl biarcfit -q -e 0.02 dome-fixed.cl
		dome-splines.cl bsplfit -q -e 0.02 dome-fixed.cl
		dome-3plus2-splines.cl bsplfit -q -e 0.02 dome-3plus2.cl
		panel-arcs-paper.cl figures biarcfit -q --paper --table panel-paper.cl
		panel-arcs-frenet.cl biarcfit -q --paper --tilt 15 panel-paper.cl
		panel-arcs-tilt.cl biarcfit -q --tilt 30 panel-8.cl
		panel-arcs-lines.cl biarcfit -q --linear-arcs panel-8.cl
		panel-arcs-axis.cl biarcfit -q --axis-tolerance 0.1 -e 0.05 panel-8.cl
		panel-arcs-g.cl biarcfit -q -g panel.xyz panel-gs.cl
		wave-arcs-g.cl biarcfit -q -e 0.02 -g wave.xyz wave-2.cl
		wave-arcs-noise.cl biarcfit -q -e 0.02 -g wave-noise.xyz --noise 0.02 wave-noise-2.cl
		wave-arcs-5.cl biarcfit -q -e 0.02 -g wave.xyz wave-5.cl
		dome-arcs-tight.cl biarcfit -q -e 0.0005 dome-fixed.cl
		panel-splines-paper.cl figures bsplfit -q --paper --table -e 0.05 panel-8.cl
		panel-splines-g.cl bsplfit -q -e 0.02 -g panel.xyz panel-gs.cl
		wave-splines-g.cl bsplfit -q -e 0.02 -g wave.xyz wave-2.cl
		wave-splines-5.cl bsplfit -q -e 0.02 -g wave.xyz wave-5.cl
		wave-splines-noise.cl bsplfit -q -e 0.02 -g wave-noise.xyz --noise 0.02 wave-noise-2.cl
		wave-splines-axis.cl bsplfit -q --axis-tolerance 0.1 wave-2.cl
		spiral-arcs.cl biarcfit -q -e 0.05 spiral.cl
		spiral-splines.cl bsplfit -q -e 0.05 spiral.cl
		winding-arcs.cl biarcfit -q -e 0.05 winding.cl
		winding-splines.cl bsplfit -q -e 0.05 winding.cl
		shapes-arcs.cl biarcfit -q shapes.cl
		shapes-splines.cl bsplfit -q shapes.cl
	END
	for degree in 2 4 5; do
		echo "wave-degree-$degree.cl bsplfit -q --degree $degree -e 0.02 wave-2.cl"
	done
	for points in same tip centre contact; do
		echo "wave-of-$points.cl bsplfit -q -e 0.02 --track $points wave-2.cl"
		echo "s1-of-$points.cl figures bsplfit -q --paper --table -e 0.1 --track $points s1-paper.cl"
	done
	for params in uniform centripetal chord; do
		echo "wave-params-$params.cl bsplfit -q -e 0.02 --params $params wave-2.cl"
	done
	for knots in uniform average free; do
		echo "wave-knots-$knots.cl bsplfit -q -e 0.02 --knots $knots wave-2.cl"
	done
	echo "contact-arcs.cl biarcfit -q wave-of-contact.cl"
	echo "centre-arcs.cl biarcfit -q wave-of-centre.cl"
}

controls='fanuc siemens heidenhain linuxcnc'
ending() { # CONTROL
	case $1 in fanuc) echo nc ;; siemens) echo mpf ;; heidenhain) echo h ;; *) echo ngc ;; esac
}

programs() {
	for kind in shapes tilted tools words creo nx catia winding spiral steep holes leaning; do
		echo "$kind.cl path $kind"
	done
	for control in $controls; do
		end=$(ending "$control")
		for file in "$SRC"/machines/*.txt; do
			machine=$(basename "$file" .txt)
			for path in shapes winding spiral holes; do
				echo "$path-$machine.$end ncpost -q -c $control -m $machine $path.cl"
			done
			echo "self-$machine.$end ncpost -q -c $control -m $machine --self-test"
		done
		for path in tilted tools words creo nx catia steep leaning panel-8 panel-arcs panel-splines wave-arcs wave-splines dome-arcs \
			dome-splines dome-fixed dome-3plus2 wave-of-centre wave-of-contact spiral-splines winding-splines ball s1-splines \
			wave-degree-2 wave-degree-4 wave-degree-5; do
			echo "$path.$end ncpost -q -c $control $path.cl"
		done
		for machine in table-bc head-ca table-ac-notcp nutating-head; do
			echo "wave-splines-$machine.$end ncpost -q -c $control -m $machine wave-splines.cl"
			echo "wave-arcs-$machine.$end ncpost -q -c $control -m $machine wave-arcs.cl"
		done
		i=0
		while read -r path options; do
			i=$((i + 1))
			echo "option-$i.$end ncpost -q -c $control $options $path.cl"
			case $options in *tcp=no*) tcp='--set tcp=no' ;; *) tcp= ;; esac
			echo "option-$i.$end.txt ncverify -q $tcp -c $control -r 4 -g flat.xyz option-$i.$end"
		done <<-'END'
			shapes -e 0.02
			shapes -e 0.0001
			shapes --chord 0.05
			shapes --inch
			shapes --vectors
			shapes --rotary
			shapes --plane
			shapes --from 2
			shapes --explain 20
			shapes --explain 5
			shapes --program 1234
			shapes --program NAME
			shapes --set arcs=no
			shapes --set splines=no
			shapes --set arcs.space=yes
			shapes --set arcs.space=yes --vectors
			spiral-arcs --set arcs.space=yes
			shapes --set smooth=yes
			shapes --set number.step=0
			shapes --set number.step=5 --set number.max=40
			shapes --set offset=G55 --set retract=20
			shapes --set digits.linear=5 --set digits.angle=5 --set digits.vector=7 --set digits.knot=6 --set digits.feed=3
			shapes --set feeds=combined --set tcp=no
			shapes --set feed.max=300 --set tcp=no
			shapes --set feeds=inverse --set tcp=no
			shapes --set 'start=M10|M11 {tool}' --set 'end=M12' --set 'home=G0 Z{rpm}'
			shapes --set 'tool.change=T{tool} M66 {offset}' --set 'tcp.on=M128 {tolerance}' --set 'tcp.off=M129'
			shapes --set smooth=yes --set 'smooth.on=S1 {tolerance} {orientation} {level}' --set 'smooth.off=S0'
			shapes --set x.max=25
			shapes --set a.min=-10 --set a.max=10
			shapes --set rapid=5000 --set a.rapid=900 --set c.rapid=900 --set tcp=no
			shapes --set centre.A=0,0,-50 --set tcp=no
			shapes --set nothing=1
			winding --axis-tolerance 1
			winding --axis-tolerance 0.01 --chord 0.001
			winding --contact-feed
			winding --feed 333
			winding --vectors
			winding --rotary --inch
			winding --set tcp=no
			winding --vectors --set c.min=-360 --set c.max=360
			spiral --set c.min=-360 --set c.max=360
			spiral --set c.min=-360 --set c.max=360 --set tcp=no
			spiral --set c.min=-360 --set c.max=360 --from 2
			spiral --set a.min=-30 --set a.max=30
			spiral --set arcs=no --set c.max=400
			tilted --plane
			tilted --plane --inch
			tilted --set plane=yes --set 'plane.on=G68 {a} {b} {i} {j} {k}' --set 'plane.off=G69'
			leaning --plane
			leaning --set cycles=no
			holes --inch
			holes --set cycles=no
			holes --set 'tap=M29 S{rpm}'
			tools --strict
			tools --set cutcom=yes
			tools --inch
			tools -m three-axis
			panel-8 --vectors
			panel-8 --set tcp=no
			dome-3plus2 --plane
			wave-splines --vectors
			wave-splines --rotary
			wave-splines --inch
			wave-arcs --vectors
			wave-arcs --rotary
			wave-splines --from 3
		END
		for limit in 70 200 4k; do
			for path in holes spiral leaning wave-splines; do
				echo "split-$path-$limit.$end also 'split-$path-$limit-$end-*' -- ncpost -q -c $control --split $limit -o split-$path-$limit-$end $path.cl"
			done
		done
	done
	for file in "$foreign"/*.*; do
		case $file in *.md) continue ;; esac
		name=$(basename "$file")
		for control in $controls; do
			echo "foreign-$name.$(ending "$control") cd \"\$foreign\" && ncpost -q -c $control $name"
		done
		echo "foreign-$name-arcs.cl cd \"\$foreign\" && biarcfit -q -e 0.05 $name"
	done
}

verdicts() {
	for control in $controls; do
		end=$(ending "$control")
		for path in panel-8 panel-arcs panel-splines wave-arcs wave-splines dome-arcs dome-splines dome-fixed dome-3plus2 ball; do
			case $path in
			panel*) guard="-r 8 -g panel.xyz" ;;
			wave*) guard="-r 2 -g wave.xyz" ;;
			dome*) guard="-r 6 -g dome.xyz" ;;
			ball) guard="-r 3 -g ball.xyz" ;;
			esac
			echo "verdict-$path.$end.txt ncverify -q $guard $path.$end"
		done
		for machine in table-bc head-ca table-ac-notcp nutating-head; do
			echo "verdict-$machine.$end.txt ncverify -q -r 2 -g wave.xyz -m $machine wave-splines-$machine.$end"
			echo "verdict-$machine-arcs.$end.txt ncverify -q -r 2 -g wave.xyz -m $machine wave-arcs-$machine.$end"
		done
		for path in shapes spiral winding holes; do
			for machine in table-ac head-cb three-axis head-table-bc nutating-table; do
				echo "verdict-$path-$machine.$end.txt ncverify -q -r 4 -g flat.xyz -m $machine $path-$machine.$end"
			done
		done
		echo "verdict-plane.$end.txt ncverify -q -r 6 -g dome.xyz plane.$end"
		echo "verdict-plane-points.$end.txt ncverify -q -r 6 -g dome.xyz plane-points.$end"
		echo "plane-points.$end ncpost -q -c $control --plane dome-3plus2.cl"
		echo "plane.$end ncpost -q -c $control --plane dome-3plus2-splines.cl"
		echo "hand.$end program $control"
		echo "verdict-hand.$end.txt ncverify -q -r 4 -g flat.xyz hand.$end"
		echo "verdict-hand-head.$end.txt ncverify -q -m head-ca -r 4 -g flat.xyz hand.$end"
		echo "plot-hand.$end.svg ncplot -q hand.$end"
		echo "verdict-map.$end.txt also 'map-$end.ply page-$end.html' -- ncverify -q -r 8 -g panel.xyz --map map-$end.ply --report page-$end.html panel-arcs.$end"
		echo "verdict-stock.$end.txt ncverify -q -r 2 -g wave.xyz --stock box,1 --cell 0.3 wave-splines.$end"
		echo "verdict-holder.$end.txt ncverify -q -r 2 -g wave.xyz --holder 2:5+8:30 wave-splines.$end"
	done
	cat <<-'END'
		verdict-e.txt ncverify -q -r 8 -g panel.xyz -e 0.001 --left 0.01 --band 1 --flute 20 panel-arcs.mpf
		verdict-c.txt ncverify -q -c fanuc -r 8 -g panel.xyz panel-arcs.nc
		verdict-mesh.txt ncverify -q -r 8 -g panel-4.ply panel-arcs.mpf
		verdict-s1.txt ncverify -q -r 4 -g s1.igs s1-splines.mpf
		verdict-nurbs.txt ncverify -q -r 4 -g saddle.nurbs s1-splines.mpf
		verdict-centre.txt ncverify -q --centre -r 2 -g wave.xyz wave-splines.mpf
		verdict-unit.txt ncverify -q -u inch -r 6 -g dome.inch dome-arcs.mpf
		verdict-set.txt ncverify -q --set x.max=10 -r 6 -g dome.xyz dome-arcs.mpf
		verdict-fast.txt ncverify -q --set a.rapid=10 --set c.rapid=10 -r 6 -g dome.xyz dome-lead-arcs.mpf
		dome-lead-arcs.mpf ncpost -q -c siemens dome-lead-arcs.cl
		verdict-box.txt ncverify -q -r 6 -g dome.xyz --stock box dome-arcs.mpf
		verdict-corners.txt ncverify -q -r 6 -g dome.xyz --stock box:-20,-15,0,20,15,25 dome-arcs.mpf
		verdict-offset.txt ncverify -q -r 6 -g dome.xyz --stock offset,1 --holder 5:20+15:20:10+20:40 dome-arcs.mpf
		verdict-layers.txt ncverify -q -r 6 -g dome.xyz --stock offset,2 dome-layers.mpf
		dome-layers.mpf ncpost -q -c siemens dome-layers.cl
		verdict-page.txt also 'stock.html stock.ply' -- ncverify -q -r 6 -g dome.xyz --stock offset,1 --holder 5:20+15:20 --report stock.html --map stock.ply dome-arcs.nc
		verdict-deep.txt sed '/^N[0-9]*50 .*Z/s/Z/Z-/' dome-arcs.mpf >deep.mpf; ncverify -q -r 6 -g dome.xyz deep.mpf
		verdict-leap.txt awk 'NR == 60 { sub(/Z[-0-9.]*/, "Z90") } { print }' dome-fixed.mpf >leap.mpf; ncverify -q -r 6 -g dome.xyz leap.mpf
		verdict-leap-spline.txt awk '/BSPLINE/ { in_it = 1 } in_it && ++n == 3 { sub(/Z[-0-9.]*/, "Z190") } { print }' wave-splines.mpf >leap-s.mpf; ncverify -q -r 2 -g wave.xyz leap-s.mpf
		verdict-cut.txt head -n 60 dome-arcs.mpf >cut.mpf; ncverify -q -r 6 -g dome.xyz cut.mpf
	END
}

pictures() {
	for stream in panel.xyz face.xyz panel-4.ply panel-8.cl panel-arcs.cl wave-splines.cl panel-arcs.nc panel-arcs.mpf \
		panel-arcs.h panel-arcs.ngc shapes.cl holes.cl s1.ply dome.csv dome-points.ply; do
		echo "plot-$stream.svg ncplot -q $stream"
	done
	for view in both plan iso front side all; do
		echo "plot-view-$view.svg ncplot -q --view $view panel-4.ply panel-arcs.cl"
	done
	for colour in auto pass kind; do
		echo "plot-colour-$colour.svg ncplot -q --colour $colour shapes.cl"
	done
	cat <<-'END'
		plot-compare.svg ncplot -q --compare wave.ply wave-coarse.ply
		plot-compare-3.svg ncplot -q --compare wave-2.cl wave-arcs.cl wave-splines.cl
		plot-compare-cloud.svg ncplot -q --compare wave.xyz wave-coarse.ply wave-2.cl wave-arcs.mpf
		plot-points.svg ncplot -q --joints --poles --axes --show-normals wave-splines.cl
		plot-normals.svg ncplot -q --show-normals --view iso wave-coarse.ply
		plot-axes.svg ncplot -q --axes --cut --title 'A title & more' --width 600 winding.cl
		plot-poles.svg ncplot -q --poles --joints --axes wave-splines.nc
		plot-machine.svg ncplot -q -m head-ca wave-splines-head-ca.nc
		plot-units.svg ncplot -q -u inch dome.inch
		plot-many.svg ncplot -q --cut face.xyz face.cl
		plot-fine.svg ncplot -q --view all s1-fine.ply torus-e.ply
		plot-stdin.svg ncplot -q - panel.xyz <shapes.cl
		plot-stdin-program.svg cat panel-arcs.mpf | ncplot -q --compare panel-arcs.cl -
		plot-compare-splines.svg ncplot -q --compare wave-splines.cl wave-splines.mpf wave-splines.nc
		plot-none.svg ncplot -q nowhere.cl
	END
}

# One job of each tool by 1 and by 8 threads: two lines of the same hash
threads() {
	for n in 1 8; do
		cat <<-END
			threads-$n.ply cloud2mesh --nodes scan -q -j $n -e 0.03 wall.xyz
			threads-$n-grid.ply cloud2mesh --nodes scan -q -j $n -t 2 face.xyz
			threads-$n-parts.ply cloud2mesh --nodes scan -q -j $n --subdivide box.xyz
			threads-$n-nurbs.ply nurbs2mesh -q -j $n -e 0.05 torus.nurbs
			threads-$n.cl meshnorm --rows mesh -q -j $n -r 3 --avoid --holder 3:5+8:20 -g wave-noise.xyz wave-noise.ply
			threads-$n-cut.cl planecut -q -j $n -r 5 --avoid -s 1 -g wave.xyz wave.ply
			threads-$n-arcs.cl biarcfit -q -j $n -e 0.02 -g wave.xyz wave-5g.cl
			threads-$n-splines.cl bsplfit -q -j $n -e 0.02 -g wave.xyz wave-5g.cl
			threads-$n.nc ncpost -q -j $n -c fanuc --set tcp=no wave-splines.cl
			threads-$n.txt also 'threads-$n-map.ply' -- ncverify -q -j $n -r 2 -g wave.xyz --stock offset,1 --map threads-$n-map.ply wave-splines.mpf
			threads-$n.svg ncplot -q -j $n --compare wave.ply wave-coarse.ply
		END
	done
}

# What the command line is like: exit status and streams; what is said may change
manners() {
	for tool in cloud2mesh nurbs2mesh meshnorm planecut biarcfit bsplfit ncpost ncverify ncplot; do
		case $tool in
		cloud2mesh) does='-t 2 dome.xyz' ;;
		nurbs2mesh) does='-n 8 saddle.nurbs' ;;
		meshnorm) does='-r 6 dome.ply' ;;
		planecut) does='-r 6 -s 4 dome.ply' ;;
		ncpost) does='-c fanuc shapes.cl' ;;
		ncverify) does='-r 6 -g dome.xyz dome-arcs.nc' ;;
		ncplot) does=shapes.cl ;;
		*) does=dome-3plus2.cl ;;
		esac
		cat <<-END
			said-$tool $tool -v $does
			told-$tool $tool $does
			file-$tool also file-$tool.out -- $tool -q -o file-$tool.out $does
			folder-$tool $tool -q -o no/such/folder $does
			help-$tool $tool -h >/dev/null
			version-$tool $tool --version >/dev/null
			unknown-$tool $tool --frobnicate $does
			lacking-$tool $tool -o
			empty-$tool $tool -q </dev/null
			full-$tool $tool -q $does >/dev/full
		END
	done
	cat <<-'END'
		forms.cl meshnorm -qr6 --fixed=0,0,1 --one-way -- dome.ply
		forms-stdin.cl meshnorm --rows mesh -r 6 -q - <dome.ply
		forms-number.cl meshnorm --rows mesh -r six dome.ply
		forms-vector.cl meshnorm --rows mesh -r 6 --fixed 0,1 dome.ply
		forms-word.cl meshnorm --rows mesh -r 6 --coolant much dome.ply
		forms-twice.cl meshnorm --rows mesh -r 6 dome.ply wave.ply
		pipe.mpf cloud2mesh --nodes scan -q -t 4 panel.xyz | meshnorm --rows mesh -q -r 8 | biarcfit -q -e 0.01 | ncpost -q -c siemens
	END
}

awkward_input() {
	awk -F , 'NR > 1 && $1 != "" { command = $2; sub(/@/, $1 ~ /^machine/ ? "./" $1 : $1, command)
		print "awkward-" $1 (seen[$1]++ ? "-" seen[$1] : "") " cd \"$awkward\" && " command " -q" }' "$awkward/expected.csv"
}

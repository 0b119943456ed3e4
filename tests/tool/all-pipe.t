#!/bin/sh
# all-pipe.t - every pipe from a scan of a face to a program, read back by the tests' own reader:
# the program does what the path says, within what ncpost states; and no broken input, at whatever
# stage, gives anything that looks complete.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# What is about its eyes and its nose.
face=face.xyz
awk '$2 > -30 && $2 < 10' "$SRC/samples/face_nefertiti_26493.xyz" >$face

ok "cloud2mesh makes a mesh of the face" cloud2mesh -q -t 4 -o mesh.ply $face
ok "meshnorm makes a path of it" meshnorm -q -r 8 --rows mesh --no-guard \
	--axis-play 12 -o none.cl mesh.ply
ok "biarcfit fits arcs" biarcfit -q -o biarcfit.cl none.cl
ok "bsplfit fits B-splines" bsplfit -q -o bsplfit.cl none.cl
has "the path of arcs has arcs" '^CIRCLE/' biarcfit.cl
has "the path of splines has splines" '^MOVNRB/ON' bsplfit.cl

# follows NAME FITTER "NCPOST-OPTIONS" "READBACK-OPTIONS": the program is as near to the path as it
# was to be (0.005 mm and 0.05 degrees, and rounding) and, within a tenth, as ncpost -v says:
# `kept 0.0059 mm and 0.0503 deg`
follows() {
	name="$2, ncpost $3"
	# shellcheck disable=SC2086 # options
	status 0 "$name: makes a program" ncpost -v $3 -o "$1-$2" "$2.cl"
	tip=$(sed -n 's/.*kept \([0-9.]*\) mm and.*/\1/p' err)
	axis=$(sed -n 's/.*kept .* mm and \([0-9.]*\) deg.*/\1/p' err)
	below "$name: keeps what it was to" "$tip" 0.006
	below "$name: in degrees too" "$axis" 0.0505
	# what the reader takes to be beside what, where the tip all but stands, goes by both limits
	# shellcheck disable=SC2086
	status 0 "$name: read back, it follows the path" \
		"$READBACK" $4 -e "$(awk -v t="$tip" 'BEGIN { print 1.1 * t + 0.0001 }')" \
		--axis "$(awk -v a="$axis" 'BEGIN { print 1.1 * a + 0.0002 }')" --path "$2.cl" "$1-$2"
	found=$(sed -n 's/^program on path: tip \([0-9.]*\).*/\1/p' out)
	below "$name: off by no more than it says" "$found" \
		"$(awk -v t="$tip" 'BEGIN { print 1.1 * t + 0.0001 }')"
	found=$(sed -n 's/^program on path: .* axis \([0-9.]*\).*/\1/p' out)
	below "$name: its axis too, degrees" "$found" \
		"$(awk -v a="$axis" 'BEGIN { print 1.1 * a + 0.0002 }')"
}

for fitter in none biarcfit bsplfit; do
	follows fanuc $fitter "-c fanuc" "-c fanuc"
	follows vectors $fitter "-c fanuc --vectors" "-c fanuc"
	follows siemens $fitter "-c siemens" "-c siemens"
	follows rotary $fitter "-c siemens --rotary" "-c siemens"
	for control in fanuc siemens; do
		follows $control-bc $fitter "-c $control -m table-bc" "-c $control --axes bc"
		follows $control-notcp $fitter "-c $control -m table-ac-notcp" "-c $control --no-tcp"
	done
done
has "Siemens: arcs as CIP" 'CIP' siemens-biarcfit
has "Siemens: splines as polynomials" 'POLY' siemens-bsplfit
has "Fanuc: splines as G06.2" 'G0?6\.2' fanuc-bsplfit
has "Fanuc: vectors" 'G43\.5' vectors-none
has "no TCP: inverse time feed" 'G93' fanuc-notcp-none
hasnt "no TCP: none is asked for" 'G43\.[45]' fanuc-notcp-none
hasnt "no TCP: none is asked for (Siemens)" 'TRAORI' siemens-notcp-none

# The whole pipe in one line gives the same program as its stages one by one.
sh -c "cloud2mesh -q -t 4 $face | meshnorm -q -r 8 --rows mesh --no-guard --axis-play 12 |
	biarcfit -q | ncpost -q -c siemens" >whole
grep -v ';' whole >a
grep -v ';' siemens-biarcfit >b
same "the pipe is its stages" a b

# Half of the input, at every stage: exit 1 from there on, no end mark at the end of the pipe.
half() { # FILE: its first half, cut at a line
	lines=$(wc -l <"$1")
	head -n $((lines / 2)) "$1"
}
half mesh.ply >half.ply
half none.cl >half.cl
half biarcfit.cl >half_arcs.cl
half bsplfit.cl >half_splines.cl
{
	head -n 3000 $face
	echo "1.0 2.0 broken"
	tail -n 3000 $face
} >broken.xyz

dies() { # DESC INPUT STAGE...: each stage in a pipe of its own files, each exits 1 and writes nothing
	desc=$1 from=$2
	shift 2
	for stage; do
		status 1 "$desc: $stage exits 1" sh -c "$stage <$from"
		cp out next
		hasnt "$desc: $stage leaves no end mark" '^(FINI|.*M30)' next
		empty "$desc: $stage leaves nothing at all" next
		from=next
	done
}
for fitter in biarcfit bsplfit; do
	for control in fanuc siemens; do
		dies "broken cloud" broken.xyz "cloud2mesh -t 4" "meshnorm -r 8" $fitter "ncpost -c $control"
		dies "half a mesh" half.ply "meshnorm -r 8" $fitter "ncpost -c $control"
		dies "half a path" half.cl $fitter "ncpost -c $control"
	done
done
for control in fanuc siemens; do
	for part in half.cl half_arcs.cl half_splines.cl; do
		dies "half a path ($part)" $part "ncpost -c $control"
	done
done
done_testing

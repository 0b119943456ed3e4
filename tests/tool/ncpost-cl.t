#!/bin/sh
# ncpost-cl.t - CL files of CAM systems: every one is posted for every control and read back equal,
# what is cut off is refused, and each trap of their dialects has its say.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack them.
ncpost() { command ncpost --no-spindle "$@"; }
data=$SRC/tests/data/cl
cd "$TMP" || exit 1

# ---- whole files, real and by hand
for file in "$data"/*.ncl "$data"/*.cls "$data"/*.cldata "$data"/*.apt; do
	name=$(basename "$file")
	for control in fanuc siemens heidenhain; do
		status 0 "$name for $control" ncpost -q -c $control -o "back.$control" "$file"
		steps=
		grep -Eq ' G(73|83) |CYCLE83|CYCL DEF 20[35]' "back.$control" && steps=--no-steps
		ok "$name for $control, read back" "$READBACK" -c $control $steps --path "$file" \
			-e 0.0062 --axis 0.052 "back.$control"
	done
	ok "$name without a word that nobody knows" ncpost --strict -c linuxcnc "$file"
	for machine in table-ac linuxcnc-xyzac; do
		ncpost -q -c linuxcnc -m $machine -o back.ngc "$file"
		axes=--no-tcp
		[ $machine = linuxcnc-xyzac ] && axes=--reversed
		# tilted axes that the program itself keeps at the tip make places on a rapid too
		[ $machine = table-ac ] && grep -q G93 back.ngc && continue
		desc="$name for linuxcnc, $machine, run by rs274, read back"
		command -v rs274 >/dev/null || { skip "$desc" "no rs274"; continue; }
		grep -Eq ' G(73|83) ' back.ngc && axes="$axes --no-steps"
		canon back.ngc >back.canon || cat canon.err
		# shellcheck disable=SC2086
		ok "$desc" "$READBACK" -c canon $axes \
			--path "$file" -e 0.0062 --axis 0.052 back.canon
	done
done

# ---- LinuxCNC without kinematics of its own: an upright job keeps its arcs, and rounds within G64 P
for file in "$data/creo_schruppen_1.ncl" "$data/nx_coremill.cls"; do
	name=$(basename "$file")
	ncpost -q -c linuxcnc -o upright.ngc "$file"
	ncpost -q -c linuxcnc -m linuxcnc-xyzac -o always.ngc "$file"
	for program in upright always; do grep -Ec '^N[0-9]+ .*G0?[23] |^N[0-9]+ .*I.* J' $program.ngc >$program.arcs; done
	result "$([ "$(cat upright.arcs)" -gt 100 ]; echo $?)" "$name upright: arcs stay"
	same "$name upright: as many as with the kinematics of a trunnion" always.arcs upright.arcs
	hasnt "$name upright: no inverse time" 'G93' upright.ngc
	has "$name upright: G64 P" ' G64 P0\.' upright.ngc
done
printf '%s\n' 'GOTO/0,0,9,0,0.6,0.8' 'GOTO/5,0,0,0,0.6,0.8' FINI >lean.cl
ncpost -q -c linuxcnc -o lean.ngc lean.cl
has "a job that leans: inverse time" 'G93' lean.ngc

# ---- cut off anywhere: refused, and nothing written
for file in "$data"/*.ncl "$data"/*.cls "$data"/*.cldata "$data"/*.apt; do
	size=$(wc -c <"$file")
	k=1
	while [ $k -lt 50 ]; do
		head -c $((size * k / 50)) "$file" >cut.cl
		ncpost -q -c fanuc cut.cl >cut.out 2>cut.err
		got=$?
		# two tool paths of NX may stand alone
		[ $got -eq 0 ] && [ "$(tail -n 1 cut.cl)" = END-OF-PATH ] && got=1 && : >cut.out
		{ [ $got -eq 1 ] && [ ! -s cut.out ]; } || echo "$k of 50: exit $got"
		k=$((k + 1))
	done >cuts
	empty "$(basename "$file"), cut off at 49 places" cuts
done

# ---- traps: the program that comes of a few lines
posts() { # DESC REGEX LINES...: a Fanuc program of these lines has such a block
	desc=$1
	regex=$2
	shift 2
	printf '%s\n' "$@" >trap.cl
	ncpost -q -c fanuc trap.cl >trap.nc 2>"$TMP/err" || { result 1 "$desc (refused)"; return; }
	has "$desc" "$regex" trap.nc
}

refuses() { # DESC REGEX LINES...: they are refused with such a message
	desc=$1
	regex=$2
	shift 2
	printf '%s\n' "$@" >trap.cl
	status 1 "$desc" ncpost -q -c fanuc trap.cl
	has "$desc: told" "$regex" err
}

posts "a continuation with a comment behind it" 'X12\. Y34\.' \
	'GOTO/0,0,9' "GOTO/12, \$ \$\$ half" '34,0' FINI
posts "a Creo comment that goes on" 'X1\.' "\$\$* Pro/CLfile 8.0" \
	"\$\$-> CSYS / 1, 0, 0, 0, \$" ' 0, 1, 0, 0' 'GOTO / 0, 0, 9' 'GOTO / 1, 0, 0' FINI
posts "RAPID/ with a slash" 'G0 X5\.' 'GOTO/0,0,9' 'RAPID/' 'GOTO/5,0,9' FINI
posts "COOLNT/ without a word" 'M8' 'COOLNT/' 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "raw text with a dollar" 'X5\.' "PPRINT costs 5 \$" 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "tabs" 'X5\.' 'GOTO/0,0,9' "$(printf '\tGOTO\t/\t5,\t0,\t9')" FINI
posts "CRLF" 'X5\.' "$(printf 'GOTO/0,0,9\r\nGOTO/5,0,9\r')" FINI
posts "start = end of an arc is a full circle" 'G3 .*I-5\.' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' 'GOTO/5,0,0' FINI
for control in fanuc siemens heidenhain linuxcnc; do # as NX leaves them: no circle, 68.9 mm wide
	printf '%s\n' 'GOTO/247.6881,58.9352,50' \
		'CIRCLE/191.1806,98.3949,50,0,0,1,68.9214,.06,.5,30,0' 'GOTO/213.0421,33.0325,50' \
		'CIRCLE/191.1806,98.3949,50,0,0,1,68.9214,.06,.5,30,0' 'GOTO/213.0420,33.0325,50' \
		'GOTO/213.0129,33.0228,50' FINI >trap.cl
	ncpost -q -c $control -m linuxcnc-xyzac trap.cl >trap.nc
	result "$([ "$(grep -Ec ' (G2|CIP|C X.*DR-)( |$)' trap.nc)" -eq 1 ]; echo $?)" \
		"$control: an arc of its last digit is no circle"
done
posts "one GOTO ends an arc, the next is straight" 'G1 X-9\.' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' 'GOTO/0,5,0' 'GOTO/-9,9,0' FINI
posts "an arc of seven numbers turns right-handed" 'G3 ' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' 'GOTO/0,5,0' FINI
posts "one of eleven clockwise" 'G2 ' 'GOTO/5,0,0' \
	'CIRCLE/0,0,0,0,0,1,5,.06,.5,10,0' 'GOTO/0,-5,0' FINI
posts "an arc without a radius" 'G2 X0\. Y-5\.' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,-1' 'GOTO/0,-5,0' FINI
posts "an arc that ends higher is a helix" 'G3 X0\. Y5\. Z2\.' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' 'GOTO/0,5,2' FINI
posts "start above end: a whole turn of it" 'G3 X-5\. .*Z1\.' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' 'GOTO/5,0,2' FINI
posts "IPM" 'F254\.' 'FEDRAT/10,IPM' 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "IPR" 'F5080\.' 'SPINDL/2000,RPM' 'FEDRAT/.1,IPR' 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "MMPR" 'F200\.' 'SPINDL/2000,RPM' 'FEDRAT/MMPR,.1' 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "PERMIN" 'F141\.' 'FEDRAT/PERMIN,141' 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "INVERS: 4 a minute over 5 mm" 'F20\.' 'GOTO/0,0,9' 'FEDRAT/INVERS,4' 'GOTO/5,0,9' FINI
posts "FROM and GODLTA" 'Z58\.' 'FROM/5,2,9' 'GODLTA/2,0,-1' 'GOTO/9,9,9' FINI
posts "ORIGIN is taken away" 'X4\. Y3\.' 'ORIGIN/1,2,3' 'GOTO/0,0,9' 'GOTO/5,5,9' FINI
posts "TRANS is added" 'X6\. Y7\.' 'TRANS/1,2,3' 'GOTO/0,0,9' 'GOTO/5,5,9' FINI
posts "DELAY" 'G4 X1\.5' 'GOTO/0,0,9' 'DELAY/1.5' 'GOTO/5,5,9' FINI
posts "DELAY by turns" 'G4 X0\.3' 'SPINDL/RPM,2000' 'GOTO/0,0,9' 'DELAY/REV,10' 'GOTO/5,5,9' FINI
posts "STOP" 'M0$' 'GOTO/0,0,9' 'STOP' 'GOTO/5,5,9' FINI
posts "OPSTOP" 'M1$' 'GOTO/0,0,9' 'OPSTOP' 'GOTO/5,5,9' FINI
posts "another speed" 'S900 M4' 'SPINDL/RPM,2000,CLW' 'GOTO/0,0,9' 'SPINDL/900,RPM,CCLW' \
	'GOTO/5,5,9' FINI
posts "MULTAX without /ON, a label, numbers alone" 'X5\. Y6\.' \
	'MULTAX' 'N30 ,GOTO/0,0,9,0,0,1' '5,6,9,0,0,1' FINI
posts "GOTO with three numbers keeps the axis" 'N[0-9]+ Y5\.' \
	'GOTO/0,0,9,0,0.6,0.8' 'GOTO/0,5,9' FINI
posts "MULTAX/OFF: upright again" 'Y5\. A0\.' 'GOTO/0,0,9,0,0.6,0.8' MULTAX/OFF 'GOTO/0,5,9' FINI
posts "TOOLNO, LOADTL: another tool" 'T7 M6' 'TOOLNO/2' 'LOADTL/2' 'GOTO/0,0,9' 'GOTO/0,0,0' \
	'TOOLNO/7' 'LOADTL/7' 'GOTO/0,5,0' FINI
result "$([ "$(grep -c ' M6$' trap.nc)" -eq 2 ]; echo $?)" "each of them once"

# ---- radius compensation: left out and said, or the control's by a key
cat >cutcom.cl <<'END'
UNITS/MM
LOADTL/7
SPINDL/9000,RPM,CLW
RAPID
GOTO/0,9,20
FEDRAT/500
GOTO/0,9,-1
CUTCOM/LEFT
GOTO/0,-1,-1
GOTO/30,-1,-1
CIRCLE/30,9,-1,0,0,1,10
GOTO/40,9,-1
CUTCOM/OFF
GOTO/60,9,-1
RAPID
GOTO/60,9,20
FINI
END
status 0 "CUTCOM" ncpost -c fanuc cutcom.cl
hasnt "left out" 'G4[12]' out
has "and said" 'CUTCOM: X Y Z are the tool' err
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -c $control --set cutcom=yes -o cutcom.$control cutcom.cl 2>cutcom.err
	empty "cutcom = yes: nothing to say for $control" cutcom.err
done
has "Fanuc: on with D" ' G41 D7 Y-1\.' cutcom.fanuc
has "off with the next straight move" ' G1 G40 X60\.' cutcom.fanuc
has "Siemens" ' G41 Y-1' cutcom.siemens
has "Heidenhain" ' L Y-1 RL$' cutcom.heidenhain
has "and off" ' L X\+60 R0' cutcom.heidenhain
if command -v rs274 >/dev/null; then
	diameter=0.31496063 # inches, as that interpreter takes them: 8 mm
	canon cutcom.linuxcnc >cutcom.canon
	has "LinuxCNC offsets to the left by its tool's radius" 'STRAIGHT_FEED\(30\.0000, 3\.0000, -1' cutcom.canon
else
	skip "LinuxCNC offsets to the left by its tool's radius" "no rs274"
fi
# ---- drilling as the systems word it
posts "NX: a tool by its name, then its number; RTRCTO,AUTO" 'G98 G81 X10\. Y5\. Z-20\.5 R3\. F220' \
	'TOOL PATH/D,TOOL,DR_8' 'TLDATA/DRILL,8.5,118,80,45' 'LOAD/TOOL,7' 'SPINDL/RPM,1800,CLW' RAPID \
	'GOTO/10,5,25,0,0,1' 'CYCLE/DRILL,RAPTO,3,FEDTO,-20.5,RTRCTO,AUTO,MMPM,220' 'GOTO/10,5,0' CYCLE/OFF \
	END-OF-PATH
posts "NX: DRILL,DEEP" 'G83 .*Q4\.' 'TOOL PATH/D,TOOL,DR_8' 'GOTO/10,5,25,0,0,1' \
	'CYCLE/DRILL,DEEP,RAPTO,3,STEP,4,FEDTO,-20.5,MMPM,220' 'GOTO/10,5,0' CYCLE/OFF END-OF-PATH
posts "NX: a tap by MMPR" 'G84 .*F450\.' 'TOOL PATH/D,TOOL,TAP' 'SPINDL/RPM,300,CLW' 'GOTO/10,5,25,0,0,1' \
	'CYCLE/TAP,RAPTO,5,FEDTO,-15,MMPR,1.5' 'GOTO/10,5,0' CYCLE/OFF END-OF-PATH
posts "Creo: RETURN, and a word with its number passed over" 'G98 G83 X1\. Y2\. Z-28\. R5\. Q5\. F90' \
	"\$\$* Pro/CLfile 10.0" 'RAPID' 'GOTO / 1, 2, 50' \
	'CYCLE / DEEP, STEP, 5.0, DEPTH, 28.0, MMPM, 90.0, CLEAR, 5.0, RETURN, 20.0, DIAMET, 12.0' \
	'GOTO / 1, 2, 0' 'CYCLE / OFF' FINI
posts "CATIA: depth, feed, unit, clearance" 'G99 G81 X25\. Y0\. Z-10\. R1\. F300' \
	"\$\$ CATIA APT VERSION 1.0" RAPID 'GOTO  /   0.0, 0.0, 100.0' 'TOOLNO/1,   10.0' 'LOADTL/1' \
	'CYCLE/DRILL, 10.000000, 300.000000,MMPM,  1.000000' 'GOTO/25,0,0' CYCLE/OFF FINI
result "$([ "$(grep -c ' M6$' trap.nc)" -eq 1 ]; echo $?)" "a rapid before the first tool is made with it"
posts "inches: IPM in a cycle" 'Z-19\.05 R2\.54 Q6\.35 F101\.6' UNITS/INCHES 'GOTO/1,1,1' \
	'CYCLE/DEEP,FEDTO,.75,IPM,4,STEP,.25,RAPTO,.1' 'GOTO/1,3,0' FINI
posts "Creo, cycle_format fixed: depth, feed, unit, clearance, step" 'G83 X1\. Y2\. Z-20\. R2\. Q5\. F200' \
	'GOTO/0,0,9' 'CYCLE/DEEP,20,200,MMPM,2,5' 'GOTO/1,2,0' CYCLE/OFF FINI
posts "of a tap the turns an inch" 'G84 X1\. Y2\. Z-10\. R2\. F1270\.' \
	UNITS/MM 'SPINDL/RPM,1000' 'GOTO/0,0,9' 'CYCLE/TAP,10,1,IPM,20,2' 'GOTO/1,2,0' CYCLE/OFF FINI
posts "Creo: RAPTO goes on from CLEAR" 'G98 G81 X1\. Y2\. Z-10\. R2\. F90' \
	"\$\$* Pro/CLfile 10.0" 'GOTO / 0, 0, 50' \
	'CYCLE / DRILL, DEPTH, 10, MMPM, 90, CLEAR, 5, RAPTO, 3' 'GOTO / 1, 2, 0' 'CYCLE / OFF' FINI
posts "Creo: RETURN, 0 is back to where the tool was" 'G0 X1\. Y2\.$' \
	"\$\$* Pro/CLfile 10.0" 'GOTO / 0, 0, 50' \
	'CYCLE / DRILL, DEPTH, 10, MMPM, 90, CLEAR, 5, RETURN, 0' 'GOTO / 1, 2, 0' 'GOTO / 3, 2, -4' \
	'CYCLE / OFF' FINI
has "from there" ' G98 G81 X1\. Y2\. Z-10\. R5\.' trap.nc
has "the next hole too" ' G98 G81 X3\. Y2\. Z-14\. R1\.' trap.nc
hasnt "with no way between" ' Z46\.| Z50\..*Y2' trap.nc
posts "STEP with several: the smallest behind the first" 'CYCLE|Q2\.' 'GOTO/0,0,9' \
	'CYCLE/DEEP,DEPTH,20,STEP,6,4,2,MMPM,90' 'GOTO/1,2,0' CYCLE/OFF FINI
posts "a dwell by turns" 'G82 .*P300$' 'SPINDL/RPM,1000' 'GOTO/0,0,9' \
	'CYCLE/DRILL,DEPTH,5,REV,5' 'GOTO/1,2,0' CYCLE/OFF FINI
posts "a rapid into a hole that is there" 'G0 X1\. Y2\.|Z-3\.$' 'GOTO/0,0,9' \
	'CYCLE/DRILL,RAPTO,-3,FEDTO,-10,MMPM,90' 'GOTO/1,2,0' CYCLE/OFF FINI
has "then at feed" 'G1 Z-10\. F90' trap.nc
hasnt "no cycle of the control" 'G81' trap.nc
posts "BORE,MANUAL: the program stops at the bottom" '^N[0-9]+ M0$' 'SPINDL/RPM,1000,CLW' 'GOTO/0,0,9' \
	'CYCLE/BORE,MANUAL,DEPTH,10,MMPM,90' 'GOTO/1,2,0' CYCLE/OFF FINI
result "$([ "$(grep -c 'M[035]$\|M3$' trap.nc)" -ge 5 ]; echo $?)" "its spindle stopped, and turned again"
printf '%s\n' 'SPINDL/RPM,1000,CLW' 'GOTO/0,0,30' 'CYCLE/TAP,DEPTH,10,PITCH,1,CLEAR,2,RTRCTO,9' 'GOTO/1,2,0' \
	'GOTO/3,4,0' CYCLE/OFF FINI >trap.cl
ok "a tap is left high" ncpost -q -c linuxcnc -m linuxcnc-xyzac -o trap.ngc trap.cl
has "LinuxCNC: at feed to R alone" ' G99 G84 X3\. Y4\. Z-10\. R2\.' trap.ngc
result "$([ "$(grep -A2 ' G84 ' trap.ngc | grep -c ' G0 Z9\.$')" -eq 2 ]; echo $?)" "then at rapid"
refuses "BORE,BACK: not from above" 'from above' 'GOTO/0,0,9' 'CYCLE/BORE,BACK,DEPTH,3' 'GOTO/0,0,0' FINI
posts "SPINDL: a limit is no speed" 'S900 M3' 'SPINDL/MAXRPM,5000,RPM,900,CLW' 'GOTO/0,0,9' 'GOTO/5,5,9' FINI
posts "SPINDL/ON: as fast as before" 'S900 M4' 'SPINDL/900,RPM,CCLW' 'GOTO/0,0,9' SPINDL/OFF 'GOTO/5,5,9' \
	SPINDL/ON 'GOTO/9,9,9' FINI
result "$([ "$(grep -c 'S900 M4' trap.nc)" -eq 2 ]; echo $?)" "twice"
posts "SPINDL/ORIENT: an angle is no speed" 'S900 M3' 'SPINDL/900,RPM' 'GOTO/0,0,9' SPINDL/ORIENT,30 \
	'GOTO/5,5,9' FINI
hasnt "no speed of it" 'S30' trap.nc
posts "FEDRAT/INVERS,AUTO: the machine's business" 'X5\. F300' 'GOTO/0,0,9' 'FEDRAT/300,MMPM' \
	'FEDRAT/INVERS,AUTO' 'GOTO/5,0,9' 'FEDRAT/INVERS,OFF' 'GOTO/9,0,9' FINI
posts "GODLTA with the axis" 'G1 Y2\. Z8\. ' 'FROM/5,2,9' 'GODLTA/2,0,-1,0,-.6,.8' 'GOTO/9,9,9' FINI
has "that axis" 'A-?36\.87' trap.nc
posts "GOHOME: at rapid to FROM" 'G0 X1\. Y2\. Z90\.' 'FROM/1,2,90' 'GOTO/9,9,9' GOHOME 'GOTO/9,9,9' FINI
posts "GOHOME with its place" 'G0 X3\. Y4\. Z80\.' 'GOTO/9,9,9' GOHOME/3,4,80 'GOTO/9,9,9' FINI
posts "RETRCT: along the tool axis to the clearance plane" 'G0 Y1\.5 Z19\.' 'CLEARP/XYPLAN,19' \
	'GOTO/9,9,9,0,-.6,.8' RETRCT 'GOTO/9,9,9' FINI
posts "to a plane in space" 'G0 Y29\.' 'CLRSRF/0,1,0,29' 'GOTO/9,9,9,0,1,0' RETRCT 'GOTO/9,9,9' FINI
printf '%s\n' 'GOTO/0,0,9' RETRCT 'GOTO/5,0,9' FINI >trap.cl
status 0 "RETRCT without a plane" ncpost -c fanuc trap.cl
has "is ignored and reported" 'ignored the unknown word RETRCT' err
posts "ROTABL by nothing" 'X5\.' 'GOTO/0,0,9' ROTABL/ATANGL,0 'GOTO/5,0,9' FINI
posts "OSETNO: the offset's number" ' G43\.4 H12$' 'LOADTL/3,OSETNO,12' 'GOTO/0,0,9' 'GOTO/5,0,9' FINI
posts "NX: ADJUST" ' G43\.4 H12$' 'TOOL PATH/A,TOOL,B' 'LOAD/TOOL,3,ADJUST,12' 'GOTO/0,0,9' 'GOTO/5,0,9' \
	END-OF-PATH
posts "the machine's words between CIRCLE and its end" 'G3 X0\. Y5\. .*F90' 'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' \
	COOLNT/ON FEDRAT/90 'GOTO/0,5,0' FINI
posts "CATIA: PSIS in front of an arc" 'G3 X0\. Y5\.' 'GOTO/5,0,0' 'INDIRV/0,1,0' 'PSIS/(PLANE/0,0,1,0)' \
	'TLON,GOFWD/(CIRCLE/0,0,0,5),ON,(LINE/0,0,0,0,5,0)' FINI
posts "AUXFUN: an M word" '^N[0-9]+ M88$' 'GOTO/0,0,9' 'AUXFUN/88' 'GOTO/5,0,9' FINI
refuses "an arc among holes" 'CYCLE/OFF' 'GOTO/1,0,0' 'CYCLE/DRILL,DEPTH,2' 'CIRCLE/0,0,0,0,0,1,1' \
	'GOTO/0,1,0' FINI
refuses "a cycle nobody knows" 'CYCLE/FROB' 'GOTO/0,0,9' 'CYCLE/FROB,1' 'GOTO/0,0,0' FINI
refuses "a cycle without its depth" 'depth' 'GOTO/0,0,9' 'CYCLE/DRILL,CLEAR,1' 'GOTO/0,0,0' FINI
refuses "a feed by the turn of a spindle that stands" 'SPINDL' 'FEDRAT/MMPR,.1' 'GOTO/0,0,9' FINI
refuses "coordinates that are ways" 'incremental' 'MODE/INCR' 'GOTO/0,0,9' FINI
refuses "numbers without a GOTO" 'without a word' 'RAPID' '1,2,3' FINI
refuses "a table that turns by itself" 'ROTABL' 'ROTABL/30' 'GOTO/0,0,9' FINI
posts "NX: a helix that ends beside its start, in its second turn" 'G2 X-4\.619 Y-1\.913 Z3\. ' \
	'GOTO/5,0,4' 'CIRCLE/0,0,0,0,0,1,5,.06,.5,10,0,TIMES,2' 'GOTO/0,5,0' FINI
result "$([ "$(grep -c ' G2 \| I.* J' trap.nc)" -eq 4 ]; echo $?)" "630 degrees in four arcs"
has "to its end" ' X0\. Y5\. Z0\. ' trap.nc
posts "NX: in its first" 'G2 X0\. Y5\. Z0\. I-5\.' \
	'GOTO/5,0,4' 'CIRCLE/0,0,0,0,0,1,5,.06,.5,10,0,TIMES,1' 'GOTO/0,5,0' FINI
posts "Creo: points without a word that lie on the arc" ' X-5\. Y0\. I0\. J-5\.' "\$\$* Pro/CLfile 8.0" \
	'GOTO / 5, 0, 0' 'CIRCLE / 0, 0, 0, 0, 0, 1, 5' 'GOTO / 3, 4, 0' '0, 5, 0' '-5, 0, 0' '-9, 9, 0' FINI
has "and one that does not" 'G1 X-9\. Y9\.' trap.nc
posts "others: straight" 'G1 X0\. Y5\.' \
	'GOTO/5,0,0' 'CIRCLE/0,0,0,0,0,1,5' 'GOTO/3,4,0' '0,5,0' FINI
refuses "a NURBS of NX with too few knots" 'knots' 'TOOL PATH/A,TOOL,B' 'GOTO/0,0,0' 'NURBS/' \
	'KNOT/1' 'CNTRL/1,0,0' 'CNTRL/2,0,0' 'CNTRL/3,0,0' 'CNTRL/4,0,0' 'END-OF-PATH'
refuses "a B-spline of CATIA without poles" 'poles' 'GOTO/0,0,0' \
	'BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0,0,1);' 'END NURBS;' FINI
refuses "one that starts elsewhere" 'first pole' 'GOTO/0,0,0' \
	'BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0,0,1);' 'N0,XT=5,YT=0,ZT=0,DK=0,W=1.0;' \
	'N1,XT=6,YT=0,ZT=0,DK=0,W=1.0;' 'N2,XT=7,YT=0,ZT=0,DK=3,W=1.0;' 'N3,XT=8,YT=0,ZT=0,DK=0,W=1.0;' \
	'END NURBS;' FINI
refuses "a rational one" 'weight' 'GOTO/0,0,0' \
	'BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0,0,1);' 'N0,XT=0,YT=0,ZT=0,DK=0,W=1.0;' \
	'N1,XT=6,YT=0,ZT=0,DK=0,W=1.5;' FINI
refuses "one with another number of intervals" 'DK' 'GOTO/0,0,0' \
	'BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0,0,1);' 'N0,XT=0,YT=0,ZT=0,DK=0,W=1.0;' \
	'N1,XT=6,YT=0,ZT=0,DK=2,W=1.0;' 'N2,XT=7,YT=0,ZT=0,DK=3,W=1.0;' 'N3,XT=8,YT=0,ZT=0,DK=0,W=1.0;' \
	'END NURBS;' FINI
refuses "a NURBS of NX in five axes" 'fixed axis' 'TOOL PATH/A,TOOL,B' 'GOTO/0,0,0' 'NURBS/' \
	'KNOT/1' 'CNTRL/1,0,0,0,0,1' 'END-OF-PATH'
# B-splines of CATIA, the tool upright and turning: a circle's quarter by one cubic, its middle where
# the formula says it is
cat >nurbs.cl <<'STREAM'
$$     CATIA APT VERSION 1.0
UNITS/MM
MULTAX/ON
SPINDL/9000,RPM,CLW
RAPID
GOTO/0,0,50,0,0,1
FEDRAT/500
GOTO/20,0,0,0,0,1
BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0.00,0.00,1.00);
N0,XT= 20.000,YT=0.000,ZT=0.000,DK= 0.00,W=1.0;
N1,XT=20.000,YT=11.046,ZT=0.000,DK= 0.00,W=1.0;
N2,XT=11.046,YT=20.000,ZT=0.000,DK=30.00,W=1.0;
N3,XT=0.000,YT=20.000,ZT=0.000,DK= 0.00,W=1.0;
END NURBS;
RAPID
GOTO/0,20,50,0,0,1
RAPID
GOTO/0,0,50,0,0,1
GOTO/0,0,0,0,0,1
BEGIN NURBS_SIEMENS(D=3,F=3000,AXIS=VAR,LENGTH=100.00);
N0,XT= 0.000,YT=0.000,ZT=0.000,XH= 0.000, $
YH=0.000,ZH=100.00,DK= 0.00,W=1.0;
N1,XT=10.000,YT=0.000,ZT=0.000,XH=10.000, $
YH=0.000,ZH=100.00,DK= 0.00,W=1.0;
N2,XT=20.000,YT=5.000,ZT=0.000,XH=24.000, $
YH=5.000,ZH=99.92,DK=12.00,W=1.0;
N3,XT=30.000,YT=0.000,ZT=0.000,XH=40.000, $
YH=0.000,ZH=99.499,DK= 14.00,W=1.0;
N4,XT=40.000,YT=0.000,ZT=0.000,XH=60.000, $
YH=0.000,ZH=97.980,DK= 0.00,W=1.0;
END NURBS;
RAPID
GOTO/40,0,60,0.2,0,0.9798
FINI
STREAM
for control in fanuc siemens heidenhain; do
	status 0 "NURBS_SIEMENS for $control" ncpost -q -c $control -o nurbs.$control nurbs.cl
	ok "read back" "$READBACK" -c $control --path nurbs.cl -e 0.0062 --axis 0.052 nurbs.$control
done
has "as a B-spline" 'G06\.2 P4' nurbs.fanuc
has "with its feed" 'F4000' nurbs.fanuc
ncpost -q -c siemens --set splines=no --chord 0.001 -o quarter.mpf nurbs.cl
awk '/ X/ { for (i = 1; i <= NF; i++) { if ($i ~ /^X/) x = substr($i, 2); if ($i ~ /^Y/) y = substr($i, 2) } }
	/ Z50/ && y > 1 { exit }
	x + y > 20.1 { r = sqrt(x * x + y * y); d = r - 20; if (d < 0) d = -d; if (d > 0.01) print }' \
	quarter.mpf | head -n 3 >bad
empty "the quarter is round" bad
refuses "TRNTYP/LOCAL" 'WORLD' 'TRNTYP/LOCAL,0,0,0' 'GOTO/0,0,9' FINI
refuses "an arc of CATIA without its direction" 'INDIRV' 'GOTO/5,0,0' \
	'TLON,GOFWD/(CIRCLE/0,0,0,5),ON,(LINE/0,0,0,0,5,0)' FINI
refuses "a motion of APT along a curve" 'geometry word TLLFT' 'GOTO/5,0,0' 'TLLFT,GOLFT/L1' FINI
refuses "a MAKINO-FF file that ends early" 'FINI' 'PPRINT/APTCL-SPEC,MAKINO-FF,1' \
	'PPRINT/BEGIN-SECTION,PATH' 'GOTO/0,0,9' 'PPRINT/END-SECTION,PATH'

done_testing

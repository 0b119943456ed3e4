#!/bin/sh
# ncpost-missing.t - what a path lacks is said, in the program and by the exit status; what it says
# for the control alone (INSERT, coolant, stops, tool names) comes through, and nothing in silence.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

path() { # LINES...: a path of them between head and a cut
	printf '%s\n' UNITS/MM "$@" 'RAPID' 'GOTO/0,0,20' 'FEDRAT/MMPM,500' 'GOTO/0,0,0' 'GOTO/9,0,0' \
		'RAPID' 'GOTO/9,0,20' FINI
}
path LOADTL/3 >standing.cl
path SPINDL/RPM,3000,CLW >toolless.cl
path LOADTL/3 SPINDL/RPM,3000,CLW >whole.cl
sed 's/^GOTO\/0,0,0/SPINDL\/OFF\n&/' whole.cl >stopped.cl
for c in fanuc siemens heidenhain linuxcnc; do
	status 3 "$c: no speed of the spindle" ncpost -c $c -m three-axis standing.cl
	has "it is said before the first cut" 'NO SPEED OF THE SPINDLE' out
	awk '/NO SPEED/ { said = 1 } / (G1 |L .*F500)/ && !said { exit 1 }' out
	result $? "and before it"
	has "told" 'cuts without a speed of the spindle' err
	status 3 "$c: no tool" ncpost -c $c -m three-axis toolless.cl
	has "it is said" 'NO TOOL IN THE PATH' out
	status 0 "$c: --no-spindle" ncpost -c $c -m three-axis --no-spindle standing.cl
	hasnt "says nothing" 'NO SPEED' out
	status 0 "$c: --no-spindle for the tool" ncpost -c $c -m three-axis --no-spindle toolless.cl
	status 0 "$c: nothing lacks" ncpost -c $c -m three-axis whole.cl
	hasnt "nothing is said" 'NO SPEED|NO TOOL' out
	status 3 "$c: the spindle was stopped" ncpost -c $c -m three-axis stopped.cl
done

# ---- refused, or told
refused() { # DESC REGEX LINES...
	desc=$1 regex=$2
	shift 2
	path LOADTL/1 "$@" >r.cl
	status 1 "$desc" ncpost -c fanuc r.cl
	has "... says what" "$regex" err
	[ "$(wc -l <err)" -eq 1 ]
	result $? "... in one line"
	empty "... and nothing is written" out
}
refused "a speed that is a word" 'found .FAST. in SPINDL' SPINDL/RPM,fast
refused "a negative wait" 'expected DELAY/ and seconds' SPINDL/900 DELAY/-1
refused "a speed below one" 'found a speed of 0\.398 rev/min' SPINDL/RPM,0.398
refused "a negative speed" 'found a speed of -500' SPINDL/-500
refused "GOTO without its slash" 'may move the tool' 'GOTO 5,5,5'
refused "GOTO misspelt" 'may move the tool' 'GOT0/5,5,5'
refused "an unknown word with a place" 'may move the tool' 'SLIDE/5,5,5'
path LOADTL/MILL SPINDL/900 >named.cl
status 0 "a tool by its name" ncpost -c fanuc named.cl
has "is told and numbered" 'numbered the 1 tools without a number' err
has "... as tool 1" ' T1 M6' out
status 0 "by its name where the control calls so" ncpost -c siemens --set tool.names=yes named.cl
has "Siemens" 'T="MILL" D1 M6' out
status 0 "Heidenhain" ncpost -c heidenhain --set tool.names=yes named.cl
has "in quotes" 'TOOL CALL "MILL" Z S900' out

# ---- INSERT, TPRINT, COOLNT, OPSKIP, AUXFUN
path LOADTL/1 SPINDL/900 'TPRINT/ball nose 10' 'INSERT M88' COOLNT/OFF |
	sed 's/^GOTO\/9,0,0/INSERT M10\n&/' >said.cl
status 0 "INSERT and TPRINT" ncpost -c fanuc said.cl
has "INSERT is a block as it stands" '^N[0-9]+ M88$' out
awk '/ M10$/ { getline; exit !/ G1 X9\. Y0\. Z0\./ }' out
result $? "and what is modal is said again after it"
has "TPRINT is a comment" '^\(BALL NOSE 10\)$' out
status 0 "--insert comment" ncpost -c fanuc --insert comment said.cl
has "INSERT is a comment" '^\(M88\)$' out
hasnt "and no block" '^N[0-9]+ M88$' out
status 1 "--insert refuse" ncpost -c fanuc --insert refuse said.cl
has "names the line" 'said\.cl:5: found .INSERT M88., expected no INSERT' err
path LOADTL/1 SPINDL/900 COOLNT/THRU >thru.cl
status 3 "coolant through the tool, for which there is no word" ncpost -c fanuc thru.cl
has "said in the program" 'COOLNT/THRU: THE MACHINE FILE HAS NO WORD' out
hasnt "no M8 instead" ' M8$' out
status 0 "coolant.thru" ncpost -c fanuc --set coolant.thru=M88 thru.cl
has "the machine's word" ' M88$' out
path LOADTL/1 SPINDL/900 AUXFUN/7 OPSTOP | sed 's/^GOTO\/9,0,0/OPSKIP\/ON\n&\nOPSKIP\/OFF/' >aux.cl
status 0 "tables of M codes" ncpost -c fanuc --set 'aux.7=M107|G4 X1.' --set stop.optional=M101 \
	--set spindle.cw=M103 --set spindle.off=M105 --set coolant.off=M109 aux.cl
has "aux.7" '^N[0-9]+ M107$' out
has "stop.optional" '^N[0-9]+ M101$' out
has "spindle.cw" 'S900 M103$' out
has "spindle.off" '^N[0-9]+ M105$' out
has "coolant.off" '^N[0-9]+ M109$' out
has "OPSKIP marks its blocks" '^/N[0-9]+ .*X9\.' out
[ "$(grep -c '^/' out)" -eq 1 ]
result $? "and no others"
status 0 "block.skip = no" ncpost -c fanuc --set block.skip=no aux.cl
hasnt "marks none" '^/' out

# ---- several tools: the next one selected, an optional stop, work offsets by operation
path LOADTL/1 SPINDL/900 | sed 's/^FINI//' >two.cl
path LOADTL/2 SPINDL/800 | sed 1d >>two.cl
status 0 "two tools" ncpost -c fanuc --set tool.next=yes --set tool.stop=yes \
	--set offset.2=G55 two.cl
has "the next tool is selected" '^N[0-9]+ T2$' out
has "an optional stop" '^N[0-9]+ M1$' out
has "the second tool's offset" '^N[0-9]+ G55$' out
has "the first one's" 'G94 G54$' out
status 0 "G54.1 P from the first" ncpost -c fanuc --set 'offset.1=G54.1 P3' two.cl
has "is said in the head" 'G94 G54\.1 P3$' out
status 0 "Siemens" ncpost -c siemens --set offset.2=G505 two.cl
has "G505" '^N[0-9]+ G505$' out

# ---- a path that is led out at feed, over its clearance plane, is out: along an axis that leads
# down the tool would come back beside the part; a cut as high is none of that
printf '%s\n' UNITS/MM MULTAX/ON CUTTER/10,5 LOADTL/1 SPINDL/900 '$$-> CLEAR/40' RAPID \
	'GOTO/100,0,0,0.94,0,-0.3412' FEDRAT/MMPM,500 'GOTO/50,0,0,0.94,0,-0.3412' \
	'GOTO/-80,20,0,0.94,0,-0.3412' 'GOTO/-80,20,40,0.94,0,-0.3412' FINI >led.cl
status 0 "led out at feed" ncpost -c fanuc -m table-ac -o led.nc led.cl
hasnt "no retract is added" 'added a retract' err
awk '{ for (i = 1; i <= NF; i++) if ($i ~ /^Z/ && !/G28/) z = substr($i, 2) }
	END { exit z + 0 != 40 }' led.nc
result $? "the last height is that of the path"
sed 's|^GOTO/-80,20,40|$$-> CONTCT/-85,20,40,1,0,0\n&|' led.cl >cut.cl
status 0 "a cut as high" ncpost -c fanuc -m table-ac -o led.nc cut.cl
has "is left by a retract" 'added a retract' err

done_testing

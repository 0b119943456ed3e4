#!/bin/sh
# ncpost-cycles.t - drilling cycles: as the control's own where the tool stands still, written out
# where it turns; the holes that come of them, read back by rule and by LinuxCNC's interpreter.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# Six kinds of holes at three heights, with places, depths and clearances all different
holes() { # AWK-FUNCTION: place(x, y, z) prints a GOTO
	awk "$1"'
	BEGIN {
		print "PARTNO/HOLES\nUNITS/MM\nMULTAX/ON\nCUTTER/8\nLOADTL/5\nSPINDL/RPM,1000,CLW\nRAPID"
		place(-7, -3, 100)
		print "CYCLE/DRILL,DEPTH,10,CLEAR,2,RTRCTO,20,MMPM,150"
		place(0, 1, 0); place(10, 2, 0); place(20, 3, 5); print "CYCLE/OFF"
		print "CYCLE/FACE,FEDTO,3,RAPTO,1.5,MMPM,90,DWELL,0.25"
		place(21, 8, 5); place(22, 9, 5)
		print "CYCLE/DEEP,DEPTH,31,STEP,5,CLEAR,2,MMPM,120"
		place(20, 10, 0); place(30, 11, 0)
		print "CYCLE/BRKCHP,DEPTH,13,STEP,6,CLEAR,2,MMPM,120"
		place(40, 12, -4); print "CYCLE/OFF"
		print "CYCLE/TAP,DEPTH,12,PITCH,1.25,CLEAR,4"
		place(40, 20, 0); place(41, 27, 0)
		print "CYCLE/BORE,DEPTH,14,CLEAR,3,MMPM,80,DWELL,1,RTRCTO,9"
		place(50, 20, 0); print "CYCLE/BORE,DRAG,DEPTH,15,CLEAR,4,MMPM,80"; place(60, 22, 0)
		print "CYCLE/OFF\nRAPID"; place(60, 22, 100); print "FINI"
	}' </dev/null
}
upright='function place(x, y, z) { printf "GOTO/%.6f,%.6f,%.6f,0,0,1\n", x, y, z }'
# about X by 20 degrees and then about the turned Y by 30: the control turns its plane back
tilted='function place(u, v, w,  r, x, y, z, ca, sa, cb, sb) {
		r = atan2(1, 1) / 45; ca = cos(20 * r); sa = sin(20 * r); cb = cos(30 * r); sb = sin(30 * r)
		x = cb * u + sb * w; z = -sb * u + cb * w; y = ca * v - sa * z; z = sa * v + ca * z
		printf "GOTO/%.9f,%.9f,%.9f,%.9f,%.9f,%.9f\n", x, y, z, sb, -sa * cb, ca * cb
	}'
# about X by 20 degrees and then about Y as it was by 30: the same for PLANE SPATIAL
spatial='function place(u, v, w,  r, x, y, z, ca, sa, cb, sb) {
		r = atan2(1, 1) / 45; ca = cos(20 * r); sa = sin(20 * r); cb = cos(30 * r); sb = sin(30 * r)
		y = ca * v - sa * w; z = sa * v + ca * w; x = cb * u + sb * z; z = -sb * u + cb * z
		printf "GOTO/%.9f,%.9f,%.9f,%.9f,%.9f,%.9f\n", x, y, z, sb * ca, -sa, cb * ca
	}'
# the last hole leans: another plane
leaning='function place(x, y, z) {
		printf "GOTO/%.6f,%.6f,%.6f,%s\n", x, y, z, x == 60 ? "0,0.6,0.8" : "0,0,1" }'
holes "$upright" >holes.cl
holes "$tilted" >axes.cl
holes "$spatial" >spatial.cl
holes "$leaning" >leaning.cl
# and here the tool turns while it cuts
awk '{ print } /^CYCLE.OFF/ && !done { print "FEDRAT/MMPM,300\nGOTO/20,3,30,0,0.2,0.979795897"; done = 1 }' \
	leaning.cl >turning.cl

for control in fanuc siemens heidenhain; do
	for machine in table-ac head-ca table-bc-notcp; do
		status 0 "$control, $machine" ncpost -c $control -m $machine holes.cl
		cp out $control.nc
		axes=
		[ $machine = table-bc-notcp ] && axes="--axes bc --no-tcp"
		# shellcheck disable=SC2086
		ok "its holes are those of the path" "$READBACK" -c $control --no-steps --path holes.cl \
			$axes -e 0.0005 $control.nc
	done
	ncpost -q -c $control --inch holes.cl >inch.nc
	ok "$control: in inches" "$READBACK" -c $control --no-steps --path holes.cl -e 0.003 inch.nc
	ncpost -q -c $control --set cycles=no holes.cl >written.nc
	hasnt "$control: cycles = no" 'G8[1-9]|CYCLE8[1-9]|CYCL DEF 20' written.nc
	ok "written out, steps and all" "$READBACK" -c $control --path holes.cl -e 0.0062 written.nc
	cp axes.cl tilted.cl
	[ $control = heidenhain ] && cp spatial.cl tilted.cl
	ncpost -q -c $control --set digits.angle=6 tilted.cl >turned.nc
	ncpost -q -c $control turning.cl >turning.nc
	hasnt "$control: where the tool turns they are written out" 'G8[1-9]|CYCLE8[1-9]|CYCL DEF 20' turning.nc
	ok "and are the path's" "$READBACK" -c $control --path turning.cl -e 0.0062 --axis 0.052 turning.nc
	ncpost -q -c $control leaning.cl >leaning.nc
	ok "$control: in two planes" "$READBACK" -c $control --no-steps --path leaning.cl -e 0.001 \
		--axis 0.001 leaning.nc
	has "the cycle goes on in the second" 'G86|CYCLE86|CYCL DEF 202' leaning.nc
	ok "$control: in the tilted plane" "$READBACK" -c $control --no-steps --path tilted.cl -e 0.001 \
		--axis 0.001 turned.nc
	# 3+2: in the tilted plane the program is that of the upright path
	ncpost -q -c $control -m three-axis holes.cl >flat.nc
	for file in flat turned; do
		grep -E ' [XYZRQ][-+]?[0-9]|Q20|G8|CYCLE8|CYCL' $file.nc |
			grep -Ev 'G28|G68|M91|SUPA|G90|CYCLE800|G53|L A' | sed 's/^N*[0-9]* //' |
			awk '/^(G0|L) X[^Z]*$/ { across = $0; next } across { print across; across = "" } 1' >$file
	done
	same "$control: 3+2 is the same program in its plane" flat turned
	has "turned there" 'G68\.2|CYCLE800\(0,|PLANE SPATIAL' turned.nc
done
ncpost -q -c fanuc leaning.cl >leaning.nc
ends=$(grep -n 'A0\. C0\.' leaning.nc | tail -n 1 | cut -d: -f1)
below "the rotary axes stand at zero at the end" "$(grep -n 'G69' leaning.nc | tail -n 1 | cut -d: -f1)" "$ends"
rm -f lean-*
status 0 "planes in parts" ncpost -q -c fanuc --split 75 -o lean.nc leaning.cl
for part in lean-*.nc; do
	"$READBACK" -c fanuc "$part" 2>&1 | grep '\.nc:'
done >parts
empty "each a program" parts
has "Fanuc: G98 to the retract plane" ' G98 G81 X0\. Y1\. Z-10\. R2\. F150\.$' fanuc.nc
has "Fanuc: the next hole is its place alone" '^N[0-9]+ X10\. Y2\.$' fanuc.nc
has "Fanuc: dwell in milliseconds" ' G99 G82 .*P250 F90\.$' fanuc.nc
has "Fanuc: steps" ' G83 .* Z-31\. R2\. Q5\. ' fanuc.nc
has "Fanuc: tap at pitch times speed" ' G84 .*F1250\.$' fanuc.nc
has "Fanuc: bored with a dwell" ' G98 G89 .*P1000 ' fanuc.nc
has "Siemens: retract, mouth, distance, bottom" ' MCALL CYCLE81\(20,0,2,-10\)$' siemens.nc
has "Siemens: dwell" ' MCALL CYCLE82\(6\.5,5,1\.5,2,,0\.25\)$' siemens.nc
has "Siemens: steps" ' MCALL CYCLE83\(2,0,2,-31,,,5,0,0,0,1,1,' siemens.nc
has "Siemens: pitch and speed" ' MCALL CYCLE84\(4,0,4,-12,,,3,,1\.25,0,1000,1000\)$' siemens.nc
has "Siemens: the cycle ends" '^N[0-9]+ MCALL$' siemens.nc
has "Heidenhain: pecking" 'CYCL DEF 205 UNIVERSAL PECKING ~$' heidenhain.nc
has "Heidenhain: pitch" 'Q239=\+1\.25 ;' heidenhain.nc
has "Heidenhain: called at each place" 'L X\+10 Y\+2 R0 FMAX M99$' heidenhain.nc

# ---- LinuxCNC's own interpreter
# each hole's place and depth, and where the tool leaves it
bottoms() { # CANON
	awk -F'[(,)]' '/STRAIGHT_FEED/ { low = ($4 < low || low == "") ? $4 : low; x = $2; y = $3 }
		/STRAIGHT_TRAVERSE/ && low != "" && ($2 != x || $3 != y) {
			printf "%.3f %.3f %.3f %.3f\n", x, y, low, z; low = "" }
		{ if (/STRAIGHT/) z = $4 }' "$1"
}
for machine in table-ac linuxcnc-xyzac three-axis; do
	ncpost -q -c linuxcnc -m $machine holes.cl >holes.ngc
	has "LinuxCNC, $machine: dwell in seconds" ' G82 .*P0\.25 ' holes.ngc
	if command -v rs274 >/dev/null; then
		ok "rs274 takes it" canon holes.ngc
		canon holes.ngc >holes.canon
		bottoms holes.canon >found
		cat >expected <<-'END'
			0.000 1.000 -10.000 20.000
			10.000 2.000 -10.000 25.000
			20.000 3.000 -5.000 25.000
			21.000 8.000 2.000 6.500
			22.000 9.000 2.000 6.500
			20.000 10.000 -31.000 2.000
			30.000 11.000 -31.000 2.000
			40.000 12.000 -17.000 4.000
			40.000 20.000 -12.000 4.000
			41.000 27.000 -12.000 9.000
			50.000 20.000 -14.000 9.000
		END
		sort found >a && head -n 11 expected | sort >b
		same "holes, depths, and where the tool leaves" b a
	else
		skip "rs274 takes it" "no rs274"
		skip "holes, depths, and where the tool leaves" "no rs274"
	fi
done
ncpost -q -c linuxcnc --inch holes.cl >inch.ngc
has "inches" ' G98 G81 X0\. Y0\.03937 Z-0\.3937 R0\.07874 F5\.9055$' inch.ngc
ncpost -q -c fanuc --set 'tap=M29 S{rpm}' holes.cl >tap.nc
has "rigid tapping by a key" ' M29 S1000$' tap.nc
sed 's/^SPINDL.*/SPINDL\/RPM,1000,CCLW/' holes.cl >left.cl
ncpost -q -c fanuc left.cl >left.nc
has "left-hand taps" ' G74 ' left.nc
ncpost -q -c siemens left.cl >left.mpf
has "Siemens: a left-hand pitch" 'CYCLE84\(4,0,4,-12,,,4,,-1\.25,' left.mpf

# ---- parts, each with its cycle said anew
rm -f part-*
status 0 "in parts" ncpost -q -c fanuc --split 70 -o part.nc holes.cl
for part in part-*.nc; do
	"$READBACK" -c fanuc "$part" 2>&1
done >parts
hasnt "each is a program" 'part-.*:' parts
cat part-*.nc | grep -Ec 'X(0|10|20|21|22|30|40|41|50|60)\. Y[0-9.]+( Z.*)?$' >count
cat part-*.nc >all.nc
for place in 'X10\. Y2\.' 'X22\. Y9\.' 'X30\. Y11\.' 'X41\. Y27\.' 'X60\. Y22\. Z'; do
	has "the hole at $place is drilled" "$place" all.nc
done

# ---- what is said and refused
sed 's/STEP,5/STEP,5,SUBPECK,2/' holes.cl >uneven.cl
status 0 "steps of two sizes" ncpost -c fanuc uneven.cl
has "the smaller one is taken" ' Q2\. ' out
has "and that is said" 'smaller step' err
ncpost -c siemens uneven.cl >uneven.mpf 2>err
has "Siemens knows both" 'CYCLE83\(2,0,2,-31,,,5,3,0,0,1,1,,2,' uneven.mpf
bad() { # CYCLE REGEX
	printf 'UNITS/MM\nGOTO/0,0,9\n%s\nGOTO/0,0,0\nFINI\n' "$1" >bad.cl
	status 1 "$1" ncpost -q -c fanuc bad.cl
	has "told" "$2" err
}
bad 'CYCLE/BORE,BACK,DEPTH,5,MMPM,50' 'from above'
bad 'CYCLE/DRILL,CLEAR,2,7' 'found 7 in CYCLE without a word'
bad 'CYCLE/DRILL,DEPTH,3,CLEAR,-3' 'more than -3'
bad 'CYCLE/DRILL,DEPTH,3,DWELL,REV,5' 'below 0'
printf 'UNITS/MM\nSPINDL/600,RPM\nGOTO/0,0,9\nCYCLE/DRILL,3,IPM,10,2\nGOTO/0,0,0\nFINI\n' >bare.cl
ncpost -q -u mm -c fanuc bare.cl >bare.nc
has "numbers without names: depth, feed, clearance" 'Z-3\. R2\. F254\.$' bare.nc
printf 'UNITS/MM\nSPINDL/600,RPM\nGOTO/0,0,9\nCYCLE/DRILL,DEPTH,3,DWELL,REV,5,MMPM,9\nGOTO/0,0,0\nFINI\n' >turns.cl
ncpost -q -c fanuc turns.cl >turns.nc
has "a dwell by turns" ' P500 ' turns.nc
printf 'UNITS/MM\nSPINDL/600,RPM\nGOTO/0,0,9\nCYCLE/TAP,DEPTH,3,TPI,20\nGOTO/0,0,0\nFINI\n' >tpi.cl
ncpost -q -c heidenhain tpi.cl >tpi.h
has "threads an inch" 'Q239=\+1\.27 ' tpi.h

done_testing

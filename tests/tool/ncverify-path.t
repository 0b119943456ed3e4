#!/bin/sh
# ncverify-path.t - a program against the path that it was made from, and what must not change amid
# it: good programs of lines, arcs and splines are accepted on every control, each kind of fault is
# found and named by its block.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (y = -8; y <= 8.001; y += 0.5) for (x = -12; x <= 12.001; x += 0.5)
	printf "%.5f %.5f %.5f\n", x, y, 20 - (x * x + y * y) / 80 }' >dome.xyz
cloud2mesh -q -t 2 dome.xyz -o dome.ply
meshnorm -q -r 6 --tilt 12 --rows mesh --no-guard --ball-only dome.ply >line.cl
biarcfit -q -e 0.01 --no-guard line.cl >arc.cl
bsplfit -q -e 0.01 --no-guard line.cl >curve.cl
bsplfit -q -e 0.01 --no-guard --track centre line.cl >centre.cl

judge() { # PROGRAM PATH: status in $got, findings in err
	run ncverify -g dome.xyz -r 6 --partial --ball-only -m "$machine" -c "$control" -p "$2" "$1"
}

for control in fanuc siemens heidenhain linuxcnc; do
	machine='table-ac'
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	for kind in line arc curve centre; do # whose program says that its places are the ball's
		ncpost -q -c $control -m $machine $kind.cl >$kind.$control
		judge $kind.$control $kind.cl
		result "$got" "$control: $kind: the good program is accepted"
	done
	judge arc.$control line.cl
	grep -q 'off the path' err || result 0 "$control: arcs are within the fitter's tolerance of the lines"
done

# edit OP K [WORD VALUE]: the K-th block of line.$control that goes straight at feed, changed; of a
# WORD the first from there on that has it, and not as 0; a G1 or F that stands in it alone is kept.
# N is its number.
edit() {
	awk -v op="$1" -v k="$2" -v word="$3" -v value="$4" -v control=$control '
	function digits(v,   s) { s = sprintf("%.4f", v); return control == "heidenhain" && v >= 0 ? "+" s : s }
	/ G1 | F[0-9]/ { feed = 1 } / G0 |FMAX/ { feed = 0 }
	/ [XYZ][-+0-9.]/ && feed && !/M91|G53|SUPA/ { n++; mine = n == k } !/ [XYZ]/ || !feed { mine = 0 }
	op == "add" || op == "turn" { mine = 0
		if (feed && n >= k && !did) for (i = 2; i <= NF; i++)
			if (index($i, word) == 1 && substr($i, length(word) + 1) + 0 != 0) mine = did = 1 }
	!mine { print; next }
	{ print $1 >"named" }
	op == "rapid" { if (control == "heidenhain") { sub(/ F[0-9.]+/, ""); $0 = $0 " FMAX" } else {
		sub(/ G1/, ""); sub(/ F[0-9.]+/, ""); sub(/^N[0-9]+/, "& G0") } print; next }
	op == "before" { if (control == "heidenhain") print "0 " word; else
		print "N" (substr($1, 2) - 1) " " word; print; next }
	{ hit = 0; for (i = 2; i <= NF; i++) if (substr($i, 1, length(word)) == word && $i ~ /[0-9]/) {
		old = substr($i, length(word) + 1); hit = 1
		$i = word digits(op == "add" ? old + value : op == "turn" ? -old : value) }
	  print }' line.$control >bad.$control
	N=$(cat named)
	[ $control != heidenhain ] || { awk '{ $1 = NR - 1; print }' bad.$control >again && mv again bad.$control; }
}

# found KIND PATTERN: the fault is in, refused or not run, and named
found() {
	if cmp -s bad.$control line.$control; then result 1 "$control: $1 (the fault is not in)"; return; fi
	judge bad.$control line.cl
	case $got in 1 | 3) result 0 "$control: $1: found" ;; *) result 1 "$control: $1: found (exit $got)" ;; esac
	has "$control: $1: named" "$2" err
	if [ "$got" -eq 0 ]; then table="$table -"; else table="$table +"; fi
}

for control in fanuc siemens heidenhain linuxcnc; do
	machine='table-ac'
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	table=
	axis=A
	[ $control = siemens ] && axis=B3= # A3 is 0 all along
	edit rapid 45; found "G0 in place of G1" "$N .*a rapid move ends on the part"
	edit add 45 Z -0.03; found "a place 0.03 off" "N?[0-9]+ .*the tip is 0\.0[23][0-9]* mm off the path"
	if [ $control = siemens ]; then edit add 45 $axis 0.02; else edit add 45 $axis 5; fi
	found "the axis off" "N?[0-9]+ .*(the tool axis is [0-9.]+ degrees off|off the path)|N[0-9]+: a tool vector wants"
	edit turn 45 $axis; found "the sign of one word" "N?[0-9]+.*(the tool axis is [0-9.]+ degrees off|off the path)"
	case $control in
	heidenhain)
		edit before 45 M9; found "the coolant off" ': N?[0-9]+ .*the coolant goes off'
		edit before 45 "TOOL CALL 2 Z S8000"; found "another tool" ': N?[0-9]+ .*the tool changes from 1 to 2' ;;
	*)
		edit before 45 M9; found "the coolant off" ': N[0-9]+ .*the coolant goes off'
		edit before 45 T2; found "another tool" ': N[0-9]+ .*the tool changes from 1 to 2'
		edit before 45 G55; found "another work offset" ': N[0-9]+ .*the work offset changes from 54 to 55'
		sed 's/ G54//;s/^\(N[0-9]*\) *G54$/\1/' line.$control >bad.$control
		found "no work offset" ': N[0-9]+ .*cuts without a work offset' ;;
	esac
	[ $control = siemens ] && { edit before 45 D0; found "the edge off" ': N[0-9]+ .*offset D changes from 1 to 0'; }
	[ $control = fanuc ] && { edit before 45 H2; found "another length" ': N[0-9]+ .*offset H changes from 1 to 2'; }
	if [ $control != linuxcnc ]; then
		sed 's/ F800\(\.*\)/ F8000\1/' line.$control >bad.$control; found "ten times the feed" 'N?[0-9]+ .*the feed is 10 times the path'
		sed 's/ F800\(\.*\)/ F0.8/' line.$control >bad.$control; found "a thousandth of the feed" 'N?[0-9]+ .*the feed is 1/1000 of the path'
	fi
	sed 's/S8000/S80/' line.$control >bad.$control; found "another speed" "N?[0-9]+ .*turns at 8000, the program's at 80"
	sed 's/ *S8000//' line.$control >bad.$control; found "no speed" 'N?[0-9]+ .*the program says no speed'
	sed 's/ M3$/ M4/' line.$control >bad.$control; found "the spindle the other way" 'N?[0-9]+ .*the program the other way'
	sed 's/ T1 / T2 /;s/CALL 1/CALL 2/' line.$control >bad.$control; found "tool 2 all along" 'N?[0-9]+ .*takes tool 2'
	sed 's/H1$/H2/;s/H1 Z/H2 Z/' line.$control >bad.$control
	case $control in fanuc | linuxcnc) found "the length of tool 2 all along" 'N[0-9]+ .*for the length H1, .* on H2' ;; esac
	if [ $control = heidenhain ]; then edit before 45 M136; else edit before 45 G95; fi
	found "a feed per revolution" '[0-9]+: N[0-9]+: found (G95|M136), a feed per revolution'
	echo "# $control:$table"
done
sed 's/ORIWKS/ORIMKS/' line.siemens >bad.siemens
control=siemens machine=table-ac
found "ORIMKS" 'bad.siemens:[0-9]+: N[0-9]+: ORIMKS'

sed 's/ UPATH//' curve.siemens >bad.siemens
if grep -q 'PO\[' curve.siemens; then found "UPATH lost" 'bad.siemens:[0-9]+: N[0-9]+: a curve under ORICURVE without UPATH'; fi
sed 's/\(TOOL CALL.*\)/\1 DL+0.5/' line.heidenhain >bad.heidenhain
control=heidenhain
found "a tool longer than its table says" 'bad.heidenhain:[0-9]+: N[0-9]+: TOOL CALL with DL or DR'
sed 's/\(TOOL CALL [0-9]*\) Z/\1 Y/' line.heidenhain >bad.heidenhain
found "a tool along another axis" 'N[0-9]+: found a tool along another axis, expected TOOL CALL Z'
for m in M92 M143; do
	edit before 45 $m
	found "$m" "N[0-9]+: found $m, "
done
ncpost -q -c haas -m table-ac -o line.haas line.cl
for control in fanuc haas; do
	edit before 45 'G43 H1'
	found "G43 ends G43.4 and G234" 'cuts without tool centre point control'
done
control=siemens

# The first way over X and Y is gone, and the numbers do not tell it: from where the tool is at home it
# would come across a hill.
awk 'BEGIN { for (y = -8; y <= 8.001; y += 0.5) for (x = -8; x <= 8.001; x += 0.5)
	printf "%.5f %.5f %.5f\n", x, y, 20 - (x * x + y * y) / 12 }' >hill.xyz
cloud2mesh -q -t 2 hill.xyz -o hill.ply
meshnorm -q -r 6 --scallop 0.2 --avoid hill.ply >hill.cl
for control in fanuc siemens heidenhain linuxcnc; do
	machine='table-ac'
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	ncpost -q -c $control -m $machine hill.cl >hill.$control
	awk -v h="$([ $control = heidenhain ] && echo 1)" '
		!did && / X[-+0-9.]+ Y[-+0-9.]+( R0 FMAX)? *$/ { did = 1; next }
		h && /^[0-9]+ / { sub(/^[0-9]+/, n + 0); n++ }
		!h && /^N[0-9]+/ { n += 10; sub(/^N[0-9]+/, "N" n) } { print }' hill.$control >bad.$control
	status 0 "$control: over a hill" ncverify -g hill.xyz hill.$control
	status 3 "$control: without its first way over" ncverify -g hill.xyz bad.$control
	has "$control: ... named" '^fault +N[0-9]+ .*a rapid move comes from a place that is not known' out
	# and its last way up, which leaves the lift at feed
	awk -v h="$([ $control = heidenhain ] && echo 1)" '
		/ (X|Y)[-+0-9.]/ && (/ FMAX/ || / G0 /) && !/M91|G53|G28|SUPA/ { last = NR } { line[NR] = $0 }
		END { for (i = 1; i <= NR; i++) { $0 = line[i]
			if (i >= last && / [XYZ][-+0-9.]/ && !/M91|G53|G28|SUPA/) continue
			if (h && /^[0-9]+ /) { sub(/^[0-9]+/, n + 0); n++ }
			if (!h && /^N[0-9]+/) { n += 10; sub(/^N[0-9]+/, "N" n) }
			print } }' hill.$control >bad.$control
	status 3 "$control: without its last way up" ncverify -g hill.xyz bad.$control
	has "$control: ... named" '^fault +N[0-9]+ .*the program ends [0-9.]+ mm below the part.s top: a retract is missing' out
done
control=siemens machine=table-ac

# a polynomial whose coefficients are 1 % too large
awk '/POLY|PO\[/ { while (match($0, /,-?[0-9.]+[,)]/)) { v = substr($0, RSTART + 1, RLENGTH - 2)
	line = line substr($0, 1, RSTART) sprintf("%.6f", v * 1.01); $0 = substr($0, RSTART + RLENGTH - 1) }
	print line $0; line = ""; next } { print }' curve.siemens >bad.siemens
if grep -q 'PO\[' curve.siemens; then
	judge bad.siemens curve.cl
	case $got in 1 | 3) result 0 "siemens: coefficients 1 % off: found" ;; *) result 1 "siemens: coefficients 1 % off: found (exit $got)" ;; esac
fi

# an axis asked for more than it can: the control slows down, or it is a fault
control=fanuc
sed 's/ F800\./ F60000./' line.fanuc >bad.fanuc
status 0 "a control that slows down" ncverify -g dome.xyz -r 6 --partial --ball-only -m table-ac -c fanuc bad.fanuc
has "is told" '^notice +N[0-9]+ .*axis . would have to move at [0-9.]+ of its largest speed' out
status 3 "one that does not" ncverify -g dome.xyz -r 6 --partial --ball-only -m table-ac --set slows=no -c fanuc bad.fanuc
has "is refused" '^fault +N[0-9]+ .*axis . would have to move at [0-9.]+ of its largest speed' out
status 0 "the good program needs no slowing" ncverify -g dome.xyz -r 6 --partial --ball-only -m table-ac --set slows=no -c fanuc line.fanuc

# the tip turns about the ball's centre, which stands: F counts degrees there in inches, too
{
	printf 'UNITS/MM\nMULTAX/ON\nCUTTER/12,6,0,6\nLOADTL/1\nSPINDL/8000,CLW\n$$-> CLOUDMILL/1\n$$-> TRACK/CENTER\n'
	printf 'RAPID\nGOTO/0,0,50,0,0,1\nFEDRAT/MMPM,400\nGOTO/0,0,26.1,0,0,1\nFEDRAT/MMPM,800\nGOTO/5,0,25.85,0,0,1\n'
	awk 'BEGIN { for (i = 1; i <= 6; i++) printf "GOTO/5,0,25.85,%.9f,0,%.9f\n", sin(i / 20), cos(i / 20) }'
	printf 'GOTO/8,0,25.45,%s\nRAPID\nGOTO/24,0,74,%s\nFINI\n' 0.295520207,0,0.955336489 0.295520207,0,0.955336489
} >stands.cl
for control in fanuc siemens heidenhain linuxcnc haas okuma mazak fagor hurco heidenhain-530; do
	machine="table-ac"
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	for unit in "" --inch; do
		# shellcheck disable=SC2086
		ncpost -q -c $control -m $machine $unit stands.cl -o stands.nc
		judge stands.nc stands.cl
		sed -n "s/^fault/$control $unit: &/p" out
		sed -n 's/^least time *\([0-9.]*\) min.*/\1/p' out >>stood
	done
done >stands
empty "a turn about the ball's centre has the path's feed, in mm and inches" stands
empty "and its time" "$(sort -u stood | awk '$1 < 0.09 || $1 > 0.1 { print }' >odd; echo odd)"

# a pass left out
awk '/\(PASS 3\)/ { skip = 1 } /\(PASS 4\)/ { skip = 0 } !skip' line.fanuc >bad.fanuc
control=fanuc
found "a pass left out" 'leaves out line [0-9]+ of the path'
status 1 "a path that is none" ncverify -g dome.xyz -r 6 -p dome.xyz line.fanuc

done_testing

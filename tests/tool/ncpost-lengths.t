#!/bin/sh
# ncpost-lengths.t - heads without tool-centre-point control: each tool with its own length, told in
# the head; angles and travel by the printed digits; rotary words as the control wants them.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# Two tools at one place, leaning by B 30: the linear axes by hand.  A pivot 150 above the nose, the
# tip at P: X = Px + (150 + L) sin 30, Z = Pz + (150 + L)(cos 30 - 1), with L above the nose.
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON"
	for (t = 1; t <= 2; t++) {
		print "LOADTL/" t "\n$$-> PASS/" t "\nSPINDL/900\nRAPID\nGOTO/10,0,90,0.5,0,0.866025403784\nFEDRAT/MMPM,300"
		print "GOTO/10,0,20,0.5,0,0.866025403784\nRAPID\nGOTO/10,0,90,0.5,0,0.866025403784"
	}
	print "FINI" }' >two.cl
head="-m head-table-bc-notcp --set c.min=-5 --set c.max=5"
wanted() { # LENGTH: the block at the part
	awk -v l="$1" 'BEGIN { r = 150 + l; printf "X%.3f Z%.3f\n", 10 + r * 0.5, 20 + r * (sqrt(3) / 2 - 1) }'
}
at_part() { # PROGRAM: X Z at feed, one line a tool
	awk '{ for (i = 1; i <= NF; i++) if ($i ~ /^[XZ]-?[0-9]/) v[substr($i, 1, 1)] = substr($i, 2) }
		/ G1 / { printf "X%.3f Z%.3f\n", v["X"], v["Z"] }' "$1"
}
# shellcheck disable=SC2086
{
	status 0 "lengths of two tools" ncpost -c fanuc $head --set 'centre.B=0 0 150' \
		--set tool.1.length=100 --set tool.2.length=150.5 two.cl
	at_part out >got
	{ wanted 100; wanted 150.5; } >want
	same "each tool has its own way" want got
	has "the head says that X Y Z are no tip" 'X Y Z ARE THE LINEAR AXES, NOT THE TIP' out
	has "the centres" 'ASSUMED: CENTRE B 0 0 150 FROM THE SPINDLE.S NOSE' out
	has "the lengths" 'ASSUMED: LENGTH OF TOOL 2 150\.5' out
	ncpost -q -c fanuc $head --set 'centre.B=0 0 150' --inch --set tool.1.length=100 \
		--set tool.2.length=150.5 --set digits.linear=6 two.cl >inch.nc
	at_part inch.nc | awk '{ gsub(/[XZ]/, ""); printf "%.1f %.1f\n", $1 * 25.4, $2 * 25.4 }' >got
	sed 's/[XZ]//g' want | awk '{ printf "%.1f %.1f\n", $1, $2 }' >mm
	awk 'NR == FNR { a[NR] = $1; b[NR] = $2; next }
		{ d = $1 - a[FNR]; e = $2 - b[FNR]; if (d * d > 0.01 || e * e > 0.01) exit 1 }' mm got
	result $? "the same in inches"
	printf 'T1 P1 Z100 D10 ;ball\nT2 P2 Z+150.5 D8\n' >tool.tbl
	printf 'include = head-table-bc-notcp\ncentre.B = 0 0 150\nc.min = -5\nc.max = 5\ntools = tool.tbl\n' >m.txt
	status 0 "a table of tools, as LinuxCNC has it" ncpost -c fanuc -m ./m.txt two.cl
	at_part out >got
	same "is the same" want got
	printf '# number length name\n1 100 BALL\n2 150.5\n' >tool.tbl
	ncpost -q -c fanuc -m ./m.txt two.cl >out
	at_part out >got
	same "a plain table too" want got
	status 1 "a tool without a length" ncpost -c fanuc $head --set tool.1.length=100 two.cl
	has "is named" 'no length of tool 2 in the machine file' err
	status 0 "without lengths" ncpost -c fanuc $head two.cl
	has "one centre for all tools is told" 'CENTRE B 0 0 250 FROM THE TIP OF EVERY TOOL' out
	ncpost -q -c fanuc $head --set 'centre.B=0 0 150' --set tool.1.length=100 \
		--set tool.2.length=150.5 --from 2 -o part.nc two.cl
	at_part part.nc >got
	wanted 150.5 >want2
	same "a restart has its tool's length" want2 got
}

# ---- the travel by printed digits
axis() { awk -v a="$1" 'BEGIN { a *= atan2(0, -1) / 180; printf "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/900\nRAPID\nGOTO/0,0,50,0,0,1\nFEDRAT/100\nGOTO/0,0,0,0,%.12f,%.12f\nFINI\n", -sin(a), cos(a) }'; }
axis 119.99996 >in.cl
axis 120.00004 >edge.cl
axis 120.002 >out.cl
for c in fanuc heidenhain; do
	turn="--set a.min=0 --set c.min=-10 --set c.max=10 --rotary"
	# shellcheck disable=SC2086
	for file in in edge; do
		status 0 "$c: $file of the travel" ncpost -c $c $turn --set digits.angle=3 $file.cl
		has "is 120" ' A\+?120\.? ' out
	done
	# shellcheck disable=SC2086
	status 1 "$c: beyond it" ncpost -c $c $turn --set digits.angle=3 out.cl
done
axis 120.00009 >hardly.cl
axis 120.0002 >more.cl
for c in siemens heidenhain linuxcnc; do # of five decimals and four
	turn="--set a.min=0 --set c.min=-10 --set c.max=10"
	for file in edge hardly; do
		# shellcheck disable=SC2086
		status 0 "$c: $file, with the control's own digits" ncpost -c $c $turn $file.cl
		hasnt "nothing is beyond 120" ' A\+?120\.0*[1-9]' out
	done
	# shellcheck disable=SC2086
	status 1 "$c: 120.0002 is beyond it" ncpost -c $c $turn more.cl
done
ncpost -q -c siemens --set a.min=0 --set c.min=-10 --set c.max=10 hardly.cl >vectors.mpf
has "as a vector, too: A is 120" 'C3=-0\.5( |$)' vectors.mpf
printf 'UNITS/MM\nLOADTL/1\nSPINDL/900\nRAPID\nGOTO/0,0,50\nFEDRAT/100\nGOTO/120.00004,0,0\nFINI\n' >x.cl
status 0 "X 120.00004 is 120" ncpost -c fanuc --set x.max=120 x.cl
sed 's/120.00004/120.002/' x.cl >y.cl
status 1 "120.002 is not" ncpost -c fanuc --set x.max=120 y.cl
has "is told with its travel, as the first place" 'position of 120.001.* travel -2000 to 120 .the first such place' err
sed 's/^GOTO.120.*/GOTO\/120.002,0,0\nGOTO\/100,7,0\nGOTO\/131.25,8,-1\nGOTO\/130,9,0/' x.cl >far.cl
for unit in "" --inch; do
	# shellcheck disable=SC2086
	status 1 "a hair beyond it, and then more $unit" ncpost -c fanuc $unit --set x.max=120 far.cl
	has "is told with the furthest place" \
		'120.00[0-9]* at .* the path goes on to 131.250 at the point 131.250 8.000 -1.000.$' err
done
status 1 "nor in inches" ncpost -c fanuc --inch --set x.max=120 y.cl
has "where it is told in mm, too" 'position of 120.00[0-9]* at the point 120.00.* travel -2000 to 120 ' err
sed 's/120.00004/-120.00004/' x.cl >x-.cl
sed 's/120.00004/-120.002/' x.cl >y-.cl
for c in fanuc okuma haas hurco; do
	status 0 "$c: nor is X -120.00004 beyond -120" ncpost -c $c --set x.min=-120 x-.cl
	status 1 "$c: -120.002 is" ncpost -c $c --set x.min=-120 y-.cl
done

# ---- rotary words: two turns about Z at A 30
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/900\nRAPID\nGOTO/0,0,60,0,-0.5,0.866025404\nFEDRAT/MMPM,500"
	for (i = 0; i <= 144; i++) { w = i * atan2(0, -1) / 36
		printf "GOTO/%.6f,%.6f,0,%.9f,%.9f,%.9f\n", 20 * sin(w), -20 * cos(w), sin(w) / 2, -cos(w) / 2, sqrt(3) / 2 }
	print "FINI" }' >round.cl
ncpost -q -c siemens --rotary round.cl >own.mpf
has "Siemens, an axis without end: DC()" ' C=DC\([0-9.]+\)' own.mpf
hasnt "no plain words there" ' C-?[0-9]' own.mpf
sed -n 's/.*C=DC(\([0-9.]*\)).*/\1/p' own.mpf | awk '!($1 >= 0 && $1 < 360) { exit 1 }'
result $? "all within 0 to 360"
ok "read back" "$READBACK" -c siemens -m table-ac --path round.cl -e 0.0062 --axis 0.052 own.mpf
ncpost -q -c siemens --rotary --set c.min=-720 --set c.max=720 round.cl >plain.mpf
has "of an axis that ends: plain" ' C-?[0-9]' plain.mpf
hasnt "no DC()" 'DC\(' plain.mpf
for words in 0-360 signed; do
	ncpost -q -c fanuc --set rotary.words=$words round.cl >w.nc
	grep -o ' C-*[0-9.]*' w.nc | tr -d ' C-' | awk '$1 > 360 { exit 1 }'
	result $? "rotary.words = $words: within a turn"
	ok "read back" "$READBACK" -c fanuc -m table-ac --set rotary.words=$words --path round.cl -e 0.0062 --axis 0.052 w.nc
done

for c in fanuc heidenhain linuxcnc haas; do
	printf 'include = table-ac\nrotary.words = dc\n' >dc.txt
	status 1 "$c: no DC()" ncpost -c $c -m ./dc.txt round.cl
	has "named with its line" '^ncpost: ./dc.txt:2: rotary.words: found dc, which .* does not know' err
	empty "and nothing written" out
done
status 0 "Siemens has it" ncpost -q -c siemens -m ./dc.txt --rotary round.cl

done_testing

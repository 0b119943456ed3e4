#!/bin/sh
# ncverify-lengths.t - lengths of tools in the machine file: a program is judged with the length of the
# tool that is in the spindle and of the one that is switched on, wherever the control keeps it.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# Two tools, 100 and 150.5 long, at one place, leaning by B 30.
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON"
	for (t = 1; t <= 2; t++) {
		print "LOADTL/" t "\n$$-> PASS/" t "\nSPINDL/900\nRAPID\nGOTO/10,0,90,0.5,0,0.866025403784\nFEDRAT/MMPM,300"
		print "GOTO/10,0,20,0.5,0,0.866025403784\nRAPID\nGOTO/10,0,90,0.5,0,0.866025403784"
	}
	print "FINI" }' >two.cl
bare='centre.B = 0 0 150\nc.min = -5\nc.max = 5\n'
lengths='tool.1.length = 100\ntool.2.length = 150.5\ntool.1.name = SHORT\ntool.2.name = LONG\n'
printf "include = head-table-bc\n$bare$lengths" >tcp.txt
printf "include = head-table-bc-notcp\n$bare$lengths" >solved.txt
printf "include = head-table-bc-notcp\n$bare" >bare.txt
read_back() { # CONTROL MACHINE PROGRAM: exit status; how far off is in `off`
	tcp=
	[ "$1" = linuxcnc ] && tcp=--no-tcp
	"$READBACK" -c "$1" $tcp -m "./$2.txt" --path two.cl -e 0.0062 --axis 0.052 "$3" >"read" 2>&1
	got=$?
	off=$(sed -n 's/^program on path: tip \([0-9.]*\).*/\1/p' read)
	return $got
}
off_by() { # DESC WANTED CONTROL MACHINE PROGRAM
	read_back "$3" "$4" "$5"
	awk -v a="$off" -v b="$2" 'BEGIN { exit !(a - b < 0.001 && b - a < 0.001) }'
	result $? "$1 ($off, expected $2)"
}
for m in tcp solved; do
	for c in fanuc siemens heidenhain linuxcnc; do
		ncpost -q -c $c -m ./$m.txt -o good.$c two.cl
		read_back $c $m good.$c
		result $? "$c, $m: each tool with its length"
		case $c in
		fanuc | linuxcnc) # the tip is too low by the difference
			sed 's/ H2/ H1/' good.$c >bad.$c
			off_by "$c, $m: H1 with tool 2" 50.5 $c $m bad.$c
			;;
		*) # all is reckoned with tool 1; without tool-centre-point control the place was tool 2's:
			# 50.5 (sin 30, 1 - cos 30) off
			sed 's/T2 D1/T1 D1/; s/TOOL CALL 2/TOOL CALL 1/' good.$c >bad.$c
			want=26.1407
			[ $m = tcp ] && want=0
			off_by "$c, $m: tool 1 in place of tool 2" $want $c $m bad.$c
			;;
		esac
	done
done

# A name stands for its tool; a tool near the spindle is not in it
for c in siemens heidenhain; do
	ncpost -q -c $c -m ./solved.txt --set tool.names=yes -o named.$c two.cl
	has "$c calls by name" '"LONG"' named.$c
	read_back $c solved named.$c
	result $? "and is read with its length"
done
ncpost -q -c fanuc -m ./solved.txt --set tool.next=yes -o next.nc two.cl
has "the next tool is brought near" '^N[0-9]+ T2$' next.nc
read_back fanuc solved next.nc
result $? "and is not taken for the one in the spindle"

# In ncverify: a plane, three axes
awk 'BEGIN { for (i = 0; i <= 20; i++) for (j = 0; j <= 20; j++) print i / 2, j / 2, 0 }' >plane.xyz
awk 'BEGIN { print "UNITS/MM\nCUTTER/10,5\nLOADTL/2\nSPINDL/900\nRAPID\nGOTO/-2,-2,30\nFEDRAT/500"
	for (j = 0; j <= 28; j++) { a = j % 2 ? 12 : -2; print "GOTO/" a "," j / 2 - 2 ",0\nGOTO/" 10 - a "," j / 2 - 2 ",0" }
	print "RAPID\nGOTO/0,0,30\nFINI" }' >plane.cl
printf 'include = three-axis\ntool.1.length = 100\ntool.2.length = 101.5\n' >m.txt
for c in fanuc linuxcnc; do
	ncpost -q -c $c -m ./m.txt -o plane.$c plane.cl
	status 0 "$c: its length" ncverify -m ./m.txt -g plane.xyz -r 5 plane.$c
	sed 's/ H2/ H1/' plane.$c >low.$c
	status 3 "$c: a shorter one" ncverify -m ./m.txt -g plane.xyz -r 5 low.$c
	has "gouges by the difference" '1\.500' out
	sed 's/T2 M6/T1 M6/' plane.$c >high.$c
	status 3 "$c: a shorter tool than is switched on" ncverify -m ./m.txt -g plane.xyz -r 5 high.$c
	sed "s,T2 M6,T7 M6,; s, H2, H7,; s,(TOOL 2:,(TOOL 7:," plane.$c >seven.$c
	status 0 "$c: of a tool without length, on a machine whose head stands" \
		ncverify -m ./m.txt -g plane.xyz -r 5 seven.$c
done
sed 's/T2 M6/T7 M6/; s/ H2/ H7/' good.fanuc >seven.nc
status 1 "a head's tool without length" ncverify -m ./solved.txt -g plane.xyz -r 5 seven.nc
has "is refused with its block" 'seven.nc:[0-9]+: N[0-9]+: cuts with tool 7, whose length is not in' err
ncpost -q -c fanuc -m ./tcp.txt -o tcp.nc two.cl
sed 's/T2 M6/T7 M6/; s/ H2/ H7/' tcp.nc >seven.nc
status 3 "with tool-centre-point control the control knows it" ncverify -m ./tcp.txt -g plane.xyz -r 5 seven.nc
status 3 "without lengths in the file nothing is known of H" ncverify -m ./bare.txt -g plane.xyz -r 5 good.fanuc

done_testing

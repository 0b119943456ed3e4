#!/bin/sh
# bsplfit-links.t - links from row to row that rise off the part, as curves: who judges the program
# tells them from a curve with a wrong pole.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (x = -6; x <= 26; x += 0.5) for (y = -6; y <= 8; y += 0.5) print x, y, 0 }' >plane.xyz

# path HEIGHT: two rows of 20 mm, 1 mm apart, and an arch of that height back between them
path() {
	awk -v height="$1" 'function go(x, y, z, contact) {
		if (contact) printf "$$-> CONTCT/%.6f,%.6f,0,0,0,1\n", x, y
		printf "GOTO/%.6f,%.6f,%.6f,0,0,1\n", x, y, z
	}
	BEGIN {
		print "PARTNO/LINK\nUNITS/MM\nMULTAX/ON\nCUTTER/10,5,0,5,0,0,60\nLOADTL/1\nSPINDL/RPM,8000,CLW"
		print "COOLNT/ON\n$$-> CLOUDMILL/1\n$$-> TOOL/FLUTE,20\n$$-> CLEAR/30\n$$-> PASS/1\nRAPID"
		print "GOTO/0,0,30,0,0,1\nRAPID\nGOTO/0,0,5,0,0,1\nFEDRAT/MMPM,400"
		go(0, 0, 0, 0); print "FEDRAT/MMPM,800"
		for (k = 0; k <= 40; k++) go(k / 2, 0, 0, 1)
		for (k = 1; k < 20; k++) go(20 - k, k / 20, height * 4 * k / 20 * (1 - k / 20), 0)
		print "$$-> PASS/2"
		for (k = 0; k <= 40; k++) go(k / 2, 1, 0, 1)
		print "RAPID\nGOTO/20,1,30,0,0,1\nFINI"
	}'
}

# The judge calls 1.25 mm off the part: a quarter of the radius.
for height in 0.5 1.4 2 4; do
	path $height >path.cl
	status 0 "an arch of $height mm" bsplfit -q -g plane.xyz -o curves.cl path.cl
	for control in fanuc siemens heidenhain linuxcnc; do
		ncpost -q -c $control -o program.nc curves.cl
		status 0 "$control: accepted" ncverify -q -c $control -g plane.xyz --partial program.nc
	done
done
path 0 >path.cl
bsplfit -q -g plane.xyz -o flat.cl path.cl
ok "a link on the part has no more poles" \
	awk -F, '/MOVNRB\/ON/ { n++; if ($3 > 8) bad = 1 } END { exit !(n >= 3 && !bad) }' flat.cl
done_testing

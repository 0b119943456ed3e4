#!/bin/sh
# controls.t - cloudmill-controls(7) has every word that programs have, under its control.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
LC_ALL=C
export LC_ALL
cd "$TMP" || exit 1
page=$SRC/man/cloudmill-controls.7

# ---- paths that make the writers say all they can: shapes, cycles, tools, stops, planes, compensation

cp "$SRC/tests/data/golden/shapes.cl" shapes.cl
awk 'BEGIN {
	print "PARTNO/ALL\nUNITS/MM\nMULTAX/ON\nCUTTER/10,5\nLOADTL/3\nSPINDL/8000,CLW\nCOOLNT/ON\nRAPID\nGOTO/0,0,60"
	print "FEDRAT/MMPM,500\nCUTCOM/LEFT\nGOTO/0,9,0\nGOTO/9,9,0\nCUTCOM/RIGHT\nGOTO/9,30,0\nCUTCOM/OFF\nGOTO/0,40,0"
	print "STOP\nOPSTOP\nDELAY/0.5\nSPINDL/500,CCLW\nCOOLNT/MIST\nCIRCLE/0,45,0,0,0,1,5\nGOTO/0,50,0"
	print "RAPID\nGOTO/0,0,60\nLOADTL/4\nCUTTER/6\nSPINDL/RPM,3000,CLW\nCOOLNT/OFF"
	n = split("DRILL,DEPTH,10,CLEAR,2,RTRCTO,20;FACE,FEDTO,3,RAPTO,1.5,DWELL,0.25;DEEP,DEPTH,31,STEP,5,CLEAR,2;" \
		"BRKCHP,DEPTH,13,STEP,6,CLEAR,2;BORE,DEPTH,14,CLEAR,3,DWELL,1,RTRCTO,9;BORE,DRAG,DEPTH,15,CLEAR,4;" \
		"BORE,DEPTH,14,CLEAR,3;TAP,DEPTH,12,PITCH,1.25,CLEAR,4", cycle, ";")
	for (i = 1; i <= n; i++) print "CYCLE/" cycle[i] (cycle[i] ~ /^TAP/ ? "" : ",MMPM,100") "\nGOTO/" i ",1,0\nGOTO/" i ",2,0\nCYCLE/OFF"
	print "RAPID\nGOTO/2,1,90\nSPINDL/300,CCLW\nCYCLE/TAP,DEPTH,12,PITCH,1.25,CLEAR,4\nGOTO/0,0,0\nCYCLE/OFF\nRAPID\nGOTO/2,1,90\nFINI" }' >upright.cl
sed 's/^GOTO\/\(.*\)$/GOTO\/\1,0,0.6,0.8/;/CIRCLE/d;/CUTCOM/d' upright.cl >tilted.cl

# words PROGRAM: those that are fixed by the control, one a line, 0 before a figure left out
words_of() { # DIALECT PROGRAM
	case $1 in
	heidenhain) sed 's/^[0-9]* *//;s/;.*//' "$2" | tr ' ~' '\n' |
		sed -n 's/^\(CYCL\|DEF\|TOOL\|CALL\|BEGIN\|END\|PGM\|MM\|INCH\|FUNCTION\|RESET\|TCPM\|TCP\|AXIS\|POS\|PATHCTRL\|VECTOR\|PLANE\|SPATIAL\|STAY\|TURN\|TOLERANCE\|DWELL\|L\|LN\|CC\|C\|FMAX\|R0\|RL\|RR\|DR\)[-+]*$/\1/p
			s/^\(M[0-9]*\)$/\1/p;s/^\([0-9][0-9]*\)\.[012]$/\1/p;s/^\(2[0-9][0-9]\)$/\1/p' ;;
	siemens) sed 's/;.*//' "$2" | tr ' ' '\n' | sed -n 's/^\([GM][0-9]*\)$/\1/p;s/^[ABC]=\(DC\)(.*/\1/p;s/^\([A-Z][A-Z0-9][A-Z0-9]*\)\(\[[A-Z]*\]\)*[=(].*/\1/p;s/^\([A-Z][A-Z][A-Z0-9]*\)$/\1/p' ;;
	*) sed 's/([^)]*)//g' "$2" | tr ' ' '\n' |
		sed -n 's/^\([GM]\)0*\([0-9][0-9]*\)\.*\([0-9]*\)$/\1\2.\3/p;s/^\(#[A-Z]*\)$/\1/p' | sed 's/\.$//' ;;
	esac | sort -u
}

# the same of a section of the page
words_of_page() { # SECTION
	awk -v want=".Ss $1" '/^\.S[sh] / { on = $0 == want } on && /^\.It / { sub(/^\.It /, ""); print }' "$page" |
		tr ' ,' '\n' | grep -vE '^(Cm|Ar|)$' | sort -u
}

for file in "$SRC"/controls/*.txt; do
	control=$(basename "$file" .txt)
	base=$control
	while ! grep -q '^dialect' "$SRC/controls/$base.txt"; do
		base=$(sed -n 's/^base *= *//p' "$SRC/controls/$base.txt")
	done
	dialect=$base
	: >words
	for path in shapes upright tilted; do
		for options in "" "--vectors" "--rotary" "--plane" "--inch --set smooth=yes" "--set cutcom=yes -m three-axis" \
			"--set arcs.space=yes" "-m table-ac-notcp" "-m linuxcnc-xyzac" "--set length.off=z" "--program ABC"; do
			# shellcheck disable=SC2086
			ncpost -q -c "$control" $options -o p.nc "$path.cl" 2>err && words_of "$dialect" p.nc >>words
		done
	done
	sort -u words >said
	ok "$control: its words are found" test "$(wc -l <said)" -ge 15
	title=$(sed -n 's/^title *= *//p' "$file")
	{ words_of_page "$title" && words_of_page "$(sed -n 's/^title *= *//p' "$SRC/controls/$dialect.txt")"; } |
		sort -u | comm -23 said - >missing
	empty "$control: each stands in cloudmill-controls(7)" missing
done

# ---- and of what the page says of confirmation each is one of four

grep -c '^\.It Cm' "$page" >n
ok "the page has its items" test "$(cat n)" -ge 40
awk '/^\.It Cm/ { if (open) print "no confirmation: " open; open = $0; next }
	/\((rs274|manual|posts|not confirmed)\)\.$/ { open = "" }
	/^\.El/ && open { print "no confirmation: " open; open = "" }' "$page" >missing
empty "each item says where it was confirmed" missing

done_testing

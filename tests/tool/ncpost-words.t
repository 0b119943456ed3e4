#!/bin/sh
# ncpost-words.t - every word of every kind of program, against what the controls take: numbers,
# comments, block numbers, lengths, and that nothing is said twice.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack them.
ncpost() { command ncpost --no-spindle "$@"; }
cd "$TMP" || exit 1

# ---- paths: all shapes, cycles, tools, a tilted plane, all directions; with a name of every sort
shapes=$SRC/tests/data/golden/shapes.cl
{ printf 'PARTNO/M\303\274ller (rev. [2]) {a|b}; 50%% "x" \\ %s\n' "$(printf '%0200d' 7)"
	sed '/PARTNO/d' "$shapes"; } >named.cl
cat >mixed.cl <<'END'
PARTNO/MIXED
UNITS/MM
MULTAX/ON
CUTTER/10,5
LOADTL/3
SPINDL/8000,CLW
COOLNT/ON
PPRINT (a nested (remark)) with a long tail that goes on and on beyond what any block may hold, on and on
RAPID
GOTO/0,0,50
FEDRAT/MMPM,0.00001
GOTO/0,0,0
FEDRAT/MMPM,9999999
GOTO/-0.00000001,0.0000001,-0.00001
GOTO/-0.0004,10,-0.00049
STOP
OPSTOP
DELAY/0.5
SPINDL/500,CCLW
COOLNT/MIST
CIRCLE/0,5,0,0,0,1,5.0000159
GOTO/0,0,-0.00001
COOLNT/OFF
RAPID
GOTO/0,0,50
LOADTL/4
CUTTER/6
SPINDL/RPM,3000,CLW
CYCLE/DRILL,DEPTH,5,CLEAR,1,MMPM,100
GOTO/1,1,0
GOTO/2,1,0
CYCLE/OFF
RAPID
GOTO/2,1,60
FINI
END
sed 's/GOTO\/\(.*\)$/GOTO\/\1,0,0.6,0.8/; /CIRCLE/d' mixed.cl >tilted.cl
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4\nSPINDL/9000,CLW\nFEDRAT/MMPM,700\nRAPID\nGOTO/0,0,90,0,0,1"
	for (i = 0; i < 160; i++) { a = i / 8; t = 0.8 * sin(i / 25)
		printf "GOTO/%.7f,%.7f,%.7f,%.9f,%.9f,%.9f\n", 30 * cos(a / 3), i / 9, 5 * sin(a),
			sin(t) * cos(a), sin(t) * sin(a), cos(t) }
	print "RAPID\nGOTO/0,0,90,0,0,1\nFINI" }' >turns.cl

# ---- the rules; a line that breaks one is printed with its name
# shellcheck disable=SC2016
lint='
function say(what) { if (told++ < 4) print FILENAME ":" FNR ": " what ": " substr($0, 1, 90) }
function word(letter,  at) {
	at = match(" " bare " ", " " letter "[-+]?[0-9.]+ ")
	RLENGTH--
	return at ? substr(" " bare, RSTART + 1 + length(letter), RLENGTH - 1 - length(letter)) : ""
}
function forget(  k) { for (k in last) delete last[k]; motion = "" }
{ bare = $0 }
/[^ -~]/ { say("a byte that is no printable ASCII") }
/ $/ { say("a blank at the end") }
/^$/ { say("an empty line") }
control ~ /fanuc|linuxcnc/ {
	if ($0 ~ /\(/) {
		open = gsub(/\(/, "(", bare); shut = gsub(/\)/, ")", bare)
		if (open != 1 || shut != 1 || $0 !~ /\)$/) say("a comment in a comment")
		if (length($0) > 80) say("a comment of more than 80 columns")
		sub(/ *\(.*\)/, "", bare)
	}
	if ($0 ~ /[a-z]/) say("a small letter")
	if (bare ~ /[XYZABCIJKRQF][-+]?[0-9]+( |$)/ && bare !~ /^O|G05/) say("a number without its point")
}
control ~ /siemens|heidenhain/ { sub(/ *;.*/, "", bare) }
length($0) > (control == "linuxcnc" ? 255 : control == "fanuc" ? 120 : 500) { say("a long block") }
bare ~ /[A-Z=(,]-(0+\.?0*|\.0+)( |,|\)|$)/ { say("minus zero") }
bare ~ /[0-9.][eE][-+]?[0-9]/ { say("an exponent") }
bare ~ /[0-9]\.[0-9]*\.[0-9]/ && bare !~ /CYCL DEF/ { say("two points in a number") }
bare ~ /(^| )F(0+\.?0*|\.0+)( |$)/ { say("a feed of nothing") }
control == "heidenhain" && $0 !~ /^ / {
	if ($1 != FNR - 1 - more) say("a block number that does not count")
}
control == "heidenhain" && /^ / { more++ }
control == "heidenhain" && bare ~ /^[0-9]+ LN? / && bare ~ / [XYZABC][0-9]/ { say("a place without its sign") }
control != "heidenhain" && match(bare, /^N[0-9]+ /) {
	n = substr(bare, 2, RLENGTH - 2) + 0
	if (n <= number && n > 100) say("a block number that falls"); number = n
}
# what is said again though it holds; the poles of BSPLINE and the places of MCALL are
bare ~ /(^| )(G[1-9]|CIP|POLY|MCALL$)/ { whole = 0 }
bare ~ /BSPLINE|MCALL CYCLE/ { whole = 1 }
whole { forget(); next }
bare ~ /G28|G53|SUPA|M91|G49|G43|TRA|G06|POLY|BSPLINE|ORI|CYCL|M99|MCALL|G8[0-9]|G7[34]|G9[89]|CIP|G6[89]|PLANE|LN |M6|TOOL|G0?2|G0?3| C X|CC|G40|G4[12]|G93|G94|G17|K[0-9]/ { forget(); next }
{
	if (match(" " bare, / G[01]( |$)/)) {
		now = substr(" " bare, RSTART + 1, 2)
		if (now == motion) say("the same motion said again")
		motion = now
	}
	split("X Y Z A B C", letter, " ")
	for (i = 1; i <= 6; i++) {
		value = word(letter[i])
		if (value == "") continue
		if (letter[i] in last && last[letter[i]] == value) say(letter[i] " said again")
		last[letter[i]] = value
	}
	if (word("F") != "" && control != "heidenhain" && !inverse) {
		if (feed == word("F") && !/G93/) say("F said again")
		feed = word("F")
	}
}
END { if (control == "fanuc" || control == "linuxcnc") { if ($0 != "%") say("no % at the end") } }'

checked=0
check() { # CONTROL PATH OPTIONS
	control=$1
	path=$2
	# shellcheck disable=SC2086
	ncpost -q -c $control $3 -o p.$control "$path" 2>err || { echo "$control $path $3: exit $?: $(cat err)"; return; }
	inverse=0
	grep -q G93 p.$control && inverse=1
	awk -v control=$control -v inverse=$inverse "$lint" p.$control >told
	[ ! -s told ] || { echo "== $control $path $3"; head -n 3 told; }
}
for control in fanuc siemens heidenhain linuxcnc; do
	for path in named.cl mixed.cl tilted.cl turns.cl; do
		for options in "" "--inch" "-m head-cb" "-m table-ac-notcp" "--set smooth=yes" \
			"--set number.step=0" "--set cycles=no" "-m nutating-table"; do
			check $control $path "$options"
			checked=$((checked + 1))
		done
	done
	[ $control = linuxcnc ] || check $control named.cl "--vectors"
	[ $control = linuxcnc ] || check $control tilted.cl "--plane --inch"
done >complaints
head -n 40 complaints >err
empty "all kinds of programs keep the rules of their controls" complaints
below "kinds of programs" 128 "$checked"

# the rules can be broken
for bad in 'N10 G1 X-0. Y1.' 'N10 G1 X1e5' 'N10 G1 X5' 'N10 G0 X1. (A (B))' 'N10 G1 X1. F0.' 'N10 G1 x1.'; do
	printf '%%\n%s\n%%\n' "$bad" | awk -v control=fanuc "$lint" | grep -q . || echo "$bad"
done >blind
printf '%%\nN10 G1 X1. Y1. F5.\nN20 G1 X2.\nN30 X2.\n%%\n' | awk -v control=fanuc "$lint" | grep -c 'again' >found
has "a rule that cannot be broken is none" '^2$' found
empty "nor the others" blind

done_testing

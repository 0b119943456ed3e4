#!/bin/sh
# ncverify-foreign.t - every shipped control's programs are read and accepted; programs in the style
# of other systems are read as far as their words are known, unknown words are told once, and what
# moves and is not read is refused with its line.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# ---- all controls: a pass over a dome, on five axes and on three

awk 'BEGIN { for (y = -8; y <= 8.001; y += 0.8) for (x = -12; x <= 12.001; x += 0.8)
	printf "%.5f %.5f %.5f\n", x, y, 20 - (x * x + y * y) / 80 }' >dome.xyz
cloud2mesh -q -t 1 -o dome.ply dome.xyz
meshnorm -q -r 6 -o five.cl dome.ply
meshnorm -q -r 6 --fixed 0,0,1 -o three.cl dome.ply
for file in "$SRC"/controls/*.txt; do
	control=$(basename "$file" .txt)
	while read -r machine path options; do
		# shellcheck disable=SC2086
		ok "$control, $machine $options: is written" \
			ncpost -q -c "$control" -m "$machine" $options -o part.nc "$path"
		status 0 "$control, $machine $options: is accepted" \
			ncverify -q -c "$control" -m "$machine" -g dome.xyz -r 6 -e 0.1 part.nc
		empty "$control, $machine $options: with no word passed over" err
	done <<-END
		table-ac five.cl --set smooth=yes
		head-ca five.cl
		three-axis three.cl
	END
done

# ---- words of a machine file: clamps, smoothing, offsets, a user's own M

reads() { # DESC CONTROL "SED": the program of that control, changed, is still accepted
	ncpost -q -c "$2" -m table-ac five.cl |
		sed 's/CLOUDMILL NCPOST/ANOTHER SYSTEM/; s/cloudmill ncpost/another system/' >good.nc
	sed "$3" good.nc >changed.nc
	if cmp -s good.nc changed.nc; then result 1 "$1 (nothing is changed)"; return; fi
	status 0 "$1" ncverify -c "$2" -m table-ac -g dome.xyz -r 6 -e 0.1 changed.nc
}
reads "G05.1 Q1 R7" fanuc 's/^\(N[0-9]*\) M8$/\1 G05.1 Q1 R7/'
reads "M10 and M88 of clamps" fanuc 's/^\(N[0-9]*\) M8$/\1 M10 M88/'
reads "G54.1 P3" fanuc 's/ G54$/ G54.1 P3/'
reads "G187 P3 E0.01" haas 's/^\(N[0-9]*\) M8$/\1 G187 P3 E0.01/'
reads "G05.1 Q2 X0 Y0 Z0, which names axes" fanuc 's/^\(N[0-9]*\) M8$/\1 G05.1 Q2 X0 Y0 Z0/'
reads "G15" fanuc 's/ G80 / G80 G15 /'
reads "M126" heidenhain 's/^\([0-9]*\) M8$/\1 M126/'
reads "BLK FORM" heidenhain 's/^\([0-9]*\) M8$/\1 BLK FORM 0.1 Z X-20 Y-20 Z-5/'
reads "a block that may be skipped" fanuc 's/^\(N[0-9]* M8\)$/\/\1/'
reads "comments in small letters" haas 's/^(TOOL 1.*/(tool 1, ball nose)/'
reads "no O and no block numbers" fanuc 's/^N[0-9]* //;/^O/d'
reads "neither % nor O" fanuc '/^%/d;/^O/d'
reads "an M that is not known" fanuc 's/^\(N[0-9]*\) M8$/\1 M253/'
has "is told, with its line and how often" '^ncverify: changed.nc:[0-9]*: found M253, .* no effect \(1 times\)$' err
reads "each once" fanuc 's/^\(N[0-9]*\) \(M8\|M9\)$/\1 M253/'
has "and is counted" '\(2 times\)' err
ok "though it stands twice" test "$(grep -c M253 err)" -eq 1
printf 'base = fanuc\nwords = M253: idle\n' >own.txt
status 0 "a control's file says what it means" ncverify -c own -g dome.xyz -r 6 -e 0.1 changed.nc
empty "then nothing is told" err

# ---- a place beside a G with numbers of its own is gone to
moves() { # DESC CONTROL "SED": at rapid into the part, which is found
	ncpost -q -c "$2" -m three-axis -o good.nc three.cl
	sed "$3" good.nc >changed.nc
	status 3 "$1" ncverify -c "$2" -m three-axis -g dome.xyz -r 6 -e 0.1 changed.nc
	has "$1: told" 'rapid' err
}
moves "G187 P3 Z15." haas 's/^\(N[0-9]*\) M8$/\1 G187 P3 Z15./'
moves "G154 P2 Z15." haas 's/^\(N[0-9]*\) M8$/\1 G154 P2 Z15./'
moves "G54.1 P2 Z15." fanuc 's/^\(N[0-9]*\) M8$/\1 G54.1 P2 Z15./'
moves "G64 P0.01 Z15." linuxcnc 's/^\(N[0-9]*\) M8$/\1 G64 P0.01 Z15./'

# ---- what moves and is not read: refused at its line

refuses() { # DESC CONTROL "SED" REGEX
	ncpost -q -c "$2" -m table-ac -o good.nc five.cl
	sed "$3" good.nc >changed.nc
	if cmp -s good.nc changed.nc; then result 1 "$1 (nothing is changed)"; return; fi
	line=$(cmp good.nc changed.nc | sed 's/.*line //')
	status 1 "$1: refused" ncverify -q -c "$2" -m table-ac -g dome.xyz -r 6 changed.nc
	has "$1: at its line" "^ncverify: changed.nc:$line: .*$4" err
	ok "$1: by one line" test "$(wc -l <err)" -eq 1
}
refuses "a subprogram" fanuc 's/^\(N[0-9]*\) M8$/\1 M98 P1000/' 'M98, a subprogram'
refuses "a macro" fanuc 's/^\(N[0-9]*\) M8$/\1 G65 P9810 Z10./' 'G65, a macro'
refuses "a variable" fanuc 's/^\(N[0-9]*\) M8$/\1 #100=5./' 'variable'
refuses "a word by a variable" fanuc 's/^\(N[0-9]*\) M8$/\1 G0 Z#100/' 'variable'
refuses "a condition" fanuc 's/^\(N[0-9]*\) M8$/\1 IF [#1 EQ 0] GOTO 5/' '.'
refuses "scaling" fanuc 's/^\(N[0-9]*\) M8$/\1 G51 X0. Y0. Z0. P2/' 'G51, scaling'
refuses "mirroring" haas 's/^\(N[0-9]*\) M8$/\1 G101 X0./' 'G101, mirroring'
refuses "a turned frame" fanuc 's/^\(N[0-9]*\) M8$/\1 G68 X0. Y0. R45./' 'G68, a turned frame'
refuses "a shift" fanuc 's/^\(N[0-9]*\) M8$/\1 G52 X10./' 'G52, .*shift'
refuses "a change of offsets" fanuc \
	's/^\(N[0-9]*\) M8$/\1 G10 L2 P1 X5./' 'G10, a change of offsets or a retract'
refuses "radius compensation" fanuc 's/^\(N[0-9]*\) M8$/\1 G41 D1/' 'G41, radius'
refuses "a cycle" fanuc 's/^\(N[0-9]*\) M8$/\1 G76 X1. Y1. Z1. R5./' 'G76, a cycle'
refuses "a pocket" haas 's/^\(N[0-9]*\) M8$/\1 G150 P100/' 'G150, a pocket'
refuses "a G with a place" fanuc 's/^\(N[0-9]*\) M8$/\1 G333 X1./' 'G333 with a place'
refuses "G05.1 Q1 with a place" fanuc 's/^\(N[0-9]*\) M8$/\1 G05.1 Q1 X30./' 'G05.1 with a place'
refuses "an axis that is not there" fanuc 's/^\(N[0-9]*\) M8$/\1 G0 W10./' 'W10'
refuses "a subprogram of LinuxCNC" linuxcnc 's/^\(N[0-9]*\) M8$/o<holes> call [1] [2]/' 'a subprogram or a loop'
refuses "a loop of LinuxCNC" linuxcnc 's/^\(N[0-9]*\) M8$/O100 repeat [5]/' 'a subprogram or a loop'
refuses "a subprogram by its name" siemens 's/^\(N[0-9]*\) M8$/\1 POCKET_7/' 'POCKET_7'
refuses "a cycle of Siemens" siemens 's/^\(N[0-9]*\) M8$/\1 POCKET3(10,0,2,-5)/' 'POCKET3'
refuses "a label called" heidenhain 's/^\([0-9]*\) M8$/\1 CALL LBL 1/' '.'
refuses "a datum shift" heidenhain 's/^\([0-9]*\) M8$/\1 CYCL DEF 7.0 DATUM SHIFT/' 'frame'
refuses "a rounded corner" heidenhain 's/^\([0-9]*\) M8$/\1 RND R5/' '.'

# ---- a tilted plane of Heidenhain: SPA, SPB and SPC are about the axes of the frame that is not tilted,
# one after another (User's Manual, PLANE SPATIAL: sequence A-B-C)

awk 'function turn(i, j, by,  c, s, t) { c = cos(by * r); s = sin(by * r); t = c * v[i] - s * v[j]; v[j] = s * v[i] + c * v[j]; v[i] = t }
	function out(x, y, z) { v[1] = x; v[2] = y; v[3] = z; turn(2, 3, 30); turn(3, 1, 20); turn(1, 2, 40)
		return sprintf("%.7f,%.7f,%.7f", v[1], v[2], v[3]) }
	function go(x, y, z) { return "GOTO/" out(x, y, z) "," out(0, 0, 1) }
	BEGIN { r = atan2(0, -1) / 180; print "UNITS/MM\nMULTAX/ON\nSPINDL/900\nRAPID\n" go(5, 0, 50) "\nFEDRAT/MMPM,500\n" go(5, 0, 10) \
		"\n" go(25, 15, 10) "\nRAPID\n" go(25, 15, 50) "\nFINI" }' >spatial.cl
cat >spatial.h <<'END'
0 BEGIN PGM P MM
1 L Z+0 R0 FMAX M91
2 TOOL CALL 1 Z S900
3 M3
4 PLANE SPATIAL SPA+30 SPB+20 SPC+40 TURN FMAX
5 L X+5 Y+0 R0 FMAX
6 L Z+50 R0 FMAX
7 L Z+10 F500
8 L X+25 Y+15
9 L Z+50 FMAX
10 PLANE RESET TURN FMAX
11 L Z+0 R0 FMAX M91
12 M5
13 M30
14 END PGM P MM
END
ok "spatial angles in the order A, B, C" "$READBACK" -c heidenhain -m table-ac --path spatial.cl -e 0.0001 --axis 0.001 spatial.h
sed 's/SPA+30 SPB+20/SPA+20 SPB+30/' spatial.h >other.h
status 3 "others are another plane" "$READBACK" -c heidenhain -m table-ac --path spatial.cl -e 0.0001 --axis 0.001 other.h

# ---- radius compensation: wear alone, where the machine says that the path is the tool's centre

{ sed -n '1,/^FEDRAT/p' three.cl && printf 'CUTCOM/LEFT\n' && sed '1,/^FEDRAT/d' three.cl; } >side.cl
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c "$control" -m three-axis --set cutcom=yes -o side.nc side.cl
	has "$control: compensation is on" ' (G41|RL)( |$)' side.nc
	status 0 "$control: it is read" ncverify -q -c "$control" -m three-axis --set cutcom=yes \
		-g dome.xyz -r 6 -e 0.1 side.nc
	status 1 "$control: else refused" ncverify -q -c "$control" -m three-axis -g dome.xyz -r 6 side.nc
	has "$control: and told" 'radius compensation, which this reader does not read' err
done

# ---- programs in the style of other systems (own data): five of them, each cuts a plane at z = 0

awk 'BEGIN { for (y = 1; y <= 19; y++) for (x = 1; x <= 39; x++) print x, y, 0 }' >plane.xyz
for file in "$SRC"/tests/data/foreign/*; do
	name=$(basename "$file")
	control=${name%%-*}
	status 0 "$name: is read and accepted" ncverify -c "$control" -m three-axis \
		-g plane.xyz -r 5 --left 0.06 "$file"
	has "$name: it cut the plane" '^verdict +accepted' out
	sed 's/Z+*0\.* F300/Z-0.2 F300/;s/z0 f/z-0.2 f/' "$file" >deep.nc
	status 3 "$name: deeper it is refused" ncverify -c "$control" -m three-axis -g plane.xyz -r 5 deep.nc
done

# ---- words that count from where the tool is: the same way, travel and verdict as in absolute ones

awk 'BEGIN { for (y = 1; y <= 19; y++) for (x = 1; x <= 39; x++) print x, y, 0 }' >plane.xyz
plane() { # CONTROL by|abs: rows over the plane with half circles between them, a full circle at their end
	awk -v control="$1" -v by="$2" '
	function signed(v) { v = sprintf("%.3f", v); if (v + 0 == 0) v = "0.000"; return control == "heidenhain" && v !~ /^-/ ? "+" v : v }
	function word(letter, v,   from) { from = at[letter]; at[letter] = v
		if (!by) return " " letter signed(v)
		if (control == "heidenhain") return " I" letter signed(v - from)
		if (control == "siemens" && letter == "X") return " X=IC(" signed(v - from) ")"
		if (control == "siemens" && letter == "Y") return " Y=AC(" signed(v) ")"
		return " " letter signed(v - from) }
	function block(text) { if (control == "heidenhain") print n++ " " text; else print text }
	BEGIN { at["X"] = 0; at["Y"] = 0.5; at["Z"] = 5; dot = control == "fanuc" ? "." : ""; plus = control == "heidenhain"
		if (control == "fanuc") print "%\nO0007 (PLANE)\nG17 G21 G40 G49 G80\nG91 G28 Z0\nG90 G54 G0 X0 Y0.5\nT1 M6\nS6000 M3\nG43 H1 Z5. M8"
		if (control == "linuxcnc") print "%\nG17 G21 G40 G49 G80 G90 G54\nT1 M6\nS6000 M3\nG0 X0 Y0.5\nG43 H1 Z5"
		if (control == "siemens") print "G54 G17 G71 G90 G40\nT1 D1\nM6\nS6000 M3\nG0 X0 Y0.5\nZ5"
		if (plus) { block("BEGIN PGM P MM"); block("TOOL CALL 1 Z S6000"); block("M3"); block("L X+0 Y+0.5 R0 FMAX"); block("L Z+5 FMAX") }
		else if (by) print "G91"
		block((plus ? "L" : "G1") word("Z", 0) " F300" dot)
		for (y = 0.5; y < 20; y++) { x = x ? 0 : 40
			block((plus ? "L" : "G1") word("X", x) " F900" dot)
			if (plus) { block("CC" word("X", x) word("Y", y + 0.5)); at["Y"] = y
				block("C" word("X", x) word("Y", y + 1) (x ? " DR+" : " DR-")) }
			else block((x ? "G3" : "G2") word("X", x) word("Y", y + 1) " I0" dot " J0.5") }
		if (plus) { block("CC" (by ? " IX+2 IY+0" : " X+2 Y" signed(y))); block("C" word("X", x) word("Y", y) " DR+") }
		else block("G3" (by ? "" : word("X", x) word("Y", y)) " I2. J0.")
		block((plus ? "L" : "G0") word("Z", 25) (plus ? " FMAX" : ""))
		if (!plus) print "G90\nM9"
		if (control == "fanuc") print "G91 G28 Z0.\nM5\nM30\n%"
		if (control == "linuxcnc") print "M5\nM2\n%"
		if (control == "siemens") print "M5\nM30"
		if (plus) { block("M5"); block("M30"); block("END PGM P MM") } }'
}
for control in fanuc haas linuxcnc siemens heidenhain; do
	reader=$control
	[ $control = haas ] && reader=fanuc
	plane $reader "" >abs.nc
	plane $reader 1 >by.nc
	for kind in abs by; do
		status 0 "$control, $kind: is accepted" ncverify -c $control -m three-axis -g plane.xyz -r 5 --left 0.06 $kind.nc
		grep -E '^(way|time|travel|coverage|gouge|verdict)' out >$kind.says
		has "$control, $kind: its half circles and the full one are in it" ' 21 arcs' out
	done
	same "$control: the same way, travel, coverage and verdict" abs.says by.says
	case $control in heidenhain) deep='s/ L IX+40/ L IZ-0.1 IX+40/' ;; siemens) deep='s/^G1 X=IC(40/G1 Z-0.1 X=IC(40/' ;; *) deep='s/^G1 X40/G1 Z-0.1 X40/' ;; esac
	sed "$deep" by.nc >deep.nc
	status 3 "$control: a little deeper from row to row is too deep" ncverify -c $control -m three-axis -g plane.xyz -r 5 deep.nc
done

# holes: R counts from where the tool begins, Z from R
holes() { printf '%s\n' % 'O0008' 'G17 G21 G40 G80 G90 G54' 'S6000 M3' 'G0 X0. Y0.' 'G43 H1 Z10.' "$@" G80 'G90 G0 Z30.' M5 M30 %; }
holes 'G98 G81 X1. Y1. Z-3. R2. F200.' 'X5. Y1.' 'X9. Y4.' >abs.nc
holes 'G91 G98 G81 X1. Y1. Z-5. R-8. F200.' 'X4.' 'X4. Y3.' >by.nc
for control in fanuc linuxcnc; do
	for kind in abs by; do
		sed "$([ $control = linuxcnc ] && echo '/^O/d;s/^M5$/M5 G49/')" $kind.nc >hole.nc
		ncverify -c $control -m three-axis -g plane.xyz -r 1 hole.nc 2>err | grep -E '^(way|time|travel|gouge)' >$kind.says
	done
	ok "$control: holes are read" grep -q '^travel Z *-3.000 to 30.000' abs.says
	same "$control: holes under G91" abs.says by.says
done
for kind in abs by; do # heights stay when the mode changes between holes
	holes 'G98 G81 X1. Y1. Z-3. R2. F200.' "$([ $kind = abs ] && echo 'X5. Y1.' || echo 'G91 X4.')" >hole.nc
	ncverify -c fanuc -m three-axis -g plane.xyz -r 1 hole.nc 2>err | grep -E '^(way|time|travel|gouge)' >$kind.says
done
ok "holes before and after G91 are read" grep -q '^travel X *0.000 to 5.000' abs.says
same "holes before and after G91" abs.says by.says

# rotary words
printf '%s\n' % O0009 'G17 G21 G90 G54' 'S6000 M3' 'G0 A0. C0.' 'G43.4 H1' 'G0 X0. Y0. Z40.' 'G1 X5. A10. C20. F900.' \
	'X10. A-5. C50.' 'G0 Z60.' G49 'G91 G28 Z0.' G90 M5 M30 % >abs.nc
sed 's/^G1 X5/G91 G1 X5/;s/^X10.*/X5. A-15. C30./;s/^G0 Z60\./G90 &/' abs.nc >by.nc
for kind in abs by; do
	ncverify -c fanuc -m table-ac -g plane.xyz -r 1 --partial $kind.nc 2>err | grep -E '^(way|time|travel|gouge)' >$kind.says
done
ok "rotary words are read" grep -q '^travel A *-5.000 to 10.000' abs.says
same "rotary words under G91" abs.says by.says

# centres from the zero
plane linuxcnc "" | awk '/^G[23] /{ x = substr($2, 2); y = substr($3, 2); $4 = "I" (/I2/ ? 2 : x); $5 = "J" (/I2/ ? y : y - 0.5) } { print }' |
	sed '2s/$/ G90.1/' >centre.nc
plane linuxcnc "" >abs.nc
for kind in abs centre; do
	ncverify -c linuxcnc -m three-axis -g plane.xyz -r 5 --left 0.06 $kind.nc | grep -E '^(way|travel|verdict)' >$kind.says
done
same "G90.1" abs.says centre.says

# ---- no G43: Z is taken for the tip's height, and told; not where a length is on elsewhere

for control in fanuc linuxcnc; do
	plane $control 1 | sed 's/G43 H1 //' >none.nc
	status 0 "$control: no G43" ncverify -c $control -m three-axis -g plane.xyz -r 5 --left 0.06 none.nc
	ok "$control: told once" test "$(grep -c "none.nc:[0-9]*: cuts without the tool's length (G43): took Z" err)" -eq 1
	plane $control 1 | sed '8,$s/^G90/G49 G90/;s/ J0.5$/& /;30s/^/G49 /' >off.nc
	status 1 "$control: G43 left while it cuts" ncverify -q -c $control -m three-axis -g plane.xyz -r 5 off.nc
	has "$control: named" "off.nc:3[01]: cuts without the tool's length, G43" err
	sed '30s/^/G43 H1 /' none.nc >late.nc
	status 1 "$control: G43 after cuts" ncverify -q -c $control -m three-axis -g plane.xyz -r 5 late.nc
	has "$control: named" "late.nc:30: the tool's length comes on after" err
done

refuses "G6.2 under G91" fanuc 's/^\(N[0-9]*\) M8$/\1 G91 G02.4 X1. Y1. Z1./' 'under G91'
for word in 'U=IC(5)' AP=30 RP=5 'X1=5' TURN=2 RND=3 'POS[Z]=5'; do
	refuses "$word of Siemens" siemens "s/^\(N[0-9]*\) M8\$/\1 G1 $word/" 'a place that this reader does not know'
done

# ---- a part with faces is no scan: where a face can't be read, its vertices alone are not the part
cloud2mesh -q -t 2 -o plane.ply plane.xyz
plane fanuc 1 >plane.nc
ok "a part with faces" ncverify -q -c fanuc -m three-axis -g plane.ply -r 5 --left 0.06 plane.nc
sed 's/^3 0 /3 999999 /' plane.ply >bad.ply
status 1 "a face of a vertex that is not there" \
	ncverify -q -c fanuc -m three-axis -g bad.ply -r 5 plane.nc
has "... is told" 'bad.ply:[0-9]*: .*999999' err

done_testing

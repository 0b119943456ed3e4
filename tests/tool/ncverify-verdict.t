#!/bin/sh
# ncverify-verdict.t - good programs are accepted, each kind of fault is found in its block; the
# figures are those of surfaces known exactly; map and page hold what they say.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# ---- a dome: z = 20 - (x^2 + y^2) / 80 by its points, and a path over it written here
# The ball of R 6 in passes 1 mm apart along x touches the dome in each point; the axis leans by 10
# degrees from the normal in the plane of the pass.  gouge: the ball that much too deep everywhere.
scan() { # STEP X Y: its points so far apart, over -X to X and -Y to Y
	awk -v d="$1" -v u="$2" -v v="$3" 'BEGIN { for (y = -v; y <= v + 0.001; y += d)
		for (x = -u; x <= u + 0.001; x += d)
            printf "%.5f %.5f %.5f\n", x, y, 20 - (x * x + y * y) / 80 }'
}
scan 0.3 18 12 >dense.xyz # for faults that only some points tell
scan 0.4 18 12 >dome.xyz

# dome CONTROL [GOUGE [HALF]]: the program, point by point, A and C as ISO has them; passes from
# -15 to 15, or so many quarters of a millimetre to each side
dome() {
	awk -v control="$1" -v gouge="${2:-0}" -v half="${3:-60}" '
	function sign(v, d,   s) { s = sprintf("%." d "f", v); if (s + 0 == 0) s = sprintf("%." d "f", 0)
		return control == "heidenhain" && s !~ /^-/ ? "+" s : s }
	function block(text) {
		if (control == "heidenhain") printf "%d %s\n", ++n, text
		else { n += 10; printf "N%d %s\n", n, text } }
	function go(word, x, y, z, a, c, rest) {
		block(word " X" sign(x, 4) " Y" sign(y, 4) " Z" sign(z, 4) " A" sign(a, 4) " C" sign(c, 4) rest) }
	function head() {
		if (control == "fanuc") { print "%"; print "O0001(DOME)"
			block("G90 G17 G21 G40 G49 G80 G94 G54"); block("G53 G0 Z0."); block("T1 M6"); block("S8000 M3")
			block("G0 A10. C-90."); block("G43.4 H1"); block("G0 X-15. Y-10. Z60.") }
		if (control == "siemens") { print "%_N_DOME_MPF"
			block("G90 G17 G71 G40 G94 G54"); block("SUPA G0 Z0 D0"); block("T=\"BALL\" D1 M6"); block("S8000 M3")
			block("TRAORI"); block("ORIWKS ORIAXES"); block("G0 A10 C-90"); block("G0 X-15 Y-10 Z60") }
		if (control == "heidenhain") { print "0 BEGIN PGM DOME MM"
			block("L Z+0 R0 FMAX M91"); block("TOOL CALL 1 Z S8000"); block("M3"); block("L A+10 C-90 R0 FMAX")
			block("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS"); block("L X-15 Y-10 Z+60 FMAX") }
		if (control == "linuxcnc") { print "%"
			block("G90 G91.1 G17 G21 G40 G49 G80 G94 G54"); block("G61"); block("G53 G0 Z0."); block("T1 M6")
			block("S8000 M3"); block("G0 A10. C-90."); block("G0 X-15. Y-10."); block("G43 H1 Z60.") } }
	function foot() {
		if (control == "fanuc") { block("G49"); block("G53 G0 Z0."); block("M5"); block("M30"); print "%" }
		if (control == "siemens") { block("TRAFOOF"); block("SUPA G0 Z0 D0"); block("M5"); block("M30") }
		if (control == "heidenhain") { block("FUNCTION RESET TCPM"); block("L Z+0 R0 FMAX M91"); block("M5")
			block("M30"); block("END PGM DOME MM") }
		if (control == "linuxcnc") { block("G49"); block("G53 G0 Z0."); block("M5"); block("M2"); print "%" } }
	# the tip, and A C: the axis (sin a, 0, cos a) in the plane of the pass is A a, C 90
	function place(word, x, y, up, rest,   nx, ny, l, a, z) {
		nx = x / 40; ny = y / 40; l = sqrt(nx * nx + ny * ny + 1)
		z = 20 - (x * x + y * y) / 80
		a = atan2(nx, 1) + 0.2
		go(word, x + (6 - gouge) * nx / l - 6 * sin(a), y + (6 - gouge) * ny / l,
			z + (6 - gouge) / l - 6 * cos(a) + up, a * 57.29577951308232, 90, rest) }
	BEGIN {
		rapid = control == "heidenhain" ? "L" : "G0"
		line = control == "heidenhain" ? "L" : "G1"
		fast = control == "heidenhain" ? " FMAX" : ""
		feed = " F800" (control == "fanuc" ? "." : "")
		head()
		side = half / 4
		for (y = -int(side / 1.5); y <= side / 1.5; y++) {
			place(rapid, (y % 2 ? side : -side), y, 10, fast)
			for (i = -half; i <= half; i++)
				place(line, (y % 2 ? -1 : 1) * i / 4, y, 0, feed)
			place(line, (y % 2 ? -side : side), y, 10, feed)
			place(rapid, (y % 2 ? -side : side), y, 30, fast)
		}
		foot()
	}'
}

for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-iso
	dome $control >dome.$control
	printf 'include = table-ac\ncontrol = linuxcnc\n' >linuxcnc-iso.txt
	status 0 "$control: a good program is accepted" \
		ncverify -q -g dome.xyz -r 6 -e 0.005 --partial --left 0.03 -m $machine dome.$control
	has "$control: and told so" '^verdict +accepted' out
done
# ---- faults, each put into one block of the good program; the block named is the one

# fault DESC "SED" PATTERN: refused with 3, and a finding matches
fault() {
	sed "$2" dome.fanuc >bad.nc
	if cmp -s bad.nc dome.fanuc; then result 1 "$1 (the fault is not in)"; return; fi
	status 3 "$1: refused" ncverify -g dense.xyz -r 6 -e 0.005 --partial --left 0.03 bad.nc
	has "$1: named" "^ncverify: bad.nc: $3" err
}

# broken DESC "SED" PATTERN: it cannot be run
broken() {
	sed "$2" dome.fanuc >bad.nc
	if cmp -s bad.nc dome.fanuc; then result 1 "$1 (the fault is not in)"; return; fi
	status 1 "$1: cannot be run" ncverify -g dome.xyz -r 6 bad.nc
	has "$1: named" "^ncverify: bad.nc:[0-9]+: $3" err
}

# N12030 stands in pass 10 (y -1), where the ball cuts near the crown.
block=$(grep -n '^N12030 ' dome.fanuc)
z=$(echo "$block" | sed 's/.* Z\([-0-9.]*\).*/\1/')
deeper=$(awk -v z="$z" 'BEGIN { printf "%.4f", z - 0.05 }')
near='N120[2-4]0 .*'
fault "a gouge of 0.05 mm" "/^N12030 /s/Z[-0-9.]*/Z$deeper/" "${near}the ball is 0.0[45].* deep"
fault "material left" '/^N11980 /,/^N12080 /s/Z19/Z20/' 'N.*of material is left'
fault "a wrong sign of A" '/^N11400 /s/A/A-/' 'N11(39|40|41)0 .* deep'
fault "a wrong sign of X" '/^N12030 /s/X-/X/' 'N120[2-4]0 .* deep'
fault "a wrong A" '/^N12030 /s/A[-0-9.]*/A40./' "${near} deep"
fault "a wrong C" '/^N11400 /s/C90/C70/' 'N11[34][019]0 .* deep'
fault "digits swapped in Z" '/^N12030 /s/Z19\.7/Z17.9/' 'N120[2-4]0 .* deep'
fault "blocks missing in a pass" '/^N1\(19[6-9]\|20[0-9]\)0 /d' 'N12100 .* deep'
fault "a block missing before a retract" '/^N12400 /,/^N12440 /d' 'N12450 .* deep'
fault "a rapid through the part" '/^N12390 /s/X.*/X-17. Z8./;/^N12390/s/G1/G0/;/^N12400 /s/G1/G1/' \
	'N12(39|40)0 .*'
fault "a line as a rapid, deep" '/^N12030 /s/G1.*/G0 X0. Z15./' 'N12030 .*rapid move goes'
fault "a rapid back across the part" '/^N12420 /s/G.*/G0 X15. Y0. Z16./' 'N12420 .*rapid move goes'
fault "a pass too low" '/^N11180 /,/^N12390 /s/Z1/Z0/' 'N1[12][0-9]*0 .* deep'
fault "a pass left out" '/ Y-1\.1[0-9]* /d' 'N.*of material is left'
fault "passes 2 mm apart" '/ Y-*1\.1[0-9]* /d' 'N.*of material is left'
fault "a limit of an axis passed" '/^N12400 /s/Y[-0-9.]*/Y2500./' 'N12400 .*axis . at .* beyond its travel'
fault "a limit of A passed" '/^N12420 /s/A[-0-9.]*/A130./' 'N124[0-9]0 .*axis A at 130.000 is beyond'
sed '/^N12420 /s/A[-0-9.]*/A120.0004/' dome.fanuc >bad.nc
ncverify -q -g dome.xyz -r 6 -e 0.005 --partial bad.nc >out 2>err
hasnt "a limit is met within the digits that are printed" 'beyond its travel' err
fault "and not by a digit more" "/^N12420 /s/A[-0-9.]*/A120.001/" 'N124[0-9]0 .*axis A at 120.001 is beyond'
fault "an arc that is none" '/^N12030 /s/G1\(.*\)A.*/G2\1R3. F800./' 'N12030 .*'
broken "an arc of wrong radius" '/^N12030 /s/G1\(.*\)A.*/G2\1I1. J1. F800./' 'N12030: an arc whose ends'
broken "a cut-off file" '2000,$d' 'the program ends without M30'
broken "cut off in a word" '/^N12030 /s/Y.*/Y/;/^N12030 /q' 'N12030: found'
broken "no % at the end" '$d' 'the program ends without %'
broken "no spindle" '/M3$/d' 'N[0-9]*: cuts while the spindle is off'
broken "no tool centre point control" '/G43/d' 'N[0-9]*: cuts without tool centre point'
broken "no feed" 's/ F800\.//' 'N[0-9]*: cuts without a feed'
broken "an unknown word" '/^N12030 /s/$/ Q1. U5./' 'N12030: found U5'
broken "a word twice" '/^N12030 /s/$/ X0./' 'N12030: a word twice'
broken "no decimal point" '/^N12030 /s/X[-0-9.]*/X1/' 'N12030: a length, angle or feed without'
broken "blocks that changed places" '/^N12030 /{h;d;};/^N12040 /{G;}' 'N12030: its number does not rise'
fault "inches" 's/G21/G20/' 'N[0-9]+ .*(beyond its travel|near no point)'
broken "two units" '/^N12030 /s/G1/G20 G1/' 'N12030: millimetres and inches'
broken "incremental words" 's/G90/G91/' 'N[0-9]*: '
broken "a retract home under tool centre point control" '/^N26[0-9]* G49/d' 'N[0-9]*: G28 or G53'
broken "letters for digits" '/^N12030 /s/X/XO/' 'N12030: found'

# Good programs in inches and in a tilted plane.
cloud2mesh --nodes scan -q -t 2 dome.xyz -o dome.ply
meshnorm -q -r 6 --rows mesh --fixed 0.3,0.2,0.9 dome.ply >tilt.cl
bsplfit -q -e 0.01 tilt.cl >tilt-s.cl
for control in fanuc siemens heidenhain; do
	ncpost -q -c $control --plane tilt.cl >tilt.$control
	status 0 "$control: a tilted plane" ncverify -q -g dome.xyz -r 6 -e 0.03 tilt.$control
	ncpost -q -c $control --inch tilt-s.cl >inch.$control
	status 0 "$control: inches" ncverify -q -g dome.xyz -r 6 -e 0.03 inch.$control
done
# the plane of a program that is turned by hand: one of its angles 2 degrees off
tilt() { # CONTROL "SED"
	sed -E "$2" tilt.$1 >bad.nc
	if cmp -s bad.nc tilt.$1; then result 1 "$1: a wrong plane (the fault is not in)"; return; fi
	status 3 "$1: a plane turned by hand" ncverify -g dome.xyz -r 6 -e 0.03 -c $1 bad.nc
	has "$1: is found" '^ncverify: bad.nc: N?[0-9]+ .*the ball is [0-9.]+ mm deep in the part' err
}
tilt fanuc '/G68\.2/s/J21\./J23./'
tilt siemens '/CYCLE800\(0,/s/-12\./-14./'
tilt heidenhain '/PLANE SPATIAL/s/SPA-11\./SPA-13./'
sed 's/G43 H1//' tilt.fanuc >bad.nc
status 1 "no length of the tool" ncverify -g dome.xyz -r 6 bad.nc
has "is named" "N[0-9]+: cuts without the tool's length" err

# ---- each kind of fault on each control, on a smaller dome of 7 passes
scan 0.3 9 6 >little.xyz

# edit K OP [WORD VALUE]: good.$control with one thing changed in the K-th block at feed, to
# bad.$control; N is that block's name.  `to` adds to a word, `set` sets it.
edit() {
	awk -v k="$1" -v op="$2" -v word="$3" -v value="$4" -v control=$control '
	function number(v,   s) { s = sprintf("%.4f", v); return control == "heidenhain" && v >= 0 ? "+" s : s }
	{ feed = / G1 | L .*F800/ ? ++n : 0 }
	feed != k || op == "" { print; next }
	{ print $1 >"named" }
	op == "del" { next }
	op == "twice" { print }
	op == "after" { held = $0; getline; print; print held; next }
	op == "fast" { sub(/ G1 /, " G0 "); sub(/ F800\.?/, control == "heidenhain" ? " FMAX" : ""); op = "add" }
	op == "say" { $0 = $0 " " word }
	op == "cut" { sub(/ Y.*/, " Y"); print; exit }
	{ for (i = 3; i <= NF; i++) if (substr($i, 1, 1) == word) {
		if (op == "add") $i = word number(substr($i, 2) + value)
		if (op == "set") $i = word number(value)
		if (op == "is") $i = word value
		if (op == "turn") $i = word number(-substr($i, 2)) } }
	op == "swap" { x = y = 0; for (i in F) delete F[i]
		for (i = 3; i <= NF; i++) { if ($i ~ /^X/) x = i; if ($i ~ /^Y/) y = i }
		t = $x; $x = "X" substr($y, 2); $y = "Y" substr(t, 2) }
	{ print }' good.$control >bad.$control
	N=$(cat named)
	[ $control != heidenhain ] || awk '{ $1 = NR - 1; print }' bad.$control >again && [ ! -s again ] || mv again bad.$control
}

# judge STATUS "KIND" PATTERN
judge() {
	if cmp -s bad.$control good.$control; then result 1 "$control: $2 (the fault is not in)"; return; fi
	status "$1" "$control: $2: found" \
		ncverify -g little.xyz -r 6 -e 0.005 --partial --left 0.03 -m $machine bad.$control
	has "$control: $2: named" "$3" err
}

whole() { # "KIND" "SED" STATUS PATTERN: something changed in all of the program
	sed "$2" good.$control >bad.$control
	[ $control != heidenhain ] || awk '{ $1 = NR - 1; print }' bad.$control >again && [ ! -s again ] || mv again bad.$control
	judge "$3" "$1" "$4"
}

# Each control's words for the same.
words() {
	case $control in
	fanuc) unit=s/G21/G20/ tcp='s/G43.4 H1//' off='/ G49$/d' end='/M30/d' dec=' F800.' ;;
	siemens) unit=s/G71/G70/ tcp=/TRAORI/d off=/TRAFOOF/d end=/M30/d dec=' F800' ;;
	heidenhain) unit='s/ MM$/ INCH/' tcp='/FUNCTION TCPM/d' off='/RESET TCPM/d' end=/M30/d dec=' F800' ;;
	linuxcnc) unit=s/G21/G20/ tcp='s/G43 H1//' off='/ G49$/d' end=/M2/d dec=' F800' ;;
	esac
}

for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-iso
	words
	dome $control 0 30 >good.$control
	status 0 "$control: the good one is accepted" \
		ncverify -q -g little.xyz -r 6 -e 0.005 --partial --left 0.03 -m $machine good.$control
	edit 345 add Z -0.05; judge 3 "a gouge of 0.05 mm" "$N .*the ball is 0\.04[5-9].* deep"
	edit 330 turn A; judge 3 "a wrong sign of A" "N[0-9]+ .*(deep|tool axis swings)"
	edit 345 add A 25; judge 3 "a wrong A" "$N .*deep"
	edit 365 add C 60; judge 3 "a wrong C" "N[0-9]+ .*(deep|tool axis swings)"
	edit 330 turn X; judge 3 "a wrong sign of X" 'N[0-9]+ .*deep'
	edit 335 swap; judge 3 "X and Y changed places" 'N[0-9]+ .*deep'
	edit 345 add Z -1.8; judge 3 "digits of Z changed places" "$N .*deep"
	edit 345 fast Z -5
	judge 3 "a rapid move through the part" "$N .*a rapid move goes .* deep through the part"
	edit 372 set Y 2500; judge 3 "a limit of Y passed" "$N .*axis . at .* is beyond its travel"
	edit 372 set A 130; judge 3 "a limit of A passed" "$N .*axis A at 130.000 is beyond"
	edit 345 set F 0; judge 1 "a feed of nothing" "$N: "
	edit 345 is X 1O; judge 1 "a letter among digits" "$N: "
	edit 345 is Y; judge 1 "a word without its number" "$N: "
	edit 345 say U5; judge 1 "an unknown word" "$N: "
	edit 345 say X+0.5; judge 1 "a word twice" "$N: .*twice"
	edit 345 cut; judge 1 "cut off within a word" "$N: "
	sed 400q good.$control >bad.$control; judge 1 "cut off" 'ends without'
	whole "no feed at all" "s/$dec\$//" 1 'N[0-9]+: cuts without a feed'
	whole "no spindle" '/ M3$/d' 1 'N[0-9]+: cuts while the spindle is off'
	whole "another unit" "$unit" 3 'N[0-9]+ .*(beyond its travel|near no point)'
	whole "no call of the tool's length or its point" "$tcp" 1 'N[0-9]+: cuts (without|from|with)'
	[ $control = linuxcnc ] || whole "nor its end" "$off" 1 'bad' # M2 may leave the length on there
	whole "no end of the program" "$end" 1 'bad'
	whole "a pass too low" '/ Y[-+]*2\.[0-9]*/s/Z\([+]*\)1/Z\10/' 3 'N[0-9]+ .*deep'
	whole "a pass left out" '/ Y[+]*1\.1[0-9]*/d' 3 'N[0-9]+ .*of material is left'
	[ $control = heidenhain ] && continue # its blocks are counted anew here
	edit 345 twice; judge 1 "a block twice" "$N: its number does not rise"
	edit 345 after; judge 1 "blocks that changed places" "its number does not rise"
	whole "incremental words" s/G90/G91/ 1 'N[0-9]+: '
done

# ---- splines: a pole too deep is named by its block; knots that fall, a curve that is torn
meshnorm -q -r 6 --rows mesh dome.ply | bsplfit -q -e 0.01 >spline.cl
# an axis as its rule says crosses the pole amid a pass: one curve ends there and another begins
meshnorm -q -r 6 --rows mesh --axis-play 0 dome.ply | bsplfit -q -e 0.01 >joint.cl

# pole OF WHICH UP: one pole of OF.$control over the middle of the part higher by UP, to bad.nc; N
# is its block.  inner: between two poles of its curve; joint: the last where a curve goes on.
pole() {
	awk -v which="$2" -v up="$3" '
	{ line[NR] = $0; pole[NR] = / K[0-9.]+ X/ || (/ ZH=/ && !/ G1 /); first[NR] = /G06\.2|BSPLINE/ }
	function word(i, letter,   k, w, n) { n = split(line[i], w)
		for (k = 1; k <= n; k++) if (w[k] ~ "^" letter "[-0-9]") return substr(w[k], 2) + 0
		return 1000 }
	function middle(i,   x, y) { x = word(i, "X"); y = word(i, "Y"); return x * x + y * y < 100 }
	function fits(i,   k) {
		if (!pole[i] || first[i] || !middle(i)) return 0
		if (which == "inner") return pole[i - 1] && pole[i + 1] && !first[i + 1]
		for (k = i + 1; line[k] ~ / G1 (ORI|XH=)| K[0-9.]+$/; k++);
		return first[k] }
	END { for (i = 1; i <= NR; i++) { $0 = line[i]
		if (!done && fits(i)) { done = 1; print $1 >"named"
			for (k = 1; k <= NF; k++) if ($k ~ /^Z[0-9]/) $k = sprintf("Z%.3f", substr($k, 2) + up) }
		print } }' $1.$control >bad.nc
	N=$(sed 's/N//' named)
	ok "$control: there is a pole, $2" test "$(diff $1.$control bad.nc | grep -c '^>')" -eq 1
}

for control in fanuc siemens; do
	ncpost -q -c $control spline.cl >spline.$control
	ncpost -q -c $control joint.cl >joint.$control
	status 0 "$control: a good spline" ncverify -q -g dome.xyz -r 6 -e 0.03 spline.$control
	pole spline inner -0.5 # it, or the one beside it, whose span it shapes as much
	status 3 "$control: a pole too deep" ncverify -g dome.xyz -r 6 -e 0.03 -c $control bad.nc
	has "$control: is named by its block" "^ncverify: bad.nc: N($N|$((N + 10))|$((N - 10))) .*deep" err
	# 100 mm up: the passes beside leave little on its place, but the curve leaves the part
	pole spline inner 100
	status 3 "$control: a pole far too high" ncverify -g dome.xyz -r 6 -e 0.03 -c $control bad.nc
	has "$control: is named too" \
		"^ncverify: bad.nc: N($N|$((N + 10))|$((N - 10))) .*leaves the part amid a cut" err
	# where one curve ends and another begins: a Fanuc refuses it, its first pole is not there
	pole joint joint 100
	if [ $control = fanuc ]; then
		status 1 "$control: a joint far too high" ncverify -g dome.xyz -r 6 -e 0.03 -c $control bad.nc
		has "$control: is no spline" 'N[0-9]+: a spline whose first pole is not where the tool is' err
	else
		status 3 "$control: a joint far too high" ncverify -g dome.xyz -r 6 -e 0.03 -c $control bad.nc
		has "$control: is named" "^ncverify: bad.nc: N($N|$((N - 10))) .*leaves the part amid a cut" err
	fi
	# the last pole of a pass 100 mm up: the next block comes down again
	awk '/G0?6.2|BSPLINE/ { inside = 1 } / G1 | K[0-9.]+$/ { inside = 0 }
		{ line[NR] = $0; if (inside) last = NR; else if (last && !end) end = last }
		END { for (i = 1; i <= NR; i++) { $0 = line[i]
			if (i == end) { print $1 >"named"
				for (k = 1; k <= NF; k++) if ($k ~ /^Z[0-9]/) $k = sprintf("Z%.3f", substr($k, 2) + 100) }
			print } }' spline.$control >bad.nc
	status 3 "$control: a last pole far too high" ncverify -g dome.xyz -r 6 -e 0.03 -c $control bad.nc
	N=$(sed 's/N//' named)
	has "$control: is named by its span" \
		"^ncverify: bad.nc: N($N|$((N - 10))) .*leaves the part amid a cut" err
done
awk '/ K[0-9.]+ X/ && ++n == 40 { sub(/ K[0-9.]+/, " K999.") } { print }' spline.fanuc >bad.nc
status 1 "a knot that is too large" ncverify -g dome.xyz -r 6 bad.nc
has "is named" 'N[0-9]+: a spline whose knots fall' err

# ---- the weight of a pole, times, programs in parts
awk '/ ZH=/ && !/ G1 / && ++n == 5 { $0 = $0 " PW=5"; print $1 >"named" } { print }' spline.siemens >bad.nc
status 3 "siemens: a wrong weight of a pole" ncverify -g dome.xyz -r 6 -e 0.03 bad.nc
has "siemens: is named" "^ncverify: bad.nc: $(cat named) .*deep" err
awk '/ ZH=/ && !/ G1 / { $0 = $0 " PW=1" } { print }' spline.siemens >bad.nc
status 0 "siemens: weights of one change nothing" ncverify -q -g dome.xyz -r 6 -e 0.03 bad.nc
for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-iso
	rm -f part-*
	ncpost -q -c $control -m $machine --split 400 -o part.nc spline.cl
	for part in part-*; do
		status 0 "$control: $part" ncverify -q -c $control -m $machine -g dome.xyz -r 6 -e 0.03 "$part"
	done
	# the time at feed: all ways of the tip by 800 mm/min, and dwells as they are written
	case $control in
	fanuc) dwell='G4 X1.5' ;; siemens) dwell='G4 F1.5' ;; linuxcnc) dwell='G4 P1.5' ;;
	heidenhain) dwell='CYCL DEF 9.1 DWELL 1.5' ;;
	esac
	awk -v dwell="$dwell" '{ print } / M3$/ { print (/^N/ ? "N" substr($1, 2) + 1 : 0), dwell }' \
		dome.$control >dwell.$control
	[ $control != heidenhain ] || {
		awk '{ $1 = NR - 1; print }' dwell.$control >again
		mv again dwell.$control
	}
	ncverify -q -g dome.xyz -r 6 -e 0.005 -m $machine dwell.$control >out 2>err
	sum=$(awk '/ (G[01]|L) X/ { for (i = 3; i <= NF; i++) p[substr($i, 1, 1)] = substr($i, 2)
		if (/F800/) s += sqrt((p["X"] - x) ^ 2 + (p["Y"] - y) ^ 2 + (p["Z"] - z) ^ 2)
		x = p["X"]; y = p["Y"]; z = p["Z"] } END { printf "%.2f", s / 800 }' dome.$control)
	has "$control: its time is the sum of all blocks" "^time +$sum min at feed, .*, 0.03 min dwell$" out
done

# ---- drilling cycles: down and out at their feeds, a tap at its pitch; what they wait
# 2 * 12 / 8 at rest 2 * 24 s; 5 steps to 20, one to 7: 22 / 5 and 9 / 5; 3 threads in and out at
# 1.25 * 40, 2 * 16 / 50 each; bored 2 * 17 / 6 and 60 s
cat >holes.cl <<-'END'
	PARTNO/HOLES
	UNITS/MM
	MULTAX/ON
	CUTTER/8
	LOADTL/5
	SPINDL/RPM,40,CLW
	RAPID
	GOTO/-7,-3,60,0,0,1
	CYCLE/FACE,FEDTO,10,RAPTO,2,MMPM,8,DWELL,24
	GOTO/0,1,0,0,0,1
	GOTO/10,2,0,0,0,1
	CYCLE/DEEP,DEPTH,20,STEP,4,CLEAR,2,MMPM,5
	GOTO/20,3,0,0,0,1
	CYCLE/DEEP,DEPTH,7,STEP,9,CLEAR,2,MMPM,5
	GOTO/-20,3,0,0,0,1
	CYCLE/TAP,DEPTH,12,PITCH,1.25,CLEAR,4
	GOTO/0,20,0,0,0,1
	GOTO/7,20,0,0,0,1
	GOTO/14,20,0,0,0,1
	CYCLE/BORE,DEPTH,14,CLEAR,3,MMPM,6,DWELL,60
	GOTO/9,30,0,0,0,1
	CYCLE/OFF
	RAPID
	GOTO/9,30,60,0,0,1
	FINI
END
for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-iso
	ncpost -q -c $control -m $machine holes.cl >holes.nc
	ncverify -q -c $control -g dome.xyz -r 4 -m $machine holes.nc >out 2>err
	has "$control: the time of drilling cycles, and their dwells" \
		'^time +16\.79 min at feed, .*, 1\.80 min dwell$' out
done
# dwells at each step and above it: 4 steps to 20; 5, 4, 3, 3, 3 and 2 to 20, the last one waits
# longer; 20, 15, 10, 10 and 5 to 60, chips broken once between two retractions
wait_of() { # DESC MINUTES CONTROL FILE
	ncverify -q -c "$3" -g dome.xyz -r 4 "$4" >out 2>err
	has "$1" "^time .*, $2 min dwell\$" out
}
ncpost -q -c siemens holes.cl | sed 's/MCALL CYCLE83.*,-20,.*/MCALL CYCLE83(5,0,2,-20,,,5,0,12,6,1,1)/
	s/MCALL CYCLE83.*,-7,.*/MCALL CYCLE83(5,0,2,-20,,-5,,1,6,0,1,0,,3,,30)/' >deep.mpf
wait_of "Siemens: dwells of steps" 3.90 siemens deep.mpf # 66 s and 60 s more
ncpost -q -c heidenhain holes.cl | sed 's/Q211=+0 /Q211=+3 /' >deep.h
wait_of "Heidenhain: dwells at the bottom" 1.90 heidenhain deep.h
awk '/ DEF 205/ { print $1, "CYCL DEF 203 UNIVERSAL DRILLING ~"
	print "    Q200=+2 ~\n    Q201=-60 ~\n    Q206=+5 ~\n    Q202=+20 ~\n    Q210=+12 ~\n    Q203=+0 ~"
	print "    Q204=+0 ~\n    Q212=+5 ~\n    Q213=+1 ~\n    Q205=+10 ~\n    Q211=+0 ~\n    Q208=+99999 ~"
	print "    Q256=+1"; on = 1; next }
	on && /^ / { next } { on = 0; print }' deep.h >breaks.h
wait_of "Heidenhain: dwells above" 2.60 heidenhain breaks.h # 24 s more for either hole

# ---- shank and holder, on all controls: 6 mm over the ball's centre a collar of 30 that leans
for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-iso
	status 0 "$control: a holder that is clear" ncverify -q -g dome.xyz -r 6 -e 0.005 -m $machine \
		--holder 6:20+6:15:30+15:20 dome.$control
	sed "/^N*12030* /s/A+*[0-9.]*/A+50.0/" dome.$control >lean.$control
	[ $control = heidenhain ] || sed -i 's/A+50/A50/' lean.$control
	status 3 "$control: a holder that leans into the part" \
		ncverify -g dome.xyz -r 6 -e 0.005 -m $machine --holder 6:2+20:30 lean.$control
	has "$control: is named with its depth" \
		'^ncverify: .*N120[234]0? .*: the holder goes [0-9.]+ mm deep into the part at' err
done
# The same tool as files: its ball, its flute, and a holder where --holder has one.
printf 'radius = 6\nflute = 8\nshank = 6\nlength = 60\nstickout = 8\n' >cutter.txt
echo 'holder = 20:30' >collar.txt
sed '/^N12030 /s/A[0-9.]*/A50./' dome.fanuc >lean.nc
status 3 "a tool of files" ncverify -g dome.xyz -e 0.005 --tool-file cutter.txt --tool-file collar.txt lean.nc
has "its holder is judged" 'N120[234]0? .*: the holder goes [0-9.]+ mm deep into the part at' err
status 0 "the cutter alone is clear" ncverify -q -g dome.xyz -e 0.005 --tool-file cutter.txt dome.fanuc
status 2 "a cutter of another ball" ncverify -q -g dome.xyz -r 5 --tool-file cutter.txt dome.fanuc
status 1 "a tool that is not there" ncverify -q -g dome.xyz -r 6 --tool-file nowhere dome.fanuc
status 2 "a tool and the ball alone" ncverify -q -g dome.xyz --ball-only --tool-file cutter.txt dome.fanuc
sed '/^N12470 /s/Z.*/Z30. A85./' dome.fanuc >lean.nc
status 3 "a holder in a rapid move" ncverify -g dome.xyz -r 6 -e 0.005 --holder 3:10+25:30 lean.nc
has "is named" 'N124[78]0 .*the holder goes .*in a rapid move' err
# ---- what the head says: the ball, and the machine
ncpost -q -c haas -m table-bc "$SRC/tests/data/golden/shapes.cl" -o haas.nc
has "a program's head says its control" '^.CONTROL: HAAS.$' haas.nc
has "and its machine" '^.MACHINE: TABLE-BC.$' haas.nc
ncverify -v -g dome.xyz haas.nc >out 2>err
has "which ncverify takes" 'machine: table-bc .as the program.s head says' err
has "and judges on" '^machine +Table-table B/C' out
hasnt "with the words of that control" 'not known here' err
status 1 "-m contradicts it" ncverify -q -g dome.xyz -m table-ac haas.nc
ncverify -g dome.xyz -m table-ac haas.nc 2>err
has "which is told" 'head says the machine TABLE-BC, not table-ac .-m' err
ncverify -g dome.xyz -c fanuc haas.nc >out 2>err
has "and so is another control" 'head says the control HAAS, it is read as one for fanuc' err
sed 's/TABLE-BC/NO-SUCH/' haas.nc >none.nc
ncverify -g dome.xyz none.nc >out 2>err
has "a machine that is not here is told" 'head says no-such, and there is no such file here' err
ok "ncplot takes the head's machine" ncplot -o haas.svg haas.nc
ncplot haas.nc -o haas.svg 2>err
empty "and the control's words" err
status 1 "ncplot with another machine" ncplot -m table-ac -o haas.svg haas.nc
has "says what the head says" 'head says the machine TABLE-BC, it is drawn on table-ac' err
printf '0 -1 0 5\n1 0 0 7\n0 0 1 -3\n0 0 0 1\n' >matrix.txt
cloud2mesh -q -t 40 -u inch --matrix matrix.txt little.xyz |
	meshnorm -q -r 60 --scallop 4 >placed.cl
for control in siemens fanuc; do
	ncpost -q -c $control placed.cl -o placed.nc
	has "$control: the head says how the scan was placed" 'PLACE1: 0 -25.4 0 5' placed.nc
	status 0 "ncverify places it" ncverify -v -g little.xyz placed.nc
	has "which it says" 'little.xyz: placed as the program.s head says' err
done
head -n 1000 little.xyz >fewer.xyz
ncverify -v -g fewer.xyz placed.nc >out 2>err
hasnt "not a scan of other points" 'placed as' err
has "which is said" '1000 points, none of the scan that .* places: taken in mm' err
sed -n '1001,$p' little.xyz >rest.xyz
cloud2mesh -q -t 40 -u inch --matrix matrix.txt fewer.xyz rest.xyz |
	meshnorm -q -r 60 --scallop 4 | ncpost -q -c fanuc -o two.nc
status 0 "each file of a scan of two is placed" ncverify -g fewer.xyz -g rest.xyz two.nc
status 0 "and both in one" ncverify -g little.xyz two.nc
ncpost -q -c siemens --set x.max=900 "$SRC/tests/data/golden/shapes.cl" -o set.mpf
has "keys of --set are in the head" '^; SET: x.max=900$' set.mpf
ncverify -g dome.xyz set.mpf >out 2>err
has "ncverify asks for them" 'made with --set x.max=900' err
ncverify -g dome.xyz --set x.max=900 set.mpf >out 2>err
hasnt "unless it has them" 'made with --set' err

awk 'NR == 2 { print; print "(TOOL: BALL R6 FLUTE 24)"
	print "(cloudmill ncpost for Fanuc, Fork head C/A)"; print "(COOLANT: NONE)"; next } { print }' \
	dome.fanuc >said.nc
ncverify -g dome.xyz -r 6 -c fanuc dome.fanuc >given
status 0 "the radius is the head's" ncverify -v -g dome.xyz -c fanuc said.nc
has "which is told" 'ball: R 6 .as the program.s head says' err
has "another machine is told, with how to give it" \
	'head says the machine Fork head C/A, it is judged on Table-table A/C .-m' err
grep '^gouge .*worst' given >given.gouge
grep '^gouge .*worst' out >out.gouge
same "the figures are the same" given.gouge out.gouge
status 0 "the machine that it says" ncverify -g dome.xyz -c fanuc --set 'name=FORK HEAD C/A' said.nc
hasnt "nothing is told" 'head says the machine' err
status 3 "another ball is refused" ncverify -g dome.xyz -r 5 -c fanuc said.nc
has "and told" 'head says a ball of radius 6, it is judged with 5' err
status 2 "no radius anywhere" ncverify -g dome.xyz -c fanuc dome.fanuc
has "what is expected" 'expected -r, the radius of the ball' err

status 2 "a holder of nothing" ncverify -g dome.xyz -r 6 --holder 3:0 dome.fanuc

# ---- the stock: passes, layers, bites, what is left, by the formulas of a sphere and of planes
# Flat: z = 0 over 40 x 20; grooves by a ball of R 5, first 1 deep, then 2.5, in the same place.
awk 'BEGIN { for (y = -10; y <= 10; y += 0.5) for (x = -20; x <= 20; x += 0.5) print x, y, -3 }' >flat.xyz
groove() { # Y...: passes along x; depth 1 and then 2.5 at each
	echo %; echo 'O0001'; echo 'N1 G90 G17 G21 G40 G49 G80 G94 G54'; echo 'N2 G53 G0 Z0.'
	echo 'N3 T1 M6'; echo 'N4 S8000 M3'; echo 'N5 G0 A0. C0.'; echo 'N6 G43.4 H1'
	n=7
	for y; do
		for z in -1. -2.5; do
			echo "N$n G0 X-30. Y$y Z20."; echo "N$((n + 1)) G1 Z$z F500."; echo "N$((n + 2)) X30."
			echo "N$((n + 3)) G0 Z20."; n=$((n + 4))
		done
	done
	echo "N$n G49"; echo "N$((n + 1)) G53 G0 Z0."; echo "N$((n + 2)) M5"; echo "N$((n + 3)) M30"; echo %
}
groove 0. >groove.nc
ncverify -q -g flat.xyz -r 5 --stock box:-20,-10,-8,20,10,0 --cell 0.1 groove.nc >out
# 40 (R^2 acos((R - d) / R) - (R - d) sqrt(2 R d - d^2)): 163.50 and 614.18
has "the first groove takes off what it must" 'cut 1, N8 .*: 163\.[45][0-9]* mm3 off, bite (0\.999|1\.000)' out
has "the second the rest of it" 'cut 2, N12 .*: 450\.[67][0-9]* mm3 off, bite 1\.[45][0-9]* mm' out
has "the way down is air" 'air in 1 of 2 blocks' out
has "what is left beside them" '^stock        left 3\.0000 mm \(50% 3\.0000' out
has "volumes add up" '^stock        6400\.0 mm3, 5785\.8 left' out
sed '/^N14 /s/.*/N14 G0 X-30.\
Y2.\
X30./' groove.nc >rapid.nc
status 3 "a rapid move through what is left" \
	ncverify -g flat.xyz -r 5 --stock box:-20,-10,-8,20,10,0 rapid.nc
has "is named, the one in the groove is not" \
	'^ncverify: rapid.nc: line 18: a rapid move goes [0-9.]+ mm deep into the stock.*blocks: 1' err
# The dome under 2 mm of stock: a layer 1 mm off it leaves 1 mm, the last one its scallops.
for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-iso
	dome $control -1 >layer.$control
	ncverify -q -g dome.xyz -r 6 --band 2 -m $machine --stock offset,2 layer.$control >out
	left=$(sed -n 's/^stock *left.*(50% \([0-9.]*\).*/\1/p' out)
	below "$control: a layer leaves what it is to leave" "$left" 1.02
	below "$control: and no less" 1 "$left"
done
ncverify -q -g dome.xyz -r 6 --stock offset,0.5 dome.fanuc >out
bite=$(sed -n 's/^stock *cut 1,.*bite \([0-9.]*\).*/\1/p' out)
below "a pass takes the layer off" "$bite" 0.53
below "all of it" 0.47 "$bite"
status 3 "a rapid move through the stock" ncverify -g dome.xyz -r 6 --stock box,20 dome.fanuc
has "is named" 'N[0-9]+ .*a rapid move goes [0-9.]+ mm deep into the stock at' err
status 3 "a holder that runs into the stock" \
	ncverify -g dome.xyz -r 6 --stock offset,8 --cell 0.4 --holder 6:2+12:20 dome.fanuc
has "is named too" 'N[0-9]+ .*the holder goes [0-9.]+ mm deep into the stock at' err
status 2 "a stock that is none" ncverify -g dome.xyz -r 6 --stock sphere dome.fanuc

# ---- what it is judged by: a mesh, surfaces; the map and the page

# A quarter of the sample's surface, up to half of both its parameters.
sed 's/^1\.,0\.,1\.;/.5,0.,.5;/' "$SRC/samples/paper2_s1_a.igs" >s1.igs
nurbs2mesh -q -n 30 -o s1.ply s1.igs
planecut -q -r 4 -s 2 s1.ply | ncpost -q -c siemens -o s1.mpf
status 0 "judged by the surfaces of an IGES file" \
	ncverify -q -g s1.igs -r 4 -e 0.2 s1.mpf
depth=$(sed -n 's/^gouge *worst \([0-9.]*\).*/\1/p' out)
below "and the path of its mesh lies on them" "$depth" 0.03
status 0 "judged by a mesh" ncverify -q -g s1.ply -r 4 -e 0.1 s1.mpf
status 3 "a ball that is too large for the program" \
	ncverify -q -g s1.ply -r 8 -e 0.03 s1.mpf

sed "/^N12030 /s/Z[-0-9.]*/Z$deeper/" dome.fanuc >bad.nc
ncverify -q -g dome.xyz -r 6 -e 0.005 --map map.ply --report page.html bad.nc >out 2>err
has "the map holds every point" '^element vertex 5551$' map.ply
has "MeshLab finds the deviation" '^property float quality$' map.ply
has "and CloudCompare" '^property float scalar_deviation$' map.ply
fails "which is the same three times" \
	awk 'on && ($7 != $9 || $7 != $10) { bad = 1 } /^end_header/ { on = 1 } END { exit !bad }' map.ply
worst=$(awk 'on && $7 < least { least = $7; block = $8 } /^end_header/ { on = 1 }
	END { print block }' map.ply)
ok "and the deepest names its block" test "$worst" -ge 12020 -a "$worst" -le 12040
ok "the map is a PLY that is read" ncverify -q -g map.ply -r 6 -e 0.005 dome.fanuc
has "the page names the block" '<button .*N120[2-4]0 \(line [0-9]*\), cut 10: gouge 0\.0' page.html
hasnt "and loads nothing" '(src|href)=|https?:|import|fetch\(|url\(' page.html
has "it is whole" '^</body></html>$' page.html
ncverify -q -j1 -g dome.xyz -r 6 -e 0.005 --report one.html bad.nc >one 2>/dev/null
ncverify -q -j4 -g dome.xyz -r 6 -e 0.005 --report four.html bad.nc >four 2>/dev/null
same "threads change nothing" one four
same "nor in the page" one.html four.html

# ---- points 10 mm apart, between which a ball of 30 that touches is as far off them as one above it

awk 'BEGIN { for (i = -12; i <= 12; i++) for (j = -12; j <= 12; j++) {
	x = 10 * i + (j % 2 ? 3 : 0); y = 10 * j
	printf "%.3f %.3f %.3f\n", x, y, -(x * x + y * y) / 800 } }' >far.xyz
cloud2mesh -q far.xyz | meshnorm -q -r 30 --avoid -g far.xyz | ncpost -q -c fanuc -o far.nc
status 0 "a rapid move ends over points far apart" ncverify -q -g far.xyz far.nc
sed '/G1 .*F400/{s/G1 /G0 /;s/F400[.]*//;n;s/ / G1 /;}' far.nc >plunge.nc
status 3 "but none on them" ncverify -q -g far.xyz plunge.nc
has "which is said" 'a rapid move ends on the part' out

status 2 "no radius" ncverify -g dome.xyz dome.fanuc
status 1 "no such scan" ncverify -g nothing.xyz -r 6 dome.fanuc
status 1 "no program" ncverify -g dome.xyz -r 6 dome.xyz

done_testing

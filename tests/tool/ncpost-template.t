#!/bin/sh
# ncpost-template.t - control files: found like machine files, the built-in ones among them, each
# maker's first and last blocks as its file has them, wrong files refused with their line.
# shellcheck disable=SC2016 # backquotes of messages
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

cat >five.cl <<'END'
PARTNO/BLADE 7
UNITS/MM
MULTAX/ON
CUTTER/10.0,5.0,0,5.0,0,0,60.0
LOADTL/7
SPINDL/RPM,8000,CLW
COOLNT/ON
RAPID
GOTO/0,0,50,0,0,1
FEDRAT/MMPM,800
GOTO/0,0,5,0.1,0,0.99498743710662
DELAY/1.5
GOTO/10,0,4,0.2,0,0.97979589711327
RAPID
GOTO/10,0,50,0.2,0,0.97979589711327
FINI
END
sed 's/,0.1,0,0.9949.*/,0,0,1/;s/,0.2,0,0.979.*/,0,0,1/' five.cl >three.cl
nameless() { # DESCRIPTION FILE FILE: the same but for the names that control and machine were given by
	sed -E '/[;( ](CONTROL|MACHINE): /d' "$2" >"$TMP/nameless" && sed -E '/[;( ](CONTROL|MACHINE): /d' "$3" >"$TMP/nameless-2"
	same "$1" "$TMP/nameless" "$TMP/nameless-2"
}
blocks() { sed 's/^N[0-9]* //' "$1"; }

# ---- the built-in controls are files like any other

for control in fanuc siemens heidenhain linuxcnc; do
	cp "$SRC/controls/$control.txt" "my-$control.txt"
	ncpost -q -c "$control" -o want five.cl
	status 0 "$control: a copy of its file" ncpost -q -c "my-$control" -o got five.cl
	nameless "$control: writes the same program" want got
done

# ---- found by name, file, folder and machine

mkdir folder
printf 'base = haas\ntitle = Shop A\n' >folder/shop-a.txt
status 0 "in \$CLOUDMILL_CONTROLS" env CLOUDMILL_CONTROLS=folder ncpost -q -c shop-a -o a.nc five.cl
has "with its title" 'NCPOST FOR SHOP A' a.nc
status 0 "as a file" ncpost -q -c folder/shop-a.txt -o b.nc five.cl
nameless "the same" a.nc b.nc
printf 'include = table-ac\ncontrol = ./folder/shop-a.txt\n' >mill.txt
status 0 "named by a machine" ncpost -q -m mill -o c.nc five.cl
nameless "the same" a.nc c.nc
printf 'base = ../folder/shop-a.txt\ntitle = Shop B\n' >folder/shop-b.txt
status 0 "a base is searched for beside its file" ncpost -q -c folder/shop-b.txt -o b.nc five.cl
has "and has its own title" 'NCPOST FOR SHOP B' b.nc
status 2 "no such control" ncpost -c shop-x five.cl
has "told with the list" 'found `shop-x`, expected fanuc\|siemens\|heidenhain\|linuxcnc or a control file' err
status 0 "the installed ones" ncpost -q -c okuma -o o.nc five.cl

# ---- keys are defaults: machine and --set override them

printf 'base = fanuc\nnumber.step = 5\nnumber = N{n:5}\ndigits.linear = 5\nhome = G53 Z0.\n' >own.txt
ncpost -q -c own -o own.nc five.cl
has "number with zeros" '^N00005 G90' own.nc
has "the step" '^N00010 ' own.nc
has "home" '^N[0-9]* G53 Z0\.$' own.nc
printf 'include = table-ac\nhome = G28 Z0.\n' >mill.txt
ncpost -q -c own -m mill --set number.step=20 -o own.nc five.cl
has "the machine's home" '^N[0-9]* G28 Z0\.$' own.nc
has "the option's step" '^N00020 G90' own.nc

# ---- every part of a program

cat >all.txt <<'END'
base = fanuc
title = All
comment = <{text}>
comment.capitals = no
comment.width = 40
point = no
tool.change = T{tool:3} M6 (H{offset:2})
[start]
{line}PROGRAM {program:6} {name}     # no number
{head}
{?mm}UNITS MM
{?inch}UNITS INCH
SMOOTH {level} {tolerance} {orientation}
{work} HASH{hash}1
[tool]
{tool.change}
{?rpm}{?!ccw}SPIN {rpm}
{?rpm}{?ccw}SPIN -{rpm}
[approach]
{rapid} {X} {Y} {Z}
{?tcp}TIP ON
{?!tcp}TIP NONE
[retract]
{?tcp}TIP OFF
UP {home}
[change]
[end]
BYE
END
ncpost -q -c all --program 42 -o all.nc five.cl
ok "the first line" test "$(sed -n 1p all.nc)" = 'PROGRAM 000042 42'
has "its comments" '^<BLADE 7>$' all.nc
hasnt "none too long" '^<.{40,}' all.nc
blocks all.nc | grep -v '^<' >got
cat >want <<'END'
PROGRAM 000042 42
UNITS MM
SMOOTH 9 0.002 0.05
G54 HASH#1
T007 M6 (H07)
SPIN 8000
G0 X0 Y0 Z50
TIP ON
END
head -n 8 got >first
same "start, tool and approach" want first
printf 'TIP OFF\nUP G91 G28 Z0.\nG90\nBYE\n' >want
tail -n 4 got >last
same "retract and end" want last
ncpost -q -c all --inch -o all.nc five.cl
has "inches" 'UNITS INCH' all.nc
sed 's/CLW/CCLW/' five.cl >ccw.cl
ncpost -q -c all -m table-ac-notcp -o all.nc ccw.cl
has "counter-clockwise" 'SPIN -8000' all.nc
has "without tool-centre-point control" 'TIP NONE' all.nc
hasnt "and no word of it" 'TIP O' all.nc

printf 'base = fanuc\n[approach]\n{rapid} {X.above} {Y.above}\nG43 H1 {Z}\n' >above.txt
status 0 "the place above a plane is the first place where there is none" ncpost -q -c above -o all.nc five.cl
has "as it is" '^N[0-9]* G0 X0\. Y0\.$' all.nc

# ---- the makers: first and last blocks, length, dwell

maker() { # CONTROL MACHINE CL "BLOCKS THAT STAND IN IT IN THIS ORDER, | BETWEEN"
	ncpost -q -c "$1" -m "$2" -o part.nc "$3" || { result 1 "$1: is written" && return; }
	blocks part.nc | awk -v want="$4" 'BEGIN { n = split(want, w, "|"); k = 1 }
		$0 == w[k] { k++ } END { if (k <= n) { print "no block " w[k]; exit 1 } }' >err
	result $? "$1: $4"
}
maker haas table-bc five.cl '%|O00001|G53 G0 Z0.|T7 M6|S8000 M3|G234 H7|G4 X1.5|G49|G53 G0 Z0.|M30|%'
maker mazak table-ac five.cl '%|O0001|T7 M6|G43.4 H7|M30|%'
maker okuma table-ac five.cl 'O0001|G90 G17 G21 G40 G80 G94 G15 H1|G30 P1|G169 Z50. H7|G4 F1.5|G170|G30 P1|M2'
maker okuma three-axis three.cl 'G56 H7 Z50.|G53|G30 P1|M2'
maker fagor table-ac five.cl '%PART1|G90 G17 G71 G40 G94 G54|#MCS ON|G0 Z0.|#MCS OFF|T7 D7 M6|#RTCP ON|G4 K1.5|#RTCP OFF|M30'
maker hurco three-axis three.cl '%|O0001|G53 G0 Z0.|G43 H7 Z50.|G49|M30|%'
maker mach3 three-axis three.cl '%|G61|T7 M6|G43 H7 Z50.|G4 P1.5|G49|M2|%'
fails "mach3: no vectors" ncpost -c mach3 -m table-ac --vectors -o none.nc three.cl
has "by its own name" 'found --vectors, which Mach3 does not know' "$TMP/err"
maker grbl three-axis three.cl 'G90 G91.1 G17 G21 G40 G49 G80 G94 G54|G61|G53 G0 Z0.|T7|M0|S8000 M3|G4 P1.5|M2'
maker tormach three-axis three.cl '%|T7 M6|G43 H7 Z50.|M2|%'
ncpost -q -c heidenhain-530 -o part.h five.cl
has "heidenhain-530: M128" '^[0-9]+ M128$' part.h
has "heidenhain-530: M129" '^[0-9]+ M129$' part.h
hasnt "heidenhain-530: no FUNCTION" 'FUNCTION' part.h
ncpost -q -c grbl -m three-axis -o part.nc three.cl
hasnt "grbl: no % and no number" '^(%|N)' part.nc
hasnt "grbl: no line of more than 80 characters" '.{81}' part.nc
ncpost -q -c hurco -o part.nc five.cl
hasnt "hurco: no tool-centre-point control on five axes" 'G43\.[45]' part.nc
status 2 "haas: tilts no plane" ncpost -q -c haas --plane three.cl
for maker in haas fagor hurco okuma; do
	status 2 "$maker: no axis as a vector" ncpost -q -c $maker --vectors five.cl
done
status 0 "mazak: an axis as a vector" ncpost -q -c mazak --vectors -o o.nc five.cl
makers=$(find "$SRC/controls" -name '*.txt' | wc -l)
ok "eight makers and the four built-in controls" test "$makers" -ge 12
for file in "$SRC"/controls/*.txt; do
	has "$(basename "$file"): says where its words come from" '^# .*(manual|Manual|B-[0-9]+|G-Codes|wiki|lists?)' "$file"
done

# ---- wrong files: exit 1, one line with the file and its line, no output

wrong() { # DESC LINE REGEX <text
	cat >bad.txt
	rm -f part.nc
	status 1 "$1: refused" ncpost -q -c bad -o part.nc five.cl
	has "$1: told" "^ncpost: (\./)*bad.txt:$2: .*$3" err
	ok "$1: in one line, and nothing is written" test "$(wc -l <err)" -eq 1 -a ! -e part.nc
}
printf 'base = fanuc\n[end]\nM30\n{line%%\n' | wrong "a brace that does not end" 4 'expected } after it'
printf 'base = fanuc\n\n[tool]\nT{tol} M6\n' | wrong "an unknown field" 4 'found `\{tol\}`, expected'
printf 'base = fanuc\n[start]\nO{program:99}\n' | wrong "a huge width" 3 'width of 1 to 20'
printf 'base = fanuc\nhome = {home}\n' | wrong "a key within itself" 2 'found `\{home\}`'
printf 'base = fanuc\n[start]\n{start} {home}\n' | wrong "blocks side by side" 3 'alone in its line'
printf 'base = ./bad.txt\n' | wrong "a base of itself" 1 'no file to include itself'
printf 'base = fanuc\n[starts]\n' | wrong "an unknown section" 2 '\[start\]'
printf 'base = fanuc\n[end]\nM30\n[end]\nM2\n' | wrong "a section twice" 4 'again'
printf 'base = nowhere\n' | wrong "an unknown base" 1 'not found'
printf 'base = fanuc\nfrob = 1\n' | wrong "an unknown key" 2 'frob'
printf 'base = fanuc\ntitle = A\ntitle = B\n' | wrong "a key twice" 3 'again'
printf 'base = fanuc\n[end]\nM\0030\n' | wrong "a binary character" 3 'binary'
printf 'title = A\n[end]\nM30\n' >bad.txt
status 1 "no base: refused" ncpost -q -c bad five.cl
has "no base: told" 'bad.txt: found no base' err

# ---- clamps: open before a tilted plane is turned to or left, closed when it stands
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/10,5\nLOADTL/1\nSPINDL/900"
	for (i = 0; i < 3; i++) { a = i ? 0.6 : 0; c = i ? 0.8 : 1
		printf "RAPID\nGOTO/%d,0,60,0,%g,%g\nFEDRAT/MMPM,300\nGOTO/%d,0,0,0,%g,%g\nRAPID\nGOTO/%d,0,60,0,%g,%g\n",
			i, a, c, i, a, c, i, a, c }
	print "FINI" }' >planes.cl
for c in fanuc siemens heidenhain; do
	ncpost -q -c $c --plane --set 'clamp.on=M10|M12' --set 'clamp.off=M11|M13' -o clamp.nc planes.cl
	sed '/SET: /d' clamp.nc | grep -o 'M1[0123]$\|G53\.1\|G69\|CYCLE800(.*)\|PLANE [SR].*\| G1 \| L .* F300' | sed '/STAY/d
		s/CYCLE800(0.*/on/; s/CYCLE800()/off/; s/PLANE S.*/on/; s/PLANE R.*/off/; s/G53.*/on/; s/G69/off/; s/ L .*/cut/; s/ G1 /cut/' |
		awk 'NR == 1 && /off/ { next } { printf "%s ", $0 } END { print "" }' >order
	has "$c: each turn between open and closed, cuts are closed" \
		'^M11 M13 on M10 M12 cut M11 M13 off M11 M13 on M10 M12 (cut )+M11 M13 off $' order
	hasnt "$c: none with tool-centre-point control" 'M1[0123]' "$(ncpost -q -c $c --set clamp.on=M10 \
		--set clamp.off=M11 planes.cl | sed "/SET: /d" >tcp.nc; echo tcp.nc)"
done
status 2 "a clamp's blocks are checked" ncpost -c fanuc --set 'clamp.on={nonsense}' planes.cl
has "and named" 'clamp.on.*nonsense' err


# A parameter of the control in a block: # alone would start a comment
printf 'GOTO/0,0,9\nFEDRAT/100\nGOTO/0,0,8\nFINI\n' >short.cl
printf 'include = table-ac # as it comes\nstart = {hash}500=1 #a note\n' >par.txt
status 0 "start = {hash}500=1" ncpost --no-spindle -q -c fanuc -m ./par.txt short.cl
has "is the block #500=1" '^N[0-9]+ #500=1$' out
for bad in 'start = #500=1' 'start = G65 #[1]' 'x.max = 100 #2nd'; do
	printf 'include = table-ac\n%s\n' "$bad" >par.txt
	status 1 "$bad is refused" ncpost --no-spindle -q -c fanuc -m ./par.txt short.cl
	has "and says what to write" 'par.txt:2: found # before a digit or \[, expected \{hash\}' err
done
printf 'base = fanuc\n[start]\n#500=1\n' >par.txt
status 1 "nor in a section" ncpost --no-spindle -q -c ./par.txt short.cl
status 2 "nor with --set" ncpost --no-spindle -q -c fanuc --set 'start=#500=1' short.cl
printf '#500 is ours\ninclude = table-ac\n' >par.txt
status 0 "a line of comment may begin so" ncpost --no-spindle -q -c fanuc -m ./par.txt short.cl
done_testing

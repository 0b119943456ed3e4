#!/bin/sh
# ncverify-words.t - what is accepted has no word that is not known to do nothing to the path: each
# control's G words, M words of the control itself, corners that are rounded, Z without the tool's
# length or of the machine.  Each is put amid an accepted program, with its head and without.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (j = 0; j <= 12; j++) for (i = 0; i <= 18; i++) { x = i * .5; y = j * .5
	printf "%.4f %.4f %.4f\n", x, y, 20 + sin(x / 3) + 0.8 * cos(y / 3) } }' >s.xyz
cloud2mesh -q -o s.ply s.xyz
meshnorm -q -r 5 --scallop 0.3 --avoid -o five.cl s.ply
meshnorm -q -r 5 --scallop 0.3 --avoid --fixed 0,0,1 -o three.cl s.ply

control() { # NAME: own.nc, its program, and other.nc, the same without its head
	control=$1
	machine=table-ac path=five.cl
	case $1 in
	grbl | mach3 | tormach) machine=three-axis path=three.cl ;;
	linuxcnc) machine=linuxcnc-xyzac ;;
	esac
	ncpost -q -c "$1" -m $machine -o own.nc $path
	grep -vE '^([0-9]+ )?[(;]' own.nc >other.nc
}
amid() { # BLOCKS, with | between them, in the middle of own.nc and other.nc: bad.own, bad.other
	for from in own other; do
		n=$(($(wc -l <$from.nc) / 2))
		awk -v n=$n -v text="$1" -v klartext="${control%%-*}" '
			klartext == "heidenhain" { klartext = 1 } { print }
			NR == n { k = split(text, line, "|")
				for (i = 1; i <= k; i++) print (klartext == 1 ? "0 " : "") line[i] }' $from.nc |
			awk -v klartext="${control%%-*}" '
				klartext == "heidenhain" { sub(/^[0-9]+ /, NR - 1 " ") }
				{ print }' >bad.$from
	done
}
judge() { # STATUS FROM DESC [OPTIONS]: bad.FROM
	want=$1 from=$2 desc=$3
	shift 3
	status "$want" "$control, $from: $desc" \
		ncverify -c "$control" -m $machine -g s.xyz -r 5 -e 0.02 "$@" bad.$from
}
refused() { # BLOCKS REGEX: not read, with the head and without
	amid "$1"
	for from in own other; do
		judge 1 $from "$1"
		has "... is told" "$2" err
	done
}
taken() { # BLOCKS: accepted, and no word of it
	amid "$1"
	for from in own other; do
		judge 0 $from "$1"
		hasnt "... and nothing is told" 'not known|notice' err
	done
}
others() { # STATUS BLOCKS REGEX: of a program without a head
	amid "$2"
	judge "$1" other "$2"
	has "... is told" "$3" err
}

# ---- G words

control fanuc
for g in G11 G122.1 G151 G54.2 G54.4 G61.2 G200 G333 G49.1 G13 G22; do
	refused $g "bad.[a-z]*:[0-9]*: .*found $g, "
done
for g in G15 G61.1 G62 G63 G23 'G8 P1' 'G4 P100' 'G4 X0.5' G69 G67 G80; do
	taken "$g"
done
amid 'G4 P100 G91' # which counts
for from in own other; do
	judge 3 $from "G4 P100 G91"
done
refused 'G4 P100 G65 P1' 'G65, a macro'
refused 'G4 P100 Y5.' 'found Y5, which'
refused 'G50.1 X0.' 'G50.1 with a place'
refused 'G49|G68.2 P1 X0. Y0. Z0. I0. J0. K0.' 'found P1, which'
refused R5. 'I, J, K or R without an arc'
refused O0002 'another program begins'
refused % 'found `%`'
sed 's/ G80 / G69 G80 /' other.nc >bad.other
judge 0 other "G69 beside G90"
control okuma
for g in G11 'G28 Z0.' G54 G55 G59 G62 'G43 H1' G49 G103 G154 G187 G5 'G81 Z1. R9.' G98; do
	refused "$g" "found ${g%% *}, which"
done
taken 'G4 F0.5'
sed 's/G30 P1/G30 P3/' own.nc >bad.own
judge 3 own "G30 P3"
has "... is told" 'goes to reference point P3, which is not home' err
control fagor
for g in G5 G9 G11 G12 G20 G151 G152 G53 'G28 Z0.' G93 G154 G61; do
	refused "$g" "found ${g%% *}, which"
done
taken G7
taken 'G4 K0.5'
control mazak
for g in G122.1 G10.9 G61.2 G110; do
	refused $g "found $g, "
done
control haas
for g in G160 G200 G11; do
	refused $g "found $g, which"
done
taken G255
taken G103
control hurco
refused G200 'found G200, which'
control linuxcnc
for g in G9 G15 G69 G187 G154 G103 G7 G8; do
	refused $g "found $g, "
done
for m in M70 M71 M72 M73; do
	refused $m "found $m, which"
done
refused 'G1 O5' 'found O5, which'
refused R5. 'without an arc'
refused G80 'a place before G0 or G1'
control grbl
for g in G64 G43 G69 G81; do
	refused $g "found $g, which"
done
control mach3
for g in G15 G50 G69; do
	taken $g
done
refused G16 'polar'
control tormach
refused G47 'found G47, '

# ---- Siemens

control siemens
refused 'TRAORI(2)' 'found TRAORI, which'
amid G18
judge 3 own G18
has "... is told" "G18 may put the tool's length along Y" err
others 0 G18 "notice: .*G18 may put the tool's length along Y"
refused 'FGROUP(A,C)' 'FGROUP without X, Y and Z'
taken 'FGROUP(X,Y,Z,A,C)'
taken 'FGROUP()'
refused ORIRESET 'found ORIRESET, which'
refused 'G4 F1 G91' 'G4 with other words'
refused 'G4 F1 TRAFOOF' 'G4 with other words'
refused I5 'without an arc'
refused CR=5 'without an arc'
refused A30 'an axis that is not known'
refused 'TRAFOOF|CYCLE800(0,"",0,57,0,0,0,5,0,0,1,0,0,1,0,1)' 'CYCLE800 with a shift'
sed 's/TRAORI$/TRAORI(1)/' other.nc >bad.other
judge 0 other "TRAORI(1)"

# ---- Klartext: cycles that wait for a call, M words of the control itself

control heidenhain
refused 'CYCL CALL' 'CYCL CALL, which'
for cycle in '1.0 PECKING' '4.0 POCKET' '13.0 ORIENTATION' '204 BACK BORING' '251 POCKET'; do
	refused "CYCL DEF $cycle" 'a cycle which'
done
for m in M89 M90 M97 M101 M104 M118 M120 M130 M144 M145; do
	refused $m "found $m, "
done
for m in M94 M107 M117 M126 M137 M148; do
	taken $m
done
refused M99 'M99 without a cycle'
refused 'STOP M5' 'cuts while the spindle is off'
refused 'TOOL CALL' 'TOOL CALL or TOOL DEF without'
taken STOP

# ---- a pallet, and a tool that is changed where nobody knows

control haas
amid M60
judge 3 own "M60"
has "... is told" 'the pallet changes amid the program' err
others 0 M60 'notice: .*the pallet changes amid the program'
control fanuc
refused M6 'cuts from a place'

# ---- how far corners may be rounded, in a program of others: against -e, else it is told

corners() { # BLOCK LENGTH
	amid "$1"
	judge 3 other "$1"
	has "... is told" "corners may be rounded by $2, expected 0.02 mm at most" err
	hasnt "... and known" 'not known' err
	status 0 "$control: $1 without -e" \
		ncverify -c "$control" -m $machine -g s.xyz -r 5 bad.other
	has "... is told" "notice: .*corners may be rounded by $2\$" err
	hasnt "... and known" 'not known' err
	status 3 "$control: $1 with -p" \
		ncverify -c "$control" -m $machine -g s.xyz -r 5 -p $path bad.other
	has "... is told" "corners may be rounded by $2, expected 0.05 mm at most" err
}
control siemens
for block in 'G641 ADIS=5' 'CTOL=5' 'CYCLE832(5,11,0.1)' 'COMPCAD CTOL=5'; do
	corners "$block" '5 mm'
done
taken 'G641 ADIS=0.001'
for word in G642 G645 COMPCAD; do
	others 0 $word "notice: .*as the machine's data say .$word., which are not known"
done
for block in OTOL=10 'CYCLE832(0.01,11,10)'; do
	others 0 "$block" 'notice: .*the axis may turn 10 degrees off'
done
control heidenhain
corners 'CYCL DEF 32.0 TOLERANCE|CYCL DEF 32.1 T2' '2 mm'
others 0 'CYCL DEF 32.2 HSC-MODE:0 TA9' 'notice: .*the axis may turn 9 degrees off'
control linuxcnc
corners 'G64 P2' '2 mm'
corners 'G64' 'any length'
control haas
corners 'G187 P1 E2.' '2 mm'
control hurco
corners 'G64 P2.' '2 mm'
ncpost -q -c linuxcnc -m linuxcnc-xyzac --inch -o own.nc five.cl
grep -vE '^[(]' own.nc | sed 's/ G20 / G64 P0.2 G20 /;s/^\(N[0-9]* \)G64 P.*/\1M9/' >inch.nc
status 3 "inches in the block of G20" \
	ncverify -c linuxcnc -m linuxcnc-xyzac -g s.xyz -r 5 -e 0.02 inch.nc
has "... are told in mm" 'corners may be rounded by 5.08 mm' err

# ---- Z without the tool's length, which was on, and Z of the machine

awk 'BEGIN { for (y = 1; y <= 19; y++) for (x = 1; x <= 39; x++) print x, y, 0 }' >plane.xyz
plane() { # CONTROL END: rows over a plane, and how it ends
	printf '%s\n' % >plane.nc
	case $1 in fanuc) echo O0007 >>plane.nc ;; siemens | heidenhain) : >plane.nc ;; esac
	awk -v control="$1" -v end="$2" '
		function put(text) { print (control == "heidenhain" ? n++ " " : "") text }
		BEGIN { go = control == "heidenhain" ? "L " : ""; s = go ? "+" : ""
			if (control == "siemens") put("G17 G71 G40 G90 G54\nT1 D1\nM6\nS6000 M3\nG0 X0 Y0.5")
			else if (go) { put("BEGIN PGM P MM"); put("TOOL CALL 1 Z S6000"); put("M3")
				put("L X+0 Y+0.5 R0 FMAX") }
			else put("G17 G21 G40 G80 G90 G54\nT1 M6\nS6000 M3\nG0 X0. Y0.5\nG43 H1 Z60.")
			put(go "Z" s "60." (go ? " FMAX" : "")); put(go "Z" s "5." (go ? " FMAX" : ""))
			put((go ? go : "G1 ") "Z" s "0. F300")
			for (y = 0.5; y < 20; y++) { x = x ? 0 : 40
				put(go "Y" s y " F900"); put(go "X" s x (go ? "" : ".")) }
			k = split(end, line, "|"); for (i = 1; i <= k; i++) put(line[i])
			put("M5")
			put(control == "linuxcnc" ? "M2\n%" : "M30" (control == "fanuc" ? "\n%" : ""))
			if (go) put("END PGM P MM") }' >>plane.nc
}
ends() { # STATUS CONTROL END REGEX
	plane "$2" "$3"
	status "$1" "$2: $3" ncverify -c "$2" -m three-axis -g plane.xyz -r 5 --left 0.2 plane.nc
	if [ -n "$4" ]; then has "... is told" "$4" err; else empty "... nothing is told" err; fi
}
bare="without the tool's length, which was on before"
low='notice: .*Z goes to -400 of the machine, which is not known to be above the part'
for c in fanuc linuxcnc; do
	ends 0 $c 'G0 Z60.' ''
	ends 3 $c 'G0 Z60.|G49|G0 Z0.' "$bare"
	ends 3 $c 'G0 Z60.|G49 Z0.' "$bare"
	ends 3 $c 'G0 Z10.|G49|G0 Z30.' "Z goes at rapid to 30.000 $bare, the part's top is at 0.000"
	ends 0 $c 'G0 Z60.|G49|G0 Z100.' ''
	ends 0 $c 'G0 Z60.|G49|G0 X5.|G43 H1 Z10.|G1 Z0.|X10.|G0 Z60.' ''
	ends 0 $c 'G0 Z60.|G53 G0 Z-400.' "$low"
done
ends 0 linuxcnc 'G0 Z60.|G53 G0 Z0.|G53 G0 X0. Y0.' ''
ends 3 siemens 'G0 Z60|D0|G0 Z0' "$bare"
ends 3 siemens 'G0 Z60|G0 Z0 D0' "$bare"
ends 0 siemens 'G0 Z60|SUPA G0 Z0 D0' ''
ends 0 siemens 'G0 Z60|SUPA G0 Z-400 D0' "$low"
ends 3 heidenhain 'L Z+60 FMAX|TOOL CALL 0 Z|L Z+0 R0 FMAX' "$bare"
ends 0 heidenhain 'L Z+60 FMAX|L Z+0 R0 FMAX M91' ''
ends 0 heidenhain 'L Z+60 FMAX|L Z-400 R0 FMAX M91' "$low"
plane linuxcnc 'G0 Z60.|G53 G0 Z-400.'
status 0 "the machine's own way home" ncverify -c linuxcnc -m three-axis \
	--set 'home=G53 G0 Z-400.' -g plane.xyz -r 5 --left 0.2 plane.nc
empty "... is high" err

# ---- a program of ncpost that goes elsewhere than home; and home as it was told

control haas
sed 's/G53 G0 Z0\./G53 G0 Z-40./' own.nc >bad.own
judge 3 own "G53 G0 Z-40."
has "... is told" 'Z goes to -40 of the machine' err
ncpost -q -c haas -m table-ac --set 'home=G53 G0 Z-40.' -o bad.own five.cl
judge 0 own "home=G53 G0 Z-40., as its head says"

# ---- the first block home is lost in a program of ncpost: each control

for file in "$SRC"/controls/*.txt; do
	control "$(basename "$file" .txt)"
	n=$(grep -nE 'G28 Z0|G53 G0 Z0|G30 P1|SUPA G0 Z0|M91|G0 Z0\.' own.nc | grep -v '[(;]' |
		head -n 1 | cut -d: -f1)
	sed -E "${n}s/^(N?[0-9]+ )?.*/\1M9/" own.nc >bad.own
	judge 3 own "no way home"
done
done_testing

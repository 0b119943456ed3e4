#!/bin/sh
# ncverify-amid.t - one block more amid a cut of a good program: what moves the tool, shifts it, or
# stops, slows or turns round its spindle is refused; what does nothing is not.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (y = -5; y <= 5.001; y += 0.5) for (x = -7; x <= 7.001; x += 0.5)
	printf "%.5f %.5f %.5f\n", x, y, 20 - (x * x + y * y) / 80 }' >dome.xyz
cloud2mesh -q -t 1 -o dome.ply dome.xyz
meshnorm -q -r 6 --fixed 0,0,1 -o three.cl dome.ply

# The program with the block amid a row, blocks of Klartext numbered anew.
amid() { # BLOCK [COMMAND OF SED]
	awk -v put="$1" -v control="$control" '{ line[NR] = $0 }
	function cuts(i) { return line[i] ~ / [XY][-+0-9]/ && line[i] !~ / (G0?0|FMAX|M[0-9]+|SUPA)( |$)/ }
	END { for (at = int(NR / 2); !(cuts(at) && cuts(at + 1) && cuts(at + 2)); at++) ;
		for (i = 1; i <= NR; i++) {
			if (control ~ /heidenhain/) sub(/^[0-9]+/, n++, line[i])
			print line[i]
			if (i == at) print (control ~ /heidenhain/ ? n++ " " : "") put
		}
	}' good.nc | sed "${2:-}" >bad.nc
}
set=
judge() { # PROGRAM [OPTION]...
	ncverify -c "$control" -m three-axis ${set:+--set "$set"} -g dome.xyz -r 6 -e 0.1 "$@" >out 2>err
	got=$?
}
good() { # CONTROL: its program, accepted
	control=$1
	ncpost -q -c "$control" -m three-axis -o good.nc three.cl
	judge good.nc
	result $got "$control: the good program is accepted"
}
refused() { # BLOCK REGEX [COMMAND OF SED]
	amid "$1" "${3:-}"
	judge bad.nc
	case $got in
	1 | 3) result 0 "$control: $1 is refused" ;;
	*) result 1 "$control: $1 is refused ($got)" ;;
	esac
	has "$control: $1 is told" "$2" err
}
taken() { # BLOCK [COMMAND OF SED]
	amid "$1" "${2:-}"
	judge bad.nc
	result $got "$control: $1 is taken"
}
foreign='s/CLOUDMILL NCPOST/ANOTHER SYSTEM/; s/cloudmill ncpost/another system/'

# ---- ways to a stored place
for c in linuxcnc grbl tormach mach3; do
	good $c
	for block in G28 G30 G28.1 'G91 G28 Z0.' 'G30 P2'; do
		refused "$block" 'found G(28|30|28\.1), a way to a reference point'
	done
done
for c in fanuc haas; do
	good $c
	refused G30 'G28 or G30 without G91'
	refused G28 'G28 or G30 without G91'
	refused 'G91 G30' 'not known' "$foreign"
	refused 'G91 G30 P2 Z0' 'G91|not known|bad.nc'
done
good okuma
refused 'G30 P1' 'not known'

# ---- G that shift or turn the tool by numbers of their own, or none
for c in fanuc linuxcnc; do
	good $c
	for block in 'G43.1 H1' 'G43.2 H1' G45 G96 G53.5 G53.6 G10.6 G17.1; do
		refused "$block" "found ${block% *}, "
	done
done

# ---- another work offset
good fanuc
refused 'G54 P2' 'the work offset changes from 54 to 56.1 amid the program'
taken 'G54 G4 P2'
taken G54
good haas
for block in 'G154 P5' G110 G111 G114 G129 G55; do
	refused "$block" 'the work offset (changes|becomes).* amid the program'
done
for offset in 'G154 P5' G110; do
	ncpost -q -c haas -m three-axis --set "offset=$offset" -o good.nc three.cl
	set="offset=$offset"
	taken "$offset"
	refused 'G154 P6' 'the work offset changes amid the program'
done
set=
sed "s/ G43 H1 / G110&/; s/ G110\$//; $foreign" good.nc >other.nc
mv other.nc good.nc
taken G110 # H1 beside it is the tool's length

# ---- Siemens: what shifts the tool, or is not known to leave it where it is
good siemens
for name in TOFFL TOFF 'TOFFL[1]' 'TOFF[Z]' TOFFR TOFFLR TCARR DL 'OS[X]' 'OSP1[X]' 'OSP2[X]' \
	'OST1[X]' DISR DISCL \
	FB OMA1 CUTMOD 'FXS[X]' RNDX; do
	refused "$name=1" "found $(echo "$name" | tr '[]' '..'), which this reader does not know"
done
refused OVR=200 'found OVR, which'
for word in TCOFR G331 G332 G147 G148 G247 G58 G59 G153 G810 G961; do
	refused $word "found $word, which"
done
refused G33 'found G33, a skip'
refused M17 'a block after M30'
refused G75 'found G75, a cycle'
for block in LIMS=9000 'ACC[X]=80' OVR=90 'VELOLIM[X]=80' FAD=100 ADIS=0.001 H2=5 \
	S2=500 M2=3 S1=8000 S=8000 \
	M1=3 G450 G621 F=800 'CTOL=0.001'; do
	taken "$block"
done
refused M1=5 'cuts while the spindle is off'
refused F=0 'cuts without a feed'
printf 'base = siemens\nwords = SPECIAL: idle | G961: idle\n' >own.txt
control=own
taken SPECIAL=5
taken G961

# ---- the spindle
for c in fanuc haas okuma siemens linuxcnc heidenhain; do
	good $c
	refused M19 'cuts while the spindle is off'
	refused M4 'the spindle turns the other way amid the program, and cuts follow'
	taken M3
	taken M4 "$foreign"
	has "$c: is told of others" 'notice: .*the spindle turns the other way amid' err
	if [ $c = heidenhain ]; then call='TOOL CALL '; else call=; fi
	for speed in 50 100000; do
		refused "${call}S$speed" "the spindle's speed changes from 8000 to $speed amid the program"
	done
	taken "${call}S8000"
	refused "${call}S0" 'cuts at a speed of the spindle that is not above 0'
	refused "${call}S-8000" 'cuts at a speed of the spindle that is not above 0'
	refused "${call}S0" 'cuts at a speed' "$foreign"
	taken "${call}S50" "$foreign"
	has "$c: is told of others" "notice: .*the spindle's speed changes from 8000 to 50" err
done
good siemens
for block in SPOS=0 'SPOS[1]=90' SPOSA=DC\(90\) M70 M1=19; do
	refused "$block" 'cuts while the spindle is off'
done
refused S1=50 "the spindle's speed changes from 8000 to 50"
taken 'G4 S30'

# a path that asks for another speed
awk '{ print } /^GOTO/ && ++n == 200 { print "SPINDL/RPM,5000,CLW" }' three.cl >speeds.cl
for c in fanuc heidenhain; do
	control=$c
	ncpost -q -c "$c" -m three-axis -o good.nc speeds.cl
	has "$c: another speed, the head says so" 'AMID: SPEEDS' good.nc
	judge good.nc
	result $got "$c: the path not known"
	sed 's/AMID: SPEEDS/NOTHING/' good.nc >bad.nc
	judge bad.nc
	result $((got != 3)) "$c: another speed that the head does not say"
	has "$c: is told" "the spindle's speed changes from 8000 to 5000" err
	judge bad.nc -p speeds.cl
	result $got "$c: the path asks for it"
done

# ---- a block that a switch of the control leaves out
awk '{ print } /^GOTO/ && ++n == 200 { print "OPSKIP/ON" }
	n == 205 { print "OPSKIP/OFF"; n++ }' three.cl >skip.cl
for c in fanuc haas okuma siemens linuxcnc mach3; do
	good $c
	awk '/ G0 / { at = NR } { line[NR] = $0 }
		END { sub(/^/, "/", line[at]); for (i = 1; i <= NR; i++) print line[i] }' good.nc >bad.nc
	judge bad.nc
	result $((got != 3)) "$c: a retract that may be left out"
	has "$c: is told" 'bad.nc: [^:]*: a block that a switch of the control leaves out' err
	judge bad.nc -p three.cl
	result $((got != 3)) "$c: the path does not ask for it"
	sed -i "$foreign" bad.nc
	judge bad.nc
	result $got "$c: of others it is taken"
	has "$c: with a notice" 'notice: .*a block that a switch of the control leaves out' err
	ncpost -q -c "$c" -m three-axis -o good.nc skip.cl
	has "$c: OPSKIP" '^/' good.nc
	judge good.nc -p skip.cl
	result $got "$c: the path asks for it"
	hasnt "$c: and nothing is told" 'leaves out' err
	judge good.nc
	result $got "$c: the path not known, the head says so"
	sed 's/AMID: SKIPS/NOTHING/' good.nc >bad.nc
	judge bad.nc
	result $((got != 3)) "$c: the path not known, nor said"
done

done_testing

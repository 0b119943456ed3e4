#!/bin/sh
# ncverify-home.t - rapid moves that nothing follows: without tool centre point control while rotary
# axes are turned, and before Z is home.  All that ncpost writes is accepted, and what others write
# who go up first.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (j = 0; j <= 40; j++) for (i = 0; i <= 60; i++) { x = i * .4; y = j * .4
	printf "%.4f %.4f %.4f\n", x, y, 20 + 2 * sin(x / 5) + 1.5 * cos(y / 5) } }' >s.xyz
cloud2mesh -q -o s.ply s.xyz
meshnorm -q -r 3 --scallop 0.1 -o five.cl s.ply
meshnorm -q -r 3 --scallop 0.1 --fixed 0,0,1 -o three.cl s.ply

write() { # CONTROL: own.nc, its options in $how
	path=five.cl machine=table-ac
	case $1 in
	grbl | mach3 | tormach) path=three.cl machine=three-axis ;;
	linuxcnc) machine=linuxcnc-xyzac ;;
	esac
	ncpost -q -c "$1" -m $machine -o own.nc $path
	how="-c $1 -m $machine -g s.xyz -r 3 -e 0.02"
}
renumber() { # of Klartext
	case $1 in
	heiden*)
		awk '/^[0-9]+ /{ sub(/^[0-9]+/, NR - 1) } 1' changed.nc >new.nc
		mv new.nc changed.nc
		;;
	esac
}
headless() { grep -vE '^([0-9]+ )?[(;]' "$1" >headless.nc && mv headless.nc "$1"; }
judged() { # STATUS DESC REGEX: changed.nc; REGEX: what is told, "": nothing
	# shellcheck disable=SC2086
	status "$1" "$2" ncverify $how changed.nc
	[ -z "$3" ] || has "$2: told" "$3" err
}
stray="a rapid move to a place of the work without tool centre point control"
low="Z goes at rapid to [-0-9.]+ without tool centre point control, .* the part's top is at"
early='X, Y or a rotary axis goes at rapid before Z is home or known'
first="X, Y or a rotary axis goes at rapid while the ball is 14.000 mm below the part's top"
first="$first: Z goes first"

# ---- as written: no word of it, with the head and without; another one in place of the way home

for file in "$SRC"/controls/*.txt; do
	control=$(basename "$file" .txt)
	write "$control"
	cp own.nc changed.nc
	judged 0 "$control: as written"
	hasnt "$control: nothing of home" 'goes at rapid|a rapid move' err
	headless changed.nc
	renumber "$control"
	judged 0 "$control: without its head"
	hasnt "$control: nothing of home" 'goes at rapid|a rapid move' err
done

homeless() { # CONTROL NTH OLD NEW REGEX [REGEX without head]: the word of home is lost there
	write "$1"
	n=$(grep -nF -- "$3" own.nc | sed -n "$2p" | cut -d: -f1)
	sed "${n}s/$3/$4/" own.nc >changed.nc
	judged 3 "$1: $3 is $4, $2" "$5"
	headless changed.nc
	renumber "$1"
	judged 3 "$1: $3 is $4, $2, no head" "${6:-$5}"
}
while IFS='|' read -r control old new; do
	homeless "$control" 1 "$old" "$new" "$low"
	homeless "$control" 2 "$old" "$new" "$stray"
done <<'END'
fanuc|G91 G28 Z0.|G0 Z0.
mazak|G91 G28 Z0.|G0 Z0.
haas|G53 G0 Z0.|G0 Z0.
hurco|G53 G0 Z0.|G0 Z0.
siemens|SUPA G0 Z0 D0|G0 Z0 D1
heidenhain|FMAX M91|FMAX
heidenhain-530|FMAX M91|FMAX
fagor|#MCS ON|#MCS OFF
END

# ---- a dive at the end, and amid a cut

dive() { # CONTROL "SED"
	write "$1"
	sed -E "$2" own.nc >changed.nc
	renumber "$1"
	judged 3 "$1: a dive at its end" "$stray"
}
dive fanuc 's/^(N[0-9]+ )G49 G91 G28 Z0\./\1G49 G0 X12. Y8. Z40.\nG0 Z-5./'
dive haas '/^N98/s/^(N[0-9]+ )G53 G0 Z0\./\1G0 X12. Y8. Z40.\nG0 Z-5./'
dive siemens '/^N99/s/^(N[0-9]+ )SUPA G0 Z0 D0/\1G0 X12 Y8 Z40\nG0 Z-5/'
dive heidenhain '/^10/s/^([0-9]+ )L Z\+0 R0 FMAX M91/0 L X+12 Y+8 Z+40 R0 FMAX\n0 L Z-5 R0 FMAX/'
dive okuma '/^N98/s/^(N[0-9]+ )G30 P1/\1G0 X12. Y8. Z40.\nG0 Z-5./'
amid() { # CONTROL LINES: in place of a straight block far from the ends
	write "$1"
	awk -v text="$2" '{ print }
		NR == 500 { n = split(text, line, "|"); for (i = 1; i <= n; i++) print line[i] }' \
		own.nc >changed.nc
	renumber "$1"
	judged 3 "$1: amid a cut" "$stray"
}
back='X6. Y6. Z60. A-15. C-15.|Z30.|G1 Z23. F400.|F800.'
amid fanuc "G49|G0 X20. Y2. Z-20.|Z60.|G43.4 H1|G0 $back"
back='X6 Y6 Z60 A3=0 B3=0 C3=1|Z30|G1 Z23 F400|F800'
amid siemens "TRAFOOF|G0 X20 Y2 Z-20|Z60|TRAORI|ORIWKS ORIVECT|G0 $back"
off='0 FUNCTION RESET TCPM|0 L X+20 Y+2 Z-20 R0 FMAX|0 L Z+60 FMAX'
back='0 L X+6 Y+6 Z+60 A-15 C-15 R0 FMAX|0 L Z+30 FMAX|0 L Z+23 F400|0 L F800'
amid heidenhain "$off|0 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS|$back"

# ---- the spindle may go up by Z alone as G49 ends the length: by a program of ncpost well above
# the part

ncpost -q -c fanuc --set length.off=z --set length.off.z=300 -o own.nc five.cl
how='-c fanuc -m table-ac --set length.off=z --set length.off.z=300 -g s.xyz -r 3 -e 0.02'
cp own.nc changed.nc
judged 0 "up as G49 ends the length"
ok "it is in it" grep -q ' G49 Z300\.' changed.nc
sed 's/ G49 Z300\./ G49 Z37./' own.nc >changed.nc
judged 3 "not up by much" "$low"
sed 's/ G49 Z300\./ G49 Z300.\nG0 X5. Y5./' own.nc >changed.nc
judged 3 "and X and Y then" "$stray"
sed 's/ G49 Z300\./ G49 Z300. X5./' own.nc >changed.nc
judged 3 "or with X" "$stray"
sed '/ G49 Z300\./,/G28 Z0/{s/ G49 Z300\./ G49\nG91 G0 Z60./;s/\(G91 \)*G28 Z0\.$/G90/}' \
	own.nc >changed.nc
headless changed.nc
judged 0 "up from where it is, by a program of another"

# ---- a block is lost

without() { # CONTROL NTH REGEX-OF-BLOCK REGEX
	write "$1"
	n=$(grep -nE -- "$3" own.nc | sed -n "$2p" | cut -d: -f1)
	sed "${n}d" own.nc >changed.nc
	renumber "$1"
	judged 3 "$1 without $3" "$4"
}
without fagor 1 '#MCS ON' 'the block N30 before it is missing'
without fagor 1 'G0 Z0\.' 'the block N40 before it is missing'
without fagor 1 'G0 Z0\.' "$early"
without fagor 1 'T1 D1 M6' 'the block N60 before it is missing'
without okuma 1 'G30 P1' 'the block N20 before it is missing'
without okuma 1 'G30 P1' "$early"
without grbl 1 'G53 G0 Z0' "$early"
without heidenhain 1 M91 "$early"
without heidenhain 2 M91 "$early"
without heidenhain 1 'TOOL CALL' 'cuts before a tool is called'
write fanuc
printf 'base = fanuc\nnumber.step = 5\n' >five.txt
ncpost -q -c five -m table-ac -o changed.nc five.cl
how='-c five -m table-ac -g s.xyz -r 3 -e 0.02'
judged 0 "another step"
sed -i '/^N10 /d' changed.nc
judged 3 "another step, its second block is lost" 'the block N10 before it is missing'

# ---- programs of others: X and Y before Z is known is a notice, none after a change of the tool

write grbl
sed '/G53 G0 Z0/d' own.nc >changed.nc
headless changed.nc
judged 0 "no head, Z not known" "notice|$early"
sed -i 's/^G0 X/T1 M6\nG0 X/' changed.nc
judged 0 "no head, a tool is changed"
hasnt "no head, a tool is changed: nothing of Z" 'before Z is home' err

# ---- out of a valley: Z first, or up before it

awk 'BEGIN { for (j = 0; j <= 40; j++) for (i = 0; i <= 80; i++) { x = -20 + i * .5
	printf "%.4f %.4f %.4f\n", x, j * .5, 10 - 10 * cos(x / 20 * 3.14159265) } }' >v.xyz
cloud2mesh -q v.xyz | meshnorm -q -r 4 --scallop 0.1 -a 90 --fixed 0,0,1 -o v.cl
valley() { # STATUS CONTROL DESC LINES: they follow the bottom of the valley
	ncpost -q -c "$2" v.cl >own.nc
	n=$(grep -nE 'X\+?1\.16[01]' own.nc | head -n 1 | cut -d: -f1)
	sed "${n}q" own.nc | sed -E 's/^N[0-9]+ //' >changed.nc
	headless changed.nc
	echo "$4" | tr '|' '\n' >>changed.nc
	renumber "$2"
	how="-c $2 -m table-ac -g v.xyz -r 4 -e 0.02"
	told=
	[ "$1" = 0 ] || told=$first
	judged "$1" "$2: $3" "$told"
}
end='G90|G0 A0. C0.|M9|M5|M30|%'
valley 3 fanuc "X Y home from the valley" "G0 Z6.|G49|G91 G28 X0. Y0.|G28 Z0.|$end"
valley 3 fanuc "all home at once" "G0 Z6.|G49|G91 G28 X0. Y0. Z0.|$end"
valley 3 fanuc "G28 alone" "G0 Z6.|G49|G91 G28|$end"
valley 3 fanuc "A home" "G0 Z6.|G49|G91 G28 A0.|G28 Z0.|$end"
valley 3 fanuc "G53" "G0 Z6.|G49|G53 G0 X0. Y0.|G53 G0 Z0.|$end"
valley 0 fanuc "Z home first" "G0 Z6.|G49|G91 G28 Z0.|G28 X0. Y0.|$end"
valley 0 fanuc "up in the work first" "G0 Z25.|G49|G91 G28 X0. Y0.|G28 Z0.|$end"
valley 0 fanuc "up in the work, all home at once" "G0 Z25.|G49|G91 G28 X0. Y0. Z0.|$end"
valley 3 siemens "X Y home from the valley" 'G0 Z6|TRAFOOF|SUPA G0 X0 Y0 D0|SUPA G0 Z0 D0|M9|M5|M30'
valley 0 siemens "Z home first" 'G0 Z6|TRAFOOF|SUPA G0 Z0 D0|SUPA G0 X0 Y0 D0|M9|M5|M30'
low='0 L Z+6 FMAX|0 FUNCTION RESET TCPM' over='0 L X+0 Y+0 R0 FMAX M91'
up='0 L Z+0 R0 FMAX M91' ended='0 M9|0 M5|0 M30|0 END PGM V_XYZ MM'
valley 3 heidenhain "X Y home from the valley" "$low|$over|$up|$ended"
valley 0 heidenhain "Z home first" "$low|$up|$over|$ended"
valley 3 haas "X Y home from the valley" "G0 Z6.|G49|G53 G0 X0. Y0.|G53 G0 Z0.|$end"
valley 0 haas "Z home first" "G0 Z6.|G49|G53 G0 Z0.|G53 G0 X0. Y0.|$end"

done_testing

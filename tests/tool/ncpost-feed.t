#!/bin/sh
# ncpost-feed.t - the time that a program takes by its feeds, block by block, against the length of
# the path over its feed; and that no axis is asked for more than it can.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack them.
ncpost() { command ncpost --no-spindle "$@"; }
cd "$TMP" || exit 1

# A path that turns its axis more and more: straight pieces of 1 mm, then turns of up to 6 degrees
awk 'BEGIN {
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4\nSPINDL/9000,CLW\nRAPID"
	printf "GOTO/0,0,90,0,0.173648178,0.984807753\nFEDRAT/MMPM,600\n"
	for (i = 0; i < 120; i++) { w = (10 + (i < 60 ? 0 : (i - 60) * 0.8)) / 57.29577951308232
		printf "GOTO/%.6f,%.6f,0,0,%.9f,%.9f\n", i, (i > 60) * (i - 60) / 2, sin(w), cos(w)
		if (i == 30) print "FEDRAT/MMPM,1500" }
	print "RAPID\nGOTO/119,30,90,0,0.7,0.714142843\nFINI" }' >path.cl

# minutes by the path: cuts alone
awk -F'[/,]' '/^RAPID/ { rapid = 1; next } /^FEDRAT/ { feed = $3 }
	/^GOTO/ { if (!rapid) minutes += sqrt(($2 - x)^2 + ($3 - y)^2 + ($4 - z)^2) / feed
		x = $2; y = $3; z = $4; rapid = 0 }
	END { printf "%.6f\n", minutes }' path.cl >wanted

# minutes by the program: feeds of the tip, inverse, or along all axes together; and the fastest that
# each rotary axis is turned in a block at feed, degrees a minute
# shellcheck disable=SC2016
clock='
	function value(letter,  at) {
		at = match(" " $0 " ", " " letter "[-+]?[0-9.]+ ")
		return at ? substr(" " $0 " ", RSTART + 2, RLENGTH - 3) + 0 : now[letter]
	}
	/^\(|;|%|G28|G53|M91|SUPA|G68|G43|BEGIN|END|TCPM|TRA|TOOL|M[0-9]|CYCL/ { if (/G0/) rapid = 1; if (!/G43/) next }
	/ G0( |$)|FMAX/ { rapid = 1 }
	/ G1( |$)|G93/ { rapid = 0 }
	/^[0-9]+ L/ && !/FMAX/ { rapid = 0 }
	/G93/ { inverse = 1 }
	/G94/ { inverse = 0 }
	{ way = turn = 0
		for (k = 1; k <= 3; k++) { l = substr("XYZ", k, 1); v = value(l); way += (v - now[l])^2; now[l] = v }
		for (k = 1; k <= 3; k++) { l = substr("ABC", k, 1); v = value(l); d[l] = v - now[l]
			turn += d[l]^2; now[l] = v }
		f = now["F"] = value("F")
		if (rapid || way + turn == 0) next
		if (f <= 0) { print "no feed: " $0; next }
		t = inverse ? 1 / f : (joint ? sqrt(way + turn) : sqrt(way)) / f
		minutes += t; blocks++
		for (l in d) if (t > 0 && (d[l] < 0 ? -d[l] : d[l]) / t > most) most = (d[l] < 0 ? -d[l] : d[l]) / t
	}
	END { printf "%.6f %.1f %d\n", minutes, most, blocks }'
near() { # DESC MINUTES LIMIT
	below "$1" "$(awk -v a="$2" -v b="$(cat wanted)" 'BEGIN { print (a > b ? a / b - 1 : 1 - a / b) }')" "$3"
}
timed() { # OPTIONS JOINT LIMIT
	# shellcheck disable=SC2086
	ncpost -q $1 path.cl >p.nc 2>err || cat err
	awk -v joint="$2" "$clock" p.nc >got
	near "ncpost $1: the time of the path" "$(cut -d' ' -f1 got)" "$3"
	below "and no rotary axis turns faster than it can" "$(cut -d' ' -f2 got)" 7210
}
timed "-c fanuc" 0 0.001
timed "-c fanuc --inch" 0 0.001
timed "-c siemens --rotary" 0 0.001
timed "-c heidenhain" 0 0.001
timed "-c fanuc -m table-ac-notcp" 0 0.002
timed "-c linuxcnc" 0 0.002
timed "-c heidenhain -m table-ac-notcp" 1 0.002
timed "-c fanuc -m table-ac-notcp --set feeds=combined" 1 0.002
timed "-c fanuc -m head-ca --set tcp=no" 0 0.02 # the slides go to and fro below the head
# inverse time is what the axes take with their acceleration: the slower they are, the longer
ncpost -q -c fanuc -m table-ac-notcp --set x.acceleration=100 --set a.acceleration=20 --set c.acceleration=20 path.cl >slow.nc
awk -v joint=0 "$clock" slow.nc >got
below "axes that are slow to move take longer" "$(awk '{ print 1.03 * $1 }' wanted)" "$(cut -d' ' -f1 got)"

# a slow axis takes its time, and no more than that
for options in "-c fanuc" "-c fanuc -m table-ac-notcp" "-c heidenhain -m table-ac-notcp"; do
	joint=0
	case $options in *heidenhain*) joint=1 ;; esac
	# shellcheck disable=SC2086
	ncpost -q $options --set a.rapid=300 --set c.rapid=300 path.cl >slow.nc
	awk -v joint=$joint "$clock" slow.nc >got
	below "$options: 300 degrees a minute kept" "$(cut -d' ' -f2 got)" 301
	below "and used" 298 "$(cut -d' ' -f2 got)"
done
# the control's largest F, and its smallest
ncpost -q -c fanuc -m table-ac-notcp --set feed.max=200 path.cl >capped.nc
sed -n 's/.* F\([0-9.]*\)$/\1/p' capped.nc | sort -n | tail -n 1 >most
below "feed.max of inverse time" "$(cat most)" 200
sed 's/FEDRAT.*/FEDRAT\/MMPM,0.00001/' path.cl >crawl.cl
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $control crawl.cl >crawl.nc
	hasnt "$control: a crawl is no F0" ' F(0+\.?0*|\.0+)$' crawl.nc
done

# The tip stands or all but stands while the axes turn, then moves on: no axis is asked for more than
# it can, nor for nothing; where the tip stays as printed F counts degrees
awk 'BEGIN {
	seed = 9 + 7919 * ENVIRON["SEED"]; x = 20; th = 0.3
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4\nSPINDL/9000,CLW\n$$-> CLOUDMILL/1"
	print "RAPID\nGOTO/20,0,60,0,0.295520207,0.955336489\nFEDRAT/MMPM,800"
	for (i = 0; i < 150; i++) {
		for (k = 0; k < 5; k++) { seed = (seed * 16807) % 2147483647; r[k] = seed / 2147483647 }
		d = r[0] < 0.5 ? (r[1] < 0.5 ? 0 : r[1] < 0.8 ? 0.0006 : 0.02) : 1
		x += d * (r[2] * 1.3 - 0.3); y += d * (r[1] - 0.5)
		th += 0.1 * r[3] - 0.05; ph += 0.8 * r[4] - 0.4
		if (th < 0.1 || th > 0.8) th = 0.3
		printf "GOTO/%.6f,%.6f,0,%.9f,%.9f,%.9f\n", x, y, sin(th) * cos(ph), sin(th) * sin(ph), cos(th)
	}
	printf "RAPID\nGOTO/%.6f,%.6f,60,%.9f,%.9f,%.9f\nFINI\n", x, y, sin(th) * cos(ph), sin(th) * sin(ph), cos(th)
}' >standing.cl
# and far from the rotary centres, where the slides go much further than the tip
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4\nSPINDL/9000,CLW\n$$-> CLOUDMILL/1\nRAPID"
	printf "GOTO/900,0,60,0,0.342897807,0.939372713\nFEDRAT/MMPM,2000\n"
	for (i = 0; i < 100; i++) { th = 0.35 + 0.3 * sin(i / 9); ph = i / 20
		printf "GOTO/%.6f,%.6f,0,%.9f,%.9f,%.9f\n", 900 + i, i / 3, sin(th) * sin(ph), sin(th) * cos(ph), cos(th) }
	printf "RAPID\nGOTO/%.6f,%.6f,60,%.9f,%.9f,%.9f\nFINI\n", 999, 33, sin(th) * sin(ph), sin(th) * cos(ph), cos(th)
}' >far.cl
bsplfit -q -e 0.002 -o farspline.cl far.cl
biarcfit -q -e 0.002 -o fararc.cl far.cl
kept() { # PATH CONTROL MACHINE OPTIONS
	path=$1 control=$2 machine=$3
	shift 3
	word=
	[ $control = siemens ] && word=--rotary
	# shellcheck disable=SC2086
	ncpost -q -c "$control" $word -m "$machine" "$@" -o kept.nc "$path" 2>err || { cat err; return; }
	"$READBACK" -c "$control" -m "$machine" "$@" kept.nc >rb 2>&1 || head -n 2 rb
	grep -q 'too fast 0,' rb || echo "$control $machine $path $*: $(sed -n 's/^axes: //p' rb)"
	grep -Eq ' F(0+\.?0*|\.0+)( |$)' kept.nc && echo "$control $machine $path: a feed of nothing"
	return 0
}
for path in standing.cl far.cl farspline.cl fararc.cl; do
	for machine in table-ac head-ca nutating-head table-ac-notcp head-table-bc-notcp; do
		for control in fanuc siemens heidenhain; do
			kept $path $control $machine
			kept $path $control $machine --set rapid=3000 --set c.rapid=500
		done
	done
	kept $path linuxcnc linuxcnc-xyzac --set a.rapid=300
done >asked
empty "tips that stand, and far from the centres: no axis too fast" asked
# 0.1 mm/min would be too fast there
grep -Eq ' F0\.0[0-9]*$' kept.nc || ncpost -q -c fanuc --set c.rapid=30 -o slow.nc standing.cl
has "F has the digits that it takes" ' F0?\.0[0-9]+$' slow.nc

# arcs of a few last digits, whose printed ends, centre and radii are not the path's, while C turns
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4\nSPINDL/9000,CLW\n$$-> CLOUDMILL/1\nRAPID"
	seed = 3 + 7919 * ENVIRON["SEED"]; x = 1; y = 1; th = 0.05; ph = 0; pi = atan2(0, -1)
	printf "GOTO/1,1,60,0.049979169,0,0.998750260\nFEDRAT/MMPM,800\nGOTO/1,1,0,0.049979169,0,0.998750260\n"
	for (i = 0; i < 400; i++) {
		for (k = 0; k < 4; k++) { seed = (seed * 16807) % 2147483647; r[k] = seed / 2147483647 }
		rad = 0.01 + 0.03 * r[0]; from = 2 * pi * r[1]; turn = 0.8 + 2 * r[2]; side = i % 2 ? 1 : -1
		cx = x - rad * cos(from); cy = y - rad * sin(from)
		x = cx + rad * cos(from + side * turn); y = cy + rad * sin(from + side * turn)
		ph += 0.3 * r[3]
		printf "CIRCLE/%.6f,%.6f,0,0,0,%d,%.6f\n", cx, cy, side, rad
		printf "GOTO/%.6f,%.6f,0,%.9f,%.9f,%.9f\n", x, y, sin(th) * cos(ph), sin(th) * sin(ph), cos(th)
	}
	printf "RAPID\nGOTO/%.6f,%.6f,60,%.9f,%.9f,%.9f\nFINI\n", x, y, sin(th) * cos(ph), sin(th) * sin(ph), cos(th)
}' >tiny.cl
awk 'BEGIN { for (i = 0; i < 400; i++) print i % 20 / 10, int(i / 20) / 10, 0 }' >tiny.xyz
for control in fanuc siemens linuxcnc; do
	word='' machine=table-ac
	[ $control = siemens ] && word=--rotary
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	for options in "" --inch; do
		# shellcheck disable=SC2086
		ncpost -q -c $control $word -m $machine $options -o tiny.nc tiny.cl
		ncverify -c $control -m $machine -r 4 -g tiny.xyz tiny.nc 2>/dev/null |
			sed -n "s/^program .* \([0-9]* arcs\).*/$control $options: \1/p; s/^.*largest speed/& $control $options/p"
	done
done >quick
empty "small arcs, as printed: no axis too fast" "$(grep -v ' arcs$' quick >fast; echo fast)"
has "and they are arcs" '^fanuc : [0-9][0-9][0-9] arcs$' quick

# a tip that stands: 800 mm a minute are as many degrees, in inches too; slower with a large ball
printf 'UNITS/MM\nMULTAX/ON\nCUTTER/%s\nSPINDL/9000,CLW\nRAPID\nGOTO/0,0,0,0,0.5,0.866025404\nFEDRAT/MMPM,800\nGOTO/0,0,0,0,0.866025404,0.5\nFINI\n' 8,4,0,4 >turn.cl
sed 's/8,4,0,4/240,120,0,120/' turn.cl >large.cl
for options in "" --inch "-m table-bc --set b.rapid=5000"; do
	# shellcheck disable=SC2086
	ncpost -q -c fanuc $options turn.cl | sed -n 's/.* F\([0-9.]*\)$/\1/p' | tail -n 1
	# shellcheck disable=SC2086
	ncpost -q -c fanuc $options large.cl | sed -n 's/.* F\([0-9.]*\)$/\1/p' | tail -n 1
done | tr '\n' ' ' >turned
has "a turn about a tip that stands" '^800. 38[0-9.]* 800. 38[0-9.]* 800. 38[0-9.]* $' turned

# contact-point feed: the contact keeps the feed on a ball that rolls over an edge, the tip does not
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/20,10,0,10\nSPINDL/9000,CLW\n$$-> CLOUDMILL/1\nRAPID"
	r = 10; R = 30
	for (i = 0; i <= 90; i++) { w = i / 90; a = sin(w); c = cos(w)
		if (i == 0) printf "GOTO/%.6f,0,%.6f,0,0,1\nFEDRAT/MMPM,600\n", 0, R + 50
		printf "$$-> CONTCT/%.6f,0,%.6f,%.9f,0,%.9f\n", R * a, R * c, a, c
		printf "GOTO/%.6f,0,%.6f,0,0,1\n", (R + r) * a, (R + r) * c - r }
	printf "RAPID\nGOTO/%.6f,0,90,0,0,1\nFINI\n", (R + r) * a }' >roll.cl
ncpost -q -c fanuc --contact-feed -o roll.nc roll.cl
sed -n 's/.* F\([0-9.]*\)$/\1/p' roll.nc | tail -n 1 >roll
below "the centre goes (R + r) / R as fast" "$(awk '{ print ($1 > 800 ? $1 - 800 : 800 - $1) }' roll)" 1

# feeds in all units, in mm and inches: the same speed of the tip
for said in MMPM,508 IPM,20 MMPR,0.0635 IPR,0.0025; do
	printf 'UNITS/MM\nCUTTER/8,4,0,4\nSPINDL/RPM,8000,CLW\nRAPID\nGOTO/0,0,50\nFEDRAT/%s\nGOTO/0,0,0\nGOTO/100,0,0\nFINI\n' "$said" >unit.cl
	ncpost -q -u mm -c fanuc unit.cl | grep -q 'F508\.$' || echo "$said"
	ncpost -q -u mm -c fanuc --inch unit.cl | grep -q 'F20\.$' || echo "$said in inches"
	ncpost -q -u mm -c fanuc -m table-ac-notcp unit.cl >unit.nc
	grep -Eq 'F508\.$|F5\.08$' unit.nc || echo "$said inverse: $(grep F unit.nc | tail -n 1)"
done >units
empty "mm and inches, a minute and a turn" units

# beside the pole a curve of the head is slow, but what only says again where the tool stands is not:
# its last digits may turn an axis by half a turn there
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/6,3,0,3\nLOADTL/1\nSPINDL/8000,CLW\nRAPID\nGOTO/-10,0,60,0,0,1\nFEDRAT/MMPM,800"
	for (i = -100; i <= 100; i++) { x = i / 10; a = 0.03 * sin(x / 4); b = 0.000001
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, sin(x / 5) / 2, 0.3 * cos(x / 3), a, b, sqrt(1 - a * a - b * b) }
	print "RAPID\nGOTO/10,0,60,0,0,1\nFINI" }' >pole.cl
bsplfit -q -e 0.01 pole.cl | ncpost -q -c siemens -o pole.mpf
awk '{ if (match($0, / F[0-9.]+$/)) f = substr($0, RSTART + 2) + 0 }
	/BSPLINE|PO\[|^N[0-9]+ X/ && f > 0 && f < 100 { print "slow " f; slow = 1 }
	/G1 ORI/ && f < 100 { print "stands at " f }' pole.mpf >feeds
has "a curve beside the pole is slow" '^slow' feeds
hasnt "what stands is not" '^stands' feeds
has "the vectors are back before the rapid" 'ORIVECT' pole.mpf
grep -c 'G1 ORIVECT' pole.mpf >back
has "and only there" '^1$' back

# --feed and a path that has feeds
printf 'FEDRAT/100\nGOTO/0,0,9\nGOTO/0,0,8\nFINI\n' >has.cl
ncpost --no-spindle -c fanuc --feed 1500 has.cl >has.nc 2>said
has "--feed beside feeds of the path is told" 'has feeds of its own: --feed 1500 is not used' said
hasnt "and not used" 'F1500' has.nc
printf 'GOTO/0,0,9\nGOTO/0,0,8\nFINI\n' >none.cl
ncpost --no-spindle -c fanuc --feed 1500 none.cl >none.nc 2>said
hasnt "where the path has none it is" 'not used' said
has "in the program" 'F1500' none.nc
done_testing

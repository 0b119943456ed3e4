#!/bin/sh
# feed.t - the time that a program takes by its feeds, block by block, against the length of the path
# over its feed; and that no axis is asked for more than it can.
. "${SRC:-$(dirname "$0")/..}/tests/lib.sh"
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
timed "-c fanuc -m head-ca --set tcp=no" 0 0.002

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
done_testing

#!/bin/sh
# ncpost-digits.t - what each control asks of the printed digits, on paths at random: straight, on
# arcs in any plane and on B-splines, the tool turning; numbers next to zero, and texts of all
# kinds.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A path at random, the same for the same seed whatever awk it is
random_path() { # SEED
	awk -v seed="$1" '
	function chance() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	function unit(  l) { l = sqrt(i * i + j * j + k * k); i /= l; j /= l; k /= l }
	function lean() { i = chance() - 0.5; j = chance() - 0.5; k = 0.6 + chance(); unit() }
	function go() { printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, y, z, i, j, k }
	function near_zero() { return chance() < 0.3 ? (chance() - 0.5) / 1000 : 30 * (chance() - 0.5) }
	function line() { x = near_zero(); y = near_zero(); z = near_zero(); if (chance() < 0.5) lean(); go() }
	function arc(  a, b, c, r, t, ux, uy, uz, vx, vy, vz, cx, cy, cz, l) {
		a = int(4 * chance()); b = chance() - 0.5; c = chance() - 0.5 # its axis: X, Y, Z or any
		ax = a == 0; ay = a == 1; az = a == 2 || a == 3
		if (a == 3) { ax = b; ay = c; l = sqrt(b * b + c * c + 1); ax /= l; ay /= l; az /= l }
		ux = ay * 0.3 - az * 0.5; uy = az * 0.8 - ax * 0.3; uz = ax * 0.5 - ay * 0.8
		l = sqrt(ux * ux + uy * uy + uz * uz); ux /= l; uy /= l; uz /= l
		vx = ay * uz - az * uy; vy = az * ux - ax * uz; vz = ax * uy - ay * ux
		r = 1 + 20 * chance(); t = 0.1 + 6 * chance()
		cx = x - r * ux; cy = y - r * uy; cz = z - r * uz
		printf "CIRCLE/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f,%.6f\n", cx, cy, cz, ax, ay, az, r
		x = cx + r * (cos(t) * ux + sin(t) * vx); y = cy + r * (cos(t) * uy + sin(t) * vy)
		z = cz + r * (cos(t) * uz + sin(t) * vz); go()
	}
	function curve(  n, p, u, s, tips, heads, knots) {
		n = 4 + int(6 * chance()); u = 0; knots = "0,0,0,0"
		for (p = 0; p < n; p++) {
			if (p) { x += 5 * chance(); y += 6 * chance() - 3; z += 2 * chance() - 1 }
			tips = tips sprintf(",%.6f,%.6f,%.6f", x, y, z)
			heads = heads sprintf(",%.6f,%.6f,%.6f", x + 100 * i, y + 100 * j, z + 100 * k)
			if (p > 3) { u += 0.02 + 9 * chance(); knots = knots sprintf(",%.6f", u) }
		}
		u += 3; for (p = 0; p < 4; p++) knots = knots sprintf(",%.6f", u)
		printf "MOVNRB/5AXIS,LENGTH,100\nMOVNRB/ON,4,%d,0,%d,%.6f\nMOVNRB/1,%s\n", n + 4, n, u, knots
		printf "MOVNRB/2%s\nMOVNRB/3%s\nMOVNRB/NEXT\n", tips, heads; go(); print "MOVNRB/OFF"
	}
	BEGIN {
		seed += 7919 * ENVIRON["SEED"]
		print "PARTNO/a (nested (name)) of \"" seed "\" with {braces}; and so on, longer than any line of a control may be: " \
			"0123456789012345678901234567890123456789"
		print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nLOADTL/3\nSPINDL/RPM,7777.777,CLW\n$$-> CLOUDMILL/1\n$$-> PASS/1"
		z = 80; k = 1; print "RAPID"; go(); lean(); print "FEDRAT/MMPM,333.3333"; line()
		for (n = 0; n < 60; n++) {
			what = chance()
			if (what < 0.5) line()
			else if (what < 0.8) arc()
			else if (what < 0.9) curve()
			else print "PPRINT lower (case) ; text % with a very long line of words that go on and on and on, ~ to the end"
		}
		z = 150; print "RAPID"; go(); print "FINI"
	}' </dev/null
}

# Every rule that a program breaks, the control in c
cat >rules.awk <<'RULES'
function say(what) { print FILENAME ":" FNR ": " what ": " $0 }
function value(w) { return substr(w, 2) + 0 }
function distance(a, b, c) { return sqrt(a * a + b * b + c * c) }
/[ \t]$/ { say("a blank at the end") }
/[^ -~]/ { say("no plain text") }
{ text = $0 }
c == "fanuc" && length($0) > 80 && /^\(/ { say("a long comment") }
c == "fanuc" && /[a-z]/ { say("a small letter") }
c == "fanuc" || c == "linuxcnc" { if ($0 ~ /\([^)]*\(/) say("a bracket within brackets"); gsub(/\([^)]*\)/, "", text) }
c == "siemens" || c == "heidenhain" { sub(/;.*/, "", text) }
length($0) > (c == "siemens" ? 512 : 255) { say("a long block") }
text ~ /[A-Z=,(]-(0+\.?|0*\.0+)([ ,)]|$)/ { say("-0") }
text ~ /[0-9][eE][-+0-9]/ { say("an exponent") }
c == "fanuc" && text ~ / [XYZABCIJKRF]-?[0-9]+( |$)/ { say("no decimal point") }
c == "heidenhain" && text ~ / (L|LN|C|CC) / && text ~ / ([XYZABC]|T[XYZ])[0-9]/ { say("no sign") }
c != "siemens" && c != "heidenhain" || text ~ /^(N|[0-9])/ {
	n = split(text, w, " ")
	split("", has); i = j = k = r = 0; vectors = 0
	for (m = 2; m <= n; m++) {
		letter = substr(w[m], 1, 1)
		if (letter == "G" && w[m] ~ /^G0?[0-3]$|^G0[26]\.[24]$|^G03\.4$/) motion = w[m]
		if (w[m] ~ /^G1[789]$/) plane = w[m]
		if (w[m] == "CIP" || w[m] == "POLY" || w[m] == "BSPLINE") motion = w[m]
		if (w[m] ~ /^(L|LN|C|CC)$/) motion = w[m]
		if (w[m] == "G93" || w[m] == "G94") inverse = w[m] == "G93"
		if (w[m] ~ /^(G28|G43|G43\.4|G43\.5|G49|G53|SUPA|M91|TRAORI|TRAFOOF|D1|M6)$/ || $0 ~ /TCPM|M128|M129/)
			split("", at)
		if (w[m] ~ /^[XYZABCF][-+]?[.0-9]+$/) {
			has[letter] = w[m]
			straight = motion ~ /^(G0?[01]|L)$/
			if (straight && (letter in at) && at[letter] == w[m] && !(letter == "F" && inverse))
				say("again " w[m])
			at[letter] = w[m]
			before[letter] = place[letter]; place[letter] = value(w[m])
		}
		if (w[m] ~ /^[IJK]-?[.0-9]+$/) { vectors++; if (letter == "I") i = value(w[m]); if (letter == "J") j = value(w[m]); if (letter == "K") k = value(w[m]) }
		if (w[m] ~ /^K-?[.0-9]+$/ && motion == "G06.2") {
			curves++
			if (knots && value(w[m]) > knot && value(w[m]) - knot < 1 - 1e-9) say("a knot span below 1")
			knot = value(w[m]); knots = 1
		}
		if (letter == "R") r = value(w[m])
	}
	if (motion != "G06.2" || $0 ~ /G06\.2/) { if (motion != "G06.2") knots = 0 }
	if (motion == "POLY" || motion == "BSPLINE" || motion ~ /G0[26]\.[24]/) split("", at)
}
$0 ~ /G43\.5/ { typed = 1; if (vectors) say("a vector with G43.5") }
$0 ~ /G49/ { typed = 0 }
typed && motion !~ /G0?[23]/ && vectors && vectors != 3 { say("a vector of " vectors) }
(c == "fanuc" || c == "linuxcnc") && motion ~ /^G[23]$/ && vectors && !r {
	dx = "X" in has ? place["X"] - before["X"] : 0; dy = "Y" in has ? place["Y"] - before["Y"] : 0
	dz = "Z" in has ? place["Z"] - before["Z"] : 0
	if (plane == "G18") { j = dy = 0 } else if (plane == "G19") { i = dx = 0 } else { k = dz = 0 }
	off = distance(i, j, k) - distance(dx - i, dy - j, dz - k)
	if (off > 0.005 || off < -0.005) say("a difference of radius of " off)
	arcs++
}
c == "siemens" {
	if (($0 ~ /A3=/) + ($0 ~ /B3=/) + ($0 ~ /C3=/) != 0 && !($0 ~ /A3=.*B3=.*C3=/)) say("part of a vector")
	if ($0 ~ /XH=|YH=|ZH=/ && !($0 ~ /XH=.*YH=.*ZH=/)) say("part of a head point")
}
END { print arcs + 0, curves + 0 >"seen" }
RULES

for seed in 11 12 1013; do # with four digits the name is cut at a blank
	random_path $seed >path.cl
	while read -r control options; do
		# shellcheck disable=SC2086
		status 0 "$control $options, path $seed" ncpost -q -c $control $options -o program path.cl
		awk -v c="$control" -f rules.awk program >broken
		empty "keeps its rules" broken
	done <<-'END'
		fanuc
		fanuc --vectors
		fanuc --inch
		fanuc --set arcs.space=yes
		fanuc -m table-ac-notcp
		siemens
		siemens --rotary
		siemens --inch
		heidenhain
		heidenhain --vectors
		linuxcnc
		linuxcnc -m linuxcnc-xyzac
	END
done
# the rules themselves: each is seen when it is broken, on a path that has all of it
(SEED=0 && export SEED && random_path 13) >path.cl
ncpost -q -c fanuc --set arcs.space=no -o program path.cl
breaks() { # DESC SED-EXPRESSION MESSAGE
	sed "$2" program >wrong
	awk -v c=fanuc -f rules.awk wrong >broken
	has "$1" "$3" broken
}
breaks "-0 is seen" 's/ Y0\.0[0-9]*/ Y-0./' '-0'
breaks "no point is seen" 's/ Z150\./ Z150/' 'no decimal point'
breaks "a small letter is seen" 's/LOWER/lower/' 'small letter'
breaks "a moved centre is seen" 's/ I\([-0-9]*\)\.\([0-9]\)/ I\1.9\2/' 'difference of radius'
breaks "a word again is seen" 's/^N\(.*\) G1 X\([-.0-9]*\)\(.*\)$/N\1 G1 X\2\3\nN1 X\2/' 'again X'
breaks "a short span is seen" 's/ K[1-9][0-9]*\./ K0./' 'knot span'
below "there are arcs" 10 "$(cut -d' ' -f1 seen)"
below "and curves" 50 "$(cut -d' ' -f2 seen)"

# ---- one direction said in two ways: a block that moves nothing is none
cat >twice.cl <<'END'
PARTNO/TWICE
UNITS/MM
CUTTER/10.000000,5.000000
LOADTL/1
SPINDL/RPM,8000.000000,CLW
RAPID
GOTO/0.000000,0.000000,50.000000,-0.339753402,-0.001651131,0.940513104
FEDRAT/800,MMPM
GOTO/0.000000,0.000000,0.000000,-0.339753402,-0.001651131,0.940513104
GOTO/10.000000,0.000000,0.000000,-0.339753402,-0.001651131,0.940513104
GOTO/10.000000,0.000000,0.000000,-0.339753402,-0.001651131,0.940513106
GOTO/20.000000,0.000000,0.000000,-0.339753402,-0.001651131,0.940513106
FINI
END
ok "vectors that differ by their last digit" ncpost -q -c siemens twice.cl -o twice.mpf
ok "no block turns by it alone" awk '/ G1 / { cut = 1 } cut && / A3=/ && !/ X/ { exit 1 }' twice.mpf
has "the next one says it" ' X20 A3=-0.3397534 B3=-0.00165113 C3=0.94051311' twice.mpf

# What stages spent in all may be as much as -e, to the digits that they write.
spent() { # LEDGERS
	for what; do echo "\$\$-> LEDGER/stage,$what"; done | cat - twice.cl
}
spent 0.1 0.2 >spent.cl
status 0 "0.1 and 0.2 are 0.3" ncpost -q -c siemens -e 0.3 -o spent.mpf spent.cl
spent 0.100001 0.2 >spent.cl
status 3 "a millionth more is more" ncpost -q -c siemens -e 0.3 -o spent.mpf spent.cl
has "is told so that it is seen" 'spent 0.300001 mm, expected at most 0.3$' "$TMP/err"

done_testing

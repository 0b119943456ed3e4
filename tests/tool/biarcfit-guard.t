#!/bin/sh
# biarcfit-guard.t - the option -g of both fitters on a plane, z = 0, and a ball of 5 mm: what is
# carried through is looked at, too, and what is published is only told.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

awk 'BEGIN { for (i = 0; i <= 100; i++) for (j = 0; j <= 40; j++) print i / 4, j / 4 - 5, 0 }' \
	>"$TMP/plane.xyz"

# path FILE BETWEEN DIP: two runs that touch the plane, a motion between them to the height BETWEEN,
# and in the second run every fourth point is too low by DIP
path() {
	awk -v between="$2" -v dip="$3" '
		function go(x, z) { printf "GOTO/%.6f,0,%.6f,0,0,1\n", x, z }
		function touch(x, z) { printf "$$-> CONTCT/%.6f,0,%.6f,0,0,1\n", x, z; go(x, z) }
		BEGIN {
			print "PARTNO/T\nUNITS/MM\nMULTAX/ON\nCUTTER/10,5,0,5,0,0,60\n$$-> CLOUDMILL/1\n$$-> PASS/1"
			print "RAPID"; go(2, 20); print "FEDRAT/MMPM,800"
			for (x = 2; x <= 10; x += 0.5) touch(x, 0)
			go(12, between)
			for (x = 14; x <= 22; x += 0.5) touch(x, x % 2 == 0 && x > 14 && x < 22 ? -dip : 0)
			print "RAPID"; go(22, 20); print "FINI"
		}' >"$1"
}

path "$TMP/clear.cl" 1 0
path "$TMP/link.cl" -0.05 0
path "$TMP/low.cl" 1 0.03
for made in 0.04 0.06; do # within which the path was made
	sed "s,CLOUDMILL/1,&\\n\$\$-> LEDGER/meshnorm\,$made," "$TMP/link.cl" >"$TMP/made-$made.cl"
done
for fit in bsplfit biarcfit; do
	status 0 "$fit: clear" $fit -q -e 0.01 -g "$TMP/plane.xyz" -o "$TMP/out.cl" "$TMP/clear.cl"
	status 3 "$fit: a motion between runs" $fit -e 0.01 -g "$TMP/plane.xyz" -o "$TMP/out.cl" "$TMP/link.cl"
	has "$fit: how deep, and where" 'in pass 1 the ball by 0\.05[0-9]* mm with the ball.s centre at 1[123]\.' "$TMP/err"
	status 0 "$fit: within what is asked for" $fit -q -e 0.06 -g "$TMP/plane.xyz" -o "$TMP/out.cl" "$TMP/link.cl"
	status 0 "$fit: what the path may be deep is none of the fit" $fit -q -e 0.01 -g "$TMP/plane.xyz" \
		-o "$TMP/out.cl" "$TMP/made-0.06.cl"
	status 3 "$fit: deeper than the path may be" $fit -e 0.01 -g "$TMP/plane.xyz" -o "$TMP/out.cl" \
		"$TMP/made-0.04.cl"
	has "$fit: by the path's tolerance" 'links at feed the tool goes deeper than 0\.04 mm' "$TMP/err"
	status 0 "$fit: points too low" $fit -v -e 0.01 -g "$TMP/plane.xyz" -o "$TMP/out.cl" "$TMP/low.cl"
	has "$fit: are lifted" 'points lifted by at most 0\.0[2-6]' "$TMP/err"
done
status 3 "as published" bsplfit -v --paper -e 0.01 -g "$TMP/plane.xyz" -o "$TMP/out.cl" "$TMP/low.cl"
hasnt "nothing is lifted" 'lifted' "$TMP/err"
has "what is too deep is told" 'in pass 1 the ball by 0\.0[2-9]' "$TMP/err"

# A wall beside the path, 20 mm high: the ball is 0.2 mm clear of it, the tool leans into it.
awk 'BEGIN { for (i = 0; i <= 100; i++) for (j = 0; j <= 60; j++) { print i / 4, 5.2, j / 3
		if (j < 40) print i / 4, 5.2 - j / 4, 0 } }' >"$TMP/wall.xyz"
leaned() { # FILE LEAN: along x with the axis leaned to the wall in the middle
	awk -v lean="$2" 'BEGIN { print "PARTNO/A\nUNITS/MM\nCUTTER/10,5,0,5,0,0,60\n$$-> CLOUDMILL/1"
		print "$$-> TOOL/FLUTE,20.000000\nFEDRAT/800,MMPM"
		for (x = 3; x <= 22; x += 0.5) { b = lean * (1 - ((x - 12.5) / 9.5) ^ 2)
			printf "$$-> CONTCT/%.6f,0,0,0,0,1\n", x
			printf "GOTO/%.6f,%.6f,%.6f,0,%.9f,%.9f\n", x, -5 * sin(b), 5 - 5 * cos(b), sin(b), cos(b) }
		print "FINI" }' >"$1"
}
leaned "$TMP/upright.cl" 0
leaned "$TMP/leaned.cl" 0.1
for fit in bsplfit biarcfit; do
	status 0 "$fit: the shaft beside a wall" $fit -q -g "$TMP/wall.xyz" -o "$TMP/out.cl" "$TMP/upright.cl"
	status 3 "$fit: the shaft in it" $fit -g "$TMP/wall.xyz" -o "$TMP/out.cl" "$TMP/leaned.cl"
	has "$fit: is told, with its depth" 'the shaft by 1\.[0-9]* mm' "$TMP/err"
	status 0 "$fit: the ball alone" sh -c "sed 's/TOOL.*/TOOL\/BALL-ONLY/' '$TMP/leaned.cl' |
		$fit -q -g '$TMP/wall.xyz' -o '$TMP/out.cl'"
done

# Two rows on the plane and a link between them with the tool down, 1 mm above it: round, or with
# long sides (SHAPE).  What touches nothing is fitted too where it is smooth and there is a guard.
linked() { # FILE SHAPE
	awk -v shape="$2" 'function go(x, y, z) {
			printf "GOTO/%.6f,%.6f,%.6f,%.9f,0,%.9f\n", x - 5 * sin(lean), y,
				z + 5 - 5 * cos(lean), sin(lean), cos(lean) }
		function touch(x, y) { printf "$$-> CONTCT/%.6f,%.6f,0,0,0,1\n", x, y; go(x, y, 0) }
		BEGIN {
			print "PARTNO/T\nUNITS/MM\nMULTAX/ON\nCUTTER/10,5,0,5,0,0,60\n$$-> CLOUDMILL/1\n$$-> PASS/1"
			if (shape == "over") lean = 0.34
			print "RAPID"; go(2, 0, 20); print "FEDRAT/MMPM,800"
			for (x = 2; x <= 20; x += 0.5) touch(x, 0)
			print "$$-> PASS/2"
			for (i = 1; i <= 16 && shape != "bent"; i++) {
				a = 3.14159265 * i / 16
				if (shape == "over") lean = 0.34 - 0.0425 * i
				go(20 + sin(a), 1 - cos(a), 0.5 * sin(a) ^ 2)
			}
			for (i = 0; i < 5 && shape == "bent"; i++) go(22 + i, i * (i - 1) / 2, 1)
			for (x = 20; x >= 2; x -= 0.5) touch(x, 2)
			print "RAPID"; go(2, 2, 20); print "FINI"
		}' >"$1"
}
linked "$TMP/round.cl" round
linked "$TMP/bent.cl" bent
linked "$TMP/over.cl" over # its axis leans to the other side at the end
# motions FILE: how many of the second pass touch nothing; a curve is one
motions() {
	awk '/PASS\/2/ { on = 1 } /^RAPID/ { on = 0 } /CONTCT/ { touches = 1 }
		/MOVNRB\/ON/ { n += on && !touches; touches = 0; listed = 1 } /MOVNRB\/OFF/ { listed = 0 }
		/^GOTO/ && !listed { n += on && !touches; touches = 0 } END { print n + 0 }' "$1"
}
ok "a link of 16 motions" test "$(motions "$TMP/round.cl")" = 16
for fit in biarcfit bsplfit; do
	$fit -q -e 0.01 -g "$TMP/plane.xyz" "$TMP/round.cl" >"$TMP/out.cl"
	below "$fit: a round link is a few curves" "$(motions "$TMP/out.cl")" 6
	$fit -q -e 0.01 "$TMP/round.cl" >"$TMP/out.cl"
	ok "$fit: without a scan to keep clear of it stays" test "$(motions "$TMP/out.cl")" = 16
	$fit -q -e 0.01 -g "$TMP/plane.xyz" "$TMP/over.cl" >"$TMP/out.cl"
	below "$fit: on both sides of the pole a link is a few curves" "$(motions "$TMP/out.cl")" 11
	ok "$fit: and goes through it" grep -q '0\.000000000,0\.000000000,1\.000000000$' "$TMP/out.cl"
	$fit -q -e 0.01 -g "$TMP/plane.xyz" "$TMP/bent.cl" >"$TMP/out.cl"
	ok "$fit: one with straight sides takes no more motions" \
		test "$(motions "$TMP/out.cl")" -le "$(motions "$TMP/bent.cl")"
done
# A fit that is closer than its path looks at the scan as the path's maker did: by a closer look a
# wall has its rims elsewhere, and what the path was kept clear of would be told as in the part.
awk 'function jitter() { seed = (seed * 1103 + 12345) % 65536; return 0.3 * (seed / 65536 - 0.5) }
BEGIN { seed = 3; for (i = 0; i < 17; i++) for (j = 0; j < 17; j++) {
	x = 0.6 * i + jitter(); y = 0.6 * j + jitter()
	printf "%.5f %.5f %.5f\n", x, y, 3 / (1 + exp((sqrt((x - 5)^2 + (y - 5)^2) - 2.5) / 0.25)) } }' \
	>"$TMP/wall.xyz"
cd "$TMP" || exit 1
cloud2mesh -q -o wall.ply wall.xyz
status 0 "a wall: a path within 0.01" meshnorm -q -r 1 --scallop 0.05 --avoid -o wall.cl wall.ply
for fit in biarcfit bsplfit; do
	for e in 0.01 0.002; do
		status 0 "$fit -e $e of it" $fit -q -e $e -o fitted.cl wall.cl
		status 0 "... a program" ncpost -q -m table-ac -c siemens -o fitted.mpf fitted.cl
		status 0 "... accepted" ncverify -q -m table-ac -g wall.xyz fitted.mpf
	done
	status 0 "$fit -e 0.002 of the fit within 0.002" $fit -q -e 0.002 -o again.cl fitted.cl
done
done_testing

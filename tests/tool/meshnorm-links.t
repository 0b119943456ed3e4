#!/bin/sh
# meshnorm-links.t - what leads from row to row, with the whole tool, on a scan with steep walls:
# few retracts, nothing in the part at rapid or feed, by a judge that shares nothing with the
# writers; what no way leads to is told.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A mesa 6 mm high with flanks of 70 degrees, and beside it a round hole in the scan.
awk 'BEGIN { for (i = 0; i <= 40; i++) for (j = 0; j <= 40; j++) {
		x = -10 + i / 2; y = -10 + j / 2; r = sqrt((x - 0.1) ^ 2 + (y - 0.06) ^ 2)
		if ((x - 7) ^ 2 + (y - 6) ^ 2 < 4) continue
		z = 6 - (r - 3) * 2.747; if (r < 3) z = 6; if (z < 0) z = 0
		printf "%.4f %.4f %.4f\n", x, y, z } }' >"$TMP/mesa.xyz"
ok "a mesh" cloud2mesh -q -t 1 -o "$TMP/mesa.ply" "$TMP/mesa.xyz"
status 0 "a path" meshnorm -v -r 3 --avoid --partno MESA -g "$TMP/mesa.xyz" -o "$TMP/mesa.cl" "$TMP/mesa.ply"
high=$(sed -n 's/.* down, \([0-9]*\) over the clearance plane.*/\1/p' "$TMP/err")
rows=$(sed -n 's/.* points in \([0-9]*\) passes.*/\1/p' "$TMP/err")
below "retracts are few: one for ten rows at most" "${high:-999}" "$((${rows:-0} / 10))"
ok "no rapid begins in the part: feed first" awk '
	/^RAPID/ { rapid = 1; next }
	/^\$\$-> CONTCT/ { touches = 1; next }
	/^GOTO/ { if (rapid && touches) bad = 1; touched = touches; touches = rapid = 0 }
	END { exit bad }' "$TMP/mesa.cl"

# With a wide holder close above: it turns only over everything.
status 0 "a path with a holder" meshnorm -v -r 3 --flute 8 --holder 3:25+12:30 --avoid \
	-g "$TMP/mesa.xyz" -o "$TMP/held.cl" "$TMP/mesa.ply"
judged() { # PATH FITTER: fitted, a program, judged
	status 0 "$1: $2" $2 -q -e 0.01 -g "$TMP/mesa.xyz" -o "$TMP/fitted.cl" "$TMP/$1.cl"
	ok "$1, $2: a program" ncpost -q -c siemens -o "$TMP/$1.mpf" "$TMP/fitted.cl"
	ncverify --partial --left 2 -r 3 -g "$TMP/mesa.xyz" -e 0.012 "$TMP/$1.mpf" 2>"$TMP/verdict" >"$TMP/report"
	hasnt "$1, $2: nothing of the tool in the part, by another reader" \
		'(ball|shaft|flute|holder) (goes|is|touches)|deeper|gouge' "$TMP/verdict"
	awk 'match($0, / F[0-9.]+/) { f = substr($0, RSTART + 2, RLENGTH - 2) + 0
			if (least == "" || f < least) least = f } END { print least }' "$TMP/$1.mpf" >"$TMP/least"
	below "$1, $2: no feed below 0.05 mm/min" 0.05 "$(cat "$TMP/least")"
}
judged mesa biarcfit
judged held bsplfit

# A clearance plane lower than the holder reaches down: the tool turns higher than that.
status 0 "a low clearance plane" meshnorm -q -r 3 --flute 8 --holder 3:25+12:30 --avoid --clearance 6.5 \
	-g "$TMP/mesa.xyz" -o "$TMP/held.cl" "$TMP/mesa.ply"
ok "a low clearance plane: a program" ncpost -q -c siemens -o "$TMP/held.mpf" "$TMP/held.cl"
ncverify --partial --left 2 -r 3 -g "$TMP/mesa.xyz" -e 0.012 "$TMP/held.mpf" 2>"$TMP/verdict" >"$TMP/report"
hasnt "a low clearance plane: clear in every move" '(ball|shaft|flute|holder) (goes|is|touches)|deeper|gouge' "$TMP/verdict"
done_testing

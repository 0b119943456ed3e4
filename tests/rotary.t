#!/bin/sh
# Rotary motion of ncpost: what it makes of paths whose tool axis turns.
# shellcheck disable=SC2016 # $ of CL files
. "${SRC:-$(dirname "$0")/..}/tests/lib.sh"

# Plain points are read a quicker way than statements with a comment or in lower case: same program.
awk 'BEGIN {
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\n$$-> CLOUDMILL/1\nRAPID\nGOTO/0,0,60,0,0,1\nFEDRAT/MMPM,500"
	for (i = 0; i < 3000; i++) {
		t = i / 400; a = 0.3 * sin(t); b = 0.25 * cos(t * 1.3) + 0.05
		printf "$$-> CONTCT/%.6f,%.6f,%.6f,0,0,1\n", i / 10, 1, -0.5
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", i / 10, t, 5 * sin(t), a, b, sqrt(1 - a * a - b * b)
		if (i % 50 == 0) printf "GOTO/ %d , -1.5 ,2\n", i / 10
	}
	print "FINI"
}' >"$TMP/plain.cl"
sed 's/^GOTO.*/& $$ here/; s/^\$\$-> CONTCT/$$-> contct/' "$TMP/plain.cl" >"$TMP/rich.cl"
sed 's/$/\r/' "$TMP/plain.cl" >"$TMP/crlf.cl"
for way in plain rich crlf; do
	ok "ncpost reads $way points" ncpost -q -c fanuc --contact-feed -o "$TMP/$way.nc" "$TMP/$way.cl"
	grep -v -i "$way" "$TMP/$way.nc" >"$TMP/$way.txt"
done
same "points with comments say the same" "$TMP/plain.txt" "$TMP/rich.txt"
same "points of CRLF files say the same" "$TMP/plain.txt" "$TMP/crlf.txt"
sed '2500s/,/,x/' "$TMP/plain.cl" >"$TMP/bad.cl"
status 1 "a bad number among plain points" ncpost -q -c fanuc "$TMP/bad.cl"
has "is named with its line" 'bad.cl:2500: found `X[0-9.-]*. in' "$TMP/err"

done_testing

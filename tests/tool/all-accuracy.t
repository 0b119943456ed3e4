#!/bin/sh
# all-accuracy.t - a part of the table of `make accuracy` that takes seconds: no gouge and nothing
# left beyond what tolerance, scallop and noise allow, on surfaces known exactly.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
CLOUD=${CLOUD:-$SRC/build/tests/accuracy/cloud}
export CLOUD
cd "$TMP" || exit 1

# rows N SHAPES PATTERNS NOISE FITTERS: so many of them, all within
rows() {
	status 0 "$2, $3, noise $4, $5" env SHAPES="$2" PATTERNS="$3" NOISE="$4" FITTERS="$5" SEED=4 SCANS= \
		sh "$SRC/tests/accuracy/accuracy.sh"
	sed 's/^/# /' out
	[ "$(grep -c "^[a-z]* *[0-9]" out)" = "$1" ]
	result $? "$1 rows of it"
}
rows 1 bowl:8 lines 0.05 biarcfit
rows 1 saddle:8 grid 0.02 bsplfit

status 1 "what is deeper is told" env SHAPES=bowl:8 PATTERNS=grid NOISE=0 FITTERS=none SCANS= DEPTH=0.0001 \
	sh "$SRC/tests/accuracy/accuracy.sh"
has "with its row" '^bowl .* 0\.000[0-9] .*beyond$' out
done_testing

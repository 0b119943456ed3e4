#!/bin/sh
# all-awkward.t - what users really feed to the tools (tests/data/awkward/README.md): each run in
# its expected.csv comes out as that says.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
awkward=$SRC/tests/data/awkward
make=$awkward/make_awkward.py

# A tool with a sanitizer in it does not start within the 2 GiB that all others must do with.
limit=
(
	# shellcheck disable=SC3045 # where a shell has no -v, the limit is left away
	ulimit -v 2097152 && cloud2mesh -V
) >/dev/null 2>&1 || limit=--no-limit
[ -z "$limit" ] || skip "in 2 GiB of memory" "no limit here, or a sanitizer is built in"

# One line for each run that does not hold, and `N of M` last.
rows_hold() { # TOOL DIR WHAT
	python3 "$make" $limit --tool "$1" --check "$BIN" "$2" >"$TMP/rows" 2>&1
	code=$?
	sed '$d' "$TMP/rows" >"$TMP/err"
	total=$(sed -n '$s/^[0-9]* of \([0-9]*\)$/\1/p' "$TMP/rows")
	[ "${total:-0}" -gt 0 ] || code=1
	result "$code" "$1: $(tail -n 1 "$TMP/rows") runs on $3 hold"
}

tools=$(sed -n 's/^[^,]*,\([a-z0-9]*\) .*/\1/p' "$awkward/expected.csv" | sort -u)
for tool in $tools; do
	rows_hold "$tool" "$awkward" "awkward input"
done

# The ones that are too large to keep; the others come out byte for byte as they are kept.
ok "the inputs are made" python3 "$make" --big "$TMP/made"
rows_hold cloud2mesh "$TMP/made" "lines of a megabyte and all the others"
(cd "$TMP/made" && find . -type f ! -name 'big-*' ! -name expected.csv) | while read -r file; do
	cmp "$TMP/made/$file" "$awkward/$file"
done >"$TMP/differs" 2>&1
empty "the inputs that are kept are those that are made" "$TMP/differs"

done_testing

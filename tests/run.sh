#!/bin/sh
# tests/run.sh - runs the unit tests in $UNITS and every tests/*.t, each with a time limit; prints
# what failed in full and one line for each, and last `N passed, N failed` over all single tests.
SRC=$(cd "$(dirname "$0")/.." && pwd)
export SRC
log=$(mktemp "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -f "$log"' EXIT
passed=0
failed=0

count() { # NAME STATUS PASSED FAILED
	passed=$((passed + $3))
	failed=$((failed + $4))
	if [ "$2" -eq 0 ] && [ "$4" -eq 0 ]; then
		printf 'ok    %-28s %d\n' "$1" "$3"
		return
	fi
	[ "$4" -eq 0 ] && failed=$((failed + 1))
	printf 'FAIL  %-28s %d passed, %d failed, exit %d\n' "$1" "$3" "$4" "$2"
	grep -v '^ok ' "$log" | sed 's/^/      /' | head -n 60
}

for unit in $UNITS; do
	CK_VERBOSITY=normal CK_DEFAULT_TIMEOUT=60 timeout 300 "$unit" >"$log" 2>&1 </dev/null
	code=$?
	# Check's closing line: 97%: Checks: 36, Failures: 1, Errors: 0
	all=$(sed -n 's/.*Checks: \([0-9]*\), Failures.*/\1/p' "$log" | awk '{ n += $1 } END { print n + 0 }')
	bad=$(sed -n 's/.*Failures: \([0-9]*\), Errors: \([0-9]*\).*/\1 \2/p' "$log" |
		awk '{ n += $1 + $2 } END { print n + 0 }')
	[ "$all" -eq 0 ] && code=1
	count "$(basename "$unit")" "$code" $((all - bad)) "$bad"
done

for test in "$SRC"/tests/*.t; do
	[ -e "$test" ] || continue
	timeout 600 sh "$test" >"$log" 2>&1 </dev/null
	code=$?
	count "$(basename "$test")" "$code" "$(grep -c '^ok ' "$log")" "$(grep -c '^not ok ' "$log")"
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

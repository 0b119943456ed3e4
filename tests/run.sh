#!/bin/sh
# tests/run.sh - runs the unit tests in $UNITS and every tests/tool/*.t and tests/house/*.t, one a processor at a time, each
# with a time limit; prints what failed in full and one line for each, and last `N passed, N failed`
# over all single tests.
SRC=$(cd "$(dirname "$0")/.." && pwd)
export SRC

if [ "${1:-}" = --one ]; then # --one FOLDER TEST: what TEST prints and its exit status, in FOLDER
	log=$2/$(basename "$3")
	case $3 in
	*.t) timeout 600 sh "$3" >"$log.log" 2>&1 </dev/null ;;
	*) CK_VERBOSITY=normal CK_DEFAULT_TIMEOUT=60 timeout 300 "$3" >"$log.log" 2>&1 </dev/null ;;
	esac
	echo $? >"$log.exit"
	exit 0
fi

logs=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$logs"' EXIT
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
	grep -v '^ok ' "$logs/$1.log" | sed 's/^/      /' | head -n 60
}

# The scripts first: they take longest.
for test in "$SRC"/tests/tool/*.t "$SRC"/tests/house/*.t $UNITS; do
	printf '%s\n' "$test"
done | xargs -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)" -n 1 sh "$0" --one "$logs"

for unit in $UNITS; do
	name=$(basename "$unit")
	log=$logs/$name.log
	code=$(cat "$logs/$name.exit")
	# Check's closing line: 97%: Checks: 36, Failures: 1, Errors: 0
	all=$(sed -n 's/.*Checks: \([0-9]*\), Failures.*/\1/p' "$log" | awk '{ n += $1 } END { print n + 0 }')
	bad=$(sed -n 's/.*Failures: \([0-9]*\), Errors: \([0-9]*\).*/\1 \2/p' "$log" |
		awk '{ n += $1 + $2 } END { print n + 0 }')
	[ "$all" -eq 0 ] && code=1
	count "$name" "$code" $((all - bad)) "$bad"
done

for test in "$SRC"/tests/tool/*.t "$SRC"/tests/house/*.t; do
	name=$(basename "$test")
	log=$logs/$name.log
	count "$name" "$(cat "$logs/$name.exit")" "$(grep -c '^ok ' "$log")" "$(grep -c '^not ok ' "$log")"
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

#!/bin/sh
# tests/run.sh - runs the unit tests in $UNITS and every *.t under tests/, one a processor at a time,
# each with a time limit, SLOWER (1) times as long where tools are slower; not those scripts whose name
# matches WITHOUT.  Prints what failed in full, and for each file one line with the tests that
# passed and the seconds it took; then what was skipped and why, how long all of it took (since
# $STARTED, in seconds since 1970), and last `N passed, N failed, N skipped` over all single tests.
SRC=$(cd "$(dirname "$0")/.." && pwd)
export SRC

now() {
	date +%s
}
began=$(now)

name() { # TEST: what it is called, and its log after it: from tests/ on
	echo "${1##*/tests/}"
}

if [ "${1:-}" = --one ]; then # --one FOLDER TEST: what TEST prints, its exit status and seconds, in FOLDER
	log=$2/$(name "$3")
	mkdir -p "$(dirname "$log")"
	case $3 in
	*.t) timeout $((600 * ${SLOWER:-1})) sh "$3" >"$log.log" 2>&1 </dev/null ;;
	*) CK_VERBOSITY=normal CK_DEFAULT_TIMEOUT=60 CK_TIMEOUT_MULTIPLIER=${SLOWER:-1} \
		timeout $((300 * ${SLOWER:-1})) "$3" >"$log.log" 2>&1 </dev/null ;;
	esac
	echo "$? $(($(now) - began))" >"$log.exit"
	exit 0
fi

logs=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$logs"' EXIT
tests=$(find "$SRC/tests" -name '*.t' | grep -vE "${WITHOUT:-none of them}" | sort)
passed=0
failed=0
skipped=0

count() { # NAME PASSED FAILED SKIPPED
	read -r status seconds <"$logs/$1.exit"
	bad=$3
	# nothing found wrong, and yet an end that is none; or nothing tested at all
	if [ "$bad" -eq 0 ] && { [ "$status" -ne 0 ] || [ $(($2 + $4)) -eq 0 ]; }; then bad=1; fi
	passed=$((passed + $2))
	failed=$((failed + bad))
	skipped=$((skipped + $4))
	note=
	[ "$4" -eq 0 ] || note=", $4 skipped"
	if [ "$bad" -eq 0 ]; then
		printf 'ok    %-40s %5d %4d s%s\n' "$1" "$2" "$seconds" "$note"
		return
	fi
	printf 'FAIL  %-40s %5d %4d s%s, %d failed, exit %d\n' "$1" "$2" "$seconds" "$note" "$3" "$status"
	grep -vE '^(ok|skip) ' "$logs/$1.log" | sed 's/^/      /' | head -n 60
}

# The scripts first: they take longest.
for test in $tests $UNITS; do
	printf '%s\n' "$test"
done | xargs -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)" -n 1 sh "$0" --one "$logs"

for unit in $UNITS; do
	name=$(name "$unit")
	# Check's closing line: 97%: Checks: 36, Failures: 1, Errors: 0
	sed -n 's/.*Checks: \([0-9]*\), Failures: \([0-9]*\), Errors: \([0-9]*\).*/\1 \2 \3/p' \
		"$logs/$name.log" | awk '{ all += $1; bad += $2 + $3 } END { print all - bad, bad + 0 }' >"$logs/checks"
	read -r good bad <"$logs/checks"
	count "$name" "$good" "$bad" 0
done

for test in $tests; do
	name=$(name "$test")
	log=$logs/$name.log
	count "$name" "$(grep -c '^ok ' "$log")" "$(grep -c '^not ok ' "$log")" "$(grep -c '^skip ' "$log")"
done

if [ "$skipped" -gt 0 ]; then
	echo "skipped, and why:"
	find "$logs" -name '*.log' -exec sed -n 's/^skip .* # //p' {} + | sort | uniq -c | sort -rn
fi
ended=$(now)
echo "took $((ended - ${STARTED:-$began})) s, $((ended - began)) s of them the tests"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]

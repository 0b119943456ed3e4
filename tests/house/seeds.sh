#!/bin/sh
# seeds.sh - the unit tests with random numbers (tests/lib/seed.h) under SEEDS other seeds each
# (20); run by `make check-seeds`.  Prints a line for each that fails, with its seed, and the
# number of runs.
cd "$(dirname "$0")/../.." || exit 1
UNITS=${UNITS:-build/tests/unit}
export UNITS

if [ "$1" = --one ]; then # UNIT SEED
	log=$UNITS/$2.$3.seed
	SEED=$3 CK_DEFAULT_TIMEOUT=${CK_DEFAULT_TIMEOUT:-60} \
		CK_TIMEOUT_MULTIPLIER=${CK_TIMEOUT_MULTIPLIER:-10} "$UNITS/$2" >"$log" 2>&1 ||
		echo "$2.c, SEED=$3: $(grep -m 1 -E ':[FE]:' "$log")"
	exit 0
fi
list=$(mktemp "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -f "$list"' EXIT
# those that include seed.h, or a header of tests/lib that does or whose source does, by however
# many steps
names=seed
known=
while [ "$known" != "$names" ]; do
	known=$names
	names=$({ echo seed && grep -lE "#include \"($known)\.h\"" tests/lib/*.[ch]; } |
		sed 's|.*/||; s|\.[ch]$||' | sort -u | paste -sd '|' -)
done
with=$(grep -lE "#include \"($names)\.h\"" tests/unit/*.c tests/unit/*/*.c tests/unit/*/*/*.c)
for source in $with; do
	unit=${source#tests/unit/}
	unit=${unit%.c}
	[ -x "$UNITS/$unit" ] || continue
	seed=0
	while [ $seed -lt "${SEEDS:-20}" ]; do
		seed=$((seed + 1))
		echo "$unit $seed"
	done
done >"$list"
runs=$(wc -l <"$list")
failed=$(xargs -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -n 2 sh tests/house/seeds.sh --one <"$list")
[ -z "$failed" ] || printf '%s\n' "$failed"
bad=$(printf '%s' "$failed" | grep -c '')
# the tool tests whose clouds and paths take SEED, under TOOL_SEEDS others (none, for they take
# long)
seed=0
while [ $seed -lt "${TOOL_SEEDS:-0}" ]; do
	seed=$((seed + 1))
	for test in $(grep -l 'ENVIRON\["SEED"\]' tests/tool/*.t); do
		runs=$((runs + 1))
		SEED=$seed sh "$test" >"$UNITS/tool.seed" 2>&1 && continue
		bad=$((bad + 1))
		echo "${test#tests/}, SEED=$seed: $(grep -m 1 '^not ok' "$UNITS/tool.seed")"
	done
done
echo "$runs runs, $bad failed"
[ $runs -gt 0 ] && [ $bad -eq 0 ]

#!/bin/sh
# fuzz.sh [READER...] - each reader of the tools (default: all of them) under libFuzzer, by `make
# fuzz`: FUZZ_SECONDS in all (default 600), shared alike, from what seeds.sh names.  Prints the runs
# of each, and how many a second; a crash, an undefined operation, a run over 5 s or over 2 GB stays
# as a file in $OUT/READER, and the exit status is 1.  Such a file, once mended, goes to
# tests/fuzz/found/READER; fuzz-found.t replays it.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
OUT=${OUT:-$SRC/build/fuzz/out}
FUZZ=${FUZZ:-$SRC/build/fuzz/tests/fuzz/fuzz}
bad=0
# shellcheck disable=SC2046 # names
[ $# -gt 0 ] || set -- $(sh "$SRC/tests/fuzz/seeds.sh")
seconds=$((${FUZZ_SECONDS:-600} / $#))
[ $seconds -gt 0 ] || seconds=1

for reader; do
	mkdir -p "$OUT/$reader/corpus" "$OUT/$reader/seeds"
	sh "$SRC/tests/fuzz/seeds.sh" "$reader" | while read -r file; do
		ln -sf "$file" "$OUT/$reader/seeds"
	done
	FUZZ_READER=$reader ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
		"$FUZZ" -max_total_time=$seconds -timeout=5 -rss_limit_mb=2048 -malloc_limit_mb=100000 \
		-max_len=8192 -print_final_stats=1 -artifact_prefix="$OUT/$reader/" "$OUT/$reader/corpus" \
		"$OUT/$reader/seeds" >"$OUT/$reader.log" 2>&1
	status=$?
	awk -v reader="$reader" '/number_of_executed_units/ { runs = $2 } /average_exec_per_sec/ { rate = $2 }
		END { printf "%-14s %9d runs, %6d a second", reader, runs, rate }' "$OUT/$reader.log"
	if [ $status -eq 0 ]; then
		echo
	else
		bad=1
		echo ": $(grep -m 1 -E 'ERROR|runtime error' "$OUT/$reader.log")"
	fi
done
exit $bad

#!/bin/sh
# fuzz.sh [READER|TOOL...] - each reader of the tools under libFuzzer and the sanitizers, from what
# seeds.sh names, and each tool of tools.txt on files with something wrong in them (hammer.c); by
# `make fuzz`: FUZZ_SECONDS in all (default 600), shared alike.  Prints the runs of each, and how many
# a second of processor time (a tool: of the clock); a crash, an undefined operation, a run over 5 s (a tool's: 10 s of processor time) or over
# 2 GB, a tool's nan stays as a file in $OUT/READER, and the exit status is 1.  Such a file, once
# mended, goes to tests/fuzz/found/READER, or for a tool into fuzz-found.t, which replays it.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
OUT=${OUT:-$SRC/build/fuzz/out}
FUZZ=${FUZZ:-$SRC/build/fuzz/tests/fuzz/fuzz}
HAMMER=${FUZZ%/*}/hammer
PATH=${FUZZ%/tests/*}/bin:$PATH
CLOUDMILL_MACHINES=$SRC/machines
export CLOUDMILL_MACHINES
bad=0
cd "$SRC" || exit 1
# shellcheck disable=SC2046 # names
[ $# -gt 0 ] || set -- $(sh tests/fuzz/seeds.sh) $(sed -n 's/^\([a-z][-a-z0-9]*\) .*/tool:\1/p' tests/fuzz/tools.txt)
seconds=$((${FUZZ_SECONDS:-600} / $#))
[ $seconds -gt 0 ] || seconds=1



# tool NAME: on broken files, which it keeps if it dies of them, takes too long or too much, or writes nan
tool() {
	line=$(sed -n "s,@,$SRC,g; s/^$1 //p" tests/fuzz/tools.txt)
	mkdir -p "$OUT/$1"
	# shellcheck disable=SC2046,SC2086 # words, and the good files by their whole names
	ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:hard_rss_limit_mb=2048 \
		"$HAMMER" ${seconds}s "${SEED:-$(date +%j)}" 10 "$OUT/$1" ${line%% -- *} -- \
		$(printf "$SRC/%s\n" ${line##* -- }) >"$OUT/$1.log" 2>&1
	status=$?
	awk -v tool="$1" -v seconds="$seconds" '/ runs: / { runs = $1; sub(/.*runs: /, ""); what = $0 }
		END { printf "%-16s %9d runs, %6.0f a second: %s\n", tool, runs, runs / seconds, what }' "$OUT/$1.log"
	[ $status -eq 0 ] || { bad=1 && sed '$d' "$OUT/$1.log"; }
}

for reader; do
	case $reader in
	tool:*)
		tool "${reader#tool:}"
		continue
		;;
	esac
	mkdir -p "$OUT/$reader/corpus" "$OUT/$reader/seeds"
	sh "$SRC/tests/fuzz/seeds.sh" "$reader" | while read -r file; do
		ln -sf "$file" "$OUT/$reader/seeds"
	done
	(
		FUZZ_READER=$reader ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
			"$FUZZ" -max_total_time=$seconds -timeout=5 -rss_limit_mb=2048 -malloc_limit_mb=100000 \
			-max_len=8192 -print_final_stats=1 -artifact_prefix="$OUT/$reader/" "$OUT/$reader/corpus" \
			"$OUT/$reader/seeds" >"$OUT/$reader.log" 2>&1
		echo $?
		times
	) >"$OUT/$reader.ended"
	status=$(head -n 1 "$OUT/$reader.ended")
	awk -F'[ms ]' -v reader="$reader" 'FNR == NR { if (FNR == 3) used = 60 * $1 + $2 + 60 * $4 + $5; next }
		/number_of_executed_units/ { runs = $0; sub(/.* /, "", runs) }
		END { printf "%-16s %9d runs, %6.0f a second of processor time", reader, runs, runs / (used + 0.01) }' \
		"$OUT/$reader.ended" "$OUT/$reader.log"
	if [ $status -eq 0 ]; then
		echo
	else
		bad=1
		echo ": $(grep -m 1 -E 'ERROR|runtime error' "$OUT/$reader.log")"
	fi
done
exit $bad

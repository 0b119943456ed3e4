#!/bin/sh
# fuzz.sh - afl++ against every reader of the tools, FUZZ_SECONDS each (default 60); run by
# `make fuzz`, which builds the tools for it in $BIN.  Crashes and hangs are what it looks for: the
# inputs that made them stay in $OUT/<reader>, and the exit status is 1.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
OUT=${OUT:-$SRC/build/fuzz/out}
SECONDS_EACH=${FUZZ_SECONDS:-60}
AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_BENCH_UNTIL_CRASH=0
AFL_NO_AFFINITY=1
export AFL_SKIP_CPUFREQ AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES AFL_NO_UI AFL_BENCH_UNTIL_CRASH
export AFL_NO_AFFINITY
bad=0

# fuzz READER "SEED-PATTERN" CMD...: the seeds are the smallest awkward files that match
fuzz() {
	name=$1 pattern=$2
	shift 2
	[ -x "$BIN/$1" ] || return 0
	rm -rf "${OUT:?}/$name" "$OUT/$name.seeds"
	mkdir -p "$OUT/$name.seeds"
	# shellcheck disable=SC2086 # patterns
	(cd "$SRC/tests/data/awkward" && ls -Sr $pattern) | head -n 12 | while read -r seed; do
		[ -f "$SRC/tests/data/awkward/$seed" ] &&
			head -c 4000 "$SRC/tests/data/awkward/$seed" >"$OUT/$name.seeds/${seed##*/}"
	done
	tool=$1
	shift
	afl-fuzz -V "$SECONDS_EACH" -m none -t 2000 -i "$OUT/$name.seeds" -o "$OUT/$name" \
		-- "$BIN/$tool" -q -j 1 "$@" >"$OUT/$name.log" 2>&1
	found=$(find "$OUT/$name" -path '*/crashes/id*' -o -path '*/hangs/id*' | wc -l)
	runs=$(sed -n 's/^execs_done *: //p' "$OUT/$name/default/fuzzer_stats" 2>/dev/null)
	echo "$name: ${runs:-no} runs, $found crashes and hangs"
	[ "${runs:-0}" -gt 0 ] && [ "$found" -eq 0 ] || bad=1
}

fuzz cloud '*.xyz *.pts *.ptx *.pcd *.obj' cloud2mesh -t 5 @@
fuzz cloud-ply 'cloud*.ply' cloud2mesh -t 5 @@
fuzz mesh 'mesh*.ply' meshnorm -r 8 @@
fuzz mesh-planes 'mesh*.ply mesh*.stl mesh.off' planecut -r 4 -s 5 -a 90 @@
fuzz iges '*.igs' nurbs2mesh -n 4 @@
fuzz step '../box.step' nurbs2mesh --partial -n 4 @@
fuzz nurbs-text '../../samples/saddle.nurbs' nurbs2mesh -n 4 @@
fuzz path 'path*.cl' ncpost -c fanuc @@
fuzz path-arcs 'path*.cl' biarcfit -e 0.1 @@
fuzz path-splines 'path*.cl' bsplfit -e 0.1 @@
cloud=$SRC/tests/data/awkward/hex-grid.xyz
fuzz program-fanuc '../golden/*.nc' ncverify -c fanuc -g "$cloud" -r 4 @@
fuzz program-siemens '../golden/*.mpf' ncverify -c siemens -g "$cloud" -r 4 @@
fuzz program-heidenhain '../golden/*.h' ncverify -c heidenhain -g "$cloud" -r 4 @@
fuzz program-linuxcnc '../golden/*.ngc' ncverify -c linuxcnc -g "$cloud" -r 4 @@
fuzz machine 'machine*.txt' ncpost -m @@ "$SRC/tests/data/awkward/path.cl"
exit $bad

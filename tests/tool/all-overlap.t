#!/bin/sh
# all-overlap.t - pipes overlap: a fitter begins with the passes that it has while the stage before
# still writes, and writes the same bytes as from a file; what is cut off is refused all the same.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

awk 'BEGIN { for (i = 0; i <= 60; i++) for (j = 0; j <= 40; j++)
	print i / 2, j / 2, 3 * sin(i / 20) * cos(j / 15) }' >"$TMP/hills.xyz"
ok "a mesh" cloud2mesh -q -o "$TMP/hills.mesh" "$TMP/hills.xyz"
ok "a path" meshnorm -q -r 3 --scallop 0.2 -o "$TMP/hills.cl" "$TMP/hills.mesh"

# Counted by the path's own lines: a point that touches, with another beside it.
touching=$(awk '/CONTCT/ { touch = 1; next }
	/^GOTO/ { if (touch) run++; else { if (run > 1) n += run; run = 0 }; touch = 0; next }
	/^RAPID/ || /^FEDRAT/ || /PASS/ { if (run > 1) n += run; run = 0; touch = 0 }
	END { if (run > 1) n += run; print n + 0 }' "$TMP/hills.cl")
feed=$(awk -F, '/^FEDRAT/ && $2 > most { most = $2 } END { printf "%.6f", most }' "$TMP/hills.cl")
has "the head says what a fitter must know of all of it" "^[\$][\$]-> RUNS/$touching,$feed\$" "$TMP/hills.cl"

# slow FILE ERR: half of its passes; the rest once ERR tells that fitting has begun (30 s at most)
slow() {
	half=$(grep -n 'PASS/' "$1" | awk -F: '{ line[NR] = $1 } END { print line[int(NR / 2)] }')
	head -n "$half" "$1"
	waits=0
	until grep -q 'fitting begins' "$2" || [ $waits -ge 300 ]; do
		sleep 0.1
		waits=$((waits + 1))
	done
	tail -n +$((half + 1)) "$1"
}

for fit in biarcfit bsplfit; do
	ok "$fit: from a file" $fit -q -o "$TMP/file.cl" "$TMP/hills.cl"
	hasnt "$fit: what is fitted has other runs" 'RUNS/' "$TMP/file.cl"
	for threads in 1 2; do
		: >"$TMP/said"
		slow "$TMP/hills.cl" "$TMP/said" | $fit -v --threads $threads -o "$TMP/pipe.cl" 2>"$TMP/said"
		has "$fit, $threads threads: begins before the path has ended" 'fitting begins while the path is read' "$TMP/said"
		same "$fit, $threads threads: the same bytes" "$TMP/file.cl" "$TMP/pipe.cl"
	done
	sed '$d' "$TMP/hills.cl" >"$TMP/cut.cl"
	status 1 "$fit: a path without its end" $fit -q -o "$TMP/none.cl" "$TMP/cut.cl"
	has "$fit: is told" 'ends without FINI' "$TMP/err"
	fails "$fit: and nothing is written" test -s "$TMP/none.cl"
	sed '/RUNS\//d' "$TMP/hills.cl" >"$TMP/other.cl"
	status 0 "$fit: a path that does not say it" $fit -v -o "$TMP/late.cl" "$TMP/other.cl"
	hasnt "$fit: is read to its end" 'fitting begins' "$TMP/err"
	same "$fit: with the same bytes" "$TMP/file.cl" "$TMP/late.cl"
done
for bad in RUNS/0,800 RUNS/5 RUNS/2.5,800 RUNS/5,0 RUNS/5,nan; do
	sed "s|RUNS/.*|$bad|" "$TMP/hills.cl" >"$TMP/bad.cl"
	status 1 "$bad" biarcfit -q -o "$TMP/none.cl" "$TMP/bad.cl"
	has "$bad: in its line" 'bad.cl:[0-9]*: ' "$TMP/err"
done
done_testing

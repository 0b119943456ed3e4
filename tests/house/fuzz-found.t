#!/bin/sh
# fuzz-found.t - the seeds of `make fuzz` and what it found, read once more; and what the hammer
# (tests/fuzz/hammer.c) found, in whole tools.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
REPLAY=${REPLAY:-$SRC/build/tests/fuzz/replay}
cd "$TMP" || exit 1

if [ -x "$REPLAY" ]; then
	for reader in $(sh "$SRC/tests/fuzz/seeds.sh"); do
		sh "$SRC/tests/fuzz/seeds.sh" "$reader" | tr '\n' '\0' >seeds
		ok "$reader: seeds read to their ends" xargs -0 -a seeds "$REPLAY" "$reader"
	done
else
	skip "seeds and cases of the fuzzers" "make check builds build/tests/fuzz/replay"
fi

# told STATUS FILE COMMAND...: ends within 10 s of processor time, with that exit status and, unless
# it is 0 or 3, with one line; no nan or inf in what is written
told() {
	want=$1 desc=$2
	shift 2
	run sh -c 'ulimit -t 10; exec "$@"' sh "$@"
	if [ "$got" -ne "$want" ]; then
		result 1 "$desc: $1 (exit $got, not $want)"
	elif [ "$got" -eq 1 ] && [ "$(grep -c "^$1: " "$TMP/err")" -ne 1 ]; then
		result 1 "$desc: $1 says one line"
	else
		hasnt "$desc: $1" '(^|[^a-zA-Z_])(nan|inf)([^a-zA-Z_]|$)' "$TMP/out"
	fi
}

mesh=$SRC/tests/data/awkward/mesh.ply
vertex() { # NUMBER "X Y Z"...: the mesh with other vertices
	cp "$mesh" mesh.ply
	while [ $# -gt 1 ]; do
		sed "$((9 + $1))s/.*/$2/" mesh.ply >next && mv next mesh.ply
		shift 2
	done
}
vertex 71 "15 15 3000000000" 89 "1e38 18 0.2981"
told 1 "two vertices as far as no part" planecut -q -j 1 -r 4 -s 2 -a 90 mesh.ply
vertex 1 "99999 0 0"
told 1 "a sliver of 100 m" planecut -q -j 1 -r 4 -s 2 -a 90 mesh.ply
told 1 "a sliver of 100 m" meshnorm -q -j 1 -r 4 --rows mesh mesh.ply
vertex 1 "0 60000 0" 100 "60000 0 0"
told 1 "more planes than can be wanted" planecut -q -j 1 -r 4 -s 0.1 mesh.ply
vertex 1 "0 0 0"
told 1 "planes for scallops that nobody sees" meshnorm -q -j 1 -r 4 --scallop 1e-12 mesh.ply
told 1 "the same, in the best direction" meshnorm -q -j 1 -r 4 --scallop 1e-12 --direction auto mesh.ply
told 1 "planes for scallops that nobody sees" planecut -q -j 1 -r 4 --scallop 1e-12 mesh.ply
vertex 97 "0 2147483647 0"
told 1 "a vertex as far as no part" meshnorm -q -j 1 -r 4 mesh.ply
told 1 "the same, in the best direction" meshnorm -q -j 1 -r 4 --direction auto mesh.ply
told 1 "the same, in the best direction" planecut -q -j 1 -r 4 --scallop 0.02 --direction auto mesh.ply
for far in 1000000. 99999999.; do
	sed "s/^N440 X[0-9.]*/N440 X$far/" "$SRC/tests/data/golden/shapes.fanuc.nc" >far.nc
	told 1 "a program that goes to X$far" ncverify -q -j 1 -c fanuc -r 4 \
		-g "$SRC/tests/data/awkward/plain.xyz" far.nc
done
sed 's/^#156=.*/#156=CARTESIAN_POINT('"''"',(0,10,0));/' "$SRC/tests/data/box.step" >crossed.step
told 3 "a face that crosses itself in thousands of places" nurbs2mesh -q -j 1 -n 4 --partial crossed.step
done_testing

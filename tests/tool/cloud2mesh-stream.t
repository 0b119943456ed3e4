#!/bin/sh
# cloud2mesh-stream.t - a cloud that is read again instead of kept gives the same mesh, the same
# messages and the same refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# alike NAME FILE OPTIONS...: both ways, their output, messages and exit status
alike() {
	name=$1 file=$2
	shift 2
	cloud2mesh -v --normals facet "$@" "$file" >"$TMP/kept.ply" 2>"$TMP/kept.log"
	want=$?
	status "$want" "$name: exit status $want" cloud2mesh -v --stream -o "$TMP/stream.ply" "$@" "$file"
	cp "$TMP/err" "$TMP/stream.log"
	[ "$want" -eq 0 ] && same "$name: the same mesh" "$TMP/kept.ply" "$TMP/stream.ply"
	same "$name: the same messages" "$TMP/kept.log" "$TMP/stream.log"
}

face=$SRC/samples/face_nefertiti_26493.xyz
alike 'a face' "$face"
alike 'finer than its points' "$face" -t 0.7 -a 33
alike 'another unit' "$face" -t 80 --max-gap 90 -u in

# a plate with a hole, gaps, a heading, comments, a row that is no number
awk 'BEGIN {
	print "X Y Z"; s = 7919 * ENVIRON["SEED"]
	for (i = 0; i < 8000; i++) {
		s = (s * 1103515245 + 12345) % 2147483648; x = s / 2147483648 * 60
		s = (s * 1103515245 + 12345) % 2147483648; y = s / 2147483648 * 40
		if ((x - 20) ^ 2 + (y - 20) ^ 2 < 64 || (x > 40 && y > 25)) continue
		printf "%.4f %.4f %.4f\n", x, y, sin(x / 5) * cos(y / 7)
		if (i % 900 == 0) print "# comment"
		if (i % 1500 == 1) print "nan 1 2"
	}
}' >"$TMP/plate.xyz"
alike 'a plate with a hole' "$TMP/plate.xyz"
alike 'empty nodes are filled' "$TMP/plate.xyz" -t 0.9
printf '0 -1 0 5\n1 0 0 6\n0 0 1 7\n0 0 0 1\n' >"$TMP/turn.txt"
alike 'placed by a matrix' "$TMP/plate.xyz" -t 1.5 --matrix "$TMP/turn.txt"

# normals of quadrics, of a cloud that nothing is taken out of
quadrics() { # NAME FILE OPTIONS...
	name=$1 file=$2
	shift 2
	cloud2mesh -v --no-features --outliers keep "$@" "$file" >"$TMP/kept.ply" 2>"$TMP/kept.log"
	status 0 "$name: by bands" cloud2mesh -v --stream --normals quadric -o "$TMP/stream.ply" "$@" "$file"
	cp "$TMP/err" "$TMP/stream.log"
	same "$name: the same mesh" "$TMP/kept.ply" "$TMP/stream.ply"
	for log in kept stream; do
		grep -e noise -e rms -e moved -e 'left out' -e 'points in,' "$TMP/$log.log" | sort >"$TMP/$log.said"
	done
	same "$name: the same is said of it" "$TMP/kept.said" "$TMP/stream.said"
}
quadrics 'quadrics of a face' "$face"
quadrics 'quadrics, turned, in inches' "$face" -t 80 --max-gap 90 -u in -a 33
quadrics 'quadrics, nodes on points' "$face" -t 4 --nodes scan --noise 0.02
quadrics 'quadrics of a plate with a hole' "$TMP/plate.xyz" -t 1.5 --noise 0 --neighbours 25
quadrics 'quadrics, placed by a matrix' "$TMP/plate.xyz" -t 1.5 --matrix "$TMP/turn.txt"
head -c 400000 "$face" | sed '$d' >"$TMP/cut.xyz"
status 0 'one thread' cloud2mesh -j 1 --stream --normals quadric -o "$TMP/one.ply" "$TMP/cut.xyz"
status 0 'four' cloud2mesh -j 4 --stream --normals quadric -o "$TMP/four.ply" "$TMP/cut.xyz"
same 'threads do not matter' "$TMP/one.ply" "$TMP/four.ply"
(cat "$TMP/cut.xyz"; echo 'one two three') >"$TMP/broken.xyz"
status 1 'a row that is none' cloud2mesh --stream --normals quadric -o "$TMP/none.ply" "$TMP/broken.xyz"
ok 'nothing is written' test ! -e "$TMP/none.ply"

# refusals
awk 'BEGIN { for (i = 0; i < 100; i++) print i, 2 * i, 3 }' >"$TMP/line.xyz"
alike 'points on one line' "$TMP/line.xyz"
printf '0 0 0\n1 0 0\n' >"$TMP/two.xyz"
alike 'two points' "$TMP/two.xyz"
alike 'a spacing too fine' "$TMP/plate.xyz" -t 0.0001
alike 'a spacing too wide' "$TMP/plate.xyz" -t 5000
{ cat "$TMP/plate.xyz" && echo 'one two three'; } >"$TMP/bad.xyz"
alike 'a row that is none' "$TMP/bad.xyz"
status 2 'outliers need the points' cloud2mesh --stream --outliers drop "$face"
status 2 'so does a mesh within an error' cloud2mesh --stream --normals quadric -e 0.1 "$face"
status 2 'so do several files' cloud2mesh --stream "$face" "$face"

# a large file is read so by itself; a pipe is not
awk 'BEGIN { for (i = 0; i < 420000; i++) { x = i % 700; y = int(i / 700)
	printf "%.4f %.4f %.4f\n", x / 7 + (i * 7919 % 97) / 999, y / 7 + (i * 7907 % 89) / 999, x * y / 1e5 } }' \
	>"$TMP/large.xyz"
cloud2mesh -q -t 1 --normals facet "$TMP/large.xyz" | sed '/^comment/d' >"$TMP/a"
cloud2mesh -q -t 1 --normals facet <"$TMP/large.xyz" | sed '/^comment/d' >"$TMP/b"
same 'a large file: the same mesh as through a pipe' "$TMP/a" "$TMP/b"

# a pipe is set aside too: the mesh of the file, with noise, and no memory that goes with points
awk 'BEGIN { for (i = 0; i < 40000; i++) { x = i % 200; y = int(i / 200)
	z = sin(x / 40) * cos(y / 30) + (i * 7919 % 1009) / 20000
	printf "%.4f %.4f %.4f\n", x / 7, y / 7, z } }' \
	>"$TMP/noisy.xyz"
for how in facet quadric; do
	cloud2mesh -q -t 1 --stream --normals $how "$TMP/noisy.xyz" | grep -v -e '^comment s' >"$TMP/a"
	cat "$TMP/noisy.xyz" | cloud2mesh -q -t 1 --stream --normals $how |
		grep -v -e '^comment s' >"$TMP/b"
	same "--normals $how: through a pipe the same mesh" "$TMP/a" "$TMP/b"
done
has 'with the noise of the scan' '^comment noise' "$TMP/b"
for cloud in line two bad; do
	cloud2mesh -q --stream "$TMP/$cloud.xyz" 2>&1 | sed 's|^[^:]*: [^:]*:||' >"$TMP/a"
	cat "$TMP/$cloud.xyz" | cloud2mesh -q --stream 2>&1 | sed 's|^[^:]*: [^:]*:||' >"$TMP/b"
	same "$cloud: the same refusal through a pipe" "$TMP/a" "$TMP/b"
done
(ulimit -f 0 && cat "$TMP/noisy.xyz" | cloud2mesh -q --stream 2>&1 >/dev/null) | cat >"$TMP/said"
has 'no room for a pipe: it says so' 'no room to set its points aside' "$TMP/said"

# points set aside in a file: no folder shows it, and where there is no room the cloud is read again
mkdir "$TMP/aside"
without_room() { # BLOCKS OPTIONS...
	(ulimit -f "$1" && shift && TMPDIR=$TMP/aside cloud2mesh -q "$@" "$TMP/large.xyz")
}
for how in '--normals facet' '--normals facet --stream' '--normals quadric --stream'; do
	# shellcheck disable=SC2086 # words
	without_room unlimited -t 1 $how >"$TMP/a"
	ok "$how: the folder is empty" test -z "$(ls -A "$TMP/aside")"
	for room in 0 2000; do
		# shellcheck disable=SC2086 # words
		without_room $room -t 1 $how | cat >"$TMP/b"
		same "$how, room for $room blocks: the same mesh" "$TMP/a" "$TMP/b"
	done
done
# shellcheck disable=SC2086 # words
TMPDIR=/nowhere/at/all cloud2mesh -q -t 1 $how "$TMP/large.xyz" >"$TMP/b"
same 'no such folder: another one serves' "$TMP/a" "$TMP/b"

done_testing

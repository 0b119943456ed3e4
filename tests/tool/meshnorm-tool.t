#!/bin/sh
# meshnorm-tool.t - the whole tool: flute, shank and holder clear of a scan with steep walls, by a
# check of its own along every line of the path; tools from files; the word that the path carries.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A floor with a steep wall on two sides and a pointed post, whose four sides the scan tells (of a
# round one it does not, and this is told): no upright tool of R 3 comes along the wall's foot
# with a tilt towards it.
awk 'BEGIN { for (i = 0; i <= 38; i++) for (j = 0; j <= 38; j++) { x = i * 0.8; y = j * 0.8
	z = 0; if (y > 22) z = (y - 22) * 6; if (x > 24) z = z > (x - 24) * 4 ? z : (x - 24) * 4
	u = (x - 9) * 0.9 + (y - 9) * 0.436; v = (y - 9) * 0.9 - (x - 9) * 0.436
	u = u < 0 ? -u : u; v = v < 0 ? -v : v; d = u > v ? u : v; if (d < 4) z = (4 - d) * 5
	if (z > 24) z = 24; print x, y, z } }' >"$TMP/walls.xyz"
status 0 "a mesh of walls" cloud2mesh -q -t 3 -o "$TMP/walls.ply" "$TMP/walls.xyz"

# depth PATH FLUTE: how deep points of the scan are in the cylinder of R 3 above the ball's centre, in
# cuts and links at feed, at steps of 1.5 mm and 6 degrees
depth() {
	awk -F '[/, ]' -v flute="$2" 'NR == FNR { px[n] = $1; py[n] = $2; pz[n++] = $3; next }
		/^RAPID/ { rapid = 1 }
		/^GOTO/ { if (have && !rapid) {
				len = sqrt(($2 - x) ^ 2 + ($3 - y) ^ 2 + ($4 - z) ^ 2)
				off = sqrt(($5 - a) ^ 2 + ($6 - b) ^ 2 + ($7 - c) ^ 2)
				m = int(len / 1.5 > off / 0.1 ? len / 1.5 : off / 0.1) + 1
				for (k = 1; k <= m; k++) { s = k / m
					u = a + s * ($5 - a); v = b + s * ($6 - b); w = c + s * ($7 - c)
					l = sqrt(u * u + v * v + w * w); u /= l; v /= l; w /= l
					cx = x + s * ($2 - x) + 3 * u; cy = y + s * ($3 - y) + 3 * v; cz = z + s * ($4 - z) + 3 * w
					for (i = 0; i < n; i++) { dx = px[i] - cx; dy = py[i] - cy; dz = pz[i] - cz
						h = dx * u + dy * v + dz * w; if (h <= 0 || h > flute) continue
						d = dx * dx + dy * dy + dz * dz - h * h
						if (d < 9 && 3 - sqrt(d) > deep) deep = 3 - sqrt(d) } } }
			x = $2; y = $3; z = $4; a = $5; b = $6; c = $7; have = 1; rapid = 0 }
		END { printf "%.4f\n", deep }' "$TMP/walls.xyz" "$1"
}
meshnorm -q -r 3 --rows mesh --avoid -g "$TMP/walls.xyz" --ball-only --axis-play 0 -o "$TMP/ball.cl" "$TMP/walls.ply"
below "the ball alone would take its flute through the walls" 0.5 "$(depth "$TMP/ball.cl" 12)"
meshnorm -q -r 3 --rows mesh --avoid -g "$TMP/walls.xyz" -o "$TMP/flute.cl" "$TMP/walls.ply"
has "the path says its tool" '^\$\$-> TOOL/FLUTE,12.000000$' "$TMP/flute.cl"
below "the flute is clear in cuts and links" "$(depth "$TMP/flute.cl" 12)" 0.012
meshnorm -q -r 3 --rows mesh --avoid -g "$TMP/walls.xyz" --axis-play 0 --flute 20 -o "$TMP/long.cl" "$TMP/walls.ply"
below "a longer one too, with axes by their rule" "$(depth "$TMP/long.cl" 20)" 0.012

# ---- tools from files, and what contradicts itself

# the post alone, with the floor about it
awk '$1 < 16 && $2 < 16' "$TMP/walls.xyz" >"$TMP/post.xyz"
cloud2mesh -q -t 3 -o "$TMP/post.ply" "$TMP/post.xyz"
status 0 "a cutter and its holder" meshnorm -v --rows mesh --avoid --tool-file ball-6 --tool-file hsk-a63-er16 \
	-o "$TMP/file.cl" "$TMP/post.ply"
has "give the ball" '^CUTTER/6.000000,3.000000,' "$TMP/file.cl"
has "and what is above it" '^\$\$-> TOOL/FLUTE,10.000000,HOLDER,3:10\+3:8\+14:17.5\+14:16.5\+31.5:26$' "$TMP/file.cl"
has "which is noted" 'tool: ball R 3, flute 10, holder 3:10' "$TMP/err"
for file in "$SRC"/tools/*.txt; do
	case $file in */ball-*) set -- --tool-file "$file" ;; *) set -- -r 8 --tool-file ball-16 --tool-file "$file" ;; esac
	meshnorm -q --rows mesh --paper "$@" -o "$TMP/any.cl" "$TMP/walls.ply" 2>>"$TMP/bad"
done
empty "all that are installed are read" "$TMP/bad"
echo 'stickout = -3' >"$TMP/bad.txt"
status 1 "a tool with a length below nothing" meshnorm --tool-file "$TMP/bad.txt" -r 3 "$TMP/walls.ply"
has "is told with its line" 'bad.txt:1: ' "$TMP/err"
status 2 "a ball of another radius" meshnorm -r 4 --tool-file ball-6 "$TMP/walls.ply"
status 2 "a holder without its place" meshnorm -r 4 --tool-file hsk-a63-er16 "$TMP/walls.ply"
status 1 "a tool that is not there" meshnorm -r 4 --tool-file ball-999 "$TMP/walls.ply"
status 2 "the ball alone with a holder" meshnorm -r 4 --ball-only --holder 5:60 "$TMP/walls.ply"
status 0 "the ball alone" meshnorm -r 3 --rows mesh --avoid --ball-only -o "$TMP/only.cl" "$TMP/walls.ply"
has "is said" 'tool: ball R 3 only' "$TMP/err"
has "and carried" '^\$\$-> TOOL/BALL-ONLY$' "$TMP/only.cl"

meshnorm -r 3 --rows mesh --avoid --flute 0 -o "$TMP/none.cl" "$TMP/walls.ply" 2>"$TMP/err"
has "no flute and no holder is the ball alone: said" 'tool: ball R 3 only' "$TMP/err"
same "... and carried" "$TMP/only.cl" "$TMP/none.cl"
for word in BALL-ONLY FLUTE,0.000000; do
	sed "s/^\(..-> TOOL\)\/.*/\1\/$word/" "$TMP/ball.cl" | ncpost -q --accept -c siemens -o "$TMP/ball.mpf"
	status 3 "a program of $word: ncverify judges the whole tool" \
		ncverify --accept --partial -g "$TMP/walls.xyz" "$TMP/ball.mpf"
	has "... and finds its shaft" '^fault .*the shaft goes .* deep into the part' "$TMP/out"
done

# ---- machines

status 0 "another machine" meshnorm -q -r 3 --rows mesh --avoid -m head-cb -o "$TMP/head.cl" "$TMP/walls.ply"
cat >"$TMP/narrow.txt" <<END
include = table-ac
a.min = -20
a.max = 20
END
status 0 "one that leans little" meshnorm -q -r 3 --rows mesh --avoid -m "$TMP/narrow.txt" -g "$TMP/walls.xyz" \
	-o "$TMP/narrow.cl" "$TMP/walls.ply"
awk -F '[/,]' '/CONTCT/ { t = 1; next } /^GOTO/ { if (t && $7 < 0.9396 - 1e-6) bad++; t = 0 } END { print bad + 0 }' \
	"$TMP/narrow.cl" >"$TMP/figures"
below "axes stay within its travel" "$(cat "$TMP/figures")" 0
status 1 "a machine that is not there" meshnorm -r 3 -m nowhere "$TMP/walls.ply"
# what is wrong without a mesh is told before one is read, which may take minutes to be made
cd "$TMP" || exit 1
printf 'radius = 3\nlength = 60\nshank = 6\nholder = 20:40\nstickout = 0\n' >nose.txt
printf '0 0\n1\n' >bad.region
for tool in meshnorm planecut; do
	for options in "--tool-file nose.txt" "-r 3 --holder 5:0" "-r 3 --holder 5:2000" "-r 3 --ball-only --flute 5" \
		"-r 3 -m nosuch" "-r 3 -m three-axis" "-r 3 --box 0,0,0,-1,1,1" "-r 3 --region bad.region" \
		"-r 3 --direction north" "-r 3 --layers 200 --depth 1000" "-r 3 -g none.xyz"; do
		# shellcheck disable=SC2086
		$tool $options none.ply >/dev/null 2>early
		grep -q 'none.ply' early && echo "$tool $options: $(head -n 1 early)"
	done
	for options in "--steep 80:20" "--faces 5,a"; do
		[ $tool = planecut ] || continue
		# shellcheck disable=SC2086
		$tool -r 3 $options none.ply 2>&1 >/dev/null | grep 'none.ply'
	done
done >late
empty "errors of usage are told before the mesh is read" late

done_testing

#!/bin/sh
# ncplot-pictures.t - every stream becomes a well-formed picture of what is in it, small whatever
# goes in.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

scan=$SRC/samples/panel_17036.xyz

# whole FILE: well-formed XML; nothing that runs or loads
whole() {
	ok "$1 is well-formed" \
		python3 -c 'import sys, xml.dom.minidom as d; d.parse(sys.argv[1])' "$TMP/$1"
	ok "$1 opens and closes its groups" test \
		"$(grep -o '<g ' "$TMP/$1" | wc -l)" -eq "$(grep -o '</g>' "$TMP/$1" | wc -l)"
	has "$1 ends" '^</svg>$' "$TMP/$1"
	hasnt "$1 runs and loads nothing" '<script|href|@import|url\(|onload' "$TMP/$1"
	hasnt "$1 has finite numbers" '[^a-z](nan|inf)[^a-z]' "$TMP/$1"
}
size() { wc -c <"$1" | tr -d ' '; }
dots() { grep -o 'h0' "$1" | wc -l | tr -d ' '; }

cloud2mesh --nodes scan -q -t 5 -o "$TMP/mesh.ply" "$scan"
meshnorm -q -r 8 --rows mesh -o "$TMP/lines.cl" "$TMP/mesh.ply"
biarcfit -q -e 0.01 -o "$TMP/arcs.cl" "$TMP/lines.cl"
bsplfit -q -e 0.01 -o "$TMP/splines.cl" "$TMP/lines.cl"

# ---- the kinds of streams

status 0 "a cloud" ncplot -v -o "$TMP/cloud.svg" "$scan"
has "its figures, grouped" '17,036 points, 74\.0 × 54\.0 × 15\.0 mm' "$TMP/err"
has "stand in the picture" '>17,036 points, ' "$TMP/cloud.svg"
has "with the name" '>panel_17036.xyz<' "$TMP/cloud.svg"
has "the plan" '>plan \(x right, y up\)<' "$TMP/cloud.svg"
has "the isometric view" '>isometric<' "$TMP/cloud.svg"
has "a scale bar" '>20 mm<' "$TMP/cloud.svg"
for size in 0.03 0.5 1.7 42 999 12345; do
	awk -v s="$size" 'BEGIN { for (i = 0; i < 9; i++) print i * s, (i % 3) * s, 0 }' >"$TMP/size.xyz"
	ncplot -q "$TMP/size.xyz" | sed -n 's/.*>\([0-9.e+-]*\) mm<.*/\1/p' |
		awk -v s="$size" '{ lead = $1; while (lead < 0.999) lead *= 10; while (lead > 9.999) lead /= 10
			print ((lead == 1 || lead == 2 || lead == 5) && $1 < 8 * s) }' >"$TMP/round"
	ok "a round one for $size mm" test "$(cat "$TMP/round")" = 1
done
below "some thousand dots" 4000 "$(dots "$TMP/cloud.svg")"
below "not more than can be seen" "$(dots "$TMP/cloud.svg")" 16000
whole cloud.svg

status 0 "a mesh" ncplot -o "$TMP/mesh.svg" "$TMP/mesh.ply"
facets=$(sed -n 's/^element face //p' "$TMP/mesh.ply")
has "its facets are counted" ">[0-9]+ vertices, $facets facets, " "$TMP/mesh.svg"
ok "and drawn, all of them from above" test \
	"$(ncplot --view plan "$TMP/mesh.ply" | grep -o z | wc -l)" -ge "$facets"
whole mesh.svg

status 0 "straight lines" ncplot -o "$TMP/lines.svg" "$TMP/lines.cl"
has "passes by colour" 'passes, in six colours' "$TMP/lines.svg"
has "rapid moves are dashed" 'stroke-dasharray' "$TMP/lines.svg"
status 0 "without rapid moves" ncplot --cut "$TMP/lines.cl"
hasnt "there are none" 'stroke-dasharray|>rapid<' "$TMP/out"
whole lines.svg
for kind in arcs splines; do
	status 0 "$kind" ncplot -o "$TMP/$kind.svg" "$TMP/$kind.cl"
	whole $kind.svg
done
has "arcs are counted" ">[0-9]+ passes, .* $(grep -c '^CIRCLE' "$TMP/arcs.cl") arcs" "$TMP/arcs.svg"
has "and named" '>arcs, by turns<' "$TMP/arcs.svg"
has "B-splines are counted" \
	"$(grep -c '^MOVNRB/OFF' "$TMP/splines.cl") B-splines of [0-9]+ control points" "$TMP/splines.svg"
hasnt "no control points unasked" '>control points<' "$TMP/splines.svg"
status 0 "control points" ncplot --poles "$TMP/splines.cl"
has "on request" '>control points<' "$TMP/out"
status 0 "by pass" ncplot --colour pass "$TMP/arcs.cl"
has "when asked" 'passes, in six colours' "$TMP/out"

# An arc is drawn as one: half a circle of radius 10 is 20 wide, 10 high, 31.4 long.
cat >"$TMP/half.cl" <<'END'
PARTNO/HALF
UNITS/MM
MULTAX/ON
GOTO/10,0,0,0,0,1
CIRCLE/0,0,0,0,0,1,10
GOTO/-10,0,0,0,0,1
FINI
END
status 0 "half a circle" ncplot -v --view plan --joints --axes -o "$TMP/half.svg" "$TMP/half.cl"
has "its length" '1 arc, 31\.4 mm of cut' "$TMP/err"
has "ends of motions are named" '>ends of motions<' "$TMP/half.svg"
has "axes too" '>tool axes<' "$TMP/half.svg"
whole half.svg

# ---- programs, as the controls run them

length() { sed -n 's/.*, \([0-9.]*\) m of cut.*/\1/p' "$TMP/err"; }
ncplot -v "$TMP/arcs.cl" >"$TMP/out" 2>"$TMP/err"
cut=$(length)
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $control -o "$TMP/arcs.$control" "$TMP/arcs.cl"
	status 0 "a program for $control" ncplot -v -o "$TMP/$control.svg" "$TMP/arcs.$control"
	below "as long as its path" "$(length)" "$(echo "$cut" | awk '{ print $1 + 0.015 }')"
	below "and no shorter" "$(echo "$cut" | awk '{ print $1 - 0.015 }')" "$(length)"
	whole $control.svg
done
ncpost -q -c siemens -o "$TMP/splines.mpf" "$TMP/splines.cl"
status 0 "a program of polynomials" ncplot --axes --poles "$TMP/splines.mpf"
# shellcheck disable=SC2016 # expanded by the inner shell
status 0 "a program from a pipe" sh -c 'cat "$1" | ncplot' - "$TMP/splines.mpf"
has "is read from its start" '>standard input<' "$TMP/out"
ncpost -q -c fanuc -o "$TMP/splines.nc" "$TMP/splines.cl"
status 0 "a program of B-splines" ncplot --axes --poles "$TMP/splines.nc"
has "with their control points" '>control points<' "$TMP/out"
ncpost -q -c fanuc -m table-bc -o "$TMP/bc.nc" "$TMP/arcs.cl"
status 0 "a program for another machine" ncplot -m table-bc "$TMP/bc.nc"
status 0 "which its head says" ncplot "$TMP/bc.nc"
status 1 "read for the wrong one" ncplot -m table-ac "$TMP/bc.nc"
status 1 "a machine that is not there" ncplot -m nowhere "$TMP/bc.nc"
head -n 40 "$TMP/bc.nc" >"$TMP/short.nc"
status 1 "a program cut off" ncplot -m table-bc "$TMP/short.nc"

# ---- from a pipe, several, views

# shellcheck disable=SC2016 # expanded by the inner shell
status 0 "from a pipe" sh -c 'cat "$1" | ncplot --title "<a> & \"b\"" -o "$2"' - \
	"$TMP/mesh.ply" "$TMP/pipe.svg"
has "told apart there too" '>[0-9]+ vertices, ' "$TMP/pipe.svg"
has "the title is escaped" '>&lt;a&gt; &amp; &quot;b&quot;<' "$TMP/pipe.svg"
whole pipe.svg
# shellcheck disable=SC2016 # expanded by the inner shell
status 0 "from a file as standard input" sh -c 'ncplot -o "$2" <"$1"' - "$scan" "$TMP/stdin.svg"
has "read from its start" '>17,036 points, ' "$TMP/stdin.svg"
status 0 "a mesh and its path" ncplot -o "$TMP/both.svg" "$TMP/mesh.ply" "$TMP/arcs.cl"
has "both are told" '>arcs.cl: ' "$TMP/both.svg"
whole both.svg
status 0 "four views" ncplot --view all "$TMP/mesh.ply"
for view in plan isometric front side; do
	has "$view" ">$view" "$TMP/out"
done
status 0 "normals" ncplot --show-normals "$TMP/mesh.ply"
has "are named" '>normals<' "$TMP/out"
status 0 "compared" ncplot --compare -o "$TMP/compare.svg" "$TMP/lines.cl" "$TMP/arcs.cl"
has "a name for each" '>lines.cl<' "$TMP/compare.svg"
has "and the other" '>arcs.cl<' "$TMP/compare.svg"
whole compare.svg
# the same cloud 0.25 mm higher is 0.25 mm away at most, and no less where it is level
awk '{ print $1, $2, $3 + 0.25 }' "$scan" >"$TMP/higher.xyz"
status 0 "a cloud and a higher one" \
	ncplot --compare -o "$TMP/compare.svg" "$scan" "$TMP/higher.xyz"
worst=$(sed -n 's/.*higher.xyz from .*worst \([0-9.]*\) mm at .*/\1/p' "$TMP/err")
below "how far they are apart" "$worst" 0.25
below "and no less" 0.2 "$worst"
has "both ways" 'from higher.xyz: worst 0\.2[0-9]* mm at' "$TMP/err"
has "in the title too" '>higher.xyz from .*: worst 0\.2[0-9]* mm' "$TMP/compare.svg"
has "with rings" 'stroke="#d00000"' "$TMP/compare.svg"

# ---- the same bytes; small

status 0 "again" ncplot -j 3 -o "$TMP/again.svg" "$scan"
same "the same bytes" "$TMP/cloud.svg" "$TMP/again.svg"
awk 'BEGIN { for (i = 0; i < 300000; i++) { x = (i % 600) / 10; y = int(i / 600) / 10
	printf "%.3f %.3f %.3f\n", x, y, 5 * sin(x / 8) } }' >"$TMP/many.xyz"
status 0 "300,000 points" ncplot -o "$TMP/many.svg" "$TMP/many.xyz"
below "are a small picture" "$(size "$TMP/many.svg")" 300000
awk 'BEGIN { print "PARTNO/MANY\nUNITS/MM\nMULTAX/ON"
	for (p = 0; p < 400; p++) { print "$$-> PASS/" p + 1
		for (i = 0; i < 200; i++) { x = p % 2 ? 200 - i : i
			printf "GOTO/%.3f,%.3f,%.3f,0,0,1\n", x, p / 2, 9 * sin(x) } }
	print "FINI" }' >"$TMP/many.cl"
status 0 "400 passes of 200 lines" ncplot -o "$TMP/passes.svg" "$TMP/many.cl"
below "are a small picture" "$(size "$TMP/passes.svg")" 400000

# ---- by the speed that the machine reaches: a corner in a long line, and all of it is drawn
{
	echo %; echo O0001; echo "N10 G90 G17 G21 G40 G49 G80 G94 G54"; echo "N20 G91 G28 Z0."; echo "N30 G90"
	echo "N40 S8000 M3"; echo "N50 G0 A0. C0."; echo "N60 G43.4 H1"; echo "N70 G0 X0. Y0."; echo "N80 Z50."
	echo "N90 G1 Z0. F6000."; echo "N100 X0.3"; echo "N110 Y0.3"; echo "N120 X0.6"; echo "N130 X200."
	echo "N140 G0 Z50."; echo "N150 G49"; echo "N160 G91 G28 Z0."; echo "N170 G90 M5"; echo "N180 M30"; echo %
} >"$TMP/corner.nc"
status 0 "a program by its speed" ncplot --speed --view plan -o "$TMP/speed.svg" "$TMP/corner.nc"
whole speed.svg
has "the legend says it" 'speed: none to the whole feed' "$TMP/speed.svg"
for colour in $(grep -o '^<path.*stroke="#[0-9A-F]*" stroke-width="12"' "$TMP/speed.svg" | grep -o '#[0-9A-F]*'); do
	echo "$colour"
done | sort -u >"$TMP/colours"
below "the corner is slower than the line" 2 "$(wc -l <"$TMP/colours")"
status 1 "a path has no speeds" ncplot --speed "$TMP/lines.cl"
status 2 "speed and passes" ncplot --speed --colour pass "$TMP/corner.nc"

# ---- odd and wrong input

echo "5 5 5" >"$TMP/one.xyz"
status 0 "one point" ncplot -o "$TMP/one.svg" "$TMP/one.xyz"
whole one.svg
printf 'PARTNO/E\nUNITS/MM\nFINI\n' >"$TMP/empty.cl"
status 1 "a path without motion" ncplot "$TMP/empty.cl"
has "is said" 'nothing to draw' "$TMP/err"
: >"$TMP/nothing"
status 1 "an empty file" ncplot -o "$TMP/none.svg" "$TMP/nothing"
ok "leaves nothing" test ! -e "$TMP/none.svg"
head -n 20 "$TMP/lines.cl" >"$TMP/cut.cl"
status 1 "a path cut off" ncplot "$TMP/cut.cl"
status 1 "a file that is not there" ncplot "$TMP/missing"
status 2 "one stream to compare" ncplot --compare "$scan"
status 2 "an unknown view" ncplot --view above "$scan"

done_testing

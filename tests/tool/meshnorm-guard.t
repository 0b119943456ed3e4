#!/bin/sh
# meshnorm-guard.t - the scan that a mesh and a path name: all later tools guard by it unless told
# otherwise, placed as it was, and tell when it is gone or another.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A hill.
awk 'BEGIN { for (i = 0; i <= 60; i++) for (j = 0; j <= 40; j++) {
	x = i / 2; y = j / 2; printf "%.4f %.4f %.4f\n", x, y, 3 + sin(x / 5) * cos(y / 6) } }' >hill.xyz
cloud2mesh -q -t 2 hill.xyz >hill.ply 2>/dev/null
has "the mesh names its scan" '^comment scan 2501 [0-9a-f]{16} hill.xyz$' hill.ply

# What is guarded is seen in the path: its lines are checked against the scan, or it has a CHORD.
meshnorm -q --rows mesh -r 2 hill.ply >default.cl
meshnorm -q --rows mesh -r 2 -g hill.xyz hill.ply >given.cl
meshnorm -q --rows mesh -r 2 --no-guard hill.ply >none.cl
same "the scan guards as if it were given" default.cl given.cl
has "the path names it" '^\$\$-> SCAN/2501,[0-9a-f]{16},hill.xyz$' default.cl
has "--no-guard: only the mesh" '^\$\$-> CHORD' none.cl
hasnt "--no-guard: no scan is named" 'SCAN' none.cl
status 2 "-g and --no-guard" meshnorm -r 2 -g hill.xyz --no-guard hill.ply
planecut -q -r 2 -s 2 hill.ply >cut.cl
has "planecut names it" '^\$\$-> SCAN/2501,[0-9a-f]{16},hill.xyz$' cut.cl
planecut -q -r 2 -s 2 --no-guard hill.ply >cut.cl
hasnt "planecut --no-guard" 'SCAN' cut.cl

# A path that goes 0.2 mm too deep, with the scan in its head.
awk '/CONTCT/ { n++ } /^GOTO/ && n > 20 && n < 40 { split($0, v, ","); v[3] -= 0.2
	printf "%s,%s,%.6f,%s,%s,%s\n", v[1], v[2], v[3], v[4], v[5], v[6]; next } { print }' default.cl >deep.cl
for fit in biarcfit bsplfit; do
	$fit -v -o out.cl deep.cl 2>log
	has "$fit guards by the scan of the path" 'points lifted by at most 0\.|too deep|deeper than' log
	has "$fit carries it on" '^\$\$-> SCAN/2501,[0-9a-f]{16},hill.xyz$' out.cl
	$fit -v --no-guard -o out.cl deep.cl 2>log
	hasnt "$fit --no-guard" 'lifted by|deeper than|guard' log
	hasnt "$fit --no-guard: names none" 'SCAN' out.cl
	$fit -v --paper -o out.cl deep.cl 2>log
	hasnt "$fit --paper: as published" 'lifted by|deeper than' log
	status 2 "$fit: -g and --no-guard" $fit -g hill.xyz --no-guard deep.cl
done

# Turned and in inches: the scan follows.
printf '0 -1 0 50\n1 0 0 -20\n0 0 1 7\n0 0 0 1\n' >turn.txt
cloud2mesh -q -u inch --matrix turn.txt -t 50 hill.xyz 2>/dev/null >inch.ply
meshnorm -q --rows mesh -r 50 -e 0.1 --avoid inch.ply >inch.cl 2>log
has "a placed mesh" '^\$\$-> PLACE/1,0,-25.4,0,50$' inch.cl
has "its third row" '^\$\$-> PLACE/3,0,0,25.4,7$' inch.cl
for fit in biarcfit bsplfit; do
	status 0 "$fit places the scan as the mesh was" $fit -v -e 0.1 -o out.cl inch.cl
	has "$fit says so" 'placed as' "$TMP/err"
	has "$fit has looked at it" 'guarded by' "$TMP/err"
	has "$fit hands the place on" '^\$\$-> PLACE/2,25.4,0,0,-20$' out.cl
	status 0 "$fit places -g likewise" $fit -q -e 0.1 -g hill.xyz -o other.cl inch.cl
	same "$fit: with the same result" out.cl other.cl
done

# Gone, changed, piped in; and several files.
mkdir elsewhere
for tool in "meshnorm --rows mesh -r 2 ../hill.ply" "biarcfit ../default.cl" "bsplfit ../default.cl" \
	"planecut -r 2 -s 3 ../hill.ply"; do
	(cd elsewhere && $tool -o /dev/null 2>../log)
	has "${tool%% *}: a scan that is gone" "hill.xyz: cannot open" log
done
sed '7s/3\./3.1/;8s/3\./2.9/' hill.xyz >elsewhere/hill.xyz
(cd elsewhere && meshnorm --rows mesh -r 2 ../hill.ply -o gone.cl 2>../log)
has "other points" 'hill.xyz: found other points, as many: it has changed; guarded by the mesh alone' log
has "the path names it nevertheless" '^\$\$-> SCAN/2501,[0-9a-f]{16},hill.xyz$' elsewhere/gone.cl
head -n 2000 hill.xyz >elsewhere/hill.xyz
(cd elsewhere && biarcfit ../default.cl -o /dev/null 2>../log)
has "fewer points" 'hill.xyz: found 2000 points, expected 2501: it has changed; what is fitted is not checked' log
cloud2mesh -q -t 2 <hill.xyz 2>/dev/null | meshnorm --rows mesh -r 2 -o piped.cl 2>log
has "a scan that was piped in" 'read from standard input; guarded by the mesh alone' log
has "its name is a hyphen" '^\$\$-> SCAN/2501,[0-9a-f]{16},-$' piped.cl
head -n 1200 hill.xyz >'one half$'
tail -n +1201 hill.xyz >'other, half'
cloud2mesh -q -t 2 'one half$' 'other, half' 2>/dev/null | meshnorm -q --rows mesh -r 2 -o halves.cl
bsplfit -q halves.cl -o halves.fit 2>log
empty "two files with odd names" log
has "a dollar at the end is doubled" '^\$\$-> SCAN/1200,[0-9a-f]{16},one half\$\$$' halves.fit
grep -v 'SCAN\|PARTNO' halves.cl >a
grep -v 'SCAN\|PARTNO' default.cl >b
same "the same points, the same path" a b
sed 's/SCAN.2501,/SCAN\/many,/' default.cl >bad.cl
status 1 "no count" biarcfit bad.cl
has "is told with its line" 'bad.cl:[0-9]+: found .*SCAN/many' "$TMP/err"
sed 's/^comment scan 2501 /comment scan /' hill.ply >bad.ply
status 1 "no count in the mesh" meshnorm -r 2 bad.ply

# Over points that noise has moved the centre rises a little to run smoothly, and no more.
awk 'BEGIN { srand(4 + ENVIRON["SEED"]); for (i = 0; i < 4000; i++) { x = 20 * rand(); y = 20 * rand()
	printf "%.4f %.4f %.4f\n", x, y, 0.1 * x + 0.002 * rand() } }' >rough.xyz
cloud2mesh -q -t 1.5 rough.xyz >rough.ply 2>/dev/null
for smooth in 0 0.005; do
	meshnorm -q -r 3 --noise 0 --fixed 0,0,1 --smooth $smooth --avoid -o rough.cl rough.ply 2>/dev/null
	awk -F'[/,]' 'function inside(x, y) { return x > 3 && x < 17 && y > 3 && y < 17 }
	/^RAPID/ { n = 0 }
	/^GOTO/ {
		if (n > 0) next_slope = ($4 - z) / (0.001 + sqrt(($2 - x) ^ 2 + ($3 - y) ^ 2))
		if (n > 1 && (next_slope - slope) ^ 2 < 0.01 && inside(x, y) && inside($2, $3)) sum += (next_slope - slope) ^ 2
		slope = next_slope; x = $2; y = $3; z = $4; n++; count++
	}
	END { print sum / count }' rough.cl
done >bends
say="$(tr '\n' ' ' <bends)"
ok "a path bends less with --smooth: $say" awk 'NR == 1 { a = $1 } NR == 2 { less = $1 < 0.2 * a }
	END { exit !less }' bends
status 2 "not below 0" meshnorm -r 3 --smooth -1 rough.ply

# The noise that a scan is said to have is said to the next tool, too: one that measures it holds
# what is fitted against another surface.
awk 'BEGIN { srand(5 + ENVIRON["SEED"]); for (i = 0; i < 3000; i++) { x = 20 * rand(); y = 20 * rand()
	for (k = z = 0; k < 12; k++) z += rand() - 0.5
	printf "%.4f %.4f %.4f\n", x, y, x * y / 80 + 0.008 * z } }' >noisy.xyz
cloud2mesh -q -t 1.5 noisy.xyz >noisy.ply 2>/dev/null
meshnorm -q -r 3 --avoid --noise 0.002 -o said.cl noisy.ply
has "the path says it" '^\$\$-> NOISE/0.002000$' said.cl
biarcfit -v said.cl >arcs.cl 2>err
has "the fitter takes it" 'noise of 0.002 mm taken out' err
has "and says so" 'noise of the scan: 0.002 mm, as the path says' err
biarcfit -v --noise 0.01 said.cl >arcs.cl 2>err
has "unless it is given another" 'noise of 0.01 mm taken out' err
has "which it says in turn" '^\$\$-> NOISE/0.010000$' arcs.cl
meshnorm -q -r 3 --avoid -o said.cl noisy.ply
hasnt "nothing is said of what is measured" '^\$\$-> NOISE' said.cl

# Pyramids of five points a side, turned, and noise: nobody can tell one from the other.
awk 'BEGIN { srand(7 + ENVIRON["SEED"])
	for (b = 0; b < 24; b += 0.5) for (a = 0; a < 24; a += 0.5) {
	x = 0.97 * a - 0.24 * b + 20; y = 0.24 * a + 0.97 * b
	u = x - 2.5 * int(x / 2.5) - 1.25; v = y - 2.5 * int(y / 2.5) - 1.25; u = u < 0 ? -u : u
	v = v < 0 ? -v : v; for (k = z = 0; k < 12; k++) z += rand() - 0.5
	printf "%.4f %.4f %.4f\n", a, b, 1.25 - (u > v ? u : v) + 0.02 * z } }' >knurl.xyz
cloud2mesh -q -t 1 knurl.xyz >knurl.ply 2>/dev/null
meshnorm -r 3 --avoid knurl.ply >knurl.cl 2>err
has "noise that cannot be told from a knurl is taken as none, which is said" \
	'noise cannot be told from the shape of the scan, .* mm off smooth surfaces: taken as none' err
meshnorm -r 3 --avoid --noise 0.02 knurl.ply >knurl.cl 2>err
hasnt "not where it is given" 'noise cannot be told' err
meshnorm -r 3 --avoid noisy.ply >knurl.cl 2>err
hasnt "nor where it is measured" 'noise cannot be told' err

# A larger tolerance finds no edge that a smaller one does not: nine times as many were told.
awk '$2 > -30 && $2 < 10' "$SRC/samples/face_nefertiti_26493.xyz" >face.xyz # eyes and nose
cloud2mesh -q -t 2 face.xyz >face.ply 2>/dev/null
for e in 0.01 0.05; do
	meshnorm -r 5 -e $e --scallop 1 face.ply 2>&1 >face.cl |
		sed -n 's/.* edge not resolved at .*, one of \([0-9]*\) such points.*/\1/p'
done >edges
say="$(tr '\n' ' ' <edges)"
ok "a larger tolerance finds no more edges: $say" awk 'NR == 1 { a = $1 } NR == 2 { b = $1 }
	END { exit !(a > 0 && b <= 1.1 * a) }' edges
# ---- ground as rough as its points are apart: of what is between them nothing is known

awk 'BEGIN { seed = 11; for (i = 0; i < 24; i++) for (j = 0; j < 24; j++) {
	seed = (seed * 16807) % 2147483647
	printf "%.3f %.3f %.3f\n", i, j, seed / 2147483647 } }' >rough.xyz
cloud2mesh -q --nodes scan -o rough.ply rough.xyz 2>err
meshnorm -r 2 --avoid --ball-only --noise 0 -g rough.xyz -o rough.cl rough.ply 2>err
has "a scan too sparse at all points for the ball is told" \
	'^[$][$]-> UNMET/.*the scan is too sparse at 57[0-9] points' rough.cl
meshnorm -r 4 --avoid --ball-only --noise 0 -g rough.xyz -o rough.cl rough.ply 2>err
has "not for a larger one, which stays above it" 'the scan is too sparse at 5' err
hasnt "that ends with 3 by it" '^[$][$]-> UNMET/.*too sparse' rough.cl

# Waves under lines half a radius apart, of which most points do not know what is between these.
awk 'BEGIN { for (y = -15; y <= 15; y += 3) for (x = -15; x < 15; x += 0.7) {
	u = x + 0.1 * sin(70 * x + y)
	printf "%.4f %.4f %.4f\n", u, y, 2 * cos(6.283185 * (y + 0.3 * u) / 13) } }' >lines.xyz
cloud2mesh -q -o lines.ply lines.xyz 2>err
meshnorm -r 5 --scallop 0.1 --avoid -g lines.xyz -o lines.cl lines.ply 2>err
has "lines too far apart for the ball are told" '^[$][$]-> UNMET/.*the scan is too sparse' lines.cl
meshnorm -r 12 --scallop 0.1 --avoid -g lines.xyz -o lines.cl lines.ply 2>err
hasnt "not for a larger one, that ends with 3 by it" '^[$][$]-> UNMET/.*too sparse' lines.cl

done_testing

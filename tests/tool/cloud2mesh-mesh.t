#!/bin/sh
# cloud2mesh-mesh.t - from scanned points to the mesh stream: counts, order, placing, normals,
# refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz
face=$SRC/samples/face_nefertiti_26493.xyz

# body FILE: the vertices and facets alone
body() {
	sed '1,/^end_header/d' "$1"
}

# number WHAT FILE: of vertices or faces
number() {
	sed -n "s/^element $1 //p" "$2"
}

# mesh NAME OPTIONS...: $TMP/NAME.ply and $TMP/NAME.err, standard input from the panel
mesh() {
	name=$1
	shift
	cloud2mesh "$@" >"$TMP/$name.ply" 2>"$TMP/$name.err"
}

# box FILE: xmin xmax ymin ymax of the vertices
box() {
	awk '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next }
		body && k++ < n {
			if (k == 1) { a = b = $1; c = d = $2 }
			if ($1 < a) a = $1
			if ($1 > b) b = $1
			if ($2 < c) c = $2
			if ($2 > d) d = $2
		}
		END { printf "%.3f %.3f %.3f %.3f\n", a, b, c, d }' "$1"
}

# counts of the paper's examples, by an independent program
mesh paper -t 4 --paper "$panel"
has "panel, --paper, t 4: 348 vertices" '^element vertex 348$' "$TMP/paper.ply"
hasnt "--paper: facet normals, nothing spent" '^comment ledger' "$TMP/paper.ply"
hasnt "--paper: no curvature" 'kmax' "$TMP/paper.ply"
mesh face4 -t 4 --paper "$face"
has "face, --paper, t 4: 974 vertices" '^element vertex 974$' "$TMP/face4.ply"
result "$(body "$TMP/face4.ply" | head -n 974 | cut -d' ' -f1-3 | sort -u | wc -l | awk '{ print $1 != 971 }')" \
	"face, --paper, t 4: on 971 different points"
mesh face38 -t 3.8 --paper "$face"
has "face, --paper, t 3.8: 1085 vertices" '^element vertex 1085$' "$TMP/face38.ply"
mesh plain -v --nodes scan -t 4 "$panel"
has "panel, t 4: 325 vertices" '^element vertex 325$' "$TMP/plain.ply"
has "the stream names itself" '^comment cloudmill mesh 1$' "$TMP/plain.ply"
has "the stream says its spacing" '^comment spacing 4$' "$TMP/plain.ply"
has "the stream says what it spent" '^comment ledger cloud2mesh 0\.00' "$TMP/plain.ply"
has "-v sums up" '17036 points in, 0 left out; spacing 4 mm, 17 rows x 28 columns; 325 vertices, 580 facets' "$TMP/plain.err"
has "-v says how far vertices are off their quadrics" 'off their quadrics by 0\.00[0-9]* mm at worst' "$TMP/plain.err"
mesh quiet -t 4 -u mm "$panel"
empty "-t and -u: nothing to say" "$TMP/quiet.err"
mesh guessed -t 4 "$panel"
has "a unit that was not given is told" '17036 points, 74 x 54 x 15 mm, their unit taken as mm \(-u\)' "$TMP/guessed.err"

# every vertex is a point of the cloud
body "$TMP/plain.ply" | head -n 325 | awk '{ printf "%.4f %.4f %.4f\n", $1, $2, $3 }' | sort -u >"$TMP/vertices"
sort -u "$panel" | comm -13 - "$TMP/vertices" >"$TMP/strangers"
empty "every vertex is a point of the cloud" "$TMP/strangers"

# the paper's order: rows of triangles, in each those that point up before those that point down
body "$TMP/plain.ply" | awk '
	NR <= 325 { row[NR - 1] = $7; next }
	{ low = row[$2]; if (row[$3] < low) low = row[$3]; if (row[$4] < low) low = row[$4]
	  up = (row[$2] == low) + (row[$3] == low) + (row[$4] == low) == 2
	  key = 2 * low + !up
	  if (key < last) print "facet " NR - 325 " out of order"
	  last = key }' >"$TMP/disorder"
empty "facets stand row by row, up before down" "$TMP/disorder"

# the same mesh whatever the order of the points, the number of threads, the number of files
cloud2mesh --nodes scan -t 4 <"$panel" >"$TMP/stdin.ply" 2>/dev/null
for order in 'sort -n' 'sort -k3' 'sort -rn -k2'; do
	$order "$panel" | cloud2mesh --nodes scan -t 4 >"$TMP/other.ply"
	same "the same mesh after $order" "$TMP/stdin.ply" "$TMP/other.ply"
done
cloud2mesh --nodes scan -t 4 -j 1 <"$panel" >"$TMP/other.ply"
same "the same mesh by one thread" "$TMP/stdin.ply" "$TMP/other.ply"
cloud2mesh --nodes scan -t 4 -j 7 <"$panel" >"$TMP/other.ply"
same "the same mesh by seven threads" "$TMP/stdin.ply" "$TMP/other.ply"
head -n 5000 "$panel" >"$TMP/a.xyz"
tail -n +5001 "$panel" >"$TMP/b.xyz"
cloud2mesh --nodes scan -t 4 "$TMP/a.xyz" "$TMP/b.xyz" >"$TMP/two.ply"
body "$TMP/two.ply" >"$TMP/two.body"
body "$TMP/stdin.ply" >"$TMP/one.body"
same "two files are one cloud" "$TMP/one.body" "$TMP/two.body"
has "the stream names the files" '^comment source .*a\.xyz and 1 more$' "$TMP/two.ply"
if has_locale de_DE.UTF-8; then
	LC_ALL=de_DE.UTF-8 cloud2mesh --nodes scan -t 4 <"$panel" >"$TMP/other.ply"
	same "the same mesh in another locale" "$TMP/stdin.ply" "$TMP/other.ply"
else
	skip "the same mesh in another locale" "no locale de_DE.UTF-8"
fi

# so too where the vertices stand at the nodes of the grid
cloud2mesh -q -t 4 <"$panel" >"$TMP/grid.ply"
cloud2mesh -q -t 4 -j 1 <"$panel" >"$TMP/other.ply"
same "vertices at the nodes: the same mesh by one thread" "$TMP/grid.ply" "$TMP/other.ply"
sort -rn -k2 "$panel" | cloud2mesh -q -t 4 >"$TMP/other.ply"
same "vertices at the nodes: the same mesh whatever the order" "$TMP/grid.ply" "$TMP/other.ply"
result "$(cmp -s "$TMP/grid.ply" "$TMP/stdin.ply" && echo 1 || echo 0)" "vertices at the nodes: another mesh than of points of the scan"

# the spacing is taken from the cloud, and -t with it gives the same
mesh auto --nodes scan "$panel"
has "without -t it says the spacing" '^cloud2mesh: spacing 1\.45 mm' "$TMP/auto.err"
cloud2mesh --nodes scan -t 1.45 "$panel" >"$TMP/other.ply"
same "-t with that spacing gives the same" "$TMP/auto.ply" "$TMP/other.ply"
mesh hush -q "$panel"
empty "-q: not a word" "$TMP/hush.err"

# placing
cloud2mesh --nodes scan -u m -t 4000 <"$panel" >"$TMP/metre.ply"
has "-u m: as many vertices" '^element vertex 325$' "$TMP/metre.ply"
result "$([ "$(box "$TMP/metre.ply" | awk '{ print $1 / 1000, $2 / 1000, $3 / 1000, $4 / 1000 }')" = \
	"$(box "$TMP/stdin.ply" | awk '{ print $1 * 1, $2 * 1, $3 * 1, $4 * 1 }')" ]; echo $?)" "-u m: a thousand times as large"
has "-u m: the stream says how the scan was placed" '^comment place 1000 0 0 0 0 1000 0 0 0 0 1000 0 0 0 0 1$' "$TMP/metre.ply"
hasnt "in mm it was not placed" '^comment place' "$TMP/stdin.ply"
cloud2mesh --origin -t 4 <"$panel" >"$TMP/origin.ply"
has "--origin: the lowest leftmost point is the origin" '^comment place 1 0 0 37 0 1 0 27 0 0 1 0 0 0 0 1$' "$TMP/origin.ply"
result "$(box "$TMP/origin.ply" | awk '{ print !($1 >= 0 && $1 < 0.1 && $3 >= 0 && $3 < 0.1) }')" "--origin: x and y start at 0"
has "--origin: as many vertices" '^element vertex 325$' "$TMP/origin.ply"
printf '0 -1 0 10\n1 0 0 20\n0 0 1 -5\n0 0 0 1\n' >"$TMP/matrix"
cloud2mesh --nodes scan --matrix "$TMP/matrix" -a 90 -t 4 <"$panel" >"$TMP/turned.ply"
has "a quarter turn with the rows turned too: as many vertices" '^element vertex 325$' "$TMP/turned.ply"
body "$TMP/turned.ply" | head -n 325 | awk '{ printf "%.4f %.4f %.4f\n", $2 - 20, 10 - $1, $3 + 5 }' | sed 's/-0\.0000/0.0000/g' | sort -u >"$TMP/back"
sed 's/-0\.0000/0.0000/g' "$TMP/vertices" | sort -u >"$TMP/there"
same "a quarter turn with the rows turned too: the same points" "$TMP/there" "$TMP/back"
has "--matrix: the stream says how the scan was placed" '^comment place 0 -1 0 10 1 0 0 20 0 0 1 -5 0 0 0 1$' "$TMP/turned.ply"
cloud2mesh --nodes scan -a 30 -t 4 <"$panel" >"$TMP/a30.ply"
has "-a: the stream says the direction" '^comment direction 30$' "$TMP/a30.ply"
body "$TMP/a30.ply" | head -n "$(number vertex "$TMP/a30.ply")" | awk '{ printf "%.4f %.4f %.4f\n", $1, $2, $3 }' | sort -u >"$TMP/vertices30"
sort -u "$panel" | comm -13 - "$TMP/vertices30" >"$TMP/strangers"
empty "-a: the points stay in the scan's frame" "$TMP/strangers"

# a sphere of radius 60 from the outside, and from the inside
awk 'BEGIN { for (y = -30; y <= 30; y += 0.75) for (x = -30; x <= 30; x += 0.6)
	printf "%.6f %.6f %.6f\n", x, y, sqrt(3600 - x * x - y * y) }' >"$TMP/dome.xyz"
cloud2mesh --nodes scan -t 4 "$TMP/dome.xyz" >"$TMP/dome.ply"
sphere() { # FILE SIGN: largest difference of normals and of curvature from the sphere's
	awk -v sign="$2" '/^element vertex/ { n = $3 } /^end_header/ { body = 1; next }
		body && k++ < n {
			d = sqrt(($4 - sign * $1 / 60) ^ 2 + ($5 - sign * $2 / 60) ^ 2 + ($6 - sign * $3 / 60) ^ 2)
			if (d > worst) worst = d
			c = $9 * 60 + sign; if (c < 0) c = -c
			if (c > curved) curved = c
		}
		END { printf "%.6f %.4f\n", worst, curved }' "$1"
}
below "normals on a sphere" "$(sphere "$TMP/dome.ply" 1 | cut -d' ' -f1)" 0.0002
below "curvature on a sphere: 1/60, not hollow" "$(sphere "$TMP/dome.ply" 1 | cut -d' ' -f2)" 0.02
awk '{ printf "%.6f %.6f %.6f\n", $1, $2, -$3 }' "$TMP/dome.xyz" | cloud2mesh --nodes scan -t 4 >"$TMP/bowl.ply"
below "normals in a bowl" "$(sphere "$TMP/bowl.ply" -1 | cut -d' ' -f1)" 0.0002
below "curvature in a bowl: 1/60, hollow" "$(sphere "$TMP/bowl.ply" -1 | cut -d' ' -f2)" 0.02
cloud2mesh --nodes scan -t 4 --normals facet "$TMP/dome.xyz" >"$TMP/facet.ply"
result "$(sphere "$TMP/facet.ply" 1 | awk '{ print !($1 > 0.001 && $1 < 0.05) }')" "facet normals are coarser"

# a hole 3 mm wide, on a cloud with points every 0.5 mm
awk 'BEGIN { for (y = 0; y <= 40; y += 0.5) for (x = 0; x <= 40; x += 0.5)
	if ((x - 20) ^ 2 + (y - 20) ^ 2 > 16) print x, y, 0 }' >"$TMP/hole.xyz"
cloud2mesh --nodes scan -v -t 5 "$TMP/hole.xyz" >"$TMP/hole.ply" 2>"$TMP/hole.err"
has "no facet over a hole" 'left out [0-9]* facets over a hole' "$TMP/hole.err"
cloud2mesh --nodes scan -v -t 5 --max-gap 12 "$TMP/hole.xyz" >"$TMP/whole.ply" 2>"$TMP/whole.err"
hasnt "--max-gap: unless it is allowed" 'over a hole' "$TMP/whole.err"
for cloud in "$panel" "$face"; do
	for t in 1.5 2 3 4; do
		cloud2mesh --nodes scan -v -t $t --normals facet "$cloud" 2>&1 >/dev/null | grep -E 'over a hole|face down'
	done
done >"$TMP/found"
empty "no facet of the samples is taken for one over a hole" "$TMP/found"

# noise 0.02 mm on the panel: said, measured within 15 %, vertices moved onto the surface
noisy=$TMP/noisy.xyz
awk 'function noise() { # normal, sigma 0.02
		return 0.02 * sqrt(-2 * log(1 - uniform())) * cos(6.283185307 * uniform()) }
	function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	BEGIN { seed = 77 + 7919 * ENVIRON["SEED"] }
	{ printf "%.4f %.4f %.4f\n", $1, $2, $3 + noise() }' "$panel" >"$noisy"
mesh noisy -v --nodes scan -t 4 "$noisy"
has "noise is said" '^cloud2mesh: noise 0\.0[12][0-9]* mm .*vertices moved' "$TMP/noisy.err"
result "$(sed -n 's/^comment noise //p' "$TMP/noisy.ply" | awk '{ print !($1 > 0.016 && $1 < 0.0225) }')" "the stream says the noise"
# off_clean FILE: rms of its vertices' heights against the clean mesh of the same nodes
off_clean() {
	awk '/^element vertex/ { n = $3; k = 0 } /^end_header/ { body = 1; next } /^ply/ { body = 0; f++ }
		body && k++ < n { key = $7 " " $8; if (f == 1) { x[key] = $1; y[key] = $2; z[key] = $3; a[key] = $4 / $6; b[key] = $5 / $6 }
			else if (key in z) { d = ($3 - z[key] + a[key] * ($1 - x[key]) + b[key] * ($2 - y[key])); s += d * d; m++ } }
		END { printf "%.5f\n", sqrt(s / m) }' "$TMP/plain.ply" "$1"
}
below "its vertices are off by less than half of it" "$(off_clean "$TMP/noisy.ply")" 0.008
cloud2mesh --nodes scan -q -t 4 --noise 0 "$noisy" >"$TMP/raw.ply"
result "$(off_clean "$TMP/raw.ply" | awk '{ print !($1 > 0.015) }')" "--noise 0: vertices stay points of the scan"
cloud2mesh --nodes scan -q -t 4 --noise 0.03 "$noisy" | sed -n 's/^comment noise //p' >"$TMP/found"
result "$(grep -qx 0.0300 "$TMP/found"; echo $?)" "--noise: is taken as given"
cloud2mesh --nodes scan -q -t 4 -j 1 "$noisy" >"$TMP/other.ply"
same "noise: the same mesh by one thread" "$TMP/noisy.ply" "$TMP/other.ply"
sort -rn -k2 "$noisy" >"$TMP/turned.xyz"
cloud2mesh --nodes scan -q -t 4 <"$noisy" >"$TMP/first.ply"
cloud2mesh --nodes scan -q -t 4 <"$TMP/turned.xyz" >"$TMP/other.ply"
same "noise: the same mesh whatever the order" "$TMP/first.ply" "$TMP/other.ply"
cloud2mesh -q -t 4 <"$noisy" >"$TMP/first.ply"
cloud2mesh -q -t 4 -j 1 <"$TMP/turned.xyz" >"$TMP/other.ply"
same "noise, vertices at the nodes: the same mesh by one thread in another order" "$TMP/first.ply" "$TMP/other.ply"

# outliers and points twice
awk '{ print } NR % 500 == 7 { print $1 + 0.01, $2, $3 + 3 + NR % 7 } NR % 3 == 0' "$panel" >"$TMP/dirty.xyz"
mesh dirty --nodes scan -t 4 "$TMP/dirty.xyz"
has "points twice are left out" '^cloud2mesh: left out 5678 points that were there already$' "$TMP/dirty.err"
has "outliers are left out" '^cloud2mesh: left out 35 outliers$' "$TMP/dirty.err"
body "$TMP/dirty.ply" >"$TMP/dirty.body"
body "$TMP/stdin.ply" >"$TMP/clean.body"
same "the mesh is that of the clean scan" "$TMP/clean.body" "$TMP/dirty.body"
mesh kept -t 4 --outliers keep "$TMP/dirty.xyz"
has "--outliers keep: they are counted" '^cloud2mesh: found, and kept, 35 outliers$' "$TMP/kept.err"
(cat "$panel" && echo 9e8 -9e8 0) >"$TMP/far.xyz"
mesh far --nodes scan -t 4 "$TMP/far.xyz"
has "an outlier far off is one" '^cloud2mesh: left out 1 outlier$' "$TMP/far.err"
body "$TMP/far.ply" >"$TMP/far.body"
same "and changes nothing" "$TMP/clean.body" "$TMP/far.body"
awk '{ print } NR % 4 == 0 && $1 * $1 + $2 * $2 < 100 { print $1 + 0.05, $2 + 0.1, 30 }
	$1 * $1 + $2 * $2 < 100 { print $1 + 0.1, $2, 30 }' "$panel" >"$TMP/roof.xyz"
mesh roof -t 2 "$TMP/roof.xyz"
has "points under a roof are left out" '^cloud2mesh: left out [0-9]* points under others' "$TMP/roof.err"

# a hole with an outlier in it stays one
awk '{ print } END { print 20, 20, 1; print 19, 20.5, -4 }' "$TMP/hole.xyz" >"$TMP/spoilt.xyz"
mesh spoilt --nodes scan -t 5 "$TMP/spoilt.xyz"
body "$TMP/spoilt.ply" >"$TMP/spoilt.body"
body "$TMP/hole.ply" >"$TMP/hole.body"
same "outliers in a hole do not close it" "$TMP/hole.body" "$TMP/spoilt.body"

# a mesh from an error
for e in 0.2 0.05; do
	mesh "e$e" -e $e "$panel"
	has "-e $e: it says how far the points are off, and where" \
		'^cloud2mesh: the points are within 0\.[0-9]* mm of the mesh at worst \(at .*\), 0\.[0-9]* mm rms; [0-9]* rows$' "$TMP/e$e.err"
	below "-e $e: no more than that" "$(sed -n 's/.*are within \([0-9.]*\) mm.*/\1/p' "$TMP/e$e.err")" "$e"
done
below "-e 0.05: with 1300 vertices" "$(number vertex "$TMP/e0.05.ply")" 1300
result "$([ "$(number vertex "$TMP/e0.2.ply")" -lt "$(number vertex "$TMP/e0.05.ply")" ]; echo $?)" "-e 0.2: with fewer"
status 0 "-e: meshnorm cuts along its rows" meshnorm -r 8 --rows mesh "$TMP/e0.05.ply"
mesh "ecoarse" -e 5 -t 2 "$panel"
has "-e and -t: no farther apart than -t" ' 3[2-9] rows$' "$TMP/ecoarse.err"
status 0 "-e on a noisy scan" cloud2mesh --nodes scan -e 0.05 "$noisy"
has "-e on a noisy scan: of the surface" '^cloud2mesh: the surface below the noise is within 0\.0[0-4][0-9]* mm of the mesh' "$TMP/err"
awk 'BEGIN { for (y = 0; y <= 40; y += 0.5) for (x = 0; x <= 40; x += 0.5) print x, y, (x > 20) * 6 }' >"$TMP/step.xyz"
status 3 "-e: a wall that no facet follows" cloud2mesh --nodes scan -e 0.05 --no-features "$TMP/step.xyz"
has "-e: a wall that no facet follows: where" 'step\.xyz: the mesh is off by [0-9.]* mm at [12][09]' "$TMP/err"
has "and the mesh is written" '^end_header' "$TMP/out"
status 2 "--paper and -e" cloud2mesh --paper -e 0.1 "$panel"

# refusals: nothing on standard output, one line that names the file
refused() { # DESC REGEX ARGUMENTS...
	desc=$1 regex=$2
	shift 2
	status 1 "$desc" cloud2mesh "$@"
	has "$desc: says so" "^cloud2mesh: .*$regex" "$TMP/err"
	empty "$desc: writes nothing" "$TMP/out"
}
printf '1 2 3\n4 5 6\n' >"$TMP/two.xyz"
refused "two points" 'two\.xyz: found 2 points, expected at least 3' "$TMP/two.xyz"
awk 'BEGIN { for (i = 0; i < 100; i++) print i, 2 * i, i % 7 }' >"$TMP/line.xyz"
refused "points on a line" 'line\.xyz: all 100 points are on one line' "$TMP/line.xyz"
awk 'BEGIN { for (i = 0; i < 100; i++) print 7, 5, i % 7 }' >"$TMP/place.xyz"
refused "points in one place" 'place\.xyz: all 100 points are in one place' "$TMP/place.xyz"
refused "a spacing far too fine" 'panel_17036\.xyz: .*spacing 0\.0001 mm has .* nodes' -t 0.0001 "$panel"
refused "a spacing far too coarse" 'panel_17036\.xyz: no three neighbouring nodes' -t 1000 "$panel"
refused "a gap far too small" 'gap of 1e-05 mm is too small' -t 4 --max-gap 0.00001 "$panel"
(cat "$panel" && echo 9e8 -9e8 0) >"$TMP/far.xyz"
refused "an outlier far off" 'far\.xyz: .*outlier far off' --outliers keep "$TMP/far.xyz"
(cat "$panel" && echo 9e5 -2e6 0 && echo 0 8e5 0) >"$TMP/farther.xyz"
refused "outliers far off" 'farther\.xyz: .*nodes for 17038 points.*far outside' --outliers keep "$TMP/farther.xyz"
refused "no such file" 'nowhere\.xyz' "$TMP/nowhere.xyz"
printf "1 0 0\n0 1 0\n0 0 1\n" >"$TMP/three"
refused "a matrix of 3 x 3" 'found 9 numbers' --matrix "$TMP/three" "$panel"
if [ -w /dev/full ]; then
	status 1 "a full disk" sh -c 'cloud2mesh -t 4 "$0" >/dev/full' "$panel"
else
	skip "a full disk" "no /dev/full"
fi
status 1 "half a file name" cloud2mesh -t 4 "$panel" "$panel.missing"
empty "all input is read before anything is written" "$TMP/out"
for wrong in '-t 0' '-t -4' '-t nan' '-t 4x' '-u furlong' '--neighbours 5' '--normals none' '--max-gap 0' '-a east'; do
	# shellcheck disable=SC2086
	status 2 "wrong usage: $wrong" cloud2mesh $wrong "$panel"
done

done_testing

#!/bin/sh
# all-limits.t - the limits that cloudmill(7) states, at their edges.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

cloud() { # X0 Y0 SCALE: a shallow bowl of 21 x 16 points there, with all digits
	awk -v x0="$1" -v y0="$2" -v s="$3" 'BEGIN {
		for (i = 0; i <= 20; i++) for (k = 0; k <= 15; k++) {
			x = 2 * i; y = 2 * k; z = ((x - 20) ^ 2 + (y - 15) ^ 2) / 300
			printf "%.9f %.9f %.9f\n", x0 + s * x, y0 + s * y, s * z } }'
}
# apart FILE FILE X0 Y0: the largest distance of the vertices of the second, moved back, from those
# of the first
apart() {
	awk -v x0="$3" -v y0="$4" 'FNR == 1 { body = 0; file++ }
		/^end_header/ { body = 1; next }
		/^element vertex/ { most = $3 }
		body && n[file] < most { i = ++n[file]; x[file, i] = $1; y[file, i] = $2; z[file, i] = $3 }
		END {
			if (n[1] != n[2] || n[1] == 0) { print 1e9; exit }
			for (i = 1; i <= n[1]; i++) {
				dx = x[2, i] - x0 - x[1, i]; dy = y[2, i] - y0 - y[1, i]; dz = z[2, i] - z[1, i]
				d = sqrt(dx * dx + dy * dy + dz * dz)
				if (d > far) far = d
			}
			printf "%.9f\n", far
		}' "$1" "$2"
}

# coordinates as of UTM: millimetres at 5,400 km have half a nanometre between doubles
cloud 0 0 1 >near.xyz
cloud 500000 5400000 1 >far.xyz
status 0 "a cloud at the origin" cloud2mesh -q -t 4 -o near.ply near.xyz
status 0 "a cloud at UTM coordinates" cloud2mesh -q -t 4 -o far.ply far.xyz
below "its mesh is the same one, to the last digit written" \
	"$(apart near.ply far.ply 500000 5400000)" 0.0000021
cloud 500000000 5400000000 1 >metres.xyz
status 0 "UTM coordinates in millimetres" cloud2mesh -q -t 4 -o metres.ply metres.xyz
below "its mesh is the same one to 0.00001 mm" \
	"$(apart near.ply metres.ply 500000000 5400000000)" 0.00001

# ... and so is the path of it: where a decision about a micrometre falls otherwise, within a
# quarter of the tolerance of 0.01
meshnorm -q -r 2 -g near.xyz -o near.cl near.ply
status 0 "a path at UTM coordinates" meshnorm -q -r 2 -g far.xyz -o far.cl far.ply
moved=$(awk -F'[/,]' 'FNR == 1 { file++ }
	/^ *GOTO/ { i = ++n[file]; x[file, i] = $2; y[file, i] = $3; z[file, i] = $4 }
	END {
		for (i = 1; i <= n[1]; i++) {
			dx = x[2, i] - 500000 - x[1, i]
			dy = y[2, i] - 5400000 - y[1, i]
			dz = z[2, i] - z[1, i]
			d = sqrt(dx * dx + dy * dy + dz * dz)
			if (d > far) far = d
			other += d > 0.0000021
		}
		printf "%.7f %.4f", (n[1] == n[2] && n[1] > 99 ? far : 9), other / n[1]
	}' near.cl far.cl)
below "it is the same one, within 0.0025 mm" "${moved% *}" 0.0025
below "nine places of ten to the last digit written" "${moved#* }" 0.1
status 1 "no path beyond 100 km" meshnorm -q -r 2 -g metres.xyz metres.ply
has "... is told" 'the part is 5.4[0-9]*e.09 mm from the origin, expected less than 1e.08 mm' err

# ... and so are its programs, to the judge: on a machine as large
printf 'include = %s\n' "$SRC/machines/table-ac.txt" >vast.txt
for axis in x y z; do printf '%s.min = -9000000\n%s.max = 9000000\n' $axis $axis; done >>vast.txt
deepest() { # FAR CONTROL: of the program of its path, as ncverify says
	ncpost -q -m vast.txt -c "$2" -o "$1.nc" "$1.arcs" &&
		ncverify -q -m vast.txt -c "$2" -r 2 -g "$1.xyz" -p "$1.arcs" "$1.nc" >said &&
		sed -n 's/^gouge  *worst \([0-9.]*\) mm.*/\1/p' said
}
biarcfit -q -o near.arcs near.cl
biarcfit -q -o far.arcs far.cl
for control in fanuc siemens heidenhain linuxcnc; do
	a=$(deepest near $control)
	b=$(deepest far $control)
	below "$control: a program at UTM coordinates is as deep: $a, $b" \
		"$(awk -v a="${a:-9}" -v b="${b:-99}" 'BEGIN { print a < b ? b - a : a - b }')" 0.0005
done

# ---- a tolerance as large as the ball tells the part from nothing: not for ncverify alone
for fitter in biarcfit bsplfit; do
	status 1 "$fitter: a tolerance of the ball's radius" $fitter -q -e 2 -o wide.fit near.cl
	has "... is told" 'found a ball of R 2, expected more than the tolerance 2 ' err
done

# the longest line: any; a comment of 5 MB, a number of 200,000 digits
{
	awk 'BEGIN { printf "# "; for (i = 0; i < 500000; i++) printf "0123456789"; print "" }'
	cat near.xyz
} >comment.xyz
status 0 "a comment of 5 MB" cloud2mesh -q -t 4 -o comment.ply comment.xyz
tail -n +20 near.ply >want
tail -n +20 comment.ply >got
same "... changes nothing" got want
{
	awk 'BEGIN { printf "0."; for (i = 0; i < 20000; i++) printf "0000000000"; print "1 0 1.4" }'
	sed 1d near.xyz
} >digits.xyz
status 0 "a number of 200,000 digits" cloud2mesh -q -t 4 -o digits.ply digits.xyz

# counts beyond what there is are refused, not believed
for count in 4294967295 18446744073709551615; do
	sed "s/^element vertex .*/element vertex $count/" near.ply >count.ply
	status 1 "$count vertices said" planecut -q -r 4 -s 4 count.ply
	status 1 "$count points said" cloud2mesh -q -t 4 count.ply
done

# the smallest spacing
cloud 0 0 0.001 >small.xyz
status 0 "points 2 micrometres apart" cloud2mesh -q -t 0.004 -o small.ply small.xyz

# numbers of options
status 0 "an option of 1000000000" cloud2mesh -q -t 4 -e 1e9 near.xyz
status 2 "an option of more" cloud2mesh -q -t 4 -e 1000000001 near.xyz
status 2 "one of several of more" meshnorm -q -r 4 --fixed 0,0,1.1e9 near.ply

# the size of a part, the planes, all cuts, layers: in radii of the ball
plate() { # X Y: flat
	printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n'
	printf 'property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n'
	printf '0 0 0\n%s 0 0\n%s %s 0\n0 %s 0\n3 0 1 2\n3 0 2 3\n' "$1" "$1" "$2" "$2"
}
bare='planecut -q --paper -r 1'
plate 10000.1 1 >longer.ply
status 1 "a part longer than 10,000 radii" planecut -q --no-guard --ball-only -r 1 -s 5 longer.ply
has "... is told" 'the part is 10000.1 mm in size, expected at most 10000 mm' err
plate 1000 996 >wide.ply
# shellcheck disable=SC2086
status 0 "499 planes of 1,000 mm" $bare -s 2 wide.ply
plate 1000 1004 >wide.ply
# shellcheck disable=SC2086
status 1 "503 of them: more than 500,000 radii" $bare -s 2 wide.ply
has "... is told" 'would cut 503 m .* at most 500 m' err
# shellcheck disable=SC2086
status 1 "far more, known from the areas" $bare -s 0.5 wide.ply
has "... is told" 'would cut about 2008 m, expected at most 500 m' err
plate 99.999 1 >many.ply
# shellcheck disable=SC2086
status 0 "100,000 planes" $bare -a 90 -s 0.001 many.ply
plate 100.1 10 >many.ply
# shellcheck disable=SC2086
status 1 "100,100 planes" $bare -a 90 -s 0.001 many.ply
has "... are told" 'would make 100100 planes, expected at most 100000' err
plate 10 10 >small.ply
# shellcheck disable=SC2086
status 0 "layers 10,000 radii thick" $bare -s 5 --layers 11 --depth 1000 small.ply
# shellcheck disable=SC2086
status 2 "thicker ones" $bare -s 5 --layers 12 --depth 1000 small.ply
has "... are told" 'layers 11000 mm thick, expected at most 10000 mm' err
# shellcheck disable=SC2086
status 2 "more than 200 layers" $bare -s 5 --layers 201 --depth 0.1 small.ply
# the length of one layer tells that of all, before any is made
plate 100 100 >layer.ply
# shellcheck disable=SC2086
status 0 "49 layers of 10.1 m" $bare -s 1 --layers 49 --depth 0.1 layer.ply
# shellcheck disable=SC2086
status 1 "50 layers" $bare -s 1 --layers 50 --depth 0.1 layer.ply
has "... are told" 'would cut 505 m .* at most 500 m' err
status 1 "and of meshnorm" meshnorm -q --no-guard -r 1 --scallop 0.02 --layers 200 layer.ply
has "... are told" 'would cut .* at most 500 m' err
status 0 "rows a fiftieth of the points' spacing apart" cloud2mesh -q -e 0.01 -t 0.05 near.xyz
status 1 "nearer ones" cloud2mesh -q -e 0.01 -t 0.01 near.xyz
has "... are told" 'rows 0.01 mm apart \(-t\), expected at least 0.0[0-9]* mm' err
status 0 "a tool of 1,000 mm" planecut -q --no-guard -r 1 -s 5 --flute 4 --holder 9:1000 small.ply
status 2 "a longer one" planecut -q --no-guard -r 1 -s 5 --holder 9:999+9:2 small.ply
has "... is told" 'a tool that reaches 1001 mm .* expected at most 1000 mm' err
status 2 "a wider one" planecut -q --no-guard -r 1 -s 5 --holder 1001:9 small.ply
status 0 "a cloud extended by its own width" cloud2mesh -q -t 4 --extend 49.9 near.xyz
status 1 "by more" cloud2mesh -q -t 4 --extend 50.1 near.xyz
has "... is told" 'at most its own width of 50 mm' err

# a line without an end
if [ -c /dev/zero ]; then
	status 1 "a region of a line without an end" meshnorm -q -r 4 --region /dev/zero near.ply
	has "... is told" '/dev/zero:1: found a line of more than 268435456 bytes' err
else
	skip "a line without an end" "no /dev/zero"
fi

# the cells of all surfaces together, 4 million, as with a tolerance
saddle=$SRC/samples/saddle.nurbs
eleven=$(yes "$saddle" | head -n 11)
status 1 "2,001 x 2,001 cells of one surface" nurbs2mesh -n 2001 "$saddle"
has "... are told" 'option -n: found 2001 x 2001 on each of 1 surfaces, expected at most 2000' err
# shellcheck disable=SC2086
status 1 "604 x 604 of eleven" nurbs2mesh -n 604 $eleven
has "... are told" 'found 604 x 604 on each of 11 surfaces, expected at most 603' err
status 1 "a table of more" nurbs2mesh --grid 2001 "$saddle"
has "... is told" 'option --grid: found 2001 x 2001' err
done_testing

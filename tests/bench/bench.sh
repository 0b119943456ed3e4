#!/bin/sh
# bench.sh - how long the tools take, beside bare C loops that do the least that must be done.  BIN:
# the tools, FLOOR: the loops.  Every figure is the best of five.
tmp=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

# best NAME CMD...: prints the seconds of the quickest of five runs
best() {
	name=$1
	shift
	for run in 1 2 3 4 5; do
		: "$run"
		from=$(date +%s%N)
		"$@" >"$tmp/out" 2>"$tmp/err" || exit 1
		to=$(date +%s%N)
		echo $(((to - from) / 1000))
	done | sort -n | head -n 1 >"$tmp/best"
	awk -v name="$name" '{ printf "%-44s %8.3f s\n", name, $1 / 1e6 }' "$tmp/best"
}
# lines a second of the last one, and how many times the floor's time
rate() { # LINES FLOOR, microseconds
	awk -v lines="$1" -v floor="$2" '{
		printf "%-44s %8.2f million lines a second, %.2f times the floor\n", "", lines / $1, $1 / floor
	}' "$tmp/best"
}

# a million points on laser stripes four steps apart, over 74 x 54 mm
awk 'BEGIN {
	for (y = -27; y <= 27; y += 0.1264)
		for (x = -37; x <= 37; x += 0.03161)
			printf "%.4f %.4f %.4f\n", x, y, 15 - 0.005 * x * x - 0.007 * y * y + 2 * sin(x / 6) * cos(y / 7)
}' >"$tmp/cloud.xyz"
printf '%d points\n' "$(wc -l <"$tmp/cloud.xyz")"
best 'floor: read and a hand-made parser' "$FLOOR/floor_read" "$tmp/cloud.xyz"
best 'floor: fgets and strtod' "$FLOOR/floor_strtod" "$tmp/cloud.xyz"
best 'cloud2mesh -t 1 --normals facet' "$BIN/cloud2mesh" -t 1 --normals facet "$tmp/cloud.xyz"
best 'cloud2mesh -t 1' "$BIN/cloud2mesh" -t 1 "$tmp/cloud.xyz"

# a million places with a tool axis that turns all the time, as CL text
awk 'BEGIN {
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nRAPID\nGOTO/0,0,60,0,0,1\nFEDRAT/MMPM,500"
	for (i = 0; i < 1000000; i++) {
		t = i / 5000; a = 0.3 * sin(t); b = 0.25 * cos(t * 1.3) + 0.05; x = i % 2000 / 10
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, int(i / 2000) * 0.3, 5 * sin(x / 20), a, b,
			sqrt(1 - a * a - b * b)
	}
	print "FINI"
}' >"$tmp/path.cl"
lines=$(wc -l <"$tmp/path.cl")
printf '%d lines of CL\n' "$lines"
post() { # WAY NAME OPTIONS...: one way of writing, and its floor
	way=$1 what=$2
	shift 2
	best "floor: read, parse by hand, write ($way)" "$FLOOR/floor_post" "$way" "$tmp/path.cl"
	least=$(cat "$tmp/best")
	best "ncpost $what" "$BIN/ncpost" -q "$@" "$tmp/path.cl"
	rate "$lines" "$least"
}
post tcp '-c fanuc' -c fanuc
post axes '-c fanuc, no tool centre point control' -c fanuc --set tcp=no
post vectors '-c siemens, vectors' -c siemens

# a million blocks over the million points of a dome, the tool axis turning all the time; without
# tool-centre-point control the machine's kinematics is run for each block
awk 'BEGIN {
	for (j = 0; j < 1000; j++)
		for (i = 0; i < 1000; i++) {
			x = -50 + i * 100 / 999; y = -50 + j * 100 / 999
			printf "%.5f %.5f %.5f\n", x, y, -(x * x + y * y) / 400
		}
}' >"$tmp/dome.xyz"
blocks() { # TCP: 1 with tool-centre-point control, 0 the places of the axes
	awk -v tcp="$1" 'BEGIN {
	printf "%%\nO0001\nN1 G90 G17 G21 G40 G49 G80 G94 G54\nN2 G53 G0 Z0.\nN3 T1 M6\nN4 S8000 M3\n"
	printf "N5 G0 A10. C90.\nN6 %s H1\nN7 G0 X-50. Y-50. Z90.\n", tcp ? "G43.4" : "G43"
	for (n = 0; n < 1000000; n++) {
		i = n % 2500; j = (n - i) / 2500; side = j % 2 ? -1 : 1
		u = side * (-50 + i * 100 / 2499); v = -50 + j * 100 / 399
		l = sqrt(u * u + v * v + 40000); a = 0.25 + 0.2 * sin(u / 9)
		x = u + 5 * u / l - 5 * sin(a); y = v + 5 * v / l; z = 1000 / l - (u * u + v * v) / 400 - 5 * cos(a)
		if (!tcp) { t = x; x = y; y = z * sin(a) - t * cos(a); z = t * sin(a) + z * cos(a) }
		printf "N%d G1 X%.4f Y%.4f Z%.4f A%.4f%s\n", n + 8, x, y, z, a * 57.29577951308232, n ? "" : " F2000."
	}
	printf "N%d G0 Z90.\nN%d G49\nN%d G53 G0 Z0.\nN%d M5\nN%d M30\n%%\n", n + 8, n + 9, n + 10, n + 11, n + 12
	}' | sed 's/\([XYZA]\)-\(0\.0000\)/\1\2/g'
}
blocks 1 >"$tmp/dome.nc"
blocks 0 >"$tmp/axes.nc"
printf '%d blocks, %d points\n' "$(wc -l <"$tmp/dome.nc")" "$(wc -l <"$tmp/dome.xyz")"
verify() { # exit 3 is a verdict too
	"$BIN/ncverify" -q -g "$tmp/dome.xyz" -r 5 "$@" || [ $? -eq 3 ]
}
best 'ncverify' verify "$tmp/dome.nc"
best 'ncverify, no tool centre point control' verify --set tcp=no "$tmp/axes.nc"
best 'ncverify --stock box,1' verify --stock box,1 "$tmp/dome.nc"

#!/bin/sh
# bench.sh - how long the tools take, beside bare C loops that only read the same file.  BIN: the
# tools, FLOOR: the loops.  Every figure is the best of five.
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
	done | sort -n | head -n 1 | awk -v name="$name" '{ printf "%-44s %8.3f s\n", name, $1 / 1e6 }'
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
printf '%d lines of CL\n' "$(wc -l <"$tmp/path.cl")"
best 'floor: read, parse by hand, two angles, write' "$FLOOR/floor_post" "$tmp/path.cl"
best 'ncpost -c fanuc' "$BIN/ncpost" -q -c fanuc "$tmp/path.cl"

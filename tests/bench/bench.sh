#!/bin/sh
# bench.sh - how long the tools take and how much memory, beside bare C loops that do the least that
# must be done.  BIN: the tools, FLOOR: the loops and makers of inputs (tests/bench/*.c).
#
# A row: what was done; the goal; ours: CPU seconds of all threads, and by the clock; the
# floor's CPU
# and how many times that is; the most memory.  Each is the quickest of RUNS (default 3) runs.
#
#	make bench                          a million points
#	make bench POINTS=10000000 RUNS=1   ten million, as the goals are set for
#	make bench GROWTH="100000 1000000"  how large clouds grow (default: to ten million points)
#	make bench ONLY=cloud2mesh          part of it: reading cloud2mesh fit post verify
#	make bench SCANS="a.xyz b.xyz"      instead of the samples
#	make bench LIDAR=N CUT=N            points of the large lidar scan, of planecut's part
#
# Other programs (peers) run where they are installed: gmt, python3 with scipy.
tmp=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
samples=$(cd "$(dirname "$0")/../../samples" && pwd)
points=${POINTS:-1000000} runs=${RUNS:-3}

wanted() { # PART
	case " ${ONLY:-$1} " in *" $1 "*) ;; *) return 1 ;; esac
}

# measure CMD...: CPU, clock, memory and status of the quickest run in $tmp/took
measure() {
	run=0
	while [ $run -lt "$runs" ]; do
		run=$((run + 1))
		"$FLOOR/measure" "$tmp/one" "$@" >"$tmp/out" 2>"$tmp/err"
		cat "$tmp/one"
	done | sort -n | head -n 1 >"$tmp/took"
}

# floor NAME CMD...: of the rows that follow
floor() {
	name=$1
	shift
	measure "$@"
	cp "$tmp/took" "$tmp/floor"
	awk -v name="$name" '{ printf "%-52s %9.3f s CPU %38.1f MB\n", "floor: " name, $1, $3 }' \
		"$tmp/took"
}

# ours NAME GOAL CMD...: a row
ours() {
	name=$1 goal=$2
	shift 2
	measure "$@"
	[ -s "$tmp/floor" ] || echo 0 >"$tmp/floor"
	read -r least _ <"$tmp/floor"
	awk -v name="$name" -v goal="$goal" -v least="$least" '{
		printf "%-52s %9.3f s CPU %8.3f s %7s %12s %8.1f MB%s\n", name, $1, $2,
			(least > 0 ? sprintf("%.2f x", $1 / least) : ""), goal, $3,
			($4 ? " (exit " $4 ")" : "")
	}' "$tmp/took"
}

# each NAME GOAL N CMD...: a row by the point, and by the floor where there is one
each() {
	name=$1 goal=$2 n=$3
	shift 3
	measure "$@"
	[ -s "$tmp/floor" ] || echo 0 >"$tmp/floor"
	read -r least _ <"$tmp/floor"
	awk -v name="$name" -v goal="$goal" -v n="$n" -v least="$least" '{
		printf "%-52s %9.3f s CPU %8.3f s %7s %12s %8.1f MB%s%s\n", name, $1, $2,
			sprintf("%.2f us", 1e6 * $1 / n), goal, $3, (least > 0 ? sprintf(" %.2f x", $1 / least) : ""),
			($4 ? " (exit " $4 ")" : "")
	}' "$tmp/took"
}

head_row() {
	printf '\n%s\n' "$1"
	printf '%-52s %15s %10s %7s %12s %11s\n' '' ours clock ratio goal memory
}

printf '%s points; %s, %s processors, %s\n' "$points" \
	"$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)" \
	"$(getconf _NPROCESSORS_ONLN)" "$(date -u +%Y-%m-%d)"

if wanted reading || wanted cloud2mesh; then
	"$FLOOR/make_cloud" random "$points" >"$tmp/cloud.xyz"
fi

if wanted reading; then
	head_row "Reading and parsing $points rows"
	floor 'read and a hand-made parser' "$FLOOR/floor_read" "$tmp/cloud.xyz"
	ours 'the reader of clouds' '1.2 x' "$FLOOR/read_cloud" "$tmp/cloud.xyz"
	# shellcheck disable=SC2016 # for the inner shell
	ours 'the same through a pipe (with cat)' '1.2 x' \
		sh -c 'cat "$2" | "$1" -' sh "$FLOOR/read_cloud" "$tmp/cloud.xyz"
	floor 'fgets and strtod' "$FLOOR/floor_strtod" "$tmp/cloud.xyz"
	ours 'one million hard decimals, equal to strtod' '' "$FLOOR/prove_decimals" 1
fi

if wanted cloud2mesh; then
	head_row "$points points in random order, 1 mm mesh"
	floor 'read twice, grid, facet normals, PLY' "$FLOOR/floor_mesh" 1 "$tmp/cloud.xyz"
	ours 'cloud2mesh -t 1 --normals facet' '1.3 x, 64 MB' \
		"$BIN/cloud2mesh" -q -j 1 -t 1 --normals facet "$tmp/cloud.xyz"
	ours 'the same, all processors' '' "$BIN/cloud2mesh" -q -t 1 --normals facet "$tmp/cloud.xyz"
	ours 'cloud2mesh -t 1' '2.5 x' "$BIN/cloud2mesh" -q -j 1 -t 1 "$tmp/cloud.xyz"
	ours 'the same, all processors' '' "$BIN/cloud2mesh" -q -t 1 "$tmp/cloud.xyz"
	ours 'the same, --stream, normals of facets' '' \
		"$BIN/cloud2mesh" -q -j 1 -t 1 --stream "$tmp/cloud.xyz"
	ours 'the same, --stream, normals of quadrics' '28 B a point' \
		"$BIN/cloud2mesh" -q -j 1 -t 1 --stream --normals quadric "$tmp/cloud.xyz"
	command -v gmt >/dev/null && ours 'peer: gmt blockmedian, the points alone' '' \
		gmt blockmedian -R0/1000/0/1000 -I1 "$tmp/cloud.xyz"
	python3 -c 'import scipy' 2>/dev/null && ours 'peer: scipy, the nearest point of each node' '' \
		python3 -c 'import sys, numpy as n, scipy.spatial as s
p = n.loadtxt(sys.argv[1]); x = n.arange(p[:, 0].min(), p[:, 0].max())
y = n.arange(p[:, 1].min(), p[:, 1].max())
near = s.cKDTree(p[:, :2]).query(n.array(n.meshgrid(x, y)).reshape(2, -1).T)[1]
print(p[near].sum())' "$tmp/cloud.xyz"

	head_row 'Growth: microseconds a point'
	for n in ${GROWTH:-100000 1000000 10000000}; do
		"$FLOOR/make_cloud" random "$n" >"$tmp/growing.xyz"
		floor "$n points" "$FLOOR/floor_mesh" 1 "$tmp/growing.xyz"
		each "cloud2mesh -t 1 --normals facet, $n points" 'linear' "$n" \
			"$BIN/cloud2mesh" -q -j 1 -t 1 --normals facet "$tmp/growing.xyz"
		each "cloud2mesh -t 1, $n points" 'linear' "$n" "$BIN/cloud2mesh" -q -j 1 -t 1 "$tmp/growing.xyz"
	done
	rm -f "$tmp/growing.xyz" "$tmp/cloud.xyz" "$tmp/floor"

	head_row 'Scans with edges, defaults: microseconds a point'
	for scan in ${SCANS:-"$samples"/face_nefertiti_26493.xyz "$samples"/panel_17036.xyz}; do
		n=$(wc -l <"$scan")
		each "cloud2mesh ${scan##*/}" '10 us' "$n" "$BIN/cloud2mesh" -q -j 1 "$scan"
		each 'the same, all processors: the clock' '1.8 x' "$n" "$BIN/cloud2mesh" -q "$scan"
		each "cloud2mesh -e 0.05 ${scan##*/}" '20 us' "$n" "$BIN/cloud2mesh" -q -j 1 -e 0.05 "$scan"
	done
	"$FLOOR/make_cloud" lidar "$points" >"$tmp/lidar.xyz"
	each "cloud2mesh, lidar, $points points" '1.1 us, 66 B' "$points" \
		"$BIN/cloud2mesh" -q -j 1 "$tmp/lidar.xyz"
	large=${LIDAR:-10650000} often=$runs runs=1
	"$FLOOR/make_cloud" lidar "$large" >"$tmp/lidar.xyz"
	each "cloud2mesh, lidar, $large points, once" '12 s, 700 MB' "$large" \
		"$BIN/cloud2mesh" -q -j 1 "$tmp/lidar.xyz"
	runs=$often
	rm -f "$tmp/lidar.xyz"
fi

if wanted fit; then
	rm -f "$tmp/floor"
	head_row 'Paths'
	# 100 mm square, facets of 0.17 mm
	awk -v n="${FINE:-592}" 'BEGIN {
		printf "ply\nformat ascii 1.0\nelement vertex %d\n", (n + 1) * (n + 1)
		print "property double x\nproperty double y\nproperty double z"
		printf "element face %d\nproperty list uchar int vertex_indices\nend_header\n", 2 * n * n
		for (j = 0; j <= n; j++) for (i = 0; i <= n; i++) {
			x = 100 * i / n; y = 100 * j / n
			printf "%.6f %.6f %.6f\n", x, y, 4 * sin(x / 9) * cos(y / 14)
		}
		for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
			k = j * (n + 1) + i
			printf "3 %d %d %d\n3 %d %d %d\n", k, k + 1, k + n + 2, k, k + n + 2, k + n + 1
		}
	}' >"$tmp/part.ply"
	n=$(sed -n 's/^element face //p' "$tmp/part.ply")
	ours "planecut -r 4 -s 2, $n facets of a fine grid: the clock" '2 s' \
		"$BIN/planecut" -q -r 4 -s 2 "$tmp/part.ply"
	"$FLOOR/make_cloud" random 300000 |
		"$BIN/cloud2mesh" -q -t 1 --normals facet -o "$tmp/part.ply" - 2>/dev/null
	n=$(sed -n 's/^element face //p' "$tmp/part.ply")
	ours "planecut -r 6 -s 3, $n facets" 'linear' "$BIN/planecut" -q -r 6 -s 3 "$tmp/part.ply"
	"$FLOOR/make_cloud" random "${CUT:-3000000}" |
		"$BIN/cloud2mesh" -q -t 1 --normals facet -o "$tmp/part.ply" - 2>/dev/null
	n=$(sed -n 's/^element face //p' "$tmp/part.ply")
	ours "planecut -r 6 -s 3, $n facets: the clock" '2 s' "$BIN/planecut" -q -r 6 -s 3 "$tmp/part.ply"
	awk 'BEGIN {
		print "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/8000,CLW\nCUTTER/8,4,0,4,0,0,60"
		print "RAPID\nGOTO/0,0,60,0,0,1\nFEDRAT/MMPM,500"
		for (i = 0; i < 13033; i++) {
			x = i / 130
			printf "GOTO/%.6f,%.6f,%.6f,0,0,1\n", x, 3 * sin(x / 7), 5 * sin(x / 20) + 0.4 * sin(x)
		}
		print "FINI"
	}' >"$tmp/dense.cl"
	ours 'biarcfit -e 0.005, 13,033 dense points' '2 s' "$BIN/biarcfit" -q -e 0.005 "$tmp/dense.cl"
	ours 'bsplfit -e 0.005, 13,033 dense points' '2 s' "$BIN/bsplfit" -q -e 0.005 "$tmp/dense.cl"
	awk 'BEGIN {
		print "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/8000,CLW\nCUTTER/10,5,0,5,0,0,60"
		print "RAPID\nGOTO/0,0,60,0,0,1\nFEDRAT/MMPM,500"
		for (i = 0; i < 20000; i++) { # to and fro on waves, along their normals
			y = int(i / 1000) / 2
			x = i % 1000 / 10
			x = y == int(y) ? x : 99.9 - x
			nx = -cos(x / 9) * cos(y / 11) / 3
			ny = 3 / 11 * sin(x / 9) * sin(y / 11)
			n = sqrt(nx * nx + ny * ny + 1)
			printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, y, 3 * sin(x / 9) * cos(y / 11),
				nx / n, ny / n, 1 / n
		}
		print "FINI"
	}' >"$tmp/turning.cl"
	ours 'biarcfit -e 0.01, 20,000 dense points, axis turns' '' "$BIN/biarcfit" -q "$tmp/turning.cl"
	ours 'bsplfit -e 0.01, 20,000 dense points, axis turns' '' "$BIN/bsplfit" -q -e 0.01 \
		"$tmp/turning.cl"
	scan=$samples/face_nefertiti_26493.xyz
	"$BIN/cloud2mesh" -q -t 3 "$scan" >"$tmp/face.ply" 2>/dev/null
	"$BIN/meshnorm" -q -r 5 --rows mesh "$tmp/face.ply" >"$tmp/face.cl" 2>/dev/null
	ours 'biarcfit, guarded by a face of 26,493 points' '3 s' \
		"$BIN/biarcfit" -q -e 0.02 -g "$scan" "$tmp/face.cl"
	ours 'bsplfit, guarded by a face of 26,493 points' '6 s' \
		"$BIN/bsplfit" -q -e 0.02 -g "$scan" "$tmp/face.cl"
fi

if wanted post; then
# a million places with a tool axis that turns all the time, as CL text
awk 'BEGIN {
	print "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/8000,CLW\nCUTTER/8,4,0,4,0,0,60"
	print "RAPID\nGOTO/0,0,60,0,0,1\nFEDRAT/MMPM,500"
	for (i = 0; i < 1000000; i++) {
		t = i / 5000; a = 0.3 * sin(t); b = 0.25 * cos(t * 1.3) + 0.05; x = i % 2000 / 10
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, int(i / 2000) * 0.3, 5 * sin(x / 20), a, b,
			sqrt(1 - a * a - b * b)
	}
	print "FINI"
}' >"$tmp/path.cl"
lines=$(wc -l <"$tmp/path.cl")
head_row "$lines lines of CL"
post() { # WAY NAME OPTIONS...: one way of writing, and its floor
	way=$1 what=$2
	shift 2
	floor "read, parse by hand, write ($way)" "$FLOOR/floor_post" "$way" "$tmp/path.cl"
	ours "ncpost $what" '2 x' "$BIN/ncpost" -q "$@" "$tmp/path.cl"
}
post tcp '-c fanuc' -c fanuc
post axes '-c fanuc, no tool centre point control' -c fanuc --set tcp=no
post vectors '-c siemens, vectors' -c siemens

# the same length of path, the tool axis over the pole again and again
sed -E 's|^(GOTO/[^,]*,[^,]*,[^,]*),.*|\1|' "$tmp/path.cl" | awk '/^GOTO/ && n++ {
		t = n / 500; a = 0.3 * sin(t); b = 0.02 * cos(t * 1.3)
		printf "%s,%.9f,%.9f,%.9f\n", $0, a, b, sqrt(1 - a * a - b * b); next
	}
	/^GOTO/ { $0 = $0 ",0,0,1" }
	{ print }' >"$tmp/pole.cl"
floor 'read, parse by hand, write (tcp, over the pole)' "$FLOOR/floor_post" tcp "$tmp/pole.cl"
ours 'ncpost -c fanuc, over the pole' '2 x' "$BIN/ncpost" -q -c fanuc "$tmp/pole.cl"
fi

if wanted verify; then
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
		x = u + 5 * u / l - 5 * sin(a); y = v + 5 * v / l
		z = 1000 / l - (u * u + v * v) / 400 - 5 * cos(a)
		if (!tcp) { t = x; x = y; y = z * sin(a) - t * cos(a); z = t * sin(a) + z * cos(a) }
		printf "N%d G1 X%.4f Y%.4f Z%.4f A%.4f%s\n", n + 8, x, y, z,
			a * 57.29577951308232, n ? "" : " F2000."
	}
	printf "N%d G0 Z90.\nN%d G49\nN%d G53 G0 Z0.\nN%d M5\nN%d M30\n%%\n",
		n + 8, n + 9, n + 10, n + 11, n + 12
	}' | sed 's/\([XYZA]\)-\(0\.0000\)/\1\2/g'
}
blocks 1 >"$tmp/dome.nc"
blocks 0 >"$tmp/axes.nc"
rm -f "$tmp/floor"
head_row "$(wc -l <"$tmp/dome.nc") blocks, $(wc -l <"$tmp/dome.xyz") points"
# exit 3 is a verdict too
ours 'ncverify' '' "$BIN/ncverify" -q -g "$tmp/dome.xyz" -r 5 "$tmp/dome.nc"
ours 'ncverify, no tool centre point control' '' \
	"$BIN/ncverify" -q -g "$tmp/dome.xyz" -r 5 --set tcp=no "$tmp/axes.nc"
ours 'ncverify --stock box,1' '' \
	"$BIN/ncverify" -q -g "$tmp/dome.xyz" -r 5 --stock box,1 "$tmp/dome.nc"
fi
exit 0

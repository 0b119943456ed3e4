#!/bin/sh
# jobs.sh FIRST LAST - random jobs, drawn by their numbers: a small scan, options of the path, a
# fitter, a machine and the controls that drive it.  Whatever pipe exits with 0 throughout, ncverify
# must accept, and safety.c (in $SAFETY) must find nothing in its programs.  One line for each
# program that fails, with the commands in FOLDER/NUMBER ($KEEP, if it is set), then the sums:
#
#	jobs 100 programs 250 refused-by-a-stage 12 accepted 250 safe 250
#
# BIN, SRC and SAFETY are set; runs in an empty folder.
first=$1
last=$2
PATH=$BIN:$PATH
CLOUDMILL_MACHINES=$SRC/machines
CLOUDMILL_TOOLS=$SRC/tools
export CLOUDMILL_MACHINES CLOUDMILL_TOOLS
ball='' flute='' holder='' tool='' machine='' fitter='' shape='' controls='' options='' post='' # of a job
programs=0 stopped=0 accepted=0 safe=0

# The job as shell variables, and its scan.
draw() { # NUMBER
	awk -v seed="$1" '
	function r(n) { state = (state * 16807) % 2147483647; return int(state / 2147483647 * n) }
	function u(a, b) { return a + (b - a) * r(1000000) / 1000000 }
	function one(list,   a, n) { n = split(list, a, "|"); return a[1 + r(n)] }
	BEGIN {
		state = (seed * 9973 + 4711) % 2147483647
		for (i = 0; i < 20; i++) r(2)
		ball = one("2|3|4|6")
		shape = one("dome|wave|trough|saddle|bowl|slope|step|rib|bumps")
		noise = one("0|0|0|0.01")
		w = u(5, 8); h = u(4, 6); d = u(0.3, 0.5)
		p = u(0.5, 1.5); q = u(2, 5); t = u(-0.6, 0.6)
		for (y = -h; y <= h; y += d)
			for (x = -w; x <= w; x += d) {
				z = t * x / 3
				if (shape == "dome") z += 10 - p * (x * x + y * y) / 50
				if (shape == "bowl") z += 10 + p * (x * x + y * y) / 60
				if (shape == "wave") z += p * sin(x / q) * cos(y / q)
				if (shape == "trough") z += p * x * x / 60 - y / 6
				if (shape == "saddle") z += p * (x * x - y * y) / 50
				if (shape == "slope") z += 2 * p * x / 3
				if (shape == "step") z += 2 * p / (1 + exp(-2 * x))
				if (shape == "rib") z += (x > -1 && x < 1) * p
				if (shape == "bumps") z += p * exp(-(x * x + y * y) / q) - p / 2 * exp(-((x - 3) ^ 2 + y * y) / q)
				printf "%.4f %.4f %.4f\n", x, y, z + noise * (r(1001) + r(1001) - 1000) / 700 >"scan.xyz"
			}
		flute = one("4|4|4|8") * ball
		holder = one("||" 2 * ball + 4 ":30|" ball + 1 ":20")
		strategy = one("--tilt 15|--tilt 5|--lead 10|--fixed 0,0,1|--to-point 0,0,120|--tilt 10 --lead 5||--fixed 0.3,0.1,0.9")
		tool = one("meshnorm|meshnorm|meshnorm|planecut")
		play = one("||--axis-play 0|--axis-play 5")
		rows = one("||--direction 0|--direction 37|--rows mesh")
		if (tool == "planecut") { rows = "-a " one("0|30|90"); }
		if (tool == "planecut" && strategy ~ /lead/) strategy = ""
		m = one("table-ac|table-ac|table-bc|head-ca|head-table-bc|nutating-table|nutating-head|table-ac-notcp|linuxcnc-xyzac|linuxcnc-xyzbc|head-cb|table-bc-notcp")
		controls = m ~ /linuxcnc/ ? "linuxcnc" : m ~ /notcp/ ? "fanuc siemens heidenhain linuxcnc" : "fanuc siemens heidenhain"
		printf "ball=%s flute=%s holder=%s tool=%s machine=%s fitter=%s shape=%s controls=\"%s\"\n",
			ball, flute, holder, tool, m, one("none|biarcfit|bsplfit"), shape, controls
		printf "options=\"%s %s %s %s --flute %s%s --avoid\"\n", tool == "planecut" ? "" : strategy, play, rows,
			rows ~ /mesh/ ? "" : "--scallop " one("0.05|0.1|0.02"), flute, holder == "" ? "" : " --holder " ball ":" flute "+" holder
		printf "post=\"%s\"\n", one("||||--vectors|--rotary|--inch|--contact-feed")
	}'
}

for job in $(seq "$first" "$last"); do
	draw "$job" >job
	# shellcheck disable=SC1091 # made here
	. ./job
	if ! cloud2mesh -q -t 2 scan.xyz -o scan.ply 2>log || ! $tool -q -r $ball -m $machine $options scan.ply >path.cl 2>>log; then
		stopped=$((stopped + 1))
		[ -z "${KEEP:-}" ] || echo "job $job: stopped: $tool $options: $(tail -n 2 log)"
		continue
	fi
	if [ $fitter != none ]; then
		mv path.cl line.cl
		if ! $fitter -q -e 0.01 line.cl >path.cl 2>>log; then
			stopped=$((stopped + 1))
			[ -z "${KEEP:-}" ] || echo "job $job: stopped: $fitter: $(tail -n 1 log)"
			continue
		fi
	fi
	for control in $controls; do
		if ! ncpost -q -c $control -m $machine $post path.cl >program.nc 2>log; then
			[ -z "${KEEP:-}" ] || echo "job $job: stopped: ncpost -c $control -m $machine $post: $(tail -n 1 log)"
			stopped=$((stopped + 1))
			continue
		fi
		programs=$((programs + 1))
		what="job $job: $shape R $ball, $tool $options, $fitter, $control, $machine $post"
		if ncverify -g scan.xyz -r $ball -m $machine -c $control -p path.cl program.nc >out 2>log; then
			accepted=$((accepted + 1))
		else
			echo "$what: refused: $(grep -v ': tool\|at most\|noise of\|outliers' log | head -n 2 | tr '\n' '|')"
			[ -z "${KEEP:-}" ] || { mkdir -p "$KEEP/$job" && cp scan.xyz path.cl program.nc job "$KEEP/$job"; }
		fi
		limit=$(sed -n 's/.*at most \([0-9.]*\) mm may be left: a scallop of.*tolerance of \([0-9.]*\).*/\2/p' log | head -n 1)
		if "$SAFETY" $control "$SRC/machines/$machine.txt" $ball $flute \
			"$(awk -v l="${limit:-0.05}" 'BEGIN { print l + 0.02 }')" program.nc scan.xyz \
			$holder >found; then
			safe=$((safe + 1))
		else
			echo "$what: unsafe: $(head -n 2 found | tr '\n' '|')"
			[ -z "${KEEP:-}" ] || { mkdir -p "$KEEP/$job" && cp scan.xyz path.cl program.nc job found "$KEEP/$job"; }
		fi
	done
done
echo "jobs $((last - first + 1)) programs $programs refused-by-a-stage $stopped accepted $accepted safe $safe"

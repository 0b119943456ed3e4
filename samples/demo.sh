#!/bin/sh
# demo.sh OUTDIR - two real tasks from scan to program: a car's panel to a Fanuc program of B-splines,
# and a face to a Siemens program of arcs; each is read back by ncverify, checked against all points
# of its scan, and drawn.  Standard output has every command, as it is run, and what came out; standard
# error the step at hand and the seconds so far; OUTDIR/log all messages.
# `make demo` calls it with BIN (the tools) set.
set -eu
cd "$(dirname "$0")/.."
PATH=${BIN:-$PWD/build/bin}:$PATH
CLOUDMILL_MACHINES=$PWD/machines
export PATH CLOUDMILL_MACHINES
out=${1:-demo}
panel=samples/panel_17036.xyz
face=samples/face_nefertiti_26493.xyz
mkdir -p "$out"
began=$(date +%s)

# run WHAT COMMAND...: says what is done, shows the command and runs it.  Exit status 3, something asked
# for is not kept, is remembered.
run() {
	step=$((step + 1)) code=0
	printf '[%s %d/6] %3d s  %s\n' "$part" $step $(($(date +%s) - began)) "$1" >&2
	shift
	echo "\$ $*" | tee -a "$out/$part.log"
	"$@" >"$out/$part.said" 2>&1 || code=$?
	cat "$out/$part.said" >>"$out/$part.log"
	case $code in
	0) ;;
	3) worst=3 ;;
	*) cat "$out/$part.said" >&2 && exit "$code" ;;
	esac
}

# check PROGRAM SCAN BALL: the verdict, in PART.txt as ncverify prints it
check() {
	run "read $1 back and check it against all points of the scan" \
		ncverify -g "$2" -r "$3" -e 0.02 --report "$out/$part.html" "$out/$1"
	cp "$out/$part.said" "$out/$part.txt"
}

# told NAME PROGRAM WHAT BALL: the verdict in words
told() {
	awk -v program="$out/$2" -v what="$3" -v ball="$4" '
		function n(x) { return x > 999 ? sprintf("%d,%03d", x / 1000, x % 1000) : x }
		$1 == "time" { minutes = $2 }
		$1 == "part" { points = $2 }
		$1 == "coverage" && $2 == "cut" { cut = $3; to = $(NF - 1) }
		$1 == "coverage" && $2 == "out" { reach = $5 }
		$1 == "coverage" && $2 == "left" { left = $3; most = $8 }
		$1 == "gouge" && $2 == "worst" { gouge = $3 }
		$1 == "left" && $2 == "50%" { half = $3; most95 = $5 }
		$1 == "verdict" { verdict = $2 }
		END {
			printf "%s: %s with a ball of %s mm radius, %.0f min at feed: %s\n", program, what, ball, minutes, verdict
			printf "  the ball goes no deeper into the part than %.3f mm (allowed: 0.02)\n", gouge
			printf "  %s of %s points of the scan are cut to %.2f mm, half of them to %.3f, 95 %% to %.3f\n", n(cut),
				n(points), to, half, most95
			if (reach + 0) printf "  %s points lie where the ball or its shank does not reach\n", n(reach)
			if (left == 1) printf "  1 point is left, %.1f mm (allowed: 0.5 %%)\n", most
			if (left > 1) printf "  %s points are left, up to %.1f mm (allowed: 0.5 %%)\n", n(left), most
		}' "$out/$1.txt"
}

panel() {
	run "a mesh of the panel, by its 17,036 points" cloud2mesh -v $panel -o "$out/panel.ply"
	run "rows for a ball of 8 mm, 0.02 mm of scallop between them" \
		meshnorm -v -r 8 "$out/panel.ply" -o "$out/panel.cl"
	run "B-splines through the rows, within 0.01 mm" \
		bsplfit -v -e 0.01 "$out/panel.cl" -o "$out/panel-splines.cl"
	run "the program for a Fanuc" ncpost -v -c fanuc "$out/panel-splines.cl" -o "$out/panel.nc"
	check panel.nc $panel 8
	run "its picture" ncplot --cut -o "$out/panel.svg" "$out/panel.ply" "$out/panel.nc"
}

face() {
	run "a mesh of the face, by its 26,493 points" cloud2mesh -v -t 2 $face -o "$out/face.ply"
	run "rows for a ball of 5 mm, leaving what it does not reach" \
		meshnorm -v -r 5 --scallop 0.15 --avoid "$out/face.ply" -o "$out/face.cl"
	run "arcs in space through the rows, within 0.01 mm" \
		biarcfit -v -e 0.01 "$out/face.cl" -o "$out/face-arcs.cl"
	run "the program for a Siemens" ncpost -v -c siemens "$out/face-arcs.cl" -o "$out/face.mpf"
	check face.mpf $face 5
	run "its picture" ncplot --cut -o "$out/face.svg" "$out/face.ply" "$out/face.mpf"
}

# task NAME: one of them, with its messages in a log of its own; ends with the worst status
task() {
	part=$1 step=0 worst=0
	: >"$out/$part.log"
	"$part"
	rm -f "$out/$part.said"
	exit $worst
}

# Both at a time: two processors have half the time to wait.
(task panel) &
other=$!
trap 'kill $other 2>/dev/null; exit 130' INT TERM
worst=0
(task face) || worst=$?
wait $other || { code=$? && [ $worst -ne 0 ] && [ $worst -ne 3 ] || worst=$code; }
case $worst in 0 | 3) ;; *) exit "$worst" ;; esac
cat "$out/panel.log" "$out/face.log" >"$out/log"
rm -f "$out/panel.log" "$out/face.log"

printf '[done]  %3d s\n' $(($(date +%s) - began)) >&2
echo
told panel panel.nc "Fanuc, B-splines," 8
told face face.mpf "Siemens, arcs in space," 5
echo "Look at $out/face.svg and $out/panel.svg; turn and zoom $out/face.html in a browser;"
echo "all messages are in $out/log, the verdicts in $out/face.txt and $out/panel.txt."
[ $worst -eq 0 ] || echo "Something asked for is not kept (exit status 3): the log says what and where."
exit $worst

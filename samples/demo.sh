#!/bin/sh
# demo.sh OUTDIR - the main task on a real scan: from a face to a Siemens program of arcs and a Fanuc
# program of B-splines, each checked by ncverify against the whole scan, and drawn.  Every command is
# shown, run as shown, and followed by some of its messages; all of them are in OUTDIR/log.
# `make demo` calls it with BIN (the tools) set.
set -eu
cd "$(dirname "$0")/.."
PATH=${BIN:-$PWD/build/bin}:$PATH
CLOUDMILL_MACHINES=$PWD/machines
export PATH CLOUDMILL_MACHINES
out=${1:-demo}
scan=samples/face_nefertiti_26493.xyz
mkdir -p "$out"
: >"$out/log"
worst=0

# run SOME COMMAND...: shows its messages that match SOME.  Exit status 3 is a verdict: continue.
run() {
	some=$1 code=0
	shift
	echo "\$ $*" | tee -a "$out/log"
	"$@" >"$out/said" 2>&1 || code=$?
	cat "$out/said" >>"$out/log"
	case $code in
	0) ;;
	3) worst=3 ;;
	*) cat "$out/said" >&2 && exit "$code" ;;
	esac
	sed -nE -e 's/^[a-z0-9]*: //' -e "/$some/s/^/  /p" "$out/said"
	rm "$out/said"
}

run 'noise of|points in' cloud2mesh -v -t 2 $scan -o "$out/face.ply"
run 'passes|not fit' meshnorm -v -r 5 --scallop 0.1 --avoid "$out/face.ply" -o "$out/face.cl"

run . biarcfit -v -e 0.01 "$out/face.cl" -o "$out/face-arcs.cl"
run . ncpost -v -c siemens "$out/face-arcs.cl" -o "$out/face.mpf"
run 'points in' bsplfit -v -e 0.01 "$out/face.cl" -o "$out/face-splines.cl"
run . ncpost -v -c fanuc "$out/face-splines.cl" -o "$out/face.nc"

some='^(time|gouge *(worst|50%)|left *50%|verdict)'
run "$some" ncverify -g $scan -r 5 -e 0.02 --report "$out/face-nc.html" "$out/face.nc"
run "$some" ncverify -g $scan -r 5 -e 0.02 --report "$out/face-mpf.html" "$out/face.mpf"
run . ncplot -v --cut -o "$out/face.svg" "$out/face.ply" "$out/face.mpf"
echo "The picture is $out/face.svg; to turn and zoom in a browser: $out/face-mpf.html"
exit $worst

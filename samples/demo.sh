#!/bin/sh
# demo.sh OUTDIR - the main job on a real scan: a face, to a Siemens program of arcs and a Fanuc
# program of B-splines, each read back as the control would run it, judged by ncverify against the
# whole scan, and drawn.
# `make demo` calls it with BIN (the tools) and READBACK (the tests' reader) set.
set -eu
src=$(cd "$(dirname "$0")/.." && pwd)
cd "$src"
PATH=${BIN:-$src/build/bin}:$PATH
READBACK=${READBACK:-$src/build/tests/readback/readback}
CLOUDMILL_MACHINES=$src/machines
export PATH CLOUDMILL_MACHINES
out=${1:-demo}
scan=samples/face_nefertiti_26493.xyz
spacing=2 radius=5 tolerance=0.01 deepest=0.1
rate=20 # degrees a mm: the normals of a rough scan swing
mkdir -p "$out"

# job FITTER CONTROL FITTED PROGRAM: the program, and the reader's report on it
job() {
	$1 -q -e $tolerance -o "$out/$3" "$out/face.cl" &&
		ncpost -q -c "$2" -o "$out/$4" "$out/$3" &&
		"$READBACK" -q -c "$2" --path "$out/$3" -e 0.01 --axis 0.1 --scan $scan \
			--deeper $deepest "$out/$4" >"$out/$4.report"
}

# value PROGRAM LINE WHAT: the number before WHAT in the line of the report that begins so
value() {
	sed -n "s/^$2:.*[ :]\([0-9.]*\) $3.*/\1/p" "$out/$1.report"
}

# told FITTED PROGRAM TITLE SHAPES
told() {
	fitted=$(sed -n 's/^\$\$-> LEDGER\/[a-z]*fit,//p' "$out/$1")
	off=$(value "$2" "program on path" "mm at.*axis")
	cut=$(value "$2" program "mm cut")
	depth=$(sed -n 's/^ball: deepest \([-0-9.]*\).*/\1/p' "$out/$2.report")
	printf '\n%s  %s\n' "$out/$2" "$3"
	printf '  %s and %d lines; %.2f m of cut in %d blocks\n' "$4" "$(value "$2" program lines)" \
		"$(echo "$cut" | awk '{ print $1 / 1000 }')" "$(value "$2" program blocks)"
	printf '  fitted within %.4f mm; read back, the program keeps to that within %.4f mm\n' \
		"$fitted" "$off"
	printf '  the ball goes at most %.3f mm deep into the scan, anywhere along the program\n' "$depth"
}

echo "\$ cloud2mesh -t $spacing $scan > $out/face.ply"
cloud2mesh -q -t $spacing -o "$out/face.ply" $scan
echo "  $(wc -l <$scan | tr -d ' ') scan points," \
	"$(sed -n 's/^element vertex //p' "$out/face.ply") nodes on a triangular grid of $spacing mm"

echo "\$ meshnorm -r $radius --avoid --axis-rate $rate -g $scan $out/face.ply > $out/face.cl"
meshnorm -q -r $radius --avoid --axis-rate $rate -g $scan -o "$out/face.cl" "$out/face.ply"
echo "  $(grep -c CONTCT/ "$out/face.cl") points in $(grep -c PASS/ "$out/face.cl") passes;" \
	"a ball of radius $radius, kept clear of all of the scan" \
	"(what it does not fit stays standing)"

echo "\$ biarcfit -e $tolerance $out/face.cl | ncpost -c siemens > $out/face.mpf"
echo "\$ bsplfit -e $tolerance $out/face.cl | ncpost -c fanuc > $out/face.nc"
job biarcfit siemens face-arcs.cl face.mpf &
arcs=$!
job bsplfit fanuc face-splines.cl face.nc
wait $arcs

told face-arcs.cl face.mpf "Siemens: TRAORI, tool vectors" \
	"$(value face.mpf program arcs) arcs in space (CIP)"
told face-splines.cl face.nc "Fanuc: G43.4, A and C" \
	"$(value face.nc program curves) B-splines (G06.2) of $(value face.nc program poles) control points"

# verdict PROGRAM: what ncverify says, in short; the whole of it as a page for a browser
verdict() {
	page=${1%.*}-${1##*.}.html
	printf '\n$ ncverify -g %s -r %s -e %s --report %s %s\n' $scan $radius $deepest "$out/$page" \
		"$out/$1"
	ncverify -q -g $scan -r $radius -e $deepest --report "$out/$page" "$out/$1" >"$out/$1.verdict" ||
		code=$?
	sed -n -e 's/^/  /' -e '/^  time/p' -e '/^  gouge *worst/p' -e '/^  gouge *50%/p' \
		-e '/^  left *50%/p' -e '/^  verdict/p' "$out/$1.verdict"
}

code=0
verdict face.nc
verdict face.mpf

printf '\n$ ncplot --cut %s %s > %s\n' "$out/face.ply" "$out/face.mpf" "$out/face.svg"
ncplot -q --cut --title "A face, its mesh and its Siemens program" -o "$out/face.svg" \
	"$out/face.ply" "$out/face.mpf"
echo "  the picture: $out/face.svg; to turn and zoom it in a browser: $out/face-mpf.html"
exit "$code"

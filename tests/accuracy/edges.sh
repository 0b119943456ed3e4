#!/bin/sh
# edges.sh - how deep the ball goes into sharp and thin shapes that are known exactly (edges.c), and
# what the tools say of it: a line for each scan with the exit statuses of meshnorm, biarcfit and
# ncverify and the deepest place along the fitted path, by the surface itself.
#
# BIN: the tools; READBACK: the tests' reader; EDGES: the maker of shapes.  SHAPES, PATTERNS, STEPS
# (distances of points, mm), SEEDS, RADIUS take part of the table, or another one.
#
#	make accuracy-edges SHAPES="ring cone_60" STEPS=0.5 SEEDS=7
#
# Exit 1: a path goes deeper than the tolerance, and no tool said so.
tmp=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
PATH=$BIN:$PATH
tolerance=0.01 radius=${RADIUS:-2.5} silent=0

row() { # SHAPE PATTERN STEP SEED
	"$EDGES" "$1" "$2" "$3" "$4" >"$tmp/scan.xyz"
	cloud2mesh -q -t 2 -o "$tmp/mesh.ply" "$tmp/scan.xyz"
	meshnorm -q -r "$radius" --avoid -g "$tmp/scan.xyz" -o "$tmp/path.cl" "$tmp/mesh.ply" 2>"$tmp/err"
	path=$?
	biarcfit -q -e $tolerance -g "$tmp/scan.xyz" -o "$tmp/fitted.cl" "$tmp/path.cl" 2>"$tmp/err"
	fit=$?
	ncpost -q -c siemens -o "$tmp/program.mpf" "$tmp/fitted.cl" 2>"$tmp/err"
	ncverify -q -r "$radius" -g "$tmp/scan.xyz" "$tmp/program.mpf" >"$tmp/err" 2>&1
	judged=$?
	deep=$("$READBACK" --scan "$tmp/truth.xyz" "$tmp/fitted.cl" | sed -n 's/^ball: deepest \([-0-9.]*\).*/\1/p')
	echo "$1 $2 $3 $4 $path $fit $judged $deep" | awk -v most=$tolerance '{
		bad = $5 + $6 + $7 == 0 && !($8 <= most + 5e-5)
		printf "%-11s %-6s %4s %4s   %d %d %d  %8.4f%s\n", $1, $2, $3, $4, $5, $6, $7, $8, bad ? "  beyond" : ""
		exit bad
	}' || silent=1
}

printf '%-11s %-6s %4s %4s   %s  %8s\n' shape scan step seed exits deepest
for shape in ${SHAPES:-$("$EDGES")}; do
	for seed in ${SEEDS:-1 2 3}; do
		"$EDGES" "$shape" truth 0.1 "$seed" >"$tmp/truth.xyz"
		for step in ${STEPS:-0.5 1}; do
			for pattern in ${PATTERNS:-grid lines random}; do
				row "$shape" "$pattern" "$step" "$seed"
			done
		done
	done
done
exit $silent

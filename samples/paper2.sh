#!/bin/sh
# paper2.sh - Tables 1 to 4 of Bey, Boudjouad and Tafat-Bouzid (2007): the paper's own figures for
# its surfaces, and those of the two substitutes here as published (--paper) and by default.
# BIN: where the tools are.
dir=$(cd "$(dirname "$0")" && pwd) || exit 1
BIN=${BIN:-$dir/../build/bin}
tmp=$(mktemp -d "${TMPDIR:-/tmp}/paper2.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

# make_path NAME RADIUS STEP ANGLE: the surface's mesh, and the tool's path over it
make_path() {
	"$BIN/nurbs2mesh" -q -n 200 -o "$tmp/$1.ply" "$dir/paper2_$1_a.igs" &&
		"$BIN/planecut" -q --paper --fixed 0,0,1 -r "$2" -s "$3" -a "$4" -o "$tmp/$1.cl" "$tmp/$1.ply"
}

# fit NAME TOLERANCE POINTS OPTIONS...: points, control points, reduction, C1, C2, the middle, the
# distance both ways
fit() {
	name=$1 tolerance=$2 points=$3
	shift 3
	"$BIN/bsplfit" -q "$@" --table --track "$points" -e "$tolerance" -o "$tmp/out" "$tmp/$name.cl" \
		2>"$tmp/report" || exit 1
	awk '$1 == "all" { print $2, $3, $4, $5, $6, $8, $9 }' "$tmp/report"
}

# row LABEL CC CE CL
row() {
	printf '  %-26s %10s %10s %10s\n' "$@"
}

# rows LABEL OPTIONS...: the table's lines for one way to fit
rows() {
	label=$1
	shift
	for points in contact centre tip; do
		fit "$surface" "$tolerance" $points "$@" >"$tmp/$points" || exit 1
	done
	column=0
	for what in points 'control points' 'reduction, %' C1 C2 'middle of two points' 'distance both ways'; do
		column=$((column + 1))
		set --
		for points in contact centre tip; do
			set -- "$@" "$(cut -d ' ' -f $column "$tmp/$points")"
		done
		row "$label$what" "$@"
	done
}

# table NUMBER SURFACE TOLERANCE CONTROL... : control points, reduction, C1, C2 as the paper has them
table() {
	surface=$2 tolerance=$3
	printf 'Table %s: surface %s, accuracy %s\n' "$1" "${2#s}" "$3"
	row '' CC CE CL
	shift 3
	row "paper:   control points" "$1" "$2" "$2"
	row "paper:   reduction, %" "$3" "$4" "$4"
	row "paper:   C1" "$5" "$6" "$6"
	row "paper:   C2" "$7" "$8" "$8"
	rows '--paper: ' --paper
	rows 'default: '
}

make_path s1 4 2 90 || exit 1
make_path s2 10 5 0 || exit 1
table 1 s1 0.1 225 230 97.5 97.45 0.0952 0.0947 0.0029 0.002
table 2 s1 0.05 240 230 97.34 97.45 0.0479 0.0497 0.0013 0.0014
table 3 s1 0.01 375 355 95.84 96.07 0.0098 0.0099 0.0004 0.0002
table 4 s2 0.1 330 320 97.47 97.54 0.095 0.1 0.0026 0.003

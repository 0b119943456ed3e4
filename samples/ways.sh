#!/bin/sh
# ways.sh [SCAN...] - the ways from points to a program that Chui, Chiu and Yu (2007) review, beside
# their own, each on the same scans with the same ball, fitter and control: what each costs, how far
# it is off, and what ncverify says of its program.
#
# SCAN: panel, face, dense (the panel's formula with ten times its points), or a file; by default
# the first three.  WAYS: those of them to go (default: all seven).
# BIN: where the tools are.  OUT: a folder to keep the streams and messages in.
dir=$(cd "$(dirname "$0")" && pwd) || exit 1
BIN=$(cd "${BIN:-$dir/../build/bin}" && pwd) || exit 1
CLOUDMILL_MACHINES=${CLOUDMILL_MACHINES:-$dir/../machines}
PATH=$BIN:$PATH
export PATH CLOUDMILL_MACHINES
if [ -n "$OUT" ]; then
	mkdir -p "$OUT" || exit 1
	work=$(cd "$OUT" && pwd) || exit 1
else
	work=$(mktemp -d "${TMPDIR:-/tmp}/ways.XXXXXX") || exit 1
	trap 'rm -rf "$work"' EXIT
	trap 'exit 130' INT TERM
fi
back=$PWD
cd "$work" || exit 1
ball=5 fit=0.01
timer=$(command -v /usr/bin/time)

# The panel's formula (tests/lib/panel.c) over 74 x 54 mm, about 0.153 mm apart.
dense() {
	awk 'BEGIN {
		seed = 1
		for (i = 0; i < 484; i++) for (j = 0; j < 352; j++) {
			seed = (seed * 16807) % 2147483647; x = -37 + 74 * (i + seed / 2147483647) / 484
			seed = (seed * 16807) % 2147483647; y = -27 + 54 * (j + seed / 2147483647) / 352
			z = -6.5 * x ^ 2 / 37 ^ 2 - 5 * y ^ 2 / 27 ^ 2 - 1.6 * x ^ 2 * y ^ 2 / (37 * 27) ^ 2 - 1.2 * y / 27
			z += 1.9 * exp(-((x - 20) / 12.5) ^ 2 - ((y - 7) / 11) ^ 2)
			z += 1.9 * exp(-((x + 20) / 12.5) ^ 2 - ((y - 7) / 11) ^ 2)
			z -= 2.2 * exp(-(x / 20) ^ 4 - ((y + 9) / 6) ^ 2)
			printf "%.4f %.4f %.4f\n", x, y, 1.0358020758819393 * (z + 14.28904030944473)
		} }'
}

# step OUTPUT COMMAND...: its time and memory are added to the way's; exit status 3 is no failure
step() {
	to=$1
	shift
	[ "$failed" -eq 0 ] || return 0
	if [ -n "$timer" ]; then
		"$timer" -o time.txt -f '%U %S %M' "$@" >"$to" 2>>"$log"
	else
		"$@" >"$to" 2>>"$log"
	fi
	case $? in 0 | 3) ;; *) failed=1 ;; esac
	[ -n "$timer" ] && tail -n 1 time.txt >>times.txt
	return 0
}

# way NAME SCAN FILE SCALLOP MAKER...: one line of the table
way() {
	name=$1 scan=$2 file=$3 scallop=$4
	shift 4
	case " ${WAYS:-$name} " in *" $name "*) ;; *) return ;; esac
	failed=0 log=$work/$scan-$name.txt
	: >"$log"
	: >verdict.txt
	: >times.txt
	case $1 in
	cloud2surf)
		step surface.nurbs "$@" "$file"
		step mesh.ply nurbs2mesh -e "$fine" surface.nurbs
		step path.cl planecut -r $ball --scallop "$scallop" --avoid mesh.ply
		;;
	*)
		step mesh.ply "$@" "$file"
		step path.cl meshnorm -r $ball --scallop "$scallop" --avoid mesh.ply
		;;
	esac
	case $name in
	lai) step fitted.cl bsplfit --interpolate -v -e $fit path.cl ;;
	lin) cp path.cl fitted.cl ;; # straight lines, as published
	*) step fitted.cl biarcfit -v -e $fit path.cl ;;
	esac
	step "$scan-$name.mpf" ncpost -c siemens fitted.cl
	cp times.txt spent.txt
	step verdict.txt ncverify -q -g "$file" -r $ball -e 0.02 "$scan-$name.mpf"
	cat verdict.txt >>"$log"
	[ "$failed" -eq 0 ] || {
		printf '%-7s %-9s %s\n' "$scan" "$name" "$(tail -n 1 "$log")"
		return
	}
	awk -v scan="$scan" -v name="$name" -v bytes="$(wc -c <"$scan-$name.mpf")" '
		FILENAME == "spent.txt" { cpu += $1 + $2; if ($3 > kb) kb = $3; next }
		FILENAME == "mesh.ply" && /^element vertex/ { held = $3 }
		FILENAME == "mesh.ply" { if (/^end_header/) nextfile; next }
		/of the (mesh|surface) at worst/ { match($0, /within [0-9.]* mm/); off = substr($0, RSTART + 7, RLENGTH - 10) }
		/ = [0-9]* control points$/ { held = $(NF - 2) }
		/^program/ { for (i = 1; i < NF; i++) { if ($(i + 1) ~ /^straight/) lines = $i; if ($(i + 1) ~ /^arcs/) arcs = $i
			if ($(i + 1) ~ /^curves/) curves = $i } }
		/^gouge +worst/ { gouge = $3 }
		/^left +worst/ { left = $3 }
		/^coverage +left/ { uncut = $3 }
		/^verdict/ { verdict = $2 }
		END { printf "%-7s %-9s %8.1f %6.0f %8s %8s %8s %8s %7s %7d %7d %7d %9d  %s\n", scan, name, cpu, kb / 1024,
			held, off == "" ? "-" : off, gouge, left, uncut, lines, arcs, curves, bytes, verdict }' \
		spent.txt mesh.ply "$log"
}

# all SCAN FILE SCALLOP ERROR: ERROR: of a surface or a triangulation
all() {
	scan=$1 file=$2 scallop=$3 error=$4
	fine=$(awk -v e="$error" 'BEGIN { print (e / 5 > 0.003 ? e / 5 : 0.003) }') # of a surface's mesh
	way direct "$scan" "$file" "$scallop" cloud2mesh
	way lin "$scan" "$file" "$scallop" cloud2mesh --method lin
	way lai "$scan" "$file" "$scallop" cloud2mesh --method lin
	way choi "$scan" "$file" "$scallop" cloud2mesh --method delaunay -e "$error"
	way bspline "$scan" "$file" "$scallop" cloud2surf --bspline -e "$error"
	way ferguson "$scan" "$file" "$scallop" cloud2surf --ferguson -e "$error"
	way bezier "$scan" "$file" "$scallop" cloud2surf --bezier -e "$error"
}

printf '%-7s %-9s %8s %6s %8s %8s %8s %8s %7s %7s %7s %7s %9s  %s\n' scan way "CPU s" MB held off gouge left \
	uncut lines arcs curves bytes verdict
[ $# -gt 0 ] || set -- panel face dense
for scan; do
	case $scan in
	panel) all panel "$dir/panel_17036.xyz" 0.02 0.01 ;;
	face) all face "$dir/face_nefertiti_26493.xyz" 0.1 0.1 ;;
	dense)
		dense >dense.xyz
		all dense "$work/dense.xyz" 0.02 0.01
		;;
	*)
		file=$(cd "$back" && readlink -f -- "$scan") && [ -f "$file" ] ||
			{ echo "ways.sh: found $scan, expected panel, face, dense or a file" >&2 && exit 2; }
		all "$(basename "$scan" .xyz)" "$file" 0.05 0.02
		;;
	esac
done

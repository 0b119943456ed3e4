#!/bin/sh
# paper1.sh - the two examples of Chui, Chiu and Yu (2007), meshed as the paper does (--paper) and
# as this suite does by default, beside the paper's own figures.  BIN: where the tools are.
dir=$(cd "$(dirname "$0")" && pwd) || exit 1
BIN=${BIN:-$dir/../build/bin}
tmp=$(mktemp "${TMPDIR:-/tmp}/paper1.XXXXXX") || exit 1
trap 'rm -f "$tmp"' EXIT
trap 'exit 130' INT TERM

# row NAME PAPER FILE OPTIONS...: one line of the table
row() {
	name=$1 paper=$2 file=$3
	shift 3
	"$BIN/cloud2mesh" -q "$@" -o "$tmp" "$dir/$file" || exit 1
	awk -v name="$name" -v paper="$paper" -v options="$*" '
		/^element vertex/ { vertices = $3 }
		/^element face/ { facets = $3 }
		/^end_header/ { body = 1; next }
		body && row < vertices {
			row++
			if (!seen[$1 " " $2 " " $3]++)
				points++
		}
		END { printf "%-20s %-16s %9d %9d %9d   %s\n", name, options, vertices, points, facets, paper }
	' "$tmp"
}

printf '%-20s %-16s %9s %9s %9s   %s\n' cloud options vertices "of points" facets "paper's vertices"
row 'panel, 17,036' 343 panel_17036.xyz -t 4 --paper
row 'panel, 17,036' - panel_17036.xyz -t 4
row 'face, 26,493' '1,099 (its t is not printed)' face_nefertiti_26493.xyz -t 4 --paper
row 'face, 26,493' '1,099' face_nefertiti_26493.xyz -t 3.8 --paper
row 'face, 26,493' - face_nefertiti_26493.xyz -t 4

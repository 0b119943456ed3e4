#!/bin/sh
# accuracy.sh - how deep the ball goes, and what it leaves: on surfaces that are known exactly, and on
# real scans.
#
# BIN: the tools; READBACK: the tests' reader; CLOUD: the maker of clouds (cloud.c).  These may be set
# to take part of the table, or another one: SHAPES (with the radius of the ball), NOISE, PATTERNS,
# SEED; SCANS (likewise); FITTERS for both; DEPTH, the gouge that is allowed without noise.
#
#	make accuracy SHAPES="panel:8 wave:2" NOISE=0.02 FITTERS=bsplfit SEED=11 SCANS=my.xyz:5
#
# The gouge is the deepest place anywhere along the fitted path, by the reader, which shares no code
# with the tools' writers; on a known surface it may be the tolerance and 1.5 sigma.  What is left is
# what ncverify finds on the Siemens program: on a known surface, 1.5 mm inside of its border, it may
# be 1.5 sigma, the scallop and the tolerance.  Known surfaces are judged by themselves, not by the
# scan of them; a real scan by all its points.  Exit 1: a row is beyond what it is allowed.
tmp=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
PATH=$BIN:$PATH
samples=$(cd "$(dirname "$0")/../../samples" && pwd)
tolerance=0.01 scallop=0.02 margin=1.5
standing=0.03 # the two together
beyond=0
points() { # SHAPE: how many make a scan of it
	case $1 in panel) echo 17036 ;; dome) echo 10000 ;; saddle) echo 10000 ;; *) echo 8900 ;; esac
}

# paths SCAN RADIUS: path.cl over it
paths() {
	cloud2mesh -q -t 2 -o "$tmp/mesh.ply" "$1"
	meshnorm -q -r "$2" --scallop $scallop -e $tolerance --avoid -g "$1" -o "$tmp/path.cl" \
		"$tmp/mesh.ply"
}

# fitted FITTER SCAN: path.cl as that fitter has it, fitted.cl, and its program
fitted() {
	case $1 in
	none) cp "$tmp/path.cl" "$tmp/fitted.cl" ;;
	*) "$1" -q -e $tolerance -g "$2" -o "$tmp/fitted.cl" "$tmp/path.cl" ;;
	esac
	ncpost -q -c siemens -o "$tmp/program.mpf" "$tmp/fitted.cl"
}

depth_in() { # POINTS: the deepest place of fitted.cl
	"$READBACK" --scan "$1" "$tmp/fitted.cl" | sed -n 's/^ball: deepest \([-0-9.]*\).*/\1/p'
}

left_on() { # POINTS RADIUS WHAT: of the material that the program leaves
	ncverify -r "$2" -g "$1" --band 1 "$tmp/program.mpf" 2>"$tmp/err" |
		sed -n "s/^ *left .*$3 \([-0-9.]*\).*/\1/p"
}

on_shape() { # SHAPE RADIUS PATTERN NOISE
	"$CLOUD" "$1" "$3" "$(points "$1")" "$4" "${SEED:-1}" >"$tmp/scan.xyz"
	paths "$tmp/scan.xyz" "$2"
	for fitter in ${FITTERS:-none biarcfit bsplfit}; do
		fitted "$fitter" "$tmp/scan.xyz"
		echo "$1 $2 $3 $4 $fitter" "$(depth_in "$tmp/truth.xyz")" \
			"$(left_on "$tmp/inner.xyz" "$2" worst)" |
			awk -v depth="${DEPTH:-$tolerance}" -v standing=$standing '{
				gouge = depth + 1.5 * $4
				left = standing + 1.5 * $4
				bad = $6 > gouge + 5e-5 || $7 > left + 5e-5 || NF < 7
				printf "%-7s %3s %-7s %5s %-8s  %7.4f %7.4f    %6.4f %7.4f%s\n", $1, $2, $3, $4, $5,
					$6, gouge, $7, left, bad ? "  beyond" : ""
				exit bad
			}' || beyond=1
	done
}

on_scan() { # SCAN RADIUS
	paths "$1" "$2"
	for fitter in ${FITTERS:-none biarcfit bsplfit}; do
		fitted "$fitter" "$1"
		printf '%-29s %3s %-8s  %7.4f    %6.4f %7.4f\n' "$(basename "$1")" "$2" "$fitter" \
			"$(depth_in "$1")" "$(left_on "$1" "$2" '50%')" "$(left_on "$1" "$2" '95%')"
	done
}

shapes=${SHAPES-panel:8 dome:8 saddle:8 bowl:8 wave:2}
[ -z "$shapes" ] || printf '%-7s %3s %-7s %5s %-8s  %7s %7s    %6s %7s\n' \
	shape R pattern noise fitter gouge allowed left allowed
for what in $shapes; do
	shape=${what%:*} radius=${what#*:}
	step=$(echo "$radius" | awk '{ print $1 < 4 ? 0.05 : 0.1 }')
	"$CLOUD" "$shape" truth "$step" 0 >"$tmp/truth.xyz"
	"$CLOUD" "$shape" truth 0.1 $margin >"$tmp/inner.xyz"
	for pattern in ${PATTERNS:-grid lines random}; do
		for noise in ${NOISE:-0 0.01 0.02 0.05}; do
			on_shape "$shape" "$radius" "$pattern" "$noise"
		done
	done
done

scans=${SCANS-$samples/face_nefertiti_26493.xyz:10 $samples/panel_17036.xyz:8}
[ -z "$scans" ] || printf '%-29s %3s %-8s  %7s    %6s %7s\n' scan R fitter gouge 'left 50%' '95%'
for what in $scans; do
	on_scan "${what%:*}" "${what##*:}"
done
exit $beyond

#!/bin/sh
# accuracy.sh - how deep the ball goes, and what it leaves, on surfaces that are known exactly.
#
# BIN: the tools; READBACK: the tests' reader; CLOUD: the maker of clouds (cloud.c).  SHAPES, NOISE,
# PATTERNS, FITTERS and SEED may be set to take part of the table, or another one; DEPTH is the gouge
# that is allowed without noise (the tolerance):
#
#	make accuracy SHAPES="panel:8 wave:2" NOISE=0.02 FITTERS=bsplfit SEED=11
#
# A row is allowed a gouge of the tolerance and 1.5 sigma anywhere along the fitted path, by the
# reader, which shares no code with the tools' writers; and 1.5 sigma, the scallop and the tolerance
# left standing 1.5 mm inside of the border, by ncverify on the Siemens program.  Both are measured
# on the true surface, not on the scan.  Exit 1: a row is beyond what it is allowed.
tmp=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
PATH=$BIN:$PATH
tolerance=0.01 scallop=0.02 margin=1.5
standing=0.03 # the two together
beyond=0
points() { # SHAPE: how many make a scan of it
	case $1 in panel) echo 17036 ;; dome) echo 10000 ;; saddle) echo 10000 ;; *) echo 8900 ;; esac
}

# fitted FITTER SCAN: path.cl as that fitter has it, fitted.cl
fitted() {
	case $1 in
	none) cp "$tmp/path.cl" "$tmp/fitted.cl" ;;
	*) "$1" -q -e $tolerance -g "$2" -o "$tmp/fitted.cl" "$tmp/path.cl" ;;
	esac
}

# measured RADIUS: the deepest place of fitted.cl, and the most that its program leaves
measured() {
	deep=$("$READBACK" --scan "$tmp/truth.xyz" "$tmp/fitted.cl" |
		sed -n 's/^ball: deepest \([-0-9.]*\).*/\1/p')
	ncpost -q -c siemens -o "$tmp/program.mpf" "$tmp/fitted.cl"
	left=$(ncverify -r "$1" -g "$tmp/inner.xyz" --band 1 "$tmp/program.mpf" 2>"$tmp/err" |
		sed -n 's/^ *left  *worst \([-0-9.]*\).*/\1/p')
}

printf '%-7s %3s %-7s %5s %-8s  %7s %7s    %6s %7s\n' shape R pattern noise fitter gouge allowed \
	left allowed
for what in ${SHAPES:-panel:8 dome:8 saddle:8 bowl:8 wave:2}; do
	shape=${what%:*} radius=${what#*:}
	step=$(echo "$radius" | awk '{ print $1 < 4 ? 0.05 : 0.1 }')
	"$CLOUD" "$shape" truth "$step" 0 >"$tmp/truth.xyz"
	"$CLOUD" "$shape" truth 0.1 $margin >"$tmp/inner.xyz"
	for pattern in ${PATTERNS:-grid lines random}; do
		for noise in ${NOISE:-0 0.01 0.02 0.05}; do
			"$CLOUD" "$shape" "$pattern" "$(points "$shape")" "$noise" "${SEED:-1}" >"$tmp/scan.xyz"
			cloud2mesh -q -t 2 -o "$tmp/mesh.ply" "$tmp/scan.xyz"
			meshnorm -q -r "$radius" --scallop $scallop -e $tolerance --avoid -g "$tmp/scan.xyz" \
				-o "$tmp/path.cl" "$tmp/mesh.ply"
			for fitter in ${FITTERS:-none biarcfit bsplfit}; do
				fitted "$fitter" "$tmp/scan.xyz"
				measured "$radius"
				echo "$shape $radius $pattern $noise $fitter $deep $left" |
					awk -v depth="${DEPTH:-$tolerance}" -v more=$standing '{
						gouge = depth + 1.5 * $4; left = more + 1.5 * $4
						bad = $6 > gouge + 5e-5 || $7 > left + 5e-5 || NF < 7
						printf "%-7s %3s %-7s %5s %-8s  %7.4f %7.4f    %6.4f %7.4f%s\n", $1, $2, $3, $4, $5,
							$6, gouge, $7, left, bad ? "  beyond" : ""
						exit bad
					}' || beyond=1
			done
		done
	done
done
exit $beyond

#!/bin/sh
# bsplfit-interpolate.t - cubic splines through all points of a path: on them, two more poles than
# points, knots that stand apart, their ends; a program that is accepted.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

passes=$SRC/tests/data/panel_passes.cl
panel=$SRC/samples/panel_17036.xyz

poles() { # FILE: all of them
	sed -n 's/^MOVNRB.ON,[0-9]*,[0-9]*,0,\([0-9]*\),.*/\1/p' "$1" | awk '{ n += $1 } END { print n + 0 }'
}
off() { awk -f "$SRC/tests/lib/splines.awk" "$1" "$2"; }
spent() { sed -n 's/^.*LEDGER\/bsplfit,//p' "$1" | sort -n | tail -n 1; }
# bend FILE: the largest second difference of the first three poles of a curve, by their knots: the
# second derivative at its start, whose zero is a natural end
bend() {
	awk '/ \$$/ { held = held substr($0, 1, length($0) - 2); next }
		{ line = held $0; held = "" }
		line ~ /^MOVNRB.1,/ { split(line, k, ",") }
		line ~ /^MOVNRB.2,/ { split(line, q, ","); a = k[6] - k[5]; b = k[7] - k[5]
			for (i = 2; i <= 4; i++) {
				d = 6 / a * ((q[i + 6] - q[i + 3]) / b - (q[i + 3] - q[i]) / a)
				if (d < 0) d = -d
				if (d > w) w = d
			} }
		END { printf "%.6f\n", w }' "$1"
}

for ends in natural clamped bessel; do
	status 0 "$ends ends" bsplfit -v --interpolate --ends $ends -e 0.02 -o "$TMP/$ends.cl" "$passes"
	found=$(sed -n 's/.*: \([0-9]*\) points in \([0-9]*\) runs: \([0-9]*\) splines, \([0-9]*\) control.*/\1 \3 \4/p' "$TMP/err")
	result "$(echo "$found" | awk '{ print $3 != $1 + 2 * $2 }')" "two poles more than points in each curve ($found)"
done
awk '/^RAPID/ { n++ } n < 3 || /^FINI/' "$passes" >"$TMP/one.cl"
status 0 "one pass" bsplfit -q --interpolate --ends bessel -e 0.02 -o "$TMP/one-fit.cl" "$TMP/one.cl"
below "what another reader finds between points" "$(off "$TMP/one.cl" "$TMP/one-fit.cl")" "$(spent "$TMP/one-fit.cl")"
below "natural ends have no curvature" "$(bend "$TMP/natural.cl")" 0.001
below "the others have some" 0.001 "$(bend "$TMP/bessel.cl")"
fails "their curves are not the same" cmp -s "$TMP/clamped.cl" "$TMP/bessel.cl"
status 0 "natural is the default" bsplfit -q --interpolate -e 0.02 -j 3 -o "$TMP/d.cl" "$passes"
same "for any number of threads" "$TMP/natural.cl" "$TMP/d.cl"
status 3 "a tolerance that the way between points does not keep" bsplfit --interpolate -e 0.0001 \
	-o "$TMP/tight.cl" "$passes"
has "is named" 'the tolerance is not kept' "$TMP/err"
status 3 "one that it does not keep with what the smooth path is off its points" \
	bsplfit --interpolate -e 0.00015 -o "$TMP/tight.cl" "$passes"
below "what is named is more than the tolerance" 0.00015 \
	"$(sed -n 's/.*: pass [0-9]*: \([0-9.]*\) mm at the tip.*/\1/p' "$TMP/err")"

status 2 "--ends alone" bsplfit --ends bessel "$passes"
status 2 "with a degree" bsplfit --interpolate --degree 4 "$passes"
status 2 "as in the other paper" bsplfit --interpolate --paper "$passes"

status 0 "the panel, rows" sh -c "cloud2mesh -q --method lin -t 2 '$panel' | meshnorm -q -r 5 --axis-play 0 -o '$TMP/row.cl'"
status 0 "curves where the axis turns, guarded" bsplfit -q --interpolate --ends bessel -e 0.02 -o "$TMP/fit.cl" "$TMP/row.cl"
status 0 "its program" sh -c "ncpost -q -c siemens '$TMP/fit.cl' >'$TMP/part.mpf'"
status 0 "is accepted" ncverify -g "$panel" -r 5 -e 0.03 "$TMP/part.mpf"

done_testing

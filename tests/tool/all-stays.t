#!/bin/sh
# all-stays.t - where the tip stays and the tool axis alone turns, point after point: both fitters
# in a time that is linear in the points, what biarcfit writes within its tolerances by a reader of
# its own, and no number that is none.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# path POINTS MOVES STAYS: at feed, in turn so many points along a wave of the tip and so many where
# it stays; there the axis goes round, leaning by 17 degrees
path() {
	awk -v n="$1" -v moves="$2" -v stays="$3" 'BEGIN {
		print "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/8000,CLW\nCUTTER/8,4,0,4,0,0,60"
		print "RAPID\nGOTO/0,0,200,0,0,1\nFEDRAT/MMPM,500"
		for (i = 0; i < n; i++) {
			if (i % (moves + stays) < moves) x += 0.05
			else turn += 0.02
			l = sqrt(1.09)
			printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, 3 * sin(x / 7), 5 * sin(x / 20),
				0.3 * sin(turn) / l, 0.3 * cos(turn) / l, 1 / l
		}
		print "FINI" }'
}

# off PATH LINES: how far the points of PATH are off the straight lines, which go the same way: tip,
# mm, centre, mm, and axis, degrees; of each the best that the lines from the last one on have
off() {
	awk -F'[/,]' '/^FEDRAT/ { feed[FILENAME] = 1 }
		!/^GOTO/ || !feed[FILENAME] { next }
		NR == FNR { n++; for (i = 1; i <= 6; i++) p[n, i] = $(i + 1); next }
		{ m++; for (i = 1; i <= 6; i++) q[m, i] = $(i + 1) }
		function far(k, j, offset,   i, a, b, c, s, d2, e2, t) {
			d2 = s = 0
			for (i = 1; i <= 3; i++) {
				a = q[j, i] + offset * q[j, i + 3]
				b = q[j + 1, i] + offset * q[j + 1, i + 3]
				c = p[k, i] + offset * p[k, i + 3]
				e[i] = c - a; d[i] = b - a; d2 += d[i] ^ 2; s += d[i] * e[i]
			}
			t = d2 > 0 ? s / d2 : 0
			t = t < 0 ? 0 : t > 1 ? 1 : t
			for (i = 1; i <= 3; i++) e2 += (e[i] - t * d[i]) ^ 2
			return sqrt(e2)
		}
		END {
			at = 1
			for (k = 1; k <= n; k++) {
				best = 1e9
				for (j = at; j < m && j < at + 40; j++) {
					tip = far(k, j, 0); ball = far(k, j, 4); worse = tip > ball ? tip : ball
					if (worse < best) { best = worse; where = j; there[1] = tip; there[2] = ball }
				}
				at = where
				for (i = 1; i <= 2; i++) if (there[i] > most[i]) most[i] = there[i]
			}
			printf "%.4f %.4f\n", most[1], most[2]
		}' "$1" "$2"
}
# keeps OFF: "TIP CENTRE", within the tolerance of 0.01 mm and what rounding adds
keeps() { echo "$1" | awk '{ exit !($1 <= 0.01001 && $2 <= 0.01001) }'; }

path 10000 0 10000 >stay.cl
path 1500 0 1500 >short.cl
path 2000 500 1000 >amid.cl
path 2000 100 100 >often.cl
for fitter in biarcfit bsplfit; do
	status 0 "$fitter: 10,000 points in half a minute of work at most" \
		sh -c 'ulimit -t 30; exec "$@"' sh $fitter -q -j 1 --no-guard -o fitted.cl stay.cl
	ok "$fitter: less than half as many lines" test "$(wc -l <fitted.cl)" -lt 5000
	for kind in short amid often; do
		status 0 "$fitter: a path, $kind" $fitter -q -o "$kind-$fitter.cl" $kind.cl
		fails "each number is one, $kind" grep -q 'nan\|inf' "$kind-$fitter.cl"
	done
done
for kind in short amid often; do
	ok "lines alone" biarcfit -q --linear-arcs -o lines.cl $kind.cl
	found=$(off $kind.cl lines.cl)
	ok "they keep the tolerance at tip and centre, $kind: $found" keeps "$found"
done
done_testing

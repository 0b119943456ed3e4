#!/bin/sh
# all-time.t - programs at 3,000 mm/min on a machine with usual limits, timed by
# tests/time/leasttime.c, which shares nothing with the tools: how much longer than length by feed,
# how far the rotary axes turn, and no block that asks an axis for more than it has.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# shellcheck disable=SC2086 # CC may have options
ok "the evaluator builds" ${CC:-cc} -std=c11 -O2 -o leasttime "$SRC/tests/time/leasttime.c" -lm

figure() { # NAME FILE
	tr -s ' ' '\n' <"$2" | awk -v name="$1" 'last == name { print } { last = $0 }'
}

# ---- the evaluator itself: known by hand
printf '%s\n' 'N1 TRAORI' 'N2 G0 X0 Y0 Z0 A3=0 B3=0 C3=1' 'N3 G1 X600 F3000' >line.nc
ok "a line is timed" ./leasttime line.nc 3000
./leasttime line.nc 3000 >line
# 600 mm at 50 mm/s, and 50 mm/s once up and once down at 3,000 mm/s^2
below "600 mm take 12 seconds and 0.017, no more" "$(figure least line)" 0.201
below "and no less" 0.2 "$(figure least line)"
printf '%s\n' 'N1 TRAORI' 'N2 G0 X0 Y0 Z0 A3=0 B3=0.5 C3=0.8660254' \
	'N3 G1 X10 A3=0.5 B3=0 C3=0.8660254 F3000' >turn.nc
./leasttime turn.nc 3000 >turn
# C turns 90 degrees in 0.2 seconds; the chord of the two directions turns it fastest in the middle
below "an axis asked for four times its speed and more is told" 3.7 "$(figure most turn)"
below "C turns by a quarter" "$(figure turn-C turn)" 90.5
below "a quarter of a turn" 89.5 "$(figure turn-C turn)"
below "and in no less than 0.75 seconds" 0.0125 "$(figure least turn)"
printf '%s\n' 'N1 TRAORI' 'N2 G0 X0.02 Y0 Z0 A3=0.5 B3=0 C3=0.86602540' \
	'N3 CIP X0 Y0.02 I1=AC(0.01414214) J1=AC(0.01414214) K1=AC(0) A3=0.49892706 B3=0.03273817 C3=0.86602540 F60' >bend.nc
./leasttime bend.nc 60 >bend
# a quarter of a circle of 0.02 mm in 31.4 ms, C at 119.5 degrees a second
below "the way is that of the arc, not of its chords" "$(figure over bend)" 0
# through the pole at one turn; the hundredth place looked at is 25 nm before it
printf '%s\n' 'N1 TRAORI' 'N2 G0 X0 Y0 Z0 A3=0.004 B3=-0.022 C3=0.99975' \
	'N3 G1 X4.000025 A3=0 B3=0 C3=1 F3000' 'N4 X8 A3=-0.004 B3=0.022 C3=0.99975' >pole.nc
./leasttime pole.nc 3000 >pole
# 8 mm at 50 mm/s, and up to 50 mm/s once up and once down at 3,000 mm/s^2
below "the pole is passed without a stop" "$(figure ratio pole)" 1.11
below "C does not turn there" "$(figure turn-C pole)" 0

# ---- a bumpy dome
awk 'BEGIN { for (y = -14; y <= 14.001; y += 0.5) for (x = -25; x <= 25.001; x += 0.5)
	printf "%.4f %.4f %.4f\n", x, y, 30 - (x * x + y * y) / 60 + 0.5 * sin(x / 3) * cos(y / 4) }' >dome.xyz
cloud2mesh -q -t 2 dome.xyz -o dome.ply
for play in 15 0; do
	meshnorm -q -r 5 --scallop 0.1 --avoid --feed 3000 --axis-play $play dome.ply >line.cl
	biarcfit -q -e 0.01 line.cl >arcs.cl
	ncpost -q -c siemens arcs.cl >dome.nc
	./leasttime dome.nc 3000 >play-$play
	cp dome.nc dome-$play.nc
done
below "least time is no more than 1.25 times length by feed" "$(figure ratio play-15)" 1.25
below "no block asks an axis for more than its largest speed" "$(figure over play-15)" 0
below "links are a few arcs each" "$(figure motions play-15)" 320
below "A and C turn less than half as far as by the rule" \
	"$(awk -v a="$(figure turn-A play-15)" -v b="$(figure turn-C play-15)" 'BEGIN { print a + b }')" \
	"$(awk -v a="$(figure turn-A play-0)" -v b="$(figure turn-C play-0)" 'BEGIN { print (a + b) / 2 }')"
below "and that saves time" "$(figure ratio play-15)" "$(figure ratio play-0)"

# ---- the panel: its axis goes through the pole on every row
cloud2mesh -q "$SRC/samples/panel_17036.xyz" -o panel.ply
meshnorm -q -r 8 --scallop 0.1 --avoid --feed 3000 panel.ply >line.cl
biarcfit -q -e 0.01 line.cl >arcs.cl
ncpost -v -c siemens arcs.cl >panel.nc 2>said
./leasttime panel.nc 3000 >panel
below "the panel's least time is no more than 1.05 times length by feed" "$(figure ratio panel)" 1.05
below "in few motions" "$(figure motions panel)" 380
ok "no axis is asked for more than it has" eval '! grep -q "largest speed" said'

# shorter FILE: motions at feed of a Siemens program below 0.02 mm, by its digits
shorter() {
	awk '/^N/ { feed = / G0 / ? 0 : / (G1|CIP) / ? 1 : feed; moved = 0
			for (i = 2; i <= NF; i++) if (match($i, /^[XYZ]-?[0-9.]+$/)) {
				to[substr($i, 1, 1)] = substr($i, 2); moved = 1 }
			d = sqrt((to["X"] - x)^2 + (to["Y"] - y)^2 + (to["Z"] - z)^2)
			n += moved && feed && d < 0.02
			x = to["X"]; y = to["Y"]; z = to["Z"] }
		END { print n + 0 }' "$1"
}
printf '%s\n' 'N1 G0 X0 Y0 Z0' 'N2 G1 X1 F3000' 'N3 Y0.01' 'N4 CIP Y0.025 I1=AC(1)' \
	'N5 G0 Z0.01' >few.nc
below "two of four motions are short" "$(shorter few.nc)" 2
below "no fewer" 2 "$(shorter few.nc)"
below "none of the panel's" "$(shorter panel.nc)" 0
below "none of the dome's" "$(shorter dome-15.nc)" 0
below "nor where the axis flutters" "$(shorter dome-0.nc)" 0

# ---- a fixed axis: a cup of a hill, its sides as steep as the tool's, and steeper by its noise
awk 'BEGIN { for (y = -20; y <= 20.001; y += 0.5) for (x = -25; x <= 25.001; x += 0.5) {
	r = sqrt(x * x + y * y); printf "%.4f %.4f %.4f\n", x, y, 15 / (1 + exp((r - 10) * 3)) } }' >hill.xyz
cloud2mesh -q -t 2 hill.xyz -o hill.ply
meshnorm -q -r 4 --scallop 0.1 --avoid --feed 3000 --fixed 0,0,1 hill.ply 2>said >hill.cl
ok "nothing is lost of which it would have to be told" test "$?" = 0
has "a fixed axis is upright" '^GOTO.*,0.000000000,0.000000000,1.000000000$' hill.cl
ok "and it is so at all points" awk '/^GOTO/ && !/,0.000000000,0.000000000,1.000000000$/ { exit 1 }' hill.cl
biarcfit -q -e 0.01 hill.cl | ncpost -q -c siemens >hill.nc
./leasttime hill.nc 3000 >fixed
below "with a fixed axis least time is no more than 1.1 times length by feed" "$(figure ratio fixed)" 1.1
meshnorm -q -r 4 --scallop 0.1 --avoid --fixed 0.3,0,1 --lean-limit 85 hill.ply 2>said >hill.cl
ok "unless it may lean" awk -F, '/^GOTO/ && $4 $5 $6 != first { first = $4 $5 $6; n++ } END { exit n < 2 }' hill.cl
cat play-15 play-0 panel fixed | sed 's/^/# /'
done_testing

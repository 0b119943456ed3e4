#!/bin/sh
# biarcfit-length.t - --min-length of both fitters: pieces and knot spans by a reader of its own,
# counts, and what is said where the tolerance leaves no room.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

passes=$SRC/tests/data/panel_passes.cl

# shortest FILE: the shortest chord between two points at feed
shortest() {
	awk '/^RAPID/ { rapid = 1 } /^FEDRAT/ { first = 1 }
		/^GOTO/ { sub(/.*\//, ""); split($0, p, ",")
			d = sqrt((p[1] - q[1])^2 + (p[2] - q[2])^2 + (p[3] - q[3])^2)
			if (!rapid && !first && (!n++ || d < least)) least = d
			if (!rapid) first = 0
			rapid = 0
			for (i = 1; i <= 3; i++) q[i] = p[i] }
		END { printf "%.4f\n", least }' "$1"
}
# span FILE: the shortest knot span, in parameters
span() {
	awk '/ \$$/ { held = held substr($0, 1, length($0) - 2); next }
		{ line = held $0; held = "" }
		line ~ /^MOVNRB.ON/ { split(line, f, ","); order = f[2]; poles = f[5] }
		line ~ /^MOVNRB.1,/ { split(line, k, ",")
			for (i = order + 1; i <= poles + 1; i++)
				if (!n++ || k[i + 1] - k[i] < least) least = k[i + 1] - k[i] }
		END { printf "%.4f\n", least }' "$1"
}
over() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a >= b) }'; }
arcs() { grep -c '^CIRCLE' "$1"; }
poles() { sed -n 's/^MOVNRB.ON,[0-9]*,[0-9]*,0,\([0-9]*\),.*/\1/p' "$1" | awk '{ n += $1 } END { print n + 0 }'; }

status 0 "as short as comes" biarcfit -e 0.01 --min-length 0 -o "$TMP/any.cl" "$passes"
status 0 "two millimetres" biarcfit -e 0.01 --min-length 2 -o "$TMP/two.cl" "$passes"
fails "there are shorter ones without it" over "$(shortest "$TMP/any.cl")" 1.98
ok "none is shorter with it" over "$(shortest "$TMP/two.cl")" 1.98
ok "no more arcs for it" test "$(arcs "$TMP/two.cl")" -le "$(arcs "$TMP/any.cl")"
status 0 "no room" biarcfit -e 0.001 --min-length 20 -o "$TMP/no.cl" "$passes"
has "they are told and counted" '[0-9][0-9]* pieces are shorter than asked for' "$TMP/err"

status 0 "as short as comes" bsplfit -e 0.01 --min-length 0 -o "$TMP/any.cl" "$passes"
status 0 "three millimetres" bsplfit -e 0.01 --min-length 3 -o "$TMP/three.cl" "$passes"
hasnt "none is too short" 'shorter than asked for' "$TMP/err"
ok "the shortest span is longer with it" over "$(span "$TMP/three.cl")" \
	"$(span "$TMP/any.cl" | awk '{ print 1.2 * $1 }')"
ok "a few control points for it" test "$(poles "$TMP/three.cl")" -le $(($(poles "$TMP/any.cl") + 4))

# by default what the feed goes in 6 ms: a rough pass of points 0.03 mm apart
rough() { # FEED [STEP HEIGHT]
	sed '/^RAPID/,$d' "$passes"
	echo "FEDRAT/MMPM,$1"
	awk -v step="${2:-0.03}" -v height="${3:-0.03}" 'BEGIN { s = 1 + 7919 * ENVIRON["SEED"]; for (i = 0; i < 300; i++) {
			s = s * 16807 % 2147483647
			printf "GOTO/%.6f,0.000000,%.6f,0.000000000,0.000000000,1.000000000\n",
				i * step, height * s / 2147483647 }
		print "FINI" }'
}
rough 1500 >"$TMP/rough.cl"
for fit in biarcfit bsplfit; do
	status 0 "$fit: the feed's length" $fit -o "$TMP/feed" "$TMP/rough.cl"
	status 0 "$fit: the same by hand" $fit --min-length 0.15 -o "$TMP/hand" "$TMP/rough.cl"
	has "$fit: shorter ones are told" 'shorter than asked for' "$TMP/err"
	ok "$fit: 6 ms of the feed" cmp "$TMP/feed" "$TMP/hand"
	status 0 "$fit: any length" $fit --min-length 0 -o "$TMP/none" "$TMP/rough.cl"
	hasnt "$fit: none is too short then" 'shorter than asked for' "$TMP/err"
done
# corners and arcs of points nearer than a block may be short: gone round, as far as there is room
short() { # FILE: how many chords at feed are below 0.02 mm
	awk '/^RAPID/ { rapid = 1 }
		/^GOTO/ { sub(/.*\//, ""); split($0, p, ",")
			n += !rapid && seen && (p[1] - q[1])^2 + (p[2] - q[2])^2 + (p[3] - q[3])^2 < 0.0004
			seen = !rapid; rapid = 0
			for (i = 1; i <= 3; i++) q[i] = p[i] }
		END { print n + 0 }' "$1"
}
rough 1500 0.012 0.05 >"$TMP/rougher.cl"
biarcfit -q -e 0.01 --min-length 0.001 -o "$TMP/any.cl" "$TMP/rougher.cl"
any=$(short "$TMP/any.cl")
ok "there would be pieces below 0.02 mm: $any" test "$any" -ge 10
biarcfit -q -e 0.01 -o "$TMP/few.cl" "$TMP/rougher.cl"
few=$(short "$TMP/few.cl")
ok "few of them are: $few" test "$few" -le $((any / 2))

status 2 "no length" bsplfit --min-length -1 "$passes"

done_testing

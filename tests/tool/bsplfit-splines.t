#!/bin/sh
# bsplfit-splines.t - counts of control points, the tolerance by a reader of its own, odd runs,
# refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

passes=$SRC/tests/data/panel_passes.cl

go='function go(x, y, z, i, j, k) { printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, y, z, i, j, k }'
path() { # FILE PROGRAM: what PROGRAM prints by go(x, y, z, i, j, k) is the run
	{
		printf 'PARTNO/T\nUNITS/MM\nMULTAX/ON\nCUTTER/16,8,0,8,0,0,60\n'
		printf '%s CHORD/0.500000\nRAPID\nGOTO/0,0,90,0,0,1\nFEDRAT/MMPM,800\n' "\$\$->"
		awk "$go BEGIN { pi = 3.14159265358979; $2 }"
		printf 'RAPID\nGOTO/0,0,90,0,0,1\nFINI\n'
	} >"$1"
}

poles() { # FILE: all of them
	sed -n 's/^MOVNRB.ON,[0-9]*,[0-9]*,0,\([0-9]*\),.*/\1/p' "$1" | awk '{ n += $1 } END { print n + 0 }'
}
curves() { grep -c '^MOVNRB/ON' "$1"; }
off() { awk -f "$SRC/tests/lib/splines.awk" "$1" "$2"; }
# simple FILE: no knot is there twice but at the ends, so that the curves have no kink inside (cubics:
# curvature without jumps), and each starts where the last one ended
simple() {
	ok "knots stand apart, pieces join" awk '
		/ \$$/ { held = held substr($0, 1, length($0) - 2); next }
		{ line = held $0; held = "" }
		line ~ /^MOVNRB.ON/ { split(line, f, ","); order = f[2]; poles = f[5] }
		line ~ /^MOVNRB.1,/ { split(line, k, ","); for (i = order + 1; i <= poles + 1; i++) if (k[i + 1] <= k[i]) bad = 1 }
		line ~ /^MOVNRB.2,/ { split(line, q, ",")
			for (i = 1; i <= 3; i++) if (here[i] != q[i + 1]) bad = 1 }
		line ~ /^GOTO/ { sub(/.*\//, "", line); split(line, here, ",") }
		END { exit bad }' "$1"
}
spent() { sed -n 's/^.*LEDGER\/bsplfit,//p' "$1" | sort -n | tail -n 1; }

# Dense passes
status 0 "dense passes" bsplfit -e 0.01 -o "$TMP/p.cl" "$passes"
ok "a curve each" test "$(curves "$TMP/p.cl")" -eq 8
below "control points of 2,888 points" "$(poles "$TMP/p.cl")" 90
found=$(off "$passes" "$TMP/p.cl")
below "what was spent" "$(spent "$TMP/p.cl")" 0.01
below "it is not less than what another reader finds" "$found" "$(spent "$TMP/p.cl")"
has "a fixed axis has no head" '^MOVNRB/M3AXIS$' "$TMP/p.cl"
inside='/^MOVNRB/ { m = 1 } !m && !/^GOTO|CONTCT|LEDGER|PASSES/; /^MOVNRB.OFF/ { m = 0 }'
awk "$inside" "$passes" >"$TMP/rest.in"
awk "$inside" "$TMP/p.cl" >"$TMP/rest.out"
same "all but the points is carried through" "$TMP/rest.in" "$TMP/rest.out"

status 0 "a tenth of the tolerance" bsplfit -q -e 0.001 -o "$TMP/fine.cl" "$passes"
below "control points" "$(poles "$TMP/fine.cl")" 125
empty "quiet" "$TMP/err"
for threads in 1 2 7; do
	status 0 "$threads threads" bsplfit -q -e 0.001 -j $threads -o "$TMP/j.cl" "$passes"
	same "the same bytes" "$TMP/fine.cl" "$TMP/j.cl"
done
status 0 "from standard input" sh -c "bsplfit -q -e 0.001 <'$passes' >'$TMP/j.cl'"
same "the same bytes" "$TMP/fine.cl" "$TMP/j.cl"

# As published, and the report
status 0 "as published" bsplfit --paper --table -q -e 0.01 -o "$TMP/paper.cl" "$passes"
cp "$TMP/err" "$TMP/report"
ok "a row for each pass, headings and totals" test "$(wc -l <"$TMP/report")" -eq 10
# shellcheck disable=SC2016
ok "counts are multiples of 5" awk 'NR > 1 && $1 != "all" && $3 % 5 { bad = 1 } END { exit bad }' "$TMP/report"
# shellcheck disable=SC2016
ok "C1 within the tolerance" awk 'NR > 1 && $5 > 0.01 { bad = 1 } END { exit bad }' "$TMP/report"
# shellcheck disable=SC2016
ok "C2 is the root mean square over the root of the count" awk '
	NR > 1 && $1 != "all" { r = $6 * sqrt($2) / $7; if (r < 0.99 || r > 1.01) bad = 1 } END { exit bad }' "$TMP/report"
below "control points as published" "$(poles "$TMP/paper.cl")" 170
status 0 "one combination" bsplfit --params chord --knots average --table -q -o "$TMP/one.cl" "$passes"
ok "it is that one" test "$(grep -c 'chord/average$' "$TMP/err")" -eq 8
for column in points control %fewer C1 C2 rms middle tip ball axis parameters/knots; do
	has "a column: $column" "(^| )$column( |\$)" "$TMP/report"
done
for p in 2 3 4 5; do
	status 0 "degree $p" bsplfit -q --degree $p -o "$TMP/degree.cl" "$passes"
	ok "has order $((p + 1))" test "$(grep -c "^MOVNRB/ON,$((p + 1))," "$TMP/degree.cl")" -eq 8
	below "degree $p, by another reader" "$(off "$passes" "$TMP/degree.cl")" 0.01
done

# What the control points stand for
for p in tip centre contact; do
	status 0 "--track $p" bsplfit -q --track $p -e 0.01 -o "$TMP/$p.cl" "$passes"
	head -20 "$TMP/$p.cl" | grep TRACK >"$TMP/track"
	case $p in
	tip) empty "the head says nothing" "$TMP/track" ;;
	centre) has "the head says so" '^..-> TRACK/CENTER$' "$TMP/track" ;;
	contact) has "the head says so" '^..-> TRACK/CONTACT$' "$TMP/track" ;;
	esac
done
ok "centres and tips alike with a fixed axis" test "$(poles "$TMP/tip.cl")" -eq "$(poles "$TMP/centre.cl")"
status 1 "a program of contact points" ncpost -c fanuc "$TMP/contact.cl"
has "is refused" 'a path of contact points' "$TMP/err"
status 1 "tips from contact points" bsplfit --track tip "$TMP/contact.cl"

# Five axes: head and tip on shared knots
path "$TMP/swing.cl" 'for (s = 0; s <= 1; s += 1 / 256) {
	i = 0.4 * sin(3 * s); j = 0.2 * cos(2 * s); l = sqrt(1 + i * i + j * j)
	go(70 * s, 10 * sin(4 * s), 6 * cos(5 * s), i / l, j / l, 1 / l) }'
status 0 "an axis that swings" bsplfit -v -o "$TMP/out.cl" "$TMP/swing.cl"
has "five axes" '^MOVNRB/5AXIS,LENGTH,100.000000$' "$TMP/out.cl"
has "poles of the head" '^MOVNRB/3,' "$TMP/out.cl"
below "control points" "$(poles "$TMP/out.cl")" 12
below "the tip, by another reader" "$(off "$TMP/swing.cl" "$TMP/out.cl")" 0.01
cp "$TMP/out.cl" "$TMP/swung.cl"
cp "$TMP/err" "$TMP/said"
for p in 2 4 5; do
	status 0 "degree $p" bsplfit -q --degree $p -o "$TMP/out.cl" "$TMP/swing.cl"
	has "has order $((p + 1))" "^MOVNRB.ON,$((p + 1))," "$TMP/out.cl"
	below "the tip, by another reader" "$(off "$TMP/swing.cl" "$TMP/out.cl")" 0.01
done
cp "$TMP/swung.cl" "$TMP/out.cl"
cp "$TMP/said" "$TMP/err"
has "a summary" 'bsplfit: 257 points in 1 runs: 1 splines, [0-9]+ control points' "$TMP/err"
hasnt "the chord error is taken out" CHORD "$TMP/out.cl"
has "the start stays a point" '^GOTO/0.000000,0.000000,6.000000' "$TMP/out.cl"
status 0 "an axis tolerance" bsplfit --axis-tolerance 0.005 -e 0.5 -v -o "$TMP/axis.cl" "$TMP/swing.cl"
# shellcheck disable=SC2016
ok "asks for more control points than 0.5 mm alone" sh -c '
	bsplfit -q -e 0.5 --axis-tolerance 5 <"$1" >"$1.free" && test "$(wc -c <"$2")" -gt "$(wc -c <"$1.free")"' \
	sh "$TMP/swing.cl" "$TMP/axis.cl"

# Odd runs
path "$TMP/line.cl" 'for (k = 0; k <= 50; k++) go(k, k / 2, 3, 0, 0, 1)'
status 0 "a straight line" bsplfit -o "$TMP/out.cl" "$TMP/line.cl"
has "is degree 1 with two poles" '^MOVNRB/ON,2,4,0,2,' "$TMP/out.cl"
path "$TMP/two.cl" 'go(0, 0, 0, 0, 0, 1); go(5, 5, 5, 0, 0, 1)'
status 0 "two points" bsplfit -o "$TMP/out.cl" "$TMP/two.cl"
has "are a line" '^MOVNRB/ON,2,4,0,2,8.660254' "$TMP/out.cl"
path "$TMP/same.cl" 'for (k = 0; k < 5; k++) go(1, 2, 3, 0, 0, 1)'
status 0 "one place" bsplfit -o "$TMP/out.cl" "$TMP/same.cl"
hasnt "has no curve" MOVNRB "$TMP/out.cl"
ok "and its points stay" test "$(grep -c '^GOTO/1.000000,2' "$TMP/out.cl")" -eq 5
path "$TMP/repeat.cl" 'for (k = 0; k <= 600; k++) go(int(k / 3) / 4, 5 * sin(int(k / 3) / 40), 0, 0, 0, 1)'
status 0 "repeated points" bsplfit -o "$TMP/out.cl" "$TMP/repeat.cl"
below "control points" "$(poles "$TMP/out.cl")" 12
below "within" "$(off "$TMP/repeat.cl" "$TMP/out.cl")" 0.01
path "$TMP/corner.cl" 'for (k = 0; k <= 30; k++) go(k, 0, 0, 0, 0, 1); for (k = 1; k <= 30; k++) go(30, k, 0, 0, 0, 1)'
status 0 "a corner" bsplfit -o "$TMP/out.cl" "$TMP/corner.cl"
ok "parts the curve" test "$(curves "$TMP/out.cl")" -eq 2
below "within" "$(off "$TMP/corner.cl" "$TMP/out.cl")" 0.01
simple "$TMP/out.cl"
has "which joins there" '^GOTO/30.000000,0.000000,0.000000' "$TMP/out.cl"
path "$TMP/ring.cl" 'for (k = 0; k <= 360; k++) go(20 * cos(k * pi / 180), 20 * sin(k * pi / 180), 0, 0, 0, 1)'
status 0 "a closed run" bsplfit -o "$TMP/out.cl" "$TMP/ring.cl"
below "control points" "$(poles "$TMP/out.cl")" 14
below "within" "$(off "$TMP/ring.cl" "$TMP/out.cl")" 0.01
simple "$TMP/out.cl"
path "$TMP/turn.cl" 'for (k = 0; k <= 40; k++) go(0, 0, 0, sin(k / 50), 0, cos(k / 50))'
status 0 "an axis that turns in place" bsplfit -o "$TMP/out.cl" "$TMP/turn.cl"
has "arrives" '^GOTO/0.000000,0.000000,0.000000,0.717356' "$TMP/out.cl"
path "$TMP/tiny.cl" 'for (k = 0; k <= 40; k++) go(k / 1e6, (k % 2) / 1e6, 0, 0, 0, 1)'
status 0 "hardly any way at all" bsplfit -o "$TMP/out.cl" "$TMP/tiny.cl"
path "$TMP/noise.cl" 'r = 1 + 7919 * ENVIRON["SEED"]; for (k = 0; k <= 500; k++) {
	r = (r * 16807) % 2147483647; go(k / 10, r / 21474836470, 0, 0, 0, 1) }'
status 0 "noise of ten tolerances" within 60 bsplfit -o "$TMP/out.cl" "$TMP/noise.cl"
below "within" "$(off "$TMP/noise.cl" "$TMP/out.cl")" 0.01
hasnt "noise: only finite numbers" '(nan|inf)' "$TMP/out.cl"
path "$TMP/spiral.cl" 'for (k = 0; k < 6000; k++) { a = k / 32; go((5 + a / 6) * cos(a), (5 + a / 6) * sin(a), 0, 0, 0, 1) }'
status 0 "a spiral of 6,000 points" within 60 bsplfit -o "$TMP/out.cl" "$TMP/spiral.cl"
below "control points" "$(poles "$TMP/out.cl")" 300
below "within" "$(off "$TMP/spiral.cl" "$TMP/out.cl")" 0.01
hasnt "spiral: only finite numbers" '(nan|inf)' "$TMP/out.cl"
simple "$TMP/out.cl"
path "$TMP/waves.cl" 'for (k = 0; k <= 4000; k++) go(k / 20, 3 * sin(k / 10), 0, 0, 0, 1)'
status 0 "sixty-three waves" within 60 bsplfit -o "$TMP/out.cl" "$TMP/waves.cl"
below "control points" "$(poles "$TMP/out.cl")" 180
below "within" "$(off "$TMP/waves.cl" "$TMP/out.cl")" 0.01
simple "$TMP/out.cl"
for f in line two corner ring turn tiny; do
	bsplfit -q "$TMP/$f.cl" >"$TMP/nan.cl"
	hasnt "$f: only finite numbers" '(nan|inf)' "$TMP/nan.cl"
done

# Points 4 mm apart on a circle: the curve follows the circle, not the chords (0.1 mm off)
path "$TMP/sparse.cl" 'for (k = 0; k <= 30; k++) go(20 * cos(k * pi / 16), 20 * sin(k * pi / 16), 0, 0, 0, 1)'
path "$TMP/dense.cl" 'for (k = 0; k <= 3000; k++) go(20 * cos(k * pi / 1600), 20 * sin(k * pi / 1600), 0, 0, 0, 1)'
status 0 "sparse points" bsplfit -o "$TMP/out.cl" "$TMP/sparse.cl"
below "the circle between them" "$(off "$TMP/dense.cl" "$TMP/out.cl")" 0.012

# Manners
head -n 400 "$passes" >"$TMP/half.cl"
status 1 "half of the input" bsplfit -o "$TMP/none.cl" "$TMP/half.cl"
ok "leaves nothing" test ! -e "$TMP/none.cl"
status 1 "no file" bsplfit "$TMP/none.cl"
status 2 "a tolerance of nothing" bsplfit -e 0 "$passes"
status 2 "two files" bsplfit "$passes" "$passes"
status 0 "free knots on request" bsplfit -q --knots free -o "$TMP/free.cl" "$passes"
status 2 "no such knots" bsplfit --knots nosuch "$passes"
status 2 "degree 1" bsplfit --degree 1 "$passes"
status 2 "degree 6" bsplfit --degree 6 "$passes"
if [ -w /dev/full ]; then
	status 1 "a full disk" sh -c "bsplfit -q '$passes' >/dev/full"
else
	skip "a full disk" "no /dev/full"
fi
printf 'PARTNO/T\nUNITS/MM\nGOTO/0,0,0\nGOTO/1,1,1\nFINI\n' >"$TMP/bare.cl"
status 0 "no cutter" bsplfit "$TMP/bare.cl"
has "says what it means" 'no ball nose' "$TMP/err"
status 0 "the tolerance that was assumed" bsplfit -o "$TMP/out.cl" "$passes"
has "is said" '0.01 mm' "$TMP/err"

done_testing

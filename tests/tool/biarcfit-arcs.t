#!/bin/sh
# biarcfit-arcs.t - counts of arcs on dense passes, what is carried through, refusals.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

passes=$SRC/tests/data/panel_passes.cl

arcs() { grep -c '^CIRCLE/' "$1"; }
spent() { sed -n 's/^.*LEDGER\/biarcfit,//p' "$1" | sort -n | tail -n 1; }

# path ITEMS: a small path with these statements
path() {
	printf 'PARTNO/T\nUNITS/MM\nMULTAX/ON\nCUTTER/8.0,4.0,0.0,4.0,0.0,0.0,60.0\n%s\nFINI\n' "$1"
}

status 0 "dense passes within 0.01" biarcfit -e 0.01 -o "$TMP/p10.cl" "$passes"
below "within 3 % of the fewest known, 107, at 0.01" "$(arcs "$TMP/p10.cl")" 110
below "what was spent at 0.01" "$(spent "$TMP/p10.cl")" 0.01
status 0 "dense passes within 0.005" biarcfit -e 0.005 -o "$TMP/p5.cl" "$passes"
below "within 3 % of the fewest known, 134, at 0.005" "$(arcs "$TMP/p5.cl")" 138
below "what was spent at 0.005" "$(spent "$TMP/p5.cl")" 0.005

# one pass of 220 mm: more arcs than are moved all together
path "$(awk 'BEGIN { for (i = 0; i <= 880; i++) { x = i / 4 - 110
	printf "GOTO/%.6f,%.6f,%.6f,0,0,1\n", x, 2 * cos(x / 25),
		2.5 * sin(x / 5.25 + 0.3 * sin(x / 17)) + 1.5 * sin(x / 60) } }')" >"$TMP/long.cl"
status 0 "a long pass" biarcfit -e 0.01 -o "$TMP/long.out" "$TMP/long.cl"
below "within 3 % of the fewest known, 46" "$(arcs "$TMP/long.out")" 47

grep -v 'CONTCT\|^GOTO\|LEDGER' "$passes" >"$TMP/rest.in"
grep -v 'CONTCT\|^GOTO\|^CIRCLE\|LEDGER\|PASSES' "$TMP/p10.cl" >"$TMP/rest.out"
same "all but the points is carried through" "$TMP/rest.in" "$TMP/rest.out"

status 0 "a biarc for each interval" biarcfit --paper -o "$TMP/paper.cl" "$passes"
below "2880 intervals, two arcs each" 5700 "$(arcs "$TMP/paper.cl")"
has "the types are counted" 'biarcs of C type, [0-9]+ of S type' "$TMP/err"

status 0 "the same again" biarcfit -q -o "$TMP/again.cl" "$passes"
same "the same bytes" "$TMP/p10.cl" "$TMP/again.cl"
empty "quiet" "$TMP/err"

status 0 "chords for arcs" biarcfit -e 0.01 --linear-arcs -o "$TMP/chords.cl" "$passes"
hasnt "no CIRCLE but in comments" '^CIRCLE' "$TMP/chords.cl"
has "arcs as comments" '^\$\$ CIRCLE/' "$TMP/chords.cl"
below "chords within the tolerance" "$(spent "$TMP/chords.cl")" 0.01
status 0 "chords read as points fit again" biarcfit -e 0.02 -o "$TMP/twice.cl" "$TMP/chords.cl"

path 'GOTO/0,0,0,0,0,1
GOTO/1,0,0,0,0,1
GOTO/2,0,0,0,0,1
GOTO/7,0,0,0,0,1
GOTO/7,5,0,0,0,1
GOTO/7,9,0,0,0,1' >"$TMP/corner.cl"
status 0 "straight pieces and a corner" biarcfit -v -e 0.01 -o "$TMP/out.cl" "$TMP/corner.cl"
hasnt "no arcs on straight lines" CIRCLE "$TMP/out.cl"
has "the corner stays" '^GOTO/7.000000,0.000000,0.000000' "$TMP/out.cl"
below "one line each" "$(grep -c GOTO "$TMP/out.cl")" 3

path 'GOTO/0,0,0,0,0,1
GOTO/0,0,0,0,0.6,0.8
GOTO/0,0,0,0,1,0' >"$TMP/pivot.cl"
status 0 "an axis that turns in place" biarcfit -o "$TMP/out.cl" "$TMP/pivot.cl"
has "it arrives" '^GOTO/0.000000,0.000000,0.000000,0.000000000,1.000000000,0.000000000' "$TMP/out.cl"

path 'GOTO/1,2,3,0,0,1
GOTO/4,2,3,0,0,1' >"$TMP/two.cl"
status 0 "two points" biarcfit -o "$TMP/out.cl" "$TMP/two.cl"
has "are a line" '^GOTO/4.000000,2.000000,3.000000' "$TMP/out.cl"

awk 'BEGIN { print "PARTNO/RING\nUNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60"
	for (i = 0; i <= 36; i++) { a = i * 0.17453292519943295
		printf "GOTO/%.6f,%.6f,0,0,0,1\n", 10 * cos(a), 10 * sin(a) }
	print "FINI" }' >"$TMP/ring.cl"
status 0 "a closed ring" biarcfit -e 0.01 -o "$TMP/out.cl" "$TMP/ring.cl"
below "is a few arcs" "$(arcs "$TMP/out.cl")" 4
has "and closes" '^GOTO/10.000000,(-0.00000[0-9]|0.000000),0.000000' "$TMP/out.cl"

head -n 400 "$passes" >"$TMP/half.cl"
status 1 "half of the input" biarcfit -o "$TMP/none.cl" "$TMP/half.cl"
ok "leaves nothing" test ! -e "$TMP/none.cl"
status 2 "a tolerance of nothing" biarcfit -e 0 "$passes"
status 2 "two files" biarcfit "$passes" "$passes"
{ printf 'PARTNO/T\nUNITS/MM\n'; echo "\$\$-> TRACK/CONTACT"; printf 'GOTO/0,0,0,0,0,1\nGOTO/1,0,0,0,0,1\nFINI\n'; } >"$TMP/contact.cl"
status 1 "a path of contact points" biarcfit "$TMP/contact.cl"
has "says so" 'contact points' "$TMP/err"

head -n 200 "$passes" >"$TMP/points.cl"
echo FINI >>"$TMP/points.cl"
for fit in biarcfit bsplfit; do
	$fit -q -o "$TMP/fitted.cl" "$TMP/points.cl"
	status 1 "curves of $fit have no points to tilt at" \
		biarcfit --tilt 30 -o "$TMP/tilted.cl" "$TMP/fitted.cl"
	has "$fit: says so" 'fitted.cl:[0-9]+: found an arc or a spline in a cut' "$TMP/err"
	ok "$fit: nothing is written" test ! -e "$TMP/tilted.cl"
done

done_testing

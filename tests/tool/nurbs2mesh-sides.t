#!/bin/sh
# nurbs2mesh-sides.t - which side of its loops a face is on, where curves in space alone bound it: on
# spheres and pipes; closed skins of loose faces within each other; trimming that leaves nothing.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

# told DESC AREA VOLUME FILE [OPTION]: what -v tells of all of it, within 1e-6; - for no volume
told() {
	nurbs2mesh -v -e 0.2 ${5:+"$5"} "$4" 2>"$TMP/report" >/dev/null
	ok "$1: is read" test $? -eq 0
	sed -n 's/.* area \([^ ]*\) mm2\(, volume \([^ ]*\) mm3\)\{0,1\}.*/\1 \3/p' "$TMP/report" | tail -1 >"$TMP/told"
	read -r area volume <"$TMP/told"
	within=0.000001
	part "$1: area" "$area" "$2"
	[ "$3" = - ] || part "$1: volume" "$volume" "$3"
}

# A sphere of radius 10 as what an arc turns, and arcs and circles on it: q1 to q4 are the quarters
# of a circle about x at 8, s1 and s2 lead from it to the poles; n is a circle about z at 6, to
# which t1 and t2 lead.
ball() {
	cat <<'END'
axis 110 0 0,0,-10,0,0,10
lie 124 0 1,0,0,0,0,0,-1,0,0,1,0,0
tox 124 0 0,0,1,0,1,0,0,0,0,1,0,0
arc 100 0@lie 0,0,0,0,-10,0,10
ball 120 0 {axis},{arc},0,6.28319
c1 100 0@tox 8,0,0,6,0,6,0
c2 100 0@tox -8,0,0,6,0,6,0
q1 100 0@tox 8,0,0,0,-6,6,0
q2 100 0@tox 8,0,0,6,0,0,6
q3 100 0@tox 8,0,0,0,6,-6,0
q4 100 0@tox 8,0,0,-6,0,0,-6
s1 100 0@lie 0,0,0,8,6,0,10
s2 100 0@lie 0,0,0,0,-10,8,-6
n 100 0 6,0,0,8,0,8,0
t1 100 0@lie 0,0,0,8,6,0,10
t2 100 0@lie 0,0,0,8,-6,8,6
END
}

{ ball && printf '%s\n' 'l1 142 0 0,{ball},0,{c1},2' 'l2 142 0 0,{ball},0,{c2},2' 'f 144 0 {ball},1,1,{l1},{l2}'; } | iges zone
told "a sphere between two circles about x" "$(calc '2 * p * 10 * 16')" - "$TMP/zone.igs"

{ ball && printf '%s\n' 'k 102 0 8,{s1},{q2},{q1},{s2},{s2},{q4},{q3},{s1}' 'l 142 0 0,{ball},0,{k},2' 'f 144 0 {ball},1,0,{l}'; } | iges slits
told "a sphere but for a cap, with slits to its poles" "$(calc '4 * p * 100 - 2 * p * 10 * 2')" - "$TMP/slits.igs"

{ ball && printf '%s\n' 'k 102 0 3,{t1},{n},{t1}' 'l 142 0 0,{ball},0,{k},2' 'f 144 0 {ball},1,0,{l}'; } | iges north
told "a cap with a slit to its pole" "$(calc '2 * p * 10 * 4')" - "$TMP/north.igs"

{ ball && printf '%s\n' 'k 102 0 5,{s2},{t2},{n},{t2},{s2}' 'l 142 0 0,{ball},0,{k},2' 'f 144 0 {ball},1,0,{l}'; } | iges south
told "and what it leaves, with a slit to the other" "$(calc '2 * p * 10 * 16')" - "$TMP/south.igs"

{ ball && printf '%s\n' 'k 102 0 2,{arc},{arc}' 'l 142 0 0,{ball},0,{k},2' 'f 144 0 {ball},1,0,{l}'; } | iges seam
told "a sphere bounded by its seam" "$(calc '4 * p * 100')" "$(calc '4 * p * 1000 / 3')" "$TMP/seam.igs"

# One loop, and no word of its side.
{ ball && printf '%s\n' 'l 142 0 0,{ball},0,{c1},2' 'f 144 0 {ball},1,0,{l}'; } | iges cap
status 3 "a sphere and one circle across its seam: its side is not told" \
	nurbs2mesh -e 0.2 -o "$TMP/x.ply" "$TMP/cap.igs"
told "what is taken" "$(calc '2 * p * 10 * 2')" - "$TMP/cap.igs" --partial
has "and it is told what was taken" 'does not tell which side .* within the loop' "$TMP/report"
{ ball && printf '%s\n' 'l 142 0 0,{ball},0,{n},2' 'f 144 0 {ball},1,0,{l}'; } | iges polar
status 3 "a sphere and one circle about its axis: its side is not told" \
	nurbs2mesh -e 0.2 -o "$TMP/x.ply" "$TMP/polar.igs"
told "what is taken" "$(calc '2 * p * 10 * 4')" - "$TMP/polar.igs" --partial
has "and it is told what was taken" 'does not tell which side .* on the left of the loop' "$TMP/report"
{ ball && printf '%s\n' 'l 142 0 0,{ball},0,{c2},2' 'f 144 0 {ball},1,0,{l}'; } | iges inner
told "a sphere and one circle beside its seam" "$(calc '2 * p * 10 * 2')" - "$TMP/inner.igs"
hasnt "of which the file tells the side" 'does not tell which side' "$TMP/report"

# A torus of 20 and 6 with a hole of half a radian to both sides of its seam, at 1.5 to 3 of the
# tube: its curves, of which those with an x run back.
ring() {
	awk 'function row(a, b, c, d, e, f, g, h) { printf "%s 124 0 %.17g,0,%.17g,%.17g,%.17g,0,%.17g,%.17g,0,%d,0,0\n", a, b, c, d, e, f, g, h }
	function plane(n, p) { row("m" n, cos(p), sin(p), 20 * cos(p), sin(p), -cos(p), 20 * sin(p), 1)
		row("xm" n, cos(p), -sin(p), 20 * cos(p), sin(p), cos(p), 20 * sin(p), -1) }
	function arc(n, m, z, r, a, b) {
		printf "%s 100 0%s %.17g,0,0,%.17g,%.17g,%.17g,%.17g\n", n, m ? "@m" m : "", z, r * cos(a), r * sin(a), r * cos(b), r * sin(b)
		printf "x%s 100 0@xm%s %.17g,0,0,%.17g,%.17g,%.17g,%.17g\n", n, m, -z, r * cos(b), -r * sin(b), r * cos(a), -r * sin(a) }
	function turn(n, t, a, b) { arc(n, "", 6 * sin(t), 20 + 6 * cos(t), a, b) }
	BEGIN { p = atan2(0, -1)
		plane("z", 0); plane("a", -0.5); plane("b", 0.5)
		print "xm 124 0 1,0,0,0,0,-1,0,0,0,0,-1,0"
		arc("g", "z", 0, 6, 0, 2 * p); turn("r", 0, 0, 2 * p)
		arc("g1", "z", 0, 6, 0, 1.5); arc("g2", "z", 0, 6, 3, 2 * p)
		arc("a", "a", 0, 6, 1.5, 3); arc("b", "b", 0, 6, 1.5, 3)
		turn("l", 1.5, -0.5, 0.5); turn("l1", 1.5, -0.5, 0); turn("l2", 1.5, 0, 0.5)
		turn("h", 3, -0.5, 0.5); turn("h1", 3, -0.5, 0); turn("h2", 3, 0, 0.5) }'
	cat <<'END'
axis 110 0 0,0,-5,0,0,9
s 120 0 {axis},{g},0.,6.283185307179586
hole 102 0 4,{l},{b},{xh},{xa}
lh 142 0 0,{s},0,{hole},2
END
}
# wired DESC CURVES: the torus bounded by its seams and its hole in one loop
wired() {
	{ ring && printf '%s\n' "k 102 0 12,$2" 'f 144 0 {s},1,0,{lk}' 'lk 142 0 0,{s},0,{k},2'; } | iges wired
	told "a torus with a hole across its seam, $1" "$left" - "$TMP/wired.igs"
}
hole=$(calc '6 * (20 * 1.5 + 6 * (sin(3) - sin(1.5)))')
left=$(calc "4 * p * p * 120 - $hole")
wired "in one loop" '{r},{g1},{xl1},{a},{h1},{g2},{xr},{xg2},{h2},{xb},{xl2},{xg1}'
wired "its seams alike" '{g1},{xl1},{a},{h1},{g2},{r},{xg2},{h2},{xb},{xl2},{xg1},{r}'
wired "curves the other way" '{r},{g1},{l2},{b},{h2},{g2},{r},{g2},{h1},{a},{l1},{g1}'
{ ring && echo 'f 144 0 {s},0,1,0,{lh}'; } | iges holed
told "a torus but for a hole across its seam" "$left" - "$TMP/holed.igs"
# An outer loop that is said to be there, and none is named: the border of the surface.
{ ring && echo 'f 144 0 {s},1,1,0,{lh}'; } | iges promised
told "a torus whose outer loop is not named, but for a hole" "$left" - "$TMP/promised.igs"
has "it is told that none is named" 'flag 1 for an outer loop, and none is named' "$TMP/report"
{ ring && echo 'f 144 0 {s},1,0,{lh}'; } | iges lone
status 3 "a torus and one loop, of which the file does not tell the side" nurbs2mesh -v -e 0.2 -o "$TMP/x.ply" "$TMP/lone.igs"
status 0 "and accepted with --partial" nurbs2mesh -v -e 0.2 --partial -o "$TMP/x.ply" "$TMP/lone.igs"
{ ring && printf '%s\n' 'k 102 0 12,{r},{g1},{l2},{b},{xh2},{g2},{xr},{xg2},{xh1},{xa},{l1},{xg1}' 'f 144 0 {s},1,0,{lk}' 'lk 142 0 0,{s},0,{k},2'; } | iges twice
status 3 "a loop that bounds more than all of a torus" nurbs2mesh -e 0.2 -o "$TMP/x.ply" "$TMP/twice.igs"

# The two rims of a pipe, written the same way round, and its seam.
cat <<'END' | iges pipe
line 110 0 8,0,0,8,0,20
axis 110 0 0,0,0,0,0,1
pipe 120 0 {axis},{line},0,6.2831853
low 100 0 0,0,0,8,0,8,0
high 100 0 20,0,0,8,0,8,0
k 102 0 4,{low},{line},{high},{line}
l 142 0 0,{pipe},0,{k},2
f 144 0 {pipe},1,0,{l}
END
told "a pipe whose rims run alike" "$(calc '2 * p * 8 * 20')" - "$TMP/pipe.igs"

# Loose faces: a ball in a hollow in a ball.
{ ball && cat <<'END'
a6 100 0@lie 0,0,0,0,-6,0,6
a3 100 0@lie 0,0,0,0,-3,0,3
hollow 120 0 {axis},{a6},0,6.2831853
core 120 0 {axis},{a3},0,6.2831853
END
} | iges nested
told "skins within each other" "$(calc '4 * p * (100 + 36 + 9)')" "$(calc '4 / 3 * p * (1000 - 216 + 27)')" "$TMP/nested.igs"
has "it is told that one is a void" '1 closed skins of loose faces .* voids' "$TMP/report"

# A face of which its trimming leaves nothing, beside a ball.
{ ball && cat <<'END'
plane 108 0 0,0,1,20,0,0,0,0,0
g 110 0 0,0,20,5,0,20
k 102 0 2,{g},{g}
l 142 0 0,{plane},0,{k},2
f 144 0 {plane},1,0,{l}
END
} | iges nothing
status 3 "a face of which nothing is left is told" nurbs2mesh -e 0.2 -o "$TMP/x.ply" "$TMP/nothing.igs"
status 0 "and accepted with --partial" nurbs2mesh -e 0.2 --partial -o "$TMP/x.ply" "$TMP/nothing.igs"

done_testing

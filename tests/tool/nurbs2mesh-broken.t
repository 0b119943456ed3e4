#!/bin/sh
# nurbs2mesh-broken.t - more than twenty broken files of each kind (IGES, STEP, NURBS text): each is
# refused with one line that has the line of the file, exit status 1, and nothing is written.
#
# shellcheck disable=SC2218 # text() edits another file in each part
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

broken() { # FILE WORDS DESC
	nurbs2mesh -n 2 "$TMP/$1" >"$TMP/out" 2>"$TMP/err"
	code=$?
	if [ $code -ne 1 ] || [ -s "$TMP/out" ] || [ "$(wc -l <"$TMP/err")" -ne 1 ] ||
		! grep -Eq "$1:[0-9]+: .*$2" "$TMP/err"; then
		sed 's/^/# /' "$TMP/err"
		echo "# exit status $code"
		ok "$3" false
	else
		ok "$3" true
	fi
}

# ---- NURBS text

text() { # SED WORDS DESC: the saddle, edited
	sed "$1" "$SRC/samples/saddle.nurbs" >"$TMP/bad.nurbs"
	broken bad.nurbs "$2" "text: $3"
}
text '1s/1/2/' expected "another version"
text '2s/mm/ell/' expected "a unit that there is not"
text '4s/2 2/2/' expected "one degree"
text '4s/2 2/2 0/' expected "a degree of nothing"
text '4s/2 2/2 99/' expected "a degree too high"
text '5s/3 3/3 -3/' expected "a negative count of poles"
text '5s/3 3/3 2/' expected "fewer poles than the degree needs"
text '5s/3 3/99999999 99999999/' expected "more poles than there is memory for"
text '6s/0 0 0 1 1 1/0 0 0 1 1/' expected "a knot too few"
text '6s/0 0 0 1 1 1/0 0 0 1 1 1 1/' expected "a knot too many"
text '6s/0 0 0 1 1 1/1 1 1 0 0 0/' "below the one before" "knots that fall"
text '6s/0 0 0 1 1 1/0 0 0 0 0 0/' expected "knots that are all one"
text '6s/0 0 0 1/0 0 0 nan/' expected "a knot that is no number"
text '9s/12/1e999/' expected "a coordinate beyond all bounds"
text '9s/12/twelve/' expected "a word for a number"
text '9s/40 0 4/40 0/' expected "a coordinate too few"
text '11s/$/ 1 2 3/' expected "a pole too many"
text '13s/0 0  1 0  1 1  0 1/0 0  1 0  1/' expected "half a corner"
text '13s/0 0  1 0  1 1  0 1/0 0  1 0/' expected "a loop of two corners"
text '16s/end/ende/' expected "an unknown word"
text '8s/points/holes/' expected "no points"
text '7d' expected "no knots in v"

# ---- IGES

cat <<'END' | iges sound
plane 108 0 0,0,2,10,0,0,0,5,1
c 126 0 2,2,0,0,0,0,0,0,0,1,1,1,1,1,1,0,0,5,5,-6,5,10,0,5,0,1,0,0,1
l 106 12 2,3,10,0,5,5,10,5,0,0,5
outer 102 0 2,{c},{l}
out 142 0 0,{plane},0,{outer},2
face 144 0 {plane},1,0,{out}
axis 110 0 0,0,-5,0,0,9
line 110 0 10,0,0,10,0,20
turned 120 0 {axis},{line},0.,1.57
END
status 0 "the sound file is read" nurbs2mesh -n 2 "$TMP/sound.igs"
text() { # SED WORDS DESC: the file above, edited
	sed "$1" "$TMP/sound.igs" >"$TMP/bad.igs"
	broken bad.igs "$2" "IGES: $3"
}
text '3s/S  /X  /;3s/D  /X  /;3s/G  /X  /' expected "a section letter that there is not"
text '$d' "no surface|expected|cut short" "no T section"
text '/^.\{72\}P[0 ]*5$/,$d' "no T section .* cut short" "the second half missing"
text '5d' "sequence number" "a directory line missing"
text '4s/^\(.\{48\}\).\{8\}/\1     -99/' "a transformation, expected an entity 124" "a transformation that there is not"
text '2s/5Hmodel/6Hmodel/' "count of characters" "a count of characters too large"
text '2s/,2,2HMM/,2,3HMM/;3s/,2,2HMM/,2,3HMM/' "expected" "a unit's count too large"
text '2s/15,5Hmodel,1.,2/15,5Hmodel,0.,2/' "scale" "a scale of nothing"
text '2s/15,5Hmodel,1.,2/15,5Hmodel,1.,0/' "unit" "a unit that there is not"
text 's/^120,/121,/' "expected" "another type in the parameters"
text 's/^108,0/108,x/' "expected a number" "a word for a number"
text 's/^126,2,2/126,9,2/' "expected" "more poles than numbers"
text 's/^126,2,2/126,-2,2/' "expected" "a negative count"
text 's/^126,2,2/126,2,88/' "expected" "a degree too high"
text 's/^126,2,2,0,0,0,0,0,0,0,1,1,1/126,2,2,0,0,0,0,1,1,1,0,0,0/' "126" "knots that fall"
text 's/^126,2,2,0,0,0,0,0,0,0,1,1,1,1,1,1/126,2,2,0,0,0,0,0,0,0,1,1,1,1,0,1/' "weight" "a weight of nothing"
text 's/^106,2,3/106,2,300/' "expected" "more points than numbers"
text 's/^106,2,3/106,7,3/' "kind of points" "a kind of points that there is not"
text 's/^102,2,3,\(.*\);  /102,2,999,\1;/' "pointer to directory entry 999" "a pointer to nothing"
text 's/^102,2,3,/102,2,7,/' "without end" "a curve that holds itself"
text 's/^142,0,1,0,7\(.*\); /142,0,1,0,70\1;/' "pointer to directory entry 70" "a loop of nothing"
text 's/^144,1,1,0/144,1,1,9/' "expected" "holes that are not there"
text 's/^120,13,15,0\.,1\.57/120,13,15,1.,0.57/' "angles" "angles that fall"
text 's/^110,0,0,-5,0,0,9/110,0,0,-5,0,0,-5/;s/^110,0,0,-5,0,0,-5;./110,0,0,-5,0,0,-5;/' "axis without length" "an axis without length"
text '/^ *120 /s/^\( *120\) *[0-9]*/\1     999/' "expected" "a pointer beyond the parameters"
text 's/;  /   /' "expected|cut short" "parameters without an end"
text 's/^108,0,0,2/108,0,0,0/' "a normal of no length" "a plane without a normal"
text 's/^102,2,3,/102,2,1,/' "expected a curve" "a surface for a curve"
text 's/^120,13,15/120,13,1 /' "expected a curve" "a surface for a profile"
text 's/^144,1,1,0,9; /144,11,1,0,9;/' "expected a surface" "a face on itself"
text 's/^144,1,1,0/144,7,1,0/' "on entity 7 of type 102, expected a surface" "a face on a curve"
{ cylinder_shell && echo 'solid 186 0 {shell},1,0'; } | iges sound
status 0 "a sound solid is read" nurbs2mesh -n 2 "$TMP/sound.igs"
text 's/^504,3,/504,1,/' "1 as count of edges, expected" "an edge beyond the list"
text 's/^186,[0-9]*,/186,37,/' "expected a shell" "a solid bounded by itself"

# ---- STEP

step() {
	name=$1
	{ cat; echo "REP ADVANCED_BREP_SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})"; } |
		awk -f "$SRC/tests/lib/step.awk" >"$TMP/$name.step"
}
cat <<'END' | step sound
v1 VERTEX_POINT('',{p 10 0 5})
c1 CIRCLE('',{a 0,0,5 0,0,1 1,0,0},10.)
e1 EDGE_CURVE('',{v1},{v1},{c1},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
l1 EDGE_LOOP('',({o1}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
s1 PLANE('',{a 0,0,5 0,0,1 1,0,0})
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
q1 POLY_LOOP('',({p 0 0 9},{p 10 0 9},{p 10 8 9},{p 0 8 9}))
b2 FACE_OUTER_BOUND('',{q1},.T.)
s2 B_SPLINE_SURFACE_WITH_KNOTS('',1,1,(({p 0 0 9},{p 0 8 9}),({p 10 0 9},{p 10 8 9})),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)
f2 ADVANCED_FACE('',({b2}),{s2},.T.)
open OPEN_SHELL('',({f1},{f2}))
SOLID SHELL_BASED_SURFACE_MODEL('',({open}))
END
status 0 "the sound file is read" nurbs2mesh -n 2 "$TMP/sound.step"
text() { # SED WORDS DESC: the file above, edited
	sed "$1" "$TMP/sound.step" >"$TMP/bad.step"
	broken bad.step "$2" "STEP: $3"
}
text '1s/ISO/ISI/' "expected one of them" "another first line"
text '1,/^#/{/^#/!d;}' "expected" "no header"
text '/^ENDSEC/,$d' "cut short" "no data"
text '$d' "cut short" "no end"
text 's/^HEADER;//' "HEADER" "a header without its word"
text 's/^DATA;/DATA; DATA;/' "ENDSEC" "data within data"
text "s/ADVANCED_FACE('',([^)]*)/ADVANCED_FACE('',7/" "list of bounds" "a number for a face's bounds"
text 's/;$//' "expected|cut short" "no semicolons"
text '10s/=/:/' "expected" "no equals sign"
text "12s/''/'/" "cut short|expected" "a text without its end"
text 's/,10\.)/,1.0.0)/' "expected a number" "a number that is none"
text 's/,10\.)/,-10.)/' "radius" "a negative radius"
text 's/,10\.)/,$)/' "no number" "no radius"
text 's/,10\.)/,1E99)/' "too large" "a radius beyond all bounds"
text 's/(2,2),(2,2)/(2,2),(2,3)/' "multiplicities" "a knot too many"
text 's/(2,2),(2,2)/(2,2),(2,1999999999)/' "number|multiplicities" "a billion knots"
text 's/(0\.,1\.),(0\.,1\.)/(1.,0.),(0.,1.)/' "below the one before" "knots that fall"
text "s/KNOTS('',1,1/KNOTS('',1,0/" "degree" "a degree of nothing"
text "s/KNOTS('',1,1/KNOTS('',9,9/" "degree" "a degree too high"
text "s/PLANE('',#[0-9]*/PLANE('',#77777/" "that there is" "a plane without its place"
text "s/PLANE('',#[0-9]*/PLANE('',''/" "no reference" "a text for a place"
text "s/EDGE_LOOP('',(#\([0-9]*\)))/EDGE_LOOP('',(#99999))/" "that there is" "an edge that there is not"
text "s/SHELL_BASED_SURFACE_MODEL('',(#[0-9]*))/SHELL_BASED_SURFACE_MODEL('',(#14,#14,#14))/;s/^#14=.*/#14=OPEN_SHELL('',(#14));/" \
	"without end" "a shell of itself"
text "20s/=.*/=TRIMMED_CURVE((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1))))))))))))));/" \
	"deep|expected" "lists within lists"
text '15s/#[0-9]*=/#0=/' "instance number" "instance number 0"
text '15s/#[0-9]*=/#99999999999999999999=/' "instance number" "an instance number beyond all bounds"
text '15s/^/\/* /' "comment" "a comment without its end"
text "s/\(EDGE_CURVE.*\)\.T\./\1.X./" "neither .T. nor .F." "an edge's sense that there is not"
text "s/\(ORIENTED_EDGE.*\)\.T\./\1\$/" "neither .T. nor .F." "an edge without an orientation"
text "s/\(FACE_OUTER_BOUND.*\),\.T\./\1/" "neither .T. nor .F." "a bound without an orientation"
text "s/\(ADVANCED_FACE.*\)\.T\./\1.U./" "neither .T. nor .F." "a face's sense that there is not"
text "s/DIRECTION('',(0,0,1))/DIRECTION('',(0,0,0))/" "an axis of no length" "an axis of no length"
text "s/OPEN_SHELL('',([^)]*))/OPEN_SHELL('',())/" "without faces" "a shell without faces"
text "s/OPEN_SHELL('',([^)]*))/OPEN_SHELL('',('a'))/" "no face where one belongs" "a text for a face"
text "s/OPEN_SHELL(/OPEN_SHOAL(/" "no face of a solid" "no shell"
text '/^#/d' "no instances" "no instances"
text "s/\\(ADVANCED_FACE('',(#[0-9]*),\\)#[0-9]*/\\1#1/" "which is a .* expected a surface" "a face on a point"
text 's/\.METRE\./.YARD./' "expected some of .METRE." "a unit that there is not"
text 's/\.MILLI\.,\.METRE\./.MILLY.,.METRE./' "expected some of .METRE." "a prefix that there is not"
sed "s/OPEN_SHELL('',(/&#1,/" "$TMP/sound.step" >"$TMP/more.step"
nurbs2mesh -n 2 "$TMP/more.step" >/dev/null 2>"$TMP/told"
ok "STEP: a shell that holds something else" test $? -eq 3
has "it is named" "1 surface of [A-Z_]+ left out, the first is entity 1" "$TMP/told"
sed 's/LENGTH_UNIT/UNIT_OF_LENGTH/' "$TMP/sound.step" >"$TMP/unit.step"
nurbs2mesh -n 2 "$TMP/unit.step" >/dev/null 2>"$TMP/err"
has "STEP: a unit that is not stated is told" "no unit of length is stated" "$TMP/err"

# Curves of curves without end.
cat <<'END' | step curves
t1 TRIMMED_CURVE('',{t2},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.)
t2 COMPOSITE_CURVE('',({g}),.F.)
g COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{t1})
v1 VERTEX_POINT('',{p 10 0 5})
v2 VERTEX_POINT('',{p 10 9 5})
e1 EDGE_CURVE('',{v1},{v2},{t2},.T.)
o1 ORIENTED_EDGE('',*,*,{e1},.T.)
l1 EDGE_LOOP('',({o1}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
s1 OFFSET_SURFACE('',{s1},1.,.F.)
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
open OPEN_SHELL('',({f1}))
SOLID SHELL_BASED_SURFACE_MODEL('',({open}))
END
nurbs2mesh -n 2 "$TMP/curves.step" >"$TMP/out" 2>"$TMP/err"
ok "STEP: curves of curves of themselves end" test $? -ne 0
sed 's/{t2},.T.)/{t2},.T.)/' "$TMP/curves.step" | sed 's/TRIMMED_CURVE(\(.*\)/LINE(\1/' >"$TMP/surfaces.step"
nurbs2mesh -n 2 "$TMP/surfaces.step" >"$TMP/out" 2>"$TMP/err"
ok "STEP: a surface that is its own offset ends" test $? -ne 0

done_testing

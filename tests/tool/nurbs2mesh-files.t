#!/bin/sh
# nurbs2mesh-files.t - what CAD systems write around their models in STEP: a picture of the part that maps
# its shape, two representations of one shape, complex instances of curves, comments before the start,
# files without a face that is read.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/model.sh"

dprism 10 -6 3 >"$TMP/prism"
read -r exact_a exact_v <<END
$(awk 'BEGIN { p = atan2(0, -1); a = atan2(8, 6); s = 100 * (p - a) + 48; printf "%.9f %.9f\n", 2 * s + 3 * (20 * (p - a) + 16), 3 * s }')
END

# A drawing that shows the shape: the shape is no part of another one by that.
{
	cat "$TMP/prism"
	cat <<'END'
a0 AXIS2_PLACEMENT_3D('',{p 0 0 0},{d 0 0 1},{d 1 0 0})
map REPRESENTATION_MAP({a0},{REP})
item MAPPED_ITEM('',{map},{a0})
draw DRAUGHTING_MODEL('',({item}),{CONTEXT})
END
} | step drawing
model "a drawing maps the shape" "$exact_a" "$exact_v" -e 0.0008 "$TMP/drawing.step"
sed 's/DRAUGHTING_MODEL/MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION/' "$TMP/drawing.step" >"$TMP/picture.step"
model "so does a presentation" "$exact_a" "$exact_v" -e 0.0008 "$TMP/picture.step"

{
	cat "$TMP/prism"
	echo "again SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})"
} | step twice
model "two representations of one solid" "$exact_a" "$exact_v" -e 0.0008 "$TMP/twice.step"

{
	printf '/* written by\n   hand */\n'
	cat "$TMP/drawing.step"
} >"$TMP/comment.step"
model "a comment before the start" "$exact_a" "$exact_v" -e 0.0008 "$TMP/comment.step"

# A set without faces in two representations; the sides of the surface are complex instances, in space
# and in its parameters.
cat <<'END' | step complex
s (BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,(({p 0 0 0},{p 0 8 0}),({p 10 0 0},{p 10 8 0})),.UNSPECIFIED.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((2,2),(2,2),(0.,10.),(0.,8.),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')SURFACE())
b CURVE_BOUNDED_SURFACE('',{s},({o}),.F.)
o (BOUNDARY_CURVE()BOUNDED_CURVE()COMPOSITE_CURVE(({s1},{s2},{s3},{s4}),.F.)COMPOSITE_CURVE_ON_SURFACE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()OUTER_BOUNDARY_CURVE()REPRESENTATION_ITEM(''))
s1 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{c1})
s2 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{c2})
s3 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{c3})
s4 COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{c4})
c1 (BOUNDED_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')SURFACE_CURVE({t1},({q1}),.PCURVE_S1.))
t1 TRIMMED_CURVE('',{l1},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.UNSPECIFIED.)
l1 LINE('',{p 1 1 0},{v1})
v1 VECTOR('',{d 1 0 0},8.)
q1 PCURVE('',{s},{r1})
r1 DEFINITIONAL_REPRESENTATION('',({x1}),{CONTEXT})
x1 POLYLINE('',({y1},{y2}))
y1 CARTESIAN_POINT('',(1.,1.))
y2 CARTESIAN_POINT('',(9.,1.))
c2 (BOUNDED_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()POLYLINE(({p 9 1 0},{p 9 7 0}))REPRESENTATION_ITEM(''))
c3 (BOUNDED_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')TRIMMED_CURVE({l3},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.UNSPECIFIED.))
l3 LINE('',{p 9 7 0},{v3})
v3 VECTOR('',{d -1 0 0},8.)
c4 (BOUNDED_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()PCURVE({s},{r4})REPRESENTATION_ITEM(''))
r4 (DEFINITIONAL_REPRESENTATION()PARAMETRIC_CURVE()REPRESENTATION('',({x4}),{CONTEXT}))
x4 POLYLINE('',({y3},{y4}))
y3 CARTESIAN_POINT('',(1.,7.))
y4 CARTESIAN_POINT('',(1.,1.))
SOLID GEOMETRIC_SET('',({b}))
again SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})
END
model "complex instances, in two representations" 48 - -e 0.001 "$TMP/complex.step"

echo "SOLID TESSELLATED_SOLID('',({SOLID}),$)" | step facets
status 1 "only what is not read" nurbs2mesh --partial -e 0.1 "$TMP/facets.step"
has "is an error" "facets.step:[0-9]+: no face of a solid or a shell that is read" "$TMP/err"

done_testing

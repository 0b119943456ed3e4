/*
 * step_model: surfaces and curves of each kind lie where their equations say, in the file's units;
 * components are where the product structure has them; what has no end is refused.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/surfaces.h"
#include "math/elementary.h"
#include "scratch.h"

/* #1 is the context, #5 the axes at the origin, #6 those at 1,2,3 with z along y and x along z. */
static const char *const HEAD =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
    "#1=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#7,#8))"
    "REPRESENTATION_CONTEXT('',''));\n"
    "#2=CARTESIAN_POINT('',(0.,0.,0.));\n#3=DIRECTION('',(0.,0.,1.));\n"
    "#4=DIRECTION('',(1.,0.,0.));\n#5=AXIS2_PLACEMENT_3D('',#2,#3,#4);\n"
    "#6=AXIS2_PLACEMENT_3D('',#9,#10,#3);\n#9=CARTESIAN_POINT('',(1.,2.,3.));\n"
    "#10=DIRECTION('',(0.,1.,0.));\n";
static const char *const MM = "#7=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
                              "#8=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n";
static const char *const INCH_DEGREE =
    "#7=(CONVERSION_BASED_UNIT('INCH',#11)LENGTH_UNIT()NAMED_UNIT(*));\n"
    "#11=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#12);\n"
    "#12=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#8=(CONVERSION_BASED_UNIT('DEGREE',#13)NAMED_UNIT(*)PLANE_ANGLE_UNIT());\n"
    "#13=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#14);\n"
    "#14=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n";

static int try_step(const char *units, const char *data, struct patches *patches,
                    struct error *error)
{
    char text[8000];
    struct surfaces_unit unit;
    int n = snprintf(text, sizeof text, "%s%s%sENDSEC;\nEND-ISO-10303-21;\n", HEAD, units, data);
    ck_assert_int_lt(n, (int)sizeof text);
    *patches = (struct patches){0};
    return surfaces_read(scratch_text(text), 0, patches, &unit, error);
}

static struct patches read_step(const char *units, const char *data)
{
    struct patches patches;
    struct error error;
    ck_assert_msg(try_step(units, data, &patches, &error) == 0, "%s", error.text);
    return patches;
}

/* How far a place is off what is asked for, mm. */
typedef double off_fn(struct vec3 p);

static double off_plane(struct vec3 p)
{
    return p.z;
}
static double off_cylinder(struct vec3 p)
{
    return hypot(p.x, p.y) - 10;
}
/* About the y axis through 1,2,3. */
static double off_placed(struct vec3 p)
{
    return hypot(p.x - 1, p.z - 3) - 10;
}
/* Radius 10 at z = 0, half angle whose tangent is 0.5. */
static double off_cone(struct vec3 p)
{
    return hypot(p.x, p.y) - (10 + p.z / 2);
}
static double off_sphere(struct vec3 p)
{
    return vec_length(p) - 10;
}
static double off_torus(struct vec3 p)
{
    return hypot(hypot(p.x, p.y) - 20, p.z) - 5;
}
static double off_ellipse(struct vec3 p)
{
    return p.x * p.x / 100 + p.y * p.y / 25 - 1;
}
static double off_parabola(struct vec3 p) /* focal distance 2 */
{
    return p.x - p.y * p.y / 8;
}
static double off_hyperbola(struct vec3 p)
{
    return p.x * p.x / 16 - p.y * p.y / 9 - 1;
}
static double off_inches(struct vec3 p)
{
    return hypot(p.x, p.y) - 254;
}

static void lies_on(const struct patch *patch, off_fn *off, double least)
{
    const struct nurbs *s = &patch->surface;
    for (int i = 0; i <= 8; i++)
        for (int k = 0; k <= 8; k++) {
            struct uv at = {s->u.from + (s->u.to - s->u.from) * i / 8,
                            s->v.from + (s->v.to - s->v.from) * k / 8};
            ck_assert_double_lt(fabs(off(nurbs_point(s, at))), least);
        }
}

static void runs_on(const struct patch *patch, off_fn *off, double least)
{
    for (size_t l = 0; l < patch->loop.n; l++)
        for (size_t i = 0; i < patch->loop.item[l].n && patch->loop.item[l].space; i++) {
            const struct nurbs_curve *c = &patch->loop.item[l].item[i];
            for (int k = 0; k <= 16; k++)
                ck_assert_double_lt(
                    fabs(off(nurbs_curve_point(c, c->t.from + (c->t.to - c->t.from) * k / 16))),
                    least);
        }
}

/* A surface that is #102, and what it is made of. */
static struct patches read_surface(const char *units, const char *of)
{
    char data[3000];
    snprintf(data, sizeof data,
             "#100=GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION('',(#101),#1);\n"
             "#101=GEOMETRIC_SET('',(#102));\n%s",
             of);
    struct patches patches = read_step(units, data);
    ck_assert_uint_eq(patches.n, 1);
    return patches;
}

/* Part of a surface without ends, by its parameters. */
static void rectangle(const char *units, const char *surface, const char *range, off_fn *off)
{
    char data[2000];
    snprintf(data, sizeof data, "#102=RECTANGULAR_TRIMMED_SURFACE('',#110,%s,.T.,.T.);\n#110=%s",
             range, surface);
    struct patches patches = read_surface(units, data);
    lies_on(&patches.item[0], off, 1e-9);
    runs_on(&patches.item[0], off, 1e-9);
    patches_free(&patches);
}

START_TEST(surfaces)
{
    rectangle(MM, "PLANE('',#5);\n", "-3.,4.,-5.,6.", off_plane);
    rectangle(MM, "CYLINDRICAL_SURFACE('',#5,10.);\n", "0.,3.,-5.,6.", off_cylinder);
    rectangle(MM, "CYLINDRICAL_SURFACE('',#6,10.);\n", "0.5,1.5,-5.,6.", off_placed);
    rectangle(MM, "CONICAL_SURFACE('',#5,10.,0.46364760900080611621);\n", "0.,3.,-5.,6.", off_cone);
    rectangle(MM, "SPHERICAL_SURFACE('',#5,10.);\n", "0.,3.,-1.,1.5", off_sphere);
    rectangle(MM, "TOROIDAL_SURFACE('',#5,20.,5.);\n", "0.,3.,1.,4.", off_torus);
    rectangle(INCH_DEGREE, "CYLINDRICAL_SURFACE('',#5,10.);\n", "0.,90.,-5.,6.", off_inches);
}
END_TEST

/* A swept surface as far as a polygon through these points needs it. */
static void bounded(const char *surface, const char *corners, off_fn *off)
{
    char data[2000];
    snprintf(data, sizeof data,
             "#102=CURVE_BOUNDED_SURFACE('',#110,(#103),.F.);\n"
             "#103=POLYLINE('',(#104,#105,#106,#104));\n%s#110=%s",
             corners, surface);
    struct patches patches = read_surface(MM, data);
    lies_on(&patches.item[0], off, 1e-9);
    patches_free(&patches);
}

START_TEST(swept)
{
    static const char *const corners = "#104=CARTESIAN_POINT('',(10.,0.,-5.));\n"
                                       "#105=CARTESIAN_POINT('',(0.,10.,6.));\n"
                                       "#106=CARTESIAN_POINT('',(-10.,0.,0.));\n";
    bounded("SURFACE_OF_LINEAR_EXTRUSION('',#111,#112);\n#111=CIRCLE('',#5,10.);\n"
            "#112=VECTOR('',#3,1.);\n",
            corners, off_cylinder);
    bounded("SURFACE_OF_REVOLUTION('',#111,#112);\n#111=LINE('',#113,#114);\n"
            "#112=AXIS1_PLACEMENT('',#2,#3);\n#113=CARTESIAN_POINT('',(10.,0.,0.));\n"
            "#114=VECTOR('',#3,1.);\n",
            corners, off_cylinder);
    bounded("SURFACE_OF_REVOLUTION('',#111,#112);\n#111=CIRCLE('',#113,5.);\n"
            "#112=AXIS1_PLACEMENT('',#2,#3);\n#113=AXIS2_PLACEMENT_3D('',#114,#115,#4);\n"
            "#114=CARTESIAN_POINT('',(20.,0.,0.));\n#115=DIRECTION('',(0.,-1.,0.));\n",
            "#104=CARTESIAN_POINT('',(25.,0.,0.));\n#105=CARTESIAN_POINT('',(0.,20.,5.));\n"
            "#106=CARTESIAN_POINT('',(-15.,0.,0.));\n",
            off_torus);
}
END_TEST

/* Curves on the plane z = 0, closed by a chord, as the bounds of a face of it. */
static void curve(const char *entity, double x0, double y0, double x1, double y1, off_fn *off)
{
    char data[4000];
    snprintf(data, sizeof data,
             "#100=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#101),#1);\n"
             "#101=SHELL_BASED_SURFACE_MODEL('',(#102));\n#102=OPEN_SHELL('',(#103));\n"
             "#103=ADVANCED_FACE('',(#104),#105,.T.);\n#105=PLANE('',#5);\n"
             "#104=FACE_OUTER_BOUND('',#106,.T.);\n#106=EDGE_LOOP('',(#107,#108));\n"
             "#107=ORIENTED_EDGE('',*,*,#109,.T.);\n#108=ORIENTED_EDGE('',*,*,#110,.F.);\n"
             "#109=EDGE_CURVE('',#111,#112,#120,.T.);\n#110=EDGE_CURVE('',#111,#112,#115,.T.);\n"
             "#111=VERTEX_POINT('',#113);\n#112=VERTEX_POINT('',#114);\n"
             "#113=CARTESIAN_POINT('',(%.17g,%.17g,0.));\n"
             "#114=CARTESIAN_POINT('',(%.17g,%.17g,0.));\n"
             "#115=POLYLINE('',(#113,#114));\n#120=%s",
             x0, y0, x1, y1, entity);
    struct patches patches = read_step(MM, data);
    ck_assert_uint_eq(patches.n, 1);
    struct patch *p = &patches.item[0];
    ck_assert_uint_eq(p->loop.n, 1);
    ck_assert_int_eq(p->ignored, 0);
    /* the chord, which is the last, is not on the curve */
    size_t n = p->loop.item[0].n;
    ck_assert_uint_ge(n, 2);
    nurbs_curve_free(&p->loop.item[0].item[n - 1]);
    p->loop.item[0].n--;
    runs_on(p, off, 1e-6);
    const struct nurbs_curve *first = &p->loop.item[0].item[0];
    const struct nurbs_curve *last = &p->loop.item[0].item[n - 2];
    ck_assert_double_lt(vec_distance(nurbs_curve_point(first, first->t.from), vec(x0, y0, 0)),
                        1e-6);
    ck_assert_double_lt(vec_distance(nurbs_curve_point(last, last->t.to), vec(x1, y1, 0)), 1e-6);
    patches_free(&patches);
}

START_TEST(curves)
{
    double y = 3 * sqrt(25.0 / 16 - 1);
    curve("CIRCLE('',#5,10.);\n", 10, 0, 0, 10, off_cylinder);
    curve("CIRCLE('',#5,10.);\n", 0, -10, 0, 10, off_cylinder); /* over the start */
    curve("ELLIPSE('',#5,10.,5.);\n", 10, 0, -10, 0, off_ellipse);
    curve("PARABOLA('',#5,2.);\n", 2, -4, 8, 8, off_parabola);
    curve("HYPERBOLA('',#5,4.,3.);\n", 5, -y, 5, y, off_hyperbola);
    curve("TRIMMED_CURVE('',#121,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.);\n"
          "#121=CIRCLE('',#5,10.);\n",
          10, 0, 10 * cos(2), 10 * sin(2), off_cylinder);
    curve(
        "COMPOSITE_CURVE('',(#121,#122),.F.);\n"
        "#121=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#123);\n"
        "#122=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#124);\n"
        "#123=TRIMMED_CURVE('',#125,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);\n"
        "#124=TRIMMED_CURVE('',#125,(PARAMETER_VALUE(1.)),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.);\n"
        "#125=CIRCLE('',#5,10.);\n",
        10, 0, 10 * cos(2), 10 * sin(2), off_cylinder);
    curve(
        "SURFACE_CURVE('',#121,(#122),.CURVE_3D.);\n#121=CIRCLE('',#5,10.);\n#122=PLANE('',#5);\n",
        10, 0, 0, 10, off_cylinder);
    curve("(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#121,#122,#123),.UNSPECIFIED.,.F.,.F.)"
          "B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)CURVE()"
          "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.70710678118654752,1.))"
          "REPRESENTATION_ITEM(''));\n#121=CARTESIAN_POINT('',(10.,0.,0.));\n"
          "#122=CARTESIAN_POINT('',(10.,10.,0.));\n#123=CARTESIAN_POINT('',(0.,10.,0.));\n",
          10, 0, 0, 10, off_cylinder);
}
END_TEST

/* A quarter turn about y at 100,0,0 of a face in the plane z = 0, from 0,0 to 8,5, and the product
 * structure that says which is the part; `relation` has both representations, `items` the axes. */
static struct patches assembly(const char *relation, const char *items, const char *more)
{
    char data[5000];
    snprintf(data, sizeof data,
             "#100=SHAPE_REPRESENTATION('part',(#5,#101),#1);\n"
             "#101=SHELL_BASED_SURFACE_MODEL('',(#102));\n#102=OPEN_SHELL('',(#103));\n"
             "#103=ADVANCED_FACE('',(#104),#105,.T.);\n#105=PLANE('',#5);\n"
             "#104=FACE_OUTER_BOUND('',#106,.T.);\n#106=POLY_LOOP('',(#2,#107,#108,#109));\n"
             "#107=CARTESIAN_POINT('',(8.,0.,0.));\n#108=CARTESIAN_POINT('',(8.,5.,0.));\n"
             "#109=CARTESIAN_POINT('',(0.,5.,0.));\n"
             "#110=SHAPE_REPRESENTATION('whole',(#111),#1);\n"
             "#111=AXIS2_PLACEMENT_3D('',#112,#4,#113);\n"
             "#112=CARTESIAN_POINT('',(100.,0.,0.));\n#113=DIRECTION('',(0.,0.,-1.));\n"
             "#114=(REPRESENTATION_RELATIONSHIP('','',%s)"
             "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#115)"
             "SHAPE_REPRESENTATION_RELATIONSHIP());\n"
             "#115=ITEM_DEFINED_TRANSFORMATION('','',%s);\n"
             "#120=PRODUCT_DEFINITION('','',$,$);\n#121=PRODUCT_DEFINITION('','',$,$);\n"
             "#122=PRODUCT_DEFINITION_SHAPE('','',#120);\n"
             "#123=PRODUCT_DEFINITION_SHAPE('','',#121);\n"
             "#124=SHAPE_DEFINITION_REPRESENTATION(#122,#100);\n"
             "#125=SHAPE_DEFINITION_REPRESENTATION(#123,#110);\n"
             "#126=NEXT_ASSEMBLY_USAGE_OCCURRENCE('','','',#121,#120,$);\n"
             "#127=PRODUCT_DEFINITION_SHAPE('','',#126);\n"
             "#128=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#114,#127);\n%s",
             relation, items, more);
    return read_step(MM, data);
}

/* (x, y, 0) of the part is at (100, y, -x). */
static void is_placed(struct patches *patches)
{
    ck_assert_uint_eq(patches->n, 1);
    const struct patch *p = &patches->item[0];
    double low = 0, high = 0;
    for (size_t i = 0; i < p->loop.item[0].n; i++) {
        const struct nurbs_curve *c = &p->loop.item[0].item[i];
        struct vec3 at = nurbs_curve_point(c, c->t.from);
        ck_assert_double_lt(fabs(at.x - 100), 1e-9);
        low = fmin(low, at.z);
        high = fmax(high, at.y);
    }
    ck_assert_double_lt(fabs(low + 8), 1e-9);
    ck_assert_double_lt(fabs(high - 5), 1e-9);
    patches_free(patches);
}

START_TEST(placed)
{
    struct patches p = assembly("#100,#110", "#5,#111", "");
    is_placed(&p);
    p = assembly("#110,#100", "#111,#5", ""); /* the whole first */
    is_placed(&p);
    p = assembly("#100,#110", "#111,#5", ""); /* the axes of each other */
    is_placed(&p);
    p = assembly("#110,#100", "#5,#111", "");
    is_placed(&p);
    /* once more in a representation that an area belongs to */
    p = assembly("#100,#110", "#5,#111",
                 "#130=SHAPE_REPRESENTATION('',(#101),#1);\n"
                 "#131=PROPERTY_DEFINITION('','area',#122);\n"
                 "#132=SHAPE_DEFINITION_REPRESENTATION(#131,#130);\n");
    is_placed(&p);
    /* what has no part in it stays */
    p = assembly("#100,#110", "#5,#111",
                 "#130=SHAPE_REPRESENTATION('',(#131),#1);\n"
                 "#131=SHELL_BASED_SURFACE_MODEL('',(#132));\n#132=OPEN_SHELL('',(#133));\n"
                 "#133=ADVANCED_FACE('',(#104),#105,.T.);\n");
    ck_assert_uint_eq(p.n, 2);
    patches_free(&p);
}
END_TEST

START_TEST(mapped)
{
    struct patches p = read_step(
        MM, "#100=SHAPE_REPRESENTATION('',(#101,#102),#1);\n#101=MAPPED_ITEM('',#103,#104);\n"
            "#102=MAPPED_ITEM('',#103,#5);\n#103=REPRESENTATION_MAP(#5,#105);\n"
            "#104=AXIS2_PLACEMENT_3D('',#112,#3,#4);\n#112=CARTESIAN_POINT('',(0.,0.,50.));\n"
            "#105=SHAPE_REPRESENTATION('',(#106),#1);\n#106=GEOMETRIC_SET('',(#107));\n"
            "#107=RECTANGULAR_TRIMMED_SURFACE('',#108,0.,1.,0.,1.,.T.,.T.);\n#108=PLANE('',#5);\n");
    ck_assert_uint_eq(p.n, 2);
    double z0 = nurbs_point(&p.item[0].surface, (struct uv){0, 0}).z;
    double z1 = nurbs_point(&p.item[1].surface, (struct uv){0, 0}).z;
    ck_assert_double_lt(fabs(fmax(z0, z1) - 50) + fabs(fmin(z0, z1)), 1e-9);
    patches_free(&p);
}
END_TEST

static void refused(const char *data, const char *words)
{
    struct patches p;
    struct error error;
    ck_assert_int_eq(try_step(MM, data, &p, &error), -1);
    ck_assert_msg(strstr(error.text, words) != NULL, "%s", error.text);
    patches_free(&p);
}

START_TEST(hostile)
{
    static const char *const shell[] = {"CLOSED_SHELL", "OPEN_SHELL", "CONNECTED_FACE_SET"};
    static const char *const solid[] = {"MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP"};
    for (int i = 0; i < 3; i++) {
        char data[300];
        snprintf(data, sizeof data, "#100=SHAPE_REPRESENTATION('',(#101),#1);\n#101=%s('',());\n",
                 shell[i]);
        refused(data, "a shell without faces");
        snprintf(data, sizeof data, "#100=SHAPE_REPRESENTATION('',(#101),#1);\n#101=%s('',(1.));\n",
                 shell[i]);
        refused(data, "no face where one belongs");
        snprintf(data, sizeof data, "#100=SHAPE_REPRESENTATION('',(#101),#1);\n#101=%s('',1.);\n",
                 solid[i]);
        refused(data, "no shell where one belongs");
    }
    refused("#100=SHAPE_REPRESENTATION('',(#5),#1);\n", "no face");
    refused("#100=SHAPE_REPRESENTATION('',(#101),#1);\n", "that there is");
    refused("#100=SHAPE_REPRESENTATION('',(#101),#1);\n#101=MAPPED_ITEM('',#102,#5);\n"
            "#102=REPRESENTATION_MAP(#5,#100);\n"
            "#103=SHAPE_REPRESENTATION('',(#101),#1);\n",
            "expected");
    refused("#100=SHAPE_REPRESENTATION('',(#101),#1);\n#101=OPEN_SHELL('',(#101));\n",
            "without end");
    refused("#100=SHAPE_REPRESENTATION('',(#101),#1);\n#101=GEOMETRIC_SET('',(#102));\n"
            "#102=RECTANGULAR_TRIMMED_SURFACE('',#103,0.,1.,0.,1.,.T.,.T.);\n"
            "#103=CYLINDRICAL_SURFACE('',#5,-1.);\n",
            "no size");
    refused("#100=(REPRESENTATION_RELATIONSHIP('','',#101,#102)"
            "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#5)"
            "SHAPE_REPRESENTATION_RELATIONSHIP());\n",
            "ITEM_DEFINED_TRANSFORMATION");
}
END_TEST

int main(void)
{
    Suite *s = suite_create("step_model");
    TCase *c = tcase_create("all");
    tcase_add_test(c, surfaces);
    tcase_add_test(c, swept);
    tcase_add_test(c, curves);
    tcase_add_test(c, placed);
    tcase_add_test(c, mapped);
    tcase_add_test(c, hostile);
    suite_add_tcase(s, c);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_ENV);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

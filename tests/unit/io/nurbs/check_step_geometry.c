/* step_geometry: places, curves from end to end and surfaces are where ISO 10303-42 says, in mm and
 * placed; the file is in inches and degrees, the part turned a quarter about z and shifted. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/step_geometry.h"
#include "math/elementary.h"
#include "scratch.h"

static struct step step;
static struct step_place place;
static struct patch_loop loop;
static struct nurbs surface;
static struct error error;
static double rough;
static char kind[40];
static const double MM = 25.4;

static void teardown(void)
{
    step_free(&step);
    patch_loop_free(&loop);
    nurbs_free(&surface);
    step = (struct step){0};
    loop = (struct patch_loop){0};
    surface = (struct nurbs){0};
}

/* #90 refers to what is looked at. */
static void read_data(const char *data)
{
    static const char *const points =
        "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,2.,3.));\n"
        "#3=DIRECTION('',(0.,0.,1.));\n#4=DIRECTION('',(0.,2.,0.));\n#5=DIRECTION('',(5.,1.,0.));\n"
        "#6=AXIS2_PLACEMENT_3D('',#1,#3,$);\n#7=AXIS2_PLACEMENT_3D('',#2,#4,#5);\n"
        "#8=VECTOR('',#4,3.);\n#9=VERTEX_POINT('',#2);\n";
    char text[4000];
    struct reader r;
    teardown();
    snprintf(text, sizeof text,
             "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n%s%sENDSEC;\nEND-ISO-10303-21;\n", points,
             data);
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    ck_assert_msg(step_read(&r, &step, &error) == 0, "%s", error.text);
    reader_close(&r);
    place = (struct step_place){&step, transform_identity(), MM, RADIANS(1)};
    memset(place.to.m, 0, sizeof place.to.m);
    place.to.m[0][1] = -MM;
    place.to.m[1][0] = MM;
    place.to.m[2][2] = MM;
    place.to.m[0][3] = 100;
    place.to.m[3][3] = 1;
    rough = 0;
}

/* A place of the file, in the part's. */
static struct vec3 placed(double x, double y, double z)
{
    return vec(100 - MM * y, MM * x, MM * z);
}

static void near_point(struct vec3 p, struct vec3 q)
{
    ck_assert_msg(vec_distance(p, q) < 1e-8, "%.12g %.12g %.12g, not %.12g %.12g %.12g", p.x, p.y,
                  p.z, q.x, q.y, q.z);
}

/* What stands for a reference in the attributes of instance 90. */
static struct step_values referring;
static const struct step_value *reference(void)
{
    array_free(&referring);
    referring = (struct step_values){0};
    ck_assert_int_eq(step_values(&step, step_find(&step, 90), &referring, &error), 0);
    return step_item(step_item(referring.item, 0), 0);
}

static int curve(const struct vec3 *ends)
{
    const struct step_value *r = reference();
    int got = step_curve(&place, &referring, r, ends, &loop, &error);
    array_free(&referring);
    referring = (struct step_values){0};
    return got;
}

static int surface_of(const struct vec3s *points)
{
    const struct step_value *r = reference();
    int got = step_surface(&place, &referring, r, points, &surface, &rough, kind, &error);
    array_free(&referring);
    referring = (struct step_values){0};
    return got;
}

START_TEST(axes_and_vertices)
{
    struct transform t;
    struct vec3 p;
    struct step_values to = {0};
    read_data("#90=X(#7);\n");
    /* z along y, x along the ratios given less their part along it; lengths as in the file */
    ck_assert_int_eq(step_axes(&step, &referring, reference(), &t, &error), 0);
    near_point(transform_point(&t, vec(0, 0, 0)), vec(1, 2, 3));
    near_point(transform_point(&t, vec(1, 0, 0)), vec(2, 2, 3));
    near_point(transform_point(&t, vec(0, 1, 0)), vec(1, 2, 2));
    near_point(transform_point(&t, vec(0, 0, 1)), vec(1, 3, 3));
    ck_assert_int_eq(step_follow(&step, &referring, reference(), &to, &error), 0);
    ck_assert_int_eq(to.instance->id, 7);
    array_free(&to);
    ck_assert_int_eq(step_vertex(&place, &referring, reference(), &p, &error), -1);
    read_data("#90=X(#9);\n");
    ck_assert_int_eq(step_vertex(&place, &referring, reference(), &p, &error), 0);
    near_point(p, placed(1, 2, 3));
    ck_assert_int_eq(step_axes(&step, &referring, reference(), &t, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "no axis placement"));
    read_data("#90=X(#2);\n");
    ck_assert_int_eq(step_vertex(&place, &referring, reference(), &p, &error), 0);
    near_point(p, placed(1, 2, 3));
    read_data("#90=X(#44);\n");
    ck_assert_int_eq(step_vertex(&place, &referring, reference(), &p, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "#90 refers to #44"));
    read_data("#90=X(5.);\n");
    ck_assert_int_eq(step_follow(&step, &referring, reference(), &to, &error), -1);
    array_free(&referring);
    referring = (struct step_values){0};
}
END_TEST

/* Each piece begins where the one before it ends. */
static void joins(struct vec3 from, struct vec3 to)
{
    for (size_t i = 0; i < loop.n; i++) {
        const struct nurbs_curve *c = &loop.item[i];
        near_point(nurbs_curve_point(c, c->t.from), from);
        from = nurbs_curve_point(c, c->t.to);
    }
    near_point(from, to);
}

static struct vec3 at(size_t i, double part)
{
    const struct nurbs_curve *c = &loop.item[i];
    return nurbs_curve_point(c, c->t.from + part * (c->t.to - c->t.from));
}

START_TEST(lines_and_circles)
{
    struct vec3 ends[2];
    read_data("#10=LINE('',#1,#8);\n#90=X(#10);\n");
    ck_assert_int_eq(curve(NULL), 1); /* has no ends */
    ends[0] = placed(0, 1, 0);
    ends[1] = placed(0, 4, 0);
    ck_assert_int_eq(curve(ends), 0);
    joins(ends[0], ends[1]);
    near_point(at(0, 0.5), placed(0, 2.5, 0));
    /* about 1, 2, 3 in the plane of x and -z: from x to -z is a quarter, and three back */
    read_data("#10=CIRCLE('',#7,2.);\n#90=X(#10);\n");
    for (int way = 0; way < 3; way++) {
        struct vec3 x = placed(3, 2, 3), y = placed(1, 2, 1);
        ends[0] = way == 1 ? y : x;
        ends[1] = way == 0 ? y : x;
        patch_loop_free(&loop);
        loop = (struct patch_loop){0};
        ck_assert_int_eq(curve(ends), 0);
        joins(ends[0], ends[1]);
        double turned = way == 0 ? 45 : way == 1 ? 90 + 135 : 180; /* degrees, in the middle */
        double a = RADIANS(turned);
        ck_assert_uint_eq(loop.n, 1);
        near_point(at(0, 0.5), placed(1 + 2 * cos(a), 2, 3 - 2 * sin(a)));
    }
    patch_loop_free(&loop);
    loop = (struct patch_loop){0};
    ck_assert_int_eq(curve(NULL), 0); /* all of it */
    joins(placed(3, 2, 3), placed(3, 2, 3));
    read_data("#10=CIRCLE('',#7,0.);\n#90=X(#10);\n");
    ck_assert_int_eq(curve(NULL), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a radius that is not positive"));
}
END_TEST

START_TEST(other_conics)
{
    struct vec3 ends[2] = {placed(4, 0, 0), placed(0, 3, 0)};
    read_data("#10=ELLIPSE('',#6,4.,3.);\n#90=X(#10);\n");
    ck_assert_int_eq(curve(ends), 0);
    joins(ends[0], ends[1]);
    near_point(at(0, 0.5), placed(4 * sqrt(0.5), 3 * sqrt(0.5), 0));
    read_data("#10=HYPERBOLA('',#6,4.,3.);\n#90=X(#10);\n");
    ends[0] = placed(4 * cosh(-1), 3 * sinh(-1), 0);
    ends[1] = placed(4 * cosh(1), 3 * sinh(1), 0);
    ck_assert_int_eq(curve(ends), 0);
    joins(ends[0], ends[1]);
    near_point(at(0, 0.5), placed(4, 0, 0));
    read_data("#10=PARABOLA('',#6,2.);\n#90=X(#10);\n");
    ends[0] = placed(2, -4, 0); /* t = -1: 2 t^2, 4 t */
    ends[1] = placed(8, 8, 0);
    ck_assert_int_eq(curve(ends), 0);
    joins(ends[0], ends[1]);
    near_point(at(0, 0.5), placed(0.5, 2, 0));
    ck_assert_int_eq(curve(NULL), 1);
}
END_TEST

/* Knots by the kind of spline; trimmed by parameters, against its direction. */
START_TEST(splines)
{
    static const char *const points = "#20=CARTESIAN_POINT('',(0.,0.,0.));\n"
                                      "#21=CARTESIAN_POINT('',(1.,2.,0.));\n"
                                      "#22=CARTESIAN_POINT('',(2.,0.,0.));\n";
    char text[1000];
    snprintf(
        text, sizeof text,
        "%s#10=B_SPLINE_CURVE_WITH_KNOTS('',2,(#20,#21,#22),.UNSPECIFIED.,.F.,.F.,(3,3),(0.,4.)"
        ",.UNSPECIFIED.);\n#90=X(#10);\n",
        points);
    read_data(text);
    ck_assert_int_eq(curve(NULL), 0);
    joins(placed(0, 0, 0), placed(2, 0, 0));
    near_point(at(0, 0.25), placed(0.5, 0.75, 0)); /* a parabola: x = 2 s, y = 4 s (1 - s) */
    struct vec3 ends[2] = {placed(0.5, 0.75, 0), placed(1.5, 0.75, 0)};
    patch_loop_free(&loop);
    loop = (struct patch_loop){0};
    ck_assert_int_eq(curve(ends), 0);
    joins(ends[0], ends[1]);
    snprintf(text, sizeof text,
             "%s#10=BEZIER_CURVE('',2,(#20,#21,#22),.UNSPECIFIED.,.F.,.F.);\n"
             "#11=TRIMMED_CURVE('',#10,(PARAMETER_VALUE(0.75)),(PARAMETER_VALUE(0.25)),.F.,"
             ".PARAMETER.);\n#90=X(#11);\n",
             points);
    read_data(text);
    ck_assert_int_eq(curve(NULL), 0);
    joins(placed(1.5, 0.75, 0), placed(0.5, 0.75, 0));
    snprintf(text, sizeof text,
             "%s#10=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#20,#21,#22),.UNSPECIFIED.,.F.,.F.)"
             "B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)CURVE()"
             "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,3.,1.))"
             "REPRESENTATION_ITEM(''));\n#90=X(#10);\n",
             points);
    read_data(text);
    ck_assert_int_eq(curve(NULL), 0);
    near_point(at(0, 0.5), placed(1, 1.5, 0)); /* (0 + 2 * 3 * 2 + 0) / (1 + 6 + 1) */
    snprintf(
        text, sizeof text,
        "%s#10=B_SPLINE_CURVE_WITH_KNOTS('',2,(#20,#21,#22),.UNSPECIFIED.,.F.,.F.,(3,2),(0.,4.)"
        ",.UNSPECIFIED.);\n#90=X(#10);\n",
        points);
    read_data(text);
    ck_assert_int_eq(curve(NULL), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "multiplicities of knots"));
}
END_TEST

/* Segments that run their own way or against it; a circle trimmed by angles in degrees. */
START_TEST(composites)
{
    read_data("#10=CIRCLE('',#6,2.);\n"
              "#11=TRIMMED_CURVE('',#10,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(90.)),.T.,"
              ".PARAMETER.);\n"
              "#12=CARTESIAN_POINT('',(-3.,2.,0.));\n#13=CARTESIAN_POINT('',(0.,2.,0.));\n"
              "#14=POLYLINE('',(#12,#13));\n"
              "#15=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#11);\n"
              "#16=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#14);\n"
              "#17=COMPOSITE_CURVE('',(#15,#16),.F.);\n#90=X(#17);\n");
    ck_assert_int_eq(curve(NULL), 0);
    joins(placed(2, 0, 0), placed(-3, 2, 0));
    ck_assert_uint_eq(loop.n, 2);
    near_point(at(0, 0.5), placed(sqrt(2), sqrt(2), 0));
    read_data("#10=CIRCLE('',#6,2.);\n"
              "#11=OFFSET_CURVE_3D('',#10,0.5,.F.,#3);\n#90=X(#11);\n");
    ck_assert_int_eq(curve(NULL), 0); /* z x tangent looks in */
    for (int i = 0; i <= 8; i++)
        ck_assert_double_eq_tol(vec_distance(at(0, i / 8.0), placed(0, 0, 0)), 1.5 * MM, 1e-5);
    read_data("#11=TRIMMED_CURVE('',#11,(#1),(#2),.T.,.CARTESIAN.);\n#90=X(#11);\n");
    ck_assert_int_eq(curve(NULL), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "without end"));
}
END_TEST

/* Curves of curves, each kind 20 deep about a circle, are read; one more is refused. */
START_TEST(curves_of_curves)
{
    static const char *const outer[] = {
        "COMPOSITE_CURVE('',(#%d),.F.);\n#%d=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#%d)",
        "OFFSET_CURVE_3D('',#%d,0.01,.F.,#3)", "SURFACE_CURVE('',#%d,(),.CURVE_3D.)"};
    for (int kinds = 0; kinds < 3; kinds++)
        for (int deep = 20; deep <= 21; deep++) {
            char data[3500] = "#100=CIRCLE('',#6,2.);\n";
            size_t n = strlen(data);
            for (int i = 1; i <= deep; i++) {
                n += (size_t)snprintf(data + n, sizeof data - n, "#%d=", 100 + i);
                n += (size_t)snprintf(data + n, sizeof data - n, outer[kinds],
                                      kinds == 0 ? 200 + i : 99 + i, 200 + i, 99 + i);
                n += (size_t)snprintf(data + n, sizeof data - n, ";\n");
            }
            snprintf(data + n, sizeof data - n, "#90=X(#%d);\n", 100 + deep);
            read_data(data);
            ck_assert_int_eq(curve(NULL), deep > 20 ? -1 : 0);
            ck_assert(deep == 20 || strstr(error.text, "without end"));
        }
}
END_TEST

/* A straight line in the parameters of a surface, from x, y along dx, dy; angles are degrees. */
static void read_line_on(const char *on, double x, double y, double dx, double dy)
{
    char data[1500];
    snprintf(data, sizeof data,
             "#20=%s;\n#29=PCURVE('',#20,#30);\n#30=DEFINITIONAL_REPRESENTATION('',(#31),#1);\n"
             "#31=LINE('',#32,#33);\n#32=CARTESIAN_POINT('',(%.12f,%.12f));\n"
             "#33=VECTOR('',#34,1.);\n#34=DIRECTION('',(%.12f,%.12f));\n#90=X(#29);\n",
             on, x, y, dx, dy);
    read_data(data);
}

static struct vec3 on_cylinder(double u, double v)
{
    return placed(2 * cos(RADIANS(u)), 2 * sin(RADIANS(u)), v);
}

static struct vec3 on_torus(double u, double v)
{
    double r = 5 + cos(RADIANS(v));
    return placed(r * cos(RADIANS(u)), r * sin(RADIANS(u)), sin(RADIANS(v)));
}

static struct vec3 on_plane(double u, double v)
{
    return placed(u, v, 0);
}

/* Two knots of u and three of v, corners 0,0,0 4,0,0 0,6,0 4,6,8, lines between. */
static struct vec3 on_saddle(double u, double v)
{
    return placed(4 * u, 6 * v, 8 * u * v);
}

static const struct {
    const char *on;
    struct vec3 (*at)(double u, double v);
    double from[2], to[2]; /* the ends of the edge */
    double shift;          /* the line begins so much of its way before them */
} line_on[] = {
    {"PLANE('',#6)", on_plane, {1, 2}, {4, 6}, 0.3},
    {"PLANE('',#6)", on_plane, {4, 6}, {1, 2}, -0.5},
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {10, 0}, {100, 1}, 0},
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {100, 1}, {10, 3}, 0.2},
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {300, 1}, {400, 2}, 0.2}, /* over the seam */
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {-20, 1}, {-200, 1}, 0},
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {30, 1}, {390, 1}, 0}, /* all round */
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {30, -1}, {30, 5}, 0.1},
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {390, 1}, {450, 40}, 0.2}, /* a turn on */
    {"CYLINDRICAL_SURFACE('',#6,2.)", on_cylinder, {-390, 1}, {-330, -40}, 0.2},
    {"TOROIDAL_SURFACE('',#6,5.,1.)", on_torus, {20, 350}, {20, 380}, 0},
    {"TOROIDAL_SURFACE('',#6,5.,1.)", on_torus, {350, 40}, {375, 40}, 0.1},
    {"B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#50),(#51,#52)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),"
     "(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.);\n#50=CARTESIAN_POINT('',(0.,6.,0.));\n"
     "#51=CARTESIAN_POINT('',(4.,0.,0.));\n#52=CARTESIAN_POINT('',(4.,6.,8.))",
     on_saddle,
     {0.2, 0.1},
     {0.7, 0.9},
     0.1},
};

START_TEST(lines_in_parameters)
{
    const double *from = line_on[_i].from, *to = line_on[_i].to, shift = line_on[_i].shift;
    double du = to[0] - from[0], dv = to[1] - from[1];
    struct vec3 ends[2] = {line_on[_i].at(from[0], from[1]), line_on[_i].at(to[0], to[1])};
    double u = from[0] - shift * du, v = from[1] - shift * dv;
    read_line_on(line_on[_i].on, u, v, shift < 0 ? -du : du, shift < 0 ? -dv : dv);
    if (shift < 0) { /* against the line: it has no part from the first to the second */
        ck_assert_int_eq(curve(ends), 1);
        return;
    }
    ck_assert_int_eq(curve(ends), 0);
    ck_assert_double_lt(vec_distance(at(0, 0), ends[0]), 1e-5);
    ck_assert_double_lt(vec_distance(at(loop.n - 1, 1), ends[1]), 1e-5);
    /* all of it on the line, whole and without a leap */
    struct vec3 last = ends[0];
    double way = 0, whole = 0;
    for (int i = 1; i <= 1000; i++)
        whole += vec_distance(
            line_on[_i].at(from[0] + du * (i - 1) / 1000, from[1] + dv * (i - 1) / 1000),
            line_on[_i].at(from[0] + du * i / 1000, from[1] + dv * i / 1000));
    for (size_t k = 0; k < loop.n; k++)
        for (int i = 0; i <= 50; i++) {
            struct vec3 p = at(k, i / 50.0);
            double least = HUGE_VAL;
            for (int j = 0; j <= 4000; j++)
                least = fmin(least, vec_distance(p, line_on[_i].at(from[0] + du * j / 4000,
                                                                   from[1] + dv * j / 4000)));
            ck_assert_double_lt(least, whole / 4000);
            way += vec_distance(last, p);
            last = p;
        }
    ck_assert_double_lt(fabs(way - whole), 2e-3 * whole);
    ck_assert_int_eq(curve(NULL), 1); /* without ends */
}
END_TEST

/* Another curve than a line there has ends of its own; its numbers are parameters, no lengths. */
START_TEST(curves_in_parameters)
{
    read_data("#20=CYLINDRICAL_SURFACE('',#6,2.);\n#29=PCURVE('',#20,#30);\n"
              "#30=DEFINITIONAL_REPRESENTATION('',(#31),#1);\n#31=POLYLINE('',(#32,#33,#34));\n"
              "#32=CARTESIAN_POINT('',(10.,0.));\n#33=CARTESIAN_POINT('',(60.,0.));\n"
              "#34=CARTESIAN_POINT('',(60.,3.));\n#90=X(#29);\n");
    ck_assert_int_eq(curve(NULL), 0);
    ck_assert_double_lt(vec_distance(at(0, 0), on_cylinder(10, 0)), 1e-5);
    ck_assert_double_lt(vec_distance(at(loop.n - 1, 1), on_cylinder(60, 3)), 1e-5);
    double way = 0;
    for (size_t k = 0; k < loop.n; k++)
        for (int i = 0; i < 100; i++)
            way += vec_distance(at(k, i / 100.0), at(k, (i + 1) / 100.0));
    ck_assert_double_eq_tol(way, MM * (2 * RADIANS(50) + 3), 1e-3);
}
END_TEST

/* Knots belong to a B-spline: the entity that only holds the poles is none. */
START_TEST(poles_without_knots)
{
    read_data("#10=B_SPLINE_CURVE('',1,(#1,#2),.UNSPECIFIED.,.F.,.F.);\n#90=X(#10);\n");
    ck_assert_int_eq(curve(NULL), 1);
    read_data("#10=(B_SPLINE_CURVE(1,(#1,#2),.UNSPECIFIED.,.F.,.F.)BOUNDED_CURVE()CURVE());\n"
              "#90=X(#10);\n");
    ck_assert_int_eq(curve(NULL), 1);
}
END_TEST

static double off_torus(struct vec3 p)
{
    double x = p.y / MM, y = (100 - p.x) / MM, z = p.z / MM;
    return hypot(hypot(x, y) - 4, z) - 1;
}

/* As far as the points reach, the normal by the standard; what is not read is named. */
START_TEST(surfaces)
{
    struct vec3 square[4] = {placed(0, 0, 0), placed(4, 0, 0), placed(4, 4, 0), placed(0, 4, 0)};
    struct vec3s points = {4, 4, square};
    read_data("#10=PLANE('',#6);\n#90=X(#10);\n");
    ck_assert_int_eq(surface_of(&points), 0);
    struct nurbs_place p = nurbs_place(&surface, (struct uv){(surface.u.from + surface.u.to) / 2,
                                                             (surface.v.from + surface.v.to) / 2});
    near_point(p.point, placed(2, 2, 0));
    near_point(p.normal, vec(0, 0, 1));
    read_data("#10=TOROIDAL_SURFACE('',#6,4.,1.);\n#90=X(#10);\n");
    ck_assert_int_eq(surface_of(&points), 0);
    for (int i = 0; i < 12; i++)
        for (int k = 0; k < 12; k++) {
            struct uv uv = {surface.u.from + (surface.u.to - surface.u.from) * i / 12,
                            surface.v.from + (surface.v.to - surface.v.from) * k / 12};
            ck_assert_double_eq_tol(off_torus(nurbs_point(&surface, uv)), 0, 1e-9);
        }
    read_data("#10=FACETED_SURFACE('',#6);\n#90=X(#10);\n");
    ck_assert_int_eq(surface_of(&points), 1);
    ck_assert_str_eq(kind, "FACETED_SURFACE");
    read_data("#10=TOROIDAL_SURFACE('',#6,'four',1.);\n#90=X(#10);\n");
    ck_assert_int_eq(surface_of(&points), -1);
}
END_TEST

/* A sector of a cylinder from 0 to 90 degrees, heights 1 to 3: four sides in turn. */
START_TEST(rectangles)
{
    struct step_values v = {0};
    read_data("#10=CYLINDRICAL_SURFACE('',#6,2.);\n"
              "#90=RECTANGULAR_TRIMMED_SURFACE('',#10,0.,90.,1.,3.,.T.,.T.);\n");
    ck_assert_int_eq(step_values(&step, step_find(&step, 90), &v, &error), 0);
    ck_assert_int_eq(step_rectangle(&place, &v, &loop, &error), 0);
    array_free(&v);
    ck_assert(loop.space);
    ck_assert_uint_ge(loop.n, 4);
    struct vec3 last = at(loop.n - 1, 1);
    joins(last, last);
    size_t corners = 0;
    for (size_t i = 0; i < loop.n; i++)
        for (int k = 0; k <= 4; k++) {
            struct vec3 p = at(i, k / 4.0);
            double x = p.y / MM, y = (100 - p.x) / MM, z = p.z / MM;
            ck_assert_double_eq_tol(hypot(x, y), 2, 1e-8);
            ck_assert(x > -1e-8 && y > -1e-8 && z > 1 - 1e-8 && z < 3 + 1e-8);
            corners += k == 0 && (fabs(x) < 1e-8 || fabs(y) < 1e-8) &&
                       (fabs(z - 1) < 1e-8 || fabs(z - 3) < 1e-8);
        }
    ck_assert_uint_eq(corners, 4);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("step_geometry");
    TCase *tests = tcase_create("step_geometry");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, axes_and_vertices);
    tcase_add_test(tests, lines_and_circles);
    tcase_add_test(tests, other_conics);
    tcase_add_test(tests, splines);
    tcase_add_test(tests, composites);
    tcase_add_test(tests, curves_of_curves);
    tcase_add_loop_test(tests, lines_in_parameters, 0, (int)(sizeof line_on / sizeof *line_on));
    tcase_add_test(tests, curves_in_parameters);
    tcase_add_test(tests, poles_without_knots);
    tcase_add_test(tests, surfaces);
    tcase_add_test(tests, rectangles);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

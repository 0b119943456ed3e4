/*
 * iges_ruled: places of two curves that belong together by their lengths (form 0) or by the file's
 * parameters (form 1), forwards and backwards: on polylines and arcs where both are known.
 */
#include "iges_files.h"

#include "base/array.h"
#include "io/nurbs/iges_ruled.h"
#include "math/elementary.h"

static struct iges_side side[2];
static struct nurbs surface;
static double rough;

static void setup(void)
{
    iges_file_begin();
    rough = 0;
}

static void teardown(void)
{
    iges_ruled_free(side);
    nurbs_free(&surface);
    iges_file_end();
    surface = (struct nurbs){0};
}

static void again(void)
{
    teardown();
    setup();
}

/* The entity of these two curves, read and made. */
static void rule(int form, int a, int b, int backwards)
{
    int number = iges_file_format(118, form, 0, false, "118,%d,%d,%d,0;", a, b, backwards);
    struct transform twice = transform_scale(2);
    iges_file_read();
    ck_assert_int_eq(iges_ruled_read(&iges, iges_entity(&iges, number), side, &error), 0);
    surface = iges_ruled_surface(side, &twice, &rough);
}

/* At u and v from 0 to 1, in the file's lengths. */
static void passes(double u, double v, struct vec3 q)
{
    const struct nurbs_axis *a = &surface.u, *b = &surface.v;
    struct uv at = {a->from + u * (a->to - a->from), b->from + v * (b->to - b->from)};
    struct vec3 p = vec_scale(0.5, nurbs_point(&surface, at));
    ck_assert_msg(vec_distance(p, q) < 1e-6, "%g %g: %.9g %.9g %.9g, not %.9g %.9g %.9g", u, v, p.x,
                  p.y, p.z, q.x, q.y, q.z);
}

/* A corner after 1 of 4 mm of one polyline, after 3 of 4 of the other: by length each place is that
 * far along it. */
START_TEST(by_length)
{
    int a = iges_file_add(106, 12, 0, true, "106,2,3,0.,0.,0.,1.,0.,0.,1.,3.,0.;");
    int b = iges_file_add(106, 12, 0, true, "106,2,3,0.,0.,5.,3.,0.,5.,3.,1.,5.;");
    rule(0, a, b, 0);
    ck_assert(!iges_ruled_exact(side));
    for (int i = 0; i <= 16; i++) {
        double l = i / 4.0;
        struct vec3 p = l < 1 ? vec(l, 0, 0) : vec(1, l - 1, 0);
        struct vec3 q = l < 3 ? vec(l, 0, 5) : vec(3, l - 3, 5);
        passes(l / 4, 0, p);
        passes(l / 4, 1, q);
        passes(l / 4, 0.3, vec_mix(p, q, 0.3));
    }
    ck_assert_double_lt(rough, 1e-6);
}
END_TEST

/* The same by parameters: a polyline's grow alike from corner to corner. */
START_TEST(by_parameter)
{
    int a = iges_file_add(106, 12, 0, true, "106,2,3,0.,0.,0.,1.,0.,0.,1.,3.,0.;");
    int b = iges_file_add(106, 12, 0, true, "106,2,3,0.,0.,5.,3.,0.,5.,3.,1.,5.;");
    rule(1, a, b, 0);
    ck_assert(iges_ruled_exact(side));
    ck_assert_double_le(rough, 0);
    for (int i = 0; i <= 8; i++) {
        double t = i / 4.0; /* 1: the corner */
        passes(t / 2, 0, t < 1 ? vec(t, 0, 0) : vec(1, 3 * (t - 1), 0));
        passes(t / 2, 1, t < 1 ? vec(3 * t, 0, 5) : vec(3, t - 1, 5));
    }
}
END_TEST

/* The second curve runs the other way. */
START_TEST(backwards)
{
    for (int form = 0; form <= 1; form++) {
        again();
        int a = iges_file_add(106, 12, 0, true, "106,2,3,0.,0.,0.,1.,0.,0.,1.,3.,0.;");
        int b = iges_file_add(106, 12, 0, true, "106,2,3,3.,1.,5.,3.,0.,5.,0.,0.,5.;");
        rule(form, a, b, 1);
        ck_assert_int_eq(iges_ruled_exact(side), form == 1);
        passes(0, 1, vec(0, 0, 5));
        passes(1, 1, vec(3, 1, 5));
        passes(0.5, 1, form == 0 ? vec(2, 0, 5) : vec(3, 0, 5));
        passes(0.25, 1, form == 0 ? vec(1, 0, 5) : vec(1.5, 0, 5));
        passes(0.25, 0, form == 0 ? vec(1, 0, 0) : vec(0.5, 0, 0));
    }
}
END_TEST

/* A half circle and a line: lengths and angles grow alike, a NURBS arc's parameter with neither. */
START_TEST(arc_and_line)
{
    for (int form = 0; form <= 1; form++) {
        again();
        int a = iges_file_add(100, 0, 0, true, "100,0.,0.,0.,5.,0.,-5.,0.;");
        int b = iges_file_add(110, 0, 0, true, "110,5.,0.,8.,-5.,0.,8.;");
        rule(form, a, b, 0);
        ck_assert(!iges_ruled_exact(side));
        for (int i = 0; i <= 12; i++) {
            double part = i / 12.0, angle = PI * part;
            passes(part, 0, vec(5 * cos(angle), 5 * sin(angle), 0));
            passes(part, 1, vec(5 - 10 * part, 0, 8));
        }
        ck_assert_double_lt(rough, 1e-5);
        /* and the NURBS' parameters of the arc: two quarters, each symmetrical */
        ck_assert_double_eq_tol(iges_ruled_own(&side[0], 0.25), 0.25, 1e-9);
        ck_assert_double_eq_tol(iges_ruled_own(&side[0], 0.5), 0.5, 1e-9);
        ck_assert_double_gt(fabs(iges_ruled_own(&side[0], 0.125) - 0.125), 1e-3);
        ck_assert_double_eq_tol(iges_ruled_own(&side[1], 0.125), 0.125, 1e-9);
    }
}
END_TEST

/* Two arcs of one angle are a surface without approximation, by either rule. */
START_TEST(two_arcs)
{
    for (int form = 0; form <= 1; form++) {
        again();
        int a = iges_file_add(100, 0, 0, true, "100,0.,0.,0.,5.,0.,0.,5.;");
        int b = iges_file_add(100, 0, 0, true, "100,4.,0.,0.,3.,0.,0.,3.;");
        rule(form, a, b, 0);
        ck_assert(iges_ruled_exact(side));
        ck_assert_double_le(rough, 0);
        for (int i = 0; i <= 12; i++) {
            struct uv at = {surface.u.from + (surface.u.to - surface.u.from) * i / 12.0,
                            (surface.v.from + surface.v.to) / 2};
            struct vec3 p = nurbs_point(&surface, at);
            ck_assert_double_eq_tol(hypot(p.x, p.y), 8, 1e-9); /* twice the mean of 5 and 3 */
            ck_assert_double_eq_tol(p.z, 4, 1e-9);
        }
    }
}
END_TEST

/* What is no curve is told by the return, a pointer to nothing by an error. */
START_TEST(no_curves)
{
    int a = iges_file_add(110, 0, 0, true, "110,0.,0.,0.,4.,0.,0.;");
    int point = iges_file_add(116, 0, 0, true, "116,0.,0.,0.;");
    int number = iges_file_format(118, 0, 0, false, "118,%d,%d,0,0;", a, point);
    int none = iges_file_add(118, 0, 0, false, "118,1,99,0,0;");
    iges_file_read();
    ck_assert_int_eq(iges_ruled_read(&iges, iges_entity(&iges, number), side, &error), 1);
    iges_ruled_free(side);
    ck_assert_int_eq(iges_ruled_read(&iges, iges_entity(&iges, none), side, &error), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_ruled");
    TCase *tests = tcase_create("iges_ruled");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, by_length);
    tcase_add_test(tests, by_parameter);
    tcase_add_test(tests, backwards);
    tcase_add_test(tests, arc_and_line);
    tcase_add_test(tests, two_arcs);
    tcase_add_test(tests, no_curves);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/*
 * check_iges_parameters - the angle along a NURBS arc against sine and cosine, for every span of a
 * turn, at its ends and back.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "iges_files.h"
#include "io/nurbs/iges_parameters.h"
#include "io/nurbs/surfaces.h"
#include "math/elementary.h"

/* A circle of radius 2 about (3, 1) from angle 0 on, in spans of `step` radians each, parameters
 * `low` .. `high` in all. */
static struct nurbs_curve arc(int spans, double step, double low, double high)
{
    size_t poles = 2 * (size_t)spans + 1;
    struct nurbs_curve c = {.t = {.degree = 2, .poles = poles, .from = low, .to = high}};
    c.t.knot = mem_alloc(poles + 3, sizeof *c.t.knot);
    c.pole = mem_alloc(poles, sizeof *c.pole);
    for (size_t i = 0; i < poles + 3; i++) {
        double at = i < 3 ? 0 : i >= poles ? spans : (double)((i - 1) / 2);
        c.t.knot[i] = low + (high - low) * at / spans;
    }
    for (size_t i = 0; i < poles; i++) {
        double w = i % 2 ? cos(step / 2) : 1, r = 2 / w, a = step * (double)i / 2;
        c.pole[i] = (struct nurbs_pole){w * (3 + r * cos(a)), w * (1 + r * sin(a)), 0, w};
    }
    return c;
}

START_TEST(angles_are_those_of_the_circle)
{
    static const struct {
        int spans;
        double step;
    } of[] = {{1, PI / 2}, {4, PI / 2}, {3, 2 * PI / 3}, {2, 0.01}, {5, 1.1}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        double all = of[k].spans * of[k].step, begin = 0.7;
        struct nurbs_curve c = arc(of[k].spans, of[k].step, -1, 5);
        struct iges_range r = {begin, begin + all, true};
        for (int i = 0; i <= 24 * of[k].spans; i++) {
            double turn = all * i / (24 * of[k].spans);
            double own = iges_parameter(&c, &r, begin + turn);
            struct vec3 p = nurbs_curve_point(&c, own);
            double off = vec_distance(p, vec(3 + 2 * cos(turn), 1 + 2 * sin(turn), 0));
            ck_assert_msg(off < 1e-12, "%d spans, %g of %g: %g", of[k].spans, turn, all, off);
            ck_assert_double_eq_tol(iges_parameter_back(&c, &r, own), begin + turn, 1e-12);
        }
        nurbs_curve_free(&c);
    }
}
END_TEST

/* The curve's own parameter grows evenly where the file says so; beyond the range is its end. */
START_TEST(even_parameters_and_beyond)
{
    struct nurbs_curve c = arc(2, 1, 10, 14);
    struct iges_range even = {-1, 1, false}, angle = {0, 2, true};
    for (int i = 0; i <= 8; i++) {
        double t = -1 + i / 4.0;
        ck_assert_double_eq(iges_parameter(&c, &even, t), 10 + 2 * (t + 1));
        ck_assert_double_eq(iges_parameter_back(&c, &even, 10 + 2 * (t + 1)), t);
    }
    ck_assert_double_eq(iges_parameter(&c, &even, -3), 10);
    ck_assert_double_eq(iges_parameter(&c, &even, 3), 14);
    ck_assert_double_eq_tol(iges_parameter(&c, &angle, -3), 10, 1e-12);
    ck_assert_double_eq_tol(iges_parameter(&c, &angle, 3), 14, 1e-12);
    nurbs_curve_free(&c);
}
END_TEST

/* A parameter where two curves meet is on the first of them. */
START_TEST(the_curve_that_a_parameter_is_on)
{
    struct iges_range item[] = {{0, 1, false}, {1, 1.5, false}, {1.5, 4, false}};
    struct iges_ranges ranges = {3, 3, item};
    static const struct {
        double t;
        size_t on;
    } at[] = {{-1, 0}, {0, 0}, {1, 0}, {1.0000001, 1}, {1.5, 1}, {1.6, 2}, {4, 2}, {9, 2}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        ck_assert_uint_eq(iges_range_of(&ranges, at[i].t), at[i].on);
}
END_TEST

/* A line, a polygon whose own parameter runs from 2 to 5, and a line: at t of 0 to 5. */
static struct vec3 on_directrix(double t)
{
    if (t <= 1)
        return vec(10 * t, 0, 0);
    if (t <= 2)
        return vec(10 * t, 5 * (t - 1), 0);
    return t <= 4 ? vec(20 + 5 * (t - 2), 5 - 2.5 * (t - 2), 0) : vec(30 + 10 * (t - 4), 0, 0);
}

/* A tabulated cylinder, 8 mm high, over these, trimmed by a triangle in its parameters (IGES 5.3,
 * 4.28): u is 0 to 1 over the whole directrix, whatever the range of its curves, and v the height.
 */
START_TEST(a_triangle_on_a_tabulated_cylinder)
{
    static const double corner[4][2] = {{0.04, 0.1}, {0.98, 0.3}, {0.5, 0.9}, {0.04, 0.1}};
    struct patches patches = {0};
    struct surfaces_unit unit;
    int side[3], part[3];
    iges_file_begin();
    part[0] = iges_file_add(110, 0, 0, true, "110,0.,0.,0.,10.,0.,0.;");
    part[1] = iges_file_add(126, 0, 0, true,
                            "126,2,1,0,0,1,0,2.,2.,3.,5.,5.,1.,1.,1.,10.,0.,0.,20.,5.,0.,30.,0.,0."
                            ",2.,5.,0.,0.,1.;");
    part[2] = iges_file_add(110, 0, 0, true, "110,30.,0.,0.,40.,0.,0.;");
    int along = iges_file_format(102, 0, 0, true, "102,3,%d,%d,%d;", part[0], part[1], part[2]);
    int surface = iges_file_format(122, 0, 0, true, "122,%d,0.,0.,8.;", along);
    for (int i = 0; i < 3; i++)
        side[i] = iges_file_format(110, 0, 0, true, "110,%g,%g,0.,%g,%g,0.;", corner[i][0],
                                   corner[i][1], corner[i + 1][0], corner[i + 1][1]);
    int loop = iges_file_format(102, 0, 0, true, "102,3,%d,%d,%d;", side[0], side[1], side[2]);
    int border = iges_file_format(142, 0, 0, true, "142,0,%d,%d,0,1;", surface, loop);
    iges_file_format(144, 0, 0, false, "144,%d,1,0,%d;", surface, border);
    iges_file_read();
    ck_assert_msg(surfaces_read(scratch_name(), 0, &patches, &unit, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(patches.n, 1);
    const struct patch *p = &patches.item[0];
    ck_assert_uint_eq(p->loop.n, 1);
    ck_assert(!p->loop.item[0].space);
    size_t i = 0; /* side */
    for (size_t k = 0; k < p->loop.item[0].n; k++) {
        const struct nurbs_curve *c = &p->loop.item[0].item[k];
        for (int j = 0; j <= 50; j++) {
            struct vec3 at = nurbs_curve_point(c, c->t.from + (c->t.to - c->t.from) * j / 50);
            struct vec3 q = nurbs_point(&p->surface, (struct uv){at.x, at.y});
            const double *a = corner[i], *b = corner[i + 1];
            double u = a[0] + (b[0] - a[0]) * (q.z / 8 - a[1]) / (b[1] - a[1]);
            struct vec3 want = on_directrix(5 * u);
            want.z = q.z;
            ck_assert_msg(vec_distance(q, want) < 1e-6, "side %zu: %g %g %g", i, q.x, q.y, q.z);
            if (j == 50 && i < 2 && fabs(q.z - 8 * b[1]) < 1e-6)
                i++;
        }
    }
    ck_assert_uint_eq(i, 2);
    patches_free(&patches);
    iges_file_end();
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_parameters");
    TCase *tests = tcase_create("iges_parameters");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, angles_are_those_of_the_circle);
    tcase_add_test(tests, even_parameters_and_beyond);
    tcase_add_test(tests, the_curve_that_a_parameter_is_on);
    tcase_add_test(tests, a_triangle_on_a_tabulated_cylinder);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

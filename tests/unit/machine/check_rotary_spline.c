/* rotary_spline: angles that are polynomials come back exactly; others within what the knots
 * allow. */
#include <check.h>
#include <stdlib.h>

#include "machine/rotary_spline.h"

static struct kinematic_chain table_ac(double min, double max)
{
    return (struct kinematic_chain){
        .n = 2,
        .master = 1,
        .tool = {0, 0, 1},
        .rotary = {{{0, 0, 1}, {0, 0, 0}, true, -99, 99}, {{1, 0, 0}, {0, 0, 0}, true, min, max}}};
}

/* Tip on x at constant speed, the head swinging through the plane y z: tan A = -(a + b u). */
static struct bspline swinging(size_t poles, double a, double b)
{
    struct bspline c = bspline_new(3, poles, true);
    for (size_t i = 0; i < poles + 4; i++)
        c.knot[i] = i < 4 ? 0 : i >= poles ? (double)(poles - 3) : (double)(i - 3);
    for (size_t i = 0; i < poles; i++) { /* Greville: a straight line at constant speed */
        double u = (c.knot[i + 1] + c.knot[i + 2] + c.knot[i + 3]) / 3;
        c.pole[i] = vec(u, 0, 0);
        c.head[i] = vec(u, 10 * (a + b * u), 10);
    }
    c.length = 10;
    return c;
}

static double angle_at(const struct bspline *c, const double *pole, double u)
{
    double basis[4], q = 0;
    size_t span = bspline_span(3, c->poles, c->knot, u);
    bspline_basis(3, c->knot, span, u, basis);
    for (size_t i = 0; i < 4; i++)
        q += basis[i] * pole[span - 3 + i]; // cppcheck-suppress uninitvar
    return q;
}

/* Worst difference from A = -atan(a + b u), C = 0. */
static double worst(size_t poles, double a, double b)
{
    struct kinematic_chain chain = table_ac(-2, 2);
    struct bspline c = swinging(poles, a, b);
    double range = (double)(poles - 3), off = 0, pole0[40], pole1[40];
    double *pole[2] = {pole0, pole1};
    const double from[2] = {0, -atan(a)};
    struct pose start = {c.pole[0], {0, 0, 1}};
    struct motion m = motion_spline(start, start, &c);
    int over;
    ck_assert_int_eq(rotary_spline_fit(&chain, &m, from, pole, &over), 0);
    ck_assert_double_eq(pole1[0], from[1]);
    ck_assert_double_eq_tol(pole1[poles - 1], -atan(a + b * range), 1e-12);
    for (int i = 0; i <= 200; i++) {
        double u = range * i / 200;
        off = fmax(off, fabs(angle_at(&c, pole1, u) + atan(a + b * u)));
        off = fmax(off, fabs(angle_at(&c, pole0, u)));
    }
    bspline_free(&c);
    return off;
}

START_TEST(constant_angles)
{
    ck_assert_double_lt(worst(4, 0.3, 0), 1e-12);
    ck_assert_double_lt(worst(12, 0.3, 0), 1e-12);
}
END_TEST

/* The error of cubic splines goes with the fourth power of the knot distance. */
START_TEST(fourth_order)
{
    double coarse = worst(8, 0.2, 0.2), fine = worst(13, 0.2, 0.1);
    ck_assert_double_lt(coarse, 1e-3);
    ck_assert_double_lt(fine, coarse / 8);
}
END_TEST

START_TEST(out_of_travel)
{
    struct kinematic_chain chain = table_ac(-0.4, 0.3);
    struct bspline c = swinging(6, 0.2, 0.2);
    double pole0[6], pole1[6], *pole[2] = {pole0, pole1};
    const double from[2] = {0, -atan(0.2)};
    struct motion m =
        motion_spline((struct pose){c.pole[0], {0, 0, 1}}, (struct pose){c.pole[5], {0, 0, 1}}, &c);
    int over;
    ck_assert_int_eq(rotary_spline_fit(&chain, &m, from, pole, &over), -1);
    ck_assert_int_eq(over, 1);
    bspline_free(&c);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rotary_spline");
    TCase *tests = tcase_create("angles");

    tcase_add_test(tests, constant_angles);
    tcase_add_test(tests, fourth_order);
    tcase_add_test(tests, out_of_travel);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

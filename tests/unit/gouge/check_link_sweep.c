/* link_sweep: what of the tool is too deep on straight motions over a floor. */
#include "gouge/link_sweep.h"

#include <check.h>
#include <stdlib.h>

static const double R = 3;

static struct gouge_check *make_floor(void)
{
    struct vec3s points = {0};
    for (int i = -40; i <= 40; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(0.25 * i, 0.25 * k, 0);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

/* The deepest on a straight motion along x, at these heights of the ball's centre; 0: nothing. */
static double deepest(double from, double to, double shank)
{
    struct gouge_check *guard = make_floor();
    struct holder holder = {.n = shank > 0 ? 1 : 0};
    holder.part[0] = (struct holder_part){.low = shank, .high = shank, .length = 20};
    struct gouge_lift_options lift = {.guard = guard, .offset = R, .tolerance = 0.01};
    struct link_options options = {.lift = &lift, .holder = &holder, .radius = R};
    struct run_point a = {.ball = vec(-5, 0, from), .axis = vec(0, 0, 1)};
    struct run_point b = {.ball = vec(5, 0, to), .axis = vec(0, 0, 1)};
    struct link_sweep sweep = link_sweep_begin(&options);
    link_sweep_to(&sweep, &a, &b);
    double most = gouge_refit_beyond(&sweep.tool, &sweep.gouges).depth;
    link_sweep_end(&sweep);
    gouge_free(guard);
    return most;
}

START_TEST(what_is_too_deep_is_found)
{
    ck_assert_double_eq(deepest(R, R, 0), 0);
    ck_assert_double_eq(deepest(R - 0.009, R - 0.009, 0), 0); /* within the tolerance */
    ck_assert_double_eq_tol(deepest(R - 0.5, R - 0.5, 0), 0.5, 1e-6);
    ck_assert_double_eq_tol(deepest(R + 1, R - 0.5, 0), 0.5, 1e-6); /* at one end alone */
    ck_assert_double_eq(deepest(R + 1, R + 1, 8), 0);
    ck_assert_double_gt(deepest(-0.5, -0.5, 8), 0.4); /* a collar, from the centre on */
}
END_TEST

START_TEST(the_normal_leads_out_or_else_the_axis)
{
    struct run_point p = {.axis = vec(0, 0, 1)};

    ck_assert_double_eq(link_outward(&p).z, 1);
    p.normal = vec(1, 0, 0);
    ck_assert_double_eq(link_outward(&p).x, 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("link_sweep");
    TCase *tests = tcase_create("link_sweep");

    tcase_add_test(tests, what_is_too_deep_is_found);
    tcase_add_test(tests, the_normal_leads_out_or_else_the_axis);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

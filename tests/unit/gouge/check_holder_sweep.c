/* holder_sweep: a cylinder that passes a point, or turns past it, is clear if and only if its
 * distance, known in closed form, is. */
#include <check.h>
#include <stdlib.h>

#include "gouge/holder_sweep.h"

enum { LONG = 30 };

static const struct holder holder = {.n = 1, .part = {{2, 2, LONG}}};

static struct run_point at(struct vec3 ball, struct vec3 axis)
{
    return (struct run_point){.ball = ball, .axis = axis};
}

/* The upright cylinder goes along x past a point that is `off` beside its way. */
static bool passes(double off, double z, double slack)
{
    struct vec3 point = vec(0, off, z);
    struct gouge_check *guard = gouge_from_points(&point, 1);
    struct holder_sweep sweep = {guard, &holder, slack};
    struct run_point from = at(vec(-40, 0, 0), vec(0, 0, 1)), to = at(vec(37, 0, 0), vec(0, 0, 1));
    bool clear = holder_sweep_clear(&sweep, &from, &to);
    ck_assert_int_eq(
        clear, holder_sweep_clear_between(&sweep, &from, holder_sweep_clearance(&sweep, &from, 100),
                                          &to, holder_sweep_clearance(&sweep, &to, 100)));
    gouge_free(guard);
    return clear;
}

START_TEST(moves)
{
    ck_assert(passes(2.01, 10, 0));
    ck_assert(!passes(1.95, 10, 0));
    ck_assert(!passes(-1.5, 29, 0));
    ck_assert(passes(0, LONG + 0.01, 0));
    ck_assert(passes(0, -0.01, 0));
    /* as deep as is allowed, and deeper */
    ck_assert(passes(1.95, 10, 0.1));
    ck_assert(!passes(1.8, 10, 0.1));
}
END_TEST

/* About its ball's centre from -40 to 40 degrees in the plane of x and z: a point at the height 20
 * beside that plane is touched where it is nearer than the radius. */
START_TEST(turns)
{
    const double t = 40 * PI / 180;
    for (int i = 0; i < 8; i++) {
        double off = 1.6 + 0.1 * i;
        struct vec3 point = vec(0, off, 20);
        struct gouge_check *guard = gouge_from_points(&point, 1);
        struct holder_sweep sweep = {guard, &holder, 0};
        struct run_point from = at(vec(0, 0, 0), vec(-sin(t), 0, cos(t)));
        struct run_point to = at(vec(0, 0, 0), vec(sin(t), 0, cos(t)));
        if (fabs(off - 2) > 0.04)
            ck_assert_int_eq(holder_sweep_clear(&sweep, &from, &to), off > 2);
        gouge_free(guard);
    }
}
END_TEST

/* Distances: beside it, above its end, at an edge; no more than is asked. */
START_TEST(clearance)
{
    static const struct {
        struct vec3 p;
        double distance;
    } of[] = {{{5, 0, 10}, 3}, {{0, 0, LONG + 4}, 4}, {{5, 0, LONG + 4}, 5}, {{0, -1.5, 15}, -0.5}};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct gouge_check *guard = gouge_from_points(&of[i].p, 1);
        struct holder_sweep sweep = {guard, &holder, 0};
        struct run_point p = at(vec(0, 0, 0), vec(0, 0, 1));
        ck_assert_double_eq_tol(holder_sweep_clearance(&sweep, &p, 50), of[i].distance, 1e-9);
        ck_assert_double_le(holder_sweep_clearance(&sweep, &p, 1), 1);
        gouge_free(guard);
    }
}
END_TEST

START_TEST(no_holder)
{
    struct vec3 point = vec(0, 0, 10);
    struct gouge_check *guard = gouge_from_points(&point, 1);
    struct holder none = {.n = 0};
    struct holder_sweep sweep = {guard, &none, 0};
    struct run_point from = at(vec(-5, 0, 0), vec(0, 0, 1)), to = at(vec(5, 0, 0), vec(0, 0, 1));
    ck_assert(holder_sweep_clear(&sweep, &from, &to));
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("holder_sweep");
    TCase *tests = tcase_create("holder_sweep");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, moves);
    tcase_add_test(tests, turns);
    tcase_add_test(tests, clearance);
    tcase_add_test(tests, no_holder);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

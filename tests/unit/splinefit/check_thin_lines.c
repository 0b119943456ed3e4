/* Tests of thin_lines.h: what is left of points that stand too near to each other. */
#include "splinefit/thin_lines.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "curve/run.h"
#include "math/elementary.h"
#include "seed.h"

static const double LEAST = 0.021;

/* 4 mm of a circle of 5 mm whose points are `step` apart and up to `noise` off it, with an axis
 * that turns. */
static struct reference circle(double step, double noise)
{
    struct run run = {.radius = 3};
    uint64_t state = 4711;

    for (double s = 0; s <= 4; s += step) {
        state = state * 6364136223846793005u + seed_step();
        double r = 5 + noise * (2 * ((double)(state >> 11) / 9007199254740992.0) - 1);
        double lean = 0.1 + 0.02 * s;
        struct run_point p = {.tip = vec(r * cos(s / 5), r * sin(s / 5), 0),
                              .axis = vec(sin(lean), 0, cos(lean)),
                              .given = true};
        p.ball = vec_along(p.tip, run.radius, p.axis);
        *array_push(&run) = p;
    }
    struct reference t = reference_distinct(&run, false);
    array_free(&run);
    return t;
}

static double distance_to(const struct reference *t, struct vec3 p)
{
    double least = HUGE_VAL;

    for (size_t k = 0; k + 1 < t->n; k++)
        least = fmin(least, vec_segment_distance(t->point[k], t->point[k + 1], p));
    return least;
}

START_TEST(near_ones_go)
{
    static const struct deviation within = {0.0075, 0.0075, 0.02};
    struct deviation off;
    struct reference t = circle(0.003, 0.002), thin = thin_lines(&t, &within, LEAST, &off);
    double worst = 0;

    ck_assert(deviation_within(&off, &within));
    ck_assert_double_eq(vec_distance(thin.point[0], t.point[0]), 0);
    ck_assert_double_eq(vec_distance(thin.point[thin.n - 1], t.point[t.n - 1]), 0);
    for (size_t k = 1; k < thin.n; k++) {
        ck_assert_double_ge(vec_distance(thin.point[k - 1], thin.point[k]), LEAST);
        ck_assert_double_le(vec_distance(thin.point[k - 1], thin.point[k]), 3 * LEAST);
        ck_assert_double_gt(thin.length[k], thin.length[k - 1]);
    }
    for (size_t k = 0; k < t.n; k++)
        worst = fmax(worst, distance_to(&thin, t.point[k]));
    ck_assert_double_le(worst, off.point + 1e-12);
    reference_free(&thin);
    reference_free(&t);
}
END_TEST

START_TEST(others_stay)
{
    static const struct deviation within = {0.0075, 0.0075, 0.02}, none = {0, 0, 0};
    struct deviation off;
    struct reference far = circle(0.03, 0.002), thin = thin_lines(&far, &within, LEAST, &off);

    ck_assert_uint_eq(thin.n, far.n);
    reference_free(&thin);
    reference_free(&far);
    struct reference near = circle(0.003, 0.002); /* no room */
    thin = thin_lines(&near, &none, LEAST, &off);
    ck_assert_uint_eq(thin.n, near.n);
    ck_assert_double_eq(off.point, 0);
    reference_free(&thin);
    reference_free(&near);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("thin_lines");
    tcase_add_test(t, near_ones_go);
    tcase_add_test(t, others_stay);
    Suite *s = suite_create("thin_lines");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

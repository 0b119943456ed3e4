/*
 * knots_init: knots rise from end to end, equally or denser where the curve bends more.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/knots_init.h"

/* Straight at first, then waves. */
static struct target wavy(void)
{
    struct run run = {0};

    for (int k = 0; k <= 800; k++) {
        double x = k * 0.1, w = x > 40 ? x - 40 : 0;
        struct run_point p = {.tip = vec(x, 0.002 * w * w * sin(w / 2), 0), .axis = vec(0, 0, 1)};
        p.ball = p.tip;
        *array_push(&run) = p;
    }
    struct track track = track_new(&run, false);
    struct target target = target_new(&track, 400, 0.01, 0.02);
    track_free(&track);
    array_free(&run);
    return target;
}

static void rises(const struct target *t, const double *knot, int degree, size_t poles)
{
    size_t p = (size_t)degree;

    ck_assert(knot[p] == 0 && knot[poles] == t->at[t->n - 1] && knot[poles + p] == knot[poles]);
    for (size_t j = p + 1; j <= poles; j++)
        ck_assert_double_gt(knot[j], knot[j - 1]);
}

START_TEST(rising_from_end_to_end)
{
    struct target t = wavy();
    double knot[64];

    for (int degree = 2; degree <= 5; degree++)
        for (size_t poles = (size_t)degree + 1; poles < 40; poles += 4) {
            knots_init_uniform(&t, degree, poles, knot);
            rises(&t, knot, degree, poles);
            ck_assert(knots_init_spread(&t, degree, poles, knot));
            rises(&t, knot, degree, poles);
            knots_init_mean(&t, degree, poles, knot);
            rises(&t, knot, degree, poles);
        }
    ck_assert(!knots_init_spread(&t, 3, t.n, knot));
    target_free(&t);
}
END_TEST

START_TEST(denser_where_it_bends)
{
    struct target t = wavy();
    double knot[64], half = t.at[t.n - 1] / 2;
    int late = 0;

    knots_init_spread(&t, 3, 24, knot);
    for (int j = 4; j < 24; j++)
        late += knot[j] > half;
    ck_assert_int_ge(late, 15);
    target_free(&t);
}
END_TEST

START_TEST(a_knot_put_in_is_not_missed)
{
    struct bspline b = bspline_new(3, 6, false);
    double knot[] = {0, 0, 0, 0, 3, 7, 10, 10, 10, 10};

    for (size_t i = 0; i < 10; i++)
        b.knot[i] = knot[i];
    for (size_t i = 0; i < 6; i++)
        b.pole[i] = vec(2.0 * (double)i, i % 2 == 0 ? 3 : -2, 0);
    bspline_insert(&b, 5);
    ck_assert_double_lt(knots_init_missed(&b, 5), 1e-9 * knots_init_missed(&b, 4));
    bspline_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("knotstart");
    TCase *tests = tcase_create("knotstart");

    tcase_add_test(tests, rising_from_end_to_end);
    tcase_add_test(tests, denser_where_it_bends);
    tcase_add_test(tests, a_knot_put_in_is_not_missed);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

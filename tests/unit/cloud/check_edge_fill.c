/* edge_fill: both sides of a roof are filled up to its ridge, no place is beside them. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

START_TEST(up_to_the_ridge)
{
    struct edge_trial trial;
    struct edge_hood near;
    struct vec3s to = {0};

    edge_trial_make(&trial, edge_trial_roof, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        if (trial.work.flank[i].valid) {
            edge_hood_find(&trial.work, i, &near);
            edge_meet_add(&trial.work, &near, i, &trial.work.found[i]);
        }
    for (size_t i = 0; i < trial.grid.n; i++)
        if (trial.work.flank[i].valid) {
            edge_hood_find(&trial.work, i, &near);
            edge_fill_add(&trial.work, &near, i, &to);
        }
    for (size_t k = 0; k < to.n; k++) { /* beyond the ridge by a quarter of what is smooth */
        double over = to.item[k].z - edge_trial_roof(to.item[k].x, to.item[k].y);
        ck_assert_double_le(over, 0.02 * 0.6 / 4 * sqrt(2));
        ck_assert_double_ge(over, -1e-6);
    }
    /* 0.65 of 0.2 mm apart; what two points fill does not meet exactly */
    for (double x = -6; x <= 6; x += 0.17)
        for (double side = -0.4; side <= 0.4; side += 0.1) {
            struct vec3 at = vec(x - side / sqrt(17), x / 4 + 4 * side / sqrt(17), 10 - fabs(side));
            double least = HUGE_VAL;
            for (size_t k = 0; k < to.n; k++)
                least = fmin(least, vec_distance(at, to.item[k]));
            ck_assert_double_le(least, 0.2);
        }
    array_free(&to);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_fill");
    TCase *tests = tcase_create("edge_fill");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, up_to_the_ridge);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

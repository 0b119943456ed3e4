/* ridge: rolled over an edge the chords sink in by no more than the tolerance, and nearly that. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "toolpath/edge_roll.h"

START_TEST(chords_sink_as_told)
{
    for (double angle = 5; angle <= 120; angle += 5) {
        const double radius = 4, tolerance = 0.01;
        struct contacts to = {0};
        struct contact last = {{0, 0, 0}, {0, 0, 1}}, next = last;
        next.n = vec(sin(RADIANS(angle)), 0, cos(RADIANS(angle)));
        *array_push(&to) = last;
        edge_roll(&to, vec(1, 0, 0), last, next, radius, tolerance);
        *array_push(&to) = next;
        for (size_t i = 1; i < to.n; i++) {
            double turn = vec_angle(to.item[i - 1].n, to.item[i].n);
            ck_assert_double_le(radius * (1 - cos(turn / 2)), tolerance + 1e-9);
        }
        ck_assert_double_lt((double)to.n - 2, RADIANS(angle) / (2 * acos(1 - tolerance / radius)));
        array_free(&to);
    }
}
END_TEST

START_TEST(none_in_a_valley)
{
    struct contacts to = {0};
    struct contact last = {{0, 0, 0}, {0.6, 0, 0.8}}, next = {{0, 0, 0}, {-0.6, 0, 0.8}};
    edge_roll(&to, vec(1, 0, 0), last, next, 4, 0.01);
    ck_assert_uint_eq(to.n, 0);
    edge_roll(&to, vec(-1, 0, 0), last, next, 4, 0.01);
    ck_assert_uint_gt(to.n, 5);
    array_free(&to);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ridge");
    TCase *tests = tcase_create("ridge");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, chords_sink_as_told);
    tcase_add_test(tests, none_in_a_valley);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

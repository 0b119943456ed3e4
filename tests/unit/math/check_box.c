/* check_box - boxes that grow, and how far places are from them. */
#include <check.h>
#include <stdlib.h>

#include "math/box.h"

START_TEST(boxes)
{
    struct box a = box_empty(), b = box_empty();
    ck_assert_double_eq(box_diagonal(&a), 0);
    box_join(&a, &b);
    ck_assert_double_eq(box_diagonal(&a), 0);
    box_add(&b, vec(1, 1, 1));
    box_add(&b, vec(4, 5, 1));
    box_join(&a, &b);
    ck_assert_double_eq_tol(box_diagonal(&a), 5, 1e-15);
    ck_assert_double_eq(a.low.y, 1);
    ck_assert_double_eq(a.high.y, 5);
}
END_TEST

/* Beside a face, an edge and a corner of the box; inside; from an empty one. */
START_TEST(distances)
{
    struct box box = {{1, 2, 3}, {5, 6, 7}}, empty = box_empty();
    ck_assert_double_eq(box_distance2(&box, vec(3, 4, 5)), 0);
    ck_assert_double_eq(box_distance2(&box, vec(5, 2, 7)), 0);
    ck_assert_double_eq(box_distance2(&box, vec(-1, 4, 5)), 4);
    ck_assert_double_eq(box_distance2(&box, vec(8, 4, 5)), 9);
    ck_assert_double_eq(box_distance2(&box, vec(3, -1, 11)), 9 + 16);
    ck_assert_double_eq(box_distance2(&box, vec(6, 8, 0)), 1 + 4 + 9);
    ck_assert(isinf(box_distance2(&empty, vec(0, 0, 0))));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("box");
    TCase *tests = tcase_create("box");
    tcase_add_test(tests, boxes);
    tcase_add_test(tests, distances);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

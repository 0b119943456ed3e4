/*
 * check_segment_tree - the nearest of many segments against all of them; whether a point lies among
 * them, by what is known of a patch of passes.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/segment_tree.h"

static double random_in(unsigned *state, double low, double high)
{
    *state = *state * 1664525u + 1013904223u;
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

START_TEST(nearest)
{
    unsigned state = 3;
    struct centre_path path = {0};
    struct vec3 from = vec(0, 0, 0);
    for (int i = 0; i < 3000; i++) {
        struct vec3 to = vec_add(from, vec(random_in(&state, -1, 1), random_in(&state, -1, 1),
                                           random_in(&state, -0.3, 0.3)));
        *array_push(&path) = (struct centre_segment){from, to, {0, 1}, 0, true};
        from = to;
    }
    struct segment_tree *tree = segment_tree_new(&path);
    size_t hint = SIZE_MAX, found = 0;
    for (int i = 0; i < 400; i++) {
        struct vec3 p =
            vec_add(path.item[i * 7].a, vec(random_in(&state, -6, 6), random_in(&state, -6, 6), 1));
        double within = random_in(&state, 0.5, 6), best = within;
        for (size_t k = 0; k < path.n; k++)
            best = fmin(best, vec_distance(centre_segment_nearest(&path.item[k], p), p));
        double distance = segment_tree_nearest(tree, p, within, &hint);
        ck_assert_double_eq_tol(distance, best, 1e-12);
        if (distance < within) {
            struct vec3 q = centre_segment_nearest(&path.item[hint], p);
            ck_assert_double_eq_tol(vec_distance(q, p), best, 1e-12);
            found++;
        }
    }
    ck_assert(found > 100 && found < 400);
    segment_tree_free(tree);
    array_free(&path);
}
END_TEST

/* Passes along x, 1 mm apart, from -10 to 10 both ways, turned about Z, 5 over the points. */
START_TEST(among_passes)
{
    double turn = _i * 0.37, c = cos(turn), s = sin(turn);
    struct centre_path path = {0};
    for (int row = -10; row <= 10; row++)
        for (int k = -20; k < 20; k++) {
            double x0 = k * 0.5, x1 = x0 + 0.5, y = row;
            struct vec3 a = vec(c * x0 - s * y, s * x0 + c * y, 5);
            struct vec3 b = vec(c * x1 - s * y, s * x1 + c * y, 5);
            *array_push(&path) = (struct centre_segment){a, b, {0, 1}, 0, true};
        }
    struct segment_tree *tree = segment_tree_new(&path);
    struct vec3 up = vec(0, 0, 1);
    for (double x = -13; x <= 13; x += 0.37)
        for (double y = -13; y <= 13; y += 0.41) {
            struct vec3 p = vec(c * x - s * y, s * x + c * y, 0);
            double out = fmax(fabs(x), fabs(y)) - 10;
            bool around = segment_tree_surrounds(tree, p, up, 5.5);
            if (out < -2.3) /* they are seen 2.29 around it */
                ck_assert(around);
            if (out > 0.6)
                ck_assert(!around);
        }
    segment_tree_free(tree);
    array_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("balltree");
    TCase *tcase = tcase_create("balltree");
    tcase_add_test(tcase, nearest);
    tcase_add_loop_test(tcase, among_passes, 0, 17);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* kdnodes: each point once, halves on their sides, boxes around what is under them. */
#include <check.h>
#include <stdlib.h>
#include <stdint.h>

#include "math/kdnodes.h"

enum { MOST = 3000 };

static uint64_t state = 5;

static double uniform(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) / 9007199254740992.0;
}

/* Looks at a node and all under it. */
static void look(const struct kdtree *tree, size_t from, size_t to, size_t number)
{
    size_t middle = from + (to - from) / 2;
    const struct kd_box *box = &tree->box[number];

    for (size_t i = from; i < to; i++)
        ck_assert_double_eq(kd_gap2(box, tree->point[i].c), 0);
    for (int d = 0; from < to && d < 3; d++) { /* no wider than it has to be */
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = from; i < to; i++) {
            low = fmin(low, tree->point[i].c[d]);
            high = fmax(high, tree->point[i].c[d]);
        }
        ck_assert(low == box->low[d] && high == box->high[d]);
    }
    if (to - from <= KD_LEAF)
        return;
    int axis = tree->axis[middle];
    for (size_t i = from; i < to; i++) {
        double off = tree->point[i].c[axis] - tree->point[middle].c[axis];
        ck_assert(i < middle ? off <= 0 : off >= 0);
    }
    look(tree, from, middle, 2 * number);
    look(tree, middle + 1, to, 2 * number + 1);
}

START_TEST(nodes_part_the_points)
{
    static const size_t sizes[] = {1, 12, 13, 14, 27, 500, MOST};
    static struct vec3 point[MOST];

    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        static int seen[MOST];
        size_t n = sizes[s];
        for (size_t i = 0; i < n; i++) {
            point[i] = vec(10 * uniform(), floor(5 * uniform()), uniform());
            seen[i] = 0;
        }
        struct kdtree *tree = kdnodes_build(point, n, 1);
        ck_assert_uint_eq(tree->n, n);
        for (size_t i = 0; i < n; i++) {
            const struct kd_point *p = &tree->point[i];
            ck_assert_int_eq(seen[p->index]++, 0);
            ck_assert(p->c[0] == point[p->index].x && p->c[2] == point[p->index].z);
        }
        look(tree, 0, n, 1);
        kdnodes_free(tree);
    }
}
END_TEST

START_TEST(gaps_are_to_the_nearest_of_the_box)
{
    struct kd_box box = {{0, 1, 2}, {1, 3, 5}};

    ck_assert_double_eq(kd_gap2(&box, (double[]){0.5, 2, 3}), 0);
    ck_assert_double_eq(kd_gap2(&box, (double[]){-3, 2, 9}), 25);
    ck_assert_double_eq(kd_gap2(&box, (double[]){2, 0, 0}), 6);
    ck_assert_double_eq(kd_distance2((double[]){1, 2, 3}, (double[]){3, 5, 9}), 49);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("kdnodes");
    TCase *tests = tcase_create("kdnodes");
    SRunner *runner = srunner_create(suite);

    tcase_add_test(tests, nodes_part_the_points);
    tcase_add_test(tests, gaps_are_to_the_nearest_of_the_box);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* Tests of facet_tree.h: against looking at every facet, and against known distances. */
#include "math/facet_tree.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"

static unsigned long state = 7;

static double random_to(double most)
{
    state = (state * 1103515245 + 12345) % 2147483648UL;
    return most * (double)state / 2147483648.0;
}

static struct vec3 random_point(double most)
{
    double x = random_to(most), y = random_to(most);
    return vec(x, y, random_to(most));
}

START_TEST(the_nearest_point_of_a_facet)
{
    struct facet f = {{vec(0, 0, 0), vec(4, 0, 0), vec(0, 3, 0)}};
    const struct {
        struct vec3 p, nearest;
    } row[] = {
        {{1, 1, 5}, {1, 1, 0}},   {{-1, -1, 2}, {0, 0, 0}}, {{2, -3, 0}, {2, 0, 0}},
        {{9, -1, 1}, {4, 0, 0}},  {{-2, 1, 0}, {0, 1, 0}},  {{5, 5, 0}, {2.24, 1.32, 0}},
        {{-1, 9, -4}, {0, 3, 0}},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        ck_assert_double_lt(vec_distance(facet_nearest(&f, row[i].p), row[i].nearest), 1e-12);
    struct facet straight = {{vec(1, 1, 1), vec(5, 1, 1), vec(5, 1, 1)}};
    ck_assert_double_lt(vec_distance(facet_nearest(&straight, vec(3, 4, 5)), vec(3, 1, 1)), 1e-12);
    struct facet point = {{vec(1, 2, 3), vec(1, 2, 3), vec(1, 2, 3)}};
    ck_assert_double_lt(vec_distance(facet_nearest(&point, vec(9, 9, 9)), vec(1, 2, 3)), 1e-12);
}
END_TEST

/* Facets, straight pieces and points, many of them at the same places. */
START_TEST(it_finds_what_looking_at_all_finds)
{
    for (size_t n = 0; n < 400; n = 3 * n / 2 + 1) {
        struct facets facets = {0};
        for (size_t i = 0; i < n; i++) {
            struct vec3 a = i % 5 ? random_point(10) : vec(5, 5, 5);
            struct vec3 b = i % 3 ? vec_add(a, random_point(2)) : a;
            struct vec3 c = i % 2 ? vec_add(a, random_point(2)) : b;
            *array_push(&facets) = (struct facet){{a, b, c}};
        }
        struct facet_tree *tree = facet_tree_new(&facets);
        for (int k = 0; k < 200; k++) {
            struct vec3 p = random_point(14);
            double best = HUGE_VAL;
            for (size_t i = 0; i < n; i++)
                best = fmin(best, vec_distance(p, facet_nearest(&facets.item[i], p)));
            double found = facet_tree_distance(tree, p);
            ck_assert(found <= best && found >= best);
        }
        facet_tree_free(tree);
        array_free(&facets);
    }
}
END_TEST

START_TEST(many_at_one_place)
{
    struct facets facets = {0};
    for (int i = 0; i < 5000; i++)
        *array_push(&facets) = (struct facet){{vec(1, 1, 1), vec(1, 1, 1), vec(1, 1, 1)}};
    struct facet_tree *tree = facet_tree_new(&facets);
    ck_assert_double_eq_tol(facet_tree_distance(tree, vec(1, 1, 4)), 3, 1e-12);
    facet_tree_free(tree);
    array_free(&facets);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("facetree");
    tcase_add_test(t, the_nearest_point_of_a_facet);
    tcase_add_test(t, it_finds_what_looking_at_all_finds);
    tcase_add_test(t, many_at_one_place);
    Suite *s = suite_create("facetree");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

/* Tests of box_tree.h: against a search of every item, and against known distances. */
#include "math/box_tree.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "seed.h"

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
        struct box_tree *tree = facets_tree(&facets);
        for (int k = 0; k < 200; k++) {
            struct vec3 p = random_point(14);
            double best = HUGE_VAL;
            for (size_t i = 0; i < n; i++)
                best = fmin(best, vec_distance(p, facet_nearest(&facets.item[i], p)));
            double found = facets_distance(tree, &facets, p);
            ck_assert(found <= best && found >= best);
        }
        box_tree_free(tree);
        array_free(&facets);
    }
}
END_TEST

START_TEST(many_at_one_place)
{
    struct facets facets = {0};
    for (int i = 0; i < 5000; i++)
        *array_push(&facets) = (struct facet){{vec(1, 1, 1), vec(1, 1, 1), vec(1, 1, 1)}};
    struct box_tree *tree = facets_tree(&facets);
    ck_assert_double_eq_tol(facets_distance(tree, &facets, vec(1, 1, 4)), 3, 1e-12);
    box_tree_free(tree);
    array_free(&facets);
}
END_TEST

static double segment_distance2(const void *items, size_t item, struct vec3 p)
{
    const struct vec3 *node = items;
    struct vec3 d = vec_sub(vec_segment_nearest(node[item], node[item + 1], p), p);
    return vec_dot(d, d);
}

/* Marks an item, and goes on. */
static bool mark(void *context, size_t item)
{
    bool *marked = context;
    marked[item] = true;
    return false;
}

/* The pieces of a chain, each known by its box alone; with a hint, and no further than `within`. */
START_TEST(items_of_any_kind)
{
    enum { N = 3000 };
    struct vec3 node[N + 1] = {{0, 0, 0}};
    struct box box[N];
    for (size_t i = 0; i < N; i++) {
        struct vec3 step = vec_sub(random_point(2), vec(1, 1, 1));
        node[i + 1] = vec_add(node[i], step);
        box[i] = box_empty();
        box_add(&box[i], node[i]);
        box_add(&box[i], node[i + 1]);
    }
    struct box_tree *tree = box_tree_new(box, N);
    size_t hint = N, found = 0;
    for (size_t i = 0; i < 400; i++) {
        struct vec3 p = vec_add(node[i * 7], vec_sub(random_point(12), vec(6, 6, 6)));
        double within = 0.5 + random_to(6), best = within * within;
        size_t first = N, missed = 0;
        bool marked[N] = {false};
        box_tree_each(tree, p, within, mark, marked);
        for (size_t k = 0; k < N; k++) {
            double d2 = segment_distance2(node, k, p);
            first = d2 < best ? k : first;
            best = fmin(best, d2);
            missed += !marked[k] && d2 <= within * within;
        }
        ck_assert_uint_eq(missed, 0);
        double distance = box_tree_nearest(tree, node, segment_distance2, p, within, &hint);
        ck_assert(distance >= sqrt(best) && distance <= sqrt(best));
        if (distance < within) {
            ck_assert_uint_eq(hint, first);
            found++;
        }
    }
    ck_assert(found > 50 && found < 400);
    box_tree_free(tree);
}
END_TEST

/* Of items that are alike the first is found, and a visit may end the search. */
static bool stop(void *context, size_t item)
{
    *(size_t *)context = item;
    return true;
}

START_TEST(the_first_of_equals)
{
    struct vec3 node[1001] = {{0, 0, 0}};
    struct box box[1000] = {{{0, 0, 0}, {0, 0, 0}}};
    struct box_tree *tree = box_tree_new(box, 1000);
    size_t nearest = 700, seen = 1000;
    double d = box_tree_nearest(tree, node, segment_distance2, vec(3, 0, 0), 10, &nearest);
    ck_assert_double_eq_tol(d, 3, 1e-15);
    ck_assert_uint_eq(nearest, 0);
    ck_assert(box_tree_each(tree, vec(3, 0, 0), 4, stop, &seen) && seen < 1000);
    ck_assert(!box_tree_each(tree, vec(3, 0, 0), 2, stop, &seen));
    box_tree_free(tree);
}
END_TEST

int main(void)
{
    state = seed_begin(state);
    TCase *t = tcase_create("box_tree");
    tcase_add_test(t, the_nearest_point_of_a_facet);
    tcase_add_test(t, it_finds_what_looking_at_all_finds);
    tcase_add_test(t, many_at_one_place);
    tcase_add_test(t, items_of_any_kind);
    tcase_add_test(t, the_first_of_equals);
    Suite *s = suite_create("box_tree");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

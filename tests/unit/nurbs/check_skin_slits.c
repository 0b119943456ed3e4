/*
 * check_skin_slits - open loops are filled, no wider than the gap, and never so that an edge gets
 * more than two facets.
 */
#include <check.h>

#include "facets.h"
#include "nurbs/skin_sides.h"
#include "nurbs/skin_slits.h"

/* How many edges have one facet, and more than two. */
static void count_edges(const struct patch_mesh *q, size_t *open, size_t *many)
{
    size_t n;
    struct skin_side *side = skin_sides_find(q, &n);
    *open = *many = 0;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        *open += k == 1;
        *many += k > 2;
    }
    free(side);
}

/* A pyramid without its base of 0.01 x 10; below the base a tetrahedron on each of the diagonals
 * that `tents` says, so that the diagonal is an edge already. */
static struct patch_mesh pyramid(int tents)
{
    const struct vec3 at[9] = {vec(0, 0, 0),    vec(10, 0, 0),  vec(10, 0.01, 0),
                               vec(0, 0.01, 0), vec(5, 0, 5),   vec(4, -1, -5),
                               vec(6, 1, -5),   vec(4, -1, -9), vec(6, 1, -9)};
    const int corner[12][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 5}, {2, 0, 6},
                               {0, 5, 6}, {2, 6, 5}, {1, 3, 7}, {3, 1, 8}, {1, 7, 8}, {3, 8, 7}};
    return facets_skin(at, 9, corner, 4 + 4 * (size_t)tents);
}

static void fill(struct patch_mesh *q, double gap, bool avoid, struct skin_close_count *count)
{
    const struct skin_slits_options how = {.gap = gap, .avoid = avoid};
    *count = (struct skin_close_count){0};
    skin_fill_slits(q, &how, count);
}

START_TEST(a_narrow_base_is_filled)
{
    size_t open, many;
    struct skin_close_count count;
    struct patch_mesh q = pyramid(0);
    fill(&q, 0.001, true, &count);
    ck_assert_uint_eq(count.filled, 0);
    fill(&q, 0.02, true, &count);
    count_edges(&q, &open, &many);
    ck_assert_uint_eq(count.filled, 1);
    ck_assert_uint_eq(count.facets, 2);
    ck_assert_double_le(count.width, 0.01 + 1e-12);
    ck_assert_uint_eq(open + many, 0);
    patch_mesh_free(&q);
}
END_TEST

/* Where one diagonal is an edge, the other is taken; where both are, a vertex in the middle. */
START_TEST(no_edge_gets_more_than_two_facets)
{
    for (int tents = 1; tents <= 2; tents++) {
        size_t open, many;
        struct skin_close_count count;
        struct patch_mesh q = pyramid(tents);
        size_t vertices = q.vertex.n;
        fill(&q, 0.02, true, &count);
        count_edges(&q, &open, &many);
        ck_assert_uint_eq(open + many, 0);
        ck_assert_uint_eq(count.facets, tents == 1 ? 2 : 4);
        ck_assert_uint_eq(q.vertex.n, vertices + (tents == 2));
        patch_mesh_free(&q);
    }
}
END_TEST

START_TEST(unless_it_is_allowed)
{
    size_t open, many;
    struct skin_close_count count;
    struct patch_mesh q = pyramid(2);
    fill(&q, 0.02, false, &count);
    count_edges(&q, &open, &many);
    ck_assert_uint_eq(open, 0);
    ck_assert_uint_eq(many, 1);
    patch_mesh_free(&q);
}
END_TEST

int main(void)
{
    TCase *tests = tcase_create("skin_slits");
    tcase_add_test(tests, a_narrow_base_is_filled);
    tcase_add_test(tests, no_edge_gets_more_than_two_facets);
    tcase_add_test(tests, unless_it_is_allowed);
    Suite *suite = suite_create("skin_slits");
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

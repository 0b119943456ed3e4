/*
 * check_skin_sides - the sides of facets by their places, against counts of closed and open bodies
 * (Euler: a closed surface of triangles has three sides for two facets).
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/skin_sides.h"

/* A body of n places, their numbers not in order, each twice as a vertex; facets take either. */
static struct patch_mesh body(size_t n, const int (*corner)[3], size_t faces, bool *flipped)
{
    struct patch_mesh q = {.sheets = 1, .flipped = flipped};
    for (size_t i = 0; i < 2 * n; i++)
        *array_push(&q.vertex) = (struct patch_mesh_vertex){.place = n - 1 - i / 2};
    for (size_t f = 0; f < faces; f++) {
        struct face face;
        for (int k = 0; k < 3; k++)
            face.v[k] = 2 * corner[f][k] + (int)(f + (size_t)k) % 2;
        *array_push(&q.face) = face;
        *array_push(&q.sheet) = 0;
    }
    return q;
}

static void free_body(struct patch_mesh *q)
{
    array_free(&q->vertex);
    array_free(&q->face);
    array_free(&q->sheet);
}

static const int tetrahedron[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

START_TEST(a_closed_body_has_each_side_twice_and_both_ways)
{
    bool flipped = false;
    struct patch_mesh q = body(4, tetrahedron, 4, &flipped);
    size_t n, edges = 0;
    struct skin_side *side = skin_sides_find(&q, &n);
    ck_assert_uint_eq(n, 12);
    for (size_t i = 0; i < n; i += 2, edges++) {
        ck_assert_uint_eq(skin_sides_same(side, n, i), 2);
        ck_assert_uint_lt(side[i].low, side[i].high);
        ck_assert(side[i].forward != side[i + 1].forward);
        ck_assert_uint_lt(side[i].facet, side[i + 1].facet);
        if (i > 0)
            ck_assert(side[i - 1].low < side[i].low ||
                      (side[i - 1].low == side[i].low && side[i - 1].high < side[i].high));
    }
    ck_assert_uint_eq(edges, 6);
    free(side);
    free_body(&q);
}
END_TEST

/* Each side says the corner where it begins, and whether it rises there. */
START_TEST(a_side_leads_back_to_its_facet)
{
    for (int turned = 0; turned < 2; turned++) {
        bool flipped = turned;
        struct patch_mesh q = body(4, tetrahedron, 4, &flipped);
        size_t n;
        struct skin_side *side = skin_sides_find(&q, &n);
        for (size_t i = 0; i < n; i++) {
            const int *v = q.face.item[side[i].facet].v;
            size_t from = q.vertex.item[v[side[i].corner]].place;
            size_t to = q.vertex.item[v[(side[i].corner + 1) % 3]].place;
            ck_assert_uint_eq(side[i].low, from < to ? from : to);
            ck_assert_uint_eq(side[i].high, from < to ? to : from);
            ck_assert(side[i].forward == ((from < to) != flipped));
        }
        free(side);
        free_body(&q);
    }
}
END_TEST

START_TEST(an_open_strip_has_single_sides)
{
    static const int strip[3][3] = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
    bool flipped = false;
    struct patch_mesh q = body(5, strip, 3, &flipped);
    size_t n, single = 0, pairs = 0;
    struct skin_side *side = skin_sides_find(&q, &n);
    ck_assert_uint_eq(n, 9);
    for (size_t i = 0; i < n; i += skin_sides_same(side, n, i)) {
        single += skin_sides_same(side, n, i) == 1;
        pairs += skin_sides_same(side, n, i) == 2;
    }
    ck_assert_uint_eq(single, 5);
    ck_assert_uint_eq(pairs, 2);
    free(side);
    free_body(&q);
}
END_TEST

/* Three facets at one edge, as of a body that is no surface. */
START_TEST(three_at_one_edge)
{
    static const int book[3][3] = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    bool flipped = false;
    struct patch_mesh q = body(5, book, 3, &flipped);
    size_t n, most = 0;
    struct skin_side *side = skin_sides_find(&q, &n);
    for (size_t i = 0; i < n; i += skin_sides_same(side, n, i))
        most = skin_sides_same(side, n, i) > most ? skin_sides_same(side, n, i) : most;
    ck_assert_uint_eq(most, 3);
    free(side);
    free_body(&q);
}
END_TEST

START_TEST(two_corners_at_one_place_are_no_facet)
{
    static const int flat[4][3] = {{0, 1, 2}, {0, 0, 2}, {0, 2, 2}, {2, 1, 2}};
    bool flipped = false;
    struct patch_mesh q = body(3, flat, 4, &flipped);
    size_t n;
    for (size_t f = 0; f < 4; f++)
        ck_assert(skin_facet_counts(&q, f) == (f == 0));
    struct skin_side *side = skin_sides_find(&q, &n);
    ck_assert_uint_eq(n, 3);
    free(side);
    free_body(&q);
}
END_TEST

START_TEST(nothing_has_no_sides)
{
    struct patch_mesh q = {0};
    size_t n = 7;
    struct skin_side *side = skin_sides_find(&q, &n);
    ck_assert_uint_eq(n, 0);
    free(side);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("skin_sides");
    TCase *tests = tcase_create("skin_sides");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_closed_body_has_each_side_twice_and_both_ways);
    tcase_add_test(tests, a_side_leads_back_to_its_facet);
    tcase_add_test(tests, an_open_strip_has_single_sides);
    tcase_add_test(tests, three_at_one_edge);
    tcase_add_test(tests, two_corners_at_one_place_are_no_facet);
    tcase_add_test(tests, nothing_has_no_sides);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/*
 * check_skin_region - the region about edges that are not sound has these and no others, and put
 * back unchanged it leaves the skin as it was.
 */
#include <check.h>

#include "facets.h"
#include "nurbs/skin_region.h"
#include "nurbs/skin_sides.h"

enum { CELLS = 30, BORDER = 4 * CELLS, FACETS = 2 * CELLS * CELLS };

/* The border of a square: the middle is not in the region, and does not make open edges. */
START_TEST(a_border_is_the_only_open_one)
{
    struct patch_mesh q = facets_square(CELLS, 1);
    struct skin_region r;
    ck_assert(skin_region_find(&q, &r));
    ck_assert_uint_eq(skin_count_unsound(&r.mesh), BORDER);
    ck_assert_uint_lt(r.mesh.face.n, FACETS);
    ck_assert(!r.inside[FACETS / 2 + CELLS]);
    skin_region_put(&q, &r);
    skin_region_free(&r);
    ck_assert_uint_eq(q.face.n, FACETS);
    ck_assert_uint_eq(skin_count_unsound(&q), BORDER);
    patch_mesh_free(&q);
}
END_TEST

/* A facet taken out of the middle, and filled in the region: put back it is there. */
START_TEST(what_is_mended_comes_back)
{
    struct patch_mesh q = facets_square(CELLS, 1);
    struct skin_region r;
    struct face hole = q.face.item[FACETS / 2 + CELLS];
    q.face.item[FACETS / 2 + CELLS] = q.face.item[--q.face.n];
    ck_assert(skin_region_find(&q, &r));
    ck_assert_uint_eq(skin_count_unsound(&r.mesh), skin_count_unsound(&q));
    struct face copy = hole;
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < r.vertices; i++)
            if (r.vertex[i] == (size_t)hole.v[k])
                copy.v[k] = (int)i;
    *array_push(&r.mesh.face) = copy;
    *array_push(&r.mesh.sheet) = 0;
    skin_region_put(&q, &r);
    skin_region_free(&r);
    ck_assert_uint_eq(q.face.n, FACETS);
    ck_assert_uint_eq(skin_count_unsound(&q), BORDER);
    patch_mesh_free(&q);
}
END_TEST

/* Two vertices made one place in the region are one in the skin. */
START_TEST(what_is_united_stays_united)
{
    struct patch_mesh q = facets_square(CELLS, 1);
    struct skin_region r;
    ck_assert(skin_region_find(&q, &r));
    size_t a = r.vertex[0], b = r.vertex[1];
    ck_assert(q.vertex.item[a].place != q.vertex.item[b].place);
    patch_mesh_unite(&r.mesh, 0, 1);
    skin_region_put(&q, &r);
    skin_region_free(&r);
    ck_assert_uint_eq(q.vertex.item[a].place, q.vertex.item[b].place);
    patch_mesh_free(&q);
}
END_TEST

START_TEST(a_closed_skin_has_none)
{
    const struct vec3 at[4] = {vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)};
    const int corner[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    struct patch_mesh q = facets_skin(at, 4, corner, 4);
    struct skin_region r;
    ck_assert(!skin_region_find(&q, &r));
    patch_mesh_free(&q);
}
END_TEST

int main(void)
{
    TCase *tests = tcase_create("skin_region");
    tcase_add_test(tests, a_border_is_the_only_open_one);
    tcase_add_test(tests, what_is_mended_comes_back);
    tcase_add_test(tests, what_is_united_stays_united);
    tcase_add_test(tests, a_closed_skin_has_none);
    Suite *suite = suite_create("skin_region");
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

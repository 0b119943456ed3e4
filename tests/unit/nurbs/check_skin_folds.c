/*
 * check_skin_folds - folds, crumbs and slivers the wrong way round are taken out or turned; a sound
 * skin stays as it is.
 */
#include <check.h>

#include "facets.h"
#include "nurbs/skin_folds.h"
#include "nurbs/skin_sides.h"

START_TEST(a_sound_square_stays)
{
    struct patch_mesh q = facets_square(3, 1);
    ck_assert_uint_eq(skin_drop_folds(&q, 0.1), 0);
    skin_turn_slivers(&q, 0.1);
    skin_drop_crumbs(&q, 0.1);
    ck_assert_uint_eq(q.face.n, 18);
    ck_assert_uint_eq(skin_count_unsound(&q), 12);
    patch_mesh_free(&q);
}
END_TEST

/* A flap: a facet from an edge of the square to a place beside it, and back. */
START_TEST(a_fold_goes)
{
    struct patch_mesh q = facets_square(3, 1);
    *array_push(&q.vertex) =
        (struct patch_mesh_vertex){.point = vec(1.5, 1.5, 1), .place = 16, .next = 16};
    *array_push(&q.face) = (struct face){{5, 6, 16}};
    *array_push(&q.face) = (struct face){{6, 5, 16}};
    *array_push(&q.sheet) = 0;
    *array_push(&q.sheet) = 0;
    ck_assert_uint_eq(skin_drop_folds(&q, 0.1), 1);
    ck_assert_uint_eq(q.face.n, 18);
    ck_assert_uint_eq(skin_count_unsound(&q), 12);
    patch_mesh_free(&q);
}
END_TEST

/* A facet by itself, 0.05 wide. */
START_TEST(a_crumb_goes)
{
    struct patch_mesh q = facets_square(3, 1);
    const struct vec3 at[3] = {vec(9, 9, 9), vec(12, 9, 9), vec(10, 9.05, 9)};
    for (size_t i = 0; i < 3; i++)
        *array_push(&q.vertex) =
            (struct patch_mesh_vertex){.point = at[i], .place = 16 + i, .next = 16 + i};
    *array_push(&q.face) = (struct face){{16, 17, 18}};
    *array_push(&q.sheet) = 0;
    skin_drop_crumbs(&q, 0.01);
    ck_assert_uint_eq(q.face.n, 19);
    skin_drop_crumbs(&q, 0.1);
    ck_assert_uint_eq(q.face.n, 18);
    patch_mesh_free(&q);
}
END_TEST

/* The square with a row of cells 0.01 wide, one facet of which is upside down. */
START_TEST(a_sliver_is_turned)
{
    struct patch_mesh q = facets_square(3, 1);
    for (size_t i = 8; i < 16; i++)
        q.vertex.item[i].point.y -= 0.99;
    int *v = q.face.item[8].v, other = v[1];
    v[1] = v[2];
    v[2] = other;
    ck_assert_uint_gt(skin_count_unsound(&q), 12);
    skin_turn_slivers(&q, 0.001);
    ck_assert_uint_gt(skin_count_unsound(&q), 12);
    skin_turn_slivers(&q, 0.02);
    ck_assert_uint_eq(skin_count_unsound(&q), 12);
    patch_mesh_free(&q);
}
END_TEST

/* Height over the longest side; what stands for the skin beyond a region is wider than any gap. */
START_TEST(a_facet_has_a_width)
{
    const struct vec3 at[3] = {vec(0, 0, 0), vec(10, 0, 0), vec(4, 0.5, 0)};
    const int corner[1][3] = {{0, 1, 2}};
    struct patch_mesh q = facets_skin(at, 3, corner, 1);
    ck_assert_double_eq_tol(skin_facet_width(&q, 0), 0.5, 1e-12);
    q.vertex.item[2].sheet = -1;
    ck_assert(isinf(skin_facet_width(&q, 0)));
    patch_mesh_free(&q);
}
END_TEST

int main(void)
{
    TCase *tests = tcase_create("skin_folds");
    tcase_add_test(tests, a_sound_square_stays);
    tcase_add_test(tests, a_fold_goes);
    tcase_add_test(tests, a_crumb_goes);
    tcase_add_test(tests, a_sliver_is_turned);
    tcase_add_test(tests, a_facet_has_a_width);
    Suite *suite = suite_create("skin_folds");
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

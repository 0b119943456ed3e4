/*
 * check_patch_weld - what the printed digits make one is one place, but not across bodies.
 */
#include <check.h>

#include "base/num.h"
#include "facets.h"
#include "nurbs/patch_weld.h"

/* Two facets whose third corners are `apart` mm from each other, of two sheets. */
static struct patch_mesh two(double apart)
{
    const struct vec3 at[6] = {vec(0, 0, 0), vec(1, 0, 0), vec(0.5, 1, 0),
                               vec(0, 2, 0), vec(1, 2, 0), vec(0.5, 1 + apart, 0)};
    const int corner[2][3] = {{0, 1, 2}, {4, 3, 5}};
    struct patch_mesh q = facets_skin(at, 6, corner, 2);
    q.sheet.item[1] = 1;
    for (int i = 3; i < 6; i++)
        q.vertex.item[i].sheet = 1;
    return q;
}

static size_t welded(double apart, int body)
{
    struct patch_mesh q = two(apart);
    struct patches patches = {0};
    *array_push(&patches) = (struct patch){.body = 1};
    *array_push(&patches) = (struct patch){.body = body};
    size_t n = patch_mesh_weld(&q, &patches);
    ck_assert_int_eq(q.vertex.item[2].place == q.vertex.item[5].place, n > 0);
    for (size_t i = 0; i < q.vertex.n; i++)
        ck_assert(!(fabs(num_round(q.vertex.item[i].point.y, 6) - q.vertex.item[i].point.y) > 0));
    patch_mesh_free(&q);
    array_free(&patches);
    return n;
}

START_TEST(places_that_print_alike_are_one)
{
    ck_assert_uint_eq(welded(0, 1), 1);
    ck_assert_uint_eq(welded(4e-7, 1), 1);
    ck_assert_uint_eq(welded(6e-7, 1), 0);
    ck_assert_uint_eq(welded(-4e-7, 1), 1);
}
END_TEST

START_TEST(bodies_stay_apart)
{
    ck_assert_uint_eq(welded(0, 2), 0);
    ck_assert_uint_eq(welded(4e-7, 2), 0);
}
END_TEST

/* A facet whose corners print alike is none any more: its places are less than three. */
START_TEST(a_facet_may_vanish)
{
    const struct vec3 at[3] = {vec(0, 0, 0), vec(1, 0, 0), vec(1, 3e-7, -0.0)};
    const int corner[1][3] = {{0, 1, 2}};
    struct patch_mesh q = facets_skin(at, 3, corner, 1);
    struct patches patches = {0};
    *array_push(&patches) = (struct patch){.body = 0};
    ck_assert_uint_eq(patch_mesh_weld(&q, &patches), 1);
    ck_assert_uint_eq(q.vertex.item[2].place, 1);
    patch_mesh_free(&q);
    array_free(&patches);
}
END_TEST

int main(void)
{
    TCase *tests = tcase_create("patch_weld");
    tcase_add_test(tests, places_that_print_alike_are_one);
    tcase_add_test(tests, bodies_stay_apart);
    tcase_add_test(tests, a_facet_may_vanish);
    Suite *suite = suite_create("patch_weld");
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/*
 * skin_loops: two flat surfaces that lie apart have two borders of known length, with the largest
 * distance between them; one surface alone has a border and no gap; a slit between surfaces that
 * meet at its ends is one loop, as wide as the slit.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/sew.h"
#include "nurbs/skin.h"

enum { CELLS = 5 }; /* an odd number: an edge's middle is in the middle of a side */

static struct skin skin_apart(const struct patches *p, double gap, struct patch_mesh *mesh)
{
    struct sheet *sheet = mem_alloc(p->n, sizeof *sheet);
    for (size_t i = 0; i < p->n; i++)
        tessellate(&p->item[i], (struct tessellate_options){CELLS, 0.001, 1}, &sheet[i]);
    patch_mesh_make(sheet, p->n, 0, mesh);
    if (gap > 0)
        sew(mesh, p, gap, 0.001);
    for (size_t i = 0; i < p->n; i++)
        sheet_free(&sheet[i]);
    free(sheet);
    return skin_of(mesh);
}

static void free_all(struct skin *skin, struct patch_mesh *mesh, struct patches *p)
{
    skin_free(skin);
    patch_mesh_free(mesh);
    patches_free(p);
}

START_TEST(alone)
{
    struct patches p = {0};
    struct patch_mesh mesh;
    *array_push(&p) = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 4, 0), vec(10, 4, 0));
    struct skin skin = skin_apart(&p, 0, &mesh);
    ck_assert_uint_eq(skin.loop.n, 1);
    ck_assert_double_eq_tol(skin.loop.item[0].length, 28, 1e-9);
    ck_assert(!isfinite(skin.loop.item[0].gap));
    ck_assert_uint_eq(skin.open_on[0], skin.loop.item[0].edges);
    free_all(&skin, &mesh, &p);
}
END_TEST

/* Beside each other, 1 mm apart: what is farthest is the far side of each. */
START_TEST(beside)
{
    struct patches p = {0};
    struct patch_mesh mesh;
    *array_push(&p) = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 4, 0), vec(10, 4, 0));
    *array_push(&p) = known_flat(vec(11, 0, 0), vec(31, 0, 0), vec(11, 4, 0), vec(31, 4, 0));
    struct skin skin = skin_apart(&p, 0, &mesh);
    ck_assert_uint_eq(skin.loop.n, 2);
    ck_assert_double_eq_tol(skin.loop.item[0].length, 48, 1e-9); /* the longest first */
    ck_assert_double_eq_tol(skin.loop.item[0].gap, 21, 1e-9);
    ck_assert_double_eq_tol(skin.loop.item[0].at.x, 31, 1e-9);
    ck_assert_int_eq(skin.loop.item[0].sheet, 1);
    ck_assert_double_eq_tol(skin.loop.item[1].length, 28, 1e-9);
    ck_assert_double_eq_tol(skin.loop.item[1].gap, 11, 1e-9);
    ck_assert_double_eq_tol(skin.loop.item[1].at.x, 0, 1e-9);
    ck_assert_uint_eq(skin.open_on[0] + skin.open_on[1], skin.open);
    free_all(&skin, &mesh, &p);
}
END_TEST

/* Three flats along a fourth, of which the middle one ends short of it. */
START_TEST(slit)
{
    const double wide = 0.5;
    struct patches p = {0};
    struct patch_mesh mesh;
    *array_push(&p) = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 6, 0), vec(10, 6, 0));
    *array_push(&p) = known_flat(vec(0, 6, 0), vec(2, 6, 0), vec(0, 12, 0), vec(2, 12, 0));
    *array_push(&p) =
        known_flat(vec(2, 6 + wide, 0), vec(8, 6 + wide, 0), vec(2, 12, 0), vec(8, 12, 0));
    *array_push(&p) = known_flat(vec(8, 6, 0), vec(10, 6, 0), vec(8, 12, 0), vec(10, 12, 0));
    struct skin skin = skin_apart(&p, 0.001, &mesh);
    ck_assert_uint_eq(skin.loop.n, 2);
    ck_assert_double_eq_tol(skin.loop.item[0].length, 44, 1e-9); /* around all */
    ck_assert_double_eq_tol(skin.loop.item[1].length, 2 * (6 + wide), 1e-9);
    ck_assert_double_eq_tol(skin.loop.item[1].gap, wide, 1e-9);
    ck_assert_double_gt(skin.loop.item[1].at.x, 2 - 1e-9);
    ck_assert_double_lt(skin.loop.item[1].at.x, 8 + 1e-9);
    free_all(&skin, &mesh, &p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("skin_loops");
    TCase *tests = tcase_create("skin_loops");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, alone);
    tcase_add_test(tests, beside);
    tcase_add_test(tests, slit);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

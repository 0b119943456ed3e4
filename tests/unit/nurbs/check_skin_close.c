/*
 * skin_close and skin: a box of six surfaces of which one ends short of its neighbours is closed
 * where the slit is narrow, and stays open where it is wide; area, volume, genus and the border's
 * length are those of the box.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/orient.h"
#include "nurbs/sew.h"
#include "nurbs/skin.h"
#include "nurbs/skin_close.h"

static const double X = 30, Y = 20, Z = 10;

/* The six sides; `slit` is cut off the lid along x = X, `lid` says whether there is one. */
static struct patches box(double slit, bool lid)
{
    struct patches p = {0};
    struct vec3 c[8];
    for (int i = 0; i < 8; i++)
        c[i] = vec(i & 1 ? X : 0, i & 2 ? Y : 0, i & 4 ? Z : 0);
    *array_push(&p) = known_flat(c[0], c[1], c[2], c[3]);
    *array_push(&p) = known_flat(c[0], c[1], c[4], c[5]);
    *array_push(&p) = known_flat(c[2], c[3], c[6], c[7]);
    *array_push(&p) = known_flat(c[0], c[2], c[4], c[6]);
    *array_push(&p) = known_flat(c[1], c[3], c[5], c[7]);
    c[5].x -= slit;
    c[7].x -= slit;
    if (lid)
        *array_push(&p) = known_flat(c[4], c[5], c[6], c[7]);
    return p;
}

static void join(const struct patches *patches, double gap, struct patch_mesh *mesh)
{
    struct sheet *sheet = mem_alloc(patches->n, sizeof *sheet);
    for (size_t i = 0; i < patches->n; i++)
        tessellate(&patches->item[i], (struct tessellate_options){3 + (int)i, 0.001, 1}, &sheet[i]);
    patch_mesh_make(sheet, patches->n, 0, mesh);
    sew(mesh, patches, gap, 0.001);
    orient_outward(mesh, NULL, vec(0, 0, 1));
    for (size_t i = 0; i < patches->n; i++)
        sheet_free(&sheet[i]);
    free(sheet);
}

/* The box, sewn. */
struct sewn {
    struct patches patches;
    struct patch_mesh mesh;
};

static struct sewn sewn_box(double slit, bool lid)
{
    struct sewn s = {.patches = box(slit, lid)};
    join(&s.patches, 0.001, &s.mesh);
    return s;
}

static void sewn_free(struct sewn *s, struct skin *skin)
{
    skin_free(skin);
    patch_mesh_free(&s->mesh);
    patches_free(&s->patches);
}

static void is_box(const struct skin *skin)
{
    ck_assert_uint_eq(skin->body.n, 1);
    const struct skin_body *body = &skin->body.item[0];
    ck_assert(skin_body_closed(body));
    ck_assert_int_eq(body->genus, 0);
    ck_assert_double_lt(fabs(body->area - 2 * (X * Y + Y * Z + Z * X)), 0.5);
    ck_assert_double_lt(fabs(body->volume - X * Y * Z), 0.5);
    ck_assert_uint_eq(skin->loop.n, 0);
}

START_TEST(tight)
{
    struct sewn sewn = sewn_box(0, true);
    struct skin_close_count closed = skin_close(&sewn.mesh, 0.01, 0.08);
    ck_assert_uint_eq(closed.filled, 0);
    ck_assert_uint_eq(closed.folded, 0);
    struct skin skin = skin_of(&sewn.mesh);
    is_box(&skin);
    sewn_free(&sewn, &skin);
}
END_TEST

START_TEST(slit)
{
    struct sewn sewn = sewn_box(0.02, true);
    struct skin skin = skin_of(&sewn.mesh);
    ck_assert_uint_gt(skin.open, 0); /* sewing alone leaves it */
    skin_free(&skin);
    struct skin_close_count closed = skin_close(&sewn.mesh, 0.05, 0.4);
    ck_assert_uint_ge(closed.filled, 1);
    ck_assert_uint_ge(closed.facets, 1);
    ck_assert_double_lt(closed.width, 0.05);
    skin = skin_of(&sewn.mesh);
    is_box(&skin);
    sewn_free(&sewn, &skin);
}
END_TEST

START_TEST(wide)
{
    struct sewn sewn = sewn_box(2, true);
    struct skin_close_count closed = skin_close(&sewn.mesh, 0.05, 0.4);
    ck_assert_uint_eq(closed.filled, 0);
    struct skin skin = skin_of(&sewn.mesh);
    ck_assert(!skin_body_closed(&skin.body.item[0]));
    ck_assert_uint_eq(skin.loop.n, 1);
    ck_assert_double_lt(fabs(skin.loop.item[0].length - 2 * (Y + 2)), 1e-9);
    sewn_free(&sewn, &skin);
}
END_TEST

START_TEST(lidless)
{
    struct sewn sewn = sewn_box(0, false);
    skin_close(&sewn.mesh, 0.05, 0.4);
    struct skin skin = skin_of(&sewn.mesh);
    ck_assert_uint_eq(skin.loop.n, 1);
    ck_assert_double_lt(fabs(skin.loop.item[0].length - 2 * (X + Y)), 1e-9);
    ck_assert_double_lt(fabs(skin.body.item[0].area - (X * Y + 2 * Y * Z + 2 * Z * X)), 1e-9);
    sewn_free(&sewn, &skin);
}
END_TEST

/* A torus has a handle. */
START_TEST(handle)
{
    struct patches p = {0};
    *array_push(&p) = known_torus(20, 5);
    struct sheet sheet;
    struct patch_mesh mesh;
    tessellate(&p.item[0], (struct tessellate_options){0, 0.002, 1}, &sheet);
    patch_mesh_make(&sheet, 1, 0, &mesh);
    sew(&mesh, &p, 0.001, 0.001);
    orient_outward(&mesh, NULL, vec(0, 0, 1));
    skin_close(&mesh, 0.001, 0.008);
    struct skin skin = skin_of(&mesh);
    ck_assert_uint_eq(skin.body.n, 1);
    ck_assert(skin_body_closed(&skin.body.item[0]));
    ck_assert_int_eq(skin.body.item[0].genus, 1);
    double volume = 2 * PI * PI * 20 * 25;
    ck_assert_double_lt(fabs(fabs(skin.body.item[0].volume) - volume), 1e-3 * volume);
    skin_free(&skin);
    sheet_free(&sheet);
    patch_mesh_free(&mesh);
    patches_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("skin_close");
    TCase *tests = tcase_create("skin_close");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, tight);
    tcase_add_test(tests, slit);
    tcase_add_test(tests, wide);
    tcase_add_test(tests, lidless);
    tcase_add_test(tests, handle);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

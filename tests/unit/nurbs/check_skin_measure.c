/*
 * skin_measure: area and volume of bodies come from their surfaces where all of them are theirs
 * alone: a torus by few facets and a box; what facets miss by more than a fifth stays as they say.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/orient.h"
#include "nurbs/sew.h"
#include "nurbs/skin_measure.h"

static const double RING = 20, PIPE = 5, A = 3, B = 4, C = 5;

static void join(const struct patches *patches, int count, struct patch_mesh *mesh)
{
    struct sheet *sheet = mem_alloc(patches->n, sizeof *sheet);
    for (size_t i = 0; i < patches->n; i++)
        tessellate(&patches->item[i], (struct tessellate_options){count, 0, 1}, &sheet[i]);
    patch_mesh_make(sheet, patches->n, 0, mesh);
    sew(mesh, patches, 0.001, 0.001);
    orient_outward(mesh, NULL, vec(0, 0, 1));
    for (size_t i = 0; i < patches->n; i++)
        sheet_free(&sheet[i]);
    free(sheet);
}

static void free_all(struct skin *skin, struct patch_mesh *mesh, struct patches *patches)
{
    skin_free(skin);
    patch_mesh_free(mesh);
    patches_free(patches);
}

START_TEST(torus)
{
    struct patches p = {0};
    struct patch_mesh mesh;
    const double area = 4 * PI * PI * RING * PIPE, volume = 2 * PI * PI * RING * PIPE * PIPE;
    *array_push(&p) = known_torus(RING, PIPE);
    join(&p, _i ? 5 : 24, &mesh);
    struct skin skin = skin_of(&mesh);
    ck_assert_uint_eq(skin.body.n, 1);
    const struct skin_body *b = &skin.body.item[0];
    double was = b->area;
    ck_assert_double_gt(fabs(was - area), 0.005 * area);
    skin_measure(&skin, &mesh, &p, 1 + _i);
    if (fabs(was - area) > 0.2 * area) { /* so coarse that it may be another body */
        ck_assert(_i == 1);
        ck_assert(!b->exact);
        ck_assert_double_eq(b->area, was);
    } else {
        ck_assert(_i == 0);
        ck_assert(b->exact);
        ck_assert_double_eq_tol(b->area, area, 1e-6 * area);
        ck_assert_double_eq_tol(b->volume, volume, 1e-6 * volume);
    }
    free_all(&skin, &mesh, &p);
}
END_TEST

/* Two boxes apart from each other, each of six surfaces, of which half lie the other way round. */
START_TEST(boxes)
{
    struct patches p = {0};
    struct patch_mesh mesh;
    for (int k = 0; k < 2; k++) {
        struct vec3 c[8];
        double s = k ? 2 : 1;
        for (int i = 0; i < 8; i++)
            c[i] = vec(20 * k + s * (i & 1 ? A : 0), s * (i & 2 ? B : 0), s * (i & 4 ? C : 0));
        *array_push(&p) = known_flat(c[0], c[1], c[2], c[3]);
        *array_push(&p) = known_flat(c[0], c[1], c[4], c[5]);
        *array_push(&p) = known_flat(c[2], c[3], c[6], c[7]);
        *array_push(&p) = known_flat(c[0], c[2], c[4], c[6]);
        *array_push(&p) = known_flat(c[1], c[3], c[5], c[7]);
        *array_push(&p) = known_flat(c[4], c[5], c[6], c[7]);
    }
    join(&p, 2, &mesh);
    struct skin skin = skin_of(&mesh);
    ck_assert_uint_eq(skin.body.n, 2);
    for (size_t i = 0; i < 2; i++)
        skin.body.item[i].area *= 1.19; /* to see that it is replaced */
    skin_measure(&skin, &mesh, &p, 2);
    for (size_t i = 0; i < 2; i++) {
        const struct skin_body *b = &skin.body.item[i];
        double s = i ? 1 : 2; /* the largest first */
        ck_assert(b->exact);
        ck_assert_double_eq_tol(b->area, s * s * 2 * (A * B + B * C + C * A), 1e-9);
        ck_assert_double_eq_tol(b->volume, s * s * s * A * B * C, 1e-9);
    }
    /* surfaces of several bodies measure none */
    skin.body.item[0].shared = true;
    skin.body.item[0].area = 1;
    skin_measure(&skin, &mesh, &p, 1);
    ck_assert(!skin.body.item[0].exact);
    ck_assert_double_eq(skin.body.item[0].area, 1);
    ck_assert(skin.body.item[1].exact);
    free_all(&skin, &mesh, &p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("skin_measure");
    TCase *tests = tcase_create("skin_measure");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, torus, 0, 2);
    tcase_add_test(tests, boxes);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

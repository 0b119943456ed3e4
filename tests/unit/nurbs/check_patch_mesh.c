/*
 * patch_mesh: borders of sheets, places made one, the mesh that becomes of them: one vertex where
 * normals agree, two at a sharp edge; a strip that is too narrow is left out.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/patch_mesh.h"

/* Squares of side 10 in the plane z = 0, and one upright on the line x = 10. */
static void make(bool sharp, double least, double strip, struct patch_mesh *q)
{
    struct patch p[3] = {
        known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0)),
        sharp ? known_flat(vec(10, 0, 0), vec(10, 0, -10), vec(10, 10, 0), vec(10, 10, -10))
              : known_flat(vec(10, 0, 0), vec(20, 0, 0), vec(10, 10, 0), vec(20, 10, 0)),
        known_flat(vec(0, 10, 0), vec(10, 10, 0), vec(0, 10 + strip, 0), vec(10, 10 + strip, 0))};
    struct sheet s[3];
    for (int i = 0; i < 3; i++)
        tessellate(&p[i], (struct tessellate_options){2, 0.01, 1}, &s[i]);
    patch_mesh_make(s, 3, least, q);
    for (int i = 0; i < 3; i++) {
        sheet_free(&s[i]);
        patch_free(&p[i]);
    }
}

static size_t near(const struct patch_mesh *q, struct vec3 p, int sheet)
{
    for (size_t i = 0; i < q->vertex.n; i++)
        if (q->vertex.item[i].sheet == sheet && vec_distance(q->vertex.item[i].point, p) < 1e-9)
            return i;
    ck_abort_msg("no such vertex");
    return 0;
}

START_TEST(borders)
{
    struct patch_mesh q;
    make(false, 0, 5, &q);
    ck_assert_uint_eq(q.vertex.n, 27);
    ck_assert_uint_eq(q.face.n, 24);
    ck_assert_uint_eq(q.edge.n, 24);
    ck_assert_uint_eq(q.narrow, 0);
    for (size_t i = 0; i < q.edge.n; i++) {
        const struct patch_mesh_edge *e = &q.edge.item[i];
        const int *v = q.face.item[e->face].v;
        int found = 0;
        for (int k = 0; k < 3; k++)
            found += (size_t)v[k] == e->from && (size_t)v[(k + 1) % 3] == e->to;
        ck_assert_int_eq(found, 1);
    }
    patch_mesh_free(&q);
    make(false, 1, 0.5, &q); /* 2 * 5 / 21 wide */
    ck_assert_uint_eq(q.narrow, 1);
    ck_assert_uint_eq(q.face.n, 16);
    patch_mesh_free(&q);
}
END_TEST

START_TEST(one_vertex_or_two)
{
    for (int sharp = 0; sharp < 2; sharp++) {
        struct patch_mesh q;
        struct mesh mesh = {0};
        make(sharp, 0, 5, &q);
        for (int k = 0; k < 3; k++)
            patch_mesh_unite(&q, near(&q, vec(10, 5 * k, 0), 0), near(&q, vec(10, 5 * k, 0), 1));
        size_t a = near(&q, vec(10, 5, 0), 0);
        ck_assert_uint_ne(q.vertex.item[a].next, a);
        ck_assert_uint_eq(q.vertex.item[q.vertex.item[a].next].next, a);
        patch_mesh_mesh(&q, &mesh);
        ck_assert_uint_eq(mesh.vertex.n, sharp ? 27 : 24);
        ck_assert_uint_eq(mesh.face.n, 24);
        mesh_free(&mesh);
        patch_mesh_free(&q);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("patch_mesh");
    TCase *tests = tcase_create("patch_mesh");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, borders);
    tcase_add_test(tests, one_vertex_or_two);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

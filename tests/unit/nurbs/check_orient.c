/* orient: sheets that look down are turned, closed bodies by their volume, upright ones counted. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "known.h"
#include "nurbs/orient.h"
#include "nurbs/sew.h"

static struct orient_count count_of(struct patch p, struct vec3 up, bool *flipped, double *volume)
{
    struct patches all = {.n = 1, .item = &p};
    struct sheet s;
    struct patch_mesh q;
    struct mesh mesh = {0};
    tessellate(&p, (struct tessellate_options){8, 0.01, 1}, &s);
    patch_mesh_make(&s, 1, 0, &q);
    sew(&q, &all, 1e-6, 0.01);
    struct orient_count count = orient_outward(&q, NULL, up);
    *flipped = q.flipped[0];
    patch_mesh_mesh(&q, &mesh);
    *volume = 0;
    for (size_t i = 0; i < mesh.face.n; i++)
        *volume += vec_dot(mesh.vertex.item[mesh.face.item[i].v[0]], mesh_face_cross(&mesh, i)) / 6;
    mesh_free(&mesh);
    patch_mesh_free(&q);
    sheet_free(&s);
    patch_free(&p);
    return count;
}

/* The same with u and v exchanged, and so the other hand. */
static struct patch other_hand(struct patch p)
{
    struct nurbs_pole *pole = mem_alloc(p.surface.u.poles * p.surface.v.poles, sizeof *pole);
    for (size_t j = 0; j < p.surface.v.poles; j++)
        for (size_t i = 0; i < p.surface.u.poles; i++)
            pole[i * p.surface.v.poles + j] = p.surface.pole[j * p.surface.u.poles + i];
    free(p.surface.pole);
    struct nurbs_axis u = p.surface.u;
    p.surface.u = p.surface.v;
    p.surface.v = u;
    p.surface.pole = pole;
    return p;
}

START_TEST(towards_up)
{
    bool flipped;
    double volume;
    struct patch p = known_flat(vec(0, 0, 0), vec(9, 0, 1), vec(0, 9, 2), vec(9, 9, 0));
    count_of(p, vec(0, 0, 1), &flipped, &volume);
    ck_assert(!flipped);
    p = known_flat(vec(0, 0, 0), vec(9, 0, 1), vec(0, 9, 2), vec(9, 9, 0));
    ck_assert_uint_eq(count_of(p, vec(0, 0, -1), &flipped, &volume).unclear, 0);
    ck_assert(flipped);
    p = known_flat(vec(0, 0, 0), vec(9, 0, 0), vec(0, 0, 9), vec(9, 0, 9));
    ck_assert_uint_eq(count_of(p, vec(0, 0, 1), &flipped, &volume).unclear, 1);
}
END_TEST

START_TEST(closed_bodies)
{
    for (int k = 0; k < 4; k++) {
        bool flipped;
        double volume;
        struct patch p = k % 2 ? known_torus(20, 5) : known_sphere(10);
        if (k / 2)
            p = other_hand(p);
        struct orient_count c = count_of(p, vec(0, 0, 1), &flipped, &volume);
        ck_assert(flipped == (k / 2 == 1));
        ck_assert_uint_eq(c.bodies, 1);
        ck_assert_uint_eq(c.open, 0);
        ck_assert_double_gt(volume, 0);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("orient");
    TCase *tests = tcase_create("orient");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, towards_up);
    tcase_add_test(tests, closed_bodies);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

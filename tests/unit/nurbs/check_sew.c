/*
 * sew and orient: a plane cut into strips with other counts and hands has
 * no open edge inside and one side; a gap wider than allowed stays open; a cube turned inside out
 * is found.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/orient.h"
#include "nurbs/sew.h"

/* A flat patch with corners a (u 0, v 0), b (u 1), c (v 1), d. */
static void add_flat(struct patches *to, struct vec3 a, struct vec3 b, struct vec3 c, struct vec3 d)
{
    static const double knot[4] = {0, 0, 1, 1};
    const struct vec3 corner[4] = {a, b, c, d};
    struct patch *p = array_push(to);
    *p = (struct patch){0};
    struct nurbs *s = &p->surface;
    s->u = s->v = (struct nurbs_axis){.degree = 1, .poles = 2, .from = 0, .to = 1};
    s->u.knot = mem_alloc(4, sizeof *s->u.knot);
    s->v.knot = mem_alloc(4, sizeof *s->v.knot);
    s->pole = mem_alloc(4, sizeof *s->pole);
    for (int i = 0; i < 4; i++) {
        s->u.knot[i] = s->v.knot[i] = knot[i];
        s->pole[i] = (struct nurbs_pole){corner[i].x, corner[i].y, corner[i].z, 1};
    }
}

struct joined {
    struct sew_count sewn;
    struct orient_count out;
    struct mesh mesh;
};

static struct joined join(const struct patches *patches, const int *n, double gap)
{
    struct sheet *sheet = mem_alloc(patches->n, sizeof *sheet);
    struct patch_mesh patch_mesh;
    struct joined j = {0};
    for (size_t i = 0; i < patches->n; i++)
        tessellate(&patches->item[i], (struct tessellate_options){n[i], 0.001, 1}, &sheet[i]);
    patch_mesh_make(sheet, patches->n, 0, &patch_mesh);
    j.sewn = sew(&patch_mesh, patches, gap, 0.001);
    j.out = orient_outward(&patch_mesh, NULL, vec(0, 0, 1));
    patch_mesh_mesh(&patch_mesh, &j.mesh);
    for (size_t i = 0; i < patches->n; i++)
        sheet_free(&sheet[i]);
    free(sheet);
    patch_mesh_free(&patch_mesh);
    return j;
}

static double area_up(const struct mesh *m)
{
    double sum = 0;
    for (size_t i = 0; i < m->face.n; i++)
        sum += mesh_face_cross(m, i).z / 2;
    return sum;
}

START_TEST(strips)
{
    struct patches p = {0};
    int n[3] = {4, 6, 5};
    add_flat(&p, vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0));
    add_flat(&p, vec(10, 0, 0), vec(10, 10, 0), vec(20, 0, 0), vec(20, 10, 0));
    add_flat(&p, vec(20.0005, 10, 0), vec(30, 10, 0), vec(20.0005, 0, 0), vec(30, 0, 0));
    struct joined j = join(&p, n, 0.001);
    ck_assert_uint_eq(j.out.bodies, 1);
    ck_assert_uint_eq(j.out.conflicts, 0);
    ck_assert_double_lt(fabs(area_up(&j.mesh) - 300), 0.01);
    /* the outline alone: above and below, left and right */
    ck_assert_uint_eq(j.out.open, 2 * (4 + 6 + 5) + 4 + 5);
    for (size_t i = 0; i < j.mesh.vertex.n; i++)
        ck_assert_double_gt(j.mesh.normal.item[i].z, 1 - 1e-12);
    mesh_free(&j.mesh);
    j = join(&p, n, 0.0001);
    ck_assert_uint_eq(j.out.bodies, 2);
    mesh_free(&j.mesh);
    patches_free(&p);
}
END_TEST

START_TEST(inside_out)
{
    struct patches p = {0};
    int n[6] = {1, 2, 3, 4, 5, 6};
    struct vec3 c[8];
    for (int i = 0; i < 8; i++)
        c[i] = vec(i & 1, i / 2 & 1, i / 4);
    add_flat(&p, c[0], c[1], c[2], c[3]); /* all of them look inwards, but for the last */
    add_flat(&p, c[4], c[6], c[5], c[7]);
    add_flat(&p, c[0], c[4], c[1], c[5]);
    add_flat(&p, c[2], c[3], c[6], c[7]);
    add_flat(&p, c[0], c[2], c[4], c[6]);
    add_flat(&p, c[1], c[3], c[5], c[7]);
    struct joined j = join(&p, n, 1e-5);
    double volume = 0;
    for (size_t i = 0; i < j.mesh.face.n; i++) {
        const int *v = j.mesh.face.item[i].v;
        struct vec3 cross = mesh_face_cross(&j.mesh, i), middle = {0.5, 0.5, 0.5};
        volume += vec_dot(j.mesh.vertex.item[v[0]], cross) / 6;
        for (int k = 0; k < 3; k++) {
            struct vec3 out = vec_sub(j.mesh.vertex.item[v[k]], middle);
            ck_assert_double_gt(vec_dot(j.mesh.normal.item[v[k]], out), 0.49);
        }
    }
    ck_assert_uint_eq(j.out.open, 0);
    ck_assert_uint_eq(j.out.conflicts, 0);
    ck_assert_double_lt(fabs(volume - 1), 1e-9);
    mesh_free(&j.mesh);
    patches_free(&p);
}
END_TEST

/*
 * Borders that run side by side share vertices; those that only cross or touch
 * stay as they are.
 */
/* How many vertices are joined or inserted between two patches, of 4 and 7 cells. */
static size_t meet(struct patch a, struct patch b, double gap, double *moved)
{
    struct patch p[2] = {a, b};
    struct patches all = {.n = 2, .item = p};
    struct sheet s[2];
    struct patch_mesh q;
    for (int i = 0; i < 2; i++)
        tessellate(&p[i], (struct tessellate_options){i ? 7 : 4, 0.01, 1}, &s[i]);
    patch_mesh_make(s, 2, 0, &q);
    struct sew_count count = sew(&q, &all, gap, 0.01);
    *moved = count.moved;
    for (size_t i = 0; i < q.edge.n; i++) { /* every border edge is one of its triangle */
        const struct patch_mesh_edge *e = &q.edge.item[i];
        const int *v = q.face.item[e->face].v;
        int found = 0;
        for (int k = 0; k < 3; k++)
            found += (size_t)v[k] == e->from && (size_t)v[(k + 1) % 3] == e->to;
        ck_assert_int_eq(found, 1);
    }
    patch_mesh_free(&q);
    for (int i = 0; i < 2; i++) {
        sheet_free(&s[i]);
        patch_free(&p[i]);
    }
    return count.joined + count.inserted;
}

static struct patch left(void)
{
    return known_flat(vec(0, 0, 0), vec(40, 0, 0), vec(0, 40, 0), vec(40, 40, 0));
}

START_TEST(side_by_side)
{
    double moved;
    for (int k = 0; k < 5; k++) { /* up to 0.04 apart: ends joined, 3 and 6 inserted */
        double d = 0.01 * k;
        struct patch right =
            known_flat(vec(40 + d, 0, 0), vec(80, 0, 0), vec(40, 40, d), vec(80, 40, 0));
        ck_assert_uint_eq(meet(left(), right, 0.05, &moved), 2 + 3 + 6);
        ck_assert_double_lt(fabs(moved - d / 2), 1e-12);
    }
    struct patch right =
        known_flat(vec(40.06, 0, 0), vec(80, 0, 0), vec(40.06, 40, 0), vec(80, 40, 0));
    ck_assert_uint_eq(meet(left(), right, 0.05, &moved), 0);
}
END_TEST

/* The border of one runs through that of the other at 45 degrees, through a vertex of both. */
START_TEST(crossing)
{
    double moved;
    struct patch other =
        known_flat(vec(30, 10, 0.02), vec(30, 10, 30), vec(58, 38, 0.02), vec(58, 38, 30));
    ck_assert_uint_eq(meet(left(), other, 0.05, &moved), 0);
    ck_assert_double_eq(moved, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("sew");
    TCase *tests = tcase_create("sew");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, strips);
    tcase_add_test(tests, inside_out);
    tcase_add_test(tests, side_by_side);
    tcase_add_test(tests, crossing);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

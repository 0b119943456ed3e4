/* feature_cut: area, places and normals of facets that creases and walls cross, on one to three
 * sides. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"

/* One triangle in the plane z = 0, its corners in one row and the next. */
static struct mesh triangle(void)
{
    static const struct vec3 corner[] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    struct mesh m = {0};
    for (int i = 0; i < 3; i++) {
        *array_push(&m.vertex) = corner[i];
        *array_push(&m.normal) = vec(0, 0, 1);
        *array_push(&m.row) = i / 2;
        *array_push(&m.col) = i % 2;
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    return m;
}

static double area(const struct mesh *m)
{
    double sum = 0;
    for (size_t f = 0; f < m->face.n; f++)
        sum += vec_length(mesh_face_cross(m, f)) / 2;
    return sum;
}

static struct feature half_way(const struct mesh *m, const struct mesh_edge *e,
                               enum feature_kind kind)
{
    struct vec3 at = vec_mix(m->vertex.item[e->v[0]], m->vertex.item[e->v[1]], 0.5);
    struct feature f = {.kind = kind, .place = {at, at}, .normal = {{0, 0, 1}, {0, 0.6, 0.8}}};
    if (kind == FEATURE_WALL) {
        f.wall = vec(1, 0, 0);
        f.place[1].z -= 2;
    }
    return f;
}

/* Creases on any sides leave the area, and put two vertices on each. */
START_TEST(creases)
{
    for (unsigned sides = 1; sides < 8; sides++) {
        struct mesh m = triangle();
        struct mesh_edges edges = mesh_edges_find(&m);
        struct feature f[3] = {{.kind = FEATURE_NONE}};
        size_t crossed = 0;
        for (int i = 0; i < 3 && sides % 2; i++)
            *array_push(&m.kmax) = 0.1;
        for (size_t e = 0; e < 3; e++) {
            if (sides >> e & 1)
                f[e] = half_way(&m, &edges.edge[e], FEATURE_CREASE);
            crossed += sides >> e & 1;
        }
        feature_cut(&m, &edges, f);
        ck_assert_uint_eq(m.vertex.n, 3 + 2 * crossed);
        ck_assert_uint_eq(m.row.n, m.vertex.n);
        ck_assert_uint_eq(m.kmax.n, sides % 2 ? m.vertex.n : 0); /* where there is any */
        ck_assert_double_eq_tol(area(&m), 8, 1e-12);
        ck_assert_uint_eq(m.face.n, crossed + 1);
        for (size_t k = 0; k < m.face.n; k++)
            ck_assert_double_gt(mesh_face_cross(&m, k).z, 0);
        mesh_edges_free(&edges);
        mesh_free(&m);
    }
}
END_TEST

/* A wall over two sides: two upright facets more, 2 mm high, and the row goes over all four
 * vertices of its edge in their order. */
START_TEST(wall)
{
    struct mesh m = triangle();
    struct mesh_edges edges = mesh_edges_find(&m);
    struct feature f[3] = {{.kind = FEATURE_NONE}};
    for (size_t e = 0; e < 3; e++)
        if (edges.edge[e].v[0] == 0) /* 0-1 along the row, 0-2 */
            f[e] = half_way(&m, &edges.edge[e], FEATURE_WALL);
    feature_cut(&m, &edges, f);
    double upright = 0;
    for (size_t k = 0; k < m.face.n; k++)
        if (fabs(vec_unit(mesh_face_cross(&m, k)).z) < 1e-9)
            upright += vec_length(mesh_face_cross(&m, k)) / 2;
    ck_assert_double_eq_tol(upright, 2 * sqrt(8), 1e-12);
    ck_assert_uint_eq(m.vertex.n, 11);
    static const double z[] = {0, 0, -2, -2};
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(m.row.item[3 + i], 0);
        ck_assert_int_eq(m.col.item[3 + i], 0);
        ck_assert_double_eq(m.vertex.item[3 + i].z, z[i]);
        ck_assert_double_eq(m.normal.item[3 + i].x, i == 1 || i == 2 ? 1 : 0);
        ck_assert_int_eq(m.row.item[7 + i], -1);
    }
    mesh_edges_free(&edges);
    mesh_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_cut");
    TCase *tests = tcase_create("feature_cut");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, creases);
    tcase_add_test(tests, wall);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

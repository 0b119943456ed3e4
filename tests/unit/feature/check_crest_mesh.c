/* crest_mesh: a rib that the edges of a mesh cut off is there again along all of its crest, without
 * gaps between the facets, and the rows stay rows. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature.h"
#include "feature/feature_steps.h"
#include "mesh/mesh_edges.h"
#include "ribs.h"

enum { COLUMNS = 12, ROWS = 13 };

/* Vertices on the rib in rows 0.52 mm apart, 0.6 mm apart along each. */
static struct mesh mesh_over(double high)
{
    struct mesh m = {0};
    for (int i = 0; i < ROWS * COLUMNS; i++) {
        int row = i / COLUMNS, col = i % COLUMNS;
        struct vec3 p = rib_point(high, 0.6 * col + 0.3 * row - 5, 0.52 * row - 3);
        *array_push(&m.vertex) = p;
        *array_push(&m.normal) = rib_normal(high, p);
        *array_push(&m.row) = row;
        *array_push(&m.col) = col;
        if (row + 1 == ROWS || col + 1 == COLUMNS)
            continue;
        *array_push(&m.face) = (struct face){{i, i + 1, i + COLUMNS}};
        *array_push(&m.face) = (struct face){{i + 1, i + COLUMNS + 1, i + COLUMNS}};
    }
    return m;
}

/* The part of the edges across the crest that are at `high` or more over it. */
static double kept(const struct mesh *m, double sign, double high)
{
    int across = 0, there = 0;
    for (size_t f = 0; f < m->face.n; f++) {
        for (int i = 0; i < 3; i++) {
            struct vec3 a = m->vertex.item[m->face.item[f].v[i]];
            struct vec3 b = m->vertex.item[m->face.item[f].v[(i + 1) % 3]];
            double from = rib_off(a), to = rib_off(b);
            if (from * to < 0) {
                across++;
                there += sign * vec_mix(a, b, from / (from - to)).z >= high;
            }
        }
    }
    return (double)there / across;
}

static size_t open_edges(const struct mesh *m)
{
    struct mesh_edges edges = mesh_edges_find(m);
    size_t open = 0;
    for (size_t e = 0; e < edges.n; e++)
        open += edges.edge[e].facet[1] == EDGE_BORDER;
    mesh_edges_free(&edges);
    return open;
}

/* Seen from above the same area, and no facet face down. */
static double area_above(const struct mesh *m)
{
    double sum = 0;
    for (size_t f = 0; f < m->face.n; f++) {
        double area = mesh_face_cross(m, f).z / 2;
        ck_assert_double_gt(area, 0);
        sum += area;
    }
    return sum;
}

/* x rises along each row in the order that rows are read in: by column, then by vertex. */
static void rows_rise(const struct mesh *m)
{
    for (int row = 0; row < ROWS; row++) {
        for (int col = 0; col < COLUMNS; col++) {
            double last = -INFINITY, next = INFINITY;
            for (size_t v = 0; v < m->vertex.n; v++) {
                if (m->row.item[v] != row)
                    continue;
                double x = m->vertex.item[v].x;
                if (v < (size_t)ROWS * COLUMNS && m->col.item[v] == col + 1)
                    next = x;
                if (m->col.item[v] != col)
                    continue;
                ck_assert_double_gt(x, last);
                last = x;
            }
            ck_assert_double_gt(next, last);
        }
    }
}

static void comes_back(double high, double noise)
{
    struct mesh m = mesh_over(high);
    struct vec3s p = rib_cloud(high, noise);
    double sign = high < 0 ? -1 : 1, area = area_above(&m), off = rib_aside(noise) / 0.6;
    double lower = fabs(high) * exp(-off * off) - rib_fit_noise(noise);
    size_t open = open_edges(&m), first = m.vertex.n;
    ck_assert_double_le(kept(&m, sign, lower), 0.8);
    size_t found = crest_mesh_keep(&m, first, p.item, p.n,
                                   &(struct crest_mesh_options){0.2, noise, 1, 2, NULL})
                       .found;
    ck_assert_uint_ge(found, 20);
    ck_assert_double_ge(kept(&m, sign, lower), 0.9);
    ck_assert_double_eq_tol(area_above(&m), area, 0.02);
    ck_assert_uint_ge(open_edges(&m), open);
    ck_assert_uint_le(open_edges(&m), open + 4 * CREST_MOST); /* where it crosses the border,
                                                             and in the edges beside that */
    ck_assert_uint_eq(m.row.n, m.vertex.n);
    ck_assert_uint_eq(m.normal.n, m.vertex.n);
    rows_rise(&m);
    mesh_free(&m);
    array_free(&p);
}

START_TEST(rib_and_groove)
{
    comes_back(0.8, 0);
    comes_back(0.8, 0.02);
    comes_back(-0.8, 0.02);
}
END_TEST

/* A plane stays; so do edges at vertices of a crease. */
START_TEST(nothing_to_do)
{
    struct mesh plane = mesh_over(0), rib = mesh_over(0.8);
    struct vec3s flat = rib_cloud(0, 0.02), p = rib_cloud(0.8, 0);
    size_t vertices = plane.vertex.n, faces = plane.face.n;
    ck_assert_uint_eq(crest_mesh_keep(&plane, vertices, flat.item, flat.n,
                                      &(struct crest_mesh_options){0.2, 0.02, 1, 2, NULL})
                          .found,
                      0);
    ck_assert_uint_eq(
        crest_mesh_keep(&rib, 0, p.item, p.n, &(struct crest_mesh_options){0.2, 0, 1, 2, NULL})
            .found,
        0);
    ck_assert_uint_eq(plane.face.n, faces);
    ck_assert_uint_eq(rib.vertex.n, vertices);
    mesh_free(&plane);
    mesh_free(&rib);
    array_free(&flat);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("crest_mesh");
    TCase *tests = tcase_create("crest_mesh");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, rib_and_groove);
    tcase_add_test(tests, nothing_to_do);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

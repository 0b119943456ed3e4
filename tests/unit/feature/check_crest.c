/* crest: edges over a rib or a groove get a point on it, others none. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "ribs.h"
#include "feature/feature.h"
#include "mesh/mesh_edges.h"

static struct point_grid sorted(const struct vec3s *p, double spacing)
{
    struct point_grid scan;
    struct error error;
    ck_assert_int_eq(point_grid_make(p->item, p->n, spacing, 1, &scan, &error), 0);
    return scan;
}

/* Of what noise leaves a quadric through 48 points along the rib: 4 / 48 of its variance at the
 * middle, six deviations for the best of many directions. */
static double fit_noise(double sigma)
{
    return 6 * sigma * sqrt(4.0 / 48);
}

/* The deviation of the slope that 48 points have across the rib. */
static double slope_noise(double sigma)
{
    return 1.7 * sigma / 0.4 / sqrt(48);
}

/* How far aside of the crest the slope of the fit vanishes, for the rib is no quadric and has
 * noise: five deviations of the slope over the curvature. */
static double aside(double noise)
{
    const double curvature = 2 * 0.8 / 0.36;
    return 0.1 + 5 * 6 * slope_noise(noise) / curvature;
}

/* Edges 0.6 mm long across the crest at several places; nearly half of the rib is off their
 * middle.  Without noise the crest is 0.02 high and `aside` for the rib is no quadric.  Points by
 * chance have holes: where the flanks that a fit along the rib is of have none, there is no crest
 * to be found, which is seen on 2 edges of 100; 4 of the same 11 are not by chance. */
static void crosses(double high, double noise)
{
    int missed = 0;
    struct vec3s p = rib_cloud(high, noise);
    struct point_grid scan = sorted(&p, 0.2);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2, .noise = noise};
    for (int i = -5; i <= 5; i++) {
        double y = 0.6 * i, x = -y * RIB_SIN / RIB_COS, part = 0.5 + 0.05 * i;
        struct vec3 a = rib_point(high, x - 0.6 * part, y);
        struct vec3 b = rib_point(high, x + 0.6 * (1 - part), y);
        struct crest c = crest_find(&cloud, a, b, vec(0, 0, 1));
        if (c.n == 0 || c.top < 0) {
            missed++;
            continue;
        }
        /* the neighbourhood is about the edge's own place, and the curve of the rib's flanks adds
         */
        ck_assert_double_le(fabs(rib_off(c.place[c.top])), aside(noise));
        ck_assert_double_le(fabs(c.place[c.top].z - high), 0.02 + fit_noise(noise));
        ck_assert_double_ge(vec_dot(c.normal[c.top], vec(0, 0, 1)),
                            cos(atan(0.36 + 6 * slope_noise(noise))));
        for (int k = 0; k < c.n; k++)
            ck_assert_double_eq_tol(c.place[k].y, y, 0.05);
    }
    ck_assert_int_lt(missed, 4);
    point_grid_free(&scan);
    array_free(&p);
}

START_TEST(ribs)
{
    crosses(0.8, 0);
    crosses(0.8, 0.02);
}
END_TEST

START_TEST(grooves)
{
    crosses(-0.8, 0);
    crosses(-0.8, 0.02);
}
END_TEST

/* An edge five times as long as the rib is wide gets its feet too: points on the surface that leave
 * less than 0.15 mm between them. */
START_TEST(a_long_edge)
{
    struct vec3s p = rib_cloud(0.8, 0);
    struct point_grid scan = sorted(&p, 0.2);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2};
    struct vec3 a = rib_point(0.8, -2, 0.3), b = rib_point(0.8, 2, 0.3);
    struct crest c = crest_find(&cloud, a, b, vec(0, 0, 1));
    ck_assert_int_ge(c.n, 3);
    for (int k = 0; k <= c.n; k++) {
        struct vec3 from = k > 0 ? c.place[k - 1] : a, to = k < c.n ? c.place[k] : b;
        for (double s = 0; s <= 1; s += 0.1) {
            struct vec3 q = vec_mix(from, to, s);
            ck_assert_double_le(fabs(q.z - rib_point(0.8, q.x, q.y).z), 0.15);
        }
    }
    point_grid_free(&scan);
    array_free(&p);
}
END_TEST

/* Along the crest, where noise may pass for a bump but not leave the rib, beside it, and on a ball
 * of 5 mm radius. */
START_TEST(nothing_there)
{
    struct vec3s p = rib_cloud(0.8, 0.02), ball = {0};
    struct point_grid scan = sorted(&p, 0.2);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2, .noise = 0.02};
    struct vec3 at = rib_point(0.8, 0, 0), on = rib_point(0.8, -0.6 * RIB_SIN, 0.6 * RIB_COS);
    struct crest along = crest_find(&cloud, at, on, vec(0, 0, 1));
    ck_assert_int_le(along.n, 1);
    for (int k = 0; k < along.n; k++)
        ck_assert_double_le(
            fabs(along.place[k].z - rib_point(0.8, along.place[k].x, along.place[k].y).z),
            0.02 + fit_noise(0.02));
    ck_assert_int_eq(crest_find(&cloud, vec(2, 2, 0), vec(2.6, 2, 0), vec(0, 0, 1)).n, 0);
    point_grid_free(&scan);
    for (int i = 0; i < 2500; i++) {
        double x = 6 * uniform() - 3, y = 6 * uniform() - 3;
        *array_push(&ball) = vec(x, y, sqrt(25 - x * x - y * y));
    }
    scan = sorted(&ball, 0.12);
    cloud = (struct feature_cloud){.scan = &scan, .spacing = 0.12};
    ck_assert_int_eq(crest_find(&cloud, vec(-0.3, 0, 4.991), vec(0.3, 0, 4.991), vec(0, 0, 1)).n,
                     0);
    point_grid_free(&scan);
    array_free(&p);
    array_free(&ball);
}
END_TEST

/* crestmesh: a rib that the edges of a mesh cut off is there again along all of its crest, without
 * gaps between the facets, and the rows stay rows. */

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
    double sign = high < 0 ? -1 : 1, area = area_above(&m), off = aside(noise) / 0.6;
    double lower = fabs(high) * exp(-off * off) - fit_noise(noise);
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
    Suite *suite = suite_create("crest");
    TCase *tests = tcase_create("crest");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, ribs);
    tcase_add_test(tests, grooves);
    tcase_add_test(tests, a_long_edge);
    tcase_add_test(tests, nothing_there);
    tcase_add_test(tests, rib_and_groove);
    tcase_add_test(tests, nothing_to_do);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

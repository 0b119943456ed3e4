/* feature_mesh: a mesh over a roof and one over a step become the roof and the step; a smooth one
 * stays as it is. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature.h"
#include "cloud/plan_extent.h"
#include "meshing/grid_mesh.h"
#include "meshing/reposition.h"
#include "rough.h"
#include "meshing/scan_normals.h"
#include "cloud/wall_points.h"

static struct mesh mesh_of(struct vec3s *p, double t, size_t *flat)
{
    struct mesh m = {0};
    struct grid grid;
    struct error error;
    struct point_grid point_grid;
    const struct scan_normals_options how = {.neighbours = 40, .threads = 1};
    struct plan_extent f = plan_extent_of(p->item, p->n, 20);
    *flat = wall_points_part(p->item, p->n, t / 3, 1);
    ck_assert_int_eq(grid_make(&f, p->n, t, &grid, &error), 0);
    size_t *chosen = reposition(&grid, p->item, *flat, REACH_NEAREST, 1);
    grid_mesh_make(&grid, chosen, p->item, NULL, 1, &m);
    ck_assert_int_eq(point_grid_make(p->item, *flat, t / 3, 1, &point_grid, &error), 0);
    scan_normals_quadric(&m, &point_grid, &how);
    point_grid_free(&point_grid);
    free(chosen);
    return m;
}

/* The largest distance from the middles of the facets to the surface. */
static double worst(const struct mesh *m, double (*distance)(struct vec3))
{
    double most = 0;
    for (size_t f = 0; f < m->face.n; f++) {
        const int *v = m->face.item[f].v;
        struct vec3 p = vec_add(m->vertex.item[v[0]], m->vertex.item[v[1]]);
        p = vec_scale(1 / 3.0, vec_add(p, m->vertex.item[v[2]]));
        most = fmax(most, fabs(distance(p)));
    }
    return most;
}

static double from_roof(struct vec3 p)
{
    return (p.z + 0.5 * fabs(p.x)) / hypot(1, 0.5);
}

/* Two levels, 6 mm apart, the upper one where x > 0. */
static double from_step(struct vec3 p)
{
    double low = hypot(fmax(p.x, 0), p.z), high = hypot(fmin(p.x, 0), p.z - 6);
    double wall = hypot(p.x, p.z - fmin(fmax(p.z, 0), 6));
    return fmin(wall, fmin(low, high));
}

/* Is it a corner of a facet with another on the ridge? */
static bool is_beside_ridge(const struct mesh *m, int vertex)
{
    for (size_t f = 0; f < m->face.n; f++) {
        const int *v = m->face.item[f].v;
        bool has = false, ridge = false;
        for (int k = 0; k < 3; k++) {
            has |= v[k] == vertex;
            ridge |= fabs(m->vertex.item[v[k]].x) < 1e-6;
        }
        if (has && ridge)
            return true;
    }
    return false;
}

/* The slope that a fit through the points within `radius` of a place at `x` gives a roof of slope
 * 0.5: 3/2 d - 1/2 d^3 of it, d = x / radius, as the integral of t |t - d| has it. */
static double slope_of_fit(double x, double radius)
{
    double d = fmin(1, fabs(x) / radius);
    return 0.5 * (1.5 * d - 0.5 * d * d * d);
}

/* Beside the ridge they have the normal of their side.  The others keep that of the 40 points about
 * them, some of which may be beyond the ridge: within 1.5 mm, at the border 2.2, and by chance a
 * little less than even points have: 4 sigmas of a slope from 40 are 0.03. */
static void expect_normals(const struct mesh *m)
{
    size_t beside = 0;
    for (size_t v = 0; v < m->vertex.n; v++) {
        struct vec3 p = m->vertex.item[v], n = m->normal.item[v];
        bool inside = p.y > 2 && p.y < 23;
        double slope = fabs(n.x / n.z);
        if (is_beside_ridge(m, (int)v)) {
            beside++;
            ck_assert_double_eq_tol(slope, 0.5, 1e-6);
        } else {
            ck_assert_double_ge(slope, slope_of_fit(p.x, inside ? 1.5 : 2.2) - 0.03);
        }
    }
    ck_assert_uint_gt(beside, 40);
}

START_TEST(roof)
{
    struct vec3s p = {0};
    size_t flat;
    rectangle(&p, 3000, vec(0, 0, 0), vec(-20, 0, -10), vec(0, 25, 0), 0);
    rectangle(&p, 3000, vec(0, 0, 0), vec(20, 0, -10), vec(0, 25, 0), 0);
    struct mesh m = mesh_of(&p, 1.3, &flat);
    ck_assert_double_gt(worst(&m, from_roof), 0.1);
    struct feature_mesh found =
        feature_mesh_keep(&m, &(struct feature_scan){p.item, p.n, flat, 0.43, 0, NULL, NULL}, 1, 2);
    ck_assert_uint_gt(found.creases, 20);
    ck_assert_uint_eq(found.walls, 0);
    ck_assert_double_le(worst(&m, from_roof), 1e-6);
    expect_normals(&m);
    array_free(&found.place);
    mesh_free(&m);
    array_free(&p);
}
END_TEST

/* Only where a crease is known to run is it looked for. */
START_TEST(near_to_a_zone)
{
    struct vec3s p = {0}, known = {0};
    size_t flat;
    rectangle(&p, 3000, vec(0, 0, 0), vec(-20, 0, -10), vec(0, 25, 0), 0);
    rectangle(&p, 3000, vec(0, 0, 0), vec(20, 0, -10), vec(0, 25, 0), 0);
    for (double y = 0; y <= 8; y += 0.5)
        *array_push(&known) = vec(0, y, 0);
    struct feature_zone zone = feature_zone_make(known.item, known.n, 1.3);
    struct mesh m = mesh_of(&p, 1.3, &flat);
    struct feature_scan scan = {p.item, p.n, flat, 0.43, 0, NULL, &zone};
    struct feature_mesh found = feature_mesh_keep(&m, &scan, 1, 2);
    ck_assert_uint_gt(found.creases, 6);
    for (size_t i = 0; i < found.place.n; i++)
        ck_assert_double_le(found.place.item[i].y, 17);
    feature_zone_free(&zone);
    array_free(&found.place);
    array_free(&known);
    mesh_free(&m);
    array_free(&p);
}
END_TEST

START_TEST(a_step)
{
    struct vec3s p = {0};
    size_t flat;
    rectangle(&p, 3000, vec(0, 0, 0), vec(-20, 0, 0), vec(0, 25, 0), 0);
    rectangle(&p, 3000, vec(0, 0, 6), vec(20, 0, 0), vec(0, 25, 0), 0);
    rectangle(&p, 900, vec(0, 0, 0), vec(0, 25, 0), vec(0, 0, 6), 0);
    struct mesh m = mesh_of(&p, 1.3, &flat);
    ck_assert_double_gt(worst(&m, from_step), 0.3);
    ck_assert_uint_gt(
        feature_mesh_walls(&m, &(struct feature_scan){p.item, p.n, flat, 0.43, 0, NULL, NULL}, 1, 2)
            .found,
        20);
    ck_assert_uint_eq(
        feature_mesh_walls(&m, &(struct feature_scan){p.item, p.n, p.n, 0.43, 0, NULL, NULL}, 1, 2)
            .found,
        0);
    struct feature_mesh found =
        feature_mesh_keep(&m, &(struct feature_scan){p.item, p.n, flat, 0.43, 0, NULL, NULL}, 1, 2);
    ck_assert_uint_gt(found.walls, 20);
    ck_assert_double_le(worst(&m, from_step), 0.1);
    array_free(&found.place);
    mesh_free(&m);
    array_free(&p);
}
END_TEST

/* The walls of a step alone, tried: about as close as the whole search brings it; of a plane there
 * are none, and it stays as it is. */
START_TEST(walls_tried)
{
    struct vec3s p = {0};
    size_t flat, facets;
    rectangle(&p, 3000, vec(0, 0, 0), vec(-20, 0, 0), vec(0, 25, 0), 0);
    rectangle(&p, 3000, vec(0, 0, 6), vec(20, 0, 0), vec(0, 25, 0), 0);
    rectangle(&p, 900, vec(0, 0, 0), vec(0, 25, 0), vec(0, 0, 6), 0);
    struct mesh m = mesh_of(&p, 1.3, &flat);
    facets = m.face.n;
    struct feature_scan scan = {p.item, p.n, flat, 0.43, 0, NULL, NULL};
    ck_assert_uint_gt(feature_mesh_try_walls(&m, &scan, 1, 2).found, 20);
    ck_assert_uint_gt(m.face.n, facets);
    ck_assert_double_le(worst(&m, from_step), 0.3);
    facets = m.face.n;
    scan.flat = scan.n;
    ck_assert_uint_eq(feature_mesh_try_walls(&m, &scan, 1, 2).found, 0);
    ck_assert_uint_eq(m.face.n, facets);
    mesh_free(&m);
    array_free(&p);
}
END_TEST

static size_t walls_of(const struct mesh *m, const struct vec3s *p, size_t flat)
{
    return feature_mesh_walls(m, &(struct feature_scan){p->item, p->n, flat, 0.43, 0, NULL, NULL},
                              1, 2)
        .found;
}

/* A facet across a step counts as any other if it is the first; and where it is there twice, so
 * that its edges have three, no wall is found at these. */
START_TEST(walls_at_a_facet)
{
    struct vec3s p = {0};
    size_t flat, looked = 0;
    rectangle(&p, 3000, vec(0, 0, 0), vec(-20, 0, 0), vec(0, 25, 0), 0);
    rectangle(&p, 3000, vec(0, 0, 6), vec(20, 0, 0), vec(0, 25, 0), 0);
    rectangle(&p, 900, vec(0, 0, 0), vec(0, 25, 0), vec(0, 0, 6), 0);
    struct mesh m = mesh_of(&p, 1.3, &flat);
    size_t walls = walls_of(&m, &p, flat);
    for (size_t f = 1; f < m.face.n && looked < 3; f++) {
        struct face face = m.face.item[f];
        double low = HUGE_VAL, high = -HUGE_VAL, y = 0;
        for (int k = 0; k < 3; k++) {
            struct vec3 v = m.vertex.item[face.v[k]];
            low = fmin(low, v.z);
            high = fmax(high, v.z);
            y += v.y / 3;
        }
        if (high - low < 5 || fabs(y - 12.5) > 8)
            continue;
        looked++;
        m.face.item[f] = m.face.item[0];
        m.face.item[0] = face;
        ck_assert_uint_eq(walls_of(&m, &p, flat), walls);
        *array_push(&m.face) = face;
        ck_assert_uint_lt(walls_of(&m, &p, flat), walls);
        m.face.n--;
        m.face.item[0] = m.face.item[f];
        m.face.item[f] = face;
    }
    ck_assert_uint_eq(looked, 3);
    mesh_free(&m);
    array_free(&p);
}
END_TEST

/* A box 6 mm high, its corner at the origin. */
static double from_box(struct vec3 p)
{
    double up = hypot(hypot(fmax(p.x, 0), fmax(p.y, 0)), p.z - 6), ground = fabs(p.z);
    double right = hypot(hypot(p.x, p.z - fmin(fmax(p.z, 0), 6)), fmax(p.y, 0));
    double front = hypot(hypot(p.y, p.z - fmin(fmax(p.z, 0), 6)), fmax(p.x, 0));
    if (p.x < 0 && p.y < 0)
        ground = hypot(p.z, fmin(-p.x, -p.y));
    return fmin(fmin(up, ground), fmin(right, front));
}

/* Where two walls meet, with noise and without: facets are on the box, and its corner is there. */
START_TEST(a_corner)
{
    for (int i = 0; i < 2; i++) {
        struct vec3s p = {0};
        size_t flat;
        double noise = i * 0.02, top = INFINITY, foot = INFINITY;
        rectangle(&p, 900, vec(0, 0, 6), vec(-12, 0, 0), vec(0, -12, 0), noise);
        rectangle(&p, 1800, vec(0, 12, 0), vec(12, 0, 0), vec(0, -24, 0), noise);
        rectangle(&p, 900, vec(-12, 0, 0), vec(12, 0, 0), vec(0, 12, 0), noise);
        rectangle(&p, 450, vec(0, 0, 0), vec(0, -12, 0), vec(0, 0, 6), noise);
        rectangle(&p, 450, vec(0, 0, 0), vec(-12, 0, 0), vec(0, 0, 6), noise);
        struct mesh m = mesh_of(&p, 1.2, &flat);
        struct feature_mesh found = feature_mesh_keep(
            &m, &(struct feature_scan){p.item, p.n, flat, 0.4, noise, NULL, NULL}, 1, 2);
        ck_assert_uint_gt(found.walls, 20);
        ck_assert_double_le(worst(&m, from_box), 0.1);
        for (size_t v = 0; v < m.vertex.n; v++) {
            top = fmin(top, vec_distance(m.vertex.item[v], vec(0, 0, 6)));
            foot = fmin(foot, vec_distance(m.vertex.item[v], vec(0, 0, 0)));
        }
        ck_assert_double_le(fmax(top, foot), 0.1);
        array_free(&found.place);
        mesh_free(&m);
        array_free(&p);
    }
}
END_TEST

/* Waves with a radius of 9 mm and noise. */
START_TEST(waves_stay)
{
    struct vec3s p = {0};
    size_t flat;
    for (int i = 0; i < 6000; i++) {
        double x = 40 * uniform(), y = 25 * uniform();
        *array_push(&p) = vec(x, y, 3 * sin(x / 5) * cos(y / 7) + 0.02 * normal());
    }
    struct mesh m = mesh_of(&p, 1.3, &flat);
    size_t vertices = m.vertex.n;
    struct feature_mesh found = feature_mesh_keep(
        &m, &(struct feature_scan){p.item, p.n, flat, 0.43, 0.02, NULL, NULL}, 1, 2);
    ck_assert_uint_eq(found.creases + found.walls, 0);
    ck_assert_uint_eq(m.vertex.n, vertices);
    array_free(&found.place);
    mesh_free(&m);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_mesh");
    TCase *tests = tcase_create("feature_mesh");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, roof);
    tcase_add_test(tests, near_to_a_zone);
    tcase_add_test(tests, a_step);
    tcase_add_test(tests, walls_tried);
    tcase_add_test(tests, walls_at_a_facet);
    tcase_add_test(tests, a_corner);
    tcase_add_test(tests, waves_stay);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

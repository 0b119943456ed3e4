/* adaptive_rows, with row_simplify and strip_triangulate: how far a mesh is off surfaces that are
 * known. */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>

#include "noisy.h"
#include "panel.h"
#include "meshing/adaptive_rows.h"
#include "meshing/adaptive_rows_steps.h"

static struct vec3s scan;
static struct point_grid point_grid;
static struct holes holes;
static struct plan_extent plan_extent;
static struct mesh mesh;

static double tilted(double x, double y)
{
    return 0.3 * x - 0.2 * y;
}

/* Weakly curved, with a rib 0.8 mm high and about 1 mm wide, 25 degrees off the columns. */
static double base(double x, double y)
{
    return 5 - 0.004 * x * x - 0.006 * y * y;
}

static double ridge(double x, double y)
{
    double s = (x * cos(RADIANS(25)) + y * sin(RADIANS(25)) - 3) / 0.6;
    return base(x, y) + 0.8 * exp(-s * s);
}

static void sort(double spacing, double direction)
{
    struct error error;
    plan_extent = plan_extent_of(scan.item, scan.n, direction);
    ck_assert_int_eq(holes_find(scan.item, scan.n, 6 * spacing, 3 * spacing, &holes, &error), 0);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, spacing, 2, &point_grid, &error), 0);
}

static void make_scan(double (*height)(double, double), int n, enum noisy_pattern pattern)
{
    noisy_seed(31);
    noisy_scan(&scan, height, n, pattern, 0);
    sort(sqrt(74 * 54 / (double)n), 0);
}

static void free_all(void)
{
    array_free(&scan);
    point_grid_free(&point_grid);
    holes_free(&holes);
    mesh_free(&mesh);
}

/* What the scan does not know about a surface of this curvature at a place of it: its nearest point
 * is so far off, and a chord over twice that sinks by half the curvature times its square. */
static double unknown_at(double x, double y, double z, double curvature)
{
    uint32_t index;
    double distance2 = 0;
    point_grid_nearest(&point_grid, vec(x, y, z), 1, &index, &distance2);
    return curvature / 2 * distance2;
}

/* Height of the true surface over the middles of facets and edges, against theirs, at worst, beyond
 * what the scan does not know. */
static double worst_off(double (*height)(double, double), double curvature)
{
    double worst = 0;
    for (size_t f = 0; f < mesh.face.n; f++) {
        const int *v = mesh.face.item[f].v;
        struct vec3 a = mesh.vertex.item[v[0]], b = mesh.vertex.item[v[1]];
        struct vec3 c = mesh.vertex.item[v[2]], ab = vec_mix(a, b, 0.5),
                    middle = vec_mix(ab, c, 1.0 / 3);
        struct vec3 at[2] = {ab, middle};
        for (int k = 0; k < 2; k++) {
            double z = height(at[k].x, at[k].y), up = noisy_up(height, at[k].x, at[k].y).z;
            worst =
                fmax(worst, fabs(at[k].z - z) * up - unknown_at(at[k].x, at[k].y, z, curvature));
        }
    }
    return worst;
}

/* Area of the facets seen from above; all of them look up. */
static double area(void)
{
    double sum = 0;
    for (size_t f = 0; f < mesh.face.n; f++) {
        struct vec3 cross = mesh_face_cross(&mesh, f);
        ck_assert_double_gt(cross.z, 0);
        sum += cross.z / 2;
    }
    return sum;
}

/* Its recess, 2.2 exp(-(y / 6)^2) deep, and its crown: 2 * 2.2 / 36 + 10 / 27^2. */
static const double PANEL_CURVATURE = 0.14;

START_TEST(panel)
{
    const double error[] = {0.2, 0.05, 0.02};
    size_t before = 0;
    make_scan(panel_height, 17000, (enum noisy_pattern)_i);
    for (int k = 0; k < 3; k++) {
        struct adaptive_rows r = adaptive_rows_make(
            &point_grid, &plan_extent, &holes,
            &(struct adaptive_rows_options){error[k], 0.48, 12, NULL, 0, 1}, &mesh);
        ck_assert_double_le(r.worst, error[k]);
        ck_assert_double_lt(r.rms, error[k] / 2);
        ck_assert_double_lt(worst_off(panel_height, PANEL_CURVATURE), 1.25 * error[k]);
        ck_assert_uint_gt(mesh.vertex.n, before);
        ck_assert_double_gt(area(), 0.99 * 74 * 54);
        ck_assert_uint_lt(r.beside, scan.n / 200);
        before = mesh.vertex.n;
        if (k == 1)
            ck_assert_uint_lt(mesh.vertex.n, 1400);
        mesh_free(&mesh);
    }
}
END_TEST

/* Rows are rows: each at one place across, its nodes in order, joined by facets. */
START_TEST(rows_are_rows)
{
    noisy_seed(31);
    noisy_scan(&scan, panel_height, 17000, NOISY_RANDOM, 0);
    sort(0.48, 30);
    struct adaptive_rows r =
        adaptive_rows_make(&point_grid, &plan_extent, &holes,
                           &(struct adaptive_rows_options){0.05, 0.48, 12, NULL, 0, 1}, &mesh);
    ck_assert_double_le(r.worst, 0.05);
    ck_assert_uint_eq(mesh.row.n, mesh.vertex.n);
    for (size_t i = 1; i < mesh.vertex.n; i++) {
        struct vec3 p = plan_extent_turn(&plan_extent, mesh.vertex.item[i - 1]);
        struct vec3 q = plan_extent_turn(&plan_extent, mesh.vertex.item[i]);
        ck_assert_int_ge(mesh.row.item[i], mesh.row.item[i - 1]);
        if (mesh.row.item[i] > mesh.row.item[i - 1])
            continue;
        ck_assert_int_gt(mesh.col.item[i], mesh.col.item[i - 1]);
        ck_assert_double_gt(q.x, p.x);
        ck_assert_double_lt(fabs(q.y - p.y), 0.6);
    }
}
END_TEST

/* Rows of a rough scan on lines take the points of a line that is nearest to both: as wide as
 * nothing, a strip between them costs without end whichever way it is joined. */
START_TEST(two_rows_on_one_line)
{
    for (int j = 0; j < 8; j++)
        for (int i = 0; i < 80; i++)
            *array_push(&scan) = vec(0.1 * i, j, (i * 7 + j * 5) % 13 * 0.1);
    sort(0.3, 0);
    struct adaptive_rows r =
        adaptive_rows_make(&point_grid, &plan_extent, &holes,
                           &(struct adaptive_rows_options){0.01, 0.3, 12, NULL, 0, 1}, &mesh);
    ck_assert_uint_gt(mesh.vertex.n, 0);
    ck_assert_double_le(r.worst, 1.3);
    for (size_t f = 0; f < mesh.face.n; f++)
        for (int k = 0; k < 3; k++)
            ck_assert_uint_lt((size_t)mesh.face.item[f].v[k], mesh.vertex.n);
}
END_TEST

START_TEST(plane_takes_few)
{
    make_scan(tilted, 17000, NOISY_RANDOM);
    struct adaptive_rows r =
        adaptive_rows_make(&point_grid, &plan_extent, &holes,
                           &(struct adaptive_rows_options){0.01, 0.48, 12, NULL, 0, 1}, &mesh);
    ck_assert_double_lt(r.worst, 1e-6);
    /* five rows 12 mm apart at most, and the borders of a random cloud, which are not straight */
    ck_assert_uint_le(mesh.vertex.n, 100);
    ck_assert_double_gt(area(), 0.98 * 74 * 54);
}
END_TEST

/* On the crest of the rib, at this y: what the scan does not know of it, with the flanks' rounding
 * of 2 * 0.8 / 0.6^2. */
static double unknown_on_rib(double y)
{
    double x = (3 - y * sin(RADIANS(25))) / cos(RADIANS(25));
    return unknown_at(x, y, ridge(x, y), 2 * 0.8 / 0.36);
}

/* A rib that is narrower than the rows are apart: kept along its whole crest. */
START_TEST(rib)
{
    make_scan(ridge, 100000, (enum noisy_pattern)_i);
    adaptive_rows_make(&point_grid, &plan_extent, &holes,
                       &(struct adaptive_rows_options){0.05, 0.2, 4.8, NULL, 0, 1}, &mesh);
    int rows = mesh.row.item[mesh.row.n - 1] + 1;
    double *kept = mem_alloc((size_t)rows, sizeof *kept);
    double *unknown = mem_alloc((size_t)rows, sizeof *unknown);
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 p = mesh.vertex.item[i];
        int r = mesh.row.item[i];
        if (p.z - base(p.x, p.y) > kept[r]) {
            kept[r] = p.z - base(p.x, p.y);
            unknown[r] = unknown_on_rib(p.y);
        }
    }
    for (int r = 1; r + 1 < rows; r++)
        ck_assert_double_gt(kept[r], 0.75 - unknown[r]);
    free(kept);
    free(unknown);
    double lost = 0;
    for (double y = -26; y <= 26; y += 0.1) { /* the facets between the rows keep it too */
        double x = (3 - y * sin(RADIANS(25))) / cos(RADIANS(25)), top = -1;
        for (size_t f = 0; f < mesh.face.n; f++) {
            struct vec3 p[3], at = vec(x, y, 0);
            for (int k = 0; k < 3; k++)
                p[k] = mesh.vertex.item[mesh.face.item[f].v[k]];
            struct vec3 n = mesh_face_cross(&mesh, f);
            bool inside = true;
            for (int k = 0; k < 3; k++) {
                struct vec3 e = vec_sub(p[(k + 1) % 3], p[k]), d = vec_sub(at, p[k]);
                inside = inside && e.x * d.y - e.y * d.x >= 0;
            }
            if (inside)
                top = p[0].z - ((at.x - p[0].x) * n.x + (at.y - p[0].y) * n.y) / n.z;
        }
        lost = fmax(lost, base(x, y) + 0.8 - top - unknown_on_rib(y));
    }
    ck_assert_double_lt(lost, 0.05);
}
END_TEST

/* A hole 12 mm wide: no facet over it, and little of its rim is lost. */
START_TEST(hole)
{
    noisy_seed(8);
    for (int i = 0; i < 17000; i++) {
        double x = 74 * noisy_uniform() - 37, y = 54 * noisy_uniform() - 27;
        if (hypot(x, y) > 6)
            *array_push(&scan) = vec(x, y, tilted(x, y));
    }
    sort(0.48, 0);
    struct adaptive_rows r =
        adaptive_rows_make(&point_grid, &plan_extent, &holes,
                           &(struct adaptive_rows_options){0.05, 0.48, 12, NULL, 0, 1}, &mesh);
    ck_assert_double_lt(r.worst, 1e-6);
    for (size_t f = 0; f < mesh.face.n; f++) {
        const int *v = mesh.face.item[f].v;
        struct vec3 middle =
            vec_scale(1.0 / 3, vec_add(mesh.vertex.item[v[0]],
                                       vec_add(mesh.vertex.item[v[1]], mesh.vertex.item[v[2]])));
        ck_assert_double_gt(hypot(middle.x, middle.y), 4);
    }
    ck_assert_double_gt(area(), 0.95 * (74 * 54 - PI * 36));
}
END_TEST

/* Where points are too far apart for the error it says how far off they are, and where. */
START_TEST(out_of_reach)
{
    make_scan(ridge, 4000, NOISY_RANDOM);
    struct adaptive_rows r =
        adaptive_rows_make(&point_grid, &plan_extent, &holes,
                           &(struct adaptive_rows_options){0.01, 1, 12, NULL, 0, 1}, &mesh);
    ck_assert_double_gt(r.worst, 0.01);
    double s = r.at.x * cos(RADIANS(25)) + r.at.y * sin(RADIANS(25)) - 3;
    ck_assert_double_lt(fabs(s), 3);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("adaptive_rows");
    TCase *tests = tcase_create("adaptive_rows");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, panel, 0, 3);
    tcase_add_test(tests, rows_are_rows);
    tcase_add_test(tests, two_rows_on_one_line);
    tcase_add_test(tests, plane_takes_few);
    tcase_add_loop_test(tests, rib, 0, 3);
    tcase_add_test(tests, hole);
    tcase_add_test(tests, out_of_reach);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

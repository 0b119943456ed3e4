/* grid_mesh: a cloud that stands on its nodes gives the paper's rows of triangles. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "meshing/grid_mesh.h"
#include "meshing/reposition.h"
#include "math/elementary.h"
#include "seed.h"

static struct vec3s cloud;
static struct mesh mesh;
static struct grid grid;

enum { ROWS = 5, COLUMNS = 6, ASIDE = 2 }; /* by the lean, 4 rows of sqrt(3) over sqrt(3) = 2 t */

/* A point on every node of a parallelogram of spacing 2, in an order of its own. */
static void make_cloud(void)
{
    struct error error;
    for (int row = ROWS - 1; row >= 0; row--)
        for (int column = 0; column < COLUMNS; column++)
            *array_push(&cloud) =
                vec(2 * (column + 0.5 * row), 2 * GRID_SLANT * row, 0.1 * column * row);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_int_eq(grid_make(&f, cloud.n, 2, &grid, &error), 0);
}

static void free_all(void)
{
    array_free(&cloud);
    mesh_free(&mesh);
}

static struct grid_mesh_count make_mesh(const struct holes *holes)
{
    size_t *chosen = reposition(&grid, cloud.item, cloud.n, REACH_NEAREST, 1);
    struct grid_mesh_count count = grid_mesh_make(&grid, chosen, cloud.item, holes, 1, &mesh);
    free(chosen);
    return count;
}

static bool points_up(const struct face *f)
{
    const int *row = mesh.row.item;
    return row[f->v[0]] == row[f->v[1]];
}

START_TEST(rows_of_triangles)
{
    struct grid_mesh_count count = make_mesh(NULL);
    ck_assert_uint_eq(mesh.vertex.n, 30);
    ck_assert_uint_eq(mesh.row.n, 30);
    ck_assert_uint_eq(mesh.col.n, 30);
    ck_assert_uint_eq(mesh.face.n, 4 * 2 * 5);
    ck_assert_uint_eq(count.bridges + count.no_area + count.alone, 0);
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 node = grid_node(&grid, mesh.col.item[i], mesh.row.item[i]);
        struct vec3 v = mesh.vertex.item[i];
        ck_assert_int_eq(mesh.col.item[i], ASIDE + (int)i % COLUMNS);
        ck_assert_double_eq_tol(hypot(v.x - node.x, v.y - node.y), 0, 1e-12);
        if (i > 0)
            ck_assert(mesh.row.item[i] > mesh.row.item[i - 1] ||
                      mesh.col.item[i] > mesh.col.item[i - 1]);
    }
    /* row by row, in each the 5 that point up, then the 5 that point down, all from left to right
     * and counter-clockwise seen from above */
    for (size_t f = 0; f < mesh.face.n; f++) {
        const struct face *face = &mesh.face.item[f];
        int lowest = mesh.row.item[face->v[0]];
        ck_assert_int_eq(lowest, (int)f / 10);
        ck_assert_int_eq(points_up(face), f % 10 < 5);
        struct vec3 cross = mesh_face_cross(&mesh, f);
        ck_assert_double_eq_tol(cross.z, 2 * 2 * GRID_SLANT, 1e-12);
        if (f % 5 > 0)
            ck_assert_double_gt(mesh.vertex.item[face->v[0]].x,
                                mesh.vertex.item[mesh.face.item[f - 1].v[0]].x);
    }
}
END_TEST

/* Without the point of an inner node its six triangles are missing. */
START_TEST(node_without_a_point)
{
    cloud.item[7] = cloud.item[cloud.n - 1]; /* of row 3, column 1 */
    make_mesh(NULL);
    ck_assert_uint_eq(mesh.vertex.n, 29);
    ck_assert_uint_eq(mesh.face.n, 40 - 6);
}
END_TEST

START_TEST(hole)
{
    struct holes h;
    struct error error;
    ck_assert_int_eq(holes_find(cloud.item, cloud.n, 1.5, 0.75, &h, &error), 0);
    struct grid_mesh_count count = make_mesh(&h); /* discs of 2.3 fit between the points */
    ck_assert_uint_eq(mesh.face.n, 0);
    ck_assert_uint_eq(count.bridges, 40);
    ck_assert_uint_eq(count.alone, 30);
    ck_assert_uint_eq(mesh.vertex.n, 0);
    holes_free(&h);
}
END_TEST

/* The paper's circle may give a point to two nodes: no facet has it twice. */
START_TEST(point_of_two_nodes)
{
    struct vec3 few[] = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {1, 1.7, 0}, {3.4, 1.9, 0}};
    struct plan_extent f = plan_extent_of(few, 5, 0);
    struct error error;
    ck_assert_int_eq(grid_make(&f, 5, 1.3, &grid, &error), 0);
    size_t *chosen = reposition(&grid, few, 5, REACH_CIRCLE, 1);
    struct grid_mesh_count count = grid_mesh_make(&grid, chosen, few, NULL, 1, &mesh);
    free(chosen);
    ck_assert_uint_gt(mesh.vertex.n, 5);
    ck_assert_uint_gt(count.no_area, 0);
    for (size_t i = 0; i < mesh.face.n; i++)
        ck_assert_double_gt(vec_length(mesh_face_cross(&mesh, i)), 0.01);
}
END_TEST

/* Rows of nodes are looked at by several threads: the facets, their order and the counts are those
 * of one. */
START_TEST(threads)
{
    struct error error;
    struct holes holes;
    uint64_t state = 1;
    array_free(&cloud);
    for (int i = 0; i < 9000; i++) {
        double at[3];
        for (int k = 0; k < 3; k++) {
            state = state * 6364136223846793005u + seed_step();
            at[k] = (double)(state >> 40) / (1 << 24);
        }
        if (hypot(at[0] - 0.5, at[1] - 0.5) > 0.2) /* a hole */
            *array_push(&cloud) = vec(100 * at[0], 60 * at[1], 3 * at[2]);
    }
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_int_eq(grid_make(&f, cloud.n, 1.3, &grid, &error), 0);
    ck_assert_int_eq(holes_find(cloud.item, cloud.n, 2, 0.8, &holes, &error), 0);
    struct grid_mesh_count one = make_mesh(&holes);
    ck_assert_uint_gt(one.bridges, 0);
    ck_assert_uint_gt(one.folded, 0);
    ck_assert_uint_gt(mesh.face.n, 3000);
    size_t *chosen = reposition(&grid, cloud.item, cloud.n, REACH_NEAREST, 1);
    for (int n = 2; n < 6; n++) {
        struct mesh other = {0};
        struct grid_mesh_count count = grid_mesh_make(&grid, chosen, cloud.item, &holes, n, &other);
        ck_assert_int_eq(memcmp(&count, &one, sizeof one), 0);
        ck_assert_uint_eq(other.face.n, mesh.face.n);
        ck_assert_int_eq(
            memcmp(other.face.item, mesh.face.item, mesh.face.n * sizeof *mesh.face.item), 0);
        ck_assert_uint_eq(other.vertex.n, mesh.vertex.n);
        mesh_free(&other);
    }
    free(chosen);
    holes_free(&holes);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("grid_mesh");
    TCase *tests = tcase_create("grid_mesh");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, make_cloud, free_all);
    tcase_add_test(tests, rows_of_triangles);
    tcase_add_test(tests, node_without_a_point);
    tcase_add_test(tests, hole);
    tcase_add_test(tests, point_of_two_nodes);
    tcase_add_test(tests, threads);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

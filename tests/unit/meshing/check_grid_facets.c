/* grid_facets: the same vertices, normals and facets as the mesh that is kept, from points that
 * come in blocks of any size. */
#include <check.h>
#include <stdlib.h>

#include "meshing/grid_facets.h"
#include "seed.h"

enum { N = 4000 };

static struct vec3 point[N];

/* A wavy plate, 40 x 30 mm, with a hole and a corner missing. */
static size_t make_points(void)
{
    uint64_t state = 11;
    size_t n = 0;

    for (int i = 0; i < N; i++) {
        state = state * 6364136223846793005u + seed_step();
        double x = (double)(state >> 40) / 419430.4;
        state = state * 6364136223846793005u + seed_step();
        double y = (double)(state >> 40) / 559240.5;
        if (hypot(x - 15, y - 15) > 5 && !(x > 30 && y > 20))
            point[n++] = vec(x, y, sin(x / 4) * cos(y / 5));
    }
    return n;
}

struct seen {
    const struct mesh *mesh;
    size_t vertices, faces;
};

static void check_vertex(void *context, struct vec3 at, struct vec3 normal, int row, int column)
{
    struct seen *s = context;
    size_t i = s->vertices++;

    ck_assert_uint_lt(i, s->mesh->vertex.n);
    ck_assert_double_eq(vec_distance(at, s->mesh->vertex.item[i]), 0);
    ck_assert_double_eq(vec_distance(normal, s->mesh->normal.item[i]), 0);
    ck_assert_int_eq(row, s->mesh->row.item[i]);
    ck_assert_int_eq(column, s->mesh->col.item[i]);
}

static void check_face(void *context, const int corner[3])
{
    struct seen *s = context;
    size_t f = s->faces++;

    ck_assert_uint_lt(f, s->mesh->face.n);
    for (int i = 0; i < 3; i++)
        ck_assert_int_eq(corner[i], s->mesh->face.item[f].v[i]);
}

/* All points `block` at a time. */
static void in_blocks(struct reposition *r, size_t n, size_t block, bool fill)
{
    for (size_t i = 0; i < n; i += block)
        (fill ? reposition_fill : reposition_add)(r, point + i, n - i < block ? n - i : block);
}

/* Rows and columns of it as a mesh: the vertices there, and the facets between them. */
static void check_part(const struct grid_facets *facets, const struct mesh *mesh, int row0,
                       int row1, int column0, int column1)
{
    struct mesh part = {.origin.ledger = NAN};
    int *number = malloc(mesh->vertex.n * sizeof *number);
    size_t vertices = 0, faces = 0;

    grid_facets_part(facets, row0, row1, column0, column1, &part);
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        int row = mesh->row.item[v], column = mesh->col.item[v];
        number[v] = -1;
        if (row < row0 || row > row1 || column < column0 || column > column1)
            continue;
        ck_assert_uint_lt(vertices, part.vertex.n);
        ck_assert_int_eq(part.row.item[vertices], row);
        ck_assert_int_eq(part.col.item[vertices], column);
        ck_assert_double_eq(vec_distance(part.vertex.item[vertices], mesh->vertex.item[v]), 0);
        number[v] = (int)vertices++;
    }
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        if (number[v[0]] < 0 || number[v[1]] < 0 || number[v[2]] < 0)
            continue;
        ck_assert_uint_lt(faces, part.face.n);
        for (int i = 0; i < 3; i++)
            ck_assert_int_eq(part.face.item[faces].v[i], number[v[i]]);
        faces++;
    }
    ck_assert_uint_eq(part.vertex.n, vertices);
    ck_assert_uint_eq(part.face.n, faces);
    free(number);
    mesh_free(&part);
}

static void check_numbers(const struct grid_facets *facets, const struct mesh *mesh)
{
    size_t n = mesh->vertex.n, number[4] = {0, 1, n / 2, n - 1};
    int row[4], column[4];

    grid_facets_numbered(facets, number, 4, row, column);
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(row[i], mesh->row.item[number[i]]);
        ck_assert_int_eq(column[i], mesh->col.item[number[i]]);
        struct vec3 at = grid_facets_vertex(facets, number[i]);
        ck_assert_double_eq(vec_distance(at, mesh->vertex.item[number[i]]), 0);
    }
}

START_TEST(as_the_mesh_that_is_kept)
{
    static const double spacing[] = {0.5, 1, 3}, direction[] = {0, 33, -70};
    static const size_t block[] = {1, 97, N};
    size_t n = make_points();
    struct plan_extent f = plan_extent_of(point, n, direction[_i]);
    struct grid grid;
    struct holes holes;
    struct reposition r;
    struct error error;
    struct mesh mesh = {.origin.ledger = NAN};
    ck_assert_int_eq(grid_make(&f, n, spacing[_i], &grid, &error), 0);
    ck_assert_int_eq(holes_find(point, n, 4, 1, &holes, &error), 0);
    size_t *chosen = reposition(&grid, point, n, REACH_NEAREST, 1);
    struct grid_mesh_count count = grid_mesh_make(&grid, chosen, point, &holes, 1, &mesh);
    mesh_normals_facet(&mesh);

    ck_assert_int_eq(reposition_begin(&grid, n, REACH_NEAREST, &r, &error), 0);
    in_blocks(&r, n, block[_i], false);
    if (reposition_empty(&r)) {
        in_blocks(&r, n, block[_i], true);
        reposition_settle(&r);
    }
    struct grid_facets facets = grid_facets_find(&r, &holes);
    struct seen seen = {.mesh = &mesh};
    grid_facets_vertices(&facets, check_vertex, &seen);
    grid_facets_faces(&facets, check_face, &seen);
    ck_assert_uint_eq(seen.vertices, mesh.vertex.n);
    ck_assert_uint_eq(seen.faces, mesh.face.n);
    ck_assert_uint_eq(facets.vertices, mesh.vertex.n);
    ck_assert_uint_eq(facets.facets, mesh.face.n);
    ck_assert_uint_gt(facets.facets, 100);
    ck_assert_uint_eq(facets.count.bridges, count.bridges);
    ck_assert_uint_eq(facets.count.alone, count.alone);
    ck_assert_double_eq(facets.steep, mesh_steep_part(&mesh, vec(0, 0, 1)));
    check_part(&facets, &mesh, 0, grid.rows - 1, 0, grid.columns - 1);
    check_part(&facets, &mesh, grid.rows / 3, grid.rows / 2, 0, grid.columns - 1);
    check_part(&facets, &mesh, 3, 7, grid.columns / 3, grid.columns / 2);
    check_numbers(&facets, &mesh);
    grid_facets_free(&facets);
    reposition_free(&r);
    holes_free(&holes);
    free(chosen);
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("grid_facets");
    TCase *tests = tcase_create("grid_facets");
    tcase_add_loop_test(tests, as_the_mesh_that_is_kept, 0, 3);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

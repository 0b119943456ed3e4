/* rows of small triangular grids, turned, with holes and with rows that run backwards. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "toolpath/rows.h"

enum { ROWS = 4, COLS = 6 };

/* A triangular grid of spacing 2, its rows turned by `angle`, rising to the right of them when
 * `mirror`; vertices in an order of their own; without the facets of vertex (hole_row, hole_col).
 */
static struct mesh make_mesh(double angle, bool mirror, int hole_row, int hole_col)
{
    struct mesh mesh = {.origin = {.direction = NAN, .ledger = NAN, .spacing = 2}};
    int at[ROWS][COLS];

    for (int k = ROWS * COLS - 1; k >= 0; k--) {
        int row = k / COLS, col = k % COLS;
        double u = 2 * col + row + 0.1 * ((row * 7 + col * 3) % 5), v = sqrt(3) * row;
        if (mirror)
            v = -v;
        at[row][col] = (int)mesh.vertex.n;
        *array_push(&mesh.vertex) =
            vec(u * cos(angle) - v * sin(angle), u * sin(angle) + v * cos(angle), 0.1 * col);
        *array_push(&mesh.row) = row + 3;
        *array_push(&mesh.col) = col - row;
    }
    for (int row = 0; row + 1 < ROWS; row++) {
        for (int col = 0; col + 1 < COLS; col++) {
            int a = at[row][col], b = at[row][col + 1];
            int c = at[row + 1][col], d = at[row + 1][col + 1], hole = -1;
            if (hole_row >= 0)
                hole = at[hole_row][hole_col];
            if (a != hole && b != hole && c != hole)
                *array_push(&mesh.face) = (struct face){{a, b, c}};
            if (b != hole && d != hole && c != hole)
                *array_push(&mesh.face) = (struct face){{b, d, c}};
        }
    }
    return mesh;
}

START_TEST(each_row_is_a_strip_by_rising_column)
{
    struct mesh mesh = make_mesh(0.5, false, -1, -1);
    struct rows rows;
    struct error error;
    ck_assert_int_eq(rows_find(&mesh, &rows, &error), 0);
    ck_assert_uint_eq(rows.strip.n, ROWS);
    ck_assert_uint_eq(rows.loose, 0);
    for (size_t s = 0; s < rows.strip.n; s++) {
        struct strip strip = rows.strip.item[s];
        ck_assert_int_eq(strip.row, (int)s + 3);
        ck_assert_uint_eq(strip.to - strip.from, COLS);
        for (size_t i = strip.from; i < strip.to; i++) {
            ck_assert_int_eq(mesh.row.item[rows.node.item[i]], strip.row);
            ck_assert_int_eq(mesh.col.item[rows.node.item[i]], (int)(i - strip.from) - (int)s);
        }
    }
    rows_free(&rows);
    mesh_free(&mesh);
}
END_TEST

START_TEST(directions_are_those_of_the_grid)
{
    for (int mirror = 0; mirror < 2; mirror++) {
        double angle = 2.2;
        struct mesh mesh = make_mesh(angle, mirror, -1, -1);
        struct vec3 along = vec(cos(angle), sin(angle), 0);
        struct vec3 left = vec(-sin(angle), cos(angle), 0);
        struct rows rows;
        struct error error;
        ck_assert_int_eq(rows_find(&mesh, &rows, &error), 0);
        ck_assert_double_lt(vec_angle(rows.along, along), 1e-6);
        ck_assert_double_lt(vec_angle(rows.side, vec_scale(mirror ? -1 : 1, left)), 1e-6);
        ck_assert_double_eq_tol(rows.distance, sqrt(3), 1e-9);
        rows_free(&rows);

        /* What the mesh says counts when the rows bear it out, either way round, and only then. */
        mesh.origin.direction = DEGREES(angle) + 2;
        ck_assert_int_eq(rows_find(&mesh, &rows, &error), 0);
        ck_assert_double_eq_tol(vec_angle(rows.along, along), RADIANS(2), 1e-6);
        rows_free(&rows);
        mesh.origin.direction = DEGREES(angle) + 182;
        ck_assert_int_eq(rows_find(&mesh, &rows, &error), 0);
        ck_assert_double_eq_tol(vec_angle(rows.along, along), RADIANS(2), 1e-6);
        rows_free(&rows);
        mesh.origin.direction = 0;
        ck_assert_int_eq(rows_find(&mesh, &rows, &error), 0);
        ck_assert_double_lt(vec_angle(rows.along, along), 1e-6);
        rows_free(&rows);
        mesh_free(&mesh);
    }
}
END_TEST

START_TEST(a_hole_ends_a_strip)
{
    struct mesh mesh = make_mesh(0, false, 1, 3);
    struct rows rows;
    struct error error;
    ck_assert_int_eq(rows_find(&mesh, &rows, &error), 0);
    ck_assert_uint_eq(rows.loose, 1); /* the vertex itself is in no facet any more */
    /* Its row is in two, and so is the border row below, where a facet's edge has gone with it. */
    static const struct {
        int row;
        size_t from, to;
    } want[] = {{3, 0, 4}, {3, 4, 6}, {4, 6, 9}, {4, 9, 11}, {5, 11, 17}, {6, 17, 23}};
    ck_assert_uint_eq(rows.strip.n, 6);
    for (size_t s = 0; s < 6; s++) {
        ck_assert_int_eq(rows.strip.item[s].row, want[s].row);
        ck_assert_uint_eq(rows.strip.item[s].from, want[s].from);
        ck_assert_uint_eq(rows.strip.item[s].to, want[s].to);
    }
    rows_free(&rows);
    mesh_free(&mesh);
}
END_TEST

START_TEST(a_mesh_without_rows_is_refused)
{
    struct mesh mesh = make_mesh(0, false, -1, -1);
    struct rows rows;
    struct error error;
    size_t n = mesh.row.n, faces = mesh.face.n;
    mesh.row.n = 0;
    ck_assert_int_eq(rows_find(&mesh, &rows, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "without rows"));
    mesh.row.n = n;
    mesh.face.n = 0;
    ck_assert_int_eq(rows_find(&mesh, &rows, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "without facets"));
    mesh.face.n = faces;
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rows");
    TCase *tests = tcase_create("rows");
    tcase_add_test(tests, each_row_is_a_strip_by_rising_column);
    tcase_add_test(tests, directions_are_those_of_the_grid);
    tcase_add_test(tests, a_hole_ends_a_strip);
    tcase_add_test(tests, a_mesh_without_rows_is_refused);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

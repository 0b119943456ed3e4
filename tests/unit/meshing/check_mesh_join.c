/* mesh_join: two parts turned back into place, rows one behind the other, their frames; and apart
 * again. */
#include <check.h>
#include <stdlib.h>

#include "toolpath/rows.h"
#include "meshing/mesh_join.h"

/* A flat patch of 3 rows of 4 columns in its own axes, with one vertex between the rows. */
static struct mesh patch(void)
{
    struct mesh m = {0};
    for (int i = 0; i < 12; i++) {
        *array_push(&m.vertex) = vec(i % 4 + 0.5 * (i / 4), i / 4, 2);
        *array_push(&m.normal) = vec(0, 0, 1);
        *array_push(&m.row) = i == 11 ? -1 : i / 4;
        *array_push(&m.col) = i == 11 ? -1 : i % 4;
    }
    for (int i = 0; i < 7; i++)
        if (i % 4 < 3)
            *array_push(&m.face) = (struct face){{i, i + 1, i + 4}};
    return m;
}

START_TEST(two_parts)
{
    struct mesh one = patch(), to = {.origin.spacing = 1};
    struct segment top = {.along = {1, 0, 0}, .across = {0, 1, 0}, .up = {0, 0, 1}};
    struct segment flank = {.along = {0, 1, 0}, .across = {0, 0, 1}, .up = {1, 0, 0}};
    mesh_join_add(&to, &one, &top);
    mesh_join_add(&to, &one, &flank);
    ck_assert_uint_eq(to.vertex.n, 24);
    ck_assert_uint_eq(to.origin.part.n, 2);
    ck_assert_int_eq(to.origin.part.item[1].row, 3);
    ck_assert_int_eq(to.row.item[12], 3);
    ck_assert_int_eq(to.row.item[23], -1);
    ck_assert_double_le(vec_distance(to.vertex.item[13], vec(2, 1, 0)), 1e-12);
    ck_assert_double_le(vec_distance(to.normal.item[13], vec(1, 0, 0)), 1e-12);
    ck_assert_double_gt(mesh_face_cross(&to, to.face.n - 1).x, 0);

    for (size_t k = 0; k < 2; k++) { /* and apart again */
        struct mesh part = mesh_join_of(&to, k);
        ck_assert_uint_eq(part.vertex.n, 12);
        ck_assert_uint_eq(part.face.n, one.face.n);
        for (size_t v = 0; v < 12; v++)
            ck_assert(vec_distance(part.vertex.item[v], to.vertex.item[12 * k + v]) == 0);
        for (size_t f = 0; f < part.face.n; f++)
            for (int i = 0; i < 3; i++)
                ck_assert_int_eq(part.face.item[f].v[i], one.face.item[f].v[i]);
        mesh_free(&part);
    }

    struct rows rows;
    struct error error;
    ck_assert_int_eq(rows_find(&to, &rows, &error), 0);
    for (size_t i = 0; i < rows.strip.n; i++) {
        const struct strip *s = &rows.strip.item[i];
        bool on_top = s->row < 3;
        ck_assert_double_eq(on_top ? s->along.x : s->along.y, 1);
        ck_assert_double_eq(on_top ? s->side.y : s->side.z, 1);
        ck_assert_double_eq(on_top ? s->up.z : s->up.x, 1);
    }
    ck_assert_double_eq_tol(rows.distance, sqrt(0.75), 1e-9);
    rows_free(&rows);
    mesh_free(&one);
    mesh_free(&to);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh_join");
    TCase *tests = tcase_create("mesh_join");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, two_parts);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

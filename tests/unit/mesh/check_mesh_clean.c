/* check_mesh_clean - facets without area, facets twice. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "mesh/mesh_repair_steps.h"

/* Vertices of a unit square, one on its diagonal and one beside that by `off`. */
static struct mesh square(double off)
{
    const struct vec3 corner[] = {vec(0, 0, 0), vec(1, 0, 0),     vec(1, 1, 0),
                                  vec(0, 1, 0), vec(0.5, 0.5, 0), vec(0.25, 0.25 + off, 0)};
    struct mesh mesh = {0};
    for (size_t i = 0; i < sizeof corner / sizeof *corner; i++)
        *array_push(&mesh.vertex) = corner[i];
    return mesh;
}

static void add(struct mesh *mesh, int a, int b, int c)
{
    *array_push(&mesh->face) = (struct face){{a, b, c}};
}

START_TEST(no_area)
{
    struct mesh mesh = square(1e-7);
    add(&mesh, 0, 1, 2);
    add(&mesh, 0, 4, 2); /* in a line */
    add(&mesh, 1, 1, 3); /* two corners */
    add(&mesh, 0, 5, 4); /* thin, but with an area */
    add(&mesh, 3, 3, 3);
    ck_assert_uint_eq(mesh_clean_no_area(&mesh), 3);
    ck_assert_uint_eq(mesh.face.n, 2);
    ck_assert_int_eq(mesh.face.item[0].v[1], 1);
    ck_assert_int_eq(mesh.face.item[1].v[1], 5);
    ck_assert_uint_eq(mesh.vertex.n, 6);
    ck_assert_uint_eq(mesh_clean_no_area(&mesh), 0);
    mesh_free(&mesh);
}
END_TEST

START_TEST(doubled)
{
    static const int turn[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    struct mesh mesh = square(0);
    add(&mesh, 1, 2, 3);
    for (int k = 0; k < 6; k++)
        add(&mesh, turn[k][0], turn[k][1], turn[k][2]);
    add(&mesh, 0, 2, 3);
    ck_assert_uint_eq(mesh_clean_doubled(&mesh), 5);
    ck_assert_uint_eq(mesh.face.n, 3);
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(mesh.face.item[0].v[i], i + 1);
        ck_assert_int_eq(mesh.face.item[1].v[i], i);
    }
    ck_assert_int_eq(mesh.face.item[2].v[1], 2);
    ck_assert_uint_eq(mesh_clean_doubled(&mesh), 0);
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("meshdrop");
    TCase *tcase = tcase_create("meshdrop");
    tcase_add_test(tcase, no_area);
    tcase_add_test(tcase, doubled);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

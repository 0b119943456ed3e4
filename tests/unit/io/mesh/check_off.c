/* check_off - OFF text at the edge of what is taken: counts, corners, indices, comments,
 * normals. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "io/mesh/off.h"
#include "scratch.h"

static struct mesh mesh;
static struct error error;

static int take(const char *text)
{
    struct reader r;
    mesh_free(&mesh);
    mesh = (struct mesh){0};
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    int status = off_read(&r, &mesh, &error);
    reader_close(&r);
    return status;
}

static void taken(const char *text, size_t vertices, size_t faces)
{
    ck_assert_msg(take(text) == 0, "%s", error.text);
    ck_assert_uint_eq(mesh.vertex.n, vertices);
    ck_assert_uint_eq(mesh.face.n, faces);
}

static void teardown(void)
{
    mesh_free(&mesh);
}

#define THREE "0 0 0\n1 0 0\n0 1 0\n"

START_TEST(counts_beside_and_below_the_word)
{
    taken("OFF\n3 1 0\n" THREE "3 0 1 2\n", 3, 1);
    taken("OFF 3 1 0\n" THREE "3 0 1 2\n", 3, 1);
    taken("OFF 3 1\n" THREE "3 0 1 2\n", 3, 1);
    taken("# a\nOFF # b\n\n  3\t1 0 # c\n\n" THREE "# d\n3 0 1 2\n", 3, 1);
    taken("COFF\n3 1 0\n0 0 0 255 0 0 1\n1 0 0 0 0 0 1\n0 1 0 1 2 3 4\n3 0 1 2 7 7 7\n", 3, 1);
}
END_TEST

START_TEST(a_polygon_is_a_fan)
{
    static const int fan[3][3] = {{4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
    taken("OFF 5 1 0\n0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n5 4 3 2 1 0\n", 5, 3);
    for (int f = 0; f < 3; f++)
        for (int k = 0; k < 3; k++)
            ck_assert_int_eq(mesh.face.item[f].v[k], fan[f][k]);
}
END_TEST

START_TEST(normals_are_of_length_one)
{
    taken("NOFF\n3 1 0\n0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 1 0 0\n3 0 1 2\n", 3, 1);
    ck_assert_uint_eq(mesh.normal.n, 3);
    ck_assert_double_eq_tol(mesh.normal.item[0].z, 1, 1e-15);
    ck_assert_double_eq_tol(mesh.normal.item[1].y, 0.6, 1e-15);
    ck_assert_double_eq_tol(mesh.normal.item[1].z, 0.8, 1e-15);
}
END_TEST

static const struct {
    const char *text, *says;
} refused[] = {
    {"", "expected an OFF file"},
    {"OFF\n", "the counts"},
    {"OFF\n3\n", "the counts"},
    {"OFF 0 1 0\n", "a count of 0 vertices"},
    {"OFF 3 0 0\n" THREE, "a count of 0 faces"},
    {"OFF 2147483648 1 0\n", "a count of 2147483648 vertices"},
    {"OFF 2.5 1 0\n", "a count of 2.5 vertices"},
    {"OFF 3 -1 0\n", "a count of -1 faces"},
    {"OFF 3 nan 0\n", "the counts"},
    {"OFF 2147483647 1 0\n" THREE, "ends after 3 vertices"},
    {"OFF 3 1 0\n0 0 0\n1 0\n", "expected x y z"},
    {"OFF 3 1 0\n0 0 0\n1 0 inf\n", "expected x y z"},
    {"NOFF 3 1 0\n0 0 0\n", "x y z nx ny nz"},
    {"OFF 3 2 0\n" THREE "3 0 1 2\n", "ends after 1 facets"},
    {"OFF 3 1 0\n" THREE "2 0 1\n", "3 or more"},
    {"OFF 3 1 0\n" THREE "3 0 1\n", "number of corners"},
    {"OFF 3 1 0\n" THREE "3 0 1 3\n", "vertex index 3, expected 0 to 2"},
    {"OFF 3 1 0\n" THREE "3 0 -1 2\n", "vertex index -1"},
    {"OFF 3 1 0\n" THREE "3 0 0.5 2\n", "vertex index 0.5"},
};

START_TEST(what_is_refused)
{
    ck_assert_msg(take(refused[_i].text) < 0, "taken: %s", refused[_i].text);
    ck_assert_msg(strstr(error.text, refused[_i].says) != NULL, "%s", error.text);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("off");
    TCase *tests = tcase_create("off");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, counts_beside_and_below_the_word);
    tcase_add_test(tests, a_polygon_is_a_fan);
    tcase_add_test(tests, normals_are_of_length_one);
    tcase_add_loop_test(tests, what_is_refused, 0, sizeof refused / sizeof *refused);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

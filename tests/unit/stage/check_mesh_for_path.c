/* mesh_for_path: which hollow is the tightest, by surfaces or by vertices; meshes that can't be
 * cut. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stage/mesh_for_path.h"
#include "said.h"
#include "scratch.h"

static struct error error;
static struct mesh mesh;

static int read_text(const char *text)
{
    bool closed;
    mesh_free(&mesh);
    return mesh_for_planes_read(scratch_text(text), vec(0, 0, 1), 1, &mesh, &closed, &error);
}

#define HEAD(comments, properties)                                                              \
    "ply\nformat ascii 1.0\n" comments "element vertex 3\nproperty float x\nproperty float y\n" \
    "property float z\n" properties "element face 1\nproperty list uchar int vertex_indices\n"  \
    "end_header\n"

START_TEST(surfaces_count_where_they_are_named)
{
    ck_assert_int_eq(
        read_text(HEAD("comment surface 4.634000 1 2 3 a.igs:1\ncomment surface none a.igs:3\n"
                       "comment surface 2.5 4 5 6 b c.igs:5\ncomment surface 9 0 0 0 a.igs:7\n",
                       "property float nx\nproperty float ny\nproperty float nz\n"
                       "property float kmax\n") "0 0 0 0 0 1 0.001\n1 0 0 0 0 1 0.1\n"
                                                "0 1 0 0 0 1 0.2\n3 0 1 2\n"),
        0);
    struct tightest_hollow h = mesh_tightest_hollow(&mesh, 5);
    ck_assert(h.known);
    ck_assert_double_eq(h.radius, 2.5);
    ck_assert_double_eq(h.at.y, 5);
    ck_assert_str_eq(h.surface, "b c.igs:5");
    ck_assert_uint_eq(h.tighter, 2);
    ck_assert_uint_eq(mesh_tightest_hollow(&mesh, 2.5).tighter, 0);
    ck_assert_uint_eq(mesh_tightest_hollow(&mesh, 2.50001).tighter, 1);
    ck_assert_uint_eq(mesh_tightest_hollow(&mesh, 100).tighter, 3);
}
END_TEST

START_TEST(else_vertices_do)
{
    ck_assert_int_eq(read_text(HEAD("", "property float nx\nproperty float ny\nproperty float "
                                        "nz\nproperty double kmax\n") "0 0 0 0 0 1 -3\n"
                                                                      "1 0 0 0 0 1 0.25\n"
                                                                      "0 1 0 0 0 1 0.125\n"
                                                                      "3 0 1 2\n"),
                     0);
    struct tightest_hollow h = mesh_tightest_hollow(&mesh, 8.1);
    ck_assert(h.known);
    ck_assert_double_eq(h.radius, 4);
    ck_assert_double_eq(h.at.x, 1);
    ck_assert_ptr_null(h.surface);
    ck_assert_uint_eq(h.tighter, 2);
}
END_TEST

START_TEST(a_bare_mesh_knows_nothing)
{
    ck_assert_int_eq(read_text(HEAD("", "") "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 0);
    ck_assert(!mesh_tightest_hollow(&mesh, 1).known);
    ck_assert(isinf(mesh_tightest_hollow(&mesh, 1).radius));
}
END_TEST

/* What it is cut as is said of a mesh of another program; this suite's are in mm. */
START_TEST(its_unit)
{
    static const struct {
        const char *head, *side, *said, *not_said;
    } cases[] = {
        {HEAD("", ""), "4", "4 x 1 x 0 mm, its unit taken as mm\n", "calls the unit"},
        {HEAD("comment units: inch\n", ""), "4", "a comment calls the unit `inch`", "right?"},
        {HEAD("comment units: mm\n", ""), "4", NULL, "taken as mm"},
        {HEAD("comment unit millimetre\n", ""), "4", NULL, "taken as mm"},
        {HEAD("comment unit mm\n", ""), "4000", "taken as mm: is that right?", "calls"},
        {HEAD("", ""), "0.1", "taken as mm\n", "right?"},
        {HEAD("comment cloudmill mesh 1\n", ""), "9000", NULL, "taken as mm"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[600];
        snprintf(text, sizeof text, "%s0 0 0\n%s 0 0\n0 1 0\n3 0 1 2\n", cases[i].head,
                 cases[i].side);
        said_begin();
        ck_assert_int_eq(read_text(text), 0);
        const char *said = said_end();
        ck_assert_msg(!cases[i].said || strstr(said, cases[i].said), "%zu: %s", i, said);
        ck_assert_msg(!strstr(said, cases[i].not_said), "%zu: %s", i, said);
    }
}
END_TEST

START_TEST(what_cannot_be_cut)
{
    ck_assert_int_eq(read_text(HEAD("", "") "0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "no facet that has an area"));
    ck_assert_int_eq(read_text(HEAD("comment surface 4 1 2 a\n", "") "0 0 0\n1 0 0\n2 1 0\n"
                                                                     "3 0 1 2\n"),
                     -1);
    ck_assert_ptr_nonnull(strstr(error.text, "comment surface with 3 numbers"));
    ck_assert_int_eq(read_text(HEAD("comment surface -4 1 2 3 a\n", "") "0 0 0\n1 0 0\n2 1 0\n"
                                                                        "3 0 1 2\n"),
                     -1);
    ck_assert_ptr_nonnull(strstr(error.text, "radius -4"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh_for_path");
    TCase *all = tcase_create("all");
    tcase_add_test(all, surfaces_count_where_they_are_named);
    tcase_add_test(all, else_vertices_do);
    tcase_add_test(all, a_bare_mesh_knows_nothing);
    tcase_add_test(all, its_unit);
    tcase_add_test(all, what_cannot_be_cut);
    suite_add_tcase(suite, all);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    mesh_free(&mesh);
    return failed > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}

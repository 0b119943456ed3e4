/* check_stl - which files are taken for binary STL; the words of text STL in and out of order. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "io/mesh/stl.h"
#include "scratch.h"

static struct mesh mesh;
static struct error error;

static void teardown(void)
{
    mesh_free(&mesh);
}

static int take(const char *text)
{
    struct reader r;
    mesh_free(&mesh);
    mesh = (struct mesh){0};
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    int status = stl_read_text(&r, &mesh, &error);
    reader_close(&r);
    return status;
}

/* 84 bytes and 50 for each facet that the head counts, no more and no less. */
START_TEST(the_size_tells_a_binary_file)
{
    char head[84];
    memset(head, 'x', sizeof head);
    memcpy(head + 80, "\x02\x01\0\0", 4); /* 258 */
    struct reader r = {.size = 84 + 50 * 258};
    ck_assert(stl_is_binary(&r, head, 84));
    ck_assert(!stl_is_binary(&r, head, 83));
    for (int more = -51; more <= 51; more++) {
        r.size = (size_t)(84 + 50 * 258 + more);
        ck_assert_msg(stl_is_binary(&r, head, 84) == (more == 0), "%d bytes more", more);
    }
    r.size = 0; /* a pipe */
    ck_assert(!stl_is_binary(&r, head, 84));
    memset(head + 80, 0, 4);
    r.size = 84;
    ck_assert(stl_is_binary(&r, head, 84));
}
END_TEST

#define CORNERS "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
#define FACET "facet normal 0 0 1\n" CORNERS "endfacet\n"

START_TEST(words_in_any_case_and_indented)
{
    ck_assert_msg(take("solid a\n" FACET "endsolid\n") == 0, "%s", error.text);
    ck_assert_uint_eq(mesh.face.n, 1);
    ck_assert_msg(take("SOLID\n\n  FACET Normal 0 0 1\n\tOUTER LOOP\n  Vertex 0 0 0\nVERTEX 1 0 0\n"
                       "vertex\t0 1 -0\nENDLOOP\nEndFacet\n" FACET "EndSolid a b\n") == 0,
                  "%s", error.text);
    ck_assert_uint_eq(mesh.face.n, 2);
    ck_assert_uint_eq(mesh.vertex.n, 3); /* one place, one vertex */
    ck_assert_msg(take("solid a\n" FACET "endsolid\nsolid b\n" FACET "endsolid b\n") == 0, "%s",
                  error.text);
    ck_assert_uint_eq(mesh.face.n, 2);
}
END_TEST

static const struct {
    const char *text, *says;
} refused[] = {
    {"solid a\nendsolid a\n", "without facets"},
    {"solid a\n" FACET, "after 1 facets without endsolid"},
    {"solid a\n" FACET "endsolid\nsolid b\n" FACET, "after 2 facets without endsolid"},
    {"solid a\nfacet normal 0 0 1\n" CORNERS "endsolid\n", "after 0 facets without endsolid"},
    {"solid a\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n",
     "'endfacet' at the wrong place"},
    {"solid a\nfacet normal 0 0 1\n" CORNERS "vertex 1 1 0\nendfacet\nendsolid\n",
     "'vertex 1 1 0' at the wrong place"},
    {"solid a\n" CORNERS "endsolid\n", "'vertex 0 0 0' at the wrong place"},
    {"solid a\nendfacet\nendsolid\n", "'endfacet' at the wrong place"},
    {"solid a\nfacet\nfacet\nendsolid\n", "'facet' at the wrong place"},
    {"solid a\nfacets\nendsolid\n", "'facets', expected a statement"},
    {"solid a\nfacet\nvertex 0 0\n", "without three finite numbers"},
    {"solid a\nfacet\nvertex 0 0 nan\n", "without three finite numbers"},
    {"solid a\nfacet\nvertex 0 0 1e999\n", "without three finite numbers"},
};

START_TEST(what_is_refused)
{
    ck_assert_msg(take(refused[_i].text) < 0, "taken: %s", refused[_i].text);
    ck_assert_msg(strstr(error.text, refused[_i].says) != NULL, "%s\n lacks: %s", error.text,
                  refused[_i].says);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stl");
    TCase *tests = tcase_create("stl");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, the_size_tells_a_binary_file);
    tcase_add_test(tests, words_in_any_case_and_indented);
    tcase_add_loop_test(tests, what_is_refused, 0, sizeof refused / sizeof *refused);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

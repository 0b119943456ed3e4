/* check_normals - the table of estimators, and each on a plane, whose normal is known. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/elementary.h"
#include "stage/normals.h"

START_TEST(the_words_and_what_they_name)
{
    static const char *const words[2] = {"mesh|facet|gouraud|central", "quadric|facet"};
    for (int of_scan = 0; of_scan < 2; of_scan++) {
        char name[100], *next = name;
        ck_assert_str_eq(normals_words(of_scan), words[of_scan]);
        strcpy(name, words[of_scan]);
        int k = 0;
        for (; next; k++) {
            char *word = next;
            next = strchr(word, '|');
            if (next)
                *next++ = '\0';
            ck_assert_str_eq(normals_find(of_scan, k)->name, word);
            ck_assert_ptr_eq(normals_find(of_scan, k), normals_of(word));
        }
        ck_assert_ptr_null(normals_find(of_scan, k));
    }
    ck_assert(normals_of("quadric")->of_surface && !normals_of("facet")->of_surface);
}
END_TEST

/* A lattice of 7 x 6 places on z = x / 2 - y / 4, two triangles a cell. */
static struct mesh plane(void)
{
    struct mesh mesh = {0};
    for (int i = 0; i < 42; i++) {
        double x = i % 7, y = i / 7;
        *array_push(&mesh.vertex) = vec(x, y, x / 2 - y / 4);
    }
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 6; x++) {
            int a = 7 * y + x;
            *array_push(&mesh.face) = (struct face){{a, a + 1, a + 8}};
            *array_push(&mesh.face) = (struct face){{a, a + 8, a + 7}};
        }
    return mesh;
}

static void expect_plane(const struct mesh *mesh, const char *name)
{
    struct vec3 truth = vec_unit(vec(-0.5, 0.25, 1));
    ck_assert_uint_eq(mesh->normal.n, mesh->vertex.n);
    for (size_t i = 0; i < mesh->normal.n; i++)
        ck_assert_msg(vec_distance(mesh->normal.item[i], truth) < 1e-9, "%s: vertex %zu", name, i);
}

START_TEST(on_a_plane)
{
    static const char *const names[] = {"facet", "gouraud", "quadric"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        struct error error = {.text = ""};
        struct mesh mesh = plane();
        struct vec3s scan = {0};
        for (int i = 0; i < 26 * 22; i++) {
            double x = i % 26 / 4.0 - 0.1, y = i / 26 / 4.0 - 0.1;
            *array_push(&scan) = vec(x, y, x / 2 - y / 4);
        }
        struct normals_options options = {
            .point = scan.item, .n = scan.n, .spacing = 0.28, .threads = 1, .silent = true};
        const struct normal_estimator *e = normals_of(names[k]);
        ck_assert_msg(e->estimate(&mesh, &options, &error) == 0, "%s", error.text);
        expect_plane(&mesh, names[k]);
        array_free(&scan);
        mesh_free(&mesh);
    }
}
END_TEST

/* Normals that the mesh has stay; without them there are none to take. */
START_TEST(as_given)
{
    struct error error = {.text = ""};
    struct mesh mesh = plane();
    struct normals_options options = {.threads = 1, .silent = true};
    struct vec3 other = vec(0.6, 0, 0.8);
    for (size_t i = 0; i < mesh.vertex.n; i++)
        *array_push(&mesh.normal) = other;
    ck_assert_int_eq(normals_of("mesh")->estimate(&mesh, &options, &error), 0);
    for (size_t i = 0; i < mesh.normal.n; i++)
        ck_assert_double_eq(vec_distance(mesh.normal.item[i], other), 0);
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("normals");
    TCase *tests = tcase_create("normals");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, the_words_and_what_they_name);
    tcase_add_test(tests, on_a_plane);
    tcase_add_test(tests, as_given);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

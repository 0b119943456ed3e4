/* ply_origin: what a mesh says of itself comes back as it was, each comment by hand, and what is no
 * such comment is told or left alone. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/mesh/ply_origin.h"
#include "scratch.h"

static struct error error;
static struct mesh mesh;

static void setup(void)
{
    mesh = (struct mesh){.origin = ply_origin_none()};
}

static void teardown(void)
{
    mesh_free(&mesh);
}

static int take(const char *comment)
{
    return ply_origin_read(&mesh.origin, comment, &error);
}

static void taken(const char *comment)
{
    ck_assert_msg(take(comment) == 0, "%s: %s", comment, error.text);
}

/* The comments that are written, one a line, without their first word. */
static void writes(const char *want)
{
    struct out *out = out_open(scratch_name());
    ply_origin_write(out, &mesh.origin);
    out_close(out);
    char *text = scratch_read(&(size_t){0});
    ck_assert_str_eq(text, want);
    free(text);
}

START_TEST(there_and_back)
{
    writes("comment cloudmill mesh 1\n");
    taken("cloudmill mesh 1");
    taken("spacing 4");
    taken("direction -12.1");
    taken("source a scan.xyz");
    taken("scan 26493 0123456789abcdef a scan.xyz");
    taken("surface 4.634 1.25 -3.5 5.625 part.igs:7");
    taken("surface none part.igs:9");
    taken("part 12 1 0 0 0 0 1");
    taken("part 40 0 0.6 0.8 0 -0.8 0.6");
    taken("place 1 0 0 -5 0 0 -1 0.1 0 1 0 3 0 0 0 1");
    taken("extended 2");
    taken("noise 0.0197");
    taken("ledger cloud2mesh 0.012");
    taken("unmet cloud2mesh off by 0.06 mm at 1 2");
    writes("comment cloudmill mesh 1\n"
           "comment spacing 4\n"
           "comment direction -12.1\n"
           "comment source a scan.xyz\n"
           "comment scan 26493 0123456789abcdef a scan.xyz\n"
           "comment surface 4.634000 1.250000 -3.500000 5.625000 part.igs:7\n"
           "comment surface none part.igs:9\n"
           "comment part 12 1.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
           "1.000000000\n"
           "comment part 40 0.000000000 0.600000000 0.800000000 0.000000000 -0.800000000 "
           "0.600000000\n"
           "comment place 1 0 0 -5 0 0 -1 0.1 0 1 0 3 0 0 0 1\n"
           "comment extended 2.0000\n"
           "comment noise 0.0197\n"
           "comment ledger cloud2mesh 0.0120\n"
           "comment unmet cloud2mesh off by 0.06 mm at 1 2\n");
}
END_TEST

START_TEST(values)
{
    taken("place 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16");
    for (int i = 0; i < 16; i++)
        ck_assert_double_eq(mesh.origin.place.m[i / 4][i % 4], i + 1);
    ck_assert(mesh.origin.placed);
    taken("surface 4.5 1 2 3 part.igs:7");
    ck_assert_double_eq(mesh.origin.surface.item[0].radius, 4.5);
    ck_assert_double_eq(vec_distance(mesh.origin.surface.item[0].at, vec(1, 2, 3)), 0);
    ck_assert_str_eq(mesh.origin.surface.item[0].name, "part.igs:7");
    taken("part 3 2 0 0 0 0 4"); /* directions are made unit vectors */
    ck_assert_int_eq(mesh.origin.part.item[0].row, 3);
    ck_assert_double_eq(vec_distance(mesh.origin.part.item[0].along, vec(1, 0, 0)), 0);
    ck_assert_double_eq(vec_distance(mesh.origin.part.item[0].up, vec(0, 0, 1)), 0);
    taken("ledger a 1");
    taken("ledger cloud2mesh 0.5");
    ck_assert_str_eq(mesh.origin.maker, "cloud2mesh");
    ck_assert_double_eq(mesh.origin.ledger, 0.5);
}
END_TEST

/* What a mesh of another program calls its unit, if it does. */
START_TEST(units)
{
    static const char *const k[][2] = {{"unit inch", "inch"},
                                       {"Units: Inches", "Inches"},
                                       {"UNIT=mm", "mm"},
                                       {"units\t: in", "in"},
                                       {"unit", NULL},
                                       {"units:", NULL},
                                       {"united by nobody", NULL},
                                       {"made in units mm", NULL}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        taken("noise 1");
        mesh_free(&mesh);
        taken(k[i][0]);
        ck_assert(!mesh.origin.own);
        if (k[i][1])
            ck_assert_str_eq(mesh.origin.unit, k[i][1]);
        else
            ck_assert_ptr_null(mesh.origin.unit);
    }
    mesh_free(&mesh);
    taken("cloudmill mesh 1");
    taken("units inch");
    ck_assert(mesh.origin.own);
    ck_assert_ptr_null(mesh.origin.unit);
    mesh_free(&mesh);
}
END_TEST

/* What may be off is rounded up, and what is a round number already stays. */
START_TEST(ledger_rounds_up)
{
    static const double k[][2] = {{0.012, 0.012}, {0.01201, 0.0121}, {0.0120001, 0.0121}, {0, 0}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        char want[100];
        taken("ledger a 1");
        mesh.origin.ledger = k[i][0];
        snprintf(want, sizeof want, "comment cloudmill mesh 1\ncomment ledger a %.4f\n", k[i][1]);
        writes(want);
    }
    mesh.origin.ledger = NAN; /* who spent it is nothing without how much, and the other way */
    writes("comment cloudmill mesh 1\n");
    free(mesh.origin.maker);
    mesh.origin.maker = NULL;
    mesh.origin.ledger = 0.5;
    writes("comment cloudmill mesh 1\n");
}
END_TEST

/* A line end in a name would end the line. */
START_TEST(names)
{
    taken("source a\nb\tc\x80");
    writes("comment cloudmill mesh 1\ncomment source a?b?c\x80\n");
}
END_TEST

/* Words may be parted by tabs. */
START_TEST(tabs)
{
    taken("cloudmill\tmesh\t1");
    taken("spacing\t4");
    taken("scan\t26493\t0123456789abcdef\ta scan.xyz");
    taken("surface\t4.634\t1.25\t-3.5\t5.625\tpart.igs:7");
    taken("unmet\tcloud2mesh\toff by 0.06 mm");
    ck_assert(mesh.origin.spacing == 4);
    ck_assert_uint_eq(mesh.origin.scan.n, 1);
    ck_assert_uint_eq(mesh.origin.scan.item[0].points, 26493);
    ck_assert_str_eq(mesh.origin.scan.item[0].name, "a scan.xyz");
    ck_assert_str_eq(mesh.origin.surface.item[0].name, "part.igs:7");
    ck_assert_str_eq(mesh.origin.unmet.item[0].stage, "cloud2mesh");
    ck_assert_str_eq(mesh.origin.unmet.item[0].text, "off by 0.06 mm");
}
END_TEST

START_TEST(of_others)
{
    static const char *const k[] = {"made by somebody", "spacings 4", "spacing", "sourcery x", ""};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++)
        taken(k[i]);
    writes("comment cloudmill mesh 1\n");
}
END_TEST

START_TEST(refused)
{
    static const char *const k[][2] = {
        {"cloudmill mesh 2", "mesh stream of version '2', expected 1"},
        {"spacing four", "comment spacing with 'four', expected one number"},
        {"spacing 4 5", "'4 5'"},
        {"noise nan", "comment noise"},
        {"extended x", "comment extended"},
        {"direction x", "comment direction"},
        {"place 1 2 3", "comment place with 3 numbers, expected 16"},
        {"place 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17", "followed by ' 17'"},
        {"place 1 2 3x 4 5 6 7 8 9 10 11 12 13 14 15 16", "with 2 numbers"},
        {"ledger cloud2mesh", "comment ledger"},
        {"part 1 1 0 0 0 0", "with 6 numbers, expected 7"},
        {"part 1 1 0 0 0 0 1 9", "two perpendicular directions"},
        {"part 1 1 0 0 0.1 0 1", "two perpendicular directions"},
        {"part 1 0 0 0 0 0 1", "two perpendicular directions"},
        {"part 1 0 0 1 0 0 0", "two perpendicular directions"},
        {"scan many", "expected points, hash and name"},
        {"unmet cloud2mesh", "expected a stage and a text"},
        {"unmet  x", "expected a stage and a text"},
        {"surface 4 1 2", "with 2 numbers, expected 4 or none"},
        {"surface 4 1 2 3", "with 3 numbers"},
        {"surface -1 1 2 3 a", "radius -1, expected a positive one"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        ck_assert_msg(take(k[i][0]) == -1, "%s", k[i][0]);
        ck_assert_msg(strstr(error.text, k[i][1]) != NULL, "%s", error.text);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ply_origin");
    TCase *tests = tcase_create("ply_origin");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, there_and_back);
    tcase_add_test(tests, values);
    tcase_add_test(tests, units);
    tcase_add_test(tests, ledger_rounds_up);
    tcase_add_test(tests, names);
    tcase_add_test(tests, tabs);
    tcase_add_test(tests, of_others);
    tcase_add_test(tests, refused);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/*
 * check_nurbs_report - which surface is the roughest; the table of a bilinear surface against its
 * formula.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "scratch.h"
#include "stage/nurbs_report.h"

enum { N = 3 };

static struct patch patch[N];
static struct patches patches;
static struct sheet sheet[N];

static void setup(void)
{
    static char name[] = "part.igs";
    patches = (struct patches){.n = N, .item = patch};
    for (int i = 0; i < N; i++) {
        patch[i] = (struct patch){.file = name, .entity = 10 + i};
        sheet[i] = (struct sheet){0};
        *array_push(&sheet[i].face) = (struct face){{0, 1, 2}};
    }
}

static void teardown(void)
{
    for (int i = 0; i < N; i++)
        sheet_free(&sheet[i]);
}

START_TEST(the_roughest)
{
    double rough = 9;
    ck_assert_ptr_null(nurbs_report_roughest(&patches, &rough));
    ck_assert_double_eq(rough, 0);
    patch[1].rough = 0.02;
    ck_assert_ptr_eq(nurbs_report_roughest(&patches, &rough), &patch[1]);
    ck_assert_double_eq(rough, 0.02);
    struct patch_loop loop[2] = {{.rough = 0.01}, {.rough = 0.03}};
    patch[2].loop = (struct patch_loops){.n = 2, .item = loop};
    ck_assert_ptr_eq(nurbs_report_roughest(&patches, &rough), &patch[2]);
    ck_assert_double_eq(rough, 0.03);
    patch[0].rough = 0.03; /* of two alike the first */
    ck_assert_ptr_eq(nurbs_report_roughest(&patches, &rough), &patch[0]);
}
END_TEST

/* S(u, v) = (10 u, 5 v, u v) over 0..1: its normal is (10, 0, v) x (0, 5, u). */
START_TEST(a_table_of_a_surface)
{
    static double knot[] = {0, 0, 1, 1};
    static struct nurbs_pole pole[] = {{0, 0, 0, 1}, {10, 0, 0, 1}, {0, 5, 0, 1}, {10, 5, 1, 1}};
    const struct nurbs_axis axis = {1, 2, knot, 0, 1};
    patches.n = 1;
    patch[0].surface = (struct nurbs){axis, axis, pole};
    char name[200];
    snprintf(name, sizeof name, "%s", scratch_text(""));
    nurbs_report_grid(name, &patches, 3);
    size_t n, lines = 0;
    char *text = scratch_read(&n), *line = strtok(text, "\n");
    ck_assert_str_eq(line, "entity,u,v,x,y,z,nx,ny,nz");
    while ((line = strtok(NULL, "\n"))) {
        double u = (double)(lines / 3) / 2, v = (double)(lines % 3) / 2, got[9];
        struct vec3 normal = vec_unit(vec(-5 * v, -10 * u, 50));
        const double want[9] = {10, u, v, 10 * u, 5 * v, u * v, normal.x, normal.y, normal.z};
        ck_assert_int_eq(sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &got[0], &got[1],
                                &got[2], &got[3], &got[4], &got[5], &got[6], &got[7], &got[8]),
                         9);
        for (int k = 0; k < 9; k++)
            ck_assert_double_eq_tol(got[k], want[k], 1e-14 * 20);
        lines++;
    }
    ck_assert_uint_eq(lines, 9);
    free(text);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("nurbs_report");
    TCase *tests = tcase_create("nurbs_report");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, the_roughest);
    tcase_add_test(tests, a_table_of_a_surface);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

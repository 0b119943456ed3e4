/*
 * spline_report: sums and largest values over pieces, and percentages of the paper's Table 1.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "stage/spline_report.h"

START_TEST(sums_and_largest)
{
    struct spline_run_piece a = {.from = 0, .to = 100, .smooth = 0.001};
    struct spline_run_piece b = {.from = 100, .to = 150};
    struct spline_report r = {0};
    char text[4000];
    FILE *table = fmemopen(text, sizeof text, "w");

    a.fit.curve = bspline_new(3, 15, false);
    for (size_t i = 0; i < 19; i++)
        a.fit.curve.knot[i] = i < 4 ? 0 : i < 15 ? (double)i - 3 : 12;
    for (size_t i = 0; i < 15;
         i++) /* the places of the knots: 0.5 mm apart, but for the first two */
        a.fit.curve.pole[i] =
            vec(i < 3 ? 0.5 * (double)(i * (i + 1) / 2) / 3 : 0.5 * (double)(i - 1), 0, 0);
    a.fit.deviation = (struct fit_error){.c1 = 0.5, .c2 = 0.1, .rms = 0.2, .middle = 0.6};
    a.fit.proof = (struct deviation){0.008, 0.007, 0.01};
    b.fit = a.fit;
    b.fit.curve = bspline_new(1, 6, false);
    for (size_t i = 0; i < 8; i++)
        b.fit.curve.knot[i] = i < 2 ? 0 : i < 6 ? (double)i - 1 : 5;
    for (size_t i = 0; i < 6; i++)
        b.fit.curve.pole[i] = vec(i < 2 ? 0.05 * (double)i : (double)i, 0, 0);
    b.fit.deviation.c1 = 0.7;
    b.fit.proof.other = 0.0085;
    spline_report_head(table);
    spline_report_add(&r, 3, 0.1, &a, table);
    spline_report_add(&r, 3, 0.1, &b, NULL);
    spline_report_totals(&r, table);
    fclose(table);
    ck_assert_uint_eq(r.points, 151); /* the corner between the pieces counts once */
    ck_assert_uint_eq(r.poles, 21);
    ck_assert_uint_eq(r.splines, 2);
    ck_assert_double_eq_tol(r.shortest, 0.05, 1e-12);
    ck_assert_uint_eq(r.shorter, 1);
    ck_assert_uint_eq(r.spans, 12 + 5);
    ck_assert(r.deviation.c1 == 0.7 && r.deviation.middle == 0.6);
    ck_assert(r.worst.point == 0.008 && r.worst.other == 0.0085 && r.worst.axis == 0.01);
    ck_assert_double_eq_tol(r.spent, 0.009, 1e-15);
    ck_assert(strstr(text, "uniform/uniform") != NULL);
    ck_assert(strstr(text, "  all     151      21   86.09  0.700000") != NULL);
    bspline_free(&a.fit.curve);
    bspline_free(&b.fit.curve);
}
END_TEST

START_TEST(percentages_of_table_1)
{
    ck_assert_double_eq_tol(spline_report_fewer(9023, 225), 97.5, 0.01);
    ck_assert_double_eq_tol(spline_report_fewer(9023, 230), 97.45, 0.01);
    ck_assert(spline_report_fewer(0, 0) == 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("spline_report");
    TCase *tests = tcase_create("spline_report");

    tcase_add_test(tests, sums_and_largest);
    tcase_add_test(tests, percentages_of_table_1);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/*
 * check_verify - motions over a plane whose faults are known: each is found with its figure, and
 * none where there is none; the stock of an option.
 */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "over_plane.h"
#include "scratch.h"

static bool found(const struct verdict *v, const char *text)
{
    for (size_t i = 0; i < v->finding.n; i++)
        if (v->finding.item[i].fault && strstr(v->finding.item[i].text, text))
            return true;
    return false;
}

static const struct {
    double height, over;
    const char *fault; /* NULL: none */
    double gouge, most;
} cases[] = {{0.002, 5, NULL, 0, 0.004},
             {-0.2, 5, "mm deep in the part", 0.2, 0},
             {0.06, 5, "of material is left", 0, 0.062},
             {0.002, -0.5, "rapid move goes 0.5", 0, 0.004}};

START_TEST(faults_of_the_surface)
{
    struct vec3s part = plane();
    struct nc_motion motion = rows(cases[_i].height, cases[_i].over);
    /* a rapid move straight through the part where rows are left for the next */
    struct vec3 at = {16, 11, cases[_i].over};
    move_to(&motion, &at, vec(-16, -11, cases[_i].over), true);
    struct verdict v = judge(&motion, &part, NULL);
    ck_assert_int_eq(verdict_refused(&v), cases[_i].fault != NULL);
    if (cases[_i].fault)
        ck_assert_msg(found(&v, cases[_i].fault), "%s", v.finding.item[0].text);
    ck_assert_double_eq_tol(v.map.gouge, cases[_i].gouge, 0.003);
    ck_assert_double_le(v.map.over, fmax(cases[_i].most, 0) + 0.003);
    ck_assert_uint_eq(v.map.cut, part.n);
    verdict_free(&v);
    nc_motion_free(&motion);
    array_free(&part);
}
END_TEST

/* A hollow that fits the ball but for 0.03 is out of reach where rows may leave 0.05, however much
 * later stages may, and within reach where rows may leave 0.08. */
START_TEST(hollow_is_judged_by_what_rows_leave)
{
    struct vec3s part = plane();
    const double sagitta = RADIUS - sqrt(RADIUS * RADIUS - 0.25);
    size_t middle = part.n / 2;
    part.item[middle].z = -sagitta - 0.03;
    struct nc_motion motion = rows(0.2, 5);
    for (int i = 0; i < 3; i++) {
        const double left[] = {0.05, 0.08, 0.08}, near[] = {0.05, 0.05, 0.08};
        struct verdict v = judge_left(&motion, &part, NULL, left[i], near[i]);
        ck_assert_uint_eq(v.coverage.sum[COVERAGE_OUT_OF_REACH].points, i < 2);
        ck_assert_uint_eq(v.coverage.sum[COVERAGE_LEFT].points, part.n - (i < 2));
        verdict_free(&v);
    }
    nc_motion_free(&motion);
    array_free(&part);
}
END_TEST

/* 1 mm off all of a block: what is cut is what is gone. */
START_TEST(stock_is_cut_down_to_the_plane)
{
    struct vec3s part = plane();
    struct stock_options stock = {
        .kind = STOCK_BETWEEN, .low = {-10, -10, -3}, .high = {10, 10, 1}};
    struct nc_motion motion = rows(0, 5);
    struct verdict v = judge(&motion, &part, &stock);
    ck_assert(v.has_stock);
    ck_assert_double_eq_tol(v.stock.before, 1600, 1e-6);
    ck_assert_double_eq_tol(v.stock.after, 1200, 3);
    ck_assert_uint_eq(v.passes, 89);
    ck_assert(!verdict_refused(&v));
    verdict_free(&v);
    nc_motion_free(&motion);
    array_free(&part);
}
END_TEST

/* Of more points than a browser shows the page has the worst of every two: the only one that is cut
 * too deep, which is 0.3 mm up, is among them. */
START_TEST(page_shows_the_worst_points)
{
    struct vec3s part = {0};
    for (int i = 0; i < 250; i++)
        for (int k = 0; k < 250; k++)
            *array_push(&part) = vec(0.08 * i - 10, 0.08 * k - 10, 0);
    part.item[31001].z = 0.3;
    struct nc_motion motion = rows(0.002, 5);
    struct verdict v = judge(&motion, &part, NULL);
    verdict_page(&v, scratch_name());
    size_t n, count = 0;
    char *page = scratch_read(&n), *at = strstr(page, "points:["),
         *end = at ? strstr(at, "],") : NULL;
    int deepest = 0, deviation;
    ck_assert_ptr_nonnull(end);
    for (; at && at < end; at = strchr(at + 1, '\n'), count++)
        if (sscanf(at + (count ? 1 : 8), "%*d,%*d,%*d,%d,", &deviation) == 1 && deviation < deepest)
            deepest = deviation;
    ck_assert_uint_ge(count, 31250);
    ck_assert_uint_le(count, 31252);
    ck_assert_int_lt(deepest, -2500); /* of 0.0001 mm */
    free(page);
    verdict_free(&v);
    nc_motion_free(&motion);
    array_free(&part);
}
END_TEST

static const struct {
    const char *text;
    bool good;
    enum stock_kind kind;
    double allowance;
} stocks[] = {{"box", true, STOCK_AROUND, 0},
              {"box,1.5", true, STOCK_AROUND, 1.5},
              {"offset,2", true, STOCK_OFFSET, 2},
              {"box:0,0,0,1,2,3", true, STOCK_BETWEEN, 0},
              {"box:1,0,0,0,2,3", false, 0, 0},
              {"offset", false, 0, 0},
              {"offset,-1", false, 0, 0},
              {"box,1,2", false, 0, 0},
              {"boxes", false, 0, 0},
              {"", false, 0, 0}};

START_TEST(stock_of_an_option)
{
    struct stock_options stock;
    struct error error;
    int result = verify_stock_read(stocks[_i].text, &stock, &error);
    ck_assert_int_eq(result, stocks[_i].good ? 0 : -1);
    if (stocks[_i].good) {
        ck_assert_int_eq(stock.kind, stocks[_i].kind);
        ck_assert_double_eq_tol(stock.allowance, stocks[_i].allowance, 1e-12);
    }
}
END_TEST

/* Faces of a mesh: a needle, one with its apex beyond an end, and a fat one. */
static const struct {
    struct vec3 v[3];
} faces[] = {{{{0, 0, 0}, {100, 0, 0}, {50, 0.05, 0}}},
             {{{0, 0, 0}, {100, 0, 0}, {100, 0.05, 0}}},
             {{{0, 0, 0}, {3, 0, 0}, {100, 1, 0}}},
             {{{0, 0, 0}, {5, 0, 0}, {1, 6, 2}}}};

/* No place of a face is farther than half the spacing from a point, and there are not many more
 * points than its length and its area ask for. */
START_TEST(points_on_a_face)
{
    const struct vec3 *v = faces[_i].v;
    struct vec3s points = {0};
    struct error error;
    char name[400];
    double spacing, worst = 0;
    size_t corners;
    snprintf(name, sizeof name, "%s.off", scratch_name());
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    fprintf(file, "OFF\n3 1 0\n");
    for (int k = 0; k < 3; k++)
        fprintf(file, "%g %g %g\n", v[k].x, v[k].y, v[k].z);
    fprintf(file, "3 0 1 2\n");
    fclose(file);
    struct transform place = transform_scale(1);
    ck_assert_int_eq(verify_part_read(name, &place, RADIUS, &points, &spacing, &corners, &error),
                     0);
    remove(name);
    for (int i = 0; i <= 60; i++)
        for (int k = 0; k <= 60 - i; k++) {
            struct vec3 p = vec_along(v[0], i / 60.0, vec_sub(v[1], v[0]));
            double least = HUGE_VAL;
            p = vec_along(p, k / 60.0, vec_sub(v[2], v[0]));
            for (size_t m = 0; m < points.n; m++)
                least = fmin(least, vec_distance(p, points.item[m]));
            worst = fmax(worst, least);
        }
    ck_assert_double_le(worst, 0.5 * spacing);
    double area = vec_length(vec_cross(vec_sub(v[1], v[0]), vec_sub(v[2], v[0]))) / 2;
    ck_assert_double_le((double)points.n, 10 + 3 * area / (spacing * spacing) + 5 * 100 / spacing);
    array_free(&points);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("verify");
    TCase *tcase = tcase_create("verify");
    tcase_add_loop_test(tcase, faults_of_the_surface, 0, (int)(sizeof cases / sizeof *cases));
    tcase_add_test(tcase, hollow_is_judged_by_what_rows_leave);
    tcase_add_test(tcase, stock_is_cut_down_to_the_plane);
    tcase_add_test(tcase, page_shows_the_worst_points);
    tcase_add_loop_test(tcase, stock_of_an_option, 0, (int)(sizeof stocks / sizeof *stocks));
    tcase_add_loop_test(tcase, points_on_a_face, 0, (int)(sizeof faces / sizeof *faces));
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

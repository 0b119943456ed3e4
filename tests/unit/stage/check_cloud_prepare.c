/* cloud_prepare: what a file has is counted and told, placing goes unit, matrix, origin, and of a
 * floor with known noise, doubles, strays and a lid just the known points are taken out. */
#include "stage/cloud_prepare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "noisy.h"
#include "said.h"
#include "scratch.h"

static struct vec3s points;
static struct error error;

static void teardown(void)
{
    array_free(&points);
}

/* Each kind that was skipped has its line, one and several in the right number. */
START_TEST(skipped)
{
    const struct cloud_count none = {.points = 9, .columns = 3};
    said_begin();
    say_skipped("a.xyz", &none);
    ck_assert_str_eq(said_end(), "");
    struct cloud_count one = {.heads = 1, .comments = 1, .withheld = 1, .not_measured = 1};
    one.not_finite = one.first_not_finite = 1;
    said_begin();
    say_skipped("a.xyz", &one);
    const char *text = said_end();
    ck_assert_ptr_nonnull(strstr(text, "1 heading line\n"));
    ck_assert_ptr_nonnull(strstr(text, "1 comment\n"));
    ck_assert_ptr_nonnull(strstr(text, "1 point that the file marks"));
    ck_assert_ptr_nonnull(strstr(text, "a.xyz:1: left out 1 row with nan"));
    ck_assert_ptr_nonnull(strstr(text, "1 cell without"));
    struct cloud_count more = {.heads = 2, .comments = 3, .withheld = 4, .not_measured = 5};
    more.not_finite = 6;
    more.no_data = 7;
    more.mark = -9999;
    more.columns = 4;
    more.facets = 7;
    said_begin();
    say_skipped("a.xyz", &more);
    text = said_end();
    ck_assert_ptr_nonnull(strstr(text, "2 heading lines"));
    ck_assert_ptr_nonnull(strstr(text, "3 comments"));
    ck_assert_ptr_nonnull(strstr(text, "4 points that the file marks"));
    ck_assert_ptr_nonnull(strstr(text, "5 cells without"));
    ck_assert_ptr_nonnull(strstr(text, "left out 7 rows with a height of -9999"));
    ck_assert_ptr_nonnull(strstr(text, "a.xyz: left out 6 points with nan"));
    ck_assert_ptr_nonnull(strstr(text, "after the third (up to 4)"));
    ck_assert_ptr_nonnull(strstr(text, "its 7 facets"));
    const struct cloud_count indexed = {.indexed = true, .columns = 4};
    said_begin();
    say_skipped("a.xyz", &indexed);
    text = said_end();
    ck_assert_ptr_nonnull(strstr(text, "numbers the rows"));
    ck_assert_ptr_null(strstr(text, "fourth"));
}
END_TEST

/* Two files are one cloud, each named with its own points; rows that are no points add up. */
START_TEST(reading)
{
    char name[200], *file[2];
    snprintf(name, sizeof name, "%s", scratch_text("1 2 3\n4 5 6\nnan 1 2\n7 8 9\n"));
    file[0] = file[1] = name;
    struct scan_sources scan = {0};
    size_t left_out;
    said_begin();
    int status = cloud_prepare_read(file, 2, 2, &points, &scan, &left_out, &error);
    said_end();
    ck_assert_int_eq(status, 0);
    ck_assert_uint_eq(points.n, 6);
    ck_assert_double_eq(points.item[5].z, 9);
    ck_assert_uint_eq(left_out, 2);
    ck_assert_uint_eq(scan.n, 2);
    for (size_t f = 0; f < 2; f++) {
        ck_assert_uint_eq(scan.item[f].points, 3);
        ck_assert_uint_eq(scan.item[f].hash, scan_source_hash(points.item + 3 * f, 3));
    }
    scan_sources_free(&scan);
    char missing[] = "/nowhere/at/all";
    file[1] = missing;
    said_begin();
    status = cloud_prepare_read(file, 2, 2, &points, &scan, &left_out, &error);
    said_end();
    ck_assert_int_eq(status, -1);
    ck_assert_ptr_nonnull(strstr(error.text, missing));
    scan_sources_free(&scan);
}
END_TEST

/* Inches, then a quarter turn about z with a shift in mm, then the corner to the origin. */
START_TEST(placing)
{
    struct mesh_origin origin = {0};
    const char *matrix = scratch_text("0 -1 0 10\n1 0 0 20\n0 0 1 30\n0 0 0 1\n");
    *array_push(&points) = vec(1, 2, 3);
    *array_push(&points) = vec(4, -6, 5);
    ck_assert_int_eq(cloud_prepare_place(&points, "mm", NULL, false, &origin, &error), 0);
    ck_assert(!origin.placed);
    ck_assert_double_eq(points.item[0].x, 1);
    struct vec3s turned = {0};
    for (size_t i = 0; i < 2; i++)
        *array_push(&turned) = points.item[i];
    ck_assert_int_eq(cloud_prepare_place(&turned, "inch", matrix, false, &origin, &error), 0);
    ck_assert(origin.placed);
    const struct vec3 want[2] = {{10 - 2 * 25.4, 20 + 25.4, 30 + 3 * 25.4},
                                 {10 + 6 * 25.4, 20 + 4 * 25.4, 30 + 5 * 25.4}};
    for (size_t i = 0; i < 2; i++) {
        ck_assert_double_lt(vec_distance(turned.item[i], want[i]), 1e-12);
        ck_assert_double_lt(vec_distance(transform_point(&origin.place, points.item[i]), want[i]),
                            1e-12);
    }
    array_free(&turned);
    struct vec3s moved = {0};
    for (size_t i = 0; i < 2; i++)
        *array_push(&moved) = points.item[i];
    ck_assert_int_eq(cloud_prepare_place(&moved, "inch", matrix, true, &origin, &error), 0);
    for (size_t i = 0; i < 2; i++) { /* z stays where it is */
        struct vec3 at = vec(want[i].x - want[0].x, want[i].y - want[0].y, want[i].z);
        ck_assert_double_lt(vec_distance(moved.item[i], at), 1e-12);
        ck_assert_double_lt(vec_distance(transform_point(&origin.place, points.item[i]), at),
                            1e-12);
    }
    array_free(&moved);
    said_begin(); /* a mirror is told, and taken */
    int status =
        cloud_prepare_place(&points, "mm", scratch_text("-1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"),
                            false, &origin, &error);
    ck_assert_ptr_nonnull(strstr(said_end(), "mirror"));
    ck_assert_int_eq(status, 0);
    ck_assert_double_eq(points.item[1].x, -4);
    ck_assert_int_eq(
        cloud_prepare_place(&points, "mm", scratch_text("1 2\n"), false, &origin, &error), -1);
}
END_TEST

enum { SIDE = 41, STRAYS = 3, DOUBLES = 5 };

/* A floor of SIDE x SIDE points 1 mm apart, normal noise, some of them twice and strays over it. */
static void make_floor(double sigma)
{
    noisy_seed(3);
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++)
            *array_push(&points) = vec(i, k, sigma * noisy_normal());
    for (int i = 0; i < DOUBLES; i++) {
        struct vec3 again = points.item[100 * i + 50];
        *array_push(&points) = again;
    }
    for (int i = 0; i < STRAYS; i++)
        *array_push(&points) = vec(7 + 10.3 * i, 20.2, 6);
}

static size_t above(double z)
{
    size_t n = 0;
    for (size_t i = 0; i < points.n; i++)
        n += points.item[i].z > z;
    return n;
}

START_TEST(cleaning)
{
    static const enum cloud_prepare_drop drops[] = {CLOUD_PREPARE_KEEP,
                                                    CLOUD_PREPARE_DROP_OUTLIERS};
    const double sigma = 0.02;
    for (size_t k = 0; k < 2; k++) {
        struct cloud_prepare found;
        points.n = 0;
        make_floor(sigma);
        said_begin();
        int status = cloud_prepare_clean(&points, 1, -1, drops[k], 1, &found, &error);
        const char *text = said_end();
        ck_assert_int_eq(status, 0);
        ck_assert_uint_eq(found.twice, DOUBLES);
        ck_assert_uint_eq(found.outliers, STRAYS);
        ck_assert_uint_eq(found.covered.n, 0);
        ck_assert_uint_eq(points.n, SIDE * SIDE + (drops[k] ? 0 : STRAYS));
        ck_assert_uint_eq(above(1), drops[k] ? 0 : STRAYS);
        /* an estimate of sigma from n points that is half as good as the best is off by no more
         * than 4 sigma sqrt(2 / n) */
        ck_assert_double_eq_tol(found.noise, sigma, 4 * sigma * sqrt(2.0 / (SIDE * SIDE)));
        ck_assert_ptr_nonnull(strstr(text, "left out 5 points that were there already"));
        ck_assert_ptr_nonnull(
            strstr(text, drops[k] ? "left out 3 outliers" : "found, and kept, 3 outliers"));
    }
}
END_TEST

/* Of a lid over part of the floor the points below it are out of reach from above. */
START_TEST(under_a_roof)
{
    struct cloud_prepare found;
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++)
            *array_push(&points) = vec(i, k, 0);
    for (int i = 10; i <= 30; i++)
        for (int k = 10; k <= 30; k++)
            *array_push(&points) = vec(i + 0.25, k + 0.25, 12);
    said_begin();
    int status = cloud_prepare_clean(&points, 1, 0, CLOUD_PREPARE_DROP, 1, &found, &error);
    said_end();
    ck_assert_int_eq(status, 0);
    ck_assert_uint_eq(found.outliers, 0);
    /* those with the lid all around: a point or two from its rim */
    ck_assert_uint_ge(found.under, 17 * 17);
    ck_assert_uint_le(found.under, 20 * 20);
    ck_assert_uint_eq(found.covered.n, found.under);
    for (size_t i = 0; i < found.covered.n; i++)
        ck_assert_double_eq(found.covered.item[i].z, 0);
    array_free(&found.covered);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        ck_assert(p.z > 1 || fabs(p.x - 20.25) > 8 || fabs(p.y - 20.25) > 8);
    }
    ck_assert_uint_eq(points.n, SIDE * SIDE + 21 * 21 - found.under);
    ck_assert_uint_eq(above(11), 21 * 21);
}
END_TEST

/* Both files together hold the points as they were read, and not as they are placed. */
START_TEST(files)
{
    char name[300], other[320];
    struct vec3s raw = {0}, kept = {0}, again = {0};
    make_floor(0.02);
    for (size_t i = 0; i < points.n; i++)
        *array_push(&raw) = vec_along(vec(1e6, 0, 0), 1, points.item[i]);
    snprintf(name, sizeof name, "%s", scratch_text(""));
    snprintf(other, sizeof other, "%s.outliers", name);
    said_begin();
    int status = cloud_prepare_write_clean(name, "a\nb.xyz", &raw, &points, -1, 1, &kept, &error);
    said_end();
    ck_assert_int_eq(status, 0);
    char head[80];
    FILE *f = fopen(other, "r");
    ck_assert_ptr_nonnull(f);
    ck_assert_ptr_nonnull(fgets(head, sizeof head, f));
    fclose(f);
    ck_assert_str_eq(head, "# 3 outliers of a?b.xyz\n");
    struct cloud_count count;
    ck_assert_int_eq(cloud_read(name, 1, &again, &count, &error), 0);
    ck_assert_uint_eq(again.n, raw.n - STRAYS);
    ck_assert_uint_eq(kept.n, again.n);
    ck_assert_int_eq(memcmp(again.item, kept.item, kept.n * sizeof *kept.item), 0);
    ck_assert_int_eq(cloud_read(other, 1, &again, &count, &error), 0);
    ck_assert_uint_eq(again.n, raw.n);
    ck_assert_uint_eq(scan_source_hash(again.item, again.n), scan_source_hash(raw.item, raw.n));
    for (size_t i = 0; i < again.n; i++)
        ck_assert_int_eq(again.item[i].z > 1, i >= kept.n);
    remove(other);
    array_free(&raw);
    array_free(&kept);
    array_free(&again);
}
END_TEST

/* Two floors of one size, 0.3 apart, are told of with their distance. */
START_TEST(sheets)
{
    struct sheets s = {.places = 0};
    said_begin();
    say_sheets(&s);
    ck_assert_str_eq(said_end(), "");
    s = (struct sheets){.places = 1, .looked = 4, .distance = 0.25, .widest = 0.5, .at = {1, 2, 3}};
    said_begin();
    say_sheets(&s);
    const char *text = said_end();
    ck_assert_ptr_nonnull(strstr(text, "0.250 mm apart (at 1 of 4 places"));
    ck_assert_ptr_nonnull(strstr(text, "at most 0.500 mm at 1.000 2.000 3.000"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_prepare");
    TCase *tests = tcase_create("cloud_prepare");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, skipped);
    tcase_add_test(tests, reading);
    tcase_add_test(tests, placing);
    tcase_add_test(tests, cleaning);
    tcase_add_test(tests, under_a_roof);
    tcase_add_test(tests, files);
    tcase_add_test(tests, sheets);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

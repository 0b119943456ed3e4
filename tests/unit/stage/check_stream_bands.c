/* stream_bands: all rows of a grid once, none with more points about it than may be in memory but a
 * row alone; of each band exactly its points, in their order, however many bands there are, whether
 * or not there is room to set them aside. */
#include "stage/stream_bands.h"

#include <check.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/cloud/cloud_spool.h"
#include "scratch.h"
#include "seed.h"
#include "stage/stream_surface.h"

enum { ABOUT = 4 };

static struct vec3s points, seen;
static struct cloud_stream stream;
static struct error error;
static uint64_t state;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* A stream of points over 40 x 50 mm, most of them where y is small, with so many kept, the others
 * set aside where there is room. */
static void begin(size_t keep, double direction, bool room)
{
    const struct cloudmesh_options options = {.spacing = 1,
                                              .direction = direction,
                                              .normals = normals_of("quadric"),
                                              .effort = 1,
                                              .smooth = true,
                                              .silent = true};
    const struct transform none = transform_identity();
    enum { N = 40000 };
    char *text = malloc(80 * N);
    size_t at = 0;

    for (size_t i = 0; i < N; i++) {
        double x = 40 * uniform(), y = 50 * uniform() * uniform();
        struct vec3 *p = array_push(&points);
        *p = vec(x, y, i % 3 ? x / 9 : round(x));
        at += (size_t)sprintf(text + at, "%.17g %.17g %.17g\n", p->x, p->y, p->z);
    }
    const char *file = scratch_bytes(text, at);
    if (!room)
        scratch_no_room();
    ck_assert_int_eq(cloud_stream_begin(file, &none, &options, keep, 2, &stream, &error), 0);
    if (!room)
        scratch_room();
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), 0);
    free(text);
}

static void teardown(void)
{
    cloud_stream_free(&stream);
    array_free(&points);
    array_free(&seen);
}

/* Rows and numbers are what they are said to be. */
static void check_rows(const struct stream_bands *bands, const size_t *of_row, int rows,
                       size_t most)
{
    int next = 0;

    for (size_t k = 0; k < bands->n; k++) {
        const struct stream_band *b = &bands->item[k];
        size_t n = 0;
        ck_assert_int_eq(b->first, next);
        ck_assert_int_ge(b->last, b->first);
        next = b->last + 1;
        ck_assert_int_eq(b->low, b->first > ABOUT ? b->first - ABOUT : 0);
        ck_assert_int_eq(b->high, b->last + ABOUT < rows - 1 ? b->last + ABOUT : rows - 1);
        for (int row = b->low; row <= b->high; row++)
            n += of_row[row];
        ck_assert_uint_eq(b->n, n);
        ck_assert(n <= most || b->first == b->last);
        size_t more = b->high + 1 < rows ? of_row[b->high + 1] : 0;
        ck_assert(next == rows || n + more > most); /* none shorter than it has to be */
    }
    ck_assert_int_eq(next, rows);
}

/* The points of a band are those of the cloud in its rows, one after the other. */
static void check_points(struct stream_bands *bands, size_t k)
{
    const struct stream_band b = bands->item[k];
    size_t at = 0;

    seen.n = 0;
    *array_push(&seen) = vec(1, 2, 3); /* what is there stays */
    ck_assert_int_eq(stream_bands_points(bands, k, &stream, &seen, &error), 0);
    ck_assert_uint_eq(seen.n, b.n + 1);
    ck_assert(seen.item[0].z == 3);
    for (size_t i = 0; i < points.n; i++) {
        int row = stream_row(&stream.nodes.grid, &points.item[i]);
        if (row < b.low || row > b.high)
            continue;
        at++;
        ck_assert(memcmp(&seen.item[at], &points.item[i], sizeof *points.item) == 0);
    }
    ck_assert_uint_eq(at, b.n);
}

/* In bands of so many points; how many bands. */
static size_t in_bands(size_t at_a_time)
{
    const struct grid *grid = &stream.nodes.grid;
    struct stream_bands bands = stream_bands_of(grid, stream.counts->of_row, ABOUT, at_a_time);
    size_t n = bands.n;

    check_rows(&bands, stream.counts->of_row, grid->rows, at_a_time);
    for (size_t k = 0; k < n; k++)
        check_points(&bands, k);
    stream_bands_free(&bands);
    return n;
}

START_TEST(one_and_many)
{
    begin(0, _i * 25, true);
    ck_assert(cloud_spool_holds(stream.spool));
    ck_assert_uint_eq(in_bands(100000), 1);
    ck_assert_uint_eq(in_bands(points.n), 1);
    ck_assert(cloud_spool_holds(stream.spool));
    size_t some = in_bands(20000);
    ck_assert_uint_gt(some, 2);
    ck_assert_uint_lt(some, 30);
    ck_assert_ptr_null(stream.spool);   /* no longer wanted */
    ck_assert_uint_gt(in_bands(1), 40); /* a row each; the file is read again */
    ck_assert_uint_gt(in_bands(15000), 2);
}
END_TEST

START_TEST(kept_in_memory)
{
    begin(1000000, 0, true);
    ck_assert_uint_eq(stream.kept.n, points.n);
    ck_assert_uint_gt(in_bands(1), 40);
    ck_assert_uint_gt(in_bands(20000), 2);
}
END_TEST

/* Points in the order of their rows, each in a row that it is in by the grid's own lines. */
START_TEST(rows)
{
    begin(0, 0, true);
    const struct grid *grid = &stream.nodes.grid;
    double width = grid->t * sqrt(3) / 2;
    for (size_t i = 0; i < points.n; i++) {
        int row = stream_row(grid, &points.item[i]);
        double low = grid->y + row * width, y = points.item[i].y;
        ck_assert(row == 0 || y >= low - 1e-9);
        ck_assert(row == grid->rows - 1 || y <= low + width + 1e-9);
    }
    struct vec3 below = vec(0, -1e9, 0), above = vec(0, 1e9, 0);
    ck_assert_int_eq(stream_row(grid, &below), 0);
    ck_assert_int_eq(stream_row(grid, &above), grid->rows - 1);
}
END_TEST

/* No room from the beginning, and for the second lot of bands only. */
START_TEST(no_room)
{
    begin(0, 0, true);
    const struct grid *grid = &stream.nodes.grid;
    for (size_t full = 0; full <= 33; full += 32) {
        struct stream_bands bands = stream_bands_of(grid, stream.counts->of_row, ABOUT, 1);
        for (size_t k = 0; k < bands.n; k++) {
            if (k == full)
                scratch_no_room();
            check_points(&bands, k);
        }
        scratch_room();
        stream_bands_free(&bands);
        ck_assert(cloud_spool_holds(stream.spool));
    }
}
END_TEST

/* A file that is another one by now. */
START_TEST(changed)
{
    begin(0, 0, false);
    struct stream_bands bands =
        stream_bands_of(&stream.nodes.grid, stream.counts->of_row, ABOUT, 9000);
    scratch_text("1 2 3\n4 5 6\n");
    ck_assert_int_eq(stream_bands_points(&bands, 0, &stream, &seen, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "changes while it is read"));
    stream_bands_free(&bands);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stream_bands");
    TCase *tests = tcase_create("stream_bands");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_loop_test(tests, one_and_many, 0, 3);
    tcase_add_test(tests, kept_in_memory);
    tcase_add_test(tests, rows);
    tcase_add_test(tests, no_room);
    tcase_add_test(tests, changed);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

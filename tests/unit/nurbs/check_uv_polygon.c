/*
 * uv_polygon: what is inside an L with a square hole, by reckoning; by rows the same; areas and the
 * way that loops run.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/uv_polygon.h"

/* Counter-clockwise; the hole too. */
static const struct uv outer[] = {{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}};
static const struct uv hole[] = {{1, 1}, {2, 1}, {2, 3}, {1, 3}};

static void add(struct uv_polygon *loops, const struct uv *at, size_t n, bool turned)
{
    struct uvs *loop = array_push(loops);
    *loop = (struct uvs){0};
    for (size_t i = 0; i < n; i++)
        *array_push(loop) = at[turned ? n - 1 - i : i];
}

static struct uv_polygon ell(bool outer_turned, bool hole_turned)
{
    struct uv_polygon loops = {0};
    add(&loops, outer, 6, outer_turned);
    add(&loops, hole, 4, hole_turned);
    return loops;
}

static bool is_in_ell(double u, double v)
{
    bool in = u > 0 && v > 0 && ((u < 6 && v < 2) || (u < 3 && v < 5));
    return in && !(u > 1 && u < 2 && v > 1 && v < 3);
}

START_TEST(inside)
{
    struct uv_polygon loops = ell(_i & 1, _i & 2);
    struct uv_rows rows;
    uv_rows_make(&loops, &rows);
    ck_assert_uint_ge(rows.n, 2);
    for (int i = -2; i < 66; i++)
        for (int k = -2; k < 56; k++) {
            struct uv at = {0.1 * i + 0.05, 0.1 * k + 0.05};
            bool in = is_in_ell(at.u, at.v);
            ck_assert(uv_polygon_inside(&loops, false, at) == in);
            ck_assert(uv_polygon_inside(&loops, true, at) == !in);
            ck_assert(uv_rows_inside(&rows, false, at) == in);
            ck_assert(uv_rows_inside(&rows, true, at) == !in);
        }
    uv_rows_free(&rows);
    ck_assert_ptr_null(rows.first);
    uv_polygon_free(&loops);
    ck_assert_uint_eq(loops.n, 0);
}
END_TEST

/* Many sides: a saw of 200 teeth, of which the rows hold about eight times each. */
START_TEST(many_rows)
{
    enum { TEETH = 200 };
    struct uv_polygon loops = {0};
    struct uvs *loop = array_push(&loops);
    *loop = (struct uvs){0};
    for (int i = 0; i < TEETH; i++) {
        *array_push(loop) = (struct uv){0, i};
        *array_push(loop) = (struct uv){1, i + 0.5};
    }
    *array_push(loop) = (struct uv){0, TEETH};
    *array_push(loop) = (struct uv){-1, TEETH};
    *array_push(loop) = (struct uv){-1, 0};
    struct uv_rows rows;
    uv_rows_make(&loops, &rows);
    ck_assert_uint_ge(rows.n, 100);
    ck_assert_uint_le(rows.first[rows.n], 10 * loop->n);
    for (int i = 0; i < 7 * TEETH; i++) {
        double v = (i + 0.5) / 7, part = v - floor(v), edge = 1 - fabs(2 * part - 1);
        ck_assert(uv_rows_inside(&rows, false, (struct uv){edge - 0.01, v}));
        ck_assert(!uv_rows_inside(&rows, false, (struct uv){edge + 0.01, v}));
        ck_assert(!uv_rows_inside(&rows, false, (struct uv){-1.01, v}));
    }
    ck_assert(!uv_rows_inside(&rows, false, (struct uv){-0.5, -1}));
    ck_assert(!uv_rows_inside(&rows, false, (struct uv){-0.5, TEETH + 1}));
    uv_rows_free(&rows);
    uv_polygon_free(&loops);
}
END_TEST

START_TEST(nothing)
{
    struct uv_polygon loops = {0};
    struct uv_rows rows;
    uv_rows_make(&loops, &rows);
    ck_assert(!uv_rows_inside(&rows, false, (struct uv){0, 0}));
    ck_assert(uv_rows_inside(&rows, true, (struct uv){0, 0}));
    ck_assert(uv_polygon_inside(&loops, true, (struct uv){0, 0}));
    uv_rows_free(&rows);
    uv_polygon_free(&loops);
}
END_TEST

/* The inside is to the left of an outer loop that runs counter-clockwise and of a hole that runs
 * clockwise; with the border of the range as the outermost loop it is the other way round. */
START_TEST(ways)
{
    struct uv_polygon loops = ell(_i & 1, _i & 2);
    ck_assert_double_eq_tol(uv_loop_area(&loops.item[0]), _i & 1 ? -21 : 21, 1e-12);
    ck_assert_double_eq_tol(uv_loop_area(&loops.item[1]), _i & 2 ? -2 : 2, 1e-12);
    ck_assert(uv_polygon_backwards(&loops, 0, false) == ((_i & 1) != 0));
    ck_assert(uv_polygon_backwards(&loops, 1, false) == ((_i & 2) == 0));
    ck_assert(uv_polygon_backwards(&loops, 0, true) == ((_i & 1) == 0));
    ck_assert(uv_polygon_backwards(&loops, 1, true) == ((_i & 2) != 0));
    uv_polygon_free(&loops);
}
END_TEST

/* An eight crosses itself once, loops beside it not at all. */
START_TEST(crossings)
{
    static const struct uv eight[] = {{0.1, 0.1}, {0.9, 0.9}, {0.9, 0.1}, {0.1, 0.9}};
    static const struct uv square[] = {{0.2, 0.2}, {0.4, 0.2}, {0.4, 0.4}, {0.2, 0.4}};
    struct patch flat = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0));
    struct uv_polygon loops = {0};
    add(&loops, square, 4, false);
    ck_assert_uint_eq(uv_polygon_crossings(&loops, &flat.surface, 0.01), 0);
    add(&loops, eight, 4, false);
    ck_assert_uint_eq(uv_polygon_crossings(&loops, &flat.surface, 0.01), 1);
    add(&loops, eight, 4, true);
    ck_assert_uint_eq(uv_polygon_crossings(&loops, &flat.surface, 0.01), 2);
    uv_polygon_free(&loops);
    patch_free(&flat);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("uv_polygon");
    TCase *tests = tcase_create("uv_polygon");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, inside, 0, 4);
    tcase_add_test(tests, many_rows);
    tcase_add_test(tests, nothing);
    tcase_add_loop_test(tests, ways, 0, 4);
    tcase_add_test(tests, crossings);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

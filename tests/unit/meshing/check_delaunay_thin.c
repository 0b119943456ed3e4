/*
 * check_delaunay_thin - a lattice with peaks: what is no farther off than the error stays out, the
 * highest comes first, and no more points are taken than asked for.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"
#include "meshing/delaunay_thin.h"

/* The border stays by its corners and the place where it begins. */
enum { SIDE = 13, POINTS = SIDE * SIDE, BORDER = 5 };

static struct vec3 point[POINTS];

static void flat(void)
{
    for (int i = 0; i < POINTS; i++)
        point[i] = vec(i % SIDE, i / SIDE, 0);
}

/* Thinned; the corners that are put in, true for each point in `in`. */
static size_t thin(double error, size_t keep, bool in[POINTS])
{
    struct delaunay_mesh_options how = {.gap = 2, .error = error, .keep = keep};
    struct scan_border border = scan_border_find(point, POINTS, how.gap);
    struct delaunay d = delaunay_new(point, POINTS);
    bool *surface = delaunay_thin(&d, point, &border, &how);
    size_t n = 0;
    double area = 0;
    for (int i = 0; i < POINTS; i++) {
        in[i] = d.triangle[i] != DELAUNAY_NONE;
        n += in[i];
    }
    for (size_t t = 0; t < d.t.n; t++) {
        if (!surface[t])
            continue;
        ck_assert(delaunay_is_near(&d, (int)t));
        const int *v = d.t.item[t].v;
        struct uv a = d.at[v[0]], b = d.at[v[1]], c = d.at[v[2]];
        area += ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u)) / 2;
    }
    if (keep == 0 || keep >= 2 * BORDER)
        ck_assert_double_eq_tol(area, (SIDE - 1) * (SIDE - 1), 1e-9);
    free(surface);
    scan_border_free(&border);
    delaunay_free(&d);
    return n;
}

START_TEST(a_plane_is_its_border)
{
    bool in[POINTS];
    flat();
    ck_assert_uint_eq(thin(0.001, 0, in), BORDER);
    ck_assert(in[0] && in[SIDE - 1] && in[POINTS - SIDE] && in[POINTS - 1]);
}
END_TEST

/* Above a flat facet a point is as far off as it is high. */
START_TEST(as_far_off_as_the_error_is_near_enough)
{
    bool in[POINTS];
    int peak = 4 * SIDE + 6;
    flat();
    point[peak].z = 0.5;
    ck_assert_uint_eq(thin(0.5, 0, in), BORDER);
    point[peak].z = -0.5;
    ck_assert_uint_eq(thin(0.5, 0, in), BORDER);
    point[peak].z = 0.5000001;
    ck_assert_uint_gt(thin(0.5, 0, in), BORDER);
    ck_assert(in[peak]);
    point[peak].z = -0.5000001;
    ck_assert_uint_gt(thin(0.5, 0, in), BORDER);
    ck_assert(in[peak]);
}
END_TEST

/* Whichever it is of all inner points that is highest: so the heap gives the first of its order. */
START_TEST(the_highest_comes_first)
{
    for (int peak = SIDE + 1; peak < POINTS - SIDE; peak++) {
        bool in[POINTS];
        if (peak % SIDE == 0 || peak % SIDE == SIDE - 1)
            continue;
        flat();
        for (int i = SIDE; i < POINTS - SIDE; i++)
            if (i % SIDE != 0 && i % SIDE != SIDE - 1)
                point[i].z = 0.5 + 0.2 * (1 + sin((double)i * i));
        point[peak].z = 0.95;
        ck_assert_uint_eq(thin(0.001, 2 * BORDER, in), 2 * BORDER);
        ck_assert_msg(in[peak], "peak %d", peak);
    }
}
END_TEST

START_TEST(no_more_than_asked_for)
{
    bool in[POINTS];
    flat();
    for (int i = SIDE; i < POINTS - SIDE; i++)
        if (i % SIDE != 0 && i % SIDE != SIDE - 1)
            point[i].z = 0.5 + 0.2 * (1 + sin((double)i * i));
    for (size_t keep = 2 * BORDER; keep < 40; keep++)
        ck_assert_uint_eq(thin(1e-6, keep, in), keep);
    /* all are needed for an error of nearly nothing */
    ck_assert_uint_eq(thin(1e-9, 0, in), (SIDE - 2) * (SIDE - 2) + BORDER);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("delaunay_thin");
    TCase *tests = tcase_create("delaunay_thin");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_plane_is_its_border);
    tcase_add_test(tests, as_far_off_as_the_error_is_near_enough);
    tcase_add_test(tests, the_highest_comes_first);
    tcase_add_test(tests, no_more_than_asked_for);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/*
 * check_mesh_outline - the outline of plates with holes and islands of known size, with corners
 * left out, and of what has none.
 */
#include <check.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "mesh/mesh_outline.h"

enum { CELLS = 40 };

static struct mesh mesh;
static struct region_polygons outline;

static void setup(void)
{
    mesh = (struct mesh){0};
    outline = (struct region_polygons){0};
}

static void teardown(void)
{
    region_polygons_free(&outline);
    mesh_free(&mesh);
}

/* Cells of 1 mm from 0 to CELLS along x and y, those where `is_there`, on a slope. */
static void make(bool (*is_there)(int x, int y))
{
    for (int i = 0; i <= CELLS; i++)
        for (int k = 0; k <= CELLS; k++)
            *array_push(&mesh.vertex) = vec(i, k, 0.5 * i + 0.1 * k);
    for (int i = 0; i < CELLS; i++)
        for (int k = 0; k < CELLS; k++) {
            int a = i * (CELLS + 1) + k, b = a + CELLS + 1;
            if (!is_there(i, k))
                continue;
            *array_push(&mesh.face) = (struct face){{a, b, b + 1}};
            *array_push(&mesh.face) = (struct face){{a, b + 1, a + 1}};
        }
}

static bool in(int x, int y, int from, int to)
{
    return x >= from && x < to && y >= from && y < to;
}

/* A frame with an island in it. */
static bool is_frame(int x, int y)
{
    return in(x, y, 2, 38) ? !in(x, y, 8, 30) || in(x, y, 12, 20) : false;
}

START_TEST(a_frame_and_an_island)
{
    make(is_frame);
    ck_assert(mesh_outline_find(&mesh, 0.01, 2, &outline));
    ck_assert_uint_eq(outline.from.n, 3);
    ck_assert_uint_eq(outline.corner.n, 12);
    for (int x = 0; x < CELLS; x++)
        for (int y = 0; y < CELLS; y++)
            ck_assert_int_eq(region_polygons_hold(&outline, vec(x + 0.5, y + 0.5, 7)),
                             is_frame(x, y));
    region_polygons_free(&outline);
    ck_assert(mesh_outline_find(&mesh, 0.01, 8, &outline));
    ck_assert_uint_eq(outline.from.n, 2); /* the island is no wider */
    ck_assert_uint_eq(outline.corner.n, 8);
}
END_TEST

/* Cells that meet in corners alone. */
static bool is_chequered(int x, int y)
{
    return in(x, y, 4, 12) && (x + y) % 2 == 0;
}

START_TEST(corners_that_touch)
{
    make(is_chequered);
    ck_assert(mesh_outline_find(&mesh, 0.01, 0, &outline));
    for (int x = 0; x < CELLS; x++)
        for (int y = 0; y < CELLS; y++)
            ck_assert_int_eq(region_polygons_hold(&outline, vec(x + 0.4, y + 0.6, 0)),
                             is_chequered(x, y));
}
END_TEST

static bool is_disc(int x, int y)
{
    return (x - 20) * (x - 20) + (y - 20) * (y - 20) < 15 * 15;
}

/* Steps of a millimetre along a circle: with 0.75 mm fewer corners are enough, and no place that is
 * farther from the border is on the other side. */
START_TEST(corners_left_out)
{
    const double within = 0.75;
    size_t all;

    make(is_disc);
    ck_assert(mesh_outline_find(&mesh, 1e-6, 2, &outline));
    all = outline.corner.n;
    region_polygons_free(&outline);
    ck_assert(mesh_outline_find(&mesh, within, 2, &outline));
    ck_assert_uint_lt(outline.corner.n, all / 2);
    for (int x = 1; x < CELLS - 1; x++)
        for (int y = 1; y < CELLS - 1; y++) {
            bool is = is_disc(x, y), alike = true;
            for (int k = 0; k < 9; k++)
                alike = alike && is_disc(x + k % 3 - 1, y + k / 3 - 1) == is;
            if (alike) /* the middle of the cell is 1.5 mm from the border */
                ck_assert_int_eq(region_polygons_hold(&outline, vec(x + 0.5, y + 0.5, 0)), is);
        }
}
END_TEST

START_TEST(what_has_none)
{
    make(is_disc);
    struct face first = mesh.face.item[0];
    *array_push(&mesh.face) = first; /* an edge of three */
    ck_assert(!mesh_outline_find(&mesh, 0.01, 0, &outline));
    ck_assert_uint_eq(outline.corner.n + outline.from.n, 0);
    mesh.face.n--;
    mesh.face.item[0] = (struct face){{first.v[1], first.v[0], first.v[2]}};
    ck_assert(!mesh_outline_find(&mesh, 0.01, 0, &outline));
    ck_assert_uint_eq(outline.corner.n + outline.from.n, 0);
    mesh.face.n = 0;
    ck_assert(mesh_outline_find(&mesh, 0.01, 0, &outline));
    ck_assert_uint_eq(outline.corner.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh_outline");
    TCase *tests = tcase_create("outline");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, a_frame_and_an_island);
    tcase_add_test(tests, corners_that_touch);
    tcase_add_test(tests, corners_left_out);
    tcase_add_test(tests, what_has_none);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* steep_facets: between the points of a wall that a scan from above has few of a ball is kept off,
 * and in front of it, in hollows, and over holes it is let be. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/steep_facets.h"
#include "math/kdtree.h"
#include "noisy.h"
#include "seed.h"

#define BALL 3.0
#define SPACING 0.5

static size_t facets_of(struct vec3s *scan, double spacing, bool sure, int threads,
                        struct vec3s *to)
{
    struct point_grid grid;
    struct error error;

    ck_assert_int_eq(point_grid_make(scan->item, scan->n, spacing, 1, &grid, &error), 0);
    size_t facets = 0;
    const struct steep_facets_options options = {
        .radius = BALL, .sink = 0.002, .sure = sure, .threads = threads};
    facets = steep_facets(&grid, &options, to);
    point_grid_free(&grid);
    return facets;
}

/* Points anywhere over [-10, 10]^2, so many to a mm2 as the spacing says. */
static void scan_of(double (*height)(double x, double y), struct vec3s *scan)
{
    noisy_seed((unsigned)(seed_step() >> 33));
    for (int i = 0; i < (int)(400 / (SPACING * SPACING)); i++) {
        double x = 20 * noisy_uniform() - 10, y = 20 * noisy_uniform() - 10;
        if (isfinite(height(x, y)))
            *array_push(scan) = vec(x, y, height(x, y));
    }
}

#define DRAFT 0.03 /* 88.3 degrees */
#define HIGH 20.0

static double wall(double x, double y)
{
    (void)y;
    return fmin(HIGH, fmax(0, HIGH - x / DRAFT));
}

/* How deep a ball, of places or points on the wall, gets in that stands before it at a height. */
static double depth_at(const struct kdtree *tree, double y, double z)
{
    double deep = 0;

    for (; deep < BALL; deep += 0.02) {
        struct vec3 centre = vec((HIGH - z) * DRAFT + BALL - deep, y, z);
        if (kdtree_any_beside(tree, centre, centre, BALL))
            break;
    }
    return deep;
}

/* Of the points alone it gets in by more than 0.25 mm in one place of three and more; of the places
 * too in half as many at most: those where facets to the floor, that are hollow, are none. */
START_TEST(wall_of_few_points)
{
    struct vec3s scan = {0}, place = {0};
    int points = 0, places = 0, all = 0;

    scan_of(wall, &scan);
    ck_assert_uint_gt(facets_of(&scan, SPACING, false, 2, &place), 20);
    struct kdtree *of_points = kdtree_new(scan.item, scan.n);
    for (size_t i = 0; i < scan.n; i++)
        *array_push(&place) = scan.item[i];
    struct kdtree *of_places = kdtree_new(place.item, place.n);
    for (double y = -8; y <= 8; y += 0.5)
        for (double z = 5; z <= HIGH - 2; z += 1) {
            points += depth_at(of_points, y, z) > 0.25;
            places += depth_at(of_places, y, z) > 0.25;
            all++;
        }
    ck_assert_int_gt(3 * points, all);
    ck_assert_int_lt(2 * places, points);
    kdtree_free(of_points);
    kdtree_free(of_places);
    array_free(&scan);
    array_free(&place);
}
END_TEST

/* By what is known a wall stands anywhere between its foot and the first point of the floor: few of
 * the places are in front of it by more than half a spacing.  Those that are sure are fewer. */
START_TEST(few_before_a_wall)
{
    struct vec3s scan = {0}, place = {0};
    double part[2] = {0, 0};
    size_t all = 0;

    scan_of(wall, &scan);
    for (int sure = 0; sure < 2; sure++) {
        place.n = 0;
        facets_of(&scan, SPACING, sure, 2, &place);
        ck_assert_uint_gt(place.n, 1000);
        all = sure ? all : place.n;
        for (size_t i = 0; i < place.n; i++) {
            double out = place.item[i].x - (HIGH - place.item[i].z) * DRAFT;
            ck_assert_double_lt(out, 3 * SPACING); /* no wider is a circle */
            part[sure] += out > 0.5 * SPACING;
        }
        part[sure] /= (double)place.n;
    }
    ck_assert_double_lt(part[0], 0.15);
    ck_assert_double_lt(part[1], 0.15);
    ck_assert_uint_lt(place.n, all);
    array_free(&scan);
    array_free(&place);
}
END_TEST

static double groove(double x, double y)
{
    (void)y;
    return fmin(15, 5 * fabs(x));
}

/* Two flanks of 79 degrees that meet in a groove: what would go from one to the other is none. */
START_TEST(none_over_a_groove)
{
    struct vec3s scan = {0}, place = {0};

    scan_of(groove, &scan);
    facets_of(&scan, SPACING, false, 1, &place);
    ck_assert_uint_gt(place.n, 1000);
    for (size_t i = 0; i < place.n; i++) {
        struct vec3 p = place.item[i];
        ck_assert_double_lt((p.z - groove(p.x, p.y)) / hypot(1, 5), 1.5 * SPACING);
    }
    array_free(&scan);
    array_free(&place);
}
END_TEST

static double gap(double x, double y)
{
    (void)y;
    return fabs(x) < 2 * SPACING ? HUGE_VAL : x < 0 ? 5 : 0;
}

/* Over what nothing was seen of, four spacings wide, goes none. */
START_TEST(none_over_a_hole)
{
    struct vec3s scan = {0}, place = {0};

    scan_of(gap, &scan);
    ck_assert_uint_eq(facets_of(&scan, SPACING, false, 1, &place), 0);
    ck_assert_uint_eq(place.n, 0);
    array_free(&scan);
    array_free(&place);
}
END_TEST

static double slope(double x, double y)
{
    (void)y;
    return 1.5 * x;
}

/* A slope of 56 degrees has points enough; and a wall so many that no ball sinks in between. */
START_TEST(none_where_there_are_enough)
{
    struct vec3s scan = {0}, place = {0};

    scan_of(slope, &scan);
    ck_assert_uint_eq(facets_of(&scan, SPACING, false, 1, &place), 0);
    scan.n = 0;
    for (double y = -5; y < 5; y += 0.1)
        for (double z = 0; z < 5; z += 0.1)
            *array_push(&scan) = vec((5 - z) * DRAFT, y, z);
    ck_assert_uint_eq(facets_of(&scan, 0.1, false, 1, &place), 0);
    array_free(&scan);
    array_free(&place);
}
END_TEST

/* On a grid four points are on each circle: the facets are there, and end. */
START_TEST(points_on_a_grid)
{
    struct vec3s scan = {0}, place = {0}, again = {0};

    for (int i = -20; i < 20; i++)
        for (int k = -20; k < 20; k++)
            *array_push(&scan) = vec(0.5 * i, 0.5 * k, i < 0 ? 6 : 0);
    ck_assert_uint_ge(facets_of(&scan, SPACING, false, 1, &place), 38);
    facets_of(&scan, SPACING, false, 4, &again);
    ck_assert_uint_eq(place.n, again.n);
    for (size_t i = 0; i < place.n; i++)
        ck_assert_double_eq(vec_distance(place.item[i], again.item[i]), 0);
    array_free(&scan);
    array_free(&place);
    array_free(&again);
}
END_TEST

/* Of a step 2.5 spacings high who asks what is in reach asks the points; of a higher one these do
 * not tell. */
START_TEST(what_is_asked)
{
    for (int high = 1; high < 4; high++) {
        struct vec3s scan = {0}, place = {0}, asked = {0};
        struct point_grid grid;
        struct error error;
        for (int i = -20; i < 20; i++)
            for (int k = -20; k < 20; k++)
                *array_push(&scan) =
                    vec(SPACING * i, SPACING * k, i < 0 ? 2.5 * high * SPACING : 0);
        ck_assert_uint_ge(facets_of(&scan, SPACING, false, 1, &place), 38);
        ck_assert_int_eq(point_grid_make(scan.item, scan.n, SPACING, 1, &grid, &error), 0);
        steep_facets_asked(&grid, BALL, 0, 1, &asked);
        ck_assert_uint_eq(asked.n, high == 1 ? 0 : place.n);
        size_t before = asked.n;
        steep_facets_sure(&grid, NULL, BALL, 0, 1, &asked);
        ck_assert_uint_gt(asked.n, before);
        point_grid_free(&grid);
        array_free(&scan);
        array_free(&place);
        array_free(&asked);
    }
}
END_TEST

/* Crowns at the edge of what was seen: heights are anything, and a hole is beside. */
static double crowns(double x, double y)
{
    return hypot(x - 4, y + 3) < 3 ? HUGE_VAL : 8 * noisy_uniform() * (x > -6);
}

/* Facets are the same ones whichever corner is the first: of the scan as its mirror shows it. */
START_TEST(same_whatever_the_order)
{
    struct vec3s scan = {0}, mirrored = {0}, place = {0};

    scan_of(crowns, &scan);
    size_t facets[4];
    for (int turn = 0; turn < 4; turn++) {
        mirrored.n = place.n = 0;
        for (size_t i = 0; i < scan.n; i++) {
            struct vec3 p = scan.item[i];
            *array_push(&mirrored) = vec(turn & 1 ? -p.x : p.x, turn & 2 ? -p.y : p.y, p.z);
        }
        facets[turn] = facets_of(&mirrored, SPACING, false, 2, &place);
    }
    ck_assert_uint_gt(facets[0], 50);
    for (int turn = 1; turn < 4; turn++)
        ck_assert_uint_eq(facets[turn], facets[0]);
    array_free(&scan);
    array_free(&mirrored);
    array_free(&place);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("steep_facets");
    TCase *tests = tcase_create("steep_facets");

    tcase_add_test(tests, wall_of_few_points);
    tcase_add_test(tests, few_before_a_wall);
    tcase_add_test(tests, none_over_a_groove);
    tcase_add_test(tests, none_over_a_hole);
    tcase_add_test(tests, none_where_there_are_enough);
    tcase_add_test(tests, points_on_a_grid);
    tcase_add_test(tests, what_is_asked);
    tcase_add_test(tests, same_whatever_the_order);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/*
 * check_excursion - a cut over a flat part that jumps up: as a curve, as a spike of two blocks, as
 * a way from pass to pass, out beside the part.
 */
#include <check.h>
#include <stdlib.h>

#include "simulate/deviation_map.h"
#include "simulate/excursion.h"

#define RADIUS 5.0

enum { PIECES = 6 };

static const double level[PIECES + 1] = {0};

/*
 * Blocks along x, 4 mm each, from x = -12; `high` of them at their ends, the second rotary axis at
 * `turn` degrees; those not straight are one cubic each, or so many spans, straight too, so that
 * heights are those given.
 */
static struct excursion in_spans(const double high[PIECES + 1], const double side[PIECES + 1],
                                 const double turn[PIECES + 1], const unsigned char shape[PIECES],
                                 int spans)
{
    struct nc_motion motion = {.kinematics = verify_kinematics_trunnion('A', 1),
                               .track = NC_MOTION_TIP};
    struct centre_path path = {0};
    struct vec3s points = {0};
    struct deviation_map roll;
    for (double x = -14; x <= 14; x += 0.5)
        for (double y = -4; y <= 4; y += 0.5)
            *array_push(&points) = vec(x, y, 0);
    for (int n = 0; n < PIECES * spans; n++) {
        int i = n / spans;
        double begin = (double)(n % spans) / spans, end = begin + 1.0 / spans;
        struct vec3 a = vec(4 * i - 12, side[i], high[i]);
        struct vec3 b = vec(4 * i - 8, side[i + 1], high[i + 1]);
        struct vec3 from = vec_mix(a, b, begin), to = vec_mix(a, b, end);
        double turns = turn[i + 1] - turn[i];
        *array_push(&motion.polynomial) = (struct nc_motion_polynomial){.p[0] = vec_sub(to, from)};
        *array_push(&motion.piece) = (struct nc_piece){
            .shape = shape[i],
            .interpolation = AXIS_ROTARY_LINEAR,
            .index = (size_t)n,
            .p = {from, to},
            .q = {{0, turn[i] + begin * turns, 0}, {0, turn[i] + end * turns, 0}}};
        for (int k = 0; k < 40; k++)
            *array_push(&path) = (struct centre_segment){
                vec_along(vec_mix(from, to, k / 40.0), RADIUS, vec(0, 0, 1)),
                vec_along(vec_mix(from, to, (k + 1) / 40.0), RADIUS, vec(0, 0, 1)),
                {(float)k / 40, (float)(k + 1) / 40},
                (unsigned)n,
                false};
    }
    const struct deviation_map_options setup = {RADIUS, 0.02, 1.25, 1, false, HUGE_VAL};
    deviation_map_run(&path, points.item, points.n, &setup, &roll);
    struct excursion leap = excursion_find(&motion, &path, points.item, points.n,
                                           &(struct excursion_options){RADIUS, setup.band});
    deviation_map_free(&roll);
    nc_motion_free(&motion);
    array_free(&path);
    array_free(&points);
    return leap;
}

static struct excursion turned(const double high[PIECES + 1], const double side[PIECES + 1],
                               const double turn[PIECES + 1], const unsigned char shape[PIECES])
{
    return in_spans(high, side, turn, shape, 1);
}

static struct excursion shaped(const double high[PIECES + 1], const double side[PIECES + 1],
                               const unsigned char shape[PIECES])
{
    return turned(high, side, level, shape);
}

static struct excursion over(const double high[PIECES + 1], const double side[PIECES + 1],
                             unsigned char shape)
{
    const unsigned char all[PIECES] = {shape, shape, shape, shape, shape, shape};
    return shaped(high, side, all);
}

START_TEST(a_curve_that_jumps)
{
    const double high[PIECES + 1] = {0, 0, 3, 8, 2, 0, 0};
    struct excursion leap = over(high, level, SHAPE_POLYNOMIAL);
    ck_assert_uint_eq(leap.count, 1);
    ck_assert_double_eq_tol(leap.height, 8, 1e-6);
    ck_assert_double_eq_tol(leap.at.x, 0, 1e-6);
    ck_assert(leap.piece == 2 || leap.piece == 3);
    ck_assert_uint_eq(over(level, level, SHAPE_POLYNOMIAL).count, 0);
}
END_TEST

/* A link as a curve: no pole reaches over so many spans. */
START_TEST(a_long_rise_is_a_link)
{
    const double high[PIECES + 1] = {0, 3, 6, 7, 6, 2, 0};
    const unsigned char p = SHAPE_POLYNOMIAL, shape[PIECES] = {p, p, p, p, p, p};

    ck_assert_uint_eq(in_spans(high, level, level, shape, 1).count, 1);
    ck_assert_uint_eq(in_spans(high, level, level, shape, 2).count, 0);
}
END_TEST

/* One that comes back only at the very end, in the last segment of the path. */
START_TEST(a_curve_that_jumps_last)
{
    const double high[PIECES + 1] = {0, 0, 0, 0, 0, 100, 0};
    struct excursion leap = over(high, level, SHAPE_POLYNOMIAL);
    ck_assert_uint_eq(leap.count, 1);
    ck_assert_double_eq_tol(leap.height, 100, 1e-6);
}
END_TEST

/* The tip is thrown past the other point on the axis: the tool is upside down up there. */
START_TEST(a_curve_that_turns_the_tool_over)
{
    const double high[PIECES + 1] = {0, 0, 3, 80, 2, 0, 0},
                               turn[PIECES + 1] = {0, 0, 0, 180, 0, 0, 0};
    const unsigned char p = SHAPE_POLYNOMIAL, shape[PIECES] = {p, p, p, p, p, p};
    struct excursion leap = turned(high, level, turn, shape);
    ck_assert_uint_eq(leap.count, 1);
    ck_assert_double_eq_tol(leap.height, 80, 1e-6);
}
END_TEST

/* A curve that ends high over the part: a fault when the straight block behind it comes down. */
START_TEST(a_curve_that_ends_high)
{
    const unsigned char l = SHAPE_LINE, p = SHAPE_POLYNOMIAL, shape[PIECES] = {p, p, p, l, l, l};
    const double down[PIECES + 1] = {0, 0, 1, 8, 2, 2, 2},
                               up[PIECES + 1] = {0, 0, 1, 8, 20, 20, 20};
    const double out[PIECES + 1] = {0, 0, 1, 8, 2, 2, 2}, side[PIECES + 1] = {0, 0, 9, 40, 9, 0, 0};
    struct excursion leap = shaped(down, level, shape);
    ck_assert_uint_eq(leap.count, 1);
    ck_assert_double_eq_tol(leap.height, 8, 1e-6);
    ck_assert_uint_eq(leap.piece, 2);
    ck_assert_uint_eq(shaped(up, level, shape).count, 0);
    /* the last pole reaches over one span */
    ck_assert_uint_eq(in_spans(down, level, level, shape, 2).count, 0);
    ck_assert_uint_eq(shaped(out, side, shape).count, 0);
}
END_TEST

/* A curve that comes down by itself where the part has no points, a wall, and a straight block that
 * goes on as it did. */
START_TEST(a_curve_that_ends_going_down)
{
    const unsigned char l = SHAPE_LINE, p = SHAPE_POLYNOMIAL, shape[PIECES] = {p, p, p, l, l, l};
    const double down[PIECES + 1] = {0, 12, 20, 14, 8, 2, 0};
    ck_assert_uint_eq(shaped(down, level, shape).count, 0);
}
END_TEST

/* A straight block that ends high, and a curve that comes down from there at a sharp angle or not.
 */
START_TEST(a_curve_that_begins_high)
{
    const unsigned char l = SHAPE_LINE, p = SHAPE_POLYNOMIAL, shape[PIECES] = {l, l, l, p, p, p};
    const double sharp[PIECES + 1] = {0, 0, 0, 8, 0, 0, 0},
                                flat[PIECES + 1] = {0, 0, 0, 8, 8, 2, 0};
    struct excursion leap = shaped(sharp, level, shape);
    ck_assert_uint_eq(leap.count, 1);
    ck_assert_double_eq_tol(leap.height, 8, 1e-6);
    ck_assert_uint_eq(leap.piece, 2);
    ck_assert_uint_eq(shaped(flat, level, shape).count, 0);
}
END_TEST

START_TEST(less_than_the_band_is_none)
{
    const double high[PIECES + 1] = {0, 0, 0.5, 1.2, 0.5, 0, 0};
    ck_assert_uint_eq(over(high, level, SHAPE_POLYNOMIAL).count, 0);
}
END_TEST

START_TEST(a_spike_of_two_blocks)
{
    const double high[PIECES + 1] = {0, 0, 0, 30, 0, 0, 0};
    ck_assert_uint_eq(over(high, level, SHAPE_LINE).count, 1);
    ck_assert_double_eq_tol(over(high, level, SHAPE_LINE).height, 30, 1e-6);
}
END_TEST

/* In a link, which is off the part at both ends of the spike, up or askew; but no low arch. */
START_TEST(a_spike_amid_a_link)
{
    const double high[PIECES + 1] = {0, 0, 2, 100, 2, 0, 0},
                               low[PIECES + 1] = {0, 0, 2, 3, 2, 0, 0},
                               askew[PIECES + 1] = {0, 2, 2, 100, 30, 2, 0};
    ck_assert_uint_eq(over(high, level, SHAPE_LINE).count, 1);
    ck_assert_double_eq_tol(over(high, level, SHAPE_LINE).height, 100, 1e-6);
    ck_assert_uint_eq(over(high, level, SHAPE_LINE).piece, 2);
    ck_assert_uint_eq(over(askew, level, SHAPE_LINE).count, 1);
    ck_assert_uint_eq(over(low, level, SHAPE_LINE).count, 0);
}
END_TEST

/* Down past the part and sharply back up to it: the way in of an axis that leans far. */
START_TEST(a_sharp_way_in_is_none)
{
    const double in[PIECES + 1] = {15, -40, 3, 0, 0, 0, 0}, by[PIECES + 1] = {5, 60, 5, 0, 0, 0, 0};
    const double out[PIECES + 1] = {0, 0, 0, 0, 3, -40, 15},
                              off[PIECES + 1] = {0, 0, 0, 0, 5, 60, 5};
    ck_assert_uint_eq(over(in, by, SHAPE_LINE).count, 0);
    ck_assert_uint_eq(over(out, off, SHAPE_LINE).count, 0);
}
END_TEST

START_TEST(up_across_and_down_is_a_way)
{
    const double high[PIECES + 1] = {0, 0, 30, 30, 0, 0, 0};
    ck_assert_uint_eq(over(high, level, SHAPE_LINE).count, 0);
}
END_TEST

START_TEST(beside_the_part_is_none)
{
    const double side[PIECES + 1] = {0, 0, 10, 30, 10, 0, 0};
    ck_assert_uint_eq(over(level, side, SHAPE_POLYNOMIAL).count, 0);
}
END_TEST

/* Three straight blocks: out at right angles to the row, along it, and back. */
START_TEST(a_detour_beside_the_part)
{
    const double far[PIECES + 1] = {0, 0, 30, 30, 0, 0, 0},
                              near[PIECES + 1] = {0, 0, 20, 20, 0, 0, 0};
    const double on[PIECES + 1] = {0, 0, 2, 12, 30, 30, 30};
    struct excursion out = over(level, far, SHAPE_LINE);
    ck_assert_uint_eq(out.count, 1);
    ck_assert_uint_eq(out.piece, 1);
    ck_assert_double_gt(out.height, 20);
    ck_assert_uint_eq(over(level, near, SHAPE_LINE).count, 0);
    ck_assert_uint_eq(over(level, on, SHAPE_LINE).count, 0);
    ck_assert_uint_eq(over(far, level, SHAPE_LINE).count, 0); /* a link */
}
END_TEST

/* Where nobody knows what stands: two straight blocks by two radii and 10 mm, curves by more. */
START_TEST(far_beside_the_part)
{
    const double far[PIECES + 1] = {0, 0, 0, 30, 0, 0, 0},
                              near[PIECES + 1] = {0, 0, 0, 20, 0, 0, 0};
    const double farther[PIECES + 1] = {0, 0, 10, 80, 10, 0, 0};
    struct excursion out = over(level, far, SHAPE_LINE);
    ck_assert_uint_eq(out.count, 1);
    ck_assert_double_eq_tol(out.at.y, 30, 1e-6);
    ck_assert_uint_eq(over(level, near, SHAPE_LINE).count, 0);
    ck_assert_uint_eq(over(level, farther, SHAPE_POLYNOMIAL).count, 1);
}
END_TEST

START_TEST(a_layer_above_the_part_is_none)
{
    const double high[PIECES + 1] = {3, 3, 6, 9, 6, 3, 3};
    ck_assert_uint_eq(over(high, level, SHAPE_POLYNOMIAL).count, 0);
}
END_TEST

/* An arc in the plane of x and z from one place to another; it turns by so many radians, below zero
 * over the chord. */
static void add_arc(struct nc_motion *motion, struct vec3 from, struct vec3 to, double angle)
{
    struct vec3 chord = vec_sub(to, from), middle = vec_mix(from, to, 0.5);
    struct vec3 left = vec_unit(vec(-chord.z, 0, chord.x)); /* of the way, up */
    double up = vec_length(chord) / 2 / tan(angle / 2);
    *array_push(&motion->arc) =
        (struct nc_motion_arc){vec_along(middle, up, left), vec(0, -1, 0), angle};
    *array_push(&motion->piece) = (struct nc_piece){.shape = SHAPE_ARC,
                                                    .index = motion->arc.n - 1,
                                                    .p = {from, to},
                                                    .q = {{0, 0, 1}, {0, 0, 1}}};
}

/* A link of arcs that go over into each other, from the part over to it again, and the same with
 * the centre of the highest moved. */
START_TEST(a_link_of_smooth_arcs)
{
    const double lean = PI / 4, r = 0.9 / (1 - cos(lean)), away = r * sin(lean);
    struct nc_motion motion = {.kinematics.tool = {0, 0, 1}, .track = NC_MOTION_TIP};
    struct centre_path path = {0};
    struct vec3s points = {0};
    struct deviation_map roll;
    const struct deviation_map_options setup = {RADIUS, 0.02, 1.25, 1, false, HUGE_VAL};
    for (double x = -14; x <= 14; x += 0.5)
        for (double y = -4; y <= 4; y += 0.5)
            *array_push(&points) = vec(x, y, 0);
    struct vec3 a = vec(-4 - away, 0, 0), b = vec(-4, 0, 0.9), c = vec(4, 0, 0.9);
    struct vec3 d = vec(4 + away, 0, 0), z = {0, 0, 1};
    *array_push(&motion.piece) = (struct nc_piece){.p = {vec(-12, 0, 0), a}, .q = {z, z}};
    add_arc(&motion, a, b, lean);
    add_arc(&motion, b, c, -2 * (_i ? 1.6 * lean : lean));
    add_arc(&motion, c, d, lean);
    *array_push(&motion.piece) = (struct nc_piece){.p = {d, vec(12, 0, 0)}, .q = {z, z}};
    centre_path_cut(&motion, &(struct centre_path_options){RADIUS, 0.001, NULL}, &path);
    deviation_map_run(&path, points.item, points.n, &setup, &roll);
    struct excursion leap = excursion_find(&motion, &path, points.item, points.n,
                                           &(struct excursion_options){RADIUS, setup.band});
    ck_assert_uint_eq(leap.count, (size_t)_i);
    deviation_map_free(&roll);
    nc_motion_free(&motion);
    array_free(&path);
    array_free(&points);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("excursion");
    TCase *tcase = tcase_create("excursion");
    tcase_add_test(tcase, a_curve_that_jumps);
    tcase_add_loop_test(tcase, a_link_of_smooth_arcs, 0, 2);
    tcase_add_test(tcase, a_curve_that_jumps_last);
    tcase_add_test(tcase, a_long_rise_is_a_link);
    tcase_add_test(tcase, a_curve_that_turns_the_tool_over);
    tcase_add_test(tcase, a_curve_that_ends_high);
    tcase_add_test(tcase, a_curve_that_ends_going_down);
    tcase_add_test(tcase, a_curve_that_begins_high);
    tcase_add_test(tcase, less_than_the_band_is_none);
    tcase_add_test(tcase, a_spike_of_two_blocks);
    tcase_add_test(tcase, a_spike_amid_a_link);
    tcase_add_test(tcase, a_detour_beside_the_part);
    tcase_add_test(tcase, a_sharp_way_in_is_none);
    tcase_add_test(tcase, up_across_and_down_is_a_way);
    tcase_add_test(tcase, beside_the_part_is_none);
    tcase_add_test(tcase, far_beside_the_part);
    tcase_add_test(tcase, a_layer_above_the_part_is_none);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

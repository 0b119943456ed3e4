/* Tests of grown_knots.h: the tolerance against the data itself, knots where the data asks for
 * them, and spans that are long enough. */
#include "splinefit/grown_knots.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "seed.h"
#include "trial.h"

enum { POINTS = 600 };
static const double SPACING = 0.2, TOLERANCE = 0.01;

/* Nearly straight, with a wave of 0.8 mm in its middle; and each point off by chance, if asked for.
 * The axis leans to the side with the wave. */
static struct reference uneven(double noise, bool turns)
{
    struct run run = {.radius = 5};
    unsigned seed = (unsigned)seed_begin(12345);

    for (int k = 0; k < POINTS; k++) {
        double x = SPACING * k, near = (x - 60) / 8, bump = exp(-near * near);
        seed = seed * 1103515245u + 12345u;
        double chance = noise * ((double)(seed >> 16 & 0x7fff) / 16384 - 1);
        struct vec3 tip = vec(x, 0, 0.4 * bump * sin(1.5 * x) + chance);
        struct vec3 axis = vec_unit(vec(0, turns ? 0.2 * bump : 0, 1));
        *array_push(&run) =
            (struct run_point){.tip = tip, .ball = vec_along(tip, 5, axis), .axis = axis};
    }
    struct reference reference = reference_distinct(&run, false);
    array_free(&run);
    return reference;
}

/* The largest distance of the data from 40 places in each span, joined. */
static double worst_off(const struct bspline *curve, const struct reference *data)
{
    double worst = 0;

    for (size_t k = 0; k < data->n; k++) {
        double nearest = HUGE_VAL;
        struct vec3 before = curve->pole[0];
        for (size_t s = (size_t)curve->degree; s < curve->poles; s++)
            for (int i = 1; i <= 40; i++) {
                double a = curve->knot[s], b = curve->knot[s + 1];
                struct vec3 here = bspline_at(curve, curve->pole, a + i * (b - a) / 40);
                nearest = fmin(nearest, vec_segment_distance(before, here, data->point[k]));
                before = here;
            }
        worst = fmax(worst, nearest);
    }
    return worst;
}

static struct free_knots_options options(double least)
{
    return (struct free_knots_options){
        .degree = 3, .tolerance = TOLERANCE, .angle = 0.02, .least = least};
}

START_TEST(within_the_tolerance)
{
    for (int turns = 0; turns < 2; turns++) {
        struct reference data = uneven(0, turns);
        struct free_knots_options o = options(0);
        struct free_knots_result found = grown_knots_fit(&data, &o, NULL);

        ck_assert_uint_gt(found.curve.poles, 0);
        ck_assert((found.curve.head != NULL) == turns);
        ck_assert_double_le(worst_off(&found.curve, &data), TOLERANCE + 1e-6);
        ck_assert_double_le(found.proof.point, TOLERANCE);
        ck_assert_double_le(found.proof.other, TOLERANCE);
        ck_assert_double_le(found.proof.axis, o.angle);
        ck_assert_uint_lt(found.curve.poles, 100); /* 600 points; a sine has some 6 a turn */
        bspline_free(&found.curve);
        reference_free(&data);
    }
}
END_TEST

START_TEST(knots_stand_in_the_wave)
{
    struct reference data = uneven(0, false);
    struct free_knots_options o = options(0);
    struct bspline curve = grown_knots_fit(&data, &o, NULL).curve;
    ck_assert_uint_gt(curve.poles, 8);
    double length = curve.knot[curve.poles];
    size_t inside = 0, all = curve.poles - 4;

    for (size_t j = 4; j < curve.poles; j++)
        inside += curve.knot[j] > 0.3 * length && curve.knot[j] < 0.7 * length;
    ck_assert_uint_gt(10 * inside, 9 * all);
    bspline_free(&curve);
    reference_free(&data);
}
END_TEST

/* Noise of twice the tolerance: there is hardly a knot to spare, but no more poles than points. */
START_TEST(noise_is_followed)
{
    struct reference data = uneven(2 * TOLERANCE, false);
    struct free_knots_options o = options(0);
    struct bspline curve = grown_knots_fit(&data, &o, NULL).curve;

    ck_assert_uint_gt(curve.poles, 0);
    ck_assert_uint_lt(curve.poles, data.n);
    ck_assert_double_le(worst_off(&curve, &data), TOLERANCE + 1e-6);
    bspline_free(&curve);
    reference_free(&data);
}
END_TEST

START_TEST(spans_are_long_enough_unless_the_tolerance_forbids_it)
{
    struct reference data = uneven(0, false);
    struct free_knots_options o = options(0.5);
    struct bspline curve = grown_knots_fit(&data, &o, NULL).curve;

    ck_assert_uint_gt(curve.poles, 0);
    ck_assert(!bspline_has_short_span(&curve, o.least));
    ck_assert_double_le(worst_off(&curve, &data), TOLERANCE + 1e-6);
    bspline_free(&curve);
    o.least = 10; /* longer than a wave */
    curve = grown_knots_fit(&data, &o, NULL).curve;
    ck_assert_uint_gt(curve.poles, 0);
    ck_assert_double_le(worst_off(&curve, &data), TOLERANCE + 1e-6);
    ck_assert(!bspline_has_short_span(&curve, 0.02));
    bspline_free(&curve);
    reference_free(&data);
}
END_TEST

/* From the curve of nearly the same data it finds one of about as many poles. */
START_TEST(again_from_the_curve_before)
{
    struct reference data = uneven(0, true);
    struct free_knots_options o = options(0);
    struct bspline first = grown_knots_fit(&data, &o, NULL).curve;

    for (size_t k = 200; k < 210; k++) {
        data.point[k].z += TOLERANCE / 2;
        data.other[k].z += TOLERANCE / 2;
    }
    struct bspline again = grown_knots_fit(&data, &o, &first).curve;
    ck_assert_uint_gt(again.poles, 0);
    ck_assert_uint_le(again.poles, first.poles + 8);
    ck_assert_double_le(worst_off(&again, &data), TOLERANCE + 1e-6);
    bspline_free(&first);
    bspline_free(&again);
    reference_free(&data);
}
END_TEST

/* A knot of the curve stands at this part of its length, but for the printed digits. */
static bool has_knot(const struct bspline *curve, double part)
{
    for (size_t j = 4; j < curve->poles; j++)
        if (fabs(curve->knot[j] / curve->knot[curve->poles] - part) < 1e-6)
            return true;
    return false;
}

/* With three times the tolerance there would be knots to spare: they stay, but near to what has
 * moved. */
START_TEST(only_near_what_moved)
{
    struct reference data = uneven(0, true);
    struct free_knots_options o = options(0);
    struct bspline first = grown_knots_fit(&data, &o, NULL).curve;
    struct doubles moved = {0};
    size_t poles[3];

    o.tolerance *= 3;
    o.angle *= 3;
    for (int k = 0; k < 3; k++) { /* anywhere, nowhere, before the wave */
        moved.n = 0;
        if (k == 2) {
            *array_push(&moved) = 0;
            *array_push(&moved) = 0.3;
        }
        o.moved = k > 0 ? &moved : NULL;
        struct bspline again = grown_knots_fit(&data, &o, &first).curve;
        poles[k] = again.poles;
        for (size_t j = 4; j < first.poles; j++)
            if (k > 0 && first.knot[j] > 0.55 * first.knot[first.poles])
                ck_assert(has_knot(&again, first.knot[j] / first.knot[first.poles]));
        ck_assert_double_le(worst_off(&again, &data), o.tolerance + 1e-6);
        bspline_free(&again);
    }
    ck_assert_uint_eq(poles[1], first.poles);
    ck_assert_uint_lt(poles[0], poles[2]);
    ck_assert_uint_lt(poles[2], poles[1]);
    array_free(&moved);
    bspline_free(&first);
    reference_free(&data);
}
END_TEST

/* Steps of six tolerances after every second point, so that the points alone would take as many
 * poles: with places between them there is a curve, of fewer. */
START_TEST(places_between_points)
{
    struct run run = {.radius = 5};
    for (int k = 0; k < 120; k++) {
        struct vec3 tip = vec(SPACING * k, 0, k % 4 < 2 ? 0 : 6 * TOLERANCE);
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, 5, vec(0, 0, 1)), .axis = vec(0, 0, 1)};
    }
    struct reference data = reference_distinct(&run, false);
    struct free_knots_options o = options(0);
    struct bspline curve = grown_knots_fit(&data, &o, NULL).curve;
    ck_assert_uint_gt(curve.poles, 0);
    ck_assert_uint_lt(4 * curve.poles, 3 * data.n);
    ck_assert_double_le(worst_off(&curve, &data), TOLERANCE + 1e-6);
    bspline_free(&curve);
    array_free(&run);
    reference_free(&data);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("grown_knots");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, within_the_tolerance);
    tcase_add_test(t, knots_stand_in_the_wave);
    tcase_add_test(t, noise_is_followed);
    tcase_add_test(t, spans_are_long_enough_unless_the_tolerance_forbids_it);
    tcase_add_test(t, again_from_the_curve_before);
    tcase_add_test(t, only_near_what_moved);
    tcase_add_test(t, places_between_points);
    Suite *s = suite_create("grown_knots");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

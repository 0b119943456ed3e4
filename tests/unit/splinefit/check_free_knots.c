/*
 * free_knots: what is found keeps the tolerance by brute force and takes no more poles than are
 * known to do; curves that are hard come to an end and are never wrongly said to be within.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/free_knots.h"
#include "trial.h"

static void add(struct run *run, double x, double y, double z)
{
    struct run_point p = {.tip = vec(x, y, z), .axis = vec(0, 0, 1)};

    p.ball = vec_along(p.tip, run->radius, p.axis);
    *array_push(run) = p;
}

/* Distance both ways, from many places, by brute force. */
static double brute_force(const struct bspline *b, const struct track *t)
{
    enum { N = 4000 };
    static struct vec3 way[N + 1];
    double worst = 0;

    for (int i = 0; i <= N; i++)
        way[i] = bspline_at(b, b->pole, b->knot[b->poles] * i / N);
    for (int i = 0; i <= N; i += 3)
        worst = fmax(worst, trial_off_chain(way[i], t->point, t->n));
    for (size_t k = 0; k < t->n; k += 1 + t->n / 400)
        worst = fmax(worst, trial_off_chain(t->point[k], way, N + 1));
    return worst;
}

static const struct free_knots_options USUAL = {.degree = 3, .tolerance = 0.01, .angle = 0.02};

/* Poles of a run with the usual options (0: none found); checked by brute force. */
static size_t poles_of(struct run *run, const struct free_knots_options *options)
{
    struct track t = track_new(run, false);
    struct bspline curve;
    struct spline_bound proof;
    size_t poles = 0;
    bool cut;

    if (free_knots_search(&t, options, &curve, &proof, &cut)) {
        poles = curve.poles;
        ck_assert_int_eq(curve.degree, options->degree);
        ck_assert_double_le(proof.point, options->tolerance);
        ck_assert_double_le(brute_force(&curve, &t), proof.point + 1e-6);
        ck_assert(vec_distance(curve.pole[0], t.point[0]) < 1e-6);
        ck_assert(vec_distance(curve.pole[poles - 1], t.point[t.n - 1]) < 1e-6);
        for (size_t j = (size_t)options->degree + 1; j <= curve.poles; j++)
            ck_assert_double_gt(curve.knot[j], curve.knot[j - 1]);
    }
    bspline_free(&curve);
    track_free(&t);
    array_free(run);
    return poles;
}

/* A spline with 6 poles and uneven knots, by its own points: 6 serve at any tolerance, whatever the
 * parameters are. */
START_TEST(a_spline_is_found_again)
{
    double knot[] = {0, 0, 0, 0, 0.15, 0.7, 1, 1, 1, 1};
    struct vec3 pole[] = {{0, 0, 0},   {8, 12, 3},   {20, -9, 6},
                          {30, 15, 2}, {50, 10, -4}, {60, 0, 0}};
    struct bspline b = {.degree = 3, .poles = 6, .knot = knot, .pole = pole};
    struct run run = {.radius = 4};
    struct free_knots_options o = USUAL;

    for (int k = 0; k <= 600; k++) {
        struct vec3 p = bspline_at(&b, pole, (double)k * k / 360000);
        add(&run, p.x, p.y, p.z);
    }
    o.tolerance = 0.002;
    ck_assert_uint_le(poles_of(&run, &o), 6);
}
END_TEST

/* Half a circle of radius 20: a cubic Bezier curve of 4 poles is 0.37 mm off, two halves of 90
 * degrees 0.0055 mm, with 7 poles; a spline needs fewer. */
START_TEST(half_a_circle)
{
    for (int degree = 2; degree <= 5; degree++) {
        struct run run = {.radius = 4};
        struct free_knots_options o = USUAL;

        o.degree = degree;
        for (int k = 0; k <= 900; k++)
            add(&run, 20 * cos(PI * k / 900), 20 * sin(PI * k / 900), 0);
        size_t poles = poles_of(&run, &o);
        ck_assert_uint_gt(poles, (size_t)degree);
        ck_assert_uint_le(poles, degree == 2 ? 10 : 6);
    }
}
END_TEST

START_TEST(closed)
{
    struct run run = {.radius = 4};

    for (int k = 0; k <= 720; k++)
        add(&run, 20 * cos(PI * k / 360), 12 * sin(PI * k / 360), 0);
    size_t poles = poles_of(&run, &USUAL);
    ck_assert(poles > 5 && poles <= 11);
}
END_TEST

START_TEST(many_waves)
{
    struct run run = {.radius = 4};

    for (int k = 0; k <= 1600; k++)
        add(&run, k * 0.05, 2 * sin(k * 0.05), 0);
    size_t poles = poles_of(&run, &USUAL);
    ck_assert(poles > 30 && poles < 100);
}
END_TEST

/* A kink that is no corner: it takes knots that are close to each other, or nothing is found. */
START_TEST(a_kink)
{
    struct run run = {.radius = 4};

    for (int k = 0; k <= 200; k++)
        add(&run, k * 0.1, k > 100 ? (k - 100) * 0.05 : 0, 0);
    size_t poles = poles_of(&run, &USUAL);
    ck_assert(poles == 0 || (poles > 4 && poles < 30));
}
END_TEST

START_TEST(noise_above_the_tolerance)
{
    struct run run = {.radius = 4};
    unsigned long seed = 7;

    for (int k = 0; k <= 400; k++) {
        seed = (seed * 1103515245 + 12345) % 2147483648UL;
        add(&run, k * 0.2, (double)seed / 2147483648.0 * 0.1, 0);
    }
    size_t poles = poles_of(&run, &USUAL);
    ck_assert(poles == 0 || poles > 40);
}
END_TEST

START_TEST(hardly_any_points)
{
    struct run run = {.radius = 4};

    add(&run, 0, 0, 0);
    add(&run, 5, 5, 0);
    ck_assert_uint_le(poles_of(&run, &USUAL), 4);
    add(&run, 0, 0, 0);
    add(&run, 5, 5, 0);
    add(&run, 9, 5, 0);
    poles_of(&run, &USUAL);
}
END_TEST

/* A wave with a noise of up to half of `noise` mm, a hump of `hump` mm in its middle, and `lean` to
 * turn the axis by. */
static struct run noisy_wave(double noise, double hump, double lean)
{
    struct run run = {.radius = 4};
    unsigned long seed = 11;

    for (int k = 0; k <= 300; k++) {
        double x = 0.2 * k, a = lean * sin(x / 12), up = exp(-(x - 30) * (x - 30) / 25);
        seed = (seed * 1103515245 + 12345) % 2147483648UL;
        struct run_point p = {.axis = vec(sin(a), 0, cos(a))};
        p.ball = vec(x, 2 * sin(x / 5), noise * ((double)seed / 2147483648.0 - 0.5) + hump * up);
        p.tip = vec_along(p.ball, -run.radius, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

/* Data that moves by three tolerances in one place: so does the curve, with hardly more poles. */
START_TEST(a_curve_moves_with_its_data)
{
    for (int turns = 0; turns < 2; turns++) {
        struct run run = noisy_wave(0, 0, 0.2 * turns), moved = noisy_wave(0, 0.03, 0.2 * turns);
        struct track t = track_new(&run, true), u = track_new(&moved, true);
        struct bspline before, curve;
        struct spline_bound proof;
        bool cut;

        ck_assert(free_knots_search(&t, &USUAL, &before, &proof, &cut));
        ck_assert_double_gt(trial_brute_force(&before, &u, false), 0.02);
        ck_assert(free_knots_again(&u, &USUAL, &before, &curve, &proof));
        ck_assert_double_le(trial_brute_force(&curve, &u, false), 0.01);
        ck_assert_double_le(trial_brute_force(&curve, &u, true), 0.01);
        ck_assert_uint_ge(curve.poles, before.poles);
        ck_assert_uint_le(curve.poles, before.poles + before.poles / 16 + 2);
        bspline_free(&curve);
        struct bspline line = track_straight(&t); /* too far off, and not of this degree */
        ck_assert(!free_knots_again(&u, &USUAL, &line, &curve, &proof));
        bspline_free(&line);
        bspline_free(&before);
        track_free(&t);
        track_free(&u);
        array_free(&run);
        array_free(&moved);
    }
}
END_TEST

/* A pole for every few points of uneven data: from the count that is known to serve on down. */
START_TEST(uneven_data_takes_fewer_than_is_known)
{
    struct run run = noisy_wave(0.024, 0, 0.2);
    struct track t = track_new(&run, true);
    struct free_knots_options o = USUAL;
    struct bspline curve;
    struct spline_bound proof;
    bool cut;

    o.known = 200;
    ck_assert(free_knots_search(&t, &o, &curve, &proof, &cut));
    ck_assert_uint_lt(curve.poles, 190);
    ck_assert_uint_gt(curve.poles, 20);
    ck_assert_double_le(trial_brute_force(&curve, &t, false), 0.01);
    ck_assert_double_le(trial_brute_force(&curve, &t, true), 0.01);
    bspline_free(&curve);
    track_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("freeknots");
    TCase *tests = tcase_create("freeknots");

    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_spline_is_found_again);
    tcase_add_test(tests, half_a_circle);
    tcase_add_test(tests, closed);
    tcase_add_test(tests, many_waves);
    tcase_add_test(tests, a_kink);
    tcase_add_test(tests, noise_above_the_tolerance);
    tcase_add_test(tests, hardly_any_points);
    tcase_add_test(tests, a_curve_moves_with_its_data);
    tcase_add_test(tests, uneven_data_takes_fewer_than_is_known);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Tests of free_knots.h: knots to begin with, and searches for the fewest poles. */
#include "splinefit/free_knots.h"
#include "splinefit/knots_init.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/spline_lsq.h"
#include "seed.h"
#include "trial.h"

/* Straight at first, then waves. */
static struct reference wavy(void)
{
    struct run run = {0};

    for (int k = 0; k <= 800; k++) {
        double x = k * 0.1, w = x > 40 ? x - 40 : 0;
        struct run_point p = {.tip = vec(x, 0.002 * w * w * sin(w / 2), 0), .axis = vec(0, 0, 1)};
        p.ball = p.tip;
        *array_push(&run) = p;
    }
    struct reference track = reference_distinct(&run, false);
    struct reference target = reference_sample(&track, 400);
    reference_free(&track);
    array_free(&run);
    return target;
}

static void rises(const struct reference *t, const double *knot, int degree, size_t poles)
{
    size_t p = (size_t)degree;

    ck_assert(knot[p] == 0 && knot[poles] == t->length[t->n - 1] && knot[poles + p] == knot[poles]);
    for (size_t j = p + 1; j <= poles; j++)
        ck_assert_double_gt(knot[j], knot[j - 1]);
}

START_TEST(rising_from_end_to_end)
{
    struct reference t = wavy();
    double knot[64];

    for (int degree = 2; degree <= 5; degree++)
        for (size_t poles = (size_t)degree + 1; poles < 40; poles += 4) {
            knots_init_uniform(&t, degree, poles, knot);
            rises(&t, knot, degree, poles);
            ck_assert(knots_init_spread(&t, degree, poles, knot));
            rises(&t, knot, degree, poles);
            knots_init_mean(&t, degree, poles, knot);
            rises(&t, knot, degree, poles);
        }
    ck_assert(!knots_init_spread(&t, 3, t.n, knot));
    reference_free(&t);
}
END_TEST

START_TEST(denser_where_it_bends)
{
    struct reference t = wavy();
    double knot[64], half = t.length[t.n - 1] / 2;
    int late = 0;

    knots_init_spread(&t, 3, 24, knot);
    for (int j = 4; j < 24; j++)
        late += knot[j] > half;
    ck_assert_int_ge(late, 15);
    reference_free(&t);
}
END_TEST

START_TEST(a_knot_put_in_is_not_missed)
{
    struct bspline b = bspline_new(3, 6, false);
    double knot[] = {0, 0, 0, 0, 3, 7, 10, 10, 10, 10}, missed[3];

    for (size_t i = 0; i < 10; i++)
        b.knot[i] = knot[i];
    for (size_t i = 0; i < 6; i++)
        b.pole[i] = vec(2.0 * (double)i, i % 2 == 0 ? 3 : -2, 0);
    bspline_insert(&b, 5);
    knots_init_missed(&b, missed);
    ck_assert_double_lt(missed[1], 1e-9 * missed[0]); /* knots 5 and 4 */
    bspline_free(&b);
}
END_TEST

static void add(struct run *run, double x, double y, double z)
{
    struct run_point p = {.tip = vec(x, y, z), .axis = vec(0, 0, 1)};

    p.ball = vec_along(p.tip, run->radius, p.axis);
    *array_push(run) = p;
}

/* Distance both ways, from many places, by brute force. */
static double brute_force(const struct bspline *b, const struct reference *t)
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
    struct reference t = reference_distinct(run, false);
    struct free_knots_result found = free_knots_search(&t, options);
    struct bspline curve = found.curve;
    struct deviation proof = found.proof;
    size_t poles = 0;

    if (curve.poles > 0) {
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
    reference_free(&t);
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
    unsigned long seed = seed_begin(7);

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
    unsigned long seed = seed_begin(11);

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
        struct reference t = reference_distinct(&run, true), u = reference_distinct(&moved, true);
        struct bspline before = free_knots_search(&t, &USUAL).curve;

        ck_assert(before.poles > 0);
        ck_assert_double_gt(trial_brute_force(&before, &u, false), 0.02);
        struct bspline curve = free_knots_again(&u, &USUAL, &before).curve;
        ck_assert(curve.poles > 0);
        ck_assert_double_le(trial_brute_force(&curve, &u, false), 0.01);
        ck_assert_double_le(trial_brute_force(&curve, &u, true), 0.01);
        ck_assert_uint_ge(curve.poles, before.poles);
        ck_assert_uint_le(curve.poles, before.poles + before.poles / 16 + 2);
        bspline_free(&curve);
        struct bspline line = spline_straight(&t); /* too far off, and not of this degree */
        ck_assert(free_knots_again(&u, &USUAL, &line).curve.poles == 0);
        bspline_free(&line);
        bspline_free(&before);
        reference_free(&t);
        reference_free(&u);
        array_free(&run);
        array_free(&moved);
    }
}
END_TEST

/* Twelve waves of 2 mm, and four humps beside them. */
static struct run long_wave(double hump)
{
    struct run run = {.radius = 4};

    for (int k = 0; k <= 1200; k++) {
        double x = 0.2 * k, up = 0;
        for (int i = 0; i < 4; i++)
            up += exp(-(x - 30 - 60 * i) * (x - 30 - 60 * i) / 25);
        struct run_point p = {.axis = vec(0, 0, 1), .ball = vec(x, 2 * sin(x / 5), hump * up)};
        p.tip = vec_along(p.ball, -run.radius, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

/* Data that moves in four places: a sixteenth more knots, and two, may be had for it. */
START_TEST(a_curve_moves_in_several_places)
{
    struct run run = long_wave(0), moved = long_wave(0.036);
    struct reference t = reference_distinct(&run, true), u = reference_distinct(&moved, true);
    struct bspline before = free_knots_search(&t, &USUAL).curve;
    struct bspline curve = free_knots_again(&u, &USUAL, &before).curve;
    ck_assert_uint_gt(curve.poles, before.poles + 2);
    ck_assert_uint_le(curve.poles, before.poles + before.poles / 16 + 2);
    ck_assert_double_le(trial_brute_force(&curve, &u, false), 0.01);
    ck_assert_double_le(trial_brute_force(&curve, &u, true), 0.01);
    bspline_free(&curve);
    bspline_free(&before);
    reference_free(&t);
    reference_free(&u);
    array_free(&run);
    array_free(&moved);
}
END_TEST

/* How often the noise goes from above the tolerance to below it, or back. */
static size_t noise_changes(const struct reference *t)
{
    size_t changes = 0;
    double last = 0;

    for (size_t k = 0; k < t->n; k++) {
        double z = t->point[k].z;
        if (fabs(z) <= 0.01)
            continue;
        changes += last * z < 0;
        last = z;
    }
    return changes;
}

/*
 * A pole for every few points of uneven data: from the count that is known to serve on down.  Noise
 * of 0.006 mm leaves least squares of 120 poles, the first count tried, 0.6 of it and 0.0017 by
 * chance, so 0.01 is kept at once, and by far fewer.  Noise of 0.012 need not serve; where it does,
 * z has no more changes of sign than poles, as every spline, and at least those of what is beyond
 * the tolerance.
 */
START_TEST(uneven_data_takes_fewer_than_is_known)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        struct run run = noisy_wave(beyond ? 0.024 : 0.012, 0, 0.2);
        struct reference t = reference_distinct(&run, true);
        struct free_knots_options o = USUAL;

        o.known = 200;
        struct bspline curve = free_knots_search(&t, &o).curve;
        ck_assert(beyond || curve.poles > 0);
        if (curve.poles > 0) {
            ck_assert_uint_lt(curve.poles, beyond ? 200 : 120);
            ck_assert_uint_gt(curve.poles, noise_changes(&t));
            ck_assert_double_le(trial_brute_force(&curve, &t, false), 0.01);
            ck_assert_double_le(trial_brute_force(&curve, &t, true), 0.01);
        }
        bspline_free(&curve);
        reference_free(&t);
        array_free(&run);
    }
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("free_knots");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, rising_from_end_to_end);
    tcase_add_test(t, denser_where_it_bends);
    tcase_add_test(t, a_knot_put_in_is_not_missed);
    tcase_add_test(t, a_spline_is_found_again);
    tcase_add_test(t, half_a_circle);
    tcase_add_test(t, closed);
    tcase_add_test(t, many_waves);
    tcase_add_test(t, a_kink);
    tcase_add_test(t, noise_above_the_tolerance);
    tcase_add_test(t, hardly_any_points);
    tcase_add_test(t, a_curve_moves_with_its_data);
    tcase_add_test(t, a_curve_moves_in_several_places);
    tcase_add_test(t, uneven_data_takes_fewer_than_is_known);
    Suite *s = suite_create("free_knots");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

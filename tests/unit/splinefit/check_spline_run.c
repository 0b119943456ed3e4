/*
 * spline_run: where runs are parted, what sparse points become, and that pieces join.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/spline_run.h"

static const struct splinefit_options ALL = {
    .degree = 3, .params = -1, .knots = -1, .tolerance = 0.01, .angle = 0.02};

static void add(struct run *run, double x, double y, double z)
{
    struct run_point p = {.tip = vec(x, y, z), .axis = vec(0, 0, 1), .given = true};

    p.ball = vec_along(p.tip, run->radius, p.axis);
    *array_push(run) = p;
}

/* A right angle between two straight lines. */
START_TEST(a_corner_parts)
{
    struct run run = {.radius = 8};
    struct spline_run pieces = {0};

    for (int k = 0; k <= 20; k++)
        add(&run, k, 0, 0);
    for (int k = 1; k <= 20; k++)
        add(&run, 20, k, 0);
    spline_run_fit(&run, false, false, &ALL, &pieces);
    ck_assert_uint_eq(pieces.n, 2);
    ck_assert_uint_eq(pieces.item[0].to, 20);
    ck_assert_uint_eq(pieces.item[1].from, 20);
    ck_assert_uint_eq(pieces.item[1].to, 40);
    for (size_t i = 0; i < 2; i++) {
        const struct spline_run_piece *p = &pieces.item[i];
        ck_assert(p->fit.kind == SPLINEFIT_STRAIGHT && p->smooth == 0);
        ck_assert_uint_eq(p->fallback.n, 1);
        ck_assert(vec_distance(p->fallback.item[0].p, run.item[p->to].tip) == 0);
    }
    ck_assert(vec_distance(pieces.item[0].fit.curve.pole[1], pieces.item[1].fit.curve.pole[0]) ==
              0);
    spline_run_free(&pieces);
    spline_run_fit(&run, false, true, &ALL, &pieces); /* the paper knows no corners */
    ck_assert_uint_eq(pieces.n, 1);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

/* Steps of 0.01 mm to and fro, 2 micrometres across: 60 degrees in a point, straight at large. */
START_TEST(noise_is_no_corner)
{
    struct run run = {.radius = 8};
    struct spline_run pieces = {0};

    for (int k = 0; k <= 2000; k++)
        add(&run, 0.004 * k, k % 2 == 0 ? 0 : 0.003, 0);
    spline_run_fit(&run, false, false, &ALL, &pieces);
    ck_assert_uint_eq(pieces.n, 1);
    ck_assert(pieces.item[0].fit.kind == SPLINEFIT_STRAIGHT);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

/* Points every 15 degrees of a circle of 30 mm: the curve follows the circle, not the chords. */
START_TEST(sparse_points_make_a_smooth_curve)
{
    struct run run = {.radius = 8};
    struct spline_run pieces = {0};
    double worst = 0;

    for (int k = 0; k <= 18; k++)
        add(&run, 30 * cos(k * PI / 12), 30 * sin(k * PI / 12), 0);
    spline_run_fit(&run, false, false, &ALL, &pieces);
    ck_assert_uint_eq(pieces.n, 1);
    const struct spline_run_piece *p = &pieces.item[0];
    ck_assert(p->fit.within && p->smooth > 0);
    for (int i = 0; i <= 2000; i++) {
        double u = p->fit.curve.knot[p->fit.curve.poles] * i / 2000;
        struct vec3 at = bspline_at(&p->fit.curve, p->fit.curve.pole, u);
        worst = fmax(worst, fabs(hypot(at.x, at.y) - 30));
    }
    ck_assert_double_lt(worst, 0.012); /* the chords are 0.26 mm off */
    for (size_t i = 0; i < p->fallback.n; i++) {
        struct vec3 at = p->fallback.item[i].p;
        ck_assert_double_lt(fabs(hypot(at.x, at.y) - 30), 0.012);
    }
    ck_assert(vec_distance(p->fallback.item[p->fallback.n - 1].p, run.item[18].tip) == 0);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

/* Straight pieces over the fallback's points stay within the tolerance of the curve. */
START_TEST(fallback_keeps_the_tolerance)
{
    struct run run = {.radius = 8};
    struct spline_run pieces = {0};

    for (int k = 0; k <= 300; k++)
        add(&run, 0.2 * k, 6 * sin(0.03 * k), 3 * cos(0.02 * k));
    spline_run_fit(&run, true, false, &ALL, &pieces);
    const struct spline_run_piece *p = &pieces.item[0];
    ck_assert(p->fit.kind == SPLINEFIT_FREE && p->smooth == 0);
    ck_assert(vec_distance(p->fit.curve.pole[0], run.item[0].ball) < 1e-6);
    double worst = 0;
    for (int i = 0; i <= 3000; i++) {
        double u = p->fit.curve.knot[p->fit.curve.poles] * i / 3000, best = INFINITY;
        struct vec3 at = bspline_at(&p->fit.curve, p->fit.curve.pole, u), from = run.item[0].ball;
        for (size_t j = 0; j < p->fallback.n; j++) {
            struct vec3 d = vec_sub(p->fallback.item[j].p, from);
            double t = vec_dot(vec_sub(at, from), d) / vec_dot(d, d);
            best = fmin(best, vec_distance(at, vec_along(from, fmin(1, fmax(0, t)), d)));
            from = p->fallback.item[j].p;
        }
        worst = fmax(worst, best);
    }
    ck_assert_double_le(worst, 0.01);
    ck_assert_double_gt(worst, 0.001);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

START_TEST(one_place_has_no_curve)
{
    struct run run = {.radius = 8};
    struct spline_run pieces = {0};

    for (int k = 0; k < 4; k++)
        add(&run, 1, 2, 3);
    spline_run_fit(&run, false, false, &ALL, &pieces);
    ck_assert_uint_eq(pieces.n, 1);
    ck_assert(pieces.item[0].still);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

/* A straight line, a corner, a wave: when a point of the wave is lifted, the line stays as it was
 * and the wave's curve goes where the point is now. */
START_TEST(what_has_not_moved_stays)
{
    struct run run = {.radius = 8};
    struct spline_run pieces = {0};

    for (int k = 0; k <= 20; k++)
        add(&run, 0, k - 20, 0);
    for (int k = 1; k <= 200; k++)
        add(&run, 0.2 * k, 0, 3 * sin(0.04 * k));
    spline_run_fit(&run, true, false, &ALL, &pieces);
    ck_assert_uint_eq(pieces.n, 2);
    const struct vec3 *line = pieces.item[0].fit.curve.pole, *wave = pieces.item[1].fit.curve.pole;
    spline_run_refit(&run, true, false, &ALL, &pieces);
    ck_assert(pieces.item[0].fit.curve.pole == line && pieces.item[1].fit.curve.pole == wave);

    for (size_t k = 118; k <= 122; k++)
        run.item[k].ball.y += 0.03;
    spline_run_refit(&run, true, false, &ALL, &pieces);
    ck_assert_uint_eq(pieces.n, 2);
    ck_assert(pieces.item[0].fit.curve.pole == line);
    const struct spline_run_piece *p = &pieces.item[1];
    ck_assert(p->from == 20 && p->to == 220 && p->fit.within);
    ck_assert(vec_distance(p->fit.curve.pole[0], run.item[20].ball) < 1e-6);
    double nearest = INFINITY;
    for (int i = 0; i <= 5000; i++) {
        double u = p->fit.curve.knot[p->fit.curve.poles] * i / 5000;
        struct vec3 at = bspline_at(&p->fit.curve, p->fit.curve.pole, u);
        nearest = fmin(nearest, vec_distance(at, run.item[120].ball));
    }
    ck_assert_double_le(nearest, 0.0101);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("splinerun");
    TCase *tests = tcase_create("splinerun");

    tcase_add_test(tests, a_corner_parts);
    tcase_add_test(tests, noise_is_no_corner);
    tcase_add_test(tests, sparse_points_make_a_smooth_curve);
    tcase_add_test(tests, fallback_keeps_the_tolerance);
    tcase_add_test(tests, one_place_has_no_curve);
    tcase_add_test(tests, what_has_not_moved_stays);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

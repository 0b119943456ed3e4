/*
 * spline_guard: curves over a sphere and up a wall, measured against them by their own formulas.
 */
#include <check.h>
#include <stdlib.h>

#include "splinefit/spline_guard.h"

static const double BALL = 5, SPHERE = 30, STEEP = 70 * PI / 180;

static const struct spline_guard USUAL = {
    .rule = {.radius = 5, .tolerance = 0.01, .centre = true},
    .fit = {.degree = 3, .params = -1, .knots = -1, .tolerance = 0.01, .angle = 0.02}};

static void add(struct run *run, struct vec3 ball, struct vec3 normal)
{
    struct run_point p = {.ball = ball, .normal = normal, .axis = {0, 0, 1}, .given = true};

    p.contact = vec_along(ball, -BALL, normal);
    p.tip = vec_along(ball, -BALL, p.axis);
    *array_push(run) = p;
}

/* The deepest of the ball along all curves; how deep it is at a place, says `depth`. */
static double deepest(const struct spline_run *pieces, double (*depth)(struct vec3 ball))
{
    enum { PLACES = 4000 };
    double worst = -INFINITY;

    for (size_t k = 0; k < pieces->n; k++) {
        const struct bspline *b = &pieces->item[k].fit.curve;
        for (int i = 0; !pieces->item[k].still && i <= PLACES; i++)
            worst = fmax(worst, depth(bspline_at(b, b->pole, b->knot[b->poles] * i / PLACES)));
    }
    return worst;
}

static double in_sphere(struct vec3 ball)
{
    return SPHERE + BALL - vec_length(ball);
}

/* Over the top of a sphere, in the middle 0.03 mm too low: without a guard the curve is as deep,
 * with it no deeper than the tolerance; points between a gap of 0.1 mm hide nothing. */
START_TEST(points_too_low_are_lifted)
{
    struct vec3s points = {0};

    for (int i = -120; i <= 120; i++)
        for (int k = -20; k <= 20; k++) {
            double x = 0.1 * i, y = 0.1 * k;
            *array_push(&points) = vec(x, y, sqrt(SPHERE * SPHERE - x * x - y * y));
        }
    for (int guarded = 0; guarded < 2; guarded++) {
        struct spline_guard guard = USUAL;
        struct spline_run pieces = {0};
        struct run run = {.radius = BALL};
        for (int i = -40; i <= 40; i++) {
            double a = 0.3 * i / 40;
            struct vec3 n = vec(sin(a), 0, cos(a));
            add(&run, vec_scale(SPHERE + BALL - (abs(i) < 9 ? 0.03 : 0), n), n);
        }
        struct gouge_check *sphere = gouge_from_points(points.item, points.n);
        guard.rule.guard = guarded ? sphere : NULL;
        struct gouge_refit_result seen = spline_guard_fit(&guard, &run, &pieces);
        ck_assert(seen.deepest.depth == 0);
        ck_assert(guarded ? seen.lift > 0.02 && seen.lift < 0.06 : seen.lift == 0);
        double worst = deepest(&pieces, in_sphere);
        ck_assert(guarded ? worst < 0.0105 : worst > 0.02);
        ck_assert_uint_eq(pieces.n, 1);
        gouge_free(sphere);
        spline_run_free(&pieces);
        array_free(&run);
    }
    array_free(&points);
}
END_TEST

/* A floor, z = 0, and a wall that rises from it at the line x = 0. */
static double in_wall(struct vec3 ball)
{
    return BALL - fmin(ball.z, ball.z * cos(STEEP) - ball.x * sin(STEEP));
}

/* The ball comes along the floor and climbs the wall; the corner is taken in two turns, and a
 * smooth curve swings out of them into wall and floor.  The normals lie along both, so that lifts
 * only move points sideways: the straight lines are left. */
START_TEST(where_lifts_do_not_help_lines_do)
{
    struct vec3s points = {0};
    struct vec3 up = vec(cos(STEEP), 0, sin(STEEP)), along = vec(1, 0, 0), side = vec(0, 1, 0);
    struct vec3 corner = vec(-BALL * (1 - cos(STEEP)) / sin(STEEP), 0, BALL);
    struct run run = {.radius = BALL};
    struct spline_run pieces = {0};
    struct spline_guard guard = USUAL;

    for (int i = 0; i <= 150; i++)
        for (int k = -20; k <= 20; k++) {
            *array_push(&points) = vec(-0.1 * i, 0.1 * k, 0);
            *array_push(&points) = vec_along(vec(0, 0.1 * k, 0), 0.1 * i, up);
        }
    for (int i = 12; i > 0; i--)
        add(&run, vec_along(corner, -0.5 * i - 0.1, along), side);
    add(&run, vec_along(corner, -0.1, along), side);
    for (int i = 0; i <= 12; i++)
        add(&run, vec_along(corner, 0.5 * i + 0.1, up), side);

    struct gouge_check *wall = gouge_from_points(points.item, points.n);
    spline_guard_fit(&guard, &run, &pieces);
    ck_assert_double_gt(deepest(&pieces, in_wall), 0.03);
    guard.rule.guard = wall;
    struct gouge_refit_result seen = spline_guard_fit(&guard, &run, &pieces);
    ck_assert(seen.deepest.depth == 0);
    ck_assert_double_lt(deepest(&pieces, in_wall), 0.0105);
    ck_assert_uint_gt(pieces.n, 1);
    ck_assert(pieces.item[0].from == 0 && pieces.item[pieces.n - 1].to == run.n - 1);
    for (size_t k = 1; k < pieces.n; k++)
        ck_assert_uint_eq(pieces.item[k].from, pieces.item[k - 1].to);
    gouge_free(wall);
    spline_run_free(&pieces);
    array_free(&run);
    array_free(&points);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("splineguard");
    TCase *tests = tcase_create("splineguard");

    tcase_add_test(tests, points_too_low_are_lifted);
    tcase_add_test(tests, where_lifts_do_not_help_lines_do);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

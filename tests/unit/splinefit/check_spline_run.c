/* Tests of spline_run.h: pieces of a run, fitted again, and kept clear of the part. */
#include "splinefit/spline_run.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"

#define FIT                                                                      \
    {                                                                            \
        .degree = 3, .params = -1, .knots = -1, .tolerance = 0.01, .angle = 0.02 \
    }

static const struct spline_run_options TIP = {.fit = FIT}, CENTRE = {.centre = true, .fit = FIT},
                                       PAPER = {.paper = true, .fit = FIT};

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
    spline_run_fit(&run, &TIP, &pieces);
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
    spline_run_fit(&run, &PAPER, &pieces); /* the paper knows no corners */
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
    spline_run_fit(&run, &TIP, &pieces);
    ck_assert_uint_eq(pieces.n, 1);
    ck_assert(pieces.item[0].fit.kind == SPLINEFIT_STRAIGHT);
    spline_run_free(&pieces);
    array_free(&run);
}
END_TEST

/* In the middle of 100 mm of a wave 0.1 mm of a zigzag that no curve follows with spans of the
 * least length: that stays a few lines, before and behind it are curves.  And the same where the
 * zigzag comes only when points are moved. */
START_TEST(lines_only_where_no_curve_is)
{
    struct spline_run_options options = {.fit = FIT};
    struct run run = {.radius = 8}, smooth = {.radius = 8};

    options.fit.tolerance = 0.001;
    options.fit.least = 0.06;
    options.fit.work = 0.01;
    for (int k = 0; k <= 400; k++) {
        int last = k == 200 ? 10 : 0; /* points of the zigzag */
        for (int j = 0; j <= last; j++) {
            double x = 0.25 * k + 0.01 * j, z = 3 * sin(x / 8);
            add(&smooth, x, 0, z);
            add(&run, x, j % 2 == 1 ? 0.0025 : 0, z);
        }
    }
    for (int moved = 0; moved < 2; moved++) {
        struct spline_run pieces = {0};
        size_t lines = 0, at = 0;
        spline_run_fit(moved ? &smooth : &run, &options, &pieces);
        if (moved) {
            ck_assert_uint_eq(pieces.n, 1);
            spline_run_refit(&run, &options, &pieces);
        }
        ck_assert_uint_ge(pieces.n, 3);
        for (size_t i = 0; i < pieces.n; i++) {
            const struct spline_run_piece *p = &pieces.item[i];
            ck_assert_uint_eq(p->from, at);
            at = p->to;
            ck_assert(p->fit.within);
            lines += p->fit.kind == SPLINEFIT_POLYLINE ? p->to - p->from : 0;
        }
        ck_assert_uint_eq(at, run.n - 1);
        ck_assert_uint_le(lines, 16); /* those of the zigzag, and what halves are more */
        spline_run_free(&pieces);
    }
    array_free(&run);
    array_free(&smooth);
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
    spline_run_fit(&run, &TIP, &pieces);
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
    spline_run_fit(&run, &CENTRE, &pieces);
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
    spline_run_fit(&run, &TIP, &pieces);
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
    spline_run_fit(&run, &CENTRE, &pieces);
    ck_assert_uint_eq(pieces.n, 2);
    const struct vec3 *line = pieces.item[0].fit.curve.pole, *wave = pieces.item[1].fit.curve.pole;
    spline_run_refit(&run, &CENTRE, &pieces);
    ck_assert(pieces.item[0].fit.curve.pole == line && pieces.item[1].fit.curve.pole == wave);

    for (size_t k = 118; k <= 122; k++)
        run.item[k].ball.y += 0.03;
    spline_run_refit(&run, &CENTRE, &pieces);
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

static const double BALL = 5, SPHERE = 30, STEEP = 70 * PI / 180;

static const struct gouge_refit_options USUAL = {.radius = 5, .tolerance = 0.01, .centre = true};

static void add_contact(struct run *run, struct vec3 ball, struct vec3 normal)
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
        struct gouge_refit_options gouge = USUAL;
        struct spline_run pieces = {0};
        struct run run = {.radius = BALL};
        for (int i = -40; i <= 40; i++) {
            double a = 0.3 * i / 40;
            struct vec3 n = vec(sin(a), 0, cos(a));
            add_contact(&run, vec_scale(SPHERE + BALL - (abs(i) < 9 ? 0.03 : 0), n), n);
        }
        struct gouge_check *sphere = gouge_from_points(points.item, points.n);
        gouge.guard = guarded ? sphere : NULL;
        struct gouge_refit_result seen = spline_run_fit_guarded(&run, &CENTRE, &gouge, &pieces);
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

/* The ball comes along the floor and climbs the wall; the corner is taken in two turns, beside a
 * chord that is shorter than the others.  A curve that swung out of them would be in wall and
 * floor: it keeps to the chords, with a guard and without, and needs no lines.  (The normals lie
 * along floor and wall, so that lifts would only move points sideways.) */
START_TEST(inner_corner_keeps_to_the_chords)
{
    const double scale = _i ? 0.55 : 1;
    struct vec3s points = {0};
    struct vec3 up = vec(cos(STEEP), 0, sin(STEEP)), along = vec(1, 0, 0), side = vec(0, 1, 0);
    struct vec3 corner = vec(-BALL * (1 - cos(STEEP)) / sin(STEEP), 0, BALL);
    struct run run = {.radius = BALL};
    struct spline_run pieces = {0};
    struct gouge_refit_options gouge = USUAL;

    for (int i = 0; i <= 150; i++)
        for (int k = -20; k <= 20; k++) {
            *array_push(&points) = vec(-0.1 * i, 0.1 * k, 0);
            *array_push(&points) = vec_along(vec(0, 0.1 * k, 0), 0.1 * i, up);
        }
    for (int i = 12; i > 0; i--)
        add_contact(&run, vec_along(corner, scale * (-0.5 * i - 0.1), along), side);
    add_contact(&run, vec_along(corner, -0.1 * scale, along), side);
    for (int i = 0; i <= 12; i++)
        add_contact(&run, vec_along(corner, scale * (0.5 * i + 0.1), up), side);

    struct gouge_check *wall = gouge_from_points(points.item, points.n);
    spline_run_fit_guarded(&run, &CENTRE, &gouge, &pieces);
    ck_assert_double_lt(deepest(&pieces, in_wall), 0.0105);
    gouge.guard = wall;
    struct gouge_refit_result seen = spline_run_fit_guarded(&run, &CENTRE, &gouge, &pieces);
    ck_assert(seen.deepest.depth == 0);
    ck_assert_double_lt(deepest(&pieces, in_wall), 0.0105);
    ck_assert_uint_eq(pieces.n, 1);
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
    TCase *t = tcase_create("spline_run");
    tcase_add_test(t, a_corner_parts);
    tcase_add_test(t, noise_is_no_corner);
    tcase_add_test(t, lines_only_where_no_curve_is);
    tcase_add_test(t, sparse_points_make_a_smooth_curve);
    tcase_add_test(t, fallback_keeps_the_tolerance);
    tcase_add_test(t, one_place_has_no_curve);
    tcase_add_test(t, what_has_not_moved_stays);
    tcase_add_test(t, points_too_low_are_lifted);
    tcase_add_loop_test(t, inner_corner_keeps_to_the_chords, 0, 2);
    Suite *s = suite_create("spline_run");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

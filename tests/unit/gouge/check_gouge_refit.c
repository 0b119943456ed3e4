/* gouge_refit: a chord across the hump of a sphere and an arc below it are found, as deep as they
 * are, and lifted; what stays outside is not. */
#include "gouge/gouge_refit.h"

#include <check.h>
#include <stdlib.h>

static const double SPHERE = 30, BALL = 5;

/* The top of a sphere about the origin, points 0.1 mm apart. */
static struct gouge_check *make_sphere(void)
{
    struct vec3s points = {0};
    for (int i = -120; i <= 120; i++)
        for (int k = -40; k <= 40; k++) {
            double x = 0.1 * i, y = 0.1 * k;
            *array_push(&points) = vec(x, y, sqrt(SPHERE * SPHERE - x * x - y * y));
        }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

static struct run_point on_arc(double angle, double radius)
{
    struct vec3 n = vec(sin(angle), 0, cos(angle));
    struct run_point p = {.axis = {0, 0, 1}, .normal = n, .contact = vec_scale(SPHERE, n)};
    p.ball = vec_scale(radius, n);
    p.tip = vec_along(p.ball, -BALL, p.axis);
    p.given = true;
    return p;
}

static struct pose centre_of(const struct run_point *p)
{
    return (struct pose){p->ball, p->axis};
}

static struct pose tip_of(const struct run_point *p)
{
    return (struct pose){p->tip, p->axis};
}

static void check_motion(const struct gouge_refit_options *rule, const struct motion *motion,
                         struct gouges *gouges)
{
    struct gouge_track track = {0};
    gouge_refit_motion(rule, motion, &track, gouges);
    gouge_track_free(&track);
}

START_TEST(a_chord_is_as_deep_as_its_sagitta)
{
    struct gouge_check *guard = make_sphere();
    struct run_point a = on_arc(-0.1, SPHERE + BALL), b = on_arc(0.1, SPHERE + BALL);
    double sagitta = (SPHERE + BALL) * (1 - cos(0.1));
    for (int centre = 0; centre < 2; centre++) {
        struct gouge_refit_options rule = {
            .guard = guard, .radius = BALL, .tolerance = 0.01, .centre = centre};
        struct motion line = centre ? motion_line(centre_of(&a), centre_of(&b))
                                    : motion_line(tip_of(&a), tip_of(&b));
        struct gouges deeps = {0};
        check_motion(&rule, &line, &deeps);
        struct gouge deepest = gouge_refit_deepest(&deeps);
        ck_assert_double_eq_tol(deepest.depth, sagitta, 0.001);
        ck_assert_double_le(fabs(deepest.ball.x), 1);
        array_free(&deeps);
        rule.tolerance = sagitta / GOUGE_SAFE + 0.001;
        check_motion(&rule, &line, &deeps);
        ck_assert_uint_eq(deeps.n, 0);
        ck_assert(gouge_refit_deepest(&deeps).depth == 0);
    }
    gouge_free(guard);
}
END_TEST

/* Motions asked again, in another order too, and others between: what gouge_refit_motion finds. */
START_TEST(what_was_found_is_not_looked_for_again)
{
    struct gouge_check *guard = make_sphere();
    struct gouge_refit_options rule = {.guard = guard, .radius = BALL, .tolerance = 0.01};
    struct gouge_memo memo = {0};
    size_t deep = 0;

    for (int i = 0; i < 120; i++) {
        int round = i / 40, k = round == 1 ? 39 - i % 40 : i % 40;
        double from = -0.3 + 0.014 * k, off = k % 7 == round ? 0.01 : 0;
        struct run_point a = on_arc(from, SPHERE + BALL + off),
                         b = on_arc(from + 0.06, SPHERE + BALL);
        struct motion line = motion_line(tip_of(&a), tip_of(&b));
        struct gouges once = {0}, anew = {0};
        gouge_refit_once(&rule, &line, &memo, &once);
        check_motion(&rule, &line, &anew);
        ck_assert_uint_eq(once.n, anew.n);
        for (size_t j = 0; j < once.n; j++) {
            ck_assert_double_eq(once.item[j].depth, anew.item[j].depth);
            ck_assert(vec_compare(&once.item[j].ball, &anew.item[j].ball) == 0);
        }
        deep += once.n;
        array_free(&once);
        array_free(&anew);
    }
    ck_assert_uint_gt(deep, 40);
    ck_assert_uint_lt(memo.seen.n, 120); /* the others were found again */
    gouge_memo_free(&memo);
    gouge_free(guard);
}
END_TEST

/* A wall at x = 0 that reaches from z = 0 up to 40, points 0.25 mm apart. */
static struct gouge_check *make_wall(void)
{
    struct vec3s points = {0};
    for (int i = -80; i <= 80; i++)
        for (int k = 0; k <= 160; k++)
            *array_push(&points) = vec(0, 0.25 * i, 0.25 * k);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

/* A tool that stands upright, with a holder that begins 10 mm above its centre. */
static struct gouge_refit_options tool_at_wall(const struct gouge_check *guard, bool centre)
{
    return (struct gouge_refit_options){.guard = guard,
                                        .radius = BALL,
                                        .tolerance = 0.01,
                                        .centre = centre,
                                        .holder = {2, {{BALL, BALL, 20}, {12, 12, 30}}}};
}

/* The tool leans towards the wall and away again while its ball passes: how deep its shaft is in
 * the middle. */
START_TEST(a_shaft_that_leans_into_a_wall_is_found)
{
    struct gouge_check *guard = make_wall();
    for (int centre = 0; centre < 2; centre++) {
        struct gouge_refit_options rule = tool_at_wall(guard, centre);
        for (int k = 0; k < 2; k++) {
            /* upright past the wall, and leaned: the place of the wall that is as far from the
             * flank as from the upper end is the deepest */
            double lean = k * RADIANS(10), x = BALL + 0.5, top = 20;
            double high = (top - BALL + x / cos(lean)) / (1 + tan(lean)), deep = top - high;
            struct vec3 axis = vec(-sin(lean), 0, cos(lean)), from = vec(x, -15, 5),
                        to = vec(x, 15, 5);
            double up = centre ? 0 : BALL;
            struct motion line = motion_line((struct pose){vec_along(from, -up, axis), axis},
                                             (struct pose){vec_along(to, -up, axis), axis});
            struct gouges deeps = {0};
            rule.holder.n = 1;
            check_motion(&rule, &line, &deeps);
            struct gouge deepest = gouge_refit_deepest(&deeps);
            if (k == 0)
                ck_assert_uint_eq(deeps.n, 0);
            else
                ck_assert_double_eq_tol(deepest.depth, deep, 0.1 * deep);
            ck_assert(k == 0 || deepest.part == TOOL_SHAFT);
            array_free(&deeps);
        }
    }
    gouge_free(guard);
}
END_TEST

/* Asked only whether there is a place too deep: one if there are any, of shaft and ball, whatever
 * the ways, clear of the wall, along it, or through. */
START_TEST(one_place_is_enough)
{
    struct gouge_check *guard = make_wall();
    struct gouge_refit_options all = tool_at_wall(guard, true), any = all;
    size_t deep = 0, clear = 0;

    all.holder.n = any.holder.n = 1;
    any.any = true;
    for (int k = 0; k < 120; k++) {
        double lean = RADIANS(0.25 * (k % 20)), aside = BALL + 0.05 * (k % 13) - 0.1;
        struct vec3 axis = vec(-sin(lean), 0, cos(lean)), end = vec(sin(lean), 0.1, cos(lean));
        struct motion line =
            motion_line((struct pose){vec(aside, -2, 5), axis},
                        (struct pose){vec(aside + 0.2 * (k % 5), 2, 5 + k % 9), vec_unit(end)});
        struct gouges every = {0}, one = {0};
        check_motion(&all, &line, &every);
        check_motion(&any, &line, &one);
        ck_assert_uint_eq(one.n, every.n > 0);
        deep += every.n > 1;
        clear += every.n == 0;
        array_free(&every);
        array_free(&one);
    }
    ck_assert_uint_gt(deep, 20);
    ck_assert_uint_gt(clear, 10);
    gouge_free(guard);
}
END_TEST

/* The axis swings over the wall's upright edge between two poses that are both clear. */
START_TEST(a_holder_that_swings_through_is_found_between_its_ends)
{
    struct gouge_check *guard = make_wall();
    struct gouge_refit_options rule = tool_at_wall(guard, true);
    struct vec3 c = vec(16, 0, 5);
    struct pose a = {c, vec_unit(vec(-0.2, -2, 1))}, b = {c, vec_unit(vec(-0.2, 2, 1))};
    struct motion turn = motion_line(a, b);
    struct gouges deeps = {0};
    double deepest = 0;
    for (int i = 0; i <= 4000; i++) { /* by many poses */
        struct pose p = motion_at(&turn, i / 4000.0);
        deepest = fmax(deepest, -gouge_holder(guard, &rule.holder, p.p, p.a, 100));
    }
    check_motion(&rule, &turn, &deeps);
    struct gouge found = gouge_refit_deepest(&deeps);
    ck_assert_double_eq_tol(found.depth, deepest, 0.1 * deepest + 0.01);
    ck_assert_int_eq(found.part, TOOL_HOLDER);
    ck_assert_double_gt(gouge_holder(guard, &rule.holder, a.p, a.a, 1), 0);
    ck_assert_double_gt(deepest, 0.1);
    array_free(&deeps);
    gouge_free(guard);
}
END_TEST

START_TEST(an_arc_is_followed_round)
{
    struct gouge_check *guard = make_sphere();
    struct gouge_refit_options rule = {
        .guard = guard, .radius = BALL, .tolerance = 0.01, .centre = true};
    for (int k = -1; k <= 1; k++) {
        double off = 0.03 * k, radius = SPHERE + BALL + off;
        struct run_point a = on_arc(-0.3, radius), b = on_arc(0.3, radius);
        struct motion arc = motion_arc(centre_of(&a), centre_of(&b), vec(0, 0, 0), vec(0, 1, 0));
        struct gouges deeps = {0};
        check_motion(&rule, &arc, &deeps);
        ck_assert_double_eq_tol(gouge_refit_deepest(&deeps).depth, k < 0 ? 0.03 : 0, 0.001);
        ck_assert(k < 0 ? deeps.n >= 18 : deeps.n == 0); /* all along its 21 mm */
        array_free(&deeps);
    }
    gouge_free(guard);
}
END_TEST

/* Points a millimetre apart in the part: lifted, all but the ends are out of it by half the
 * tolerance and more, and no more than it takes. */
START_TEST(points_are_lifted_out)
{
    struct gouge_check *guard = make_sphere();
    struct gouge_refit_options rule = {.guard = guard, .radius = BALL, .tolerance = 0.01};
    struct run run = {.radius = BALL};
    struct gouges deeps = {0};
    for (int i = -10; i <= 10; i++)
        *array_push(&run) = on_arc(i / 35.0, SPHERE + BALL - (abs(i) < 4 ? 0.04 : 0));
    for (size_t i = 1; i < run.n; i++) {
        struct motion line = motion_line(tip_of(&run.item[i - 1]), tip_of(&run.item[i]));
        check_motion(&rule, &line, &deeps);
    }
    struct run_point first = run.item[0], last = run.item[run.n - 1];
    double highest = gouge_refit_lift(&rule, &deeps, &run);
    ck_assert_double_ge(highest, 0.035);
    ck_assert_double_le(highest, 0.04);
    for (size_t i = 0; i < run.n; i++) {
        double out = vec_length(run.item[i].ball) - SPHERE - BALL;
        ck_assert_double_ge(out, -0.0051);
        ck_assert_double_le(out, 0.04);
        ck_assert_double_lt(
            vec_distance(vec_along(run.item[i].tip, BALL, run.item[i].axis), run.item[i].ball),
            1e-12);
    }
    ck_assert(vec_distance(first.ball, run.item[0].ball) == 0);
    ck_assert(vec_distance(last.ball, run.item[run.n - 1].ball) == 0);
    array_free(&run);
    array_free(&deeps);
    gouge_free(guard);
}
END_TEST

/* A ball deep beside a line that is clear: the path goes straight there.  Not where the line is as
 * deep, nor for what a fit near the line explains, nor twice. */
START_TEST(where_the_line_is_clear_it_goes_straight)
{
    struct gouge_check *guard = make_sphere();
    struct gouge_refit_options rule = {.guard = guard, .radius = BALL, .tolerance = 0.01};
    struct run run = {.radius = BALL};
    const double at[] = {-0.12, -0.02, -0.01, 0, 0.01, 0.02}; /* the first chord is 0.04 deep */
    for (int i = 0; i < 6; i++)
        *array_push(&run) = on_arc(at[i], SPHERE + BALL);
    struct gouge deep[] = {{on_arc(-0.07, SPHERE + BALL - 0.05).ball, 0.05, TOOL_BALL},
                           {on_arc(-0.015, SPHERE + BALL - 0.05).ball, 0.05, TOOL_BALL},
                           {on_arc(-0.014, SPHERE + BALL - 0.03).ball, 0.03, TOOL_BALL},
                           {on_arc(0.005, SPHERE + BALL - 0.01).ball, 0.011, TOOL_BALL},
                           {on_arc(0.015, SPHERE + BALL - 0.05).ball, 0.05, TOOL_SHAFT}};
    for (int again = 0; again < 2; again++) {
        struct gouges gouges = {0};
        for (int k = 0; k < 5; k++)
            *array_push(&gouges) = deep[k];
        ck_assert(gouge_refit_straighten(&rule, &gouges, &run) == !again);
        ck_assert_uint_eq(gouges.n, again ? 5 : 3);
        ck_assert(gouges.item[0].ball.x == deep[0].ball.x);
        ck_assert_int_eq(gouges.item[gouges.n - 1].part, TOOL_SHAFT);
        for (size_t i = 0; i < run.n; i++)
            ck_assert_int_eq(run.item[i].straight, i == 1);
        array_free(&gouges);
    }
    array_free(&run);
    gouge_free(guard);
}
END_TEST

/* The smooth curve through the points. */
static void check_smooth(void *context, const struct run *run, struct gouges *gouges)
{
    struct run dense = {.radius = BALL};
    run_densify(run, 1e-4, &dense);
    for (size_t i = 1; i < dense.n; i++) {
        struct motion line = motion_line(tip_of(&dense.item[i - 1]), tip_of(&dense.item[i]));
        check_motion(context, &line, gouges);
    }
    array_free(&dense);
}

/* Down a flank of 40 degrees and level on, 2 mm over a plane: the curve swings below it behind the
 * kink, the lines do not.  No point is lifted for that. */
START_TEST(a_curve_that_swings_lifts_nothing)
{
    struct vec3s points = {0};
    for (int i = -100; i <= 100; i++)
        for (int k = -60; k <= 60; k++)
            *array_push(&points) = vec(0.1 * i, 0.1 * k, 0);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct gouge_refit_options rule = {.guard = guard, .radius = BALL, .tolerance = 0.01};
    struct run run = {.radius = BALL};
    for (int i = 0; i < 12; i++) {
        double x = i < 10 ? 0.1 * (i - 9) : 2 * (i - 9);
        struct run_point p = {
            .tip = {x, 0, x < 0 ? -x * tan(RADIANS(40)) : 0}, .axis = {0, 0, 1}, .given = true};
        p.ball = vec_along(p.tip, BALL, p.axis);
        *array_push(&run) = p;
    }
    struct gouges before = {0};
    check_smooth(&rule, &run, &before);
    ck_assert_double_gt(gouge_refit_deepest(&before).depth, 0.1);
    struct gouge_refit_result result = gouge_refit_fit(&rule, &run, check_smooth, &rule);
    ck_assert_double_eq(result.deepest.depth, 0);
    ck_assert_double_le(result.lift, rule.tolerance);
    array_free(&before);
    array_free(&run);
    array_free(&points);
    gouge_free(guard);
}
END_TEST

START_TEST(without_a_guard_nothing_is_deep)
{
    struct gouge_refit_options rule = {.radius = BALL, .tolerance = 0.01};
    struct run_point a = on_arc(-0.1, 1), b = on_arc(0.1, 1);
    struct motion line = motion_line(tip_of(&a), tip_of(&b));
    struct gouges deeps = {0};
    check_motion(&rule, &line, &deeps);
    ck_assert_uint_eq(deeps.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gouge_refit");
    TCase *tcase = tcase_create("gouge_refit");
    tcase_add_test(tcase, a_chord_is_as_deep_as_its_sagitta);
    tcase_add_test(tcase, what_was_found_is_not_looked_for_again);
    tcase_add_test(tcase, a_shaft_that_leans_into_a_wall_is_found);
    tcase_add_test(tcase, one_place_is_enough);
    tcase_add_test(tcase, a_holder_that_swings_through_is_found_between_its_ends);
    tcase_add_test(tcase, an_arc_is_followed_round);
    tcase_add_test(tcase, points_are_lifted_out);
    tcase_add_test(tcase, where_the_line_is_clear_it_goes_straight);
    tcase_add_test(tcase, a_curve_that_swings_lifts_nothing);
    tcase_add_test(tcase, without_a_guard_nothing_is_deep);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

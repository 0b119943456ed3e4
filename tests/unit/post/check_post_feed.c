/*
 * post_feed: the time of a block against the fastest of its axes, measured in a thousand small
 * steps, on machines of every kind; digits of F.  post_ik: travel of the slides with the tip far
 * off.
 */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "post/post_feed.h"

enum { STEPS = 1000 };

/* A table or head of one of the kinds, its axes slow and fast. */
static struct machine any_machine(int kind)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    m.chain = chain_of(kind);
    m.letter[0] = MACHINE_C;
    m.letter[1] = MACHINE_A;
    m.rapid[MACHINE_A] = 1000 + 9000 * chance();
    m.rapid[MACHINE_C] = 1000 + 9000 * chance();
    m.rapid[MACHINE_X] = m.rapid[MACHINE_Y] = m.rapid[MACHINE_Z] = 2000 + 30000 * chance();
    return m;
}

static struct block_pose any_end(const struct kinematic_chain *chain, double far)
{
    struct block_pose s = {.p = vec_scale(far * chance(), random_unit()),
                           .q = {4 * chance() - 2, 2 * chance() - 1}};
    s.a = chain_axis(chain, s.q);
    return s;
}

/* The least time at which no axis is too fast in any of many steps, all of them as long. */
static double by_steps(const struct machine *m, const struct block_pose *a,
                       const struct block_pose *b)
{
    struct vec3 last = chain_linear(&m->chain, a->p, a->q);
    double minutes = 0;
    for (int i = 1; i <= STEPS; i++) {
        double s = (double)i / STEPS;
        const double q[2] = {a->q[0] + s * (b->q[0] - a->q[0]), a->q[1] + s * (b->q[1] - a->q[1])};
        struct vec3 linear = chain_linear(&m->chain, vec_mix(a->p, b->p, s), q);
        struct vec3 way = vec_sub(linear, last);
        double slide = fmax(fabs(way.x), fmax(fabs(way.y), fabs(way.z)));
        minutes = fmax(minutes, STEPS * slide / m->rapid[MACHINE_X]);
        last = linear;
    }
    minutes = fmax(minutes, DEGREES(fabs(b->q[0] - a->q[0])) / m->rapid[MACHINE_C]);
    return fmax(minutes, DEGREES(fabs(b->q[1] - a->q[1])) / m->rapid[MACHINE_A]);
}

START_TEST(as_by_small_steps)
{
    int slides = 0;
    seed = 300 + (uint64_t)_i;
    for (int i = 0; i < 300; i++) {
        struct machine m = any_machine(_i);
        struct nc_planner planner = {.machine = &m,
                                     .options = {.unit = 1},
                                     .follow = {.mode = INTERPOLATE_ROTARY, .chain = &m.chain}};
        planner.state.at = any_end(&m.chain, 900);
        struct machine_pose to = {.at = any_end(&m.chain, 900)};
        if (i % 3 == 0) /* close by, or where it is */
            to.at.p = vec_along(planner.state.at.p, i % 2 ? 1 : 0, random_unit());
        to.turned = chain_turned(&m.chain, to.at.q);
        double length = vec_distance(planner.state.at.p, to.at.p), least = 0.1 * chance();
        double want = by_steps(&m, &planner.state.at, &to.at),
               rotary = post_feed_axes_minutes(&planner, &planner.state.at, &to.at);
        double got = post_feed_minutes(&planner, &to, length, NULL, least);
        ck_assert_double_ge(got, 0.97 * fmax(want, least));
        ck_assert_double_le(got, 1.022 * fmax(want, least));
        slides += want > 1.01 * rotary && want > least;
    }
    ck_assert_int_gt(slides, 30);
}
END_TEST

/* A straight cubic of 10 mm a span whose tool leans by `lean` degrees more from its middle on. */
static struct bspline leaning(double lean)
{
    struct bspline b = bspline_new(3, 15, true);
    b.length = 100;
    for (size_t i = 0; i < b.poles + 4; i++)
        b.knot[i] = fmin(fmax((double)i - 3, 0), 12);
    for (size_t i = 0; i < b.poles; i++) {
        double angle = RADIANS(i < 8 ? 30 : 30 + lean);
        b.pole[i] = vec(10 * (b.knot[i + 1] + b.knot[i + 2] + b.knot[i + 3]) / 3, 0, 0);
        b.head[i] = vec_add(b.pole[i], vec(100 * sin(angle), 0, 100 * cos(angle)));
    }
    return b;
}

/* Parted beside what is slow, at a part of a span, and there alone. */
START_TEST(slow_part_of_a_curve)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    m.rapid[MACHINE_A] = m.rapid[MACHINE_C] = 1000;
    struct nc_planner planner = {.machine = &m,
                                 .options = {.unit = 1},
                                 .follow = {.mode = INTERPOLATE_ROTARY, .chain = &m.chain}};
    planner.state.feed = 1000;
    planner.state.faster = 1;
    struct bspline slow = leaning(60), even = leaning(0), tame = leaning(1);
    const struct bspline *curve[] = {&slow, &even, &tame};
    for (int i = 0; i < 3; i++) {
        struct pose from = {curve[i]->pole[0],
                            vec_unit(vec_sub(curve[i]->head[0], curve[i]->pole[0]))};
        struct motion motion = motion_spline(from, from, curve[i]);
        int over;
        ck_assert_int_eq(
            ik_choose(&m.chain, from.a, (double[]){0, 0}, false, -1, planner.state.at.q, &over), 0);
        double s = post_feed_divide(&planner, &motion);
        ck_assert_double_eq_tol(288 * s, round(288 * s), 1e-9);
        if (i > 0)
            ck_assert_double_eq(s, 1);
        else
            ck_assert(12 * s > 4 && 12 * s < 8.5);
    }
    bspline_free(&slow);
    bspline_free(&even);
    bspline_free(&tame);
}
END_TEST

/* One span whose axis passes the singular direction by 0.1 degrees at 0.3 of it: what the axes take
 * there slows less than a tenth of the curve. */
START_TEST(beside_the_singular_direction)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    struct nc_planner planner = {.machine = &m,
                                 .options = {.unit = 1},
                                 .follow = {.mode = INTERPOLATE_VECTOR, .chain = &m.chain}};
    planner.state.feed = 1000;
    planner.state.faster = 1;
    struct bspline b = bspline_new(3, 4, true);
    b.length = 100;
    for (size_t i = 0; i < 4; i++) {
        double s = (double)i / 3;
        b.knot[i] = 0, b.knot[i + 4] = 1;
        b.pole[i] = vec(3 * s, 0, 0);
        b.head[i] = vec_add(b.pole[i], vec(30 * (s - 0.3), 0.2, 100));
    }
    struct pose from = {b.pole[0], vec_unit(vec_sub(b.head[0], b.pole[0]))};
    struct pose to = {b.pole[3], vec_unit(vec_sub(b.head[3], b.pole[3]))};
    struct motion motion = motion_spline(from, to, &b);
    int over;
    ck_assert_int_eq(
        ik_choose(&m.chain, from.a, (double[]){0, 0}, false, -1, planner.state.at.q, &over), 0);
    double s = post_feed_divide(&planner, &motion);
    ck_assert_double_gt(s, 0.2);
    ck_assert_double_lt(s, 0.5);
    bspline_free(&b);
}
END_TEST

/* Curves of 60 mm in 20 spans that pass the singular direction anywhere, by at most 0.005 degrees:
 * where the whole curve would be slow by it, it is parted. */
START_TEST(a_peak_that_slows_all_is_parted)
{
    enum { SPANS = 20, POLES = SPANS + 3 };
    struct machine m = machine_default();
    struct error error;
    int slow = 0;

    ck_assert_int_eq(machine_finish(&m, &error), 0);
    for (int trial = 0; trial < 2000; trial++) {
        struct nc_planner planner = {.machine = &m,
                                     .options = {.unit = 1},
                                     .follow = {.mode = INTERPOLATE_VECTOR, .chain = &m.chain}};
        struct bspline b = bspline_new(3, POLES, true);
        double pole = chance(), beside = 0.009 * chance();
        int over;
        b.length = 100;
        for (size_t i = 0; i < POLES + 4; i++)
            b.knot[i] = fmin(fmax((double)i - 3, 0), SPANS);
        for (size_t i = 0; i < POLES; i++) {
            double s = (b.knot[i + 1] + b.knot[i + 2] + b.knot[i + 3]) / (3 * SPANS);
            b.pole[i] = vec(60 * s, 0, 0);
            b.head[i] = vec_add(b.pole[i], vec(100 * (s - pole), beside, 100));
        }
        struct pose from = {b.pole[0], vec_unit(vec_sub(b.head[0], b.pole[0]))};
        struct pose to = {b.pole[POLES - 1],
                          vec_unit(vec_sub(b.head[POLES - 1], b.pole[POLES - 1]))};
        struct motion motion = motion_spline(from, to, &b);
        struct machine_pose end = {.at = {.p = to.p, .a = to.a}};
        const struct nc_along along = {&motion, 0, 1, NULL, 0};
        double *q = planner.state.at.q, wished = 60 / 1000.0;
        planner.state.feed = 1000;
        planner.state.faster = 1;
        planner.state.at = (struct block_pose){.p = from.p, .a = from.a};
        ck_assert_int_eq(ik_choose(&m.chain, from.a, (double[]){0, 0}, false, -1, q, &over), 0);
        ck_assert_int_eq(ik_choose(&m.chain, to.a, q, false, -1, end.at.q, &over), 0);
        if (post_feed_minutes(&planner, &end, 60, &along, wished) > 2 * wished) {
            slow++;
            ck_assert_double_lt(post_feed_divide(&planner, &motion), 1);
        }
        bspline_free(&b);
    }
    ck_assert_int_gt(slow, 20);
}
END_TEST

/* A curve of 0.01 mm past the singular direction by 0.001 degrees, where C turns by nearly half a
 * turn in a tenth of it: a control that slows down by itself needs the time of that turn, another
 * as much for every tenth. */
START_TEST(short_past_the_singular_direction)
{
    struct machine m = machine_default();
    struct error error;
    double minutes[2];
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    for (int slows = 0; slows < 2; slows++) {
        struct nc_planner planner = {.machine = &m,
                                     .options = {.unit = 1},
                                     .follow = {.mode = INTERPOLATE_VECTOR, .chain = &m.chain}};
        struct bspline b = bspline_new(3, 4, true);
        int over;
        m.slows = slows;
        b.length = 100;
        for (size_t i = 0; i < 4; i++) {
            double s = (double)i / 3;
            b.knot[i] = 0, b.knot[i + 4] = 1;
            b.pole[i] = vec(0.01 * s, 0, 0);
            b.head[i] = vec_add(b.pole[i], vec(0.1 * (s - 0.5), 0.00175, 100));
        }
        struct pose from = {b.pole[0], vec_unit(vec_sub(b.head[0], b.pole[0]))};
        struct pose to = {b.pole[3], vec_unit(vec_sub(b.head[3], b.pole[3]))};
        struct motion motion = motion_spline(from, to, &b);
        struct machine_pose end = {.at = {.p = to.p, .a = to.a}};
        const struct nc_along along = {&motion, 0, 1, NULL, 0};
        double *q = planner.state.at.q;
        planner.state.at = (struct block_pose){.p = from.p, .a = from.a};
        ck_assert_int_eq(ik_choose(&m.chain, from.a, (double[]){0, 0}, false, -1, q, &over), 0);
        ck_assert_int_eq(ik_choose(&m.chain, to.a, q, false, -1, end.at.q, &over), 0);
        minutes[slows] = post_feed_minutes(&planner, &end, 0.01, &along, 0);
        bspline_free(&b);
    }
    double turn = 180 / m.rapid[MACHINE_C];
    ck_assert_double_lt(minutes[1], 1.2 * turn);
    ck_assert_double_gt(minutes[0], 3 * minutes[1]);
}
END_TEST

/* Below 1 there are more digits, but not of inverse time. */
START_TEST(digits_of_feeds)
{
    struct nc_ability ability = {.feeds = NC_FEEDS_TIP, .digits = {.feed = 1}};
    ck_assert_int_eq(post_feed_digits(&ability, 1), 1);
    ck_assert_int_eq(post_feed_digits(&ability, 0.99), 4);
    ability.digits.feed = 8;
    ck_assert_int_eq(post_feed_digits(&ability, 0.5), 9);
    ability.feeds = NC_FEEDS_INVERSE;
    ck_assert_int_eq(post_feed_digits(&ability, 0.5), 8);
}
END_TEST

/* F read back as the control takes it: no axis is too fast for it, it is no slower than it need be,
 * and never faster than the path says. */
START_TEST(feed_words)
{
    int slow = 0;
    seed = 340 + (uint64_t)_i;
    for (int i = 0; i < 300; i++) {
        struct machine m = any_machine(_i);
        struct nc_plan plan = {.ability = {.feeds = (enum nc_feeds)(i % 3),
                                           .feed_max = 99999,
                                           .unit = 1,
                                           .digits = {.linear = 5, .feed = 3}}};
        bool tip = plan.ability.feeds == NC_FEEDS_TIP;
        struct nc_planner planner = {
            .machine = &m,
            .plan = &plan,
            .options = {.unit = 1},
            .follow = {.mode = tip ? INTERPOLATE_ROTARY : INTERPOLATE_JOINT, .chain = &m.chain}};
        planner.state.feed = 100 + 5000 * chance();
        planner.state.faster = 1;
        planner.state.at = any_end(&m.chain, 600);
        struct machine_pose to = {.at = any_end(&m.chain, 600)};
        to.at.p = vec_along(planner.state.at.p, 1 + 300 * chance(), random_unit());
        to.turned = chain_turned(&m.chain, to.at.q);
        const struct block_pose *a = &planner.state.at, *b = &to.at;
        double length = vec_distance(a->p, b->p), minutes, joint = length;
        double turned[2] = {DEGREES(fabs(b->q[0] - a->q[0])), DEGREES(fabs(b->q[1] - a->q[1]))};
        double least = fmax(turned[0] / m.rapid[MACHINE_C], turned[1] / m.rapid[MACHINE_A]);
        if (tip)
            least = fmax(least, by_steps(&m, a, b));
        else
            least = fmax(least, length / m.rapid[MACHINE_X]);
        double feed = post_feed_word(&planner, &to, length, NULL, &minutes);
        double wished = length / planner.state.feed, takes = length / feed;
        if (plan.ability.feeds == NC_FEEDS_INVERSE)
            takes = 1 / feed;
        joint = sqrt(length * length + turned[0] * turned[0] + turned[1] * turned[1]);
        if (plan.ability.feeds == NC_FEEDS_COMBINED)
            takes = joint / feed;
        ck_assert_double_ge(takes, 0.97 * fmax(least, wished));
        /* post_feed leaves 2 % of an axis' speed */
        ck_assert_double_le(takes, 1.025 * fmax(least, wished));
        ck_assert_double_eq_tol(1000 * feed, round(1000 * feed), 1e-6); /* its digits */
        ck_assert_double_eq_tol(minutes, takes, 0.01 * takes);
        slow += least > 1.05 * wished;
    }
    ck_assert_int_gt(slow, 30);
    ck_assert_int_lt(slow, 290);
}
END_TEST

/* A tip that hardly moves while C makes a quarter of a turn: with so few digits of F that it
 * stays too fast, the block is counted, and without the turn it is not. */
START_TEST(blocks_too_fast_are_counted)
{
    struct machine m = any_machine(0);
    struct nc_plan plan = {
        .ability = {.feed_max = 99999, .unit = 1, .digits = {.linear = 9, .feed = 0}}};
    struct nc_planner planner = {.machine = &m,
                                 .plan = &plan,
                                 .options = {.unit = 1},
                                 .follow = {.mode = INTERPOLATE_ROTARY, .chain = &m.chain}};
    struct machine_pose to = {.at = {.p = {1e-6, 0, 0}, .q = {0, 0}}};
    double minutes;
    planner.state.feed = 800;
    planner.state.faster = 1;
    planner.state.line = 7;
    to.at.a = planner.state.at.a = chain_axis(&m.chain, to.at.q);
    for (unsigned turn = 0; turn < 2; turn++) {
        to.at.q[1] = turn * PI / 2;
        to.at.a = chain_axis(&m.chain, to.at.q);
        to.turned = chain_turned(&m.chain, to.at.q);
        double said = post_feed_word(&planner, &to, 1e-6, NULL, &minutes);
        ck_assert_uint_eq(plan.total.fast, turn);
        if (turn == 0)
            continue;
        double takes = 1e-6 / said, slowest = 90 / m.rapid[m.letter[1]];
        ck_assert_double_ge(plan.total.fastest, 0.97 * slowest / takes);
        ck_assert_uint_eq(plan.total.fast_line, 7);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_feed");
    TCase *tests = tcase_create("blocks");

    tcase_add_loop_test(tests, as_by_small_steps, 0, KINDS);
    tcase_add_test(tests, slow_part_of_a_curve);
    tcase_add_test(tests, blocks_too_fast_are_counted);
    tcase_add_test(tests, beside_the_singular_direction);
    tcase_add_test(tests, short_past_the_singular_direction);
    tcase_add_test(tests, a_peak_that_slows_all_is_parted);
    tcase_add_test(tests, digits_of_feeds);
    tcase_add_loop_test(tests, feed_words, 0, KINDS);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/*
 * follow: deviations that can be worked out by hand, against the ones that are measured, and the
 * quick bound against the close look.
 */
#include <check.h>
#include <stdlib.h>

#include "follow.h"

static const struct deviation exact = {0, 0}; /* nothing is allowed: no bound will do */

/* C carried by A, both centres at the origin. */
static struct chain table_ac(void)
{
    return (struct chain){.n = 2, .master = 1, .tool = {0, 0, 1},
                          .rotary = {{{0, 0, 1}, {0, 0, 0}, true, -9, 9},
                                     {{1, 0, 0}, {0, 0, 0}, true, -9, 9}}};
}

static struct station station(const struct chain *chain, struct vec3 p, double c, double a)
{
    const double q[2] = {c, a};
    return (struct station){.p = p, .a = chain_axis(chain, q), .q = {c, a}};
}

/* Great circle between vectors: the motion of the path itself. */
START_TEST(vectors_are_exact)
{
    struct chain chain = table_ac();
    struct follow f = {FOLLOW_VECTOR, &chain, 8};
    struct station from = station(&chain, vec(0, 0, 0), 0, 0.5);
    struct station to = station(&chain, vec(10, 0, 0), 1, 0.7);
    struct motion m = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    struct deviation d = follow_block(&f, &from, &to, &m, 0, 1, exact);
    ck_assert_double_lt(d.point, 1e-12);
    ck_assert_double_lt(d.axis, 1e-12);
}
END_TEST

/*
 * A at 0.5, C from -0.3 to 0.3: the rotary axes keep the tilt of 0.5; in the middle the great
 * circle stands at atan(tan 0.5 cos 0.3).
 */
START_TEST(rotary_words_leave_the_great_circle)
{
    struct chain chain = table_ac();
    struct follow f = {FOLLOW_ROTARY, &chain, 8};
    struct station from = station(&chain, vec(0, 0, 0), -0.3, 0.5);
    struct station to = station(&chain, vec(10, 0, 0), 0.3, 0.5);
    struct motion m = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    double off = 0.5 - atan(tan(0.5) * cos(0.3));
    struct deviation d = follow_block(&f, &from, &to, &m, 0, 1, exact);
    ck_assert_double_eq_tol(d.axis, off, 1e-9);
    ck_assert_double_eq_tol(d.point, 8 * 2 * sin(off / 2), 1e-9);
    /* the bound, taken where much is allowed, is no smaller */
    struct deviation bound = follow_block(&f, &from, &to, &m, 0, 1, (struct deviation){1e3, 1e3});
    ck_assert_double_ge(bound.axis, d.axis);
    ck_assert_double_ge(bound.point, d.point);
}
END_TEST

/*
 * Without TCP, C turning by 0.2 at a radius of 50 while the linear axes go straight: the point is
 * off by the sagitta 50 (1 - cos 0.1), the work's turn being that of the chord.
 */
START_TEST(joints_leave_the_straight_line)
{
    struct chain chain = table_ac();
    struct follow f = {FOLLOW_JOINT, &chain, 0};
    struct vec3 p = vec(50, 0, 0);
    const double q0[2] = {-0.1, 0}, q1[2] = {0.1, 0};
    struct station from = {.p = chain_linear(&chain, p, q0), .a = {0, 0, 1}, .q = {-0.1, 0}};
    struct station to = {.p = chain_linear(&chain, p, q1), .a = {0, 0, 1}, .q = {0.1, 0}};
    struct motion m = motion_line((struct pose){p, {0, 0, 1}}, (struct pose){p, {0, 0, 1}});
    struct deviation d = follow_block(&f, &from, &to, &m, 0, 1, exact);
    ck_assert_double_eq_tol(d.point, 50 * (1 - cos(0.1)), 1e-6);
}
END_TEST

START_TEST(chord_of_an_arc)
{
    struct chain chain = table_ac();
    struct follow f = {FOLLOW_VECTOR, &chain, 0};
    struct station from = station(&chain, vec(10, 0, 0), 0, 0);
    struct station to = station(&chain, vec(0, 10, 0), 0, 0);
    struct motion m = motion_arc((struct pose){from.p, from.a}, (struct pose){to.p, to.a},
                                 vec(0, 0, 0), vec(0, 0, 1));
    struct deviation d = follow_block(&f, &from, &to, &m, 0, 1, exact);
    ck_assert_double_eq_tol(d.point, 10 - sqrt(50), 1e-9);
    double point;
    d = follow_curve(&f, &from, &to, &m, &m, 0, 1, &point);
    ck_assert_double_lt(d.point, 1e-12);
    ck_assert_double_lt(point, 1e-12);
}
END_TEST

/* The tool turns over the pole on one spot: its two ends alone would look right. */
START_TEST(a_turn_on_the_spot_is_seen)
{
    struct chain chain = table_ac();
    struct follow f = {FOLLOW_ROTARY, &chain, 8};
    struct station from = station(&chain, vec(0, 0, 0), PI, 0.5);
    struct station to = station(&chain, vec(1e-5, 0, 0), 0, -0.5);
    struct motion m = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    struct deviation d = follow_block(&f, &from, &to, &m, 0, 1, exact);
    ck_assert_double_gt(d.axis, 0.3);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("follow");
    TCase *tests = tcase_create("blocks");

    tcase_add_test(tests, vectors_are_exact);
    tcase_add_test(tests, rotary_words_leave_the_great_circle);
    tcase_add_test(tests, joints_leave_the_straight_line);
    tcase_add_test(tests, chord_of_an_arc);
    tcase_add_test(tests, a_turn_on_the_spot_is_seen);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* rotary_cost: against angles that are known. */
#include "machine/rotary_cost.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "machine/machine.h"

static struct vec3 leaning(double lean, double direction)
{
    return vec(sin(lean) * cos(direction), sin(lean) * sin(direction), cos(lean));
}

START_TEST(ways_are_those_of_lean_and_direction)
{
    for (int i = 0; i < 36; i++) {
        double at = 2 * PI * i / 36;
        ck_assert_double_eq_tol(rotary_travel(leaning(0.5, at), leaning(0.7, at)), 0.2, 1e-9);
        ck_assert_double_eq_tol(rotary_travel(leaning(0.5, at), leaning(0.4, at + 1)), 1.1, 1e-9);
        ck_assert_double_eq_tol(rotary_travel(leaning(0.5, at), leaning(0.4, at - 1)), 1.1, 1e-9);
        /* straight over the top: the lean goes to the other side */
        ck_assert_double_eq_tol(rotary_travel(leaning(0.1, at), leaning(0.2, at + PI)), 0.3, 1e-9);
        ck_assert_double_eq_tol(rotary_travel(leaning(0.1, at), leaning(0.2, at + PI - 0.1)), 0.4,
                                1e-9);
        ck_assert_double_eq_tol(rotary_travel(vec(0, 0, 1), leaning(0.3, at)), 0.3, 1e-9);
        ck_assert_double_eq(rotary_travel(leaning(0.3, at), leaning(0.3, at)), 0);
        /* to one side alone: not over the pole */
        struct rotary_leaning a = rotary_leaning_of(leaning(0.1, at));
        struct rotary_leaning b = rotary_leaning_of(leaning(0.2, at + 3));
        ck_assert_double_eq_tol(a.lean, 0.1, 1e-12);
        ck_assert_double_eq_tol(rotary_leaning_travel(&a, &b), 0.3 + PI - 3, 1e-9);
        ck_assert_double_eq_tol(rotary_leaning_travel_one(&a, &b), 0.1 + 3, 1e-9);
        ck_assert(rotary_leaning_travel(&a, &b) == rotary_travel(a.axis, b.axis));
        b = rotary_leaning_of(vec(0, 0, 1));
        ck_assert_double_eq_tol(rotary_leaning_travel_one(&a, &b), 0.1, 1e-12);
    }
}
END_TEST

START_TEST(leans_are_off_the_normal_by_what_was_asked)
{
    double least = 15 * PI / 180, most = 27 * PI / 180, smallest = 9, largest = 0;
    struct tool_axis_feed feed = {.along = vec(1, 0, 0), .side = vec(0, 1, 0)};
    int n = rotary_leans(least, most);

    ck_assert_int_eq(rotary_leans(least, least), 24);
    ck_assert_int_eq(n, 24 * 4);
    for (int i = 0; i < n; i++) {
        struct tool_axis_options rule = rotary_lean(least, most, i);
        struct vec3 axis = tool_axis_at(&rule, &feed, vec(0, 0, 0), vec(0, 0, 1));
        double off = acos(axis.z);
        smallest = fmin(smallest, off);
        largest = fmax(largest, off);
        for (int k = 0; k < i; k++) { /* and no two alike */
            struct tool_axis_options other = rotary_lean(least, most, k);
            ck_assert_double_gt(fabs(rule.lead - other.lead) + fabs(rule.tilt - other.tilt), 1e-3);
        }
    }
    ck_assert_double_eq_tol(smallest, least, 1e-9);
    ck_assert_double_eq_tol(largest, most, 1e-9);
}
END_TEST

/* A machine of one rotary axis turns the tool about that; where it is along the tool, or there are
 * two or none, there is no circle. */
START_TEST(the_circle_of_one_axis)
{
    struct kinematic_chain one = {
        .n = 1, .rotary = {{.axis = {1, 0, 0}, .min = -1, .max = 2}}, .tool = {0, 0, 1}};
    struct axis_circle c = rotary_circle(&one);
    struct rotary_frame frame = rotary_frame_of(&one);
    struct rotary_angles at = {.lean = 0};

    ck_assert_double_eq_tol(vec_distance(c.pole, vec(1, 0, 0)), 0, 1e-12);
    ck_assert_double_eq(c.min, -1);
    ck_assert_double_eq(c.max, 2);
    for (double q = -1; q <= 2; q += 0.1) {
        struct vec3 a = vec_turn(c.zero, c.pole, q);
        double last = at.turn;
        at = rotary_angles_near(&frame, a, at);
        ck_assert_double_eq_tol(at.lean, PI / 2, 1e-9);
        ck_assert(q < -0.95 || fabs(fabs(at.turn - last) - 0.1) < 1e-9);
        ck_assert_double_lt(vec_distance(rotary_axis(&frame, at), a), 1e-12);
        ck_assert(rotary_reaches(&one, a));
        ck_assert(rotary_reaches_between(&one, a, vec_turn(c.zero, c.pole, fmin(2, q + 1))));
        ck_assert(!rotary_reaches(&one, vec_unit(vec_add(a, vec(0.001, 0, 0)))));
    }
    ck_assert(!rotary_reaches(&one, vec_turn(c.zero, c.pole, 2.1)));
    one.rotary[0].min =
        -1.5; /* the short way from one end to the other is through what it has not */
    ck_assert(
        !rotary_reaches_between(&one, vec_turn(c.zero, c.pole, 2), vec_turn(c.zero, c.pole, -1.5)));
    one.rotary[0].axis = vec(0, 0, 1);
    ck_assert_double_eq(vec_length(rotary_circle(&one).pole), 0);
    one.n = 0;
    ck_assert_double_eq(vec_length(rotary_circle(&one).pole), 0);
    struct machine machine = machine_default();
    ck_assert_double_eq(vec_length(rotary_circle(&machine.chain).pole), 0);
}
END_TEST

/* Past the pole the turn goes by while the axis leans, and stands at the pole itself. */
START_TEST(a_way_past_the_pole_turns_beside_it)
{
    const struct kinematic_chain none = {.tool = {0, 0, 1}};
    struct rotary_frame frame = rotary_frame_of(&none);
    struct rotary_angles from = {-0.06, 0.4}, to = {0.6, 0.9}, beside = {0.3, 2};
    double pole = rotary_pole_between(from, to), eps = 1e-4;

    ck_assert_double_eq_tol(pole, 1.0 / 11, 1e-12);
    ck_assert_double_lt(rotary_pole_between(beside, to), 0);
    for (int i = 0; i <= 10; i++) {
        struct rotary_angles at = rotary_angles_between(from, to, i / 10.0);
        ck_assert_double_eq_tol(at.lean, -0.06 + 0.066 * i, 1e-12);
        at = rotary_angles_between(beside, to, i / 10.0);
        ck_assert_double_eq_tol(at.turn, 2 - 0.11 * i, 1e-12);
    }
    ck_assert_double_eq_tol(rotary_angles_between(from, to, 0).turn, 0.4, 1e-12);
    ck_assert_double_eq_tol(rotary_angles_between(from, to, 1).turn, 0.9, 1e-12);
    double before = rotary_angles_between(from, to, pole - eps).turn,
           after = rotary_angles_between(from, to, pole + eps).turn;
    ck_assert_double_lt(fabs(after - before), 1e-7);
    ck_assert_double_eq(rotary_axis(&frame, rotary_angles_between(from, to, pole)).z, 1);
}
END_TEST

/* Of a trunnion that leans by 120 degrees: a great circle's highest lean is known. */
START_TEST(a_turn_stays_within_its_travel_or_not)
{
    struct machine machine = machine_default();
    struct error error;
    const struct kinematic_chain none = {.tool = {0, 0, 1}};

    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    for (int i = 1; i < 36; i++) {
        double half = RADIANS(2.5 * i), lean = RADIANS(110);
        struct vec3 a = leaning(lean, 1 - half), b = leaning(lean, 1 + half);
        double highest = PI - atan(fabs(tan(lean)) * cos(half)); /* lean of a + b */
        bool within = highest <= RADIANS(120);
        ck_assert(rotary_reaches(&machine.chain, a) && rotary_reaches(&machine.chain, b));
        if (fabs(highest - RADIANS(120)) > RADIANS(1e-6))
            ck_assert_int_eq(rotary_reaches_between(&machine.chain, a, b), within);
        ck_assert(rotary_reaches_between(&none, a, b));
        ck_assert(!rotary_reaches(&none, a) && rotary_allows(&none, a));
        ck_assert(rotary_allows(&machine.chain, a));
        ck_assert(!rotary_allows(&machine.chain, leaning(RADIANS(121), 1 - half)));
    }
}
END_TEST

/* Ends 1.2 degrees apart, whose way is looked at in its middle alone: there it leans more than they
 * do, by half of what is left to the limit before. */
START_TEST(the_middle_of_a_short_way)
{
    struct machine machine = machine_default();
    struct error error;

    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    for (int within = 0; within < 2; within++) {
        double half = RADIANS(0.7), bulge = PI - atan(fabs(tan(RADIANS(120))) * cos(half)),
               lean = RADIANS(120) - (within ? 2 : 0.5) * (bulge - RADIANS(120));
        struct vec3 a = leaning(lean, 1 - half), b = leaning(lean, 1 + half);
        ck_assert_double_gt(vec_angle(a, b), RADIANS(1));
        ck_assert_double_lt(vec_angle(a, b), RADIANS(2));
        ck_assert(rotary_reaches(&machine.chain, a) && rotary_reaches(&machine.chain, b));
        ck_assert_int_eq(rotary_reaches_between(&machine.chain, a, b), within);
    }
}
END_TEST

/* The table B/C of a head that turns by 45 degrees, with C to 90 to both sides: about -Y there is a
 * gap that no angles have.  With the tool L off Z the head's axis B is at b,
 * cos L = (1 + cos b) / 2, and the gap is atan(tan(b / 2) / sqrt(2)) wide to each side. */
START_TEST(a_gap_is_seen_on_a_short_way)
{
    struct kinematic_chain nutating = {.tool = {0, 0, 1}, .n = 2}, upright;
    const double end = PI / 2;

    nutating.rotary[0] = (struct rotary){.axis = {0, 0, 1}, .min = -end, .max = end};
    nutating.rotary[1] = (struct rotary){.axis = {0, sqrt(0.5), sqrt(0.5)}, .min = -PI, .max = PI};
    chain_measure(&nutating);
    upright = nutating;
    upright.rotary[1].axis = vec(0, 1, 0);
    chain_measure(&upright);
    for (int i = 1; i <= 40; i++) {
        double lean = RADIANS(0.5 * i), b = acos(2 * cos(lean) - 1);
        double gap = atan(tan(b / 2) / sqrt(2));
        for (int k = 0; k < 20; k++) {
            double before = gap + RADIANS(0.02 + 0.13 * k) / sin(lean),
                   after = gap + RADIANS(2.7 - 0.13 * k) / sin(lean);
            if (before > 1 || after > 1)
                continue;
            struct vec3 a = leaning(lean, -end - before), c = leaning(lean, -end + after);
            ck_assert(rotary_reaches(&nutating, a) && rotary_reaches(&nutating, c));
            ck_assert(!rotary_reaches(&nutating, leaning(lean, -end + 0.99 * gap)));
            ck_assert(!rotary_reaches_between(&nutating, a, c));
            ck_assert(!rotary_reaches_between(&nutating, c, a));
            ck_assert(rotary_reaches_between(&upright, a, c)); /* the other solution is there */
            a.y *= -1, c.y *= -1;
            ck_assert(rotary_reaches_between(&nutating, a, c)); /* and here both are */
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rotary_cost");
    TCase *tests = tcase_create("rotary_cost");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, ways_are_those_of_lean_and_direction);
    tcase_add_test(tests, leans_are_off_the_normal_by_what_was_asked);
    tcase_add_test(tests, the_circle_of_one_axis);
    tcase_add_test(tests, a_way_past_the_pole_turns_beside_it);
    tcase_add_test(tests, a_turn_stays_within_its_travel_or_not);
    tcase_add_test(tests, the_middle_of_a_short_way);
    tcase_add_test(tests, a_gap_is_seen_on_a_short_way);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

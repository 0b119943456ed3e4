/* post_time: plans whose times are known by hand: a straight way from standstill to standstill
 * takes v / a more than its length over v, whatever moves, in whatever unit. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "post/post_time.h"

static struct machine machine;
static struct nc_plan plan;

/* Rapids of 500 mm/s and 120 degrees/s, 3000 mm/s^2 and 1000 degrees/s^2; the jerk is no limit. */
static void setup(void)
{
    struct error error;
    machine = machine_default();
    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    for (int k = 0; k < MACHINE_AXES; k++) {
        machine.rapid[k] = 60 * (k <= MACHINE_Z ? 500 : 120);
        machine.acceleration[k] = k <= MACHINE_Z ? 3000 : 1000;
        machine.jerk[k] = 1e12;
    }
    plan = (struct nc_plan){
        .ability = {.mode = INTERPOLATE_JOINT, .unit = 1, .digits = {3, 3, 6, 3, 3}}};
}

static void teardown(void)
{
    array_free(&plan.move);
}

static void go(enum nc_kind kind, struct vec3 p, double c, double a, double feed)
{
    *array_push(&plan.move) =
        (struct nc_move){.kind = kind, .p = p, .q = {RADIANS(c), RADIANS(a)}, .feed = feed};
}

/* Seconds that are added to the plan's. */
static double added(void)
{
    plan.total.minutes = 7;
    post_time(&plan, &machine);
    return 60 * (plan.total.minutes - 7);
}

START_TEST(straight)
{
    for (int inch = 0; inch < 2; inch++) {
        double unit = inch ? 25.4 : 1;
        plan.ability.unit = unit;
        for (int k = 0; k <= MACHINE_Z; k++) /* as post_frame_inch makes it; the rest stays in mm */
            machine.rapid[k] = 60 * 500 / unit;
        plan.move.n = 0;
        go(NC_RAPID, vec(0, 0, 0), 0, 0, 0); /* from where is not known */
        ck_assert_double_eq(added(), 0);
        go(NC_LINE, vec(0, 600 / unit, 0), 0, 0, 3000 / unit);
        ck_assert_double_eq_tol(added(), 50 / 3000., 1e-6);
        /* on in the same way: no stop; in between a word that moves nothing */
        *array_push(&plan.move) = (struct nc_move){.kind = NC_PASS};
        go(NC_LINE, vec(0, 900 / unit, 0), 0, 0, 3000 / unit);
        ck_assert_double_eq_tol(added(), 50 / 3000., 1e-6);
        /* another tool: a run of its own */
        *array_push(&plan.move) = (struct nc_move){.kind = inch ? NC_TOOL : NC_PLANE};
        go(NC_LINE, vec(0, 1200 / unit, 0), 0, 0, 3000 / unit);
        ck_assert_double_eq_tol(added(), 2 * 50 / 3000., 1e-6);
        /* faster than the axis goes: what its feed wished for is not what it takes */
        go(NC_RAPID, vec(0, 1300 / unit, 0), 0, 0, 0);
        double so_far = added();
        ck_assert_double_eq_tol(so_far, 2 * 50 / 3000. + 500 / 3000., 1e-6);
        go(NC_LINE, vec(0, 7300 / unit, 0), 0, 0, 60000 / unit);
        ck_assert_double_eq_tol(added() - so_far, 6000 / 500. + 500 / 3000. - 6000 / 1000., 1e-6);
        /* without a feed there is no time to compare with */
        so_far = added();
        go(NC_HOLE, vec(0, 0, 0), 0, 0, 100);
        go(NC_LINE, vec(0, 600, 0), 0, 0, 0);
        ck_assert_double_eq_tol(added(), so_far, 1e-9);
    }
}
END_TEST

/* Either rotary axis alone, by its rapid and at a feed in degrees a minute; and with a slide. */
START_TEST(turns)
{
    for (int axis = 0; axis < 2; axis++) {
        double c = axis == 0 ? 180 : 0, a = axis == 1 ? 90 : 0, far = c + a;
        plan.move.n = 0;
        go(NC_RAPID, vec(0, 0, 0), 0, 0, 0);
        go(NC_RAPID, vec(0, 0, 0), c, a, 0);
        ck_assert_double_eq_tol(added(), 120 / 1000., 1e-6);
        go(NC_LINE, vec(0, 0, 0), 0, 0, 3600);
        ck_assert_double_eq_tol(added(), 120 / 1000. + 60 / 1000., 1e-6);
        machine.acceleration[machine.letter[axis]] = 500;
        ck_assert_double_eq_tol(added(), 120 / 500. + 60 / 500., 1e-6);
        machine.acceleration[machine.letter[axis]] = 1000;
        machine.rapid[machine.letter[axis]] = 60 * 30; /* too slow for the feed */
        ck_assert_double_eq_tol(added(), 30 / 1000. + far / 30 + 30 / 1000. - far / 60, 1e-6);
        machine.rapid[machine.letter[axis]] = 60 * 120;
        /* F along all axes together: 3-4-5; the slide needs least of its acceleration */
        plan.move.n = 0;
        plan.ability.feeds = NC_FEEDS_COMBINED;
        go(NC_RAPID, vec(0, 0, 0), 0, 0, 0);
        go(NC_LINE, vec(0.75 * far, 0, 0), c, a, 3000);
        ck_assert_double_eq_tol(added(), 40 / 1000., 1e-6);
        plan.ability.feeds = NC_FEEDS_TIP;
    }
}
END_TEST

/* A table's axis through a place off the tip moves the slides, where the control leads the tip. */
START_TEST(the_tip_is_led)
{
    plan.ability.mode = INTERPOLATE_ROTARY;
    go(NC_RAPID, vec(200, 0, 0), 0, 0, 0);
    go(NC_LINE, vec(200, 0, 0), 90, 0, 5400);
    double at_rest = added();
    machine.acceleration[MACHINE_X] = 100;
    ck_assert_double_gt(added(), at_rest + 0.1); /* 200 mm * (pi / 2)^2 is 490 mm/s^2 */
    plan.ability.mode = INTERPOLATE_JOINT;
    ck_assert_double_eq_tol(added(), 90 / 1000., 1e-6);
}
END_TEST

/* Inverse time: each block gets the time that it takes, half of v / a more at each end. */
START_TEST(inverse)
{
    plan.ability.feeds = NC_FEEDS_INVERSE;
    go(NC_RAPID, vec(0, 0, 0), 0, 0, 0);
    for (int i = 1; i <= 3; i++)
        go(NC_LINE, vec(100 * i, 0, 0), 0, 0, 30); /* 2 s: 50 mm/s */
    ck_assert_double_eq_tol(added(), 50 / 3000., 1e-6);
    double end = 60 / (2 + 25 / 3000.);
    ck_assert_double_eq_tol(plan.move.item[1].feed, end, 0.00051);
    ck_assert_double_eq(plan.move.item[2].feed, 30);
    ck_assert_double_eq_tol(plan.move.item[3].feed, end, 0.00051);
    /* so slow that the digits say nothing: the least that they say */
    plan.move.n = 1;
    go(NC_LINE, vec(1000, 0, 0), 0, 0, 0.5);
    machine.rapid[MACHINE_X] = 1e-6;
    added();
    ck_assert_double_gt(plan.move.item[1].feed, 0);
    ck_assert_double_lt(plan.move.item[1].feed, 0.0011);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_time");
    TCase *tests = tcase_create("post_time");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, straight);
    tcase_add_test(tests, turns);
    tcase_add_test(tests, the_tip_is_led);
    tcase_add_test(tests, inverse);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

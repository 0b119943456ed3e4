/* post_hole: heights, kinds, pitches of drilling cycles; which hole the cycle that is on serves. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "blocks.h"
#include "post/post_hole.h"

static struct path_cycle drill = {.kind = CYCLE_DRILL, .depth = 10, .clear = 2, .retract = 5};

static struct nc_move hole(struct vec3 mouth, const struct path_cycle *cycle)
{
    *array_push(&plan.hole) = (struct nc_hole){mouth, cycle, 100, 10, 2, 5};
    return (struct nc_move){.kind = NC_HOLE,
                            .index = (unsigned)plan.hole.n - 1,
                            .p = vec(mouth.x + 0.00049, mouth.y, mouth.z + 5)};
}

static void setup(void)
{
    blocks_begin((struct nc_ability){0});
}

static void teardown(void)
{
    array_free(&plan.hole);
}

START_TEST(heights)
{
    const struct nc_hole h = {{1, 2, 30}, &drill, 100, 10, 2, 5};
    ck_assert_double_eq(nc_hole_bottom(&h), 20);
    ck_assert_double_eq(nc_hole_clear(&h), 32);
    ck_assert_double_eq(nc_hole_level(&h), 35);
}
END_TEST

START_TEST(kinds)
{
    static const struct {
        enum path_cycle_kind kind;
        bool slow, steps;
    } k[] = {{CYCLE_DRILL, false, false}, {CYCLE_DEEP, false, true}, {CYCLE_BREAK, false, true},
             {CYCLE_TAP, true, false},    {CYCLE_BORE, true, false}, {CYCLE_DRAG, false, false},
             {CYCLE_MANUAL, false, false}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        struct path_cycle c = {.kind = k[i].kind, .step = 3, .next = 3};
        struct nc_hole h = {.cycle = &c};
        ck_assert(nc_hole_slow(&h) == k[i].slow);
        ck_assert(nc_hole_steps(&h) == k[i].steps);
        c.step = 0; /* all at once */
        ck_assert(!nc_hole_steps(&h));
    }
}
END_TEST

START_TEST(steps_differ)
{
    static const struct {
        double step, next, dwell;
        bool differ;
    } k[] = {{0, 0, 0, false}, {0, 0, 2, false}, {3, 3, 0, false},
             {3, 2, 0, true},  {3, 3, 1, true},  {0, 2, 0, false}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        struct path path = {.name = "p.cl"};
        *array_push(&path.cycle) = drill;
        *array_push(&path.cycle) =
            (struct path_cycle){.step = k[i].step, .next = k[i].next, .dwell = k[i].dwell};
        *array_push(&path.cycle) = drill;
        ck_assert(nc_hole_steps_differ(&path) == k[i].differ);
        array_free(&path.cycle);
    }
}
END_TEST

START_TEST(pitch)
{
    struct path_cycle tap = {.kind = CYCLE_TAP, .pitch = 1.25};
    struct nc_hole h = {.cycle = &tap, .feed = 600};
    ck_assert_double_eq(nc_hole_pitch(&p, &h), 1.25);
    tap.pitch = 0;
    ck_assert_double_eq(nc_hole_pitch(&p, &h), 0); /* the spindle stands */
    p.tooling.spindle = 400;
    ck_assert_double_eq(nc_hole_pitch(&p, &h), 1.5);
}
END_TEST

/* The same cycle from the same height, and no other; where the tool is after a hole is known. */
START_TEST(goes_on)
{
    struct path_cycle other = drill;
    struct nc_move first = hole(vec(1, 2, 30), &drill), near = hole(vec(3, 2, 30), &drill),
                   lower = hole(vec(3, 2, 29), &drill), another = hole(vec(3, 2, 30), &other);
    ck_assert_ptr_eq(nc_hole_of(&p, &lower), &plan.hole.item[2]);
    ck_assert(!nc_hole_goes_on(&p, &first));
    p.w.motion = "G0";
    nc_hole_done(&p, &first);
    ck_assert_ptr_null(p.w.motion);
    ck_assert(nc_hole_goes_on(&p, &first));
    ck_assert(nc_hole_goes_on(&p, &near));
    ck_assert(!nc_hole_goes_on(&p, &lower));
    ck_assert(!nc_hole_goes_on(&p, &another));
    /* X Y Z as printed are known: a word of the same place is none */
    nc_modal(&p.w, NC_X, "X", 1, 3);
    nc_modal(&p.w, NC_Y, "Y", 2, 3);
    nc_modal(&p.w, NC_Z, "Z", 35, 3);
    ck_assert_str_eq(said(), "");
    /* but the place of a hole makes one, so both its words stand */
    nc_hole_place(&p, nc_hole_of(&p, &first));
    ck_assert_str_eq(said(), "X1. Y2.");
    nc_hole_place(&p, nc_hole_of(&p, &near));
    ck_assert_str_eq(said(), "X3. Y2.");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_hole");
    TCase *tests = tcase_create("post_hole");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, heights);
    tcase_add_test(tests, kinds);
    tcase_add_test(tests, steps_differ);
    tcase_add_test(tests, pitch);
    tcase_add_test(tests, goes_on);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/*
 * verify_swerve: a row of a cut with one place off it, to either side of what is allowed; what a
 * part makes of a row, as a corner or a step, is none.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/elementary.h"
#include "verify/verify_swerve.h"

enum { STEPS = 9, PLACE = 4 };

struct trial {
    struct nc_motion motion;
    struct verdict v;
};

/* A row of steps of half a millimetre along x, all of them on the part. */
static void trial_begin(struct trial *t)
{
    memset(t, 0, sizeof *t);
    t->motion.kinematics.tool = vec(0, 0, 1);
    for (int i = 0; i < STEPS; i++)
        *array_push(&t->motion.piece) =
            (struct nc_piece){.block = 10 * i,
                              .line = (size_t)i,
                              .feed = 800,
                              .p = {vec(0.5 * i, 0, 0), vec(0.5 * i + 0.5, 0, 0)},
                              .q = {vec(0, 0, 1), vec(0, 0, 1)}};
    for (unsigned i = 0; i < STEPS; i++)
        *array_push(&t->v.cut) = (struct centre_segment){.piece = i, .on = true};
    t->v.program.motion = &t->motion;
    t->v.options = (struct verify_options){.radius = 3, .tolerance = 0.01};
}

/* The end of a step, and the start of the next. */
static void put(struct trial *t, int step, struct vec3 p, struct vec3 axis)
{
    struct nc_piece *piece = t->motion.piece.item + step;
    struct vec3 tip = vec_along(p, -t->v.options.radius, axis);
    piece[0].p[1] = piece[1].p[0] = tip;
    piece[0].q[1] = piece[1].q[0] = axis;
}

/* Lines that are said for the row; the first one's block. */
static size_t said(struct trial *t, int *block)
{
    verify_swerve(&t->v);
    size_t n = t->v.finding.n;
    *block = n > 0 ? (int)strtol(t->v.finding.item[0].text + 1, NULL, 10) : -1;
    for (size_t i = 0; i < n; i++)
        ck_assert(t->v.finding.item[i].fault);
    nc_motion_free(&t->motion);
    verdict_free(&t->v);
    return n;
}

/* One place off the row: by so much along it and aside of it, mm; the axis by so many degrees. */
static const struct {
    double along, aside, lean;
    bool on, said;
} places[] = {
    {0, 0, 0, true, false},    {0, 0.3, 0, true, true}, {0, 0.2, 0, true, false},
    {0, 0.3, 0, false, false}, {0.2, 1, 0, true, true}, {-0.4, -1, 0, true, true},
    {1, 0, 0, true, false}, /* there and back on the row: cut twice */
    {0, 0, 5, true, true},     {0, 0, 3.2, true, true}, {0, 0, 2.8, true, false},
    {0, 0, 5, false, false},
};

START_TEST(one_place)
{
    struct trial t;
    int block;
    trial_begin(&t);
    for (size_t i = 0; i < STEPS; i++)
        t.v.cut.item[i].on = places[_i].on;
    double lean = RADIANS(places[_i].lean);
    for (int i = 0; i + 1 < STEPS; i++) /* of the ball's centre */
        put(&t, i,
            vec(0.5 * i + 0.5 + (i == PLACE ? places[_i].along : 0),
                i == PLACE ? places[_i].aside : 0, 3),
            i == PLACE ? vec(sin(lean), 0, cos(lean)) : vec(0, 0, 1));
    t.motion.piece.item[0].p[0] = vec(0, 0, 0);
    ck_assert_uint_eq(said(&t, &block), places[_i].said);
    ck_assert_int_eq(block, places[_i].said ? 10 * PLACE : -1);
}
END_TEST

/* The axis turns evenly all along, by a degree a step, but in one place. */
START_TEST(an_axis_that_turns)
{
    const double off[] = {0, 2.5, 5};
    struct trial t;
    int block;
    trial_begin(&t);
    for (int i = 0; i + 1 < STEPS; i++) {
        double lean = RADIANS(i + 1 + (i == PLACE ? off[_i] : 0));
        put(&t, i, vec(0.5 * i + 0.5, 0, 3), vec(sin(lean), 0, cos(lean)));
    }
    t.motion.piece.item[STEPS - 1].q[1] = vec(sin(RADIANS(STEPS)), 0, cos(RADIANS(STEPS)));
    ck_assert_uint_eq(said(&t, &block), off[_i] > 3);
}
END_TEST

/* The axis turns ever faster to where a row ends, and back on the long way that leaves it: off an
 * even turn, by the lengths, at one place only, but the row turned it as fast before.  Not
 * so where it all but stands. */
START_TEST(a_row_that_ends)
{
    const double x[STEPS] = {0.5, 0.55, 0.59, 0.62, 0.66, 0.82, 9.2, 17.6, 17.7};
    const double lean[2][STEPS] = {{0, 0, 1, 2.5, 5.5, 19, 9, 4, 4}, {0, 0, 0, 1, 2, 19, 4, 4, 4}};
    struct trial t;
    int block;
    trial_begin(&t);
    for (int i = 0; i < STEPS; i++) {
        double angle = RADIANS(lean[_i][i]);
        struct vec3 axis = vec(sin(angle), 0, cos(angle)), ball = vec(x[i], 0, 3);
        struct nc_piece *piece = t.motion.piece.item + i;
        piece->p[1] = vec_along(ball, -t.v.options.radius, axis);
        piece->q[1] = axis;
        if (i + 1 < STEPS)
            put(&t, i, ball, axis);
    }
    ck_assert_uint_eq(said(&t, &block), (size_t)_i);
}
END_TEST

/* What parts do: a row up a step or over a ridge, round a corner, and back beside itself. */
static const double shapes[][STEPS][2] = {
    {{.5, 0}, {1, 0}, {1.5, 0}, {1.5, 1}, {2, 1}, {2.5, 1}, {3, 1}, {3.5, 1}, {4, 1}},
    {{.5, 0}, {1, 0}, {1.5, .5}, {2, 1}, {2.5, .5}, {3, 0}, {3.5, 0}, {4, 0}, {4.5, 0}},
    {{.5, 0}, {1, 0}, {1.5, 0}, {2, 0}, {2, .5}, {2, 1}, {2, 1.5}, {2, 2}, {2, 2.5}},
    {{.5, 0}, {1, 0}, {1.5, 0}, {2, 0}, {2, .4}, {1.5, .4}, {1, .4}, {.5, .4}, {0, .4}},
};

START_TEST(shapes_of_parts)
{
    struct trial t;
    int block;
    trial_begin(&t);
    for (int i = 0; i + 1 < STEPS; i++)
        put(&t, i, vec(shapes[_i][i][0], 0, 3 + shapes[_i][i][1]), vec(0, 0, 1));
    t.motion.piece.item[STEPS - 1].p[1] =
        vec(shapes[_i][STEPS - 1][0], 0, shapes[_i][STEPS - 1][1]);
    ck_assert_uint_eq(said(&t, &block), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("verify_swerve");
    TCase *tests = tcase_create("verify_swerve");
    tcase_add_loop_test(tests, one_place, 0, sizeof places / sizeof *places);
    tcase_add_loop_test(tests, an_axis_that_turns, 0, 3);
    tcase_add_loop_test(tests, a_row_that_ends, 0, 2);
    tcase_add_loop_test(tests, shapes_of_parts, 0, sizeof shapes / sizeof *shapes);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/*
 * check_holder_collision - shank and holder along a motion: what is nearest against all places
 * looked at one by one, and depths that are known.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/holder_collision.h"
#include "seed.h"

static const struct tool_shape stack = {2, {{0, 30, 2, 2}, {30, 50, 8, 15}}};

static double random_in(unsigned *state, double low, double high)
{
    *state = *state * 1664525u + seed_step_32();
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

static struct vec3 direction(unsigned *state)
{
    struct vec3 a = vec(random_in(state, -1, 1), random_in(state, -1, 1), 1);
    return vec_unit(a);
}

START_TEST(nearest_of_points)
{
    unsigned state = 17;
    struct vec3s points = {0};
    for (int i = 0; i < 5000; i++) {
        double x = random_in(&state, -40, 40), y = random_in(&state, -25, 25);
        *array_push(&points) = vec(x, y, 4 * sin(x / 6) + random_in(&state, -3, 0));
    }
    struct collision_body part = collision_body_points(points.item, points.n);
    for (int trial = 0; trial < 300; trial++) {
        struct vec3 c =
            vec(random_in(&state, -50, 50), random_in(&state, -30, 30), random_in(&state, -30, 30));
        struct holder_search search = {&stack, c, direction(&state), 12, -HUGE_VAL, {0, 0, 0}};
        double want = 12;
        for (size_t i = 0; i < points.n; i++)
            want = fmin(want, tool_shape_distance(&stack, c, search.axis, points.item[i]));
        collision_body_nearest(&part, &search);
        ck_assert_double_eq(search.distance, want);
        if (want < 12)
            ck_assert_double_eq(tool_shape_distance(&stack, c, search.axis, search.at), want);
    }
    collision_body_free(&part);
    array_free(&points);
}
END_TEST

/* The stock shrinks while it is looked at: a new look at all of it finds the same. */
START_TEST(nearest_of_a_stock_that_is_cut)
{
    unsigned state = 23;
    struct stock s = stock_box(vec(-20, -15, -20), vec(20, 15, 0), 0.5);
    struct collision_body block = collision_body_stock(&s);
    for (int trial = 0; trial < 60; trial++) {
        struct vec3 a =
            vec(random_in(&state, -25, 25), random_in(&state, -20, 20), random_in(&state, -8, 2));
        struct vec3 b = vec_add(a, vec(random_in(&state, -9, 9), random_in(&state, -9, 9), -2));
        stock_capsule(&s, a, b, 3, 1);
        struct vec3 axis = direction(&state);
        struct holder_search search = {&stack,   vec_along(b, 6, axis), axis, 12, -HUGE_VAL,
                                       {0, 0, 0}};
        struct holder_search again = search;
        collision_body_nearest(&block, &search);
        struct collision_body anew = collision_body_stock(&s);
        collision_body_nearest(&anew, &again);
        ck_assert_double_eq_tol(search.distance, again.distance, 0.5); /* steps down a wall */
        collision_body_free(&anew);
    }
    collision_body_free(&block);
    stock_free(&s);
}
END_TEST

/* A motion of straight pieces of the tip with these axes. */
static void go(struct nc_motion *motion, struct vec3 from, struct vec3 to, struct vec3 axis0,
               struct vec3 axis1)
{
    struct nc_piece piece = {
        .interpolation = AXIS_GREAT_CIRCLE, .p = {from, to}, .q = {axis0, axis1}};
    *array_push(&motion->piece) = piece;
}

/*
 * One spike beside the way.  Upright the shank, 2 thick, passes it by 1; in the third piece the
 * tool leans over it, and with its middle line about through the spike it goes on in the fourth.
 */
START_TEST(depth_in_a_turn)
{
    struct vec3 spike = vec(3, 0, 20), up = vec(0, 0, 1);
    double lean = atan2(3, 17); /* seen from the ball's centre */
    struct vec3 over = vec(sin(lean), 0, cos(lean));
    struct nc_motion motion = {0};
    go(&motion, vec(0, -20, 0), vec(0, 20, 0), up, up);
    go(&motion, vec(0, 20, 0), vec(0, 0, 0), up, up);
    struct vec3 tip = vec_along(vec(0, 0, 3), -3, over);
    go(&motion, vec(0, 0, 0), tip, up, over);
    go(&motion, tip, vec_add(tip, vec(0, 20, 0)), over, over);
    struct collision_body part = collision_body_points(&spike, 1);
    struct holder_collision found = {0};
    struct holder_collision_options options = {
        .motion = &motion, .tool = &stack, .body = &part, .radius = 3, .tolerance = 0.05};
    holder_collision_piece(&options, &found, 0);
    holder_collision_piece(&options, &found, 1);
    ck_assert_double_eq(found.depth, 0);
    ck_assert_uint_eq(found.pieces, 0);
    holder_collision_piece(&options, &found, 2);
    holder_collision_piece(&options, &found, 3);
    ck_assert_double_eq_tol(found.depth, 2, 0.2);
    ck_assert_uint_eq(found.pieces, 2);
    ck_assert_double_eq(found.at.z, 20);
    collision_body_free(&part);
    nc_motion_free(&motion);
}
END_TEST

/* A fence that one long piece goes through in its middle: found however long the piece is. */
START_TEST(depth_in_the_middle_of_a_long_piece)
{
    struct vec3 up = vec(0, 0, 1), spike = vec(0, 1.25, 10);
    struct nc_motion motion = {.track = NC_MOTION_CENTRE};
    go(&motion, vec(-500, 0, 0), vec(700, 0, 0), up, up);
    go(&motion, vec(700, 0, 0), vec(700, 0, 60), up, up);
    struct collision_body part = collision_body_points(&spike, 1);
    struct holder_collision found = {0};
    struct holder_collision_options options = {
        .motion = &motion, .tool = &stack, .body = &part, .radius = 3, .tolerance = 0.05};
    holder_collision_piece(&options, &found, 0);
    holder_collision_piece(&options, &found, 1);
    ck_assert_double_eq_tol(found.depth, 0.75, 0.0126);
    ck_assert_uint_eq(found.piece, 0);
    ck_assert_uint_eq(found.pieces, 1);
    collision_body_free(&part);
    nc_motion_free(&motion);
}
END_TEST

/* The least of the distances of all points along a piece, looked at closely. */
static double least_along(const struct nc_motion *motion, size_t piece, const struct vec3s *points)
{
    double least = HUGE_VAL;
    for (int k = 0; k <= 300; k++) {
        struct nc_motion_pose at = nc_motion_at(motion, &motion->piece.item[piece], k / 300.0);
        for (size_t i = 0; i < points->n; i++)
            least = fmin(least, tool_shape_distance(&stack, at.p, at.a, points->item[i]));
    }
    return least;
}

/* Where most pieces hit, those that do are counted, and the deepest is told within a tenth. */
START_TEST(most_pieces_hit)
{
    unsigned state = 31;
    struct vec3s points = {0};
    struct nc_motion motion = {.track = NC_MOTION_CENTRE};
    struct vec3 from = vec(0, 0, -10), axis = vec(0, 0, 1);
    size_t hit = 0, close = 0;
    double depth = 0;
    for (int i = 0; i < 120; i++) {
        struct vec3 p = vec(random_in(&state, -30, 30), random_in(&state, -30, 30), 0);
        p.z = 3 * sin(p.x / 5);
        *array_push(&points) = p;
    }
    struct collision_body part = collision_body_points(points.item, points.n);
    struct holder_collision found = {0};
    struct holder_collision_options options = {
        .motion = &motion, .tool = &stack, .body = &part, .radius = 3, .tolerance = 0.05};
    for (size_t i = 0; i < 100; i++) {
        struct vec3 to =
            vec(random_in(&state, -40, 40), random_in(&state, -40, 40), random_in(&state, -25, -5));
        struct vec3 turned = vec_unit(vec_along(axis, 0.1, direction(&state)));
        go(&motion, from, to, axis, turned);
        holder_collision_piece(&options, &found, i);
        double least = least_along(&motion, i, &points);
        hit += least < -0.05;
        close += fabs(least + 0.05) < 0.2; /* between two places looked at it may be as deep */
        depth = fmax(depth, -least);
        ck_assert_double_ge(found.depth, depth / 1.1 - 0.01);
        ck_assert_double_le(found.depth, depth + 0.2);
        from = to;
        axis = turned;
    }
    ck_assert_uint_gt(hit, 50);
    ck_assert_uint_lt(hit, 95);
    ck_assert_uint_ge(found.pieces, hit);
    ck_assert_uint_le(found.pieces, hit + close);
    struct nc_motion_pose last = nc_motion_at(&motion, &motion.piece.item[found.piece], 0.5);
    ck_assert(vec_distance(found.at, last.p) < 100 && found.at.z >= -3 && found.at.z <= 3);
    collision_body_free(&part);
    array_free(&points);
    nc_motion_free(&motion);
}
END_TEST

/* The tool goes down beside a wall of stock that a pass has left: the holder's cone meets it. */
START_TEST(holder_against_stock)
{
    struct vec3 up = vec(0, 0, 1);
    struct stock s = stock_box(vec(-30, -30, -60), vec(30, 30, 0), 0.5);
    struct collision_body block = collision_body_stock(&s);
    struct nc_motion motion = {.track = NC_MOTION_CENTRE};
    go(&motion, vec(0, 0, 10), vec(0, 0, -24), up, up);
    go(&motion, vec(0, 0, -24), vec(0, 0, -31), up, up);
    struct holder_collision found = {0};
    struct holder_collision_options options = {
        .motion = &motion, .tool = &stack, .body = &block, .radius = 3, .tolerance = 0.1};
    for (size_t i = 0; i < 2; i++) {
        stock_capsule(&s, motion.piece.item[i].p[0], motion.piece.item[i].p[1], 3, 1);
        holder_collision_piece(&options, &found, i);
        if (i == 0)
            ck_assert_double_eq(found.depth, 0);
    }
    ck_assert_double_eq_tol(found.depth, 1, 0.1); /* its lower face, 8 wide at 30 over the centre */
    ck_assert_uint_eq(found.piece, 1);
    collision_body_free(&block);
    stock_free(&s);
    nc_motion_free(&motion);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("holder_collision");
    TCase *tcase = tcase_create("holder_collision");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, nearest_of_points);
    tcase_add_test(tcase, nearest_of_a_stock_that_is_cut);
    tcase_add_test(tcase, depth_in_a_turn);
    tcase_add_test(tcase, depth_in_the_middle_of_a_long_piece);
    tcase_add_test(tcase, most_pieces_hit);
    tcase_add_test(tcase, holder_against_stock);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* path_check: a path over a block with a slot, whose rapid, link, cut or holder goes into it,
 * against depths known from the shapes; and a feed of nothing. */
#include "stage/path_check.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/cli.h"

static const double R = 3;

/* A floor at z = 0 for |x|, |y| <= 20 and a wall upright on it at x = 10, up to z = 15. */
static struct gouge_check *floor_and_wall(void)
{
    struct vec3s points = {0};
    for (int i = -80; i <= 80; i++) {
        for (int k = -80; k <= 80; k++)
            *array_push(&points) = vec(0.25 * i, 0.25 * k, 0);
        for (int k = 0; k <= 60; k++)
            *array_push(&points) = vec(10, 0.25 * i, 0.25 * k);
    }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

static struct path_check check_with(const struct gouge_check *guard)
{
    return (struct path_check){.tool = {.guard = guard,
                                        .radius = R,
                                        .tolerance = 0.01,
                                        .holder = {2, {{R, R, 8}, {6, 6, 20}}}},
                               .threads = 1};
}

static struct path_item *go(struct path *path, double x, double y, double z, bool rapid)
{
    return path_add_point(path, (struct pose){{x, y, z}, {0, 0, 1}}, rapid);
}

static void cut_to(struct path *path, double x, double y, double z)
{
    struct vec3 p = vec(x, y, z);
    path_set_contact(path, go(path, x, y, z, false), (struct contact){p, {0, 0, 1}});
}

/* Down beside the wall, along it at this x and z, and up. */
static struct path pass_along_wall(double x, double z)
{
    struct path path = {.name = "path"};
    path_add_pass(&path, 7);
    path_add_feed(&path, 800);
    go(&path, x, -15, 40, true);
    go(&path, x, -15, z + 5, false);
    cut_to(&path, x, -15, z);
    cut_to(&path, x, 15, z);
    go(&path, x, 15, 40, true);
    return path;
}

START_TEST(a_clear_pass_is_clear)
{
    struct gouge_check *guard = floor_and_wall();
    struct path path = pass_along_wall(3.9, 0);
    struct path_check check = check_with(guard);
    path_check_items(&check, &path, 0, path.item.n);
    for (int k = 0; k < 3; k++)
        ck_assert_uint_eq(check.deep[k].n, 0);
    ck_assert_int_eq(path_check_conclude(&check, NULL), EXIT_DONE);
    path_free(&path);
    gouge_free(guard);
}
END_TEST

START_TEST(ball_and_holder_in_a_cut_are_told_apart)
{
    struct gouge_check *guard = floor_and_wall();
    struct path low = pass_along_wall(3.9, -0.05), near = pass_along_wall(4.3, 0);
    for (int pieces = 1; pieces <= 3; pieces++) { /* as a stream comes */
        struct path_check check = check_with(guard), holder = check;
        for (int k = 0; k < pieces; k++) {
            size_t from = low.item.n * (size_t)k / (size_t)pieces;
            path_check_items(&check, &low, from, low.item.n * (size_t)(k + 1) / (size_t)pieces);
            path_check_items(&holder, &near, from, near.item.n * (size_t)(k + 1) / (size_t)pieces);
        }
        ck_assert_uint_eq(check.deep[MOTION_CUT].n, 1);
        ck_assert_uint_eq(check.deep[MOTION_CUT].pass, 7);
        ck_assert_double_eq_tol(check.deep[MOTION_CUT].deepest.depth, 0.05, 0.003);
        ck_assert_int_eq(check.deep[MOTION_CUT].deepest.part, TOOL_BALL);
        /* the holder begins 8 mm over the centre: 11 mm high, where the wall still is */
        ck_assert_uint_eq(holder.deep[MOTION_CUT].n, 1);
        ck_assert_double_eq_tol(holder.deep[MOTION_CUT].deepest.depth, 0.3, 0.03);
        ck_assert_int_eq(holder.deep[MOTION_CUT].deepest.part, TOOL_HOLDER);
        ck_assert_int_eq(path_check_conclude(&holder, NULL), EXIT_UNMET);
    }
    path_free(&low);
    path_free(&near);
    gouge_free(guard);
}
END_TEST

START_TEST(a_rapid_through_the_wall_is_the_shafts)
{
    struct gouge_check *guard = floor_and_wall();
    struct path path = pass_along_wall(0, 0);
    struct path_check check = check_with(guard);
    check.tool.holder.n = 1;
    go(&path, 0, 0, 14, true); /* ball above the wall's lower part, shaft from 17 up: over it all */
    go(&path, 18, 0, 14, true);
    path_check_items(&check, &path, 0, path.item.n);
    ck_assert_uint_eq(check.deep[MOTION_RAPID].n, 1);
    ck_assert_int_eq(check.deep[MOTION_RAPID].deepest.part, TOOL_BALL);
    ck_assert_double_eq_tol(check.deep[MOTION_RAPID].deepest.depth, 1,
                            0.01); /* tip at 14, 15 high */
    path_free(&path);
    path = pass_along_wall(0, 0);
    check = check_with(guard);
    check.tool.holder.n = 1;
    go(&path, 4, 0, 5, true);
    go(&path, 7.5, 0, 5, true); /* half a mm in the wall: the shaft as deep as the ball */
    path_check_items(&check, &path, 0, path.item.n);
    ck_assert_double_eq_tol(check.deep[MOTION_RAPID].deepest.depth, 0.5, 0.05);
    path_free(&path);
    gouge_free(guard);
}
END_TEST

START_TEST(a_feed_of_nothing_is_told)
{
    struct path path = pass_along_wall(0, 0);
    struct path_check check = {.threads = 1};
    path_add_feed(&path, 0.0001);
    go(&path, 1, 1, 50, false);
    path_check_items(&check, &path, 0, path.item.n);
    ck_assert_uint_eq(check.slow, 1);
    ck_assert_double_eq(check.slowest, 0.0001);
    ck_assert_int_eq(path_check_conclude(&check, NULL), EXIT_UNMET);
    path_free(&path);
}
END_TEST

/* A table whose C turns by 30 degrees to both sides of X: a cut, a feed motion and a rapid from the
 * one solution to the other, whose middle it does not have. */
START_TEST(an_axis_out_of_the_travel_on_the_way)
{
    const double travel = RADIANS(30), lean = 0.5, turn = RADIANS(25);
    struct path path = {.name = "path"};
    struct path_check check = {.threads = 1};

    check.chain = (struct kinematic_chain){.tool = {0, 0, 1}, .n = 2};
    check.chain.rotary[0] = (struct rotary){.axis = {0, 0, 1}, .min = -travel, .max = travel};
    check.chain.rotary[1] = (struct rotary){.axis = {0, 1, 0}, .min = -2, .max = 2};
    chain_measure(&check.chain);
    struct pose one = {.a = {sin(lean) * cos(turn), sin(lean) * sin(turn), cos(lean)}};
    struct pose other = {.p = {3, 0, 0}, .a = {-one.a.x, one.a.y, one.a.z}};
    path_add_pass(&path, 7);
    path_add_feed(&path, 800);
    path_add_point(&path, one, false);
    path_add_point(&path, other, true);
    path_check_items(&check, &path, 0, path.item.n);
    ck_assert_uint_eq(check.out, 0);
    path_add_point(&path, one, false);
    path_check_items(&check, &path, path.item.n - 1, path.item.n);
    ck_assert_uint_eq(check.out, 1);
    ck_assert_uint_eq(check.out_pass, 7);
    ck_assert_double_eq(check.out_at.a.x, one.a.x);
    ck_assert_int_eq(path_check_conclude(&check, NULL), EXIT_UNMET);
    path_free(&path);
}
END_TEST

/* Far below the part nobody knows what is there. */
START_TEST(below_the_floor)
{
    struct path path = {.name = "path"};
    struct path_check check = {.tool = {.radius = R}, .threads = 1, .floored = true, .floor = -30};

    path_add_pass(&path, 4);
    path_add_feed(&path, 800);
    go(&path, 0, 0, 10, true);
    go(&path, 0, 0, -30 - R, true);
    path_check_items(&check, &path, 0, path.item.n);
    ck_assert_uint_eq(check.low, 0);
    go(&path, 0, 0, -31 - R, true);
    go(&path, 0, 0, -33 - R, false);
    go(&path, 0, 0, -32 - R, false);
    path_check_items(&check, &path, path.item.n - 3, path.item.n);
    ck_assert_uint_eq(check.low, 3);
    ck_assert_double_eq_tol(check.lowest, -33, 1e-9);
    ck_assert_uint_eq(check.low_pass, 4);
    ck_assert_int_eq(path_check_conclude(&check, NULL), EXIT_UNMET);
    check.floored = false;
    check.low = 0;
    path_check_items(&check, &path, path.item.n - 3, path.item.n);
    ck_assert_int_eq(path_check_conclude(&check, NULL), EXIT_DONE);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_check");
    TCase *tests = tcase_create("path_check");
    tcase_add_test(tests, a_clear_pass_is_clear);
    tcase_add_test(tests, ball_and_holder_in_a_cut_are_told_apart);
    tcase_add_test(tests, a_rapid_through_the_wall_is_the_shafts);
    tcase_add_test(tests, a_feed_of_nothing_is_told);
    tcase_add_test(tests, an_axis_out_of_the_travel_on_the_way);
    tcase_add_test(tests, below_the_floor);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

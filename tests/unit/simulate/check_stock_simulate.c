/* check_stock_simulate - passes over a block: what each takes off and leaves, air, rapid moves. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/stock_simulate.h"

#define R 4.0

/* The ball's centre goes straight to a place; each block is a line of its own. */
static void go(struct nc_motion *motion, struct vec3 to, bool rapid)
{
    size_t n = motion->piece.n;
    struct vec3 from = n ? motion->piece.item[n - 1].p[1] : to, up = vec(0, 0, 1);
    struct nc_piece piece = {.interpolation = AXIS_GREAT_CIRCLE,
                             .rapid = rapid,
                             .block = (int)n + 1,
                             .line = n + 1,
                             .p = {from, to},
                             .q = {up, up}};
    *array_push(&motion->piece) = piece;
}

/* One pass along x at y, with its bottom at z: four blocks at feed, the first and last in air. */
static void pass(struct nc_motion *motion, double y, double z)
{
    go(motion, vec(-30, y, 20), true);
    go(motion, vec(-30, y, z + R), false);
    go(motion, vec(0, y, z + R), false);
    go(motion, vec(30, y, z + R), false);
    go(motion, vec(30, y, 20), false);
    go(motion, vec(30, y, 30), true);
}

/* Bottom of the block -10, its top 0, the part's points at -3. */
struct fixture {
    struct nc_motion motion;
    struct vec3s points;
    struct centre_path cut;
    struct stock stock;
    struct stock_rest left;
    struct stock_simulate run;
};

static void run(struct fixture *f, struct holder_collision_options *holder)
{
    for (int j = -19; j <= 19; j++)
        for (int i = -19; i <= 19; i++)
            *array_push(&f->points) = vec(i / 2.0, j / 2.0, -3);
    f->motion.track = NC_MOTION_CENTRE;
    centre_path_cut(&f->motion, &(struct centre_path_options){R, 0.001, NULL}, &f->cut);
    f->stock = stock_box(vec(-10, -10, -10), vec(10, 10, 0), 0.1);
    f->left = stock_rest_new(f->points.item, f->points.n, &f->stock);
    struct collision_body block = collision_body_stock(&f->stock);
    if (holder)
        holder->body = &block; // cppcheck-suppress autoVariables
    struct stock_simulate_options options = {&f->motion, &f->cut, R, 0.001, 0.01, holder};
    stock_simulate_run(&options, &f->stock, &f->left, &f->run);
    collision_body_free(&block);
}

static void end(struct fixture *f)
{
    stock_simulate_free(&f->run);
    stock_rest_free(&f->left);
    stock_free(&f->stock);
    array_free(&f->cut);
    array_free(&f->points);
    nc_motion_free(&f->motion);
}

static double segment_area(double depth)
{
    double up = R - depth;
    return R * R * acos(up / R) - up * sqrt(2 * R * depth - depth * depth);
}

START_TEST(passes_layer_by_layer)
{
    struct fixture f = {0};
    pass(&f.motion, 0, -1);
    pass(&f.motion, 0, -2.5);
    pass(&f.motion, 0, -2.5);
    run(&f, NULL);
    const struct stock_simulate_pass *p = f.run.pass.item;
    ck_assert_uint_eq(f.run.pass.n, 3);
    ck_assert_double_eq_tol(f.run.before, 4000, 1e-6);
    ck_assert_double_eq_tol(p[0].volume, 20 * segment_area(1), 0.05);
    ck_assert_double_eq_tol(p[0].volume + p[1].volume, 20 * segment_area(2.5), 0.2);
    ck_assert_double_eq(p[2].volume, 0);
    ck_assert_double_eq_tol(f.run.after, 4000 - p[0].volume - p[1].volume, 1e-6);
    ck_assert_double_eq_tol(p[0].bite, 1, 1e-3);
    ck_assert_double_eq_tol(p[1].bite, 1.5, 1e-3);
    ck_assert_double_eq_tol(fabs(p[1].bite_at.y), 0.05, 1e-9);
    ck_assert_uint_eq(p[0].blocks, 4);
    ck_assert_uint_eq(p[0].air, 2);
    ck_assert_uint_eq(p[2].air, 4);
    ck_assert_double_eq_tol(p[2].air_length, 2 * (20 - 1.5) + 60, 1e-9);
    ck_assert_uint_eq(p[1].first, 7);
    ck_assert_uint_eq(p[1].last, 10);
    ck_assert_double_eq_tol(p[0].left.worst, 3, 1e-6); /* beside the groove */
    ck_assert_double_eq_tol(p[1].left.worst, 3, 1e-6);
    ck_assert_double_eq(f.run.rapid, 0);
    end(&f);
}
END_TEST

/* All of the top off: what is left is the height of the cusps and less, by the formula. */
START_TEST(scallops)
{
    struct fixture f = {0};
    for (int k = -8; k <= 8; k++)
        pass(&f.motion, 1.5 * k, -3);
    run(&f, NULL);
    const struct stock_rest_sum *left = &f.run.pass.item[16].left;
    double cusp = R - sqrt(R * R - 0.75 * 0.75);
    double rows[4] = {0, R - sqrt(R * R - 0.25), R - sqrt(R * R - 0.25), 0};
    /* points lie 0, 0.5 and 1 beside a pass: on it, or 0.5 off one; none on the cusp */
    ck_assert_double_le(left->worst, cusp);
    ck_assert_double_eq_tol(left->worst, rows[1], 2e-3);
    ck_assert_double_eq_tol(left->part[0], rows[1], 2e-3);
    end(&f);
}
END_TEST

START_TEST(rapid_through_what_is_left)
{
    struct fixture f = {0};
    pass(&f.motion, 0, -2);
    go(&f.motion, vec(-30, 0, 30), true);
    go(&f.motion, vec(-30, 0, R - 2), true); /* in the groove: clear */
    go(&f.motion, vec(30, 0, R - 2), true);
    go(&f.motion, vec(30, 5, R - 1.5), true);
    go(&f.motion, vec(-30, 5, R - 1.5), true); /* beside it: through the stock */
    run(&f, NULL);
    ck_assert_double_eq_tol(f.run.rapid, 1.5, 1e-3);
    ck_assert_uint_eq(f.run.rapid_piece, 10);
    ck_assert_uint_eq(f.run.rapids, 1);
    end(&f);
}
END_TEST

/* The collar clears the groove that the pass before has cut, and not the wall beside it. */
START_TEST(holder_follows_the_stock)
{
    const struct tool_shape stack = {2, {{0, 5, 2, 2}, {5, 35, 6, 6}}};
    struct fixture f = {0};
    struct holder_collision_options holder = {
        .motion = &f.motion, .tool = &stack, .radius = R, .tolerance = 0.02};
    pass(&f.motion, 0, -3);
    pass(&f.motion, 0, -6);
    pass(&f.motion, 0, -8.5); /* its centre at -4.5, the collar from 0.5 up: clear */
    pass(&f.motion, 0, -9.5); /* from -0.5 up */
    run(&f, &holder);
    ck_assert_double_eq_tol(f.run.holder.depth, 0.5, 0.05);
    ck_assert_int_eq(f.motion.piece.item[f.run.holder.piece].block, 21);
    end(&f);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stock_simulate");
    TCase *tcase = tcase_create("stock_simulate");
    tcase_add_test(tcase, passes_layer_by_layer);
    tcase_add_test(tcase, scallops);
    tcase_add_test(tcase, rapid_through_what_is_left);
    tcase_add_test(tcase, holder_follows_the_stock);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/*
 * check_centre_path - segments of the ball's centre against the curve that it goes on: on a circle
 * by the sagitta of each, on the arc of a tool that turns about its tip, on a tool that stands.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/centre_path.h"
#include "math/elementary.h"

#define RADIUS 4.0
#define FLAT 0.001

static const struct vec3 up = {0, 0, 1}, ahead = {1, 0, 0};

static struct nc_motion one_piece(struct nc_piece piece)
{
    struct nc_motion m = {.track = NC_MOTION_TIP};
    *array_push(&m.arc) = (struct nc_motion_arc){{5, 7, 1}, {0, 0, 1}, 2 * PI};
    *array_push(&m.piece) = piece;
    return m;
}

/* Each segment begins where the last one ended, in place and in s, from 0 to 1. */
static void joins(const struct centre_path *path)
{
    ck_assert_uint_gt(path->n, 0);
    ck_assert(path->item[0].s[0] == 0 && path->item[path->n - 1].s[1] == 1);
    for (size_t i = 1; i < path->n; i++) {
        ck_assert(path->item[i].s[0] == path->item[i - 1].s[1]);
        ck_assert(vec_distance(path->item[i].a, path->item[i - 1].b) == 0);
    }
}

/* All ends lie on the circle of `radius` about c in the plane of `normal`; none of the chords is
 * farther off it than FLAT, and no more than twice as many as that takes. */
static void on_circle(const struct centre_path *path, struct vec3 c, struct vec3 normal,
                      double radius, double turn)
{
    double half = acos(1 - FLAT / radius); /* of the longest chord that is flat enough */
    joins(path);
    for (size_t i = 0; i < path->n; i++) {
        struct vec3 from = vec_sub(path->item[i].a, c), to = vec_sub(path->item[i].b, c);
        ck_assert_double_eq_tol(vec_length(from), radius, 1e-9);
        ck_assert_double_eq_tol(vec_dot(from, normal), 0, 1e-9);
        double cosine = vec_dot(from, to) / radius / radius;
        ck_assert_double_le(radius * (1 - sqrt((1 + cosine) / 2)), 1.01 * FLAT);
    }
    ck_assert_double_le((double)path->n, 2 * turn / (2 * half) + 8);
}

static const struct nc_piece full_turn = {.shape = SHAPE_ARC,
                                          .interpolation = AXIS_GREAT_CIRCLE,
                                          .p = {{15, 7, 1}, {15, 7, 1}},
                                          .q = {{0, 0, 1}, {0, 0, 1}}};

START_TEST(a_full_turn)
{
    struct nc_motion m = one_piece(full_turn);
    struct centre_path path = {0};
    centre_path_piece(&m, 0, &(struct centre_path_options){RADIUS, FLAT, NULL}, &path);
    on_circle(&path, vec(5, 7, 1 + RADIUS), up, 10, 2 * PI);
    array_free(&path);
    nc_motion_free(&m);
}
END_TEST

/* A circle of a kilometre about a part as large as a hand: near it as fine as ever. */
START_TEST(far_off_the_part)
{
    const double r = 1e6, near = 100;
    struct nc_motion m = one_piece(full_turn);
    struct box part = {{-near, -near, -near}, {near, near, near}};
    struct centre_path path = {0};
    m.track = NC_MOTION_CENTRE;
    m.arc.item[0].centre = vec(r, 0, 0);
    m.piece.item[0].p[0] = m.piece.item[0].p[1] = vec(2 * r, 0, 0);
    centre_path_piece(&m, 0, &(struct centre_path_options){RADIUS, FLAT, &part}, &path);
    joins(&path);
    ck_assert_uint_lt(path.n, 2000);
    for (size_t i = 0; i < path.n; i++) {
        struct vec3 middle = vec_mix(path.item[i].a, path.item[i].b, 0.5);
        if (vec_length(middle) < 5 * near)
            ck_assert_double_eq_tol(vec_distance(middle, vec(r, 0, 0)), r, FLAT);
    }
    array_free(&path);
    nc_motion_free(&m);
}
END_TEST

START_TEST(a_path_of_centres_is_not_raised)
{
    struct nc_motion m = one_piece(full_turn);
    struct centre_path path = {0};
    m.track = NC_MOTION_CENTRE;
    centre_path_piece(&m, 0, &(struct centre_path_options){RADIUS, FLAT, NULL}, &path);
    on_circle(&path, vec(5, 7, 1), up, 10, 2 * PI);
    array_free(&path);
    nc_motion_free(&m);
}
END_TEST

START_TEST(a_tool_that_turns_about_its_tip)
{
    struct nc_motion m = one_piece((struct nc_piece){.shape = SHAPE_LINE,
                                                     .interpolation = AXIS_GREAT_CIRCLE,
                                                     .p = {{1, 2, 3}, {1, 2, 3}},
                                                     .q = {up, ahead}});
    struct centre_path path = {0};
    centre_path_piece(&m, 0, &(struct centre_path_options){RADIUS, FLAT, NULL}, &path);
    on_circle(&path, vec(1, 2, 3), vec(0, 1, 0), RADIUS, PI / 2);
    ck_assert(vec_distance(path.item[0].a, vec(1, 2, 3 + RADIUS)) < 1e-12);
    ck_assert(vec_distance(path.item[path.n - 1].b, vec(1 + RADIUS, 2, 3)) < 1e-9);
    array_free(&path);
    nc_motion_free(&m);
}
END_TEST

/* Straight, with the axis as it is: one segment, of the kind that is asked for. */
START_TEST(cuts_and_rapids)
{
    struct nc_piece piece = {.shape = SHAPE_LINE,
                             .interpolation = AXIS_GREAT_CIRCLE,
                             .p = {{0, 0, 0}, {30, 0, 0}},
                             .q = {ahead, ahead}};
    struct nc_motion m = one_piece(piece);
    struct centre_path cut = {0}, rapid = {0};
    piece.rapid = true;
    piece.p[0] = piece.p[1];
    piece.p[1] = vec(30, 0, 50);
    *array_push(&m.piece) = piece;
    centre_path_cut(&m, &(struct centre_path_options){RADIUS, FLAT, NULL}, &cut);
    centre_path_rapid(&m, &(struct centre_path_options){RADIUS, FLAT, NULL}, &rapid);
    ck_assert_uint_eq(cut.n, 1);
    ck_assert_uint_eq(rapid.n, 1);
    ck_assert_uint_eq(cut.item[0].piece, 0);
    ck_assert_uint_eq(rapid.item[0].piece, 1);
    ck_assert(vec_distance(cut.item[0].b, vec(30 + RADIUS, 0, 0)) < 1e-12);
    ck_assert(vec_distance(rapid.item[0].b, vec(30 + RADIUS, 0, 50)) < 1e-12);
    array_free(&cut);
    array_free(&rapid);
    nc_motion_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("centre_path");
    TCase *tcase = tcase_create("centre_path");
    tcase_add_test(tcase, a_full_turn);
    tcase_add_test(tcase, far_off_the_part);
    tcase_add_test(tcase, a_path_of_centres_is_not_raised);
    tcase_add_test(tcase, a_tool_that_turns_about_its_tip);
    tcase_add_test(tcase, cuts_and_rapids);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

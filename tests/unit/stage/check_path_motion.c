/*
 * check_path_motion - a path as a motion that is evaluated by other formulas: each kind of item is
 * where the geometry says, at its ends and in the middle.
 */
#include <check.h>
#include <stdlib.h>

#include "stage/path_motion.h"
#include "math/elementary.h"

static const struct vec3 up = {0, 0, 1};

static struct pose at(double x, double y, double z)
{
    return (struct pose){{x, y, z}, up};
}

static struct nc_motion motion_of(const struct path *path)
{
    struct nc_motion motion;
    struct error error;
    ck_assert_int_eq(path_motion_of(path, &motion, &error), 0);
    return motion;
}

static void is_at(const struct nc_motion *m, size_t piece, double s, struct vec3 p, struct vec3 a)
{
    struct nc_motion_pose pose = nc_motion_at(m, &m->piece.item[piece], s);
    ck_assert_double_le(vec_distance(pose.p, p), 1e-9);
    ck_assert_double_le(vec_distance(pose.a, a), 1e-9);
}

START_TEST(points_and_feeds)
{
    struct path path = {.name = "p"};
    struct vec3 lean = vec(1, 0, 0);
    path_add_feed(&path, 300);
    path_add_point(&path, at(0, 0, 5), true);
    path_add_point(&path, at(0, 0, 1), false);
    path_add_feed(&path, 700);
    path_add_point(&path, (struct pose){{10, 0, 1}, lean}, false);
    struct nc_motion m = motion_of(&path);
    ck_assert_int_eq(m.track, NC_MOTION_TIP);
    ck_assert_uint_eq(m.piece.n, 3);
    ck_assert(m.piece.item[0].rapid && !m.piece.item[1].rapid);
    ck_assert_double_eq(m.piece.item[1].feed, 300);
    ck_assert_double_eq(m.piece.item[2].feed, 700);
    is_at(&m, 0, 0, vec(0, 0, 5), up); /* nothing is before the first */
    is_at(&m, 1, 0.25, vec(0, 0, 4), up);
    is_at(&m, 2, 0.5, vec(5, 0, 1), vec(sqrt(0.5), 0, sqrt(0.5)));
    nc_motion_free(&m);
    path_free(&path);
}
END_TEST

/* A quarter, three quarters and a full turn about the same axis, and the same upside down. */
START_TEST(arcs_by_the_right_hand_rule)
{
    for (int side = -1; side <= 1; side += 2) {
        struct path path = {.name = "p"};
        struct path_arc arc = {vec(1, 2, 3), vec(0, 0, side), 5};
        path_add_point(&path, at(6, 2, 3), false);
        path_add_arc(&path, at(1, 2 + 5 * side, 3), arc);
        path_add_arc(&path, at(6, 2, 3), arc);
        path_add_arc(&path, at(6, 2, 3), arc);
        struct nc_motion m = motion_of(&path);
        double half = sqrt(0.5) * 5;
        is_at(&m, 1, 0.5, vec(1 + half, 2 + half * side, 3), up);
        is_at(&m, 2, 0.5, vec(1 - half, 2 - half * side, 3), up);
        is_at(&m, 3, 0.5, vec(-4, 2, 3), up);
        is_at(&m, 3, 0.25, vec(1, 2 + 5 * side, 3), up);
        is_at(&m, 3, 1, vec(6, 2, 3), up);
        nc_motion_free(&m);
        path_free(&path);
    }
}
END_TEST

/* A Bezier curve of the third degree at 1/2: (p0 + 3 p1 + 3 p2 + p3) / 8; its head beside it. */
START_TEST(splines_with_their_heads)
{
    struct path path = {.name = "p", .head.track = TRACK_CENTRE};
    struct bspline b = bspline_new(3, 4, true);
    const struct vec3 pole[] = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 16}};
    for (int i = 0; i < 4; i++) {
        b.pole[i] = pole[i];
        b.head[i] = vec_along(pole[i], 10, up);
        b.knot[i] = 0;
        b.knot[4 + i] = 1;
    }
    b.length = 10;
    path_add_point(&path, at(0, 0, 0), false);
    path_add_spline(&path, at(0, 8, 16), (struct path_spline){.curve = b});
    path_add_point(&path, at(0, 18, 16), false);
    struct nc_motion m = motion_of(&path);
    ck_assert_int_eq(m.track, NC_MOTION_CENTRE);
    ck_assert_uint_eq(m.piece.n, 3);
    is_at(&m, 1, 0.5, vec(6, 4, 2), up);
    is_at(&m, 2, 0.5, vec(0, 13, 16), up);
    nc_motion_free(&m);
    path_free(&path);
}
END_TEST

START_TEST(contact_points_are_refused)
{
    struct path path = {.name = "p", .head.track = TRACK_CONTACT};
    struct nc_motion motion;
    struct error error;
    ck_assert_int_eq(path_motion_of(&path, &motion, &error), -1);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_motion");
    TCase *tcase = tcase_create("path_motion");
    tcase_add_test(tcase, points_and_feeds);
    tcase_add_test(tcase, arcs_by_the_right_hand_rule);
    tcase_add_test(tcase, splines_with_their_heads);
    tcase_add_test(tcase, contact_points_are_refused);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/*
 * post_arc: random arcs as words, read back by school geometry: the two ends as far from the
 * printed centre, the circle of a printed radius or of three points where the arc is, in mm and in
 * inches.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "post/post_arc.h"
#include "base/num.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

static struct vec3 printed(struct vec3 p, int digits)
{
    return vec(num_round(p.x, digits), num_round(p.y, digits), num_round(p.z, digits));
}

/* An arc about an axis, its ends as printed. */
struct trial {
    struct motion motion;
    struct block_pose from, to;
    double radius;
};

static struct trial random_arc(struct vec3 axis, double sweep, double unit, int digits)
{
    struct vec3 up = vec(0, 0, 1), across = vec_unit(vec_cross(axis, vec(0.3, 0.5, 0.8)));
    struct vec3 centre = vec_scale(1 / unit, vec(200 * chance() - 100, 100 * chance(), chance()));
    struct trial t = {.radius = (0.5 + 60 * chance()) / unit};
    struct vec3 arm = vec_turn(across, axis, 6 * chance());
    struct pose a = {vec_along(centre, t.radius, arm), up};
    struct pose b = {vec_along(centre, t.radius, vec_turn(arm, axis, sweep)), up};
    t.motion = motion_arc(a, b, centre, axis);
    t.from = (struct block_pose){.p = printed(a.p, digits), .a = up};
    t.to = (struct block_pose){.p = printed(b.p, digits), .a = up};
    return t;
}

static const struct {
    double unit;
    int digits;
} written[] = {{1, 3}, {1, 5}, {25.4, 4}};

/* I J K: what Fanuc and LinuxCNC check, on the printed digits; and the arc is where it was. */
START_TEST(centre_words)
{
    const struct vec3 normal[] = {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}};
    const int plane[] = {17, 18, 19, 17};
    double digit = pow(10, -written[_i].digits);
    struct interpolation f = {.mode = INTERPOLATE_VECTOR};
    seed = 5;
    for (int i = 0; i < 4000; i++) {
        struct trial t =
            random_arc(normal[i % 4], 0.05 + 6 * chance(), written[_i].unit, written[_i].digits);
        struct nc_arc arc;
        struct pose_deviation d;
        double point;
        ck_assert(nc_arc_words(&arc, NC_ARCS_CENTRE, written[_i].digits, 0.005 / written[_i].unit,
                               &f, &t.from, &t.to, &t.motion, 0, 1, &d, &point));
        ck_assert_double_lt(point, 20 * digit);
        ck_assert_int_eq(arc.plane, plane[i % 4]);
        ck_assert(arc.ccw == (i % 4 == 0 || i % 4 == 2));
        ck_assert_double_lt(vec_distance(printed(arc.centre, written[_i].digits), arc.centre),
                            1e-12);
        struct vec3 centre = vec_add(t.from.p, arc.centre);
        struct vec3 r0 = vec_reject(vec_sub(t.from.p, centre), normal[i % 4]);
        struct vec3 r1 = vec_reject(vec_sub(t.to.p, centre), normal[i % 4]);
        ck_assert_double_lt(fabs(vec_length(r0) - vec_length(r1)), 2 * digit);
        /* the middle of the printed arc, a turn of its start, is as far off as is said, or less */
        struct vec3 half = vec_turn(r0, normal[i % 4], t.motion.sweep / 2);
        struct vec3 wanted = motion_at(&t.motion, 0.5).p;
        struct vec3 off = vec_reject(vec_sub(vec_add(centre, half), wanted), normal[i % 4]);
        ck_assert_double_lt(vec_length(off), point + 3 * digit);
    }
}
END_TEST

/* Of a few last digits, the centre would be anywhere: no words, whichever way it is told. */
START_TEST(too_short)
{
    struct interpolation f = {.mode = INTERPOLATE_VECTOR};
    double digit = pow(10, -written[_i].digits);
    seed = 6;
    for (int i = 0; i < 1000; i++) {
        struct vec3 axis = vec(0, 0, i % 2 ? 1 : -1);
        struct trial t = random_arc(axis, 1, written[_i].unit, written[_i].digits);
        double sweep = 9 * chance() * digit / t.radius;
        struct vec3 arm = vec_sub(t.motion.from.p, t.motion.centre);
        t.motion.to.p = vec_add(t.motion.centre, vec_turn(arm, axis, sweep));
        t.motion = motion_arc(t.motion.from, t.motion.to, t.motion.centre, axis);
        t.to.p = printed(t.motion.to.p, written[_i].digits);
        struct nc_arc arc;
        struct pose_deviation d = {0, 0};
        double point = 0;
        for (int kind = NC_ARCS_FLAT; kind <= NC_ARCS_BOTH; kind++) {
            bool words =
                nc_arc_words(&arc, (enum nc_arcs)kind, written[_i].digits, 0.005 / written[_i].unit,
                             &f, &t.from, &t.to, &t.motion, 0, 1, &d, &point);
            ck_assert(!words || vec_distance(t.from.p, t.to.p) > 9.5 * digit);
        }
    }
}
END_TEST

/* R: the centre that the control finds lies on the bisector of the chord, on the side of the sign.
 */
START_TEST(radius_words)
{
    double digit = pow(10, -written[_i].digits);
    struct interpolation f = {.mode = INTERPOLATE_VECTOR};
    int made = 0;
    seed = 6;
    for (int i = 0; i < 2000; i++) {
        struct trial t = random_arc(vec(0, 0, i % 2 ? 1 : -1), 0.05 + 2 * chance(),
                                    written[_i].unit, written[_i].digits);
        struct nc_arc arc;
        struct pose_deviation d;
        double point;
        if (!nc_arc_words(&arc, NC_ARCS_RADIUS, written[_i].digits, 1, &f, &t.from, &t.to,
                          &t.motion, 0, 1, &d, &point))
            continue;
        made++;
        ck_assert_double_lt(point, 6 * digit);
        ck_assert_double_gt(arc.radius, 0); /* less than half a turn */
        ck_assert_double_eq_tol(arc.radius, t.radius, 0.51 * digit);
        struct vec3 chord = vec_sub(t.to.p, t.from.p);
        chord.z = 0;
        double half = vec_length(chord) / 2, high = sqrt(arc.radius * arc.radius - half * half);
        struct vec3 left = vec_unit(vec(-chord.y, chord.x, 0));
        struct vec3 centre = vec_along(vec_mix(t.from.p, t.to.p, 0.5), i % 2 ? high : -high, left);
        struct vec3 bulge = vec_along(centre, (i % 2 ? -1 : 1) * arc.radius, left);
        struct vec3 off = vec_sub(bulge, motion_at(&t.motion, 0.5).p);
        off.z = 0;
        ck_assert_double_lt(vec_length(off), point + 3 * digit);
    }
    ck_assert_int_gt(made, 1900);
}
END_TEST

/* Three points of CIP: the circle through them, by equal distances, is the arc within what is said;
 * points too near to a line are refused. */
START_TEST(space_words)
{
    double digit = pow(10, -written[_i].digits);
    struct interpolation f = {.mode = INTERPOLATE_VECTOR};
    seed = 7;
    for (int i = 0; i < 2000; i++) {
        struct vec3 axis = vec_unit(vec(chance() - 0.5, chance() - 0.5, chance() - 0.5));
        struct trial t = random_arc(axis, 0.3 + 2 * chance(), written[_i].unit, written[_i].digits);
        struct nc_arc arc;
        struct pose_deviation d;
        double point;
        if (!nc_arc_words(&arc, NC_ARCS_SPACE, written[_i].digits, 1, &f, &t.from, &t.to, &t.motion,
                          0, 1, &d, &point)) {
            /* the three points are within 20 of the last digits of a line */
            ck_assert_double_lt(t.radius * (1 - cos(t.motion.sweep / 2)), 22 * digit);
            continue;
        }
        ck_assert_double_lt(point, 6 * digit);
        ck_assert_int_eq(arc.plane, 0);
        struct vec3 centre = vec_add(t.from.p, arc.centre);
        double r = vec_distance(centre, t.from.p);
        ck_assert_double_lt(fabs(vec_distance(centre, arc.middle) - r), 1e-7 * r);
        ck_assert_double_lt(fabs(vec_distance(centre, t.to.p) - r), 1e-7 * r);
        for (int k = 1; k < 8; k++) {
            struct vec3 p = motion_at(&t.motion, k / 8.0).p;
            ck_assert_double_lt(fabs(vec_distance(centre, p) - r), point + 2 * digit);
        }
    }
    struct trial flat = random_arc(vec(0, 0, 1), 1e-4, 1, 3);
    struct nc_arc arc;
    struct pose_deviation d;
    double point;
    ck_assert(!nc_arc_words(&arc, NC_ARCS_SPACE, 3, 1, &f, &flat.from, &flat.to, &flat.motion, 0, 1,
                            &d, &point));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_arc");
    TCase *tests = tcase_create("words");
    enum { WRITTEN = sizeof written / sizeof *written };

    tcase_add_loop_test(tests, centre_words, 0, WRITTEN);
    tcase_add_loop_test(tests, too_short, 0, WRITTEN);
    tcase_add_loop_test(tests, radius_words, 0, WRITTEN);
    tcase_add_loop_test(tests, space_words, 0, WRITTEN);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* nc_motion: each shape against its own formula, written once more here. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "simulate/nc_motion.h"

static struct nc_motion motion;

static struct nc_piece line(struct vec3 a, struct vec3 b)
{
    return (struct nc_piece){.shape = SHAPE_LINE,
                             .interpolation = AXIS_GREAT_CIRCLE,
                             .p = {a, b},
                             .q = {vec(0, 0, 1), vec(0, 0, 1)}};
}

static void near_to(struct vec3 a, struct vec3 b)
{
    ck_assert_double_le(vec_distance(a, b), 1e-12);
}

/* The tip in proportion, the axis at an even rate from z to x; a tool that the control takes to be
 * longer is so much lower along its axis. */
START_TEST(lines)
{
    struct nc_piece p = line(vec(1, 2, 3), vec(5, -2, 3));
    p.q[1] = vec(1, 0, 0);
    for (int i = 0; i <= 8; i++) {
        double s = i / 8.0, turn = s * PI / 2;
        struct nc_motion_pose at = nc_motion_at(&motion, &p, s);
        near_to(at.p, vec(1 + 4 * s, 2 - 4 * s, 3));
        near_to(at.a, vec(sin(turn), 0, cos(turn)));
    }
    p.beyond = 0.5;
    near_to(nc_motion_at(&motion, &p, 1).p, vec(5.5, -2, 3));
}
END_TEST

/* Three quarters of a turn about a line along y; the radius and the height change evenly. */
START_TEST(arcs)
{
    const double r0 = 2, r1 = 3, rise = 4, angle = 1.5 * PI;
    *array_push(&motion.arc) = (struct nc_motion_arc){vec(1, 0, 1), vec(0, 1, 0), angle};
    struct nc_piece p = line(vec(1, 0, 1 + r0), vec(1 - r1, rise, 1));
    p.shape = SHAPE_ARC;
    for (int i = 0; i <= 12; i++) {
        double s = i / 12.0, t = s * angle, r = r0 + s * (r1 - r0);
        /* by the right-hand rule about y, z turns towards x */
        near_to(nc_motion_at(&motion, &p, s).p, vec(1 + r * sin(t), s * rise, 1 + r * cos(t)));
    }
    array_free(&motion.arc);
}
END_TEST

START_TEST(polynomials)
{
    struct nc_motion_polynomial sum = {.p = {{1, 0, 0}, {0, 2, 0}, {0, 0, -1}, {0}, {0.5, 0, 0}}};
    *array_push(&motion.polynomial) = sum;
    struct nc_piece p = line(vec(7, 8, 9), vec(8.5, 10, 8));
    p.shape = SHAPE_POLYNOMIAL;
    for (double s = 0; s <= 1; s += 0.125)
        near_to(nc_motion_at(&motion, &p, s).p,
                vec(7 + s + 0.5 * pow(s, 5), 8 + 2 * s * s, 9 - s * s * s));
    array_free(&motion.polynomial);
}
END_TEST

/* Half a circle as two rational quarters is a circle; each knot span of the spline is a piece, and
 * they follow each other. */
START_TEST(splines)
{
    enum { POLES = 5, ORDER = 3 };
    static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
    struct nc_motion_spline b = {.order = ORDER,
                                 .n = POLES,
                                 .knot = mem_alloc(POLES + ORDER, sizeof(double)),
                                 .p = mem_alloc(POLES, sizeof(struct vec3)),
                                 .weight = mem_alloc(POLES, sizeof(double))};
    const struct vec3 pole[] = {{2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {-2, 2, 0}, {-2, 0, 0}};
    for (int i = 0; i < POLES; i++) {
        b.p[i] = pole[i];
        b.weight[i] = i % 2 ? sqrt(0.5) : 1;
    }
    for (int i = 0; i < POLES + ORDER; i++)
        b.knot[i] = knots[i];
    struct nc_piece as = line(pole[0], pole[POLES - 1]);
    nc_motion_add_spline(&motion, b, &as);
    ck_assert_uint_eq(motion.piece.n, 2);
    for (size_t k = 0; k < 2; k++) {
        for (double s = 0; s <= 1; s += 0.1) {
            struct vec3 p = nc_motion_at(&motion, &motion.piece.item[k], s).p;
            ck_assert_double_eq_tol(hypot(p.x, p.y), 2, 1e-12);
            ck_assert(k == 0 ? p.x >= -1e-12 : p.x <= 1e-12);
        }
    }
    near_to(nc_motion_at(&motion, &motion.piece.item[0], 1).p, vec(0, 2, 0));
    near_to(nc_motion_at(&motion, &motion.piece.item[1], 0).p, vec(0, 2, 0));
    near_to(motion.piece.item[1].p[1], vec(-2, 0, 0));
    nc_motion_free(&motion);
    motion = (struct nc_motion){.name = NULL};
}
END_TEST

/* Moves of 10 m are as many as there are; longer ones are 100 m together, and the line of the first
 * one beyond that is told; an arc is as long as its chords. */
START_TEST(no_farther_than_a_machine_goes)
{
    struct nc_motion far = {.name = "far.nc"};
    struct error error = {.text = ""};
    for (size_t i = 0; i < 50; i++) {
        struct nc_piece p = line(vec(0, 0, 0), vec(0, 1e4, 0));
        p.line = i + 1;
        *array_push(&far.piece) = p;
    }
    ck_assert_int_eq(nc_motion_bounded(&far, &error), 0);
    for (size_t i = 10; i < 15; i++) /* 100 m to the last digit */
        far.piece.item[i].p[1].y = 2e4;
    ck_assert_int_eq(nc_motion_bounded(&far, &error), 0);
    far.piece.item[47].p[1].y = 10000.5;
    ck_assert_int_eq(nc_motion_bounded(&far, &error), -1);
    ck_assert_str_eq(error.text, "far.nc:48: found moves of more than 10 m, 110 m together, "
                                 "expected at most 100 m: no machine goes so far");
    far.piece.item[47].block = 480;
    ck_assert_int_eq(nc_motion_bounded(&far, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "far.nc:48: N480: found moves of more than 10 m"));

    /* half a turn of 40 m about z, in the place of all lines: 4 chords of 30.6 m */
    far.piece.n = 0;
    *array_push(&far.arc) = (struct nc_motion_arc){vec(0, 0, 0), vec(0, 0, 1), PI};
    struct nc_piece half = line(vec(40000, 0, 0), vec(-40000, 0, 0));
    half.shape = SHAPE_ARC;
    half.line = 7;
    *array_push(&far.piece) = half;
    ck_assert_int_eq(nc_motion_bounded(&far, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "far.nc:7: found moves of more than 10 m, 122 m"));
    nc_motion_free(&far);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("nc_motion");
    TCase *tests = tcase_create("nc_motion");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, lines);
    tcase_add_test(tests, no_farther_than_a_machine_goes);
    tcase_add_test(tests, arcs);
    tcase_add_test(tests, polynomials);
    tcase_add_test(tests, splines);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

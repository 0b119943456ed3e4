/* motion: lines, arcs and B-splines against points, angles and lengths that are known. */
#include <check.h>
#include <stdlib.h>

#include "curve/motion.h"

static const struct vec3 up = {0, 0, 1};

START_TEST(line)
{
    struct pose from = {vec(0, 0, 0), up}, to = {vec(3, 4, 0), vec(1, 0, 0)};
    struct motion m = motion_line(from, to);
    struct pose mid = motion_at(&m, 0.5);
    ck_assert_double_eq_tol(motion_length(&m), 5, 1e-12);
    ck_assert_double_lt(vec_distance(mid.p, vec(1.5, 2, 0)), 1e-12);
    ck_assert_double_lt(vec_distance(mid.a, vec(sqrt(0.5), 0, sqrt(0.5))), 1e-12);
    ck_assert_double_eq(motion_next_knot(&m, 0), 1);
}
END_TEST

START_TEST(arc)
{
    struct pose from = {vec(11, 2, 3), up}, to = {vec(1, 12, 3), vec(0, 1, 0)};
    struct motion m = motion_arc(from, to, vec(1, 2, 3), up);
    ck_assert_double_eq_tol(m.sweep, PI / 2, 1e-12);
    ck_assert_double_eq_tol(motion_length(&m), 5 * PI, 1e-12);
    struct pose at = motion_at(&m, 1. / 3);
    ck_assert_double_lt(vec_distance(at.p, vec(1 + 10 * cos(PI / 6), 2 + 5, 3)), 1e-12);
    ck_assert_double_lt(vec_distance(at.a, vec(0, 0.5, sqrt(0.75))), 1e-12);
    /* the other way round the axis it is three quarters */
    m = motion_arc(from, to, vec(1, 2, 3), vec(0, 0, -1));
    ck_assert_double_eq_tol(m.sweep, 1.5 * PI, 1e-12);
    /* start = end: the full circle */
    m = motion_arc(from, from, vec(1, 2, 3), up);
    ck_assert_double_eq_tol(m.sweep, 2 * PI, 1e-12);
    ck_assert_double_lt(vec_distance(motion_at(&m, 0.5).p, vec(-9, 2, 3)), 1e-12);
    ck_assert_double_eq_tol(motion_length(&m), 20 * PI, 1e-12);
}
END_TEST

START_TEST(arc_off_its_circle)
{
    struct pose from = {vec(10, 0, 0), up}, to = {vec(0, 10.008, 0.006), up};
    struct motion m = motion_arc(from, to, vec(0, 0, 0), up);
    ck_assert_double_eq(motion_at(&m, 1).p.y, 10.008);
    struct vec3 mid = motion_at(&m, 0.5).p;
    ck_assert_double_eq_tol(hypot(mid.x, mid.y), 10.004, 1e-12);
    ck_assert_double_eq_tol(mid.z, 0.003, 1e-12);
}
END_TEST

/* A cubic with its poles on a line at equal distances is that line at constant speed. */
START_TEST(spline)
{
    struct bspline b = bspline_new(3, 5, true);
    const double knot[] = {0, 0, 0, 0, 15, 30, 30, 30, 30}, x[] = {0, 5, 15, 25, 30};
    b.length = 100;
    for (size_t i = 0; i < 9; i++)
        b.knot[i] = knot[i];
    for (size_t i = 0; i < 5; i++) {
        b.pole[i] = vec(x[i], 1, 2);
        b.head[i] = vec(x[i], 1, 102);
    }
    struct pose from = {b.pole[0], up}, to = {b.pole[4], up};
    struct motion m = motion_spline(from, to, &b);
    ck_assert_double_eq_tol(motion_length(&m), 30, 1e-9);
    ck_assert_double_lt(vec_distance(motion_at(&m, 0.25).p, vec(7.5, 1, 2)), 1e-12);
    ck_assert_double_lt(vec_distance(motion_at(&m, 0.25).a, up), 1e-12);
    ck_assert_double_eq_tol(motion_next_knot(&m, 0), 0.5, 1e-12);
    ck_assert_double_eq(motion_next_knot(&m, 0.5), 1);
    bspline_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("motion");
    TCase *tests = tcase_create("motions");

    tcase_add_test(tests, line);
    tcase_add_test(tests, arc);
    tcase_add_test(tests, arc_off_its_circle);
    tcase_add_test(tests, spline);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* post_even: what goes out of an even course and back in one block each does so in three, along the
 * same way; row ends, bends and paths of others stay as they are. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "curve/motion.h"
#include "math/elementary.h"
#include "post/post_even.h"

static struct pose upright(double x, double y)
{
    return (struct pose){vec(x, y, 0), vec(0, 0, 1)};
}

static struct path own_path(void)
{
    struct path path = {0};
    path.head.cutter_n = 2;
    path.head.cutter[0] = 6;
    path.head.cutter[1] = 3;
    path_spend(&path, "meshnorm", 0.01);
    return path;
}

static void go(struct path *path, double x, double y)
{
    path_add_point(path, upright(x, y), false);
}

/* To the place where the course is left, there, back, and on. */
static void begin(struct path *path)
{
    path_add_point(path, upright(0, 0), true);
    go(path, 5, 0);
}

static void end(struct path *path)
{
    go(path, 14, 0);
    go(path, 20, 0);
}

START_TEST(lines)
{
    for (int own = 0; own < 2; own++) {
        struct path path = own_path();
        path.head.ledger.n = own ? 1 : 0;
        begin(&path);
        go(&path, 7, 3);
        go(&path, 9.5, 0);
        end(&path);
        ck_assert_uint_eq(post_even(&path), (size_t)own);
        ck_assert_uint_eq(path.item.n, 6 + (size_t)own);
        struct vec3 half = path.item.item[3].to.p; /* of the longer one of the two */
        if (own)
            ck_assert_double_le(vec_distance(half, vec(8.25, 1.5, 0)), 1e-12);
        ck_assert_uint_eq(post_even(&path), 0);
        path.head.ledger.n = 1;
        path_free(&path);
    }
}
END_TEST

START_TEST(an_arc)
{
    struct path path = own_path();
    begin(&path);
    path_add_arc(&path, upright(8, 3), (struct path_arc){vec(8, 0, 0), vec(0, 0, -1), 3});
    go(&path, 8.5, 0.3);
    end(&path);
    ck_assert_uint_eq(post_even(&path), 1);
    ck_assert_uint_eq(path.item.n, 7);
    ck_assert(path.item.item[2].kind == PATH_ARC && path.item.item[3].kind == PATH_ARC);
    ck_assert_uint_ne(path.item.item[2].index, path.item.item[3].index);
    double c = 3 * sqrt(0.5);
    ck_assert_double_le(vec_distance(path.item.item[2].to.p, vec(8 - c, c, 0)), 1e-12);
    path_free(&path);
}
END_TEST

START_TEST(a_span)
{
    const double at[4][2] = {{5, 0}, {5.5, 1.5}, {6, 2.5}, {7, 3}};
    struct path path = own_path();
    begin(&path);
    struct bspline curve = bspline_new(3, 4, false);
    for (size_t i = 0; i < 4; i++) {
        curve.pole[i] = vec(at[i][0], at[i][1], 0);
        curve.knot[i] = 0;
        curve.knot[4 + i] = 2;
    }
    struct bspline before = bspline_copy(&curve);
    path_add_spline(&path, upright(7, 3), (struct path_spline){.curve = curve});
    go(&path, 9, 0);
    end(&path);
    ck_assert_uint_eq(post_even(&path), 1);
    const struct bspline *after = &path.spline.item[0].curve;
    ck_assert_uint_eq(path.item.n, 6);
    ck_assert_uint_eq(after->poles, 5);
    for (double u = 0; u <= 2; u += 0.125)
        ck_assert_double_le(
            vec_distance(bspline_at(&before, before.pole, u), bspline_at(after, after->pole, u)),
            1e-12);
    ck_assert_uint_eq(post_even(&path), 0);
    bspline_free(&before);
    path_free(&path);
}
END_TEST

START_TEST(the_axis)
{
    struct path path = own_path();
    begin(&path);
    path_add_point(&path, (struct pose){vec(7, 0, 0), vec(sin(0.08), 0, cos(0.08))}, false);
    go(&path, 10, 0);
    end(&path);
    ck_assert_uint_eq(post_even(&path), 1);
    struct pose half = path.item.item[3].to; /* from there back */
    ck_assert_double_le(vec_angle(half.a, vec(sin(0.04), 0, cos(0.04))), 1e-9);
    path_free(&path);
}
END_TEST

START_TEST(what_stays)
{
    struct path path = own_path();
    begin(&path);
    for (double y = 0; y < 5; y += 1) { /* rows */
        go(&path, fmod(y, 2) > 0.5 ? 0 : 20, y);
        go(&path, fmod(y, 2) > 0.5 ? 0 : 20, y + 1);
    }
    ck_assert_uint_eq(post_even(&path), 0);
    path_add_point(&path, upright(0, 9), true);
    for (double x = 1; x < 30; x += 1)
        go(&path, x, 9 + 2 * sin(x)); /* bends, in steps that are no faults */
    ck_assert_uint_eq(post_even(&path), 0);
    path_add_point(&path, upright(40, 9), true); /* at rapid */
    go(&path, 45, 9);
    path_add_point(&path, upright(47, 12), true);
    go(&path, 49, 9);
    go(&path, 59, 9);
    ck_assert_uint_eq(post_even(&path), 0);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_even");
    TCase *tests = tcase_create("post_even");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, lines);
    tcase_add_test(tests, an_arc);
    tcase_add_test(tests, a_span);
    tcase_add_test(tests, the_axis);
    tcase_add_test(tests, what_stays);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

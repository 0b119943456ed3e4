/*
 * flatten, against the curve itself at many places between the vertices: the chord error that was
 * asked for is kept, at the tracked point and at the other one.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "curve/bspline.h"
#include "curve/flatten.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

static struct bspline random_motion(int degree, size_t poles)
{
    struct bspline b = bspline_new(degree, poles, true);
    size_t p = (size_t)degree;

    b.length = 100;
    for (size_t i = 0; i < poles + p + 1; i++)
        b.knot[i] = i <= p ? 0 : b.knot[i - 1] + (i > poles ? 0 : 1 + 5 * chance());
    for (size_t i = 0; i < poles; i++) {
        double x = 3 * (double)i + chance(), y = 4 * chance(), z = 4 * chance();
        b.pole[i] = vec(x, y, z);
        double tilt = 60 * chance(), lean = 60 * chance();
        b.head[i] = vec_add(b.pole[i], vec(tilt, lean, 90));
    }
    return b;
}

static double off_segment(struct vec3 q, struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(b, a);
    double l2 = vec_dot(d, d), t = l2 > 0 ? vec_dot(vec_sub(q, a), d) / l2 : 0;

    return vec_distance(q, vec_along(a, fmin(1, fmax(0, t)), d));
}

START_TEST(chords_are_kept)
{
    seed = 12;
    for (int turn = 0; turn < 60; turn++) {
        int degree = 1 + turn % 5;
        struct bspline b = random_motion(degree, (size_t)degree + 1 + (size_t)(10 * chance()));
        double offset = turn % 3 == 0 ? -8 : 8, chord = turn % 2 == 0 ? 0.01 : 0.0003, worst = 0;
        struct flat flat = {0};

        ck_assert(flatten(&b, offset, vec(0, 0, 1), chord, &flat));
        ck_assert(flat.u.n == flat.point.n && flat.u.n == flat.other.n && flat.u.n == flat.axis.n);
        ck_assert(flat.u.item[0] == 0 && flat.u.item[flat.u.n - 1] == b.knot[b.poles]);
        for (size_t i = 0; i + 1 < flat.u.n; i++)
            for (int k = 0; k <= 8; k++) {
                double u = flat.u.item[i] + (flat.u.item[i + 1] - flat.u.item[i]) * k / 8;
                struct vec3 p = bspline_at(&b, b.pole, u);
                struct vec3 axis = vec_unit(vec_sub(bspline_at(&b, b.head, u), p));
                struct vec3 other = vec_along(p, offset, axis);
                const struct vec3 *a = &flat.point.item[i], *o = &flat.other.item[i];
                double off = fmax(off_segment(p, a[0], a[1]), off_segment(other, o[0], o[1]));
                ck_assert_double_le(off, chord);
                worst = fmax(worst, off);
            }
        if (degree > 1)
            ck_assert_double_gt(worst, chord / 100); /* and not by far too many pieces */
        flat_free(&flat);
        bspline_free(&b);
    }
}
END_TEST

START_TEST(what_can_not_be_flattened)
{
    struct flat flat = {0};
    struct bspline b;

    seed = 13;
    b = random_motion(3, 8);
    b.pole[4].y = NAN;
    ck_assert(!flatten(&b, 8, vec(0, 0, 1), 0.01, &flat));
    b.pole[4].y = 1e12; /* too many pieces */
    ck_assert(!flatten(&b, 8, vec(0, 0, 1), 0.01, &flat));
    bspline_free(&b);
    b = random_motion(3, 8);
    for (int i = 2; i < 6; i++)
        b.head[i] = vec_add(b.pole[i], vec(0, 0, 20)); /* the head comes too near */
    ck_assert(!flatten(&b, 8, vec(0, 0, 1), 0.01, &flat));
    bspline_free(&b);
    flat_free(&flat);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("flatten");
    TCase *tests = tcase_create("flatten");

    tcase_add_test(tests, chords_are_kept);
    tcase_add_test(tests, what_can_not_be_flattened);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

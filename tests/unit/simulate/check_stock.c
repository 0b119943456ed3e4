/* check_stock - a ball that cuts a block, against grooves and holes whose size is known. */
#include <check.h>
#include <stdlib.h>

#include "simulate/stock_rest.h"
#include "seed.h"

/* Area of the part of a disc that lies deeper than radius - depth. */
static double segment_area(double radius, double depth)
{
    double up = radius - depth;
    return radius * radius * acos(up / radius) - up * sqrt(2 * radius * depth - depth * depth);
}

START_TEST(a_straight_groove)
{
    struct stock s = stock_box(vec(0, -10, -5), vec(30, 10, 2), 0.1);
    struct vec3 a = vec(-6, 1.03, 4.5), b = vec(36, 1.03, 4.5); /* 1.5 deep with R 4 */
    double before = stock_volume(&s);
    ck_assert_double_eq_tol(before, 30 * 20 * 7, 1e-6);
    struct stock_bite bite = stock_capsule(&s, a, b, 4, 1);
    double want = 30 * segment_area(4, 1.5);
    ck_assert_double_eq_tol(bite.volume, want, 2e-4 * want);
    ck_assert_double_eq_tol(before - stock_volume(&s), bite.volume, 1e-6);
    ck_assert_double_eq_tol(bite.depth, 1.5, 1e-3);
    for (int j = 0; j < s.ny; j++) {
        double y = stock_y(&s, j) - 1.03, w2 = 16 - y * y;
        double top = w2 > 0 ? fmin(2, 4.5 - sqrt(w2)) : 2;
        ck_assert_double_eq_tol(stock_at(&s, 50, j)->high, top, 1e-12);
    }
    bite = stock_capsule(&s, b, a, 4, 2); /* once more: air */
    ck_assert_double_eq(bite.volume, 0);
    stock_free(&s);
}
END_TEST

/* Two grooves a step apart: a cusp is left between them; together the tops are the lower of both.
 */
START_TEST(overlapping_passes)
{
    struct stock s = stock_box(vec(0, -8, -5), vec(10, 8, 3), 0.05);
    double step = 2, radius = 5, both = 0;
    for (int k = 0; k < 3; k++) {
        double y = (k - 1) * step;
        both += stock_capsule(&s, vec(-6, y, 5), vec(16, y, 5), radius, (unsigned)k + 1).volume;
    }
    for (int j = 0; j < s.ny; j++) {
        double y = stock_y(&s, j), top = 3;
        for (int k = -1; k <= 1; k++)
            if (fabs(y - k * step) < radius)
                top = fmin(top, 5 - sqrt(radius * radius - (y - k * step) * (y - k * step)));
        ck_assert_double_eq_tol(stock_at(&s, 3, j)->high, top, 1e-12);
    }
    double end = 10 * (segment_area(5, 3) + 2 * step * 3); /* a step wider for each pass more ... */
    double cusp = 2 * radius * asin(0.5 * step / radius) * radius; /* ... but for the cusps */
    cusp = 2 * 10 * (radius * step - 0.5 * cusp - 0.5 * step * sqrt(25 - 1));
    ck_assert_double_eq_tol(both, end - cusp, 1e-3 * end);
    stock_free(&s);
}
END_TEST

/* The ball, its centre going down to z = 1: a hole with a round bottom. */
START_TEST(a_plunge)
{
    struct stock s = stock_box(vec(-6, -6, -6), vec(6, 6, 4), 0.05);
    struct stock_bite bite = stock_capsule(&s, vec(0, 0, 9), vec(0, 0, 1), 4, 1);
    double want = PI * 16 * 3 + 2.0 / 3 * PI * 64;
    ck_assert_double_eq_tol(bite.volume, want, 1e-3 * want);
    ck_assert_double_eq_tol(bite.depth, 7, 0.01);
    stock_free(&s);
}
END_TEST

/* Deep below the top a roof stays above the groove. */
START_TEST(a_roof_stays)
{
    struct stock s = stock_box(vec(0, -6, -10), vec(10, 6, 10), 0.1);
    double volume = stock_capsule(&s, vec(-5, 0, 0), vec(15, 0, 0), 3, 1).volume;
    const struct stock_column *c = stock_at(&s, 40, s.ny / 2);
    double w = sqrt(9 - stock_y(&s, s.ny / 2) * stock_y(&s, s.ny / 2));
    ck_assert_double_eq_tol(volume, 10 * PI * 9, 0.3);
    ck_assert_double_eq(c->high, 10);
    ck_assert_double_eq_tol(c->low, w, 1e-12);
    ck_assert_int_ne(c->more, STOCK_NONE);
    ck_assert_double_eq_tol(s.more.item[c->more].high, -w, 1e-12);
    ck_assert_double_eq_tol(stock_above(&s, c, -20), 20 - 2 * w, 1e-12);
    ck_assert_double_eq_tol(stock_above(&s, c, 5), 5, 1e-12);
    /* the roof comes off, then all the rest */
    stock_capsule(&s, vec(-5, 0, 6), vec(15, 0, 6), 5, 2);
    ck_assert_double_eq_tol(stock_at(&s, 40, s.ny / 2)->high, -w, 1e-12);
    stock_capsule(&s, vec(-50, 0, 0), vec(50, 0, 0), 40, 3);
    ck_assert_double_eq(stock_volume(&s), 0);
    stock_free(&s);
}
END_TEST

/* Any capsule: each column as if balls close to each other had cut it. */
START_TEST(as_many_balls)
{
    unsigned state = 3;
    for (int trial = 0; trial < 40; trial++) {
        double r[6];
        for (int k = 0; k < 6; k++) {
            state = state * 1664525u + seed_step_32();
            r[k] = (state >> 8) / 16777216.0 * 8 - 4;
        }
        struct vec3 a = vec(r[0], r[1], r[2]), b = vec(r[3], r[4], r[5]);
        b = trial % 4 == 0 ? vec(a.x, a.y, b.z) : trial % 4 == 1 ? vec(b.x, b.y, a.z) : b;
        struct stock s = stock_box(vec(-6, -6, -9), vec(6, 6, 9), 0.7);
        struct stock t = stock_box(vec(-6, -6, -9), vec(6, 6, 9), 0.7);
        stock_capsule(&s, a, b, 2.5, 1);
        for (int k = 0; k <= 4000; k++) {
            struct vec3 c = vec_mix(a, b, k / 4000.0);
            stock_capsule(&t, c, c, 2.5, 1);
        }
        for (int k = 0; k < s.nx * s.ny; k++) {
            double one = stock_above(&s, &s.column[k], -9),
                   many = stock_above(&t, &t.column[k], -9);
            ck_assert_double_ge(many, one - 1e-9);
            ck_assert_double_le(many, one + 0.25); /* at the rim balls reach less far */
        }
        ck_assert_double_eq_tol(stock_volume(&s), stock_volume(&t), 1e-2);
        stock_free(&s);
        stock_free(&t);
    }
}
END_TEST

/* In pieces that go on from each other it takes the same as in one. */
START_TEST(pieces_go_on)
{
    struct vec3 way[6] = {{-5, -2, 3}, {-1, -1, 1.5}, {0, 0, 1}, {2, 3, 0.5}, {2, 3, 2}, {6, 0, 2}};
    struct stock s = stock_box(vec(-6, -6, -6), vec(6, 6, 2), 0.1);
    struct stock t = stock_box(vec(-6, -6, -6), vec(6, 6, 2), 0.1);
    double sum = 0;
    for (int k = 0; k < 5; k++) {
        sum += stock_capsule(&s, way[k], way[k + 1], 2, 1).volume;
        stock_capsule(&t, way[k], way[k + 1], 2, 1);
    }
    ck_assert_double_eq_tol(sum, 12 * 12 * 8 - stock_volume(&s), 1e-6);
    ck_assert_double_eq_tol(stock_volume(&s), stock_volume(&t), 1e-9);
    stock_free(&s);
    stock_free(&t);
}
END_TEST

/* What is only looked at stays; a bite adds up over the blocks of a pass, not over passes. */
START_TEST(looking_and_adding_up)
{
    struct stock s = stock_box(vec(0, -5, -5), vec(10, 5, 0), 0.1);
    struct vec3 a = vec(-5, 0, 2), b = vec(15, 0, 2), down = vec(0, 0, -1);
    double volume = stock_volume(&s);
    ck_assert_double_eq_tol(stock_capsule(&s, a, b, 3, 0).depth, 1, 1e-3);
    ck_assert_double_eq(stock_volume(&s), volume);
    stock_capsule(&s, a, b, 3, 1);
    a = vec_add(a, down);
    b = vec_add(b, down);
    ck_assert_double_eq_tol(stock_capsule(&s, a, b, 3, 1).depth, 2, 1e-3);
    a = vec_add(a, down);
    b = vec_add(b, down);
    ck_assert_double_eq_tol(stock_capsule(&s, a, b, 3, 2).depth, 1, 1e-3);
    stock_free(&s);
}
END_TEST

/* What stands on a point below a round flank is its distance from that, in all cells up to those at
 * the border. */
START_TEST(rest_up_to_the_border)
{
    struct stock s = stock_box(vec(0, 0, -8), vec(10, 10, 4), 0.1);
    stock_capsule(&s, vec(12, -9, 5), vec(12, 19, 5), 6, 1);
    for (int k = 0; k < 40; k++) {
        double x = 7.5 + 2.43 * k / 39; /* cut down to 5 - sqrt(36 - (x - 12)^2) there */
        double turn = atan2(-sqrt(36 - (x - 12) * (x - 12)), x - 12);
        struct vec3 p = vec(12 + 6.5 * cos(turn), 5, 5 + 6.5 * sin(turn));
        /* half a mm under it; the cells are 0.1 wide: a chord of them is off by 0.1^2 / 8 / 6 in
         * the normal, and steeper than 45 degrees not by more than twice that along z */
        if (p.x > 6)
            ck_assert_double_eq_tol(stock_rest_at(&s, p), 0.5, 2e-3);
        p = vec(12 + 5.9 * cos(turn), 5, 5 + 5.9 * sin(turn));
        ck_assert_double_eq(stock_rest_at(&s, p), 0);
    }
    stock_free(&s);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stock");
    TCase *tcase = tcase_create("stock");
    tcase_add_test(tcase, a_straight_groove);
    tcase_add_test(tcase, overlapping_passes);
    tcase_add_test(tcase, a_plunge);
    tcase_add_test(tcase, a_roof_stays);
    tcase_add_test(tcase, as_many_balls);
    tcase_add_test(tcase, pieces_go_on);
    tcase_add_test(tcase, rest_up_to_the_border);
    tcase_add_test(tcase, looking_and_adding_up);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* Tests of rest_chain: strips from point to point, over points whose places are known. */
#include "toolpath/rest_chain.h"

#include <check.h>
#include <stdlib.h>

static const double GAP = 4, BESIDE = 0.5;

static struct contacts points;
static struct rest_strips strips;

static void teardown(void)
{
    array_free(&points);
    rest_strips_free(&strips);
    points = (struct contacts){0};
    strips = (struct rest_strips){0};
}

static void add(double x, double y, struct vec3 n)
{
    *array_push(&points) = (struct contact){vec(x, y, 0), n};
}

/* Every point is on a strip, or beside one; none of a strip is further from the one before than the
 * gap, and none has two neighbours that do not face the same way. */
static void hold(void)
{
    for (size_t i = 0; i < points.n; i++) {
        double least = HUGE_VAL;
        for (size_t k = 0; k < strips.n; k++) {
            const struct contacts *c = &strips.item[k].contact;
            for (size_t m = 0; m < c->n; m++)
                least = fmin(least, vec_segment_distance(c->item[m > 0 ? m - 1 : 0].p, c->item[m].p,
                                                         points.item[i].p));
        }
        ck_assert_double_le(least, BESIDE);
    }
    for (size_t k = 0; k < strips.n; k++) {
        const struct contacts *c = &strips.item[k].contact;
        ck_assert_uint_gt(c->n, 0);
        ck_assert_double_eq_tol(vec_length(strips.item[k].planes), 1, 1e-9);
        for (size_t m = 1; m < c->n; m++) {
            struct vec3 way = vec_sub(c->item[m].p, c->item[m - 1].p);
            ck_assert_double_le(vec_length(way), GAP);
            ck_assert_double_gt(vec_dot(c->item[m].n, c->item[m - 1].n), 0.5);
        }
    }
}

/* Points 3 apart on a bow, given from its middle and in no order. */
START_TEST(one_strip_to_both_sides)
{
    const int order[] = {4, 1, 7, 0, 3, 8, 5, 2, 6};

    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        double angle = order[i] * 0.15;
        add(20 * cos(angle), 20 * sin(angle), vec(0, 0, 1));
    }
    rest_chain_points(&points, GAP, BESIDE, &strips);
    hold();
    ck_assert_uint_eq(strips.n, 1);
    ck_assert_uint_ge(strips.item[0].contact.n, points.n / 2);
    ck_assert_double_lt(
        fabs(vec_distance(strips.item[0].contact.item[0].p,
                          strips.item[0].contact.item[strips.item[0].contact.n - 1].p) -
             40 * sin(0.6)),
        1e-9);
}
END_TEST

/* What lies beside the line is cut by it; what lies further off is a strip of its own. */
START_TEST(what_lies_beside_is_cut)
{
    add(0, 0, vec(0, 0, 1));
    add(2, 0, vec(0, 0, 1));
    add(1, 0.4, vec(0, 0, 1));
    add(2.2, -0.45, vec(0, 0, 1));
    add(10, 10, vec(0, 0, 1));
    rest_chain_points(&points, GAP, BESIDE, &strips);
    hold();
    ck_assert_uint_eq(strips.n, 2);
}
END_TEST

/* The two sides of a wall are not one strip, however near. */
START_TEST(not_round_an_edge)
{
    for (int i = 0; i < 6; i++)
        add(i, 0, i % 2 ? vec(0, 1, 0) : vec(0, -1, 0));
    rest_chain_points(&points, GAP, BESIDE, &strips);
    hold();
    ck_assert_uint_eq(strips.n, 2);
}
END_TEST

/* A field of points: fewer strips than there are rows of it on planes across, and all is cut. */
START_TEST(many_points)
{
    for (int i = 0; i < 20; i++)
        for (int k = 0; k < 20; k++)
            add(0.9 * i + 0.2 * (k % 3), 0.9 * k + 0.2 * (i % 4), vec(0, 0, 1));
    rest_chain_points(&points, GAP, BESIDE, &strips);
    hold();
    ck_assert_uint_lt(strips.n, points.n / 4);
}
END_TEST

START_TEST(none)
{
    rest_chain_points(&points, GAP, BESIDE, &strips);
    ck_assert_uint_eq(strips.n, 0);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("rest_chain");
    tcase_add_checked_fixture(t, NULL, teardown);
    tcase_add_test(t, one_strip_to_both_sides);
    tcase_add_test(t, what_lies_beside_is_cut);
    tcase_add_test(t, not_round_an_edge);
    tcase_add_test(t, many_points);
    tcase_add_test(t, none);
    Suite *s = suite_create("rest_chain");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

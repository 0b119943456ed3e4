/* Tests of arc.h against circles written down by hand, and by properties of random arcs. */
#include "curve/arc.h"

#include <check.h>
#include <stdlib.h>
#include "seed.h"

static double random_unit(unsigned *seed)
{
    *seed = *seed * 1664525u + seed_step_32();
    return (double)(*seed >> 8) / (1 << 24) * 2 - 1;
}

static struct vec3 random_vec(unsigned *seed)
{
    double x = random_unit(seed), y = random_unit(seed);
    return vec(x, y, random_unit(seed));
}

/* A piece of no length has no direction, and what goes on from it no plane. */
START_TEST(without_a_tangent)
{
    struct vec3 from = vec(1, 2, 3), none = arc_line(from, from).tangent;
    struct arc arc = arc_to(from, none, vec(1.001, 2, 3));

    ck_assert(arc_straight(&arc) && arc.to.x == 1.001);
}
END_TEST

START_TEST(quarter_circle)
{
    struct arc a = arc_to(vec(1, 0, 5), vec(0, 1, 0), vec(-1, 2, 5));
    ck_assert_double_eq_tol(a.radius, 2, 1e-14);
    ck_assert_double_eq_tol(a.angle, PI / 2, 1e-14);
    ck_assert_double_lt(vec_distance(arc_centre(&a), vec(-1, 0, 5)), 1e-14);
    ck_assert_double_lt(vec_distance(arc_axis(&a), vec(0, 0, 1)), 1e-14);
    ck_assert_double_eq_tol(arc_length(&a), PI, 1e-14);
    double h = sqrt(0.5);
    ck_assert_double_lt(vec_distance(arc_at(&a, 0.5), vec(-1 + 2 * h, 2 * h, 5)), 1e-14);
    ck_assert_double_lt(vec_distance(arc_tangent(&a, 0.5), vec(-h, h, 0)), 1e-14);
    ck_assert_double_lt(vec_distance(arc_tangent(&a, 1), vec(-1, 0, 0)), 1e-14);
    ck_assert_double_eq_tol(arc_foot(&a, vec(-1 + h, h, 9)), 0.5, 1e-14);
    ck_assert_double_eq(arc_foot(&a, vec(3, -1, 5)), 0);
    ck_assert_double_eq(arc_foot(&a, vec(-5, 1, 5)), 1);
}
END_TEST

START_TEST(more_than_half_a_circle)
{
    struct arc a = arc_to(vec(1, 0, 0), vec(0, 1, 0), vec(0, -1, 0));
    ck_assert_double_eq_tol(a.angle, 1.5 * PI, 1e-14);
    ck_assert_double_lt(vec_distance(arc_at(&a, 2.0 / 3), vec(-1, 0, 0)), 1e-14);
}
END_TEST

START_TEST(straight_lines)
{
    struct arc a = arc_to(vec(1, 2, 3), vec(0, 0, 1), vec(1, 2, 13));
    ck_assert(arc_straight(&a));
    ck_assert_double_eq(arc_length(&a), 10);
    ck_assert_double_lt(vec_distance(arc_at(&a, 0.25), vec(1, 2, 5.5)), 1e-14);
    /* a sagitta just below 1e-6 mm is a line, just above is none */
    a = arc_to(vec(0, 0, 0), vec_unit(vec(1, 1.9e-6 * 2, 0)), vec(1, 0, 0));
    ck_assert(arc_straight(&a));
    a = arc_to(vec(0, 0, 0), vec_unit(vec(1, 2.1e-6 * 2, 0)), vec(1, 0, 0));
    ck_assert(!arc_straight(&a));
    struct arc none = arc_to(vec(1, 1, 1), vec(1, 0, 0), vec(1, 1, 1));
    ck_assert(arc_straight(&none));
    ck_assert_double_eq(arc_foot(&none, vec(5, 5, 5)), 0);
}
END_TEST

START_TEST(random_arcs_end_where_they_should)
{
    unsigned seed = 7;
    for (int i = 0; i < 2000; i++) {
        struct vec3 from = random_vec(&seed), to = random_vec(&seed);
        struct vec3 t = vec_unit(random_vec(&seed));
        struct arc a = arc_to(from, t, to);
        if (arc_straight(&a))
            continue;
        double small = 1e-12 * (1 + a.radius);
        ck_assert_double_lt(vec_distance(arc_at(&a, 1), to), small);
        struct vec3 centre = arc_centre(&a);
        for (int k = 0; k <= 4; k++) {
            struct vec3 p = arc_at(&a, k / 4.0);
            ck_assert_double_lt(fabs(vec_distance(p, centre) - a.radius), small);
            ck_assert_double_lt(fabs(arc_foot(&a, p) - k / 4.0), 1e-6);
            double turn = vec_dot(arc_tangent(&a, k / 4.0), vec_sub(p, centre));
            ck_assert_double_lt(fabs(turn), small);
        }
        struct arc back = arc_about(from, to, centre, arc_axis(&a));
        ck_assert_double_lt(fabs(back.angle - a.angle), 1e-6);
        ck_assert_double_lt(vec_distance(arc_at(&back, 0.5), arc_at(&a, 0.5)), 1e-6);
    }
}
END_TEST

START_TEST(tangents_stay_units_along_a_long_chain)
{
    unsigned seed = 3;
    struct vec3 p = vec(0, 0, 0), t = vec(1, 0, 0);
    for (int i = 0; i < 1000; i++) {
        struct vec3 to = vec(i + 1, 0.01 * random_unit(&seed), 0.01 * random_unit(&seed));
        struct arc a = arc_to(p, t, to);
        ck_assert_double_lt(fabs(vec_length(a.tangent) - 1), 1e-12);
        ck_assert_double_lt(vec_distance(arc_at(&a, 1), to), 1e-9);
        p = to;
        t = arc_tangent(&a, 1);
    }
}
END_TEST

START_TEST(read_back_arcs_meet_their_ends)
{
    struct arc full = arc_about(vec(3, 0, 0), vec(3, 0, 0), vec(0, 0, 0), vec(0, 0, -1));
    ck_assert_double_eq(full.angle, 2 * PI);
    ck_assert_double_lt(vec_distance(arc_at(&full, 0.25), vec(0, -3, 0)), 1e-14);
    struct arc off = arc_about(vec(3, 0, 0), vec(0, 3.01, 0.02), vec(0, 0, 0), vec(0, 0, 1));
    ck_assert_double_lt(vec_distance(arc_at(&off, 1), vec(0, 3.01, 0.02)), 1e-14);
    ck_assert_double_lt(vec_distance(arc_at(&off, 0), vec(3, 0, 0)), 1e-14);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arc");
    tcase_add_test(t, without_a_tangent);
    tcase_add_test(t, quarter_circle);
    tcase_add_test(t, more_than_half_a_circle);
    tcase_add_test(t, straight_lines);
    tcase_add_test(t, random_arcs_end_where_they_should);
    tcase_add_test(t, tangents_stay_units_along_a_long_chain);
    tcase_add_test(t, read_back_arcs_meet_their_ends);
    Suite *s = suite_create("arc");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

/* Tests of biarc.h: against the equations of paper 1's appendix A, which each biarc has to solve.
 */
#include "curve/biarc.h"

#include <check.h>
#include <stdlib.h>
#include "seed.h"

static double random_unit(unsigned *seed)
{
    *seed = *seed * 1664525u + seed_step_32();
    return (double)(*seed >> 8) / (1 << 24) * 2 - 1;
}

static struct vec3 random_vec(unsigned *seed, double size)
{
    double x = size * random_unit(seed), y = size * random_unit(seed);
    return vec(x, y, size * random_unit(seed));
}

/* Two ends with tangents that go roughly from the one to the other. */
static void random_ends(unsigned *seed, struct vec3 p[2], struct vec3 t[2])
{
    p[0] = vec(0, 0, 0);
    p[1] = vec_add(vec(4, 0, 0), random_vec(seed, 1));
    for (int i = 0; i < 2; i++)
        t[i] = vec_unit(vec_add(vec(1, 0, 0), random_vec(seed, 0.5)));
}

/* A.2 to A.4, common tangents, and both arcs on their ends. */
static void assert_biarc(const struct biarc *b, const struct vec3 p[2], const struct vec3 t[2])
{
    struct vec3 first = vec_scale(b->a, vec_add(t[0], b->t2));
    struct vec3 second = vec_scale(b->b, vec_add(b->t2, t[1]));
    ck_assert_double_lt(fabs(vec_length(b->t2) - 1), 1e-12);
    ck_assert_double_lt(vec_distance(vec_add(p[0], first), b->joint), 1e-11);
    ck_assert_double_lt(vec_distance(vec_add(b->joint, second), p[1]), 1e-11);
    ck_assert_double_lt(vec_distance(arc_at(&b->first, 1), b->joint), 1e-11);
    ck_assert_double_lt(vec_distance(arc_at(&b->second, 1), p[1]), 1e-11);
    if (!arc_straight(&b->first))
        ck_assert_double_lt(vec_distance(arc_tangent(&b->first, 1), b->t2), 1e-7);
    if (!arc_straight(&b->second))
        ck_assert_double_lt(vec_distance(arc_tangent(&b->second, 1), t[1]), 1e-7);
}

/*
 * The curvatures of its arcs by the formulas of paper 1, 3.4, 1/mm:
 *   k1 = |t1 x s - b t1 x t3| / (s^2 / 2 - b s . t3)
 *   k2 = |s x t3 - a t1 x t3| / (s^2 / 2 - a s . t1)
 */
static void curvatures_by_formula(const struct biarc *biarc, struct vec3 t3, double *first,
                                  double *second)
{
    struct vec3 t1 = biarc->first.tangent, s = vec_sub(biarc->second.to, biarc->first.from);
    struct vec3 across = vec_cross(t1, t3);
    double half = vec_dot(s, s) / 2;
    *first = vec_length(vec_along(vec_cross(t1, s), -biarc->b, across)) /
             (half - biarc->b * vec_dot(s, t3));
    *second = vec_length(vec_along(vec_cross(s, t3), -biarc->a, across)) /
              (half - biarc->a * vec_dot(s, t1));
}

/* S type: it turns one way and then the other; else C type. */
static bool is_of_type_s(const struct biarc *biarc)
{
    if (arc_straight(&biarc->first) || arc_straight(&biarc->second))
        return false;
    struct vec3 end = vec_sub(arc_centre(&biarc->first), biarc->joint);
    return vec_dot(end, biarc->second.inward) < 0;
}

START_TEST(every_ratio_makes_a_biarc)
{
    unsigned seed = 11;
    struct vec3 p[2], t[2];
    for (int i = 0; i < 500; i++) {
        random_ends(&seed, p, t);
        for (double ratio = 0.1; ratio < 11; ratio *= 1.7) {
            struct biarc b;
            ck_assert(biarc_of_ratio(p[0], t[0], p[1], t[1], ratio, &b));
            ck_assert_double_lt(fabs(b.a / b.b - ratio), 1e-9 * ratio);
            assert_biarc(&b, p, t);
        }
    }
}
END_TEST

START_TEST(the_shortest_has_the_least_legs)
{
    unsigned seed = 5;
    struct vec3 p[2], t[2];
    int found = 0;
    for (int i = 0; i < 500; i++) {
        random_ends(&seed, p, t);
        struct biarc b, other;
        if (!biarc_shortest(p[0], t[0], p[1], t[1], &b))
            continue;
        found++;
        assert_biarc(&b, p, t);
        for (double by = 0.98; by < 1.03; by += 0.04) {
            ck_assert(biarc_of_ratio(p[0], t[0], p[1], t[1], by * b.a / b.b, &other));
            ck_assert_double_ge(other.a + other.b, b.a + b.b - 1e-12);
        }
    }
    ck_assert_int_gt(found, 50);
}
END_TEST

START_TEST(curvatures_by_the_paper_are_those_of_the_arcs)
{
    unsigned seed = 23;
    struct vec3 p[2], t[2];
    for (int i = 0; i < 500; i++) {
        random_ends(&seed, p, t);
        struct biarc b;
        double k1, k2;
        ck_assert(biarc_of_ratio(p[0], t[0], p[1], t[1], 0.7, &b));
        if (arc_straight(&b.first) || arc_straight(&b.second))
            continue;
        curvatures_by_formula(&b, t[1], &k1, &k2);
        ck_assert_double_lt(fabs(k1 - 1 / b.first.radius), 1e-9);
        ck_assert_double_lt(fabs(k2 - 1 / b.second.radius), 1e-9);
    }
}
END_TEST

START_TEST(a_circle_is_a_biarc_of_type_c)
{
    struct biarc b;
    ck_assert(biarc_shortest(vec(1, 0, 0), vec(0, 1, 0), vec(0, 1, 0), vec(-1, 0, 0), &b));
    ck_assert_double_eq_tol(b.first.radius, 1, 1e-12);
    ck_assert_double_eq_tol(b.second.radius, 1, 1e-12);
    ck_assert(!is_of_type_s(&b));
}
END_TEST

START_TEST(a_step_aside_is_of_type_s)
{
    struct biarc b;
    ck_assert(biarc_shortest(vec(0, 0, 0), vec(1, 0, 0), vec(4, 1, 0), vec(1, 0, 0), &b));
    ck_assert_double_lt(vec_distance(b.joint, vec(2, 0.5, 0)), 1e-12);
    ck_assert(is_of_type_s(&b));
}
END_TEST

START_TEST(what_is_no_biarc_is_refused)
{
    struct biarc b;
    ck_assert(!biarc_of_ratio(vec(1, 1, 1), vec(1, 0, 0), vec(1, 1, 1), vec(1, 0, 0), 1, &b));
    ck_assert(!biarc_shortest(vec(1, 1, 1), vec(1, 0, 0), vec(1, 1, 1), vec(0, 1, 0), &b));
    /* the chord itself as the first tangent: the paper's b is negative, a loop */
    ck_assert(
        !biarc_shortest(vec(0, 0, 0), vec(1, 0, 0), vec(1, 0, 0), vec(cos(0.2), sin(0.2), 0), &b));
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("biarc");
    tcase_add_test(t, every_ratio_makes_a_biarc);
    tcase_add_test(t, the_shortest_has_the_least_legs);
    tcase_add_test(t, curvatures_by_the_paper_are_those_of_the_arcs);
    tcase_add_test(t, a_circle_is_a_biarc_of_type_c);
    tcase_add_test(t, a_step_aside_is_of_type_s);
    tcase_add_test(t, what_is_no_biarc_is_refused);
    Suite *s = suite_create("biarc");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

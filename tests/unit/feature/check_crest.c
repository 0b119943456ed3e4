/* crest: edges over a rib or a groove get a point on it, others none. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "ribs.h"

/* Edges 0.6 mm long across the crest at several places; nearly half of the rib is off their
 * middle. */
static void crosses(double high, double noise)
{
    struct vec3s p = rib_cloud(high, noise);
    struct kdtree *tree = kdtree_new(p.item, p.n);
    struct feature_cloud cloud = {.tree = tree, .point = p.item, .spacing = 0.2, .noise = noise};
    for (int i = -5; i <= 5; i++) {
        double y = 0.6 * i, x = -y * RIB_SIN / RIB_COS, part = 0.5 + 0.05 * i;
        struct vec3 a = rib_point(high, x - 0.6 * part, y);
        struct vec3 b = rib_point(high, x + 0.6 * (1 - part), y);
        struct crest c = crest_find(&cloud, a, b);
        ck_assert_int_ge(c.n, 1);
        ck_assert_int_ge(c.top, 0);
        ck_assert_double_le(fabs(rib_off(c.place[c.top])), noise > 0 ? 0.15 : 0.1);
        ck_assert_double_le(fabs(c.place[c.top].z - high), 0.02 + noise);
        ck_assert_double_ge(vec_dot(c.normal[c.top], vec(0, 0, 1)), 0.96);
        for (int k = 0; k < c.n; k++)
            ck_assert_double_eq_tol(c.place[k].y, y, 0.05);
    }
    kdtree_free(tree);
    array_free(&p);
}

START_TEST(ribs)
{
    crosses(0.8, 0);
    crosses(0.8, 0.02);
}
END_TEST

START_TEST(grooves)
{
    crosses(-0.8, 0);
    crosses(-0.8, 0.02);
}
END_TEST

/* An edge five times as long as the rib is wide gets its feet too: points on the surface that leave
 * less than 0.15 mm between them. */
START_TEST(a_long_edge)
{
    struct vec3s p = rib_cloud(0.8, 0);
    struct kdtree *tree = kdtree_new(p.item, p.n);
    struct feature_cloud cloud = {.tree = tree, .point = p.item, .spacing = 0.2};
    struct vec3 a = rib_point(0.8, -2, 0.3), b = rib_point(0.8, 2, 0.3);
    struct crest c = crest_find(&cloud, a, b);
    ck_assert_int_ge(c.n, 3);
    for (int k = 0; k <= c.n; k++) {
        struct vec3 from = k > 0 ? c.place[k - 1] : a, to = k < c.n ? c.place[k] : b;
        for (double s = 0; s <= 1; s += 0.1) {
            struct vec3 q = vec_mix(from, to, s);
            ck_assert_double_le(fabs(q.z - rib_point(0.8, q.x, q.y).z), 0.15);
        }
    }
    kdtree_free(tree);
    array_free(&p);
}
END_TEST

/* Along the crest, beside it, and on a ball of 5 mm radius. */
START_TEST(nothing_there)
{
    struct vec3s p = rib_cloud(0.8, 0.02), ball = {0};
    struct kdtree *tree = kdtree_new(p.item, p.n);
    struct feature_cloud cloud = {.tree = tree, .point = p.item, .spacing = 0.2, .noise = 0.02};
    struct vec3 at = rib_point(0.8, 0, 0), on = rib_point(0.8, -0.6 * RIB_SIN, 0.6 * RIB_COS);
    ck_assert_int_eq(crest_find(&cloud, at, on).n, 0);
    ck_assert_int_eq(crest_find(&cloud, vec(2, 2, 0), vec(2.6, 2, 0)).n, 0);
    kdtree_free(tree);
    for (int i = 0; i < 2500; i++) {
        double x = 6 * uniform() - 3, y = 6 * uniform() - 3;
        *array_push(&ball) = vec(x, y, sqrt(25 - x * x - y * y));
    }
    tree = kdtree_new(ball.item, ball.n);
    cloud = (struct feature_cloud){.tree = tree, .point = ball.item, .spacing = 0.12};
    ck_assert_int_eq(crest_find(&cloud, vec(-0.3, 0, 4.991), vec(0.3, 0, 4.991)).n, 0);
    kdtree_free(tree);
    array_free(&p);
    array_free(&ball);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("crest");
    TCase *tests = tcase_create("crest");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, ribs);
    tcase_add_test(tests, grooves);
    tcase_add_test(tests, a_long_edge);
    tcase_add_test(tests, nothing_there);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

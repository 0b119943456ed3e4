/* surface_contacts: on the arch z = -x^2 / 20, over which a ball's centre has a known place. */
#include "stage/surface_contacts.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "curve/run.h"

static const double BALL = 1.5, OFF = 0.0025;

static double across[] = {0, 0, 1, 1}, along[] = {0, 0, 0, 1, 1, 1};
static struct nurbs_pole poles[] = {{-10, 0, -5, 1}, {0, 0, 5, 1}, {10, 0, -5, 1},
                                    {-10, 9, -5, 1}, {0, 9, 5, 1}, {10, 9, -5, 1}};

static struct patch arch(void)
{
    struct nurbs_axis u = {2, 3, along, 0, 1}, v = {1, 2, across, 0, 1};

    return (struct patch){.surface = {u, v, poles}};
}

static struct contact contact_at(double x, double above)
{
    struct vec3 n = vec_unit(vec(x / 10, 0, 1));

    return (struct contact){vec_along(vec(x, 5, -x * x / 20), above, n), n};
}

static void chain_through(struct slice_chains *chains, const double *x, size_t n, double above)
{
    size_t from = chains->point.n;

    for (size_t i = 0; i < n; i++)
        *array_push(&chains->point) = contact_at(x[i], above);
    slice_chains_end(chains, from, false);
}

static size_t put(struct slice_chains *chains)
{
    struct patch patch = arch();
    struct patches patches = {.n = 1, .item = &patch};
    struct projection *on = project_new(&patches, 0.01);
    struct surface_contacts rule = {
        .on = on, .plane = vec(0, 1, 0), .reach = 3, .radius = BALL, .off = OFF, .threads = 2};
    size_t beside = surface_contacts_put(&rule, chains);

    project_free(on);
    return beside;
}

/* How far the smooth curve of the centres of a chain is off the arch at most, mm. */
static double curve_off(const struct slice_chains *chains, size_t k)
{
    struct run run = {.radius = BALL}, dense = {.radius = BALL};
    double worst = 0;

    for (size_t i = chains->chain.item[k].from; i < chains->chain.item[k].to; i++) {
        struct contact c = chains->point.item[i];
        struct vec3 ball = vec_along(c.p, BALL, c.n);
        *array_push(&run) =
            (struct run_point){.tip = ball, .ball = ball, .contact = c.p, .normal = c.n};
    }
    run_densify(&run, 1e-4, &dense);
    for (size_t i = 0; i < dense.n; i++) {
        double x = dense.item[i].ball.x;
        for (int step = 0; step < 50; step++) /* the foot: x + BALL n.x is the ball's */
            x += dense.item[i].ball.x - contact_at(x, BALL).p.x;
        worst = fmax(worst, vec_distance(dense.item[i].ball, contact_at(x, BALL).p));
    }
    array_free(&run);
    array_free(&dense);
    return worst;
}

START_TEST(the_curve_between_far_contacts_is_on_the_surface)
{
    const double x[] = {-9, -2, -1.8, 6, 9};
    struct slice_chains chains = {0};

    chain_through(&chains, x, 5, 0);
    ck_assert_double_gt(curve_off(&chains, 0), 20 * OFF);
    ck_assert_uint_eq(put(&chains), 0);
    ck_assert_double_le(curve_off(&chains, 0), 2 * OFF);
    ck_assert_uint_eq(chains.chain.n, 1);
    ck_assert_uint_gt(chains.point.n, 5);
    ck_assert_uint_le(chains.point.n, 40);
    slice_chains_free(&chains);
}
END_TEST

START_TEST(where_the_curve_is_right_none_are_added)
{
    double x[60];
    struct slice_chains chains = {0};

    for (int i = 0; i < 60; i++)
        x[i] = -8.85 + 0.3 * i;
    chain_through(&chains, x, 60, 0.1);
    ck_assert_uint_eq(put(&chains), 0);
    ck_assert_uint_eq(chains.point.n, 60);
    for (size_t i = 0; i < 60; i++) {
        struct vec3 p = chains.point.item[i].p;
        ck_assert_double_eq_tol(p.z, -p.x * p.x / 20, 1e-6);
    }
    slice_chains_free(&chains);
}
END_TEST

/* Three contacts far above it: nothing is put beside them; the second chain is as it would be. */
START_TEST(what_has_no_surface_stays)
{
    const double x[] = {-8, 0, 8};
    struct slice_chains chains = {0};

    chain_through(&chains, x, 3, 4);
    chain_through(&chains, x, 3, 0);
    ck_assert_uint_eq(put(&chains), 3);
    ck_assert_uint_eq(chains.chain.item[0].to, 3);
    for (size_t i = 0; i < 3; i++)
        ck_assert_double_eq(vec_distance(chains.point.item[i].p, contact_at(x[i], 4).p), 0);
    ck_assert_uint_eq(chains.chain.item[1].from, 3);
    ck_assert_uint_gt(chains.chain.item[1].to, 6);
    ck_assert_uint_eq(chains.chain.item[1].to, chains.point.n);
    ck_assert_double_le(curve_off(&chains, 1), 2 * OFF);
    slice_chains_free(&chains);
}
END_TEST

int main(void)
{
    TCase *tests = tcase_create("surface_contacts");
    tcase_add_test(tests, the_curve_between_far_contacts_is_on_the_surface);
    tcase_add_test(tests, where_the_curve_is_right_none_are_added);
    tcase_add_test(tests, what_has_no_surface_stays);
    Suite *suite = suite_create("surface_contacts");
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

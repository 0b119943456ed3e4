/* edge_rim: how far the top of a mesa may go on beyond its points: as far as it does, and hardly
 * further; at a corner, and where the scan has two layers, nothing is told. */
#include <check.h>
#include <stdlib.h>

#include "cloud/edge_steps.h"
#include "edge_trial.h"

static const double HIGH = 3;

static double mesa(double x, double y)
{
    return edge_trial_side(x, y) > 0.07 ? HIGH : 0;
}

static double corner(double x, double y)
{
    return edge_trial_side(x, y) > 0.07 && edge_trial_side(y, -x) > 0.03 ? HIGH : 0;
}

static struct edge_trial trial;
static struct vec3s on, under;

/* Points about point i, as high or lower. */
static struct edge_rim rim_of(size_t i)
{
    const struct vec3 *p = trial.grid.point;

    on.n = under.n = 0;
    for (size_t k = 0; k < trial.grid.n; k++)
        if (hypot(p[k].x - p[i].x, p[k].y - p[i].y) < EDGE_REACH * 0.5)
            *array_push(p[k].z == p[i].z ? &on : &under) = p[k];
    return edge_rim_find(&trial.work, i, &on, &under);
}

static void make(double (*height)(double x, double y))
{
    edge_trial_make(&trial, height, false, 0);
    edge_flanks_find(&trial.work);
}

static void teardown(void)
{
    edge_trial_free(&trial);
    array_free(&on);
    array_free(&under);
}

/* Across the rim, (1, -4) / sqrt(17): its line is within what the points allow, and that is less
 * than the way to the next point below, 0.25 on average and up to 0.5. */
START_TEST(straight_rim)
{
    size_t rims = 0;
    double sum = 0, worst = 0;

    make(mesa);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        double side = edge_trial_side(p.x, p.y) - 0.07;
        if (p.z == 0 || side > 0.6 || fabs(p.x) > 6 || fabs(p.y) > 6)
            continue;
        struct edge_rim rim = rim_of(i);
        ck_assert_int_gt(rim.n, 0);
        double far = 2 * side + 1, u = far / sqrt(17), v = -4 * far / sqrt(17);
        double allowed = far * edge_rim_way(&rim, u, v);
        ck_assert_double_ge(allowed, side);
        worst = fmax(worst, allowed - side);
        sum += allowed - side;
        rims++;
        /* no further along it than it is borne out */
        ck_assert_double_eq_tol(edge_rim_way(&rim, 40, 10) * hypot(40, 10), rim.reach, 1e-9);
        ck_assert(edge_rim_allows(&trial.work, &rim, i, p));
        ck_assert(!edge_rim_allows(&trial.work, &rim, i, vec(p.x + 2 * u, p.y + 2 * v, p.z)));
    }
    ck_assert_uint_gt(rims, 20);
    ck_assert_double_le(worst, 0.35);
    ck_assert_double_le(sum / (double)rims, 0.25);
}
END_TEST

/* The tip of a square corner is not cut off. */
START_TEST(square_corner)
{
    size_t n = 0;

    make(corner);
    /* 4 y - x = 0.07 sqrt(17), -4 x - y = 0.03 sqrt(17) */
    double b = 0.07 * sqrt(17), c = 0.03 * sqrt(17), x = -(b + 4 * c) / 17, y = (4 * b - c) / 17;
    ck_assert_double_eq_tol(edge_trial_side(x, y), 0.07, 1e-12);
    ck_assert_double_eq_tol(edge_trial_side(y, -x), 0.03, 1e-12);
    bool reached = false;
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        double far = hypot(p.x - x, p.y - y);
        if (p.z == 0 || far > 1)
            continue;
        struct edge_rim rim = rim_of(i);
        n++;
        reached = reached || edge_rim_way(&rim, 0.9 * (x - p.x), 0.9 * (y - p.y)) == 1;
    }
    ck_assert_uint_ge(n, 3);
    ck_assert(reached);
}
END_TEST

/* Nothing under the point: nothing is told; with a layer below all of it neither. */
START_TEST(nothing_known)
{
    make(mesa);
    on.n = under.n = 0;
    struct edge_rim rim = edge_rim_find(&trial.work, 0, &on, &under);
    ck_assert_int_eq(rim.n, 0);
    ck_assert_double_eq(edge_rim_way(&rim, 3, 4), 1);
    struct vec3 p = trial.grid.point[0];
    for (int k = 0; k < 12; k++)
        *array_push(&under) = vec(p.x + 0.5 * cos(k), p.y + 0.5 * sin(k), p.z - 1);
    rim = edge_rim_find(&trial.work, 0, &on, &under);
    ck_assert_int_eq(rim.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_rim");
    TCase *tests = tcase_create("edge_rim");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, straight_rim);
    tcase_add_test(tests, square_corner);
    tcase_add_test(tests, nothing_known);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* edge_wide: under noise the sides of a pyramid, continued to its edges, and those of a cone to its
 * rim, are where they are within a part of the noise, though the points next to an edge are few. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"
#include "noisy.h"

static const double NOISE = 0.02, SPACING = 0.4;
enum { POINTS = 2500, WIDE = 20 };

static double pyramid(double x, double y)
{
    return fmax(0, 8 - fmax(fabs(x), fabs(y)));
}

/* A place of the nearest edge. */
static struct vec3 edge_of_pyramid(struct vec3 p)
{
    double t = (fabs(p.x) + fabs(p.y)) / 2;

    return vec(copysign(t, p.x), copysign(t, p.y), 8 - t);
}

static double mesa(double x, double y)
{
    return fmax(0, fmin(5, 5 - 1.5 * (hypot(x, y) - 4)));
}

static struct vec3 rim_of_mesa(struct vec3 p)
{
    double r = hypot(p.x, p.y);

    return vec(4 * p.x / r, 4 * p.y / r, 5);
}

static void make(double (*height)(double, double), unsigned seed, struct edge_trial *trial)
{
    struct vec3s scan = {0};

    noisy_seed(seed);
    for (int i = 0; i < POINTS; i++) {
        double x = WIDE * (noisy_uniform() - 0.5), y = WIDE * (noisy_uniform() - 0.5);
        *array_push(&scan) = vec(x, y, height(x, y) + NOISE * noisy_normal());
    }
    edge_trial_of(trial, scan, SPACING, NOISE);
}

START_TEST(sides_at_edges)
{
    static const struct {
        double (*height)(double, double);
        struct vec3 (*edge)(struct vec3);
        double off; /* noises; a dozen points are off by 0.5 to 1.2, and 1 to 2 */
    } of[] = {{pyramid, edge_of_pyramid, 0.45}, {mesa, rim_of_mesa, 0.8}};
    struct edge_trial trial;
    double sum = 0, n = 0;
    struct vec3 normal;

    make(of[_i % 2].height, 51 + (unsigned)_i, &trial);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        const struct edge_flank *flank = &trial.work.flank[i];
        struct vec3 p = trial.grid.point[i], edge = of[_i % 2].edge(p);
        if (p.z < 1 || !flank->valid || vec_distance(p, edge) > 2 * SPACING)
            continue;
        double h = edge_flank_above(flank, edge, &normal);
        n++;
        sum += h * h;
    }
    ck_assert_double_gt(n, 50);
    ck_assert_double_lt(sqrt(sum / n), of[_i % 2].off * NOISE);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_wide");
    TCase *tests = tcase_create("edge_wide");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, sides_at_edges, 0, 8);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

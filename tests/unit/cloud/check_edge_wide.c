/* edge_wide: under noise the sides of a pyramid, continued to its edges, those of a cone to its
 * rim, and the top of a block over its walls, are where they are within a part of the noise, though
 * the points next to an edge are few. */
#include <check.h>
#include <stdlib.h>

#include "cloud/noise.h"
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

/* The points of its top know nothing of its walls. */
static double block(double x, double y)
{
    return fabs(x) < 5 && fabs(y) < 4 ? 4 : 0;
}

static struct vec3 edge_of_block(struct vec3 p)
{
    return 5 - fabs(p.x) < 4 - fabs(p.y) ? vec(copysign(5, p.x), p.y, 4)
                                         : vec(p.x, copysign(4, p.y), 4);
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
        double off; /* noises; a dozen points are off by 0.5 to 1.2, 1 to 2, and 0.5 to 0.7 */
    } of[] = {
        {pyramid, edge_of_pyramid, 0.45}, {mesa, rim_of_mesa, 0.8}, {block, edge_of_block, 0.4}};
    struct edge_trial trial;
    double off[POINTS];
    size_t n = 0;
    struct vec3 normal;

    make(of[_i % 3].height, 51 + (unsigned)_i, &trial);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        const struct edge_flank *flank = &trial.work.flank[i];
        struct vec3 p = trial.grid.point[i], edge = of[_i % 3].edge(p);
        bool one = _i % 3 < 2 ? flank->valid : edge_flank_known(flank);
        if (p.z < 1 || !one || vec_distance(p, edge) > 2 * SPACING)
            continue;
        off[n++] = fabs(edge_flank_above(flank, edge, &normal));
    }
    ck_assert_uint_gt(n, 50);
    ck_assert_double_lt(noise_of_distances(off, n), of[_i % 3].off * NOISE);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_wide");
    TCase *tests = tcase_create("edge_wide");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, sides_at_edges, 0, 9);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* unseen_wall: the points at the foot of a step that has no points on it, and how high it is; none
 * on flanks that were scanned, on walls that were, on a roof or far from the step. */
#include <check.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "noisy.h"
#include "simulate/unseen_wall.h"

enum { POINTS = 6000 };
static const double HIGH = 5, SPACING = 0.2582; /* of so many points over 20 by 20 mm */

/* Points anywhere over a square of 20 mm, at heights of their own. */
static struct vec3s scan(double (*height)(double x))
{
    struct vec3s p = {0};

    for (int i = 0; i < POINTS; i++) {
        double x = 20 * noisy_uniform() - 10, y = 20 * noisy_uniform() - 10;
        *array_push(&p) = vec(x, y, height(x));
    }
    return p;
}

static double *walls_of(const struct vec3s *p, double apart)
{
    double *height = mem_alloc(p->n, sizeof *height), *spacing = mem_alloc(p->n, sizeof *spacing);

    for (size_t i = 0; i < p->n; i++)
        spacing[i] = apart;
    struct kdtree *tree = kdtree_new(p->item, p->n);
    unseen_wall_find(p->item, spacing, p->n, tree, 2, height);
    kdtree_free(tree);
    free(spacing);
    return height;
}

static double step(double x)
{
    return x < 0 ? HIGH : 0;
}

START_TEST(step_has_feet)
{
    noisy_seed(5);
    struct vec3s p = scan(step);
    double *height = walls_of(&p, SPACING);
    size_t feet = 0;

    for (size_t i = 0; i < p.n; i++) {
        double x = p.item[i].x;
        if (height[i] == 0)
            continue;
        feet++;
        ck_assert_double_eq_tol(height[i], HIGH, 1e-12);
        ck_assert_double_ge(x, 0);
        ck_assert_double_lt(x, 1.4 * 3.2 * SPACING); /* as far as a step is looked for */
    }
    /* along 20 mm about one a spacing */
    ck_assert_uint_gt(feet, (size_t)(0.5 * 20 / SPACING));
    ck_assert_uint_lt(feet, (size_t)(2 * 20 / SPACING));
    /* and where the step is looked at over a width of two spacings there is one */
    for (double y = -9; y <= 9; y += 0.5) {
        double near = HUGE_VAL;
        for (size_t i = 0; i < p.n; i++)
            near = height[i] > 0 ? fmin(near, fabs(p.item[i].y - y)) : near;
        ck_assert_double_lt(near, 3 * SPACING);
    }
    free(height);
    array_free(&p);
}
END_TEST

static double slope; /* of a flank */

static double flank(double x)
{
    return -slope * x;
}

/* Of a flank that was scanned hardly a point is at a foot: where chance leaves a gap. */
START_TEST(flanks_have_none)
{
    static const double of[] = {0, 1, 2.7, 5};
    noisy_seed(6);
    slope = of[_i];
    struct vec3s p = scan(flank);
    double *height = walls_of(&p, SPACING * sqrt(hypot(1, slope)));
    size_t feet = 0;

    for (size_t i = 0; i < p.n; i++)
        feet += height[i] > 0;
    ck_assert_uint_le(feet, _i < 3 ? 0 : p.n / 200);
    free(height);
    array_free(&p);
}
END_TEST

/* A roof over a floor that was seen below it. */
START_TEST(roof_has_none)
{
    noisy_seed(8);
    struct vec3s p = scan(step);
    size_t n = p.n;

    for (size_t i = 0; i < n; i++)
        if (p.item[i].z > 0) {
            struct vec3 below = vec(p.item[i].x, p.item[i].y, 0);
            *array_push(&p) = below;
        }
    double *height = walls_of(&p, SPACING);
    size_t feet = 0;
    for (size_t i = 0; i < p.n; i++)
        feet += height[i] > 0;
    ck_assert_uint_le(feet, p.n / 300);
    free(height);
    array_free(&p);
}
END_TEST

/* With points on the wall itself. */
START_TEST(seen_wall_has_none)
{
    noisy_seed(7);
    struct vec3s p = scan(step);

    for (double y = -10; y <= 10; y += 0.25)
        for (double z = 0.2; z < HIGH; z += 0.2)
            *array_push(&p) = vec(0, y, z);
    double *height = walls_of(&p, SPACING);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_double_eq(height[i], 0);
    free(height);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("unseen_wall");
    TCase *tests = tcase_create("unseen_wall");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, step_has_feet);
    tcase_add_loop_test(tests, flanks_have_none, 0, 4);
    tcase_add_test(tests, roof_has_none);
    tcase_add_test(tests, seen_wall_has_none);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* edge_crest: the crest of a thin ring, which no point is on, and both its sides get places on them
 * and nowhere else; a straight roof, whose sides are certain, gets none. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

/* 4 mm high and 2 mm thick at its foot. */
static double ring(double x, double y)
{
    return fmax(0, 4 - 4 * fabs(hypot(x - 0.1, y + 0.07) - 6));
}

/* Smooth: bends of 2.5 1/mm at most, where lines are 0.8 mm apart. */
static double waves(double x, double y)
{
    return 4 * cos(0.75 * (y + 0.3 * x));
}

/* With noise: on lines. */
static void add(struct edge_trial *trial, double (*height)(double x, double y), double sigma)
{
    size_t n;

    edge_trial_make(trial, height, sigma > 0, sigma);
    n = trial->grid.n;
    trial->work.between = mem_alloc(n, sizeof *trial->work.between);
    for (size_t i = 0; i < n; i++)
        trial->work.between[i] = (struct vec3s){0};
    edge_flanks_find(&trial->work);
    edge_crests_add(&trial->work);
}

static void remove_all(struct edge_trial *trial)
{
    for (size_t i = 0; i < trial->grid.n; i++)
        array_free(&trial->work.between[i]);
    free(trial->work.between);
    edge_trial_free(trial);
}

/* Distance of the nearest place of one of the lists. */
static double nearest(const struct edge_trial *trial, const struct vec3s *list, struct vec3 at)
{
    double least = HUGE_VAL;

    for (size_t i = 0; i < trial->grid.n; i++)
        for (size_t k = 0; k < list[i].n; k++)
            least = fmin(least, vec_distance(at, list[i].item[k]));
    return least;
}

START_TEST(on_a_ring)
{
    struct edge_trial trial;

    add(&trial, ring, 0);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3s list[] = {trial.work.found[i], trial.work.between[i]};
        for (int l = 0; l < 2; l++)
            for (size_t k = 0; k < list[l].n; k++) {
                struct vec3 p = list[l].item[k];
                double side = 4 - 4 * fabs(hypot(p.x - 0.1, p.y + 0.07) - 6);
                /* their points may be off by 0.02 spacings */
                ck_assert_double_eq_tol((p.z - side) / sqrt(17), 0, 2 * 0.02 * 0.5);
            }
    }
    /* places 0.2 mm apart: no gap in the crest of twice that, nor on its sides */
    for (double t = 0; t < 2 * PI; t += 0.02) {
        struct vec3 crest = vec(0.1 + 6 * cos(t), 6 * sin(t) - 0.07, 4);
        ck_assert_double_le(nearest(&trial, trial.work.found, crest), 0.2);
        for (double d = -0.5; d <= 0.5; d += 1) {
            struct vec3 side = vec(0.1 + (6 + d) * cos(t), (6 + d) * sin(t) - 0.07, 2);
            ck_assert_double_le(nearest(&trial, trial.work.between, side), 0.2);
        }
    }
    remove_all(&trial);
}
END_TEST

START_TEST(not_where_sides_are_certain)
{
    struct edge_trial trial;
    size_t found = 0;

    add(&trial, edge_trial_roof, 0);
    for (size_t i = 0; i < trial.grid.n; i++)
        found += trial.work.found[i].n + trial.work.between[i].n;
    ck_assert_uint_eq(found, 0);
    remove_all(&trial);
}
END_TEST

/* Seen along y. */
static double off_waves(struct vec3 p)
{
    double least = HUGE_VAL;

    for (double y = -2; y <= 2; y += 0.02)
        least = fmin(least, hypot(y, waves(p.x, p.y + y) - p.z));
    return least;
}

/* Of noise on a few lines crests may be as steep as anything: they are near to what was scanned. */
START_TEST(near_to_noisy_lines)
{
    const double most = 0.6; /* mm: 1.25 spacings, and the noise */
    struct edge_trial trial;

    add(&trial, waves, 0.02);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3s list[] = {trial.work.found[i], trial.work.between[i]};
        for (int l = 0; l < 2; l++)
            for (size_t k = 0; k < list[l].n; k++)
                if (fabs(list[l].item[k].x) < 7 && fabs(list[l].item[k].y) < 7)
                    ck_assert_double_le(off_waves(list[l].item[k]), most);
    }
    remove_all(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_crest");
    TCase *tests = tcase_create("edge_crest");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, on_a_ring);
    tcase_add_test(tests, near_to_noisy_lines);
    tcase_add_test(tests, not_where_sides_are_certain);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* edge_flank: on a roof each point gets the plane of its own side, near to the ridge too. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

/* Without noise on a grid and on scan lines; with it on a grid. */
START_TEST(own_side)
{
    const double sigma = _i == 2 ? 0.01 : 0;
    struct edge_trial trial;
    size_t rough = 0, known = 0, wrong = 0;

    edge_trial_make(&trial, edge_trial_roof, _i == 1, sigma);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i], normal;
        const struct edge_flank *flank = &trial.work.flank[i];
        double side = edge_trial_side(p.x, p.y);
        if (hypot(p.x, p.y) > 7 || fabs(side) < 0.05)
            continue;
        rough += flank->rough;
        known += edge_flank_known(flank);
        if (!edge_flank_known(flank))
            continue;
        /* a spacing on, away from the ridge or over it, the plane goes on */
        for (double far = -0.5; far <= 0.5; far += 0.5) {
            double z = 10 - (fabs(side) + far), s = side > 0 ? far : -far;
            struct vec3 at = vec(p.x - s / sqrt(17), p.y + 4 * s / sqrt(17), z);
            wrong += fabs(edge_flank_above(flank, at, &normal)) > (sigma > 0 ? 4 * sigma : 1e-3);
            ck_assert(normal.z > 0);
        }
        ck_assert(sigma > 0 || !flank->valid || edge_flank_certain(&trial.work, flank));
    }
    ck_assert_uint_gt(rough, 50); /* the ridge is 14 mm long: two rows of points at least */
    ck_assert_uint_gt(known, 9 * rough / 10);
    ck_assert_uint_le(wrong, sigma > 0 ? known / 50 : 0);
    edge_trial_free(&trial);
}
END_TEST

/* Posts of six sides, their tops tilted, as wide as high. */
static double turn;

static double posts(double x, double y)
{
    double u = x * cos(turn) + y * sin(turn), v = y * cos(turn) - x * sin(turn), most = 0;

    u -= 6 * floor(u / 6 + 0.5);
    v -= 6 * floor(v / 6 + 0.5);
    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(u * cos(k * PI / 3) + v * sin(k * PI / 3)));
    return most < 2.2 ? 2.5 + 0.2 * u : 0;
}

/* Through the points about a rim goes a cubic, too, that leaves the floor and the top: those of the
 * tops are on their planes. */
START_TEST(planes_of_narrow_tops)
{
    struct edge_trial trial;
    size_t top = 0, on = 0;

    turn = 0.1 + 0.13 * _i;
    edge_trial_make(&trial, posts, false, 0);
    edge_flanks_find(&trial.work);
    struct vec3 up = vec_unit(vec(-0.2 * cos(turn), -0.2 * sin(turn), 1));
    for (size_t i = 0; i < trial.grid.n; i++) {
        const struct edge_flank *flank = &trial.work.flank[i];
        struct vec3 p = trial.grid.point[i];
        if (p.z < 1 || !edge_flank_known(flank) || hypot(p.x, p.y) > 8)
            continue;
        top++;
        on += vec_dot(quadric_normal_at(&flank->q, p), up) > 0.9999;
    }
    ck_assert_uint_gt(top, 200);
    ck_assert_uint_le(top - on, top / 100);
    edge_trial_free(&trial);
}
END_TEST

/* A point of a flank that is left out lies on what the others make; one beside it does not. */
START_TEST(holds)
{
    struct edge_trial trial;
    size_t n = 0, held = 0;

    edge_trial_make(&trial, edge_trial_roof, false, 0);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        double side = fabs(edge_trial_side(p.x, p.y));
        if (hypot(p.x, p.y) > 7 || side > 0.5 || side < 0.05)
            continue;
        n++;
        held += edge_flank_holds(&trial.grid, 0, i);
        trial.grid.point[i].z += 0.3;
        ck_assert(!edge_flank_holds(&trial.grid, 0, i));
        trial.grid.point[i] = p;
    }
    ck_assert_uint_gt(n, 20);
    ck_assert_uint_gt(held, 3 * n / 4);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_flank");
    TCase *tests = tcase_create("edge_flank");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, own_side, 0, 3);
    tcase_add_loop_test(tests, planes_of_narrow_tops, 0, 4);
    tcase_add_test(tests, holds);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

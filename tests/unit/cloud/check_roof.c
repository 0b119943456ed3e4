/* roof: where a scan is one sheet that faces up, and the points that hang under its rims and
 * under what stands out of it. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/roof.h"
#include "math/elementary.h"
#include "seed.h"

#define STEP 0.5 /* mm between points */

/* A level sheet, its lower left corner at (x, y). */
static void sheet(struct vec3s *p, double x, double y, double width, double depth, double z)
{
    for (double v = 0; v <= depth + 1e-9; v += STEP)
        for (double u = 0; u <= width + 1e-9; u += STEP)
            *array_push(p) = vec(x + u, y + v, z);
}

struct found {
    struct point_grid grid;
    unsigned char *roof;
    size_t n;
};

static struct found find(struct vec3s *p, double reach, int threads)
{
    struct found f;
    struct error error;
    ck_assert_int_eq(point_grid_make(p->item, p->n, STEP, threads, &f.grid, &error), 0);
    f.roof = malloc(p->n);
    f.n = roof_find(&f.grid, reach, threads, f.roof);
    return f;
}

static void discard(struct found *f, struct vec3s *p)
{
    point_grid_free(&f->grid);
    free(f->roof);
    array_free(p);
}

/* Points anywhere on a level ground and a sheet over half of it, of any density: what a judge takes
 * for roof is roof for who guards, and there is such. */
START_TEST(what_is_judged_is_guarded)
{
    for (int density = 1; density <= 8; density++) {
        struct vec3s p = {0};
        uint32_t seed = (uint32_t)density;
        for (int i = 0; i < 400 * density; i++) {
            double at[2];
            for (int k = 0; k < 2; k++) {
                seed = seed * 1664525u + seed_step_32();
                at[k] = 20 * ((seed >> 8) / 16777216.0);
            }
            bool over = at[0] < 10 && i % 3 == 0; /* thin: its points are farther apart */
            if (at[0] < 10 && !over && i % 5 > 0)
                continue;
            *array_push(&p) = vec(at[0], at[1], over ? 9 : 0);
        }
        struct point_grid grid;
        struct error error;
        double spacing = sqrt(20 * 20 / (double)p.n);
        ck_assert_int_eq(point_grid_make(p.item, p.n, spacing, 1, &grid, &error), 0);
        unsigned char *guard = malloc(p.n), *judge = malloc(p.n);
        roof_find(&grid, ROOF_GUARD, 1, guard);
        ck_assert_uint_gt(roof_find(&grid, ROOF_JUDGE, 1, judge), 0);
        for (size_t i = 0; i < p.n; i++)
            ck_assert(!judge[i] || guard[i]);
        free(guard);
        free(judge);
        point_grid_free(&grid);
        array_free(&p);
    }
}
END_TEST

/* A hole of 4 x 4 mm, seen down to its floor: neither the floor beside its walls nor the plate
 * beside the hole is roof, all the rest is. */
START_TEST(a_plate_with_a_hole)
{
    for (int k = 0; k < 2; k++) {
        double reach = k == 0 ? ROOF_GUARD : ROOF_JUDGE;
        struct vec3s p = {0};
        sheet(&p, 0, 0, 20, 20, 0);
        for (size_t i = 0; i < p.n; i++)
            if (fabs(p.item[i].x - 10) < 2 && fabs(p.item[i].y - 10) < 2)
                p.item[i].z = -10;
        struct found f = find(&p, reach, 1);
        for (size_t i = 0; i < p.n; i++) {
            double x = fabs(p.item[i].x - 10), y = fabs(p.item[i].y - 10), off = fmax(x, y) - 2;
            if (off > reach * STEP || off < -(reach + 1) * STEP)
                ck_assert_int_eq(f.roof[i], 1);
            if (off >= 0 && off < (reach - 1) * STEP && fmin(x, y) < 2)
                ck_assert_int_eq(f.roof[i], 0);
        }
        discard(&f, &p);
    }
}
END_TEST

/* An overhang whose lower side is known is none, nor what is under it; a slope of 80 degrees is
 * none, one of 60 is. */
START_TEST(overhangs_and_slopes)
{
    struct vec3s p = {0};
    sheet(&p, 0, 0, 20, 20, 0);
    sheet(&p, 5, 5, 10, 10, 6);
    sheet(&p, 5, 5, 10, 10, 9);
    struct found f = find(&p, ROOF_GUARD, 1);
    for (size_t i = 0; i < p.n; i++) {
        bool over = fmax(fabs(p.item[i].x - 10), fabs(p.item[i].y - 10)) <= 5;
        if (over)
            ck_assert_int_eq(f.roof[i], 0);
    }
    ck_assert_uint_gt(f.n, 500);
    discard(&f, &p);
    for (int k = 0; k < 2; k++) {
        struct vec3s slope = {0};
        sheet(&slope, 0, 0, 20, 20, 0);
        for (size_t i = 0; i < slope.n; i++)
            slope.item[i].z = tan(RADIANS(k == 0 ? 60 : 80)) * slope.item[i].x;
        size_t n = slope.n;
        struct found g = find(&slope, ROOF_GUARD, 1);
        ck_assert_uint_eq(g.n, k == 0 ? n : 0);
        discard(&g, &slope);
    }
}
END_TEST

/* Whoever reaches further finds some of the same: on a hemisphere all but the steep, and a part. */
START_TEST(judged_by_less)
{
    struct vec3s p = {0};
    sheet(&p, -15, -15, 30, 30, 0);
    for (size_t i = 0; i < p.n; i++) {
        double r2 = p.item[i].x * p.item[i].x + p.item[i].y * p.item[i].y;
        p.item[i].z = r2 < 100 ? sqrt(100 - r2) : 0;
    }
    struct found f = find(&p, ROOF_GUARD, 1);
    unsigned char *judged = malloc(p.n);
    size_t n = roof_find(&f.grid, ROOF_JUDGE, 2, judged);
    ck_assert_uint_lt(n, f.n);
    ck_assert_uint_gt(n, f.n / 2);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_int_le(judged[i], f.roof[i]);
    free(judged);
    discard(&f, &p);
}
END_TEST

/* The curtain of a plate hangs under its four sides, no wider apart than the gap, down to the
 * bottom, and within there is a floor; the same for any number of threads. */
START_TEST(a_curtain)
{
    const double gap = 1.25, bottom = -8;
    struct vec3s curtain[2] = {{0}, {0}};
    for (int k = 0; k < 2; k++) {
        struct vec3s p = {0};
        sheet(&p, 0, 0, 20, 20, 0);
        struct found f = find(&p, ROOF_GUARD, k == 0 ? 1 : 3);
        roof_curtain(&f.grid, f.roof, gap, bottom, k == 0 ? 1 : 3, &curtain[k]);
        discard(&f, &p);
    }
    ck_assert_uint_eq(curtain[0].n, curtain[1].n);
    for (size_t i = 0; i < curtain[0].n; i++) {
        struct vec3 p = curtain[0].item[i];
        double inside = fmin(fmin(p.x, 20 - p.x), fmin(p.y, 20 - p.y));
        ck_assert(vec_distance(p, curtain[1].item[i]) == 0);
        ck_assert(inside <= 1e-9 || p.z == bottom);
        ck_assert(p.z < 0 && p.z >= bottom);
    }
    for (double x = 0; x <= 20; x += 0.5)
        for (double y = 0; y <= 20; y += 0.5) {
            double nearest = HUGE_VAL;
            for (size_t i = 0; i < curtain[0].n; i++)
                nearest = fmin(nearest, vec_distance(curtain[0].item[i], vec(x, y, bottom)));
            ck_assert_double_le(nearest, 1.1 * gap);
        }
    for (double along = 0; along <= 20; along += 0.1)
        for (double z = -gap; z >= bottom; z -= 0.1) {
            double nearest = HUGE_VAL;
            for (size_t i = 0; i < curtain[0].n; i++)
                nearest = fmin(nearest, vec_distance(curtain[0].item[i], vec(along, 0, z)));
            ck_assert_double_le(nearest, 0.8 * gap);
        }
    array_free(&curtain[0]);
    array_free(&curtain[1]);
}
END_TEST

/* Under a plate that is thinner than the gap, points hang at the bottom. */
START_TEST(a_low_curtain)
{
    const double gap = 1.25, bottom = -0.5;
    struct vec3s p = {0}, curtain = {0};
    sheet(&p, 0, 0, 20, 20, 0);
    struct found f = find(&p, ROOF_GUARD, 1);
    roof_curtain(&f.grid, f.roof, gap, bottom, 1, &curtain);
    ck_assert_uint_ge(curtain.n, 4 * (size_t)(20 / gap));
    for (size_t i = 0; i < curtain.n; i++)
        ck_assert(curtain.item[i].z == bottom);
    discard(&f, &p);
    array_free(&curtain);
}
END_TEST

/* A point that stands above all about it, far from any rim: below it points hang down to those,
 * so that no ball passes under it from the side; nothing else hangs inside, but for the floor. */
START_TEST(under_a_lone_point)
{
    const double gap = 0.4, high = 1.5;
    struct vec3s p = {0}, curtain = {0};
    sheet(&p, 0, 0, 20, 20, 0);
    for (size_t i = 0; i < p.n; i++)
        if (fabs(p.item[i].x - 10) < STEP / 2 && fabs(p.item[i].y - 10) < STEP / 2)
            p.item[i].z = high;
    struct found f = find(&p, ROOF_GUARD, 1);
    double lowest = high;
    size_t inside = 0;
    ck_assert_uint_eq(f.n, p.n);
    roof_curtain(&f.grid, f.roof, gap, -8, 1, &curtain);
    for (size_t i = 0; i < curtain.n; i++) {
        struct vec3 q = curtain.item[i];
        if (q.z == -8 || fmin(fmin(q.x, 20 - q.x), fmin(q.y, 20 - q.y)) < STEP / 2)
            continue;
        ck_assert(fabs(q.x - 10) < 1e-9 && fabs(q.y - 10) < 1e-9);
        ck_assert_double_le(lowest - q.z, gap + 1e-9);
        lowest = q.z;
        inside++;
    }
    ck_assert_uint_eq(inside, 4); /* 1.1, 0.7, 0.3 and 0 */
    ck_assert_double_eq(lowest, 0);
    discard(&f, &p);
    array_free(&curtain);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("roof");
    TCase *tcase = tcase_create("roof");
    tcase_add_test(tcase, what_is_judged_is_guarded);
    tcase_add_test(tcase, a_plate_with_a_hole);
    tcase_add_test(tcase, overhangs_and_slopes);
    tcase_add_test(tcase, judged_by_less);
    tcase_add_test(tcase, a_curtain);
    tcase_add_test(tcase, a_low_curtain);
    tcase_add_test(tcase, under_a_lone_point);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

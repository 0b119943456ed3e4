/*
 * rest_passes: strips over points that are left of planes and of a wall, whose places are known:
 * they lie on planes a step apart, none of the points is far from one, no strip leaps over what is
 * cut, and each next one is the nearest.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"
#include "toolpath/rest_passes.h"

static struct {
    size_t n, cap;
    struct coverage_point *item;
} points;
static struct rest_strips strips;

static void teardown(void)
{
    array_free(&points);
    rest_strips_free(&strips);
    strips = (struct rest_strips){0};
}

static void add(struct vec3 p, struct vec3 normal, enum coverage_state state)
{
    *array_push(&points) = (struct coverage_point){.p = p, .normal = normal, .state = state};
}

/* Floor from x0, 6 wide and 4 deep, a point each 0.25. */
static void add_floor(double x0, double y0, enum coverage_state state)
{
    for (int k = 0; k <= 16; k++)
        for (int i = 0; i <= 24; i++)
            add(vec(x0 + i * 0.25, y0 + k * 0.25, 0), vec(0, 0, 1), state);
}

static void find(struct vec3 planes, bool turned)
{
    const struct rest_options options = {
        .planes = planes, .turned = turned, .step = 0.5, .gap = 2.1};
    strips = rest_passes_find(points.item, points.n, &options);
}

static double nearest_strip(struct vec3 p)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < strips.n; i++)
        for (size_t k = 0; k < strips.item[i].contact.n; k++)
            least = fmin(least, vec_distance(p, strips.item[i].contact.item[k].p));
    return least;
}

/* Every strip is in one plane of its family, a whole number of steps from 0, has no two points in
 * one place and none further apart than the gap; every point that is left is near one. */
static void hold(void)
{
    for (size_t i = 0; i < strips.n; i++) {
        const struct rest_strip *s = &strips.item[i];
        double steps = vec_dot(s->contact.item[0].p, s->planes) / 0.5;
        ck_assert_double_lt(fabs(steps - nearbyint(steps)), 1e-9);
        ck_assert_uint_ge(s->contact.n, 2);
        for (size_t k = 0; k < s->contact.n; k++) {
            const struct contact *c = &s->contact.item[k];
            ck_assert_double_lt(fabs(vec_dot(c->p, s->planes) / 0.5 - steps), 1e-9);
            ck_assert_double_lt(fabs(vec_length(c->n) - 1), 1e-9);
            if (k > 0)
                ck_assert_double_lt(vec_distance(c->p, c[-1].p), 2.1);
            if (k > 0)
                ck_assert_double_gt(vec_distance(c->p, c[-1].p), 0.1);
        }
    }
    for (size_t i = 0; i < points.n; i++)
        if (points.item[i].state == COVERAGE_LEFT)
            ck_assert_double_le(nearest_strip(points.item[i].p), 0.5);
}

/* How far it is from each strip to the next, all together. */
static double links(void)
{
    double sum = 0;
    for (size_t i = 1; i < strips.n; i++) {
        const struct contacts *a = &strips.item[i - 1].contact, *b = &strips.item[i].contact;
        sum += vec_distance(a->item[a->n - 1].p, b->item[0].p);
    }
    return sum;
}

/* Across the planes of the passes, or along them. */
START_TEST(floor_in_strips)
{
    for (int turned = 0; turned < 2; turned++) {
        teardown();
        add_floor(0, 0, COVERAGE_LEFT);
        find(vec(1, 0, 0), turned);
        hold();
        ck_assert_uint_eq(strips.n, turned ? 13 : 9);
        for (size_t i = 0; i < strips.n; i++) {
            ck_assert_double_eq_tol(fabs(strips.item[i].planes.x), turned, 1e-12);
            ck_assert_double_eq_tol(fabs(strips.item[i].planes.y), 1 - turned, 1e-12);
        }
        /* to and fro: each link is a step long */
        ck_assert_double_lt(links(), 0.5 * (double)(strips.n - 1) + 1e-9);
    }
}
END_TEST

/* What is cut has no strip; one over a gap of 2 goes on, over one of 2.5 it does not. */
START_TEST(gaps)
{
    for (int far = 0; far < 2; far++) {
        teardown();
        add_floor(0, 0, COVERAGE_LEFT);
        add_floor(far ? 8.5 : 8, 0, COVERAGE_LEFT);
        add_floor(30, 0, COVERAGE_CUT);
        add_floor(40, 0, COVERAGE_OUT);
        add_floor(50, 0, COVERAGE_KEPT);
        find(vec(1, 0, 0), false);
        hold();
        ck_assert_uint_eq(strips.n, far ? 18 : 9);
        ck_assert_double_gt(nearest_strip(vec(30, 0, 0)), 10);
    }
}
END_TEST

/* Five floors, told in another order than they lie in: one is left for the next beside it. */
START_TEST(nearest_next)
{
    static const int order[] = {0, 3, 1, 4, 2};
    for (int i = 0; i < 5; i++)
        add_floor(0, 10 * order[i], COVERAGE_LEFT);
    find(vec(0, 1, 0), false);
    hold();
    ck_assert_uint_eq(strips.n, 5 * 13);
    /* 12 steps on each floor, and 6 or less from its last strip to the next floor's nearest end,
     * which may be the one that its own width leads to */
    ck_assert_double_lt(links(), 5 * 12 * 0.5 + 4 * hypot(6, 6) + 1e-9);
}
END_TEST

/* A wall that the planes across do not serve: those along do; one that neither serves has level
 * ones, of which each point is nearest to one. */
START_TEST(walls)
{
    static const struct vec3 normal[] = {{0, 1, 0}, {1, 0, 0}};
    for (int w = 0; w < 2; w++) {
        teardown();
        struct vec3 along = vec_cross(normal[w], vec(0, 0, 1));
        for (int i = 0; i <= 24; i++)
            for (int k = 0; k <= 16; k++)
                add(vec_add(vec_scale(i * 0.25, along), vec(0, 0, k * 0.25)), normal[w],
                    COVERAGE_LEFT);
        find(vec(1, 0, 0), false);
        hold();
        for (size_t i = 0; i < strips.n; i++)
            ck_assert_double_lt(fabs(vec_dot(strips.item[i].planes, normal[w])), 1e-9);
    }
    teardown();
    struct vec3 corner = vec_unit(vec(1, 1, 0.05)), along = vec_unit(vec(1, -1, 0));
    for (int i = 0; i <= 24; i++)
        for (int k = 0; k <= 16; k++)
            add(vec_add(vec_scale(i * 0.25, along), vec_scale(k * 0.25, vec_cross(along, corner))),
                corner, COVERAGE_LEFT);
    find(vec(1, 0, 0), false);
    hold();
    for (size_t i = 0; i < strips.n; i++)
        ck_assert_double_eq_tol(strips.item[i].planes.z, 1, 1e-12);
}
END_TEST

/* One point gets two beside it, in its tangent plane; points back to back are no strip. */
START_TEST(single_points)
{
    add(vec(1, 2, 3), vec_unit(vec(0.3, 0, 1)), COVERAGE_LEFT);
    find(vec(1, 0, 0), false);
    ck_assert_uint_eq(strips.n, 1);
    ck_assert_uint_eq(strips.item[0].contact.n, 3);
    ck_assert_double_lt(vec_distance(strips.item[0].contact.item[1].p, vec(1, 2, 3)), 1e-9);
    hold();
    teardown();
    add(vec(0, 0, 0), vec(0, 0, 1), COVERAGE_LEFT);
    add(vec(1, 0, 0), vec(0, 0, -1), COVERAGE_LEFT);
    find(vec(1, 0, 0), false);
    ck_assert_uint_eq(strips.n, 2);
    teardown();
    find(vec(1, 0, 0), false);
    ck_assert_uint_eq(strips.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rest_passes");
    TCase *tests = tcase_create("rest_passes");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, floor_in_strips);
    tcase_add_test(tests, gaps);
    tcase_add_test(tests, nearest_next);
    tcase_add_test(tests, walls);
    tcase_add_test(tests, single_points);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

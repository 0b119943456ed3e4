/* holder_glance: of motions in all directions, turning, over a wavy ground, no point is left out
 * that comes near in any of many poses; where the tool passes close over the ground it is none. */
#include <check.h>
#include <stdlib.h>

#include "gouge/holder_glance.h"
#include "seed.h"

enum { POSES = 50, MOTIONS = 100 };

static const double TIP = 3;

static double random_in(unsigned *state, double low, double high)
{
    *state = *state * 1664525u + seed_step_32();
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

static double ground(double x, double y)
{
    return 0.8 * sin(x / 2) * cos(y / 3);
}

static struct vec3s make_ground(double wave)
{
    struct vec3s points = {0};
    for (int i = -60; i <= 60; i++)
        for (int k = -60; k <= 60; k++)
            *array_push(&points) = vec(0.3 * i, 0.3 * k, wave * ground(0.3 * i, 0.3 * k));
    return points;
}

/* A motion of the ball's centre on a parabola, the axis turning on a great circle. */
struct way {
    struct vec3 from, to, bend, a, b;
};

static struct pose pose_on(const struct way *way, double s)
{
    struct vec3 p = vec_along(vec_mix(way->from, way->to, s), s * (1 - s), way->bend);
    return (struct pose){p, vec_slerp(way->a, way->b, s)};
}

static struct holder_glance glance_of(const struct way *way, const struct holder *holder,
                                      double least, double from, double to)
{
    struct holder_glance glance = {.holder = holder, .least = least};
    for (int i = 0; i < GLANCE_POSES; i++)
        glance.pose[i] = pose_on(way, from + (to - from) * i / (GLANCE_POSES - 1));
    holder_glance_measure(&glance);
    return glance;
}

static struct way random_way(unsigned *state)
{
    double length = random_in(state, 0.1, 6), turn = random_in(state, 0, 0.1) * length;
    struct vec3 along = vec_unit(
        vec(random_in(state, -1, 1), random_in(state, -1, 1), random_in(state, -0.3, 0.3)));
    struct vec3 aside = vec(random_in(state, -1, 1), random_in(state, -1, 1), 0);
    struct way way = {.from = vec(random_in(state, -8, 8), random_in(state, -8, 8), TIP)};
    way.from.z += random_in(state, -1, 1.5);
    way.to = vec_along(way.from, length, along);
    way.bend = vec_scale(random_in(state, 0, 0.5) * length, aside);
    way.a = vec_unit(vec(random_in(state, -3, 3), random_in(state, -3, 3), 1));
    way.b = vec_unit(vec_along(way.a, turn, aside));
    return way;
}

/* The least distance of the point in any of the poses from one place of the way to another. */
static double nearest_of(const struct way *way, const struct holder *holder, double from, double to,
                         struct vec3 p)
{
    double nearest = HUGE_VAL;
    for (int i = 0; i <= POSES; i++) {
        struct pose at = pose_on(way, from + (to - from) * i / POSES);
        nearest = fmin(nearest, holder_distance(holder, at.p, at.a, p));
    }
    return nearest;
}

/* No place of the holder is farther from where it is in the middle. */
static double farthest_moved(const struct way *way, const struct holder *holder)
{
    struct pose middle = pose_on(way, 0.5);
    double moved = 0;
    for (int i = 0; i <= POSES; i++) {
        struct pose at = pose_on(way, (double)i / POSES);
        moved = fmax(moved, vec_distance(at.p, middle.p) +
                                holder_reach(holder) * vec_distance(at.a, middle.a));
    }
    return moved;
}

static bool holds(const struct vec3s *list, size_t from, struct vec3 p)
{
    for (size_t i = from; i < list->n; i++)
        if (vec_compare(&list->item[i], &p) == 0)
            return true;
    return false;
}

START_TEST(no_point_that_comes_near_is_left_out)
{
    static const struct holder holders[] = {{1, {{3, 3, 12}}},
                                            {3, {{3, 3, 6}, {4, 9, 3}, {9, 9, 10}}}};
    struct vec3s points = make_ground(1);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    unsigned state = 11;
    size_t near = 0, named = 0;

    for (int k = 0; k < MOTIONS; k++) {
        const struct holder *holder = &holders[k % 2];
        struct way way = random_way(&state);
        double least = k % 3 ? -0.0075 : 0.3, half = random_in(&state, 0.3, 0.7);
        struct holder_glance whole = glance_of(&way, holder, least, 0, 1);
        struct holder_glance part = glance_of(&way, holder, least, 0, half);
        struct vec3s list = {0};
        holder_glance_gather(guard, &whole, &list);
        size_t n = list.n;
        holder_glance_choose(&part, 0, n, &list);
        struct pose middle = pose_on(&way, 0.5);
        double far = least + farthest_moved(&way, holder);
        for (size_t i = 0; i < points.n; i++) {
            struct vec3 p = points.item[i];
            if (holder_distance(holder, middle.p, middle.a, p) > far)
                continue;
            bool comes = nearest_of(&way, holder, 0, 1, p) < least - 1e-9;
            near += comes;
            ck_assert(!comes || holds(&list, 0, p));
            if (nearest_of(&way, holder, 0, half, p) < least - 1e-9)
                ck_assert(holds(&list, n, p));
        }
        named += n;
        array_free(&list);
    }
    ck_assert_uint_gt(near, MOTIONS);
    ck_assert_uint_lt(named, 2 * near); /* hardly more than those */
    gouge_free(guard);
    array_free(&points);
}
END_TEST

/* The rim of the cylinder 0.05 mm over flat ground, 2 mm along it. */
START_TEST(a_tool_that_passes_close_by_is_clear)
{
    const struct holder holder = {1, {{3, 3, 12}}};
    struct vec3s points = make_ground(0), list = {0};
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    const double lean = RADIANS(60);
    struct vec3 axis = vec(0, sin(lean), cos(lean));
    struct vec3 from = vec(0, 0, 3 * sin(lean) + 0.05);
    struct way way = {.from = from, .to = vec_along(from, 2, vec(1, 0, 0)), .a = axis, .b = axis};
    struct holder_glance glance = glance_of(&way, &holder, -0.0075, 0, 1);

    holder_glance_gather(guard, &glance, &list);
    ck_assert_uint_eq(list.n, 0);
    glance.least = 0.06;
    holder_glance_gather(guard, &glance, &list);
    ck_assert_uint_gt(list.n, 0);
    array_free(&list);
    gouge_free(guard);
    array_free(&points);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("holder_glance");
    TCase *tests = tcase_create("holder_glance");
    tcase_add_test(tests, no_point_that_comes_near_is_left_out);
    tcase_add_test(tests, a_tool_that_passes_close_by_is_clear);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* post_frame: the frames of tilted planes, against turns written out here; what is a plane and what
 * is not; inches. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "post/post_frame.h"
#include "base/num.h"
#include "seed.h"

enum { TRIALS = 400 };

static unsigned long state = 20261121;

/* -1 to 1 */
static double any(void)
{
    state = (state * 1103515245UL + 12345UL) % 2147483648UL;
    return (double)state / 1073741824.0 - 1;
}

static struct vec3 any_axis(void)
{
    struct vec3 a;
    do
        a = vec(any(), any(), any());
    while (vec_length(a) > 1 || vec_length(a) < 0.1);
    return vec_unit(a);
}

/* A point turned about a principal direction: 0, 1, 2. */
static struct vec3 about(int axis, double degrees, struct vec3 p)
{
    double c = cos(RADIANS(degrees)), s = sin(RADIANS(degrees));
    if (axis == 0)
        return vec(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
    if (axis == 1)
        return vec(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    return vec(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

/* From the plane to the work: intrinsic turns are the same about fixed axes, the last one first. */
static struct vec3 to_work(const struct nc_plane *p, enum nc_plane_angles angles, struct vec3 v)
{
    if (angles == NC_PLANE_EULER)
        return about(2, p->i, about(0, p->j, about(2, p->k, v)));
    if (angles == NC_PLANE_SPATIAL)
        return about(1, p->spb, about(0, p->spa, v));
    return about(0, p->a, about(1, p->b, v));
}

static struct machine reaching(void)
{
    struct error e;
    struct machine m = machine_default();
    ck_assert_int_eq(machine_set(&m, "a.min=-180", &e), 0);
    ck_assert_int_eq(machine_set(&m, "a.max=180", &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), 0);
    return m;
}

START_TEST(points_come_back_by_the_printed_angles)
{
    enum nc_plane_angles angles = (enum nc_plane_angles)(_i % NC_PLANE_ANGLES);
    int digits = 3 + _i % 4;
    for (int trial = 0; trial < TRIALS / 8; trial++) {
        struct path path = {.name = "path"};
        struct machine m = reaching();
        struct nc_planes planes = {0};
        struct error e;
        struct vec3 axis[2] = {any_axis(), trial % 5 ? any_axis() : vec(0, 0, trial % 2 ? 1 : -1)};
        struct vec3 point[4];
        for (int i = 0; i < 4; i++) {
            point[i] = vec(100 * any(), 100 * any(), 100 * any());
            path_add_point(&path, (struct pose){point[i], axis[i / 2]}, i % 2 == 0);
        }
        ck_assert(post_frame_planes(&path, &planes));
        ck_assert_uint_eq(planes.n, 2);
        ck_assert_int_eq(post_frame_tilt(&path, &m, &planes, angles, digits, &e), 0);
        ck_assert_uint_eq(path.item.n, 5);
        ck_assert_int_eq(path.item.item[2].kind, PATH_PLANE);
        double most = RADIANS(1.5 * pow(10, -digits));
        for (int i = 0; i < 4; i++) {
            const struct nc_plane *p = &planes.item[i / 2];
            struct pose at = path.item.item[i + i / 2].to;
            ck_assert_double_lt(vec_distance(to_work(p, angles, at.p), point[i]), 1e-9);
            ck_assert_double_lt(vec_angle(to_work(p, angles, at.a), axis[i / 2]), most);
            ck_assert(num_round(p->a, digits) == p->a && num_round(p->k, digits) == p->k);
        }
        array_free(&planes);
        path_free(&path);
    }
}
END_TEST

START_TEST(where_the_axis_may_change)
{
    const struct vec3 up = {0, 0, 1}, lean = {0, 0.6, 0.8};
    struct nc_planes planes = {0};
    struct path path = {.name = "path"};
    path_add_point(&path, (struct pose){vec(0, 0, 0), up}, true);
    path_add_point(&path, (struct pose){vec(1, 0, 0), up}, false);
    ck_assert(post_frame_planes(&path, &planes) && post_frame_upright(&planes));
    path_add_point(&path, (struct pose){vec(1, 0, 9), lean}, true);
    path_add_point(&path, (struct pose){vec(1, 0, 8), lean}, false);
    ck_assert(post_frame_planes(&path, &planes) && planes.n == 2 && !post_frame_upright(&planes));
    path_add_point(&path, (struct pose){vec(2, 0, 8), up}, false); /* in the cut */
    ck_assert(!post_frame_planes(&path, &planes) && planes.n == 0);
    path.item.n--;
    path_add_tool(&path, (struct path_tool){.number = 2});
    path_add_point(&path, (struct pose){vec(2, 0, 8), up}, false); /* with another tool */
    ck_assert(post_frame_planes(&path, &planes) && planes.n == 3);
    array_free(&planes);
    path_free(&path);
}
END_TEST

START_TEST(inches_are_lengths_alone)
{
    struct machine m = reaching();
    struct nc_plan_options options = {
        .chord = 0.0254, .axis_tolerance = 0.1, .feed = 254, .unit = 1};
    struct path path = {.name = "path"};
    path.head.clearance = 25.4;
    *array_push(&path.cycle) = (struct path_cycle){
        .depth = 25.4, .clear = 2.54, .retract = 5.08, .dwell = 3, .feed = 508, .pitch = 1.27};
    path_add_hole(&path, (struct pose){vec(254, 0, -25.4), vec(0, 0, 1)}, 0);
    post_frame_inch(&path, &m, &options);
    const struct path_cycle *c = &path.cycle.item[0];
    ck_assert_double_eq_tol(path.item.item[0].to.p.x, 10, 1e-12);
    ck_assert_double_eq_tol(c->depth, 1, 1e-12);
    ck_assert_double_eq_tol(c->pitch, 0.05, 1e-12);
    ck_assert_double_eq_tol(c->feed, 20, 1e-12);
    ck_assert_double_eq(c->dwell, 3);
    ck_assert_double_eq_tol(options.feed, 10, 1e-12);
    ck_assert_double_eq(options.axis_tolerance, 0.1);
    path_free(&path);
}
END_TEST

/* Holes of the path, what no cycle of a control makes among them, and not what lies behind it. */
START_TEST(holes_of_the_path)
{
    struct path_item item[3] = {
        {.kind = PATH_HOLE}, {.kind = PATH_POINT}, {.kind = PATH_HOLE, .index = 1}};
    struct path_cycle cycle[2] = {{.kind = CYCLE_DRILL, .clear = 1},
                                  {.kind = CYCLE_DRILL, .clear = -1}};
    struct path path = {.item = {.item = item, .n = 2}, .cycle = {.item = cycle, .n = 2}};
    ck_assert(post_frame_holes(&path));
    path.item.n = 3;
    ck_assert(!post_frame_holes(&path));
    cycle[1] = (struct path_cycle){.kind = CYCLE_TAP, .clear = 1};
    ck_assert(!post_frame_holes(&path)); /* neither pitch nor spindle */
    path.head.spindle = 500;
    ck_assert(post_frame_holes(&path));
    cycle[1].kind = CYCLE_MANUAL;
    ck_assert(!post_frame_holes(&path));
    item[0].kind = PATH_POINT;
    path.item.n = 2;
    ck_assert(!post_frame_holes(&path));
}
END_TEST

int main(void)
{
    state = seed_begin(state);
    Suite *suite = suite_create("post_frame");
    TCase *tc = tcase_create("frames");
    tcase_add_loop_test(tc, points_come_back_by_the_printed_angles, 0, 8);
    tcase_add_test(tc, where_the_axis_may_change);
    tcase_add_test(tc, inches_are_lengths_alone);
    tcase_add_test(tc, holes_of_the_path);
    suite_add_tcase(suite, tc);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

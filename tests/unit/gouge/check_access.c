/* access - the open directions beside a wall, over a plane, in a groove and in a cone, whose limits
 * are known exactly; against the tool held at every single guard point. */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"
#include "gouge/access.h"
#include "seed.h"

enum { RADIUS = 5 };

static struct sphere_grid grid;

static void add_plane(struct vec3s *points, struct vec3 corner, struct vec3 u, struct vec3 v,
                      int nu, int nv)
{
    for (int i = 0; i <= nu; i++)
        for (int k = 0; k <= nv; k++)
            *array_push(points) = vec_along(vec_along(corner, i, u), k, v);
}

static struct access *access_of(const struct gouge_check *guard, const struct holder *holder,
                                double margin, double slope)
{
    struct access_options options = {guard, holder, &grid, 0.01, margin, slope, 0, 1};

    return access_new(&options);
}

/* A cylinder of R that stands at c and a wall x >= c.x + far: the axis leans towards it by no more
 * than asin((far - R) / length). */
START_TEST(wall_limits_the_lean_towards_it)
{
    const double far = 7, length = 20;
    struct holder flute = {1, {{RADIUS, RADIUS, length}}};
    struct vec3s points = {0};
    add_plane(&points, vec(far, -40, -5), vec(0, 0.2, 0), vec(0, 0, 0.2), 400, 250);
    struct gouge_check *guard = gouge_new(points, 1);
    struct access *access = access_of(guard, &flute, 0, 0);
    /* the rim of the upper end touches: length sin(a) + R cos(a) = far */
    double low = 0, high = PI / 4;
    for (int k = 0; k < 60; k++) {
        double a = (low + high) / 2;
        *(length * sin(a) + RADIUS * cos(a) < far ? &low : &high) = a;
    }
    for (int k = -80; k <= 80; k++) {
        double a = RADIANS(k);
        bool open = access_is_open(access, vec(0, 0, 0), vec(sin(a), 0, cos(a)));
        if (fabs(a - low) > RADIANS(0.2))
            ck_assert_msg(open == (a < low), "%d degrees", k);
    }
    access_free(access);
    gouge_free(guard);
}
END_TEST

/* In a groove of half width w and depth h the axis leans across by no more than the groove lets it;
 * along it is free. */
START_TEST(groove_is_open_along_itself)
{
    const double w = 6, depth = 30, length = 20;
    struct holder flute = {1, {{RADIUS, RADIUS, length}}};
    struct vec3s points = {0};
    for (int side = -1; side <= 1; side += 2)
        add_plane(&points, vec(side * w, -60, -5), vec(0, 0.25, 0), vec(0, 0, 0.25), 480,
                  (int)((depth + 5) * 4));
    add_plane(&points, vec(-w, -60, -5), vec(0.25, 0, 0), vec(0, 0.25, 0), 48, 480);
    struct gouge_check *guard = gouge_new(points, 1);
    struct access *access = access_of(guard, &flute, 0, 0);
    unsigned char *state = mem_alloc((size_t)grid.n, 1);
    int open = access_find(access, vec(0, 0, 0), vec(0, 0, 1), vec(0, 0, 1), PI, state), seen = 0;
    for (int i = 0; i < grid.n; i++) {
        struct vec3 a = grid.at[i];
        /* half the width that the leaning cylinder takes, at its upper end */
        double across = fabs(a.x) * length + RADIUS * sqrt(1 - a.x * a.x);
        bool fits = across < w && a.z > cos(ACCESS_STEEPEST);
        if (fabs(across - w) > 0.05 && fabs(a.z - cos(ACCESS_STEEPEST)) > 1e-9)
            ck_assert_msg((state[i] == ACCESS_OPEN) == fits, "%g %g %g", a.x, a.y, a.z);
        seen += state[i] != ACCESS_BLOCKED;
    }
    ck_assert_int_eq(open, seen);
    ck_assert_int_ge(open, 2);
    free(state);
    access_free(access);
    gouge_free(guard);
}
END_TEST

/* At the bottom of a cone of half angle b, seen from far below its edge, a thin tool leans up to
 * where it touches the side: R = distance from the cone's side at the tool's length. */
START_TEST(cone_is_open_around_its_axis)
{
    const double b = RADIANS(35), length = 25, radius = 1, z0 = 4; /* centre above the apex */
    struct holder thin = {1, {{radius, radius, length}}};
    struct vec3s points = {0};
    for (int i = 1; i < 400; i++) {
        int n = (int)(2 * PI * i * 0.1 / 0.1) + 8;
        for (int k = 0; k < n; k++) {
            double r = i * 0.1, turn = 2 * PI * k / n;
            *array_push(&points) = vec(r * cos(turn), r * sin(turn), r / tan(b));
        }
    }
    struct gouge_check *guard = gouge_new(points, 1);
    struct access *access = access_of(guard, &thin, 0, 0);
    /* in the plane of the lean: rim at length L: height z0 + L cos a + R sin a,
     * radius L sin a - R cos a inside, + on the outer side */
    double low = 0, high = PI / 2;
    for (int k = 0; k < 60; k++) {
        double a = (low + high) / 2;
        double out = length * sin(a) + radius * cos(a);
        double up = z0 + length * cos(a) - radius * sin(a);
        *(out < up * tan(b) ? &low : &high) = a;
    }
    for (int k = 0; k < 36; k++) {
        struct vec3 side = vec(cos(RADIANS(10 * k)), sin(RADIANS(10 * k)), 0);
        for (double a = 0; a < RADIANS(80); a += RADIANS(0.5)) {
            struct vec3 axis = vec_along(vec_scale(sin(a), side), cos(a), vec(0, 0, 1));
            if (fabs(a - low) > RADIANS(0.5))
                ck_assert_msg(access_is_clear(access, vec(0, 0, z0), axis) == (a < low),
                              "%d: %g of %g", k, DEGREES(a), DEGREES(low));
        }
    }
    access_free(access);
    gouge_free(guard);
}
END_TEST

/* A hole as wide as the tool, but for less than the margin, is tight: open without it. */
START_TEST(tight_holes_are_open_without_margin)
{
    struct holder flute = {1, {{RADIUS, RADIUS, 10}}};
    struct vec3s points = {0};
    for (int h = 0; h <= 60; h++)
        for (int k = 0; k < 360; k++)
            *array_push(&points) =
                vec(5.02 * cos(RADIANS(k)), 5.02 * sin(RADIANS(k)), -2 + 0.25 * h);
    struct gouge_check *guard = gouge_new(points, 1);
    struct access *access = access_of(guard, &flute, 0.05, 0.001);
    ck_assert(!access_is_open(access, vec(0, 0, 0), vec(0, 0, 1)));
    ck_assert(access_is_clear(access, vec(0, 0, 0), vec(0, 0, 1)));
    access_free(access);
    gouge_free(guard);
}
END_TEST

/* Whatever the points and the tool: a direction is open exactly if the stack, widened, holds no
 * point higher than the centre. */
START_TEST(as_every_point_says)
{
    struct holder tool = {3, {{3, 3, 12}, {5, 8, 6}, {8, 8, 10}}};
    struct holder wide = holder_widened(&tool, 0.3, 0.01);
    unsigned state = 7;
    for (int trial = 0; trial < 20; trial++) {
        struct vec3s points = {0};
        for (int i = 0; i < 60; i++) {
            double c[3];
            for (int d = 0; d < 3; d++) {
                state = state * 1664525u + seed_step_32();
                c[d] = (state >> 8) / 16777216.0 * 32 - 16;
            }
            *array_push(&points) = vec(c[0], c[1], c[2]);
        }
        struct gouge_check *guard = gouge_from_points(points.item, points.n);
        struct access *access = access_of(guard, &tool, 0.3, 0.01);
        for (int i = 0; i < grid.n; i++) {
            bool clear = true;
            for (size_t k = 0; k < points.n; k++)
                clear =
                    clear && holder_distance(&wide, vec(0, 0, 0), grid.at[i], points.item[k]) >= 0;
            ck_assert(access_is_open(access, vec(0, 0, 0), grid.at[i]) == clear);
        }
        access_free(access);
        gouge_free(guard);
        array_free(&points);
    }
}
END_TEST

int main(void)
{
    grid = sphere_grid_new(vec(0, 0, 1));
    Suite *suite = suite_create("access");
    TCase *tcase = tcase_create("access");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, wall_limits_the_lean_towards_it);
    tcase_add_test(tcase, groove_is_open_along_itself);
    tcase_add_test(tcase, cone_is_open_around_its_axis);
    tcase_add_test(tcase, tight_holes_are_open_without_margin);
    tcase_add_test(tcase, as_every_point_says);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    sphere_grid_free(&grid);
    return failed ? 1 : 0;
}

/* project: on the surface z = x y / 25, whose points and normals are known. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "nurbs/project.h"
#include "seed.h"

static uint64_t state = 11;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static double knots[] = {0, 0, 1, 1};
static struct nurbs_pole poles[] = {{0, 0, 0, 1}, {10, 0, 0, 1}, {0, 10, 0, 1}, {10, 10, 4, 1}};

static struct patch saddle(void)
{
    struct nurbs_axis axis = {1, 2, knots, 0, 1};

    return (struct patch){.surface = {axis, axis, poles}};
}

START_TEST(points_go_to_the_surface_and_stay_in_their_plane)
{
    struct patch patch = saddle();
    struct patches patches = {.n = 1, .item = &patch};
    struct projection *on = project_new(&patches, 0.01);

    for (int i = 0; i < 300; i++) {
        double x = uniform(0.3, 9.7), y = uniform(0.3, 9.7), angle = uniform(0, 7);
        struct vec3 n = vec_unit(vec(-y / 25, -x / 25, 1));
        struct vec3 plane = vec_unit(vec(cos(angle), sin(angle), uniform(-0.3, 0.3)));
        struct contact c = {vec_along(vec(x, y, x * y / 25), uniform(-0.1, 0.1), n), n}, was;
        /* A normal that is a little off, as one that is mixed from two. */
        c.n = vec_unit(vec_add(n, vec(uniform(-0.02, 0.02), uniform(-0.02, 0.02), 0)));
        was = c;
        ck_assert_int_eq(project_contact(on, plane, 0.2, &c), 0);
        ck_assert_double_eq_tol(c.p.z, c.p.x * c.p.y / 25, 1e-9);
        ck_assert_double_eq_tol(vec_dot(vec_sub(c.p, was.p), plane), 0, 1e-12);
        struct vec3 exact = vec_unit(vec(-c.p.y / 25, -c.p.x / 25, 1));
        ck_assert_double_lt(vec_distance(c.n, exact), 1e-9);
    }
    project_free(on);
}
END_TEST

START_TEST(what_is_elsewhere_stays)
{
    struct patch patch = saddle();
    struct patches patches = {.n = 1, .item = &patch};
    struct projection *on = project_new(&patches, 0.01);
    struct contact beside = {vec(11, 5, 2.2), vec(0, 0, 1)}, above = {vec(5, 5, 2), vec(0, 0, 1)};
    struct contact c = beside;

    ck_assert_int_eq(project_contact(on, vec(0, 1, 0), 5, &c), -1);
    ck_assert_double_eq(vec_distance(c.p, beside.p), 0);
    c = above;
    ck_assert_int_eq(project_contact(on, vec(0, 1, 0), 0.5, &c), -1);
    ck_assert_double_eq(vec_distance(c.p, above.p), 0);
    /* On the border, beyond it by what six decimals leave. */
    c = (struct contact){vec(10.0000004, 5, 2), vec(-0.2, -0.4, 0.9)};
    ck_assert_int_eq(project_contact(on, vec(0, 1, 0), 0.5, &c), 0);
    project_free(on);
}
END_TEST

/* A circle of radius 3 about (5, 5), in plan, is cut out: what lies in it has no surface. */
START_TEST(what_is_trimmed_away_is_none)
{
    struct patch patch = saddle();
    struct patches patches = {.n = 1, .item = &patch};
    struct patch_loop loop = {.n = 1};
    struct nurbs_curve curve = patch_curve(1, 361);
    for (int i = 0; i <= 360; i++) {
        double a = RADIANS(i);
        curve.pole[i] = (struct nurbs_pole){0.5 + 0.3 * cos(a), 0.5 + 0.3 * sin(a), 0, 1};
        curve.t.knot[1 + i] = i / 360.0;
    }
    curve.t.knot[362] = 1;
    loop.item = &curve;
    patch.loop.n = 1;
    patch.loop.item = &loop;
    patch.open = true;
    struct projection *on = project_new(&patches, 0.01);
    for (int i = 0; i < 300; i++) {
        double r = uniform(0.1, 4.5), a = uniform(0, 7);
        double x = 5 + r * cos(a), y = 5 + r * sin(a);
        struct contact c = {vec(x, y, x * y / 25 + 0.01), vec_unit(vec(-y / 25, -x / 25, 1))};
        int got = project_contact(on, vec(0, 1, 0), 0.2, &c);
        if (r < 2.98 || r > 3.005)
            ck_assert_int_eq(got, r < 3 ? -1 : 0);
    }
    project_free(on);
    nurbs_curve_free(&curve);
}
END_TEST

/* A triangle: what is beyond any of its three sides by less than the slack goes there, what is
 * farther does not. */
START_TEST(every_side_of_the_trimming)
{
    static const double corner[3][2] = {{2, 2}, {8, 3}, {4, 8}};
    struct patch patch = saddle();
    struct patches patches = {.n = 1, .item = &patch};
    struct patch_loop loop = {0};
    struct nurbs_curve side[3];
    for (int i = 0; i < 3; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % 3];
        side[i] = patch_line((struct uv){a[0] / 10, a[1] / 10}, (struct uv){b[0] / 10, b[1] / 10});
    }
    loop.n = 3;
    loop.item = side;
    patch.loop.n = 1;
    patch.loop.item = &loop;
    struct projection *on = project_new(&patches, 0.5);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 80;
             k++) { /* at 40 places, a little nearer than the slack and farther */
            const double *a = corner[i], *b = corner[(i + 1) % 3];
            double off = k % 2 ? 0.44 : 0.56, l = hypot(b[0] - a[0], b[1] - a[1]);
            double along = 0.02 + 0.024 * (k / 2);
            double x = a[0] + along * (b[0] - a[0]) + off * (b[1] - a[1]) / l;
            double y = a[1] + along * (b[1] - a[1]) - off * (b[0] - a[0]) / l;
            struct contact c = {vec(x, y, x * y / 25), vec_unit(vec(-y / 25, -x / 25, 1))};
            ck_assert_int_eq(project_contact(on, vec(0, 1, 0), 5, &c), k % 2 ? 0 : -1);
        }
    project_free(on);
    for (int i = 0; i < 3; i++)
        nurbs_curve_free(&side[i]);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("project");
    TCase *tests = tcase_create("project");
    tcase_add_test(tests, points_go_to_the_surface_and_stay_in_their_plane);
    tcase_add_test(tests, what_is_elsewhere_stays);
    tcase_add_test(tests, what_is_trimmed_away_is_none);
    tcase_add_test(tests, every_side_of_the_trimming);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* plane_passes on a gutter: how long all passes are, and in which direction they are the shortest.
 */
#include "stage/plane_passes.h"

#include <check.h>
#include <stdlib.h>

#include "stage/path_options.h"
#include "toolpath/scallop.h"

enum { ALONG = 40, AROUND = 30 };

static const double GUTTER = 20, BALL = 5, CUSP = 0.02;

/* A hollow part of a cylinder about x: 40 mm long, 1.5 radians around, with its normals. */
static struct mesh make_gutter(void)
{
    struct mesh mesh = {0};
    for (int j = 0; j <= AROUND; j++) {
        for (int i = 0; i <= ALONG; i++) {
            double a = 0.05 * (j - AROUND / 2);
            *array_push(&mesh.vertex) = vec(i, GUTTER * sin(a), -GUTTER * cos(a));
            *array_push(&mesh.normal) = vec(0, -sin(a), cos(a));
        }
    }
    for (int j = 0; j < AROUND; j++) {
        for (int i = 0; i < ALONG; i++) {
            int v = (ALONG + 1) * j + i;
            *array_push(&mesh.face) = (struct face){{v, v + 1, v + ALONG + 1}};
            *array_push(&mesh.face) = (struct face){{v + 1, v + ALONG + 2, v + ALONG + 1}};
        }
    }
    mesh.origin.ledger = NAN;
    return mesh;
}

START_TEST(the_shortest_direction_is_along_a_gutter)
{
    struct mesh mesh = make_gutter();
    double length, angle = plane_passes_best(&mesh, BALL, CUSP, &length);
    /* 40 mm for each step around, at most as far apart as the cusps allow at every place */
    double step = scallop_step(CUSP, BALL, -1 / GUTTER), around = 2 * 0.75 * GUTTER;
    ck_assert_double_eq_tol(angle, 0, 1e-12);
    ck_assert_double_ge(length, 40 * around / step);
    ck_assert_double_le(length, 1.25 * 40 * (around / step + 2));
    mesh_free(&mesh);
}
END_TEST

START_TEST(directions_are_read)
{
    struct mesh mesh = make_gutter();
    double angle;
    angle = plane_passes_direction("30", &mesh, BALL, CUSP);
    ck_assert_double_eq_tol(angle, PI / 6, 1e-12);
    angle = plane_passes_direction("auto", &mesh, BALL, CUSP);
    ck_assert_double_eq_tol(angle, 0, 1e-12);
    ck_assert(plane_passes_direction_read("auto") && plane_passes_direction_read("30"));
    ck_assert(!plane_passes_direction_read("automatic") && !plane_passes_direction_read("30d"));
    mesh_free(&mesh);
}
END_TEST

START_TEST(planes_become_passes)
{
    struct mesh mesh = make_gutter();
    struct plane_passes p = {.rule = plane_passes_upright(PI / 2, BALL)};
    struct path path = {0};
    struct toolpath t = {.path = &path,
                         .rule = {.radius = BALL,
                                  .feed = 800,
                                  .plunge = 300,
                                  .clearance = 20,
                                  .approach = 3,
                                  .longest = 6},
                         .lift = {.limit = BALL,
                                  .tolerance = 0.01,
                                  .step = 0.05,
                                  .axis = {.kind = AXIS_FIXED, .direction = {0, 0, 1}}}};
    path_options.radius = BALL;
    plane_passes_equal(&p, &mesh, 4);
    ck_assert_uint_eq(p.height.n, 11); /* 40 mm, the last plane 0.04 inside */
    struct error error;
    ck_assert_int_eq(plane_passes_make(&p, 1, &t, &error), 0);
    toolpath_end(&t);
    size_t passes = 0;
    double x = HUGE_VAL;
    for (size_t i = 0; i < path.item.n; i++) {
        const struct path_item *item = &path.item.item[i];
        if (item->kind == PATH_PASS)
            passes++;
        if (item->kind != PATH_POINT || !item->touches)
            continue;
        struct vec3 ball = vec_along(item->to.p, BALL, item->to.a);
        ck_assert_double_eq_tol(hypot(ball.y, ball.z), GUTTER - BALL, 1e-3);
        x = fmin(x, ball.x);
    }
    ck_assert_uint_eq(passes, 11);
    ck_assert_double_eq_tol(x, 0, 1e-9);
    plane_passes_free(&p);
    path_free(&path);
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("plane_passes");
    TCase *tcase = tcase_create("plane_passes");
    tcase_add_test(tcase, the_shortest_direction_is_along_a_gutter);
    tcase_add_test(tcase, directions_are_read);
    tcase_add_test(tcase, planes_become_passes);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

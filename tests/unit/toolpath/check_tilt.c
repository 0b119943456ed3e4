/* Tests of tilt.h and path_tilt.h on a cylinder, where the frames are known. */
#include "toolpath/tilt.h"

#include <check.h>
#include <stdlib.h>

#include "stage/path_tilt.h"

/* Along a convex cylinder about the y axis, to +x or back; normals outward, ball of radius 4. */
static struct run over(bool back)
{
    struct run run = {.radius = 4};
    for (int i = 0; i < 9; i++) {
        double u = (back ? 4 - i : i - 4) * 0.1;
        struct vec3 n = vec(sin(u), 0, cos(u));
        *array_push(&run) = (struct run_point){.tip = vec_scale(30, n),
                                               .ball = vec_scale(34, n),
                                               .axis = n,
                                               .contact = vec_scale(30, n),
                                               .normal = n,
                                               .given = true};
    }
    return run;
}

START_TEST(leans_to_the_same_side_on_zig_and_on_zag)
{
    for (int frenet = 0; frenet < 2; frenet++) {
        struct vec3 side = {0};
        for (int row = 0; row < 4; row++) {
            struct run run = over(row % 2);
            tilt_run(&run, RADIANS(15), frenet, &side);
            for (size_t i = 0; i < run.n; i++) {
                struct vec3 n = run.item[i].normal, a = run.item[i].axis;
                struct vec3 want = vec_along(vec(0, sin(RADIANS(15)), 0), cos(RADIANS(15)), n);
                ck_assert_double_lt(vec_distance(a, want), 1e-9);
                ck_assert_double_lt(vec_distance(run.item[i].ball, vec_scale(34, n)), 1e-12);
                struct vec3 tip = vec_along(run.item[i].ball, -4, a);
                ck_assert_double_lt(vec_distance(run.item[i].tip, tip), 1e-12);
            }
            array_free(&run);
        }
    }
}
END_TEST

START_TEST(without_length_or_normal_the_axis_stays)
{
    struct run run = {.radius = 4};
    struct vec3 side = {0}, axis = vec(0, 0.6, 0.8);
    for (int i = 0; i < 3; i++)
        *array_push(&run) = (struct run_point){.axis = axis, .normal = vec(0, 0, 1)};
    for (int frenet = 0; frenet < 2; frenet++) {
        tilt_run(&run, 0.3, frenet, &side);
        for (size_t i = 0; i < run.n; i++)
            ck_assert_double_eq(vec_distance(run.item[i].axis, axis), 0);
    }
    array_free(&run);
}
END_TEST

START_TEST(the_moves_beside_a_run_go_with_it)
{
    struct path path = {.name = "test"};
    path.head.cutter[0] = 8;
    path.head.cutter[1] = 4;
    path.head.cutter_n = 2;
    struct run run = over(false);
    struct pose first = {run.item[0].tip, run.item[0].axis};
    struct pose above = {vec_along(first.p, 20, first.a), first.a};
    struct pose far = {vec(0, 0, 99), vec(1, 0, 0)};
    path_add_point(&path, far, true);
    path_add_point(&path, above, true);
    for (size_t i = 0; i < run.n; i++) {
        struct path_item *item =
            path_add_point(&path, (struct pose){run.item[i].tip, run.item[i].axis}, false);
        path_set_contact(&path, item, (struct contact){run.item[i].contact, run.item[i].normal});
    }
    struct error error;
    ck_assert_int_eq(path_set_tilt(&path, 0.2, false, &error), 0);
    struct pose now = path.item.item[1].to, start = path.item.item[2].to;
    ck_assert_double_eq(vec_distance(path.item.item[0].to.p, far.p), 0);
    ck_assert_double_lt(vec_distance(now.a, start.a), 1e-15);
    ck_assert_double_lt(fabs(vec_angle(now.a, first.a) - 0.2), 1e-9);
    struct vec3 was_ball = vec_along(above.p, 4, above.a), ball = vec_along(now.p, 4, now.a);
    ck_assert_double_lt(vec_distance(was_ball, ball), 1e-12);
    for (size_t i = 0; i < path.item.n; i++)
        path.item.item[i].touches = false;
    ck_assert_int_eq(path_set_tilt(&path, 0.2, false, &error), -1);
    path_free(&path);
    array_free(&run);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("tilt");
    tcase_add_test(t, leans_to_the_same_side_on_zig_and_on_zag);
    tcase_add_test(t, without_length_or_normal_the_axis_stays);
    tcase_add_test(t, the_moves_beside_a_run_go_with_it);
    Suite *s = suite_create("tilt");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

/* Tests of layer_distance_of: layers whose distance is known. */
#include "plot/plot.h"

#include <check.h>
#include <stdlib.h>

#include "shapes.h"

/* A layer of one stroke along a circle about the origin, in pieces of a degree. */
static struct layer circle(double radius, double height)
{
    struct layer layer = {.name = "circle"};
    for (int i = 0; i <= 360; i++) {
        double u = RADIANS(i);
        *array_push(&layer.node) = vec(radius * cos(u), radius * sin(u), height);
    }
    *array_push(&layer.stroke) = (struct stroke){.kind = STROKE_LINE, .to = layer.node.n};
    return layer;
}

START_TEST(two_circles)
{
    struct layer small = circle(20, 0), large = circle(20.3, 0.4);
    struct layer_distance d = layer_distance_of(&small, &large, 2);
    ck_assert_double_eq_tol(d.worst, 0.5, 0.003); /* chords of a degree */
    ck_assert_double_eq_tol(d.rms, 0.5, 0.003);
    ck_assert_double_le(d.most95, d.worst);
    ck_assert_uint_gt(d.n, 1000); /* between the nodes too */
    /* a rapid move far away is no part of it, a cut is */
    for (int i = 0; i < 2; i++)
        *array_push(&small.node) = vec(0, 0, 50 + i);
    *array_push(&small.stroke) =
        (struct stroke){.kind = STROKE_RAPID, .from = small.node.n - 2, .to = small.node.n};
    ck_assert_double_lt(layer_distance_of(&small, &large, 1).worst, 1);
    small.stroke.item[1].kind = STROKE_ARC;
    d = layer_distance_of(&small, &large, 1);
    ck_assert_double_gt(d.worst, 50);
    ck_assert_double_eq_tol(d.at.z, 51, 1e-9);
    ck_assert_double_lt(d.most95, 1);
    layer_free(&small);
    layer_free(&large);
}
END_TEST

START_TEST(points_over_a_mesh)
{
    struct layer mesh = {.mesh = shape_ball(10, 90, 90)}, cloud = {0};
    for (int i = 0; i < 500; i++) {
        double z = -1 + 2 * (i + 0.5) / 500, u = 2.4 * i, r = sqrt(1 - z * z);
        *array_push(&cloud.point) = vec_scale(10.25, vec(r * cos(u), r * sin(u), z));
    }
    struct layer_distance d = layer_distance_of(&cloud, &mesh, 1);
    ck_assert_uint_eq(d.n, 500);
    ck_assert_double_eq_tol(d.worst, 0.255, 0.01); /* facets stand 0.012 within at most */
    ck_assert_double_eq_tol(d.rms, 0.255, 0.01);
    ck_assert_uint_eq(layer_distance_of(&cloud, &(struct layer){0}, 1).n, 0);
    layer_free(&mesh);
    layer_free(&cloud);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("layer_distance");
    tcase_add_test(t, two_circles);
    tcase_add_test(t, points_over_a_mesh);
    Suite *s = suite_create("layer_distance");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}

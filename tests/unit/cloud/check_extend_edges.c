/* extend_edges: a roof between walls and slopes is continued in its own surface, over convex edges
 * alone, so far as is asked. */
#include <check.h>
#include <stdlib.h>

#include "cloud/segment_steps.h"
#include "rough.h"

static const double SPACING = 0.35, LENGTH = 2;

/* What is put beyond the first `own` of the points. */
static struct vec3s beyond(const struct vec3s *p, size_t own)
{
    size_t *near = cloud_neighbours(p->item, p->n, 2);
    struct vec3 *normal = mem_alloc(p->n, sizeof *normal);
    bool *in = mem_alloc(p->n, sizeof *in);
    struct vec3s found = {0};
    cloud_normals(p->item, p->n, near, vec(0, 0, 1), 2, normal);
    for (size_t i = 0; i < p->n; i++)
        in[i] = i < own;
    struct extend_edges cloud = {p->item, normal, near, p->n, in};
    extend_edges_find(&cloud, SPACING, LENGTH, &found);
    free(in);
    free(normal);
    free(near);
    return found;
}

/* A square roof of 20 mm at z = 10, all around by 90 or 45 degrees down, or (up) rising walls. */
static void check_roof(double out, double height, double noise, size_t least)
{
    struct vec3s p = {0};
    rectangle(&p, 3600, vec(-10, -10, 10), vec(20, 0, 0), vec(0, 20, 0), noise);
    for (int side = 0; side < 4; side++) {
        struct vec3 w = vec(cos(PI / 2 * side), sin(PI / 2 * side), 0);
        struct vec3 along = vec(-w.y, w.x, 0);
        struct vec3 corner = vec_along(vec_scale(10, w), -10, along);
        corner.z = 10;
        struct vec3 down = vec_scale(out, w);
        down.z = height;
        rectangle(&p, 1500, corner, vec_scale(20, along), down, noise);
    }
    struct vec3s found = beyond(&p, 3600);
    double reach = 0;
    ck_assert_uint_ge(found.n, least);
    for (size_t i = 0; i < found.n; i++) {
        struct vec3 q = found.item[i];
        double off = fmax(fabs(q.x), fabs(q.y)) - 10;
        ck_assert_double_le(fabs(q.z - 10), 1e-9 + 8 * noise);
        ck_assert_double_ge(off, -2 * SPACING);
        ck_assert_double_le(off, LENGTH + SPACING);
        reach = fmax(reach, off);
        size_t next = (i + 1) % found.n;
        ck_assert_double_ge(vec_distance(q, found.item[next]), 0.75 * SPACING - 1e-9);
    }
    ck_assert(least == 0 || reach > LENGTH - SPACING);
    if (least == 0)
        ck_assert_uint_eq(found.n, 0);
    array_free(&found);
    array_free(&p);
}

START_TEST(over_convex_edges)
{
    check_roof(0, -10, 0, 800);
    check_roof(0, -10, 0.02, 800);
    check_roof(7, -7, 0, 800);
}
END_TEST

START_TEST(not_into_rising_walls_nor_over_smooth_borders)
{
    check_roof(0, 10, 0, 0);
    check_roof(8, 2, 0, 0);
    check_roof(8, -2, 0, 0);
}
END_TEST

/* A round bar with a cap: its own surface goes on straight. */
START_TEST(round_edges)
{
    struct vec3s p = {0};
    size_t side = 7000;
    for (size_t i = 0; i < side; i++) {
        double a = 2 * PI * uniform();
        *array_push(&p) = vec(8 * cos(a), 8 * sin(a), 20 * uniform());
    }
    for (int i = 0; i < 1500; i++) {
        double a = 2 * PI * uniform(), r = 8 * sqrt(uniform());
        *array_push(&p) = vec(r * cos(a), r * sin(a), 20);
    }
    struct vec3s found = beyond(&p, side);
    ck_assert_uint_ge(found.n, 250);
    for (size_t i = 0; i < found.n; i++) {
        ck_assert_double_le(fabs(hypot(found.item[i].x, found.item[i].y) - 8), 0.03);
        /* the border is where the last points are: 4 by 4 spacings without one of 7 a mm^2 are
         * there            once in a million */
        ck_assert_double_ge(found.item[i].z, 20 - 4 * SPACING);
    }
    array_free(&found);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("extend_edges");
    TCase *tests = tcase_create("extend_edges");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, over_convex_edges);
    tcase_add_test(tests, not_into_rising_walls_nor_over_smooth_borders);
    tcase_add_test(tests, round_edges);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

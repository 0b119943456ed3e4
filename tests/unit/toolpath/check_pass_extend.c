/* pass_extend on a hollow whose scan goes beyond its mesh: how far rows run out (seen along the
 * normal the last points curve) and which rows are added. */
#include "toolpath/pass_extend.h"

#include <check.h>
#include <stdlib.h>

#include "toolpath/passes.h"
#include "shapes.h"

static const struct vec3 ALONG = {1, 0, 0}, ACROSS = {0, 1, 0};

static struct vec3 hollow(double x, double y, struct vec3 *normal)
{
    *normal = vec_unit(vec(-x / 30, -y / 30, 1));
    return vec(x, y, (x * x + y * y) / 60);
}

/* A scan half a millimetre fine out to `half`, beyond a mesh of 18 by 18 mm. */
static struct border_surface *border_surface_of(double half)
{
    struct mesh mesh = shape_grid(hollow, -9, -9, 9, 9, 18, 18);
    struct vec3s scan = {0};
    struct vec3 normal;
    int n = (int)(half / 0.5);

    for (int j = -n; j <= n; j++)
        for (int i = -n; i <= n; i++)
            *array_push(&scan) = hollow(i * 0.5, j * 0.5, &normal);
    struct vec3s none = {0};
    struct border_surface_options rule = {&scan, &none, 1, 5, 0.005};
    struct border_surface *border_surface = border_surface_new(&rule, &mesh);
    array_free(&scan);
    mesh_free(&mesh);
    return border_surface;
}

static void add_strip(double y, double from, double to, struct slice_chains *strips)
{
    struct slice_chain chain = {strips->point.n, 0, false};

    for (double x = from; x <= to; x += 0.5) {
        struct contact c;
        c.p = hollow(x, y, &c.n);
        *array_push(&strips->point) = c;
    }
    chain.to = strips->point.n;
    *array_push(&strips->chain) = chain;
}

static double first_of(const struct slice_chains *s, size_t k)
{
    return s->point.item[s->chain.item[k].from].p.x;
}

static double last_of(const struct slice_chains *s, size_t k)
{
    return s->point.item[s->chain.item[k].to - 1].p.x;
}

START_TEST(rows_run_out_to_the_last_points)
{
    struct border_surface *border_surface = border_surface_of(10);
    struct border_surface_plane plane = {ACROSS, ALONG, 3.2};
    struct slice_chains strips = {0};
    struct vec3 normal;

    add_strip(3.2, -9, 9, &strips);
    double length = slice_chains_length(&strips),
           added = pass_extend_ends(border_surface, &plane, &strips);
    ck_assert_uint_eq(strips.chain.n, 1);
    ck_assert_double_eq_tol(first_of(&strips, 0), -10, 0.04);
    ck_assert_double_eq_tol(last_of(&strips, 0), 10, 0.04);
    ck_assert_double_eq_tol(added, 2 * hypot(1, 9.5 / 30), 0.1);
    ck_assert_double_eq_tol(slice_chains_length(&strips), length + added, 1e-9);
    for (size_t i = 0; i < strips.point.n; i++) {
        struct vec3 p = strips.point.item[i].p;
        ck_assert(i == 0 || p.x > strips.point.item[i - 1].p.x);
        ck_assert_double_le(vec_distance(p, hollow(p.x, p.y, &normal)), 1e-5);
    }
    slice_chains_free(&strips);
    border_surface_free(border_surface);
}
END_TEST

START_TEST(what_lies_beyond_the_scan_is_left_out)
{
    struct border_surface *border_surface = border_surface_of(8);
    struct slice_chains strips = {0};

    add_strip(3.2, -9, 9, &strips);
    add_strip(8.6, -9, 9, &strips);
    ck_assert_uint_eq(pass_extend_within(border_surface, &strips),
                      4 + 37 - 4); /* ends are more than 1 mm off */
    ck_assert_uint_eq(strips.chain.n, 1);
    ck_assert_double_eq(first_of(&strips, 0), -8);
    ck_assert_double_eq(last_of(&strips, 0), 8);
    ck_assert_uint_eq(pass_extend_within(border_surface, &strips), 0);
    slice_chains_free(&strips);
    border_surface_free(border_surface);
}
END_TEST

START_TEST(a_few_points_have_no_border)
{
    struct border_surface *border_surface = border_surface_of(1); /* 25 points */
    struct border_surface_plane plane = {ACROSS, ALONG, 9};
    struct slice_chains strips = {0};

    add_strip(9, -9, 9, &strips);
    ck_assert_uint_eq(pass_extend_within(border_surface, &strips), 0);
    ck_assert_double_eq(pass_extend_ends(border_surface, &plane, &strips), 0);
    slice_chains_free(&strips);
    border_surface_free(border_surface);
}
END_TEST

START_TEST(rows_end_with_a_mesh_that_is_a_part_of_the_scan)
{
    struct border_surface *border_surface = border_surface_of(14);
    struct border_surface_plane plane = {ACROSS, ALONG, 3.2}, beyond = {ACROSS, ALONG, 9.5};
    struct slice_chains strips = {0}, end = {0}, none = {0};
    struct pass_extend_neighbours beside = {&end, NULL};

    add_strip(3.2, -9, 9, &strips);
    ck_assert_double_eq(pass_extend_ends(border_surface, &plane, &strips), 0);
    ck_assert_double_eq(last_of(&strips, 0), 9);
    add_strip(9, -9, 9, &end);
    ck_assert_double_eq(pass_extend_beside(border_surface, &beyond, &beside, 0.5, &none), 0);
    slice_chains_free(&strips);
    slice_chains_free(&end);
    border_surface_free(border_surface);
}
END_TEST

START_TEST(strips_grow_up_to_each_other)
{
    struct border_surface *border_surface = border_surface_of(10);
    struct border_surface_plane plane = {ACROSS, ALONG, 9.4};
    struct slice_chains strips = {0};

    add_strip(9.4, -4, -1, &strips);
    add_strip(9.4, 3, 5, &strips);
    pass_extend_ends(border_surface, &plane, &strips);
    ck_assert_uint_eq(strips.chain.n, 1);
    ck_assert_double_eq_tol(first_of(&strips, 0), -10, 0.04);
    ck_assert_double_eq_tol(last_of(&strips, 0), 10, 0.04);
    for (size_t i = 1; i < strips.point.n; i++)
        ck_assert_double_gt(strips.point.item[i].p.x, strips.point.item[i - 1].p.x);
    slice_chains_free(&strips);
    border_surface_free(border_surface);
}
END_TEST

START_TEST(rows_are_added_beside_others)
{
    struct border_surface *border_surface = border_surface_of(10);
    struct border_surface_plane plane = {ACROSS, ALONG, 9.6}, out = {ACROSS, ALONG, 10.1};
    struct slice_chains from = {0}, beyond = {0}, strips = {0}, parts = {0}, none = {0};
    struct pass_extend_neighbours all = {&from, NULL}, some = {&from, &beyond},
                                  last = {&strips, NULL};

    add_strip(9, -9, 9, &from);
    ck_assert_double_gt(pass_extend_beside(border_surface, &plane, &all, 0.5, &strips), 19.9);
    ck_assert_uint_eq(strips.chain.n, 1);
    ck_assert_double_eq_tol(first_of(&strips, 0), -10, 0.04);
    ck_assert_double_eq_tol(last_of(&strips, 0), 10, 0.04);
    ck_assert_double_eq(pass_extend_beside(border_surface, &plane, &all, 0.5, &strips), 0);
    ck_assert_double_eq(pass_extend_beside(border_surface, &out, &last, 0.5, &none), 0);

    add_strip(10, -2, 5, &beyond); /* what it has leaves two pieces, of which one is too short */
    pass_extend_beside(border_surface, &plane, &some, 0.5, &parts);
    ck_assert_uint_eq(parts.chain.n, 2);
    ck_assert_double_le(last_of(&parts, 0), -2);
    ck_assert_double_ge(first_of(&parts, 1), 5);
    slice_chains_free(&parts);
    pass_extend_beside(border_surface, &plane, &some, 6, &parts);
    ck_assert_uint_eq(parts.chain.n, 1);
    ck_assert_double_eq_tol(first_of(&parts, 0), -10, 0.04);
    slice_chains_free(&from);
    slice_chains_free(&beyond);
    slice_chains_free(&strips);
    slice_chains_free(&parts);
    border_surface_free(border_surface);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("pass_extend");
    TCase *tests = tcase_create("pass_extend");
    tcase_add_test(tests, rows_run_out_to_the_last_points);
    tcase_add_test(tests, what_lies_beyond_the_scan_is_left_out);
    tcase_add_test(tests, a_few_points_have_no_border);
    tcase_add_test(tests, rows_end_with_a_mesh_that_is_a_part_of_the_scan);
    tcase_add_test(tests, strips_grow_up_to_each_other);
    tcase_add_test(tests, rows_are_added_beside_others);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

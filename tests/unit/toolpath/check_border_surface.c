/* border_surface on a saddle whose scan reaches a millimetre beyond its mesh: points and normals
 * against the formula, and where there are none. */
#include "toolpath/border_surface.h"

#include <check.h>
#include <stdlib.h>

#include "shapes.h"

static struct vec3 saddle(double x, double y, struct vec3 *normal)
{
    *normal = vec_unit(vec(-x / 20, y / 30, 1));
    return vec(x, y, x * x / 40 - y * y / 60);
}

/* Half a millimetre apart out to `half`, but for a disc about (9, 0); with a `ripple`. */
static struct vec3s scan_of(double half, double hole, double ripple)
{
    struct vec3s scan = {0};
    struct vec3 normal;
    int n = (int)(half / 0.5);

    for (int j = -n; j <= n; j++) {
        for (int i = -n; i <= n; i++) {
            struct vec3 p = saddle(i * 0.5, j * 0.5, &normal);
            p.z += (7 * i + 3 * j * j + 70) % 5 < 2 ? ripple : 0;
            if (hypot(p.x - 9, p.y) > hole)
                *array_push(&scan) = p;
        }
    }
    return scan;
}

static struct border_surface *border_surface_of(const struct vec3s *scan)
{
    struct mesh mesh = shape_grid(saddle, -9, -9, 9, 9, 18, 18);
    struct vec3s none = {0};
    struct border_surface_options rule = {scan, &none, 1, 5, 0.005};
    struct border_surface *border_surface = border_surface_new(&rule, &mesh);

    mesh_free(&mesh);
    return border_surface;
}

/* On the plane y = `y`, from a place that is off by 0.05 mm. */
static bool put(const struct border_surface *border_surface, double x, double y, struct contact *c)
{
    struct border_surface_plane plane = {vec(0, 1, 0), vec(1, 0, 0), y};

    c->p = saddle(x, y, &c->n);
    c->p.z += 0.05;
    c->n = vec_unit(vec_add(c->n, vec(0.05, 0.02, 0)));
    return border_surface_move(border_surface, &plane, c);
}

START_TEST(it_is_the_surface_up_to_the_last_points)
{
    struct vec3s scan = scan_of(10, 0, 0);
    struct border_surface *border_surface = border_surface_of(&scan);
    struct contact c;
    struct vec3 normal;

    for (double x = 8.03; x < 10; x += 0.1) {
        for (double y = -9.97; y < 10; y += 0.7) {
            ck_assert(put(border_surface, x, y, &c));
            ck_assert_double_le(vec_distance(c.p, saddle(c.p.x, c.p.y, &normal)), 1e-4);
            ck_assert_double_le(vec_distance(c.n, normal), 1e-4);
            ck_assert_double_eq_tol(c.p.y, y, 1e-12);
        }
    }
    for (double y = -9; y < 9; y += 0.7)
        ck_assert(!put(border_surface, 10.1, y, &c));
    for (double y = -9; y < 9; y += 0.7) {
        c.p = saddle(9.99, y, &c.n);
        ck_assert(border_surface_within(border_surface, &c));
        c.p = saddle(10.3, y, &c.n);
        ck_assert(!border_surface_within(border_surface, &c));
    }
    c.p = saddle(0, 0, &c.n);
    ck_assert(
        border_surface_within(border_surface, &c)); /* far from the border it is not looked for */
    ck_assert_double_eq(border_surface_step(border_surface), 0.25);
    ck_assert(border_surface_beside(border_surface, vec(9.9, 0, 2)));
    ck_assert(!border_surface_beside(border_surface, vec(0, 0, 0)));
    ck_assert(!border_surface_beside(border_surface, vec(12, 0, 3)));
    border_surface_free(border_surface);
    array_free(&scan);
}
END_TEST

START_TEST(there_is_none_in_a_hole)
{
    struct vec3s scan = scan_of(12, 1.8, 0);
    struct border_surface *border_surface = border_surface_of(&scan);
    struct contact c;

    ck_assert(!put(border_surface, 9, 0, &c));
    ck_assert(put(border_surface, 9, 2.4, &c));
    border_surface_free(border_surface);
    array_free(&scan);
}
END_TEST

START_TEST(there_is_none_where_it_is_uncertain)
{
    struct vec3s scan = scan_of(10, 0, 0.3);
    struct border_surface *border_surface = border_surface_of(&scan);
    struct contact c;
    int sure = 0;

    for (double y = -9; y < 9; y += 0.3)
        sure += put(border_surface, 9.6, y, &c);
    ck_assert_int_le(sure, 6); /* of 60 */
    border_surface_free(border_surface);
    array_free(&scan);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("border_surface");
    TCase *tests = tcase_create("border_surface");
    tcase_add_test(tests, it_is_the_surface_up_to_the_last_points);
    tcase_add_test(tests, there_is_none_in_a_hole);
    tcase_add_test(tests, there_is_none_where_it_is_uncertain);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

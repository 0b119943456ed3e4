/*
 * patch_measure: areas and volumes by formula, of trimmed planes, cylinders and spheres, within
 * 1e-6; chords of a ten-thousandth alone would leave 1e-4.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "math/elementary.h"
#include "nurbs/construct.h"
#include "nurbs/patch_measure.h"
#include "nurbs/primitive.h"

static const double R = 5;

/* The ellipse about `at` with these half axes as a loop of its own, from -180 to 180 degrees. */
static void add_ellipse(struct patch *p, struct vec3 at, struct vec3 a, struct vec3 b)
{
    struct transform place = construct_place(at, vec_cross(a, b), a);
    struct patch_loop *loop = array_push(&p->loop);
    *loop = (struct patch_loop){.space = true};
    *array_push(loop) = construct_ellipse(&place, vec_length(a), vec_length(b), -PI, PI);
}

static void make_surface(struct patch *p, enum primitive_kind kind)
{
    struct primitive k = {.kind = kind, .radius = R};
    struct vec3s points = {0};
    k.place = construct_place(vec(0, 0, 0), vec(0, 0, 1), vec(1, 0, 0));
    primitive_points(&p->loop, &points);
    ck_assert_int_eq(primitive_surface(&k, &points, &p->surface), 0);
    array_free(&points);
}

/* Relative, both. */
static void check(struct patch *p, struct vec3 origin, double area, double volume)
{
    struct patch_measure m = patch_measure(p, R, origin);
    ck_assert(m.sound);
    ck_assert_double_eq_tol(m.area, area, 1e-6 * area);
    ck_assert_double_eq_tol(m.volume, volume, 1e-6 * fabs(volume));
    patch_free(p);
}

START_TEST(a_ring_in_a_plane)
{
    struct patch p = {0};
    add_ellipse(&p, vec(1, 2, 0), vec(R, 0, 0), vec(0, R, 0));
    add_ellipse(&p, vec(2, 2, 0), vec(0.6, 0.8, 0), vec(-1.6, 1.2, 0));
    make_surface(&p, PRIMITIVE_PLANE);
    double area = PI * (R * R - 2);
    check(&p, vec(3, 4, -7), area, 7 * area / 3);
}
END_TEST

/* Below a plane across: by symmetry the area is that up to the middle.  With its two ends it is a
 * body of R^2 pi times the mean height; what the ends add about a place on both planes is 0. */
START_TEST(a_cylinder_cut_askew)
{
    struct patch p = {0};
    add_ellipse(&p, vec(0, 0, 0), vec(R, 0, 0), vec(0, R, 0));
    add_ellipse(&p, vec(0, 0, 6), vec(R, 0, 3), vec(0, R, 0));
    make_surface(&p, PRIMITIVE_CYLINDER);
    check(&p, vec(-10, 0, 0), 2 * PI * R * 6, PI * R * R * 6);
}
END_TEST

START_TEST(a_whole_sphere)
{
    struct patch p = {0};
    make_surface(&p, PRIMITIVE_SPHERE);
    check(&p, vec(1, 2, 3), 4 * PI * R * R, 4 * PI * R * R * R / 3);
}
END_TEST

/* What is between two planes across a sphere, about its middle. */
START_TEST(a_zone_of_a_sphere)
{
    struct patch p = {0};
    add_ellipse(&p, vec(0, 0, -3), vec(4, 0, 0), vec(0, 4, 0));
    add_ellipse(&p, vec(0, 0, 4), vec(3, 0, 0), vec(0, 3, 0));
    make_surface(&p, PRIMITIVE_SPHERE);
    check(&p, vec(0, 0, 0), 2 * PI * R * 7, 2 * PI * R * 7 * R / 3);
}
END_TEST

/* Swept along z: a cubic that turns within a hundredth of its length, nearly a cusp, so that the
 * area element there is hardly a polynomial.  With w from -1 to 1 its derivative by t = (1 + w) / 2
 * is 3 (NARROW / 2 + w^2 (1 - 3 NARROW / 2)), 3 w; the length by Simpson's rule. */
START_TEST(nearly_a_cusp)
{
    static const double NARROW = 0.02;
    enum { STEPS = 20000 };
    struct nurbs_curve c = patch_curve(3, 4);
    const double x[] = {0, 1 - NARROW, NARROW, 1}, y[] = {0, 1, 1, 0};
    for (int i = 0; i < 4; i++)
        c.pole[i] = (struct nurbs_pole){x[i], y[i], 0, 1};
    struct patch p = {.surface = construct_extrusion(&c, vec(0, 0, 4))};
    double length = 0;
    for (int i = 0; i <= STEPS; i++) {
        double w = 2.0 * i / STEPS - 1, weight = i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2;
        double dx = 3 * (NARROW / 2 + w * w * (1 - 1.5 * NARROW));
        length += weight * hypot(dx, 3 * w) / (3 * STEPS);
    }
    struct patch_measure m = patch_measure(&p, 4, vec(0, 0, 0));
    ck_assert(m.sound);
    ck_assert_double_eq_tol(m.area, 4 * length, 1e-5 * m.area);
    nurbs_curve_free(&c);
    patch_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("patch_measure");
    TCase *tcase = tcase_create("known");
    tcase_add_test(tcase, a_ring_in_a_plane);
    tcase_add_test(tcase, a_cylinder_cut_askew);
    tcase_add_test(tcase, a_whole_sphere);
    tcase_add_test(tcase, a_zone_of_a_sphere);
    tcase_add_test(tcase, nearly_a_cusp);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

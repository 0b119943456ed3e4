/*
 * isolines: equal lines, with every kink among them; bent ones that keep the tolerance of a known
 * curvature, and no more of them than that takes.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "nurbs/isolines.h"
#include "known.h"

static void rises(const struct doubles *line, const struct nurbs_axis *a)
{
    ck_assert_double_eq(line->item[0], a->from);
    ck_assert_double_eq(line->item[line->n - 1], a->to);
    for (size_t i = 1; i < line->n; i++)
        ck_assert_double_gt(line->item[i], line->item[i - 1]);
}

START_TEST(equal)
{
    struct patch p = known_flat(vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 0));
    struct doubles line = {0};
    for (int n = 1; n < 40; n++) {
        isolines_equal(&p.surface.u, n, &line);
        ck_assert_uint_eq(line.n, (size_t)n + 1);
        rises(&line, &p.surface.u);
        for (int i = 0; i <= n; i++)
            ck_assert_double_lt(fabs(line.item[i] - (double)i / n), 1e-14);
    }
    array_free(&line);
    patch_free(&p);
}
END_TEST

/* A sphere of four spans in u: its knots are double, as kinks have them. */
START_TEST(kinks_are_lines)
{
    struct patch p = known_sphere(10);
    struct doubles line = {0};
    for (int n = 1; n < 30; n++) {
        int found = 0;
        isolines_equal(&p.surface.u, n, &line);
        rises(&line, &p.surface.u);
        for (size_t i = 0; i < line.n; i++)
            found += line.item[i] == 1 || line.item[i] == 2 || line.item[i] == 3;
        ck_assert_int_eq(found, 3);
    }
    array_free(&line);
    patch_free(&p);
}
END_TEST

/* A cylinder of radius r: an arc of angle a has the sagitta r (1 - cos(a / 2)). */
START_TEST(bent)
{
    static const double tolerance[] = {1, 0.1, 0.01, 0.001};
    const struct isolines_border inner = {{false, false}, {false, false}};
    struct patch p = known_cylinder(10, 50);
    struct doubles u = {0}, v = {0};
    for (int k = 0; k < 4; k++) {
        struct isolines_bend bend = {0};
        isolines_measure(&p.surface, &inner, &bend);
        isolines_bent(&bend, tolerance[k], 1, &u, &v);
        isolines_bend_free(&bend);
        rises(&u, &p.surface.u);
        ck_assert_uint_eq(v.n, 2); /* straight */
        double most = 0, fewest = PI / acos(1 - tolerance[k] / 10);
        for (size_t i = 1; i < u.n; i++) {
            struct vec3 a = nurbs_point(&p.surface, (struct uv){u.item[i - 1], 0});
            struct vec3 b = nurbs_point(&p.surface, (struct uv){u.item[i], 0});
            most = fmax(most, 10 - vec_length(vec_mix(a, b, 0.5)));
        }
        ck_assert_double_le(most, tolerance[k]);
        ck_assert_double_le((double)u.n, 1.6 * fewest + 5);
    }
    array_free(&u);
    array_free(&v);
    patch_free(&p);
}
END_TEST

/* A twisted patch, z as x y: where its parameters begin, and how far they go, changes no place of a
 * line. */
START_TEST(any_range)
{
    static const struct {
        double u0, u, v0, v;
    } range[] = {{0, 1, 0, 1}, {100, 1, -3, 2}, {-0.5, 1, 7, 0.25}};
    const struct isolines_border inner = {{false, false}, {false, false}};
    struct doubles line[3][2] = {{{0}}};
    for (int i = 0; i < 3; i++) {
        struct patch p = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 20, 0), vec(10, 20, 8));
        struct isolines_bend bend = {0};
        for (int k = 0; k < 4; k++) {
            p.surface.u.knot[k] = range[i].u0 + (k > 1 ? range[i].u : 0);
            p.surface.v.knot[k] = range[i].v0 + (k > 1 ? range[i].v : 0);
        }
        p.surface.u.from = range[i].u0, p.surface.u.to = range[i].u0 + range[i].u;
        p.surface.v.from = range[i].v0, p.surface.v.to = range[i].v0 + range[i].v;
        isolines_measure(&p.surface, &inner, &bend);
        isolines_bent(&bend, 0.01, 1, &line[i][0], &line[i][1]);
        isolines_bend_free(&bend);
        rises(&line[i][0], &p.surface.u);
        rises(&line[i][1], &p.surface.v);
        ck_assert_uint_gt(line[i][0].n, 9); /* a cell rises from its facets by 8 / n^2 / 4 */
        patch_free(&p);
    }
    for (int i = 1; i < 3; i++)
        for (int side = 0; side < 2; side++) {
            double from = side ? range[i].v0 : range[i].u0, by = side ? range[i].v : range[i].u;
            ck_assert_uint_eq(line[i][side].n, line[0][side].n);
            for (size_t k = 0; k < line[0][side].n; k++)
                ck_assert_double_lt(
                    fabs((line[i][side].item[k] - from) / by - line[0][side].item[k]), 1e-9);
        }
    for (int i = 0; i < 6; i++)
        array_free(&line[i / 2][i % 2]);
}
END_TEST

/* A disc is flat, so that lines through it bend for its rim alone: where that bounds the patch, and
 * from the end of the range that does, not from the other. */
START_TEST(a_rim_that_bounds)
{
    static const double profile[2][3] = {{0.5, 0, 1}, {10, 0, 1}}, knot[4] = {0, 0, 1, 1};
    struct patch p = known_turned(1, 2, knot, profile);
    size_t lines[3];
    for (int k = 0; k < 3; k++) {
        const struct isolines_border border = {{false, false}, {k == 1, k == 2}};
        struct isolines_bend bend = {0};
        struct doubles u = {0}, v = {0};
        isolines_measure(&p.surface, &border, &bend);
        isolines_bent(&bend, 0.01, 1, &u, &v);
        lines[k] = u.n;
        isolines_bend_free(&bend);
        array_free(&u);
        array_free(&v);
    }
    /* half the angle of a side is acos(1 - e / r): for a radius of 0.5 and of 10 */
    ck_assert_uint_eq(lines[0], 5); /* the quarters */
    ck_assert_double_ge((double)lines[1], PI / acos(1 - 0.01 / 0.5));
    ck_assert_double_le((double)lines[1], 1.6 * PI / acos(1 - 0.01 / 0.5) + 5);
    ck_assert_double_ge((double)lines[2], PI / acos(1 - 0.01 / 10.0));
    ck_assert_double_le((double)lines[2], 1.6 * PI / acos(1 - 0.01 / 10.0) + 5);
    patch_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("isolines");
    TCase *tests = tcase_create("isolines");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, equal);
    tcase_add_test(tests, kinks_are_lines);
    tcase_add_test(tests, bent);
    tcase_add_test(tests, any_range);
    tcase_add_test(tests, a_rim_that_bounds);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/* primitive: surfaces of STEP and IGES as NURBS lie on what their equations say. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/construct.h"
#include "nurbs/primitive.h"

/* Turned, and moved. */
static struct transform place(void)
{
    const double c = cos(0.7), s = sin(0.7);
    struct transform t = transform_identity();
    const double m[3][4] = {{c, 0, s, 3}, {0, 1, 0, -2}, {-s, 0, c, 5}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            t.m[i][k] = m[i][k];
    return t;
}

static struct vec3 local(struct vec3 p)
{
    const double c = cos(0.7), s = sin(0.7);
    struct vec3 d = vec_sub(p, vec(3, -2, 5));
    return vec(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

/* Signed distance of a point in the primitive's own frame, outward. */
static double off(const struct primitive *p, struct vec3 q)
{
    double r = hypot(q.x, q.y);
    if (p->kind == PRIMITIVE_PLANE)
        return q.z;
    if (p->kind == PRIMITIVE_CYLINDER)
        return r - p->radius;
    if (p->kind == PRIMITIVE_CONE)
        return (r - p->radius - q.z * tan(p->other)) * cos(p->other);
    if (p->kind == PRIMITIVE_SPHERE)
        return vec_length(q) - p->radius;
    return hypot(r - p->radius, q.z) - p->other;
}

static const struct primitive kinds[] = {{.kind = PRIMITIVE_PLANE},
                                         {.kind = PRIMITIVE_CYLINDER, .radius = 4},
                                         {.kind = PRIMITIVE_CONE, .radius = 4, .other = 0.3},
                                         {.kind = PRIMITIVE_SPHERE, .radius = 6},
                                         {.kind = PRIMITIVE_TORUS, .radius = 8, .other = 2.5}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Points of it at parameters; the surface through them reaches past all of them and is on it. */
START_TEST(on_the_surface)
{
    for (int kind = 0; kind < KINDS; kind++) {
        struct primitive p = kinds[kind];
        struct vec3s points = {0};
        struct nurbs s;
        struct vec3 least = vec(HUGE_VAL, HUGE_VAL, HUGE_VAL), most = vec_scale(-1, least);
        p.place = place();
        for (double u = -1; u <= 1; u += 0.25)
            for (double v = -1; v <= 1; v += 0.25) {
                struct vec3 q = primitive_point(&p, u, v);
                ck_assert_double_eq_tol(off(&p, local(q)), 0, 1e-12);
                *array_push(&points) = q;
            }
        ck_assert_int_eq(primitive_surface(&p, &points, &s), 0);
        for (int i = 0; i <= 24; i++)
            for (int k = 0; k <= 24; k++) {
                struct uv at = {s.u.from + (s.u.to - s.u.from) * i / 24,
                                s.v.from + (s.v.to - s.v.from) * k / 24};
                struct vec3 q = nurbs_point(&s, at);
                ck_assert_double_eq_tol(off(&p, local(q)), 0, 1e-11);
                least = vec(fmin(least.x, q.x), fmin(least.y, q.y), fmin(least.z, q.z));
                most = vec(fmax(most.x, q.x), fmax(most.y, q.y), fmax(most.z, q.z));
            }
        for (size_t i = 0; i < points.n; i++) {
            struct vec3 q = points.item[i];
            ck_assert(q.x >= least.x - 0.1 && q.y >= least.y - 0.1 && q.z >= least.z - 0.1);
            ck_assert(q.x <= most.x + 0.1 && q.y <= most.y + 0.1 && q.z <= most.z + 0.1);
        }
        nurbs_free(&s);
        array_free(&points);
    }
}
END_TEST

/* Moved along its normals every point is as far off what it was; a sphere goes, but not beyond its
 * middle. */
START_TEST(offsets)
{
    for (int kind = 0; kind < KINDS; kind++) {
        struct primitive p = kinds[kind];
        p.place = place();
        struct primitive moved = p;
        ck_assert_int_eq(primitive_offset(&moved, 0.75), 0);
        for (double u = -1; u <= 1; u += 0.5)
            for (double v = -1; v <= 1; v += 0.5)
                ck_assert_double_eq_tol(off(&p, local(primitive_point(&moved, u, v))), 0.75, 1e-11);
    }
    struct primitive ball = kinds[3];
    ck_assert_int_eq(primitive_offset(&ball, -7), -1);
}
END_TEST

/* No end and no points, or no size. */
/* Of a torus that cuts itself the curve on it tells the part: one about the outer side, or one
 * about the spindle within. */
START_TEST(part_of_a_torus)
{
    struct primitive p = {.kind = PRIMITIVE_TORUS, .place = place(), .radius = 3, .other = 5};
    const enum primitive_part part[] = {PRIMITIVE_OUTER, PRIMITIVE_INNER};
    for (int i = 0; i < 2; i++) {
        struct transform at = place(), up = transform_identity();
        double v = 0.4, r = 5 * cos(v) + (i == 0 ? 3 : -3);
        up.m[2][3] = 5 * sin(v);
        at = transform_product(at, up);
        struct nurbs_curve circle = construct_ellipse(&at, r, r, 0, 6);
        struct patch_loops loops = {0};
        struct patch_loop *loop = array_push(&loops);
        *loop = (struct patch_loop){.space = true};
        *array_push(loop) = circle;
        ck_assert_int_eq(primitive_part_of(&p, &loops), part[i]);
        p.radius = 6;
        ck_assert_int_eq(primitive_part_of(&p, &loops), PRIMITIVE_WHOLE);
        p.radius = 3;
        nurbs_curve_free(&circle);
        array_free(loop);
        array_free(&loops);
    }
    struct patch_loops none = {0};
    ck_assert_int_eq(primitive_part_of(&p, &none), PRIMITIVE_WHOLE);
}
END_TEST

START_TEST(no_surface)
{
    struct primitive plane = {.kind = PRIMITIVE_PLANE, .place = place()};
    struct primitive point = {.kind = PRIMITIVE_SPHERE, .place = place(), .radius = 0};
    struct vec3s none = {0};
    struct nurbs s;
    ck_assert_int_eq(primitive_surface(&plane, &none, &s), -1);
    ck_assert_int_eq(primitive_surface(&point, &none, &s), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("primitive");
    TCase *tests = tcase_create("primitive");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, on_the_surface);
    tcase_add_test(tests, offsets);
    tcase_add_test(tests, part_of_a_torus);
    tcase_add_test(tests, no_surface);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

/*
 * trim_loops: curves in space on surfaces where the area inside is known: a plane, a cylinder that
 * closes on itself (with and without its seam as part of the loop, across it, round it), a sphere
 * with its poles.  Parts of the surface are told by many places of its range, so the areas are good
 * to a percent, and the polygons' corners to the tolerance.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/primitive.h"
#include "nurbs/pullback.h"
#include "nurbs/trim_loops.h"
#include "seed.h"

static const double TOLERANCE = 1e-4;

/* Part of a circle of radius r about `at`, by e1 and e2, in pieces of a quarter or less. */
static void add_arc(struct patch_loop *loop, struct vec3 at, struct vec3 e1, struct vec3 e2,
                    double r, double from, double to)
{
    int pieces = (int)ceil(fabs(to - from) / (PI / 2) - 1e-9);
    for (int k = 0; k < pieces; k++) {
        double half = (to - from) / pieces / 2, middle = from + half * (2 * k + 1);
        struct nurbs_curve c = patch_curve(2, 3);
        for (int i = 0; i < 3; i++) {
            double a = middle + half * (i - 1), w = i == 1 ? cos(half) : 1, out = r / w;
            struct vec3 q = vec_along(vec_along(at, out * cos(a), e1), out * sin(a), e2);
            c.pole[i] = (struct nurbs_pole){w * q.x, w * q.y, w * q.z, w};
        }
        *array_push(loop) = c;
    }
}

static void add_line(struct patch_loop *loop, struct vec3 a, struct vec3 b)
{
    struct nurbs_curve c = patch_curve(1, 2);
    c.pole[0] = (struct nurbs_pole){a.x, a.y, a.z, 1};
    c.pole[1] = (struct nurbs_pole){b.x, b.y, b.z, 1};
    *array_push(loop) = c;
}

static const struct vec3 X = {1, 0, 0}, Y = {0, 1, 0}, Z = {0, 0, 1};

static struct patch_loop *new_loop(struct patch *p)
{
    struct patch_loop *loop = array_push(&p->loop);
    *loop = (struct patch_loop){.space = true};
    return loop;
}

/* The area inside the loops, by places in the middle of equal parts of the range, and every side of
 * the polygons within the range. */
static double area_inside(const struct patch *p, double most_off)
{
    enum { N = 400 };
    const struct nurbs *s = &p->surface;
    struct uv_polygon loops;
    double sum = 0;
    trim_loops(p, TOLERANCE, &loops);
    ck_assert_double_le(loops.off, most_off);
    ck_assert(loops.gap == 0);
    for (size_t i = 0; i < loops.n; i++)
        for (size_t k = 0; k < loops.item[i].n; k++) {
            struct uv at = loops.item[i].item[k];
            ck_assert_double_gt(at.u, s->u.from - 1e-6);
            ck_assert_double_lt(at.u, s->u.to + 1e-6);
            ck_assert_double_gt(at.v, s->v.from - 1e-6);
            ck_assert_double_lt(at.v, s->v.to + 1e-6);
        }
    for (int i = 0; i < N * N; i++) {
        struct uv at = {s->u.from + (s->u.to - s->u.from) * (i % N + 0.5) / N,
                        s->v.from + (s->v.to - s->v.from) * (i / N + 0.5) / N};
        struct vec3 d[3][3];
        nurbs_derivatives(s, at, 1, d);
        if (uv_polygon_inside(&loops, p->open || loops.open || loops.n == 0, at))
            sum += vec_length(vec_cross(d[1][0], d[0][1]));
    }
    uv_polygon_free(&loops);
    return sum * (s->u.to - s->u.from) * (s->v.to - s->v.from) / (N * N);
}

static void expect(struct patch p, double area)
{
    double got = area_inside(&p, 1e-9);
    ck_assert_msg(fabs(got - area) < 0.02 * area, "area %g, expected %g", got, area);
    patch_free(&p);
}

START_TEST(on_a_plane)
{
    struct patch p = known_flat(vec(0, 0, 0), vec(40, 0, 40), vec(0, 30, 0), vec(40, 30, 40));
    struct patch_loop *loop = new_loop(&p);
    struct vec3 e1 = vec_unit(vec(1, 0, 1));
    add_arc(loop, vec(20, 15, 20), e1, Y, 12, 0, PI); /* its second half runs backwards */
    add_arc(loop, vec(20, 15, 20), e1, Y, 12, 0, -PI / 2);
    add_arc(loop, vec(20, 15, 20), e1, Y, 12, -PI / 2, -PI);
    struct nurbs_curve swap = loop->item[2];
    loop->item[2] = loop->item[3];
    loop->item[3] = swap;
    add_arc(new_loop(&p), vec(20, 15, 20), e1, Y, 5, 1, 1 + 2 * PI);
    /* each corner on the circle, each middle of a side within the tolerance */
    struct uv_polygon loops;
    trim_loops(&p, TOLERANCE, &loops);
    ck_assert_uint_eq(loops.n, 2);
    for (size_t i = 0; i < 2; i++)
        for (size_t k = 0; k < loops.item[i].n; k++) {
            struct uv a = loops.item[i].item[k], b = loops.item[i].item[(k + 1) % loops.item[i].n];
            struct uv m = {(a.u + b.u) / 2, (a.v + b.v) / 2};
            double r = i == 0 ? 12 : 5, ra, rm;
            ra = vec_distance(nurbs_point(&p.surface, a), vec(20, 15, 20));
            rm = vec_distance(nurbs_point(&p.surface, m), vec(20, 15, 20));
            ck_assert_double_lt(fabs(ra - r), 1e-9);
            ck_assert_double_lt(fabs(rm - r), TOLERANCE);
        }
    uv_polygon_free(&loops);
    expect(p, PI * (144 - 25));
}
END_TEST

/* The gap that is found in the only loop of a plane of 40 by 30, whose corners are in space or in
 * the parameters; a side is left out, and the last one ends so much short. */
static struct uv_polygon gap_in(bool space, int sides, double less)
{
    static const double corner[5][2] = {{5, 5}, {35, 5}, {35, 25}, {5, 25}, {5, 5}};
    struct patch p = known_flat(vec(0, 0, 0), vec(40, 0, 0), vec(0, 30, 0), vec(40, 30, 0));
    const struct nurbs_axis *u = &p.surface.u, *v = &p.surface.v;
    struct patch_loop *loop = new_loop(&p);
    struct uv_polygon loops;
    loop->space = space;
    for (int k = 0; k < sides; k++) {
        struct vec3 a = vec(corner[k][0], corner[k][1], 0);
        struct vec3 b = vec(corner[k + 1][0], corner[k + 1][1] + (k + 1 == sides ? less : 0), 0);
        if (!space) {
            a = vec(u->from + a.x / 40 * (u->to - u->from), v->from + a.y / 30 * (v->to - v->from),
                    0);
            b = vec(u->from + b.x / 40 * (u->to - u->from), v->from + b.y / 30 * (v->to - v->from),
                    0);
        }
        add_line(loop, a, b);
    }
    trim_loops(&p, TOLERANCE, &loops);
    patch_free(&p);
    return loops;
}

START_TEST(curves_that_do_not_meet)
{
    for (int space = 0; space < 2; space++) {
        struct uv_polygon l = gap_in(space == 1, 4, 0);
        ck_assert(l.gap == 0);
        uv_polygon_free(&l);
        l = gap_in(space == 1, 4, 3);
        ck_assert_double_eq_tol(l.gap, 3, 1e-9);
        ck_assert_double_lt(vec_distance(l.gap_at, vec(5, 6.5, 0)), 1e-9);
        uv_polygon_free(&l);
        l = gap_in(space == 1, 3, 0);
        ck_assert_double_eq_tol(l.gap, 20, 1e-9);
        ck_assert_double_lt(vec_distance(l.gap_at, vec(5, 15, 0)), 1e-9);
        uv_polygon_free(&l);
        l = gap_in(space == 1, 4, 0.009); /* of a length of 100 */
        ck_assert(l.gap == 0);
        uv_polygon_free(&l);
        l = gap_in(space == 1, 4, 0.011);
        ck_assert_double_eq_tol(l.gap, 0.011, 1e-9);
        uv_polygon_free(&l);
    }
}
END_TEST

/* Around parameters u0..u1, v0..v1 of a torus of 8 and 2: counter-clockwise, or the other way. */
static struct patch on_torus(double u0, double u1, double v0, double v1, bool clockwise)
{
    struct primitive torus = {.kind = PRIMITIVE_TORUS, .radius = 8, .other = 2};
    struct patch p = {0};
    struct vec3s none = {0};
    torus.place = transform_identity();
    ck_assert_int_eq(primitive_surface(&torus, &none, &p.surface), 0);
    struct patch_loop *loop = new_loop(&p);
    loop->directed = true;
    const double corner[5][2] = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}, {u0, v0}};
    for (int k = 0; k < 4; k++) {
        const double *a = corner[clockwise ? 4 - k : k], *b = corner[clockwise ? 3 - k : k + 1];
        struct vec3 out = vec(cos(a[0]), sin(a[0]), 0);
        if (k % 2 == (clockwise ? 1 : 0))
            add_arc(loop, vec(0, 0, 2 * sin(a[1])), X, Y, 8 + 2 * cos(a[1]), a[0], b[0]);
        else
            add_arc(loop, vec_scale(8, out), out, Z, 2, a[1], b[1]);
    }
    return p;
}

static double torus_area(double u0, double u1, double v0, double v1)
{
    return (u1 - u0) * 2 * (8 * (v1 - v0) + 2 * (sin(v1) - sin(v0)));
}

/* A loop with the seam in it, such as a fillet of a rim has, is what lies between, even where the
 * file has it the wrong way round; one without leaves out what it goes round clockwise. */
START_TEST(round_a_torus)
{
    double part = torus_area(0, 2 * PI, 0, PI / 2), whole = torus_area(0, 2 * PI, 0, 2 * PI);
    for (int way = 0; way < 2; way++)
        expect(on_torus(0, 2 * PI, 0, PI / 2, way == 1), part);
    expect(on_torus(1, 2, 0.3, 1.3, false), torus_area(1, 2, 0.3, 1.3));
    expect(on_torus(1, 2, 0.3, 1.3, true), whole - torus_area(1, 2, 0.3, 1.3));
}
END_TEST

START_TEST(round_a_cylinder)
{
    struct patch p = known_cylinder(10, 20);
    add_arc(new_loop(&p), vec(0, 0, 4), X, Y, 10, 0.3, 0.3 + 2 * PI);
    add_arc(new_loop(&p), vec(0, 0, 9), X, Y, 10, 4, 4 - 2 * PI);
    expect(p, 2 * PI * 10 * 5);
    p = known_cylinder(10, 20); /* the outer loop with the seam in it, both ways */
    struct patch_loop *loop = new_loop(&p);
    add_arc(loop, vec(0, 0, 4), X, Y, 10, 0, 2 * PI);
    add_line(loop, vec(10, 0, 4), vec(10, 0, 9));
    add_arc(loop, vec(0, 0, 9), X, Y, 10, 2 * PI, 0);
    add_line(loop, vec(10, 0, 9), vec(10, 0, 4));
    expect(p, 2 * PI * 10 * 5);
}
END_TEST

/* A window that the seam runs through, and the same as a hole. */
START_TEST(across_the_seam)
{
    for (int hole = 0; hole < 2; hole++)
        for (int start = 0; start < 4; start += 3) {
            struct patch p = known_cylinder(10, 20);
            struct patch_loop *loop = new_loop(&p);
            double a = 0.5;
            struct vec3 low[2] = {{10 * cos(-a), 10 * sin(-a), 5}, {10 * cos(a), 10 * sin(a), 5}};
            struct vec3 high[2] = {low[0], low[1]};
            high[0].z = high[1].z = 15;
            for (int k = start; k < start + 4; k++) {
                if (k % 4 == 0)
                    add_arc(loop, vec(0, 0, 5), X, Y, 10, -a, a);
                if (k % 4 == 1)
                    add_line(loop, low[1], high[1]);
                if (k % 4 == 2)
                    add_arc(loop, vec(0, 0, 15), X, Y, 10, a, -a);
                if (k % 4 == 3)
                    add_line(loop, high[0], low[0]);
            }
            p.open = hole == 1;
            expect(p, hole ? 2 * PI * 200 - 100 : 100);
        }
}
END_TEST

/* One circle alone bounds what is on its left. */
START_TEST(caps_of_a_sphere)
{
    double z = 6, r = 8;
    struct patch p = known_sphere(10);
    add_arc(new_loop(&p), vec(0, 0, z), X, Y, r, 1, 1 + 2 * PI);
    expect(p, 2 * PI * 10 * (10 - z));
    p = known_sphere(10);
    add_arc(new_loop(&p), vec(0, 0, z), X, Y, r, 1, 1 - 2 * PI);
    expect(p, 2 * PI * 10 * (10 + z));
    p = known_sphere(10); /* one that has no pole inside, over the seam */
    add_arc(new_loop(&p), vec(6, 0, 0), Y, Z, 8, 0, 2 * PI);
    expect(p, 2 * PI * 10 * (10 - 6));
}
END_TEST

/* A circle with a slit to a pole, there and back, is round that pole, whichever way it goes: the
 * slit is drawn through what counts. */
START_TEST(slit_to_a_pole)
{
    double z = 6, r = 8, down = acos(z / 10);
    for (int k = 0; k < 4; k++) {
        struct patch p = known_sphere(10);
        struct patch_loop *loop = new_loop(&p);
        double from = k % 2 ? PI : 0, a = 2, way = k / 2 ? 1 : -1;
        struct vec3 out = vec(cos(a), sin(a), 0);
        add_arc(loop, vec(0, 0, 0), Z, out, 10, from, down);
        add_arc(loop, vec(0, 0, z), X, Y, r, a, a + way * 2 * PI);
        add_arc(loop, vec(0, 0, 0), Z, out, 10, down, from);
        expect(p, 2 * PI * 10 * (k % 2 ? 10 + z : 10 - z));
    }
    for (int k = 0; k < 4; k++) { /* to one that the circle does not go round */
        struct patch p = known_sphere(10);
        struct patch_loop *loop = new_loop(&p);
        double side = k % 2 ? 1 : -1, way = k / 2 ? 1 : -1;
        struct vec3 pole = vec(0, 0, side);
        add_arc(loop, vec(0, 0, 0), pole, X, 10, 0, acos(0.8));
        add_arc(loop, vec(6, 0, 0), pole, Y, 8, 0, way * 2 * PI);
        add_arc(loop, vec(0, 0, 0), pole, X, 10, acos(0.8), 0);
        expect(p, 2 * PI * 10 * (10 + 6));
    }
}
END_TEST

/* A curve beside the surface is put onto it, and how far off it was is returned. */
START_TEST(beside_the_surface)
{
    struct patch p = known_cylinder(10, 20);
    add_arc(new_loop(&p), vec(0, 0, 4), X, Y, 10.01, 0, 2 * PI);
    add_arc(new_loop(&p), vec(0, 0, 9), X, Y, 9.98, 0, 2 * PI);
    struct uv_polygon loops;
    trim_loops(&p, TOLERANCE, &loops);
    ck_assert_double_lt(fabs(loops.off - 0.02), 1e-9);
    uv_polygon_free(&loops);
    double area = area_inside(&p, 0.03);
    ck_assert_double_lt(fabs(area - 2 * PI * 10 * 5), 0.01 * area);
    patch_free(&p);
}
END_TEST

/* Foot points on a sphere and a torus from anywhere, and over the seam of a cylinder. */
static uint64_t state = 7;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

START_TEST(seek)
{
    struct patch p = known_torus(20, 5);
    struct pullback on = pullback_new(&p.surface);
    ck_assert(on.closed_u && on.closed_v);
    for (int i = 0; i < 100; i++) {
        double a = uniform(0, 2 * PI), b = uniform(0, 2 * PI), r = 5 + uniform(-2, 3);
        double d = 20 + r * cos(b);
        struct vec3 q = {d * cos(a), d * sin(a), r * sin(b)};
        struct vec3 foot = pullback_point(&on, pullback_seek(&on, q));
        ck_assert_double_lt(fabs(vec_distance(foot, q) - fabs(r - 5)), 1e-9);
    }
    pullback_free(&on);
    patch_free(&p);
}
END_TEST

/* Three times round: the parameter goes on rising, a turn of 4 each time. */
START_TEST(over_the_seam)
{
    struct patch p = known_cylinder(10, 20);
    struct pullback on = pullback_new(&p.surface);
    struct uv at = {0.01, 0.5}, first;
    ck_assert(on.closed_u && !on.closed_v);
    for (int way = 1; way >= -1; way -= 2) {
        at = first = pullback_foot(&on, vec(10, 0.2, 10), (struct uv){0.01, 0.5});
        for (int i = 1; i <= 300; i++) {
            double a = way * 6 * PI * i / 300 + atan2(0.2, 10);
            struct vec3 q = vec(10.3 * cos(a), 10.3 * sin(a), 10);
            struct uv next = pullback_foot(&on, q, at);
            ck_assert_double_gt(way * (next.u - at.u), 0);
            ck_assert_double_lt(way * (next.u - at.u), 0.1);
            ck_assert_double_lt(fabs(vec_distance(pullback_point(&on, next), q) - 0.3), 1e-9);
            at = next;
        }
        ck_assert_double_lt(fabs(at.u - first.u - way * 12), 1e-9);
    }
    pullback_free(&on);
    patch_free(&p);
}
END_TEST

/* What is inside random stars by another rule: the sum of the angles at a place. */
static struct uvs star(struct uv at, double least, double most, int n, bool backwards)
{
    struct uvs loop = {0};
    for (int i = 0; i < n; i++) {
        double a = 2 * PI * (backwards ? n - i : i) / n, r = uniform(least, most);
        *array_push(&loop) = (struct uv){at.u + r * cos(a), at.v + r * sin(a)};
    }
    return loop;
}

/* How often the loop goes round: the angles under which its sides are seen. */
static int turns(const struct uvs *loop, struct uv p)
{
    double sum = 0;
    for (size_t i = 0; i < loop->n; i++) {
        struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        a.u -= p.u, a.v -= p.v, b.u -= p.u, b.v -= p.v;
        sum += atan2(a.u * b.v - a.v * b.u, a.u * b.u + a.v * b.v);
    }
    return (int)floor(sum / (2 * PI) + 0.5);
}

START_TEST(inside_by_angles)
{
    for (int turn = 0; turn < 60; turn++) {
        struct uv_polygon loops = {0};
        for (int k = 0; k < 3; k++)
            *array_push(&loops) = star((struct uv){uniform(-1, 1), uniform(-1, 1)}, 0.3, 2,
                                       3 + (int)uniform(0, 20), uniform(0, 1) < 0.5);
        struct uv_rows rows;
        uv_rows_make(&loops, &rows);
        for (int i = 0; i < 200; i++) {
            struct uv p = {uniform(-3, 3), uniform(-3, 3)};
            int n = 0;
            for (size_t k = 0; k < 3; k++)
                n += abs(turns(&loops.item[k], p));
            ck_assert(uv_polygon_inside(&loops, false, p) == (n % 2 == 1));
            ck_assert(uv_polygon_inside(&loops, true, p) == (n % 2 == 0));
            ck_assert(uv_rows_inside(&rows, false, p) == (n % 2 == 1));
            ck_assert(uv_rows_inside(&rows, true, p) == (n % 2 == 0));
        }
        /* at the heights of corners, where a side more or less counts twice */
        for (size_t i = 0; i < loops.item[0].n; i++) {
            struct uv p = {uniform(-3, 3), loops.item[0].item[i].v};
            ck_assert(uv_rows_inside(&rows, false, p) == uv_polygon_inside(&loops, false, p));
        }
        uv_rows_free(&rows);
        uv_polygon_free(&loops);
    }
}
END_TEST

/* Sides that all reach from below to above: no more room than some for each of them. */
START_TEST(rows_of_long_sides)
{
    struct uv_polygon loops = {0};
    struct uvs *comb = array_push(&loops);
    *comb = (struct uvs){0};
    for (int i = 0; i < 20000; i++)
        *array_push(comb) = (struct uv){i, i % 2};
    struct uv_rows rows;
    uv_rows_make(&loops, &rows);
    ck_assert_uint_le(rows.first[rows.n], 20 * comb->n);
    for (int i = 0; i < 50; i++) {
        struct uv p = {uniform(0, 20000), uniform(-0.1, 1.1)};
        ck_assert(uv_rows_inside(&rows, false, p) == uv_polygon_inside(&loops, false, p));
    }
    uv_rows_free(&rows);
    uv_polygon_free(&loops);
}
END_TEST

/* An outer loop and a hole in it: each backwards as it is made. */
START_TEST(hands)
{
    for (int k = 0; k < 4; k++) {
        struct uv_polygon loops = {0};
        *array_push(&loops) = star((struct uv){0, 0}, 2, 3, 17, k & 1);
        *array_push(&loops) = star((struct uv){0, 0}, 0.5, 1, 9, k & 2);
        ck_assert(uv_polygon_backwards(&loops, 0, false) == (k & 1));
        ck_assert(uv_polygon_backwards(&loops, 1, false) != ((k & 2) != 0));
        ck_assert(uv_polygon_backwards(&loops, 0, true) != (k & 1));
        uv_polygon_free(&loops);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_loops");
    TCase *tests = tcase_create("trim_loops");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, on_a_plane);
    tcase_add_test(tests, curves_that_do_not_meet);
    tcase_add_test(tests, round_a_cylinder);
    tcase_add_test(tests, across_the_seam);
    tcase_add_test(tests, caps_of_a_sphere);
    tcase_add_test(tests, slit_to_a_pole);
    tcase_add_test(tests, beside_the_surface);
    tcase_add_test(tests, seek);
    tcase_add_test(tests, over_the_seam);
    tcase_add_test(tests, round_a_torus);
    tcase_add_test(tests, inside_by_angles);
    tcase_add_test(tests, rows_of_long_sides);
    tcase_add_test(tests, hands);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

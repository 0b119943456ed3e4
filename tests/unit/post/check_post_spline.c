/*
 * post_spline: G06.2 of curves of every degree, run by de Boor's scheme on the printed poles, knots
 * and angles: within the tolerance of the motion, no span below 1; POLY ends where the motion does.
 * The printed polynomials, by the formula of the manual, are the curve, to the fifth degree; a
 * wrong factor is seen; the width is that of the words as the manual writes them.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "chains.h"
#include "post/post_spline.h"

static const struct kinematic_chain table_ac = {
    .n = 2,
    .master = 1,
    .tool = {0, 0, 1},
    .rotary = {{{0, 0, 1}, {0, 0, 0}, true, -99, 99}, {{1, 0, 0}, {0, 0, 0}, true, -2, 2}}};

/* The tool leans 20 degrees forward and swings a little. */
static struct bspline any_curve(int degree, size_t poles, double unit)
{
    struct bspline b = bspline_new(degree, poles, true);
    size_t p = (size_t)degree;
    for (size_t i = 0; i < poles + p + 1; i++)
        b.knot[i] = i <= p ? 0 : b.knot[i - 1] + (i > poles ? 0 : (0.5 + 8 * chance()) * unit);
    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec_scale(unit, vec(6 * (double)i, 3 * chance(), 2 * chance()));
        struct vec3 axis = vec_unit(vec(0.36, 0.1 * chance(), 0.94));
        b.head[i] = vec_along(b.pole[i], 100 * unit, axis);
    }
    b.length = 100 * unit;
    return b;
}

/* By de Boor's scheme on any rows of numbers. */
static double at(const double *knot, size_t degree, size_t n, const double *pole, double u)
{
    double d[16];
    size_t span = degree;
    while (span + 1 < n && knot[span + 1] <= u)
        span++;
    for (size_t i = 0; i <= degree; i++)
        d[i] = pole[span - degree + i];
    for (size_t level = 1; level <= degree; level++)
        for (size_t i = degree; i >= level; i--) {
            double from = knot[span - degree + i], to = knot[span + i - level + 1];
            d[i] = d[i - 1] + (u - from) / (to - from) * (d[i] - d[i - 1]);
        }
    return d[degree];
}

static struct block_pose begin(const struct bspline *b, struct nc_spline_digits digits)
{
    struct block_pose from = {.a = vec_unit(vec_sub(b->head[0], b->pole[0]))};
    struct vec3 p = b->pole[0];
    from.p = vec(num_round(p.x, digits.linear), num_round(p.y, digits.linear),
                 num_round(p.z, digits.linear));
    struct chain_solutions ways = chain_angles(&table_ac, from.a);
    for (int i = 0; i < 2; i++)
        from.q[i] = RADIANS(num_round(DEGREES(ways.q[0][i]), digits.angle));
    return from;
}

/* How far the printed NURBS is off the motion: tip, and axis by rotation matrices.  Knots are of
 * so many digits, which moves the tool along the curve, by its speed and half a digit at either end
 * of a span, and not off it. */
static void expect_near(const struct nc_spline *s, const struct motion *motion, double point,
                        double axis, int knot_digits)
{
    size_t n = s->curve.poles, degree = (size_t)s->curve.degree;
    const double *k = s->curve.knot;
    double *x[3];
    for (int c = 0; c < 3; c++)
        x[c] = malloc(n * sizeof **x);
    for (size_t i = 0; i < n; i++) {
        x[0][i] = s->curve.pole[i].x;
        x[1][i] = s->curve.pole[i].y;
        x[2][i] = s->curve.pole[i].z;
    }
    double worst = 0, swung = 0, range = k[n] - k[degree];
    double shift = pow(10, -knot_digits) / range;
    for (int i = 0; i <= 2000; i++) {
        double share = i / 2000.0, u = k[degree] + share * range;
        double before = fmax(0, share - shift), after = fmin(1, share + shift);
        struct pose wanted = motion_at(motion, share);
        struct vec3 p =
            vec(at(k, degree, n, x[0], u), at(k, degree, n, x[1], u), at(k, degree, n, x[2], u));
        double c = RADIANS(at(k, degree, n, s->angle[0], u));
        double a = RADIANS(at(k, degree, n, s->angle[1], u));
        struct vec3 tool = vec(sin(c) * sin(a), -cos(c) * sin(a), cos(a));
        double along = vec_distance(motion_at(motion, before).p, motion_at(motion, after).p) / 2;
        worst = fmax(worst, vec_distance(p, wanted.p) - along);
        swung = fmax(swung, vec_angle(tool, wanted.a));
    }
    ck_assert_double_lt(worst, point);
    ck_assert_double_lt(swung, axis);
    for (int c = 0; c < 3; c++)
        free(x[c]);
}

START_TEST(nurbs)
{
    const struct nc_spline_digits mm = {3, 3, 3}, inch = {4, 3, 4};
    struct interpolation f = {.mode = INTERPOLATE_ROTARY, .chain = &table_ac, .ball = 0};
    int done = 0;
    for (int i = 0; i < 60; i++) {
        seed = (uint64_t)i + 1;
        int degree = 2 + i % 6;
        double unit = i % 2 ? 1 / 25.4 : 1;
        struct nc_spline_digits digits = i % 2 ? inch : mm;
        struct bspline b = any_curve(degree, (size_t)degree + 1 + (size_t)i % 7, unit);
        struct pose_deviation allowed = {0.005 * unit, RADIANS(0.05)}, d;
        struct block_pose from = begin(&b, digits), to;
        struct motion motion = motion_spline((struct pose){b.pole[0], from.a},
                                             (struct pose){b.pole[b.poles - 1], from.a}, &b);
        motion.to.a = motion_at(&motion, 1).a;
        struct nc_spline s;
        if (nc_spline_words(&s, NC_SPLINES_ROTARY, digits, &f, &from, &motion, allowed, &to, &d)) {
            ck_assert_int_eq(s.form, NC_NURBS);
            ck_assert_int_eq(s.curve.degree, degree > 3 ? 3 : degree);
            expect_near(&s, &motion, 1.02 * 0.005 * unit + 1e-6, RADIANS(0.051), digits.knot);
            for (size_t k = 0; k + 1 < s.curve.poles + (size_t)s.curve.degree + 1; k++) {
                double span = s.curve.knot[k + 1] - s.curve.knot[k];
                ck_assert(span == 0 || span > 1 - 1e-9);
            }
            ck_assert_double_lt(vec_distance(s.curve.pole[0], from.p), 1e-12);
            ck_assert_double_lt(vec_distance(to.p, s.curve.pole[s.curve.poles - 1]), 1e-12);
            nc_spline_free(&s);
            done++;
        }
        bspline_free(&b);
    }
    ck_assert_int_ge(done, 50);
}
END_TEST

/* Across the singular direction the axis nearest the work turns far while the tool hardly does, and
 * a curve that keeps the tolerance may go beyond its travel between ends that are within: then
 * there are no words. */
START_TEST(within_travel_between_ends)
{
    const struct nc_spline_digits mm = {3, 3, 3};
    const struct pose_deviation allowed = {0.005, RADIANS(0.05)};
    int done = 0;
    for (int i = 0; i < 600; i++) {
        seed = (uint64_t)i + 500;
        struct kinematic_chain chain = table_ac;
        struct interpolation f = {.mode = INTERPOLATE_ROTARY, .chain = &chain, .ball = 0};
        struct bspline b = any_curve(3, 4 + (size_t)i % 4, 0.01);
        for (size_t k = 0; k < b.poles; k++)
            b.head[k] = vec_along(b.pole[k], 1,
                                  vec_unit(vec(0.003 * chance() - 0.0015, 0.001 * chance(), 1)));
        b.length = 1;
        struct block_pose from = begin(&b, mm), to;
        struct motion motion = motion_spline((struct pose){b.pole[0], from.a},
                                             (struct pose){b.pole[b.poles - 1], from.a}, &b);
        struct pose_deviation d;
        struct nc_spline s;
        motion.to.a = motion_at(&motion, 1).a;
        chain.rotary[0].min = RADIANS(-185);
        chain.rotary[0].max = RADIANS(185);
        if (nc_spline_words(&s, NC_SPLINES_ROTARY, mm, &f, &from, &motion, allowed, &to, &d)) {
            size_t n = s.curve.poles;
            const double *k = s.curve.knot;
            for (int j = 0; j <= 500; j++)
                ck_assert_double_le(fabs(at(k, 3, n, s.angle[0], k[3] + j / 500.0 * (k[n] - k[3]))),
                                    185.01);
            nc_spline_free(&s);
            done++;
        }
        bspline_free(&b);
    }
    ck_assert_int_gt(done, 50);
}
END_TEST

/* Past the pole at a little distance, within 0.02 mm: the axis nearest the work would turn to and
 * fro by tens of degrees, which hardly moves the tool: it goes straight from end to end. */
START_TEST(beside_the_pole_axes_are_calm)
{
    const struct nc_spline_digits mm = {3, 3, 3};
    const struct pose_deviation allowed = {0.005, RADIANS(0.05)};
    struct interpolation f = {.mode = INTERPOLATE_ROTARY, .chain = &table_ac, .ball = 0};
    int turned = 0;
    for (int i = 0; i < 40; i++) {
        seed = (uint64_t)i + 77;
        struct bspline b = any_curve(3, 4, 0.001);
        for (size_t k = 0; k < b.poles; k++)
            b.head[k] =
                vec_along(b.pole[k], 1,
                          vec_unit(vec(1.5e-5 + 1e-5 * chance(), 1.4e-4 * (double)k - 2.1e-4, 1)));
        b.length = 1;
        struct block_pose from = begin(&b, mm), to;
        struct motion motion = motion_spline((struct pose){b.pole[0], from.a},
                                             (struct pose){b.pole[b.poles - 1], from.a}, &b);
        struct pose_deviation d;
        struct nc_spline s;
        motion.to.a = motion_at(&motion, 1).a;
        ck_assert(nc_spline_words(&s, NC_SPLINES_ROTARY, mm, &f, &from, &motion, allowed, &to, &d));
        expect_near(&s, &motion, 0.00501, RADIANS(0.051), mm.knot);
        size_t last = s.curve.poles - 1;
        double way = 0, whole = fabs(s.angle[0][last] - s.angle[0][0]);
        for (size_t k = 1; k <= last; k++)
            way += fabs(s.angle[0][k] - s.angle[0][k - 1]);
        ck_assert_double_lt(way, whole + 0.5);
        turned += whole > 1;
        nc_spline_free(&s);
        bspline_free(&b);
    }
    ck_assert_int_gt(turned, 30);
}
END_TEST

START_TEST(polynomials)
{
    const struct nc_spline_digits digits = {5, 5, 5};
    struct interpolation f = {.mode = INTERPOLATE_VECTOR, .chain = &table_ac};
    for (int i = 0; i < 60; i++) {
        seed = (uint64_t)i + 1;
        int degree = 2 + i % 7;
        struct bspline b = any_curve(degree, (size_t)degree + 1 + (size_t)i % 7, 1);
        struct pose_deviation allowed = {0.005, RADIANS(0.05)}, d;
        struct block_pose from = begin(&b, digits), to;
        struct motion motion = motion_spline((struct pose){b.pole[0], from.a},
                                             (struct pose){b.pole[b.poles - 1], from.a}, &b);
        motion.to.a = motion_at(&motion, 1).a;
        struct nc_spline s;
        ck_assert(
            nc_spline_words(&s, NC_SPLINES_HEAD, digits, &f, &from, &motion, allowed, &to, &d));
        ck_assert(d.point <= 0.005 && (degree > 5 || s.form != NC_POLY || d.point < 3e-5));
        ck_assert(s.form != NC_POLY || s.degree == (degree > 5 ? 3 : degree));
        ck_assert_double_lt(vec_distance(to.p, b.pole[b.poles - 1]), 1e-5);
        nc_spline_free(&s);
        bspline_free(&b);
    }
}
END_TEST

/* A line has no need of one, and a control that knows none is given none. */
START_TEST(none)
{
    const struct nc_spline_digits digits = {3, 3, 3};
    struct interpolation f = {.mode = INTERPOLATE_ROTARY, .chain = &table_ac};
    for (int degree = 1; degree <= 3; degree += 2) {
        struct bspline b = any_curve(degree, 8, 1);
        struct pose_deviation allowed = {0.005, RADIANS(0.05)}, d;
        struct block_pose from = begin(&b, digits), to;
        struct motion motion =
            motion_spline((struct pose){b.pole[0], from.a}, (struct pose){b.pole[7], from.a}, &b);
        struct nc_spline s;
        enum nc_splines kind = degree == 1 ? NC_SPLINES_ROTARY : NC_SPLINES_NONE;
        ck_assert(!nc_spline_words(&s, kind, digits, &f, &from, &motion, allowed, &to, &d));
        bspline_free(&b);
    }
}
END_TEST

/* Head points 100 above the tip, leaning up to 30 degrees. */
static struct bspline turning_curve(int degree, size_t poles)
{
    struct bspline b = bspline_new(degree, poles, true);
    size_t p = (size_t)degree;
    for (size_t i = 0; i < poles + p + 1; i++)
        b.knot[i] = i <= p ? 2 : b.knot[i - 1] + (i > poles ? 0 : 0.3 + 30 * chance());
    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec(10 * (double)i + chance(), 100 * chance(), 4 * chance() - 300);
        b.head[i] = vec_add(b.pole[i], vec(50 * chance(), 10 * chance(), 90));
    }
    b.length = 100;
    return b;
}

/* X(p) = x0 + a1 p + a2 p^2 + ..., a1 from X(h) = xe. */
static double by_manual(double from, double to, const double a[], int n, double h, double p)
{
    double a1 = (to - from) / h, x = from;
    for (int i = 0; i < n; i++) {
        a1 -= a[i] * pow(h, i + 1);
        x += a[i] * pow(p, i + 2);
    }
    return x + a1 * p;
}

static struct vec3 point_by_manual(struct vec3 from, struct vec3 to, const struct vec3 *a, int n,
                                   double h, double p)
{
    double x[8], y[8], z[8];
    for (int i = 0; i < n; i++) {
        x[i] = a[i].x;
        y[i] = a[i].y;
        z[i] = a[i].z;
    }
    return vec(by_manual(from.x, to.x, x, n, h, p), by_manual(from.y, to.y, y, n, h, p),
               by_manual(from.z, to.z, z, n, h, p));
}

START_TEST(the_curve_itself)
{
    for (int i = 0; i < 200; i++) {
        seed = (uint64_t)i + 1;
        int degree = 2 + i % 4, factors = nc_poly_factors(degree);
        struct bspline b = turning_curve(degree, (size_t)degree + 1 + (size_t)i % 9);
        struct nc_spans spans = {0};
        ck_assert(nc_poly_words(&spans, &b, 5));
        ck_assert_uint_eq(spans.n, b.poles - (size_t)degree);
        struct vec3 tip = b.pole[0], head = b.head[0];
        for (size_t s = 0; s < spans.n; s++) {
            const struct nc_span *n = &spans.item[s];
            double from = b.knot[(size_t)degree + s], to = b.knot[(size_t)degree + s + 1];
            for (int k = 0; k <= 20; k++) {
                double u = from + (to - from) * k / 20, p = n->h * k / 20;
                struct vec3 at = point_by_manual(tip, n->end, n->factor, factors, n->h, p);
                ck_assert_double_lt(vec_distance(at, bspline_at(&b, b.pole, u)), 2e-5);
                at = point_by_manual(head, n->head_end, n->head_factor, factors, n->h, p);
                ck_assert_double_lt(vec_distance(at, bspline_at(&b, b.head, u)), 2e-5);
            }
            tip = n->end;
            head = n->head_end;
        }
        array_free(&spans);
        bspline_free(&b);
    }
}
END_TEST

START_TEST(faults_are_seen)
{
    struct interpolation f = {.mode = INTERPOLATE_VECTOR};
    struct pose_deviation allowed = {0.001, 0.001};
    for (int i = 0; i < 40; i++) {
        seed = (uint64_t)i + 1;
        int degree = 2 + i % 4;
        struct bspline b = turning_curve(degree, (size_t)degree + 5);
        struct nc_spans spans = {0};
        struct doubles more = {0};
        struct pose from = {b.pole[0], vec(0, 0, 1)}, to = {b.pole[b.poles - 1], vec(0, 0, 1)};
        struct motion motion = motion_spline(from, to, &b);
        ck_assert(nc_poly_words(&spans, &b, 5));
        struct pose_deviation d =
            nc_poly_deviation(&spans, &b, &f, b.pole[0], b.head[0], &motion, allowed, &more);
        ck_assert_double_lt(d.point, 2e-5);
        ck_assert_double_lt(d.axis, 1e-6);
        ck_assert_uint_eq(more.n, 0);
        /* bent by 0.01 mm in its middle: a (p^2 - p h) is a h^2 / 4 there */
        struct nc_span *bad = &spans.item[2];
        bad->factor[0].y += 0.04 / (bad->h * bad->h);
        d = nc_poly_deviation(&spans, &b, &f, b.pole[0], b.head[0], &motion, allowed, &more);
        ck_assert_double_eq_tol(d.point, 0.01, 1e-4);
        ck_assert_uint_eq(more.n, 1);
        double middle = (b.knot[degree + 2] + b.knot[degree + 3]) / 2;
        ck_assert_double_eq_tol(more.item[0], middle, 1e-12);
        array_free(&more);
        array_free(&spans);
        bspline_free(&b);
    }
}
END_TEST

/* A cubic whose span is shorter and shorter: its factors grow with the cube of that, and none is
 * said with more than nine digits before its point. */
START_TEST(short_spans)
{
    size_t refused = 0, said = 0;
    for (double h = 1; h > 2e-6; h /= 3) {
        struct bspline b = bspline_new(3, 5, false);
        for (size_t i = 0; i < 9; i++)
            b.knot[i] = i < 4 ? 0 : i == 4 ? h : 1;
        for (size_t i = 0; i < 5; i++)
            b.pole[i] = vec(i < 2 ? 0 : (double)i, i % 2 ? 0.01 : -0.01, 0);
        struct nc_spans spans = {0};
        bool can = nc_poly_words(&spans, &b, 5);
        for (size_t i = 0; i < spans.n && can; i++)
            for (int k = 0; k < 2; k++)
                ck_assert_double_lt(vec_length(spans.item[i].factor[k]), 1e9);
        *(can ? &said : &refused) += 1;
        array_free(&spans);
        bspline_free(&b);
    }
    ck_assert_uint_ge(said, 3);
    ck_assert_uint_ge(refused, 1);
}
END_TEST

START_TEST(width)
{
    struct nc_span s = {.h = 1, .digits = 7};
    struct nc_spans spans = {1, 1, &s};
    s.end = vec(-12.5, 0, 100.12345);
    s.factor[0] = vec(-1.1234567, 2, 0);
    s.factor[1] = vec(0, 0.5, 0);
    const char words[] = " PO[X]=(-12.5,-1.1234567,0) PO[Y]=(0,2,0.5) PO[Z]=(100.12345,0,0)";
    /* one letter more for the H of a head, which is not there yet */
    ck_assert_uint_eq(nc_poly_width(&spans, 3, false, 5), strlen(words) + 3);
    s.head_end = s.end;
    memcpy(s.head_factor, s.factor, sizeof s.factor);
    ck_assert_uint_eq(nc_poly_width(&spans, 2, true, 5), 2 * (strlen(words) + 3));
    ck_assert_uint_eq(nc_poly_width(&spans, 5, false, 5), strlen(words) + 3 + 6 * strlen(",0"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_spline");
    TCase *tests = tcase_create("splines");
    tcase_add_test(tests, nurbs);
    tcase_add_test(tests, within_travel_between_ends);
    tcase_add_test(tests, beside_the_pole_axes_are_calm);
    tcase_add_test(tests, polynomials);
    tcase_add_test(tests, none);
    suite_add_tcase(suite, tests);
    tests = tcase_create("as polynomials");
    tcase_add_test(tests, the_curve_itself);
    tcase_add_test(tests, faults_are_seen);
    tcase_add_test(tests, short_spans);
    tcase_add_test(tests, width);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* construct - see construct.h. */
#include "nurbs/construct.h"

#include <stdlib.h>

#include "base/array.h"

static struct nurbs_pole weighted_pole(struct vec3 p, double w)
{
    return (struct nurbs_pole){w * p.x, w * p.y, w * p.z, w};
}

static struct vec3 pole_point(struct nurbs_pole p)
{
    return vec_scale(1 / p.w, vec(p.wx, p.wy, p.wz));
}

/* An axis whose knots the caller fills. */
static struct nurbs_axis new_axis(int degree, size_t poles, double from, double to)
{
    struct nurbs_axis a = {.degree = degree, .poles = poles, .from = from, .to = to};
    a.knot = mem_alloc(poles + (size_t)degree + 1, sizeof *a.knot);
    return a;
}

static struct nurbs_axis copy_axis(const struct nurbs_axis *a)
{
    struct nurbs_axis copy = new_axis(a->degree, a->poles, a->from, a->to);
    for (size_t i = 0; i < a->poles + (size_t)a->degree + 1; i++)
        copy.knot[i] = a->knot[i];
    return copy;
}

/* Clamped knots of Bezier segments joined at at[0..n], each inner one `degree` times. */
static struct nurbs_axis bezier_axis(int degree, const double *at, size_t n)
{
    size_t p = (size_t)degree;
    struct nurbs_axis a = new_axis(degree, p * n + 1, at[0], at[n]);
    for (size_t i = 0; i < a.poles + p + 1; i++)
        a.knot[i] = at[i == 0 ? 0 : (i - 1) / p < n ? (i - 1) / p : n];
    return a;
}

static struct nurbs_curve new_curve(struct nurbs_axis axis)
{
    return (struct nurbs_curve){axis, mem_alloc(axis.poles, sizeof(struct nurbs_pole))};
}

struct nurbs_curve construct_polyline(const struct vec3 *point, size_t n)
{
    double *at = mem_alloc(n, sizeof *at);
    for (size_t i = 0; i < n; i++)
        at[i] = (double)i / (double)(n - 1);
    struct nurbs_curve c = new_curve(bezier_axis(1, at, n - 1));
    for (size_t i = 0; i < n; i++)
        c.pole[i] = weighted_pole(point[i], 1);
    free(at);
    return c;
}

struct nurbs_curve construct_line(struct vec3 a, struct vec3 b)
{
    const struct vec3 point[2] = {a, b};
    return construct_polyline(point, 2);
}

/* The knots of an arc: pieces of up to a quarter of a turn. */
static struct nurbs_axis arc_axis(double from, double to)
{
    double at[5];
    size_t n = (size_t)fmin(fmax(ceil((to - from) / (PI / 2) - 1e-9), 1), 4);
    for (size_t i = 0; i <= n; i++)
        at[i] = i == n ? to : from + (to - from) * (double)i / (double)n;
    return bezier_axis(2, at, n);
}

/* Pole i of the arc of these knots on the unit circle, with its weight (The NURBS Book, eq 7.33).
 */
static struct nurbs_pole arc_pole(const struct nurbs_axis *a, size_t i)
{
    if (i % 2 == 0)
        return weighted_pole(vec(cos(a->knot[i + 1]), sin(a->knot[i + 1]), 0), 1);
    double middle = (a->knot[i] + a->knot[i + 2]) / 2, w = cos((a->knot[i + 2] - a->knot[i]) / 2);
    return (struct nurbs_pole){cos(middle), sin(middle), 0, w};
}

void construct_move(const struct transform *t, struct nurbs_pole *pole, size_t n)
{
    for (size_t i = 0; i < n; i++)
        pole[i] = weighted_pole(transform_point(t, pole_point(pole[i])), pole[i].w);
}

struct nurbs_curve construct_ellipse(const struct transform *place, double a, double b, double from,
                                     double to)
{
    struct nurbs_curve c = new_curve(arc_axis(from, to));
    for (size_t i = 0; i < c.t.poles; i++) {
        struct nurbs_pole p = arc_pole(&c.t, i);
        c.pole[i] = (struct nurbs_pole){a * p.wx, b * p.wy, 0, p.w};
    }
    construct_move(place, c.pole, c.t.poles);
    return c;
}

/* A conic of one segment by its ends and its middle pole. */
static struct nurbs_curve one_conic(const struct transform *place, struct vec3 first,
                                    struct vec3 middle, double w, struct vec3 last, double from,
                                    double to)
{
    const double at[2] = {from, to};
    struct nurbs_curve c = new_curve(bezier_axis(2, at, 1));
    c.pole[0] = weighted_pole(first, 1);
    c.pole[1] = weighted_pole(middle, w);
    c.pole[2] = weighted_pole(last, 1);
    construct_move(place, c.pole, 3);
    return c;
}

struct nurbs_curve construct_hyperbola(const struct transform *place, double a, double b,
                                       double from, double to)
{
    double middle = (from + to) / 2, w = cosh((to - from) / 2);
    return one_conic(place, vec(a * cosh(from), b * sinh(from), 0),
                     vec(a * cosh(middle) / w, b * sinh(middle) / w, 0), w,
                     vec(a * cosh(to), b * sinh(to), 0), from, to);
}

struct nurbs_curve construct_parabola(const struct transform *place, double a, double from,
                                      double to)
{
    return one_conic(place, vec(a * from * from, 2 * a * from, 0),
                     vec(a * from * to, a * (from + to), 0), 1, vec(a * to * to, 2 * a * to, 0),
                     from, to);
}

/* Bernstein coefficients of a cubic over 0..width from those of its powers, `step` apart. */
static void to_bernstein(const double *c, size_t step, double width, double b[4])
{
    double p[4] = {c[0], c[step] * width, c[2 * step] * width * width,
                   c[3 * step] * width * width * width};
    b[0] = p[0];
    b[1] = p[0] + p[1] / 3;
    b[2] = p[0] + p[1] * 2 / 3 + p[2] / 3;
    b[3] = p[0] + p[1] + p[2] + p[3];
}

struct nurbs construct_spline_surface(const double *u, size_t m, const double *v, size_t n,
                                      const double *c)
{
    struct nurbs s = {.u = bezier_axis(3, u, m), .v = bezier_axis(3, v, n)};
    s.pole = mem_alloc(s.u.poles * s.v.poles, sizeof *s.pole);
    for (size_t patch = 0; patch < m * n; patch++) {
        size_t i = patch / n, j = patch % n;
        double b[3][4][4]; /* [coordinate][power of t, then pole in v][pole in u] */
        for (size_t k = 0; k < 3; k++) {
            for (size_t q = 0; q < 4; q++)
                to_bernstein(c + 48 * patch + 16 * k + 4 * q, 1, u[i + 1] - u[i], b[k][q]);
            for (size_t p = 0; p < 4; p++) {
                double column[4];
                to_bernstein(&b[k][0][p], 4, v[j + 1] - v[j], column);
                for (size_t q = 0; q < 4; q++)
                    b[k][q][p] = column[q];
            }
        }
        for (size_t q = 0; q < 4; q++)
            for (size_t p = 0; p < 4; p++)
                s.pole[(3 * j + q) * s.u.poles + 3 * i + p] =
                    weighted_pole(vec(b[0][q][p], b[1][q][p], b[2][q][p]), 1);
    }
    return s;
}

struct nurbs_curve construct_spline_curve(const double *t, size_t n, const double *c)
{
    struct nurbs_curve s = new_curve(bezier_axis(3, t, n));
    for (size_t i = 0; i < n; i++) {
        double b[3][4];
        for (size_t k = 0; k < 3; k++)
            to_bernstein(c + 12 * i + 4 * k, 1, t[i + 1] - t[i], b[k]);
        for (size_t p = 0; p < 4; p++)
            s.pole[3 * i + p] = weighted_pole(vec(b[0][p], b[1][p], b[2][p]), 1);
    }
    return s;
}

/* Solves for the poles whose curve has these values at the Greville abscissae: elimination in a
 * band of `width` on both sides of the diagonal, which needs no pivots as the matrix is totally
 * positive (de Boor, A Practical Guide to Splines, chapter XIII). */
static void solve_band(double *a, struct nurbs_pole *x, size_t n, size_t width)
{
    size_t row = 2 * width + 1;
    for (size_t k = 0; k < n; k++)
        for (size_t i = k + 1; i < n && i <= k + width; i++) {
            double f = a[i * row + k + width - i] / a[k * row + width];
            for (size_t j = k; j < n && j <= k + width; j++)
                a[i * row + j + width - i] -= f * a[k * row + j + width - k];
            x[i] = (struct nurbs_pole){x[i].wx - f * x[k].wx, x[i].wy - f * x[k].wy,
                                       x[i].wz - f * x[k].wz, x[i].w - f * x[k].w};
        }
    for (size_t k = n; k-- > 0;) {
        double d = a[k * row + width];
        for (size_t j = k + 1; j < n && j <= k + width; j++) {
            double f = a[k * row + j + width - k];
            x[k] = (struct nurbs_pole){x[k].wx - f * x[j].wx, x[k].wy - f * x[j].wy,
                                       x[k].wz - f * x[j].wz, x[k].w - f * x[j].w};
        }
        x[k] = (struct nurbs_pole){x[k].wx / d, x[k].wy / d, x[k].wz / d, x[k].w / d};
    }
}

double construct_greville(const struct nurbs_axis *a, size_t i)
{
    double t = 0;
    for (size_t k = 1; k <= (size_t)a->degree; k++)
        t += a->knot[i + k];
    return i == 0 ? a->from : i + 1 == a->poles ? a->to : t / a->degree;
}

/* From values at the Greville abscissae to poles. */
static void solve_greville(const struct nurbs_axis *axis, struct nurbs_pole *pole)
{
    size_t p = (size_t)axis->degree, n = axis->poles, row = 2 * p + 1;
    double *a = mem_alloc(n * row, sizeof *a), value[NURBS_DEGREE_MAX + 1];
    for (size_t i = 0; i < n; i++) {
        size_t first = nurbs_basis(axis, construct_greville(axis, i), value);
        for (size_t k = 0; k <= p; k++)
            if (first + k + p >= i && first + k <= i + p)
                a[i * row + first + k + p - i] = value[k];
    }
    solve_band(a, pole, n, p);
    free(a);
}

struct nurbs_pole *construct_interpolation(const struct nurbs_axis *axis, const struct vec3 *value)
{
    struct nurbs_pole *pole = mem_alloc(axis->poles, sizeof *pole);
    for (size_t i = 0; i < axis->poles; i++)
        pole[i] = weighted_pole(value[i], 1);
    solve_greville(axis, pole);
    return pole;
}

/* Interpolates the curve on the knots of the axis, in whose spline space it lies: exact but for
 * rounding. */
static struct nurbs_curve interpolate_on(const struct nurbs_curve *c, struct nurbs_axis axis)
{
    struct nurbs_curve to = new_curve(axis);
    for (size_t i = 0; i < axis.poles; i++)
        to.pole[i] = nurbs_curve_pole(c, construct_greville(&axis, i));
    solve_greville(&axis, to.pole);
    return to;
}

/* The inner knots of a curve of higher degree: each of its own as many times more as the degree
 * rises. */
static void raised_knots(const struct nurbs_axis *a, int degree, struct doubles *knot)
{
    for (size_t i = 0; i < a->poles + (size_t)a->degree + 1; i++) {
        double x = a->knot[i];
        bool inside = x > a->from && x < a->to;
        if (!inside)
            continue;
        *array_push(knot) = x;
        bool last = !(a->knot[i + 1] <= x);
        for (int k = 0; k < degree - a->degree && last; k++)
            *array_push(knot) = x;
    }
}

/* Both lists, rising, into one: a knot as often as the list has it that has it more often. */
static void unite_knots(struct doubles *a, const double *b, size_t n, double near)
{
    struct doubles all = {0};
    size_t i = 0, k = 0;
    while (i < a->n || k < n) {
        bool same = i < a->n && k < n && fabs(a->item[i] - b[k]) <= near;
        bool from_a = same || k == n || (i < a->n && a->item[i] < b[k]);
        *array_push(&all) = from_a ? a->item[i] : b[k];
        i += from_a;
        k += same || !from_a;
    }
    array_free(a);
    *a = all;
}

struct nurbs_curve construct_refined(const struct nurbs_curve *c, int degree, const double *inner,
                                     size_t n)
{
    struct doubles knot = {0};
    size_t p = (size_t)degree;
    raised_knots(&c->t, degree, &knot);
    unite_knots(&knot, inner, n, 1e-9 * (c->t.to - c->t.from));
    struct nurbs_axis axis = new_axis(degree, knot.n + p + 1, c->t.from, c->t.to);
    for (size_t i = 0; i < axis.poles + p + 1; i++)
        axis.knot[i] = i <= p ? c->t.from : i - p - 1 < knot.n ? knot.item[i - p - 1] : c->t.to;
    array_free(&knot);
    return interpolate_on(c, axis);
}

struct nurbs construct_extrusion(const struct nurbs_curve *c, struct vec3 by)
{
    static const double ends[2] = {0, 1};
    struct nurbs s = {.u = copy_axis(&c->t), .v = bezier_axis(1, ends, 1)};
    s.pole = mem_alloc(2 * s.u.poles, sizeof *s.pole);
    for (size_t i = 0; i < s.u.poles; i++) {
        s.pole[i] = c->pole[i];
        s.pole[s.u.poles + i] = weighted_pole(vec_add(pole_point(c->pole[i]), by), c->pole[i].w);
    }
    return s;
}

/* How near to the axis an end of a curve is on it: by the width of the curve's poles. */
static double axis_reach(const struct nurbs_curve *c)
{
    const double rounding = 1e-7; /* files have as few as eight digits */
    double width = 0;
    for (size_t j = 1; j < c->t.poles; j++)
        width = fmax(width, vec_distance(pole_point(c->pole[j]), pole_point(c->pole[0])));
    return rounding * width;
}

struct nurbs construct_revolution(const struct nurbs_curve *c, struct vec3 at, struct vec3 axis,
                                  double from, double to)
{
    struct nurbs s = {.u = arc_axis(from, to), .v = copy_axis(&c->t)};
    double near = axis_reach(c);
    s.pole = mem_alloc(s.u.poles * s.v.poles, sizeof *s.pole);
    for (size_t j = 0; j < s.v.poles; j++) {
        struct vec3 p = vec_sub(pole_point(c->pole[j]), at);
        struct vec3 foot = vec_scale(vec_dot(p, axis), axis), x = vec_sub(p, foot);
        if ((j == 0 || j + 1 == s.v.poles) && vec_length(x) <= near)
            x = vec(0, 0, 0);
        struct vec3 y = vec_cross(axis, x);
        foot = vec_add(at, foot);
        for (size_t i = 0; i < s.u.poles; i++) {
            struct nurbs_pole a = arc_pole(&s.u, i);
            struct vec3 q = vec_along(vec_along(foot, a.wx / a.w, x), a.wy / a.w, y);
            s.pole[j * s.u.poles + i] = weighted_pole(q, a.w * c->pole[j].w);
        }
    }
    return s;
}

struct nurbs_curve construct_unit_range(const struct nurbs_curve *c)
{
    struct nurbs_curve copy = construct_refined(c, c->t.degree, NULL, 0);
    double from = copy.t.from, width = copy.t.to - from;
    for (size_t i = 0; i < copy.t.poles + (size_t)copy.t.degree + 1; i++)
        copy.t.knot[i] = (copy.t.knot[i] - from) / width;
    copy.t.from = 0;
    copy.t.to = 1;
    return copy;
}

struct nurbs_curve construct_joined(const struct nurbs_curve *c, size_t n)
{
    int degree = 1;
    size_t poles = 1, knots = 0, at = 0;
    double weight = 1;
    struct nurbs_curve *part = mem_alloc(n, sizeof *part);
    for (size_t i = 0; i < n; i++)
        degree = c[i].t.degree > degree ? c[i].t.degree : degree;
    for (size_t i = 0; i < n; i++) {
        struct nurbs_curve unit = construct_unit_range(&c[i]);
        part[i] = construct_refined(&unit, degree, NULL, 0);
        poles += part[i].t.poles - 1;
        nurbs_curve_free(&unit);
    }
    struct nurbs_curve all = new_curve(new_axis(degree, poles, 0, (double)n));
    for (size_t i = 0; i < n; i++) {
        const struct nurbs_curve *p = &part[i];
        size_t d = (size_t)degree, last = p->t.poles + d + (i + 1 == n);
        weight /= p->pole[0].w;
        for (size_t k = i == 0 ? 0 : d + 1; k < last; k++)
            all.t.knot[knots++] = (double)i + p->t.knot[k];
        for (size_t k = i == 0 ? 0 : 1; k < p->t.poles; k++)
            all.pole[at++] = weighted_pole(pole_point(p->pole[k]), weight * p->pole[k].w);
        weight *= p->pole[p->t.poles - 1].w;
    }
    for (size_t i = 0; i < n; i++)
        nurbs_curve_free(&part[i]);
    free(part);
    return all;
}

struct nurbs construct_ruled(const struct nurbs_curve *a, const struct nurbs_curve *b)
{
    static const double ends[2] = {0, 1};
    struct nurbs_curve unit[2] = {construct_unit_range(a), construct_unit_range(b)}, both[2];
    int degree = a->t.degree > b->t.degree ? a->t.degree : b->t.degree;
    struct doubles knot = {0}, second = {0};
    raised_knots(&unit[0].t, degree, &knot);
    raised_knots(&unit[1].t, degree, &second);
    unite_knots(&knot, second.item, second.n, 1e-9);
    for (int k = 0; k < 2; k++)
        both[k] = construct_refined(&unit[k], degree, knot.item, knot.n);
    struct nurbs s = {.u = both[0].t, .v = bezier_axis(1, ends, 1)};
    s.pole = mem_alloc(2 * s.u.poles, sizeof *s.pole);
    for (size_t i = 0; i < s.u.poles; i++) {
        s.pole[i] = both[0].pole[i];
        s.pole[s.u.poles + i] = both[1].pole[i];
    }
    both[0].t.knot = NULL; /* the surface has them */
    for (int k = 0; k < 2; k++) {
        nurbs_curve_free(&both[k]);
        nurbs_curve_free(&unit[k]);
    }
    array_free(&knot);
    array_free(&second);
    return s;
}

struct nurbs construct_plane(const struct transform *place, double x0, double x1, double y0,
                             double y1)
{
    const double x[2] = {x0, x1}, y[2] = {y0, y1};
    struct nurbs s = {.u = bezier_axis(1, x, 1), .v = bezier_axis(1, y, 1)};
    s.pole = mem_alloc(4, sizeof *s.pole);
    for (size_t i = 0; i < 4; i++)
        s.pole[i] = weighted_pole(vec(x[i % 2], y[i / 2], 0), 1);
    construct_move(place, s.pole, 4);
    return s;
}

struct transform construct_place(struct vec3 at, struct vec3 z, struct vec3 x)
{
    struct transform t = transform_identity();
    z = vec_length(z) > 0 ? vec_unit(z) : vec(0, 0, 1);
    x = vec_along(x, -vec_dot(x, z), z);
    if (!(vec_length(x) > 1e-9)) {
        struct vec3 other = fabs(z.x) < 0.8 ? vec(1, 0, 0) : vec(0, 1, 0);
        x = vec_along(other, -vec_dot(other, z), z);
    }
    x = vec_unit(x);
    struct vec3 y = vec_cross(z, x);
    const struct vec3 column[4] = {x, y, z, at};
    for (int k = 0; k < 4; k++) {
        t.m[0][k] = column[k].x;
        t.m[1][k] = column[k].y;
        t.m[2][k] = column[k].z;
    }
    return t;
}

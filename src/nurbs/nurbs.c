/*
 * nurbs - evaluation by the basis functions that are not zero; then normals, principal curvatures
 * and foot points.
 *
 * A row of them is raised from degree to degree; their derivatives come from the rows one and two
 * degrees lower.
 */
#include "nurbs/nurbs.h"

#include <stdlib.h>

#include "base/array.h"

enum { WIDTH = NURBS_DEGREE_MAX + 1 };

/* The basis functions at one place and their derivatives, from the pole `first` on. */
struct basis {
    size_t first;
    double d[3][WIDTH];
};

int nurbs_axis_check(struct nurbs_axis *a, const char *name, struct error *error)
{
    if (a->degree < 1 || a->degree > NURBS_DEGREE_MAX)
        return error_set(error, "degree %d in %s, expected 1 to %d", a->degree, name,
                         NURBS_DEGREE_MAX);
    if (a->poles < (size_t)a->degree + 1)
        return error_set(error, "%zu poles for degree %d in %s, expected at least %d", a->poles,
                         a->degree, name, a->degree + 1);
    for (size_t i = 0; i + 1 < a->poles + (size_t)a->degree + 1; i++)
        if (!(a->knot[i] <= a->knot[i + 1]))
            return error_set(error, "knot %zu in %s is %g, below the one before it (%g)", i + 2,
                             name, a->knot[i + 1], a->knot[i]);
    for (size_t i = 0; i < a->poles + (size_t)a->degree + 1; i++)
        if (!(fabs(a->knot[i]) <= NURBS_LARGEST))
            return error_set(error, "knot %zu in %s is %g, expected one within %g", i + 1, name,
                             a->knot[i], NURBS_LARGEST);
    double low = a->knot[a->degree], high = a->knot[a->poles];
    if (!(low < high))
        return error_set(error, "knots in %s that span nothing (%g to %g), expected rising ones",
                         name, low, high);
    a->from = fmax(a->from, low);
    a->to = fmin(a->to, high);
    if (!(a->from < a->to))
        return error_set(error,
                         "a range in %s from %g to %g, expected one inside the knots %g to %g",
                         name, a->from, a->to, low, high);
    return 0;
}

size_t nurbs_axis_breaks(const struct nurbs_axis *a, double *at, size_t most)
{
    size_t n = 0, degree = (size_t)a->degree;
    for (size_t i = 1; i < a->poles; i++) {
        double knot = a->knot[i];
        bool again = i + degree - 1 < a->poles + degree + 1 && a->knot[i + degree - 1] <= knot;
        if (again && a->knot[i - 1] < knot && knot > a->from && knot < a->to) {
            if (n < most)
                at[n] = knot;
            n++;
        }
    }
    return n;
}

/* The span of the knots that t lies in; at the end of the range the one before it. */
static size_t span_of(const struct nurbs_axis *a, double t)
{
    size_t low = (size_t)a->degree, high = a->poles;
    bool end = t >= a->to;
    double x = end ? a->to : t;
    while (high - low > 1) {
        size_t mid = low + (high - low) / 2;
        if (end ? a->knot[mid] >= x : a->knot[mid] > x)
            high = mid;
        else
            low = mid;
    }
    return low;
}

/* From the functions of degree d - 1 to those of degree d. */
static void raise_degree(const double *knot, size_t span, int d, double t, const double *low,
                         double *high)
{
    for (int r = 0; r <= d; r++) {
        const double *k = knot + span - (size_t)d + (size_t)r; /* k[0]: the first knot of it */
        high[r] = r > 0 ? (t - k[0]) / (k[d] - k[0]) * low[r - 1] : 0;
        if (r < d)
            high[r] += (k[d + 1] - t) / (k[d + 1] - k[1]) * low[r];
    }
}

/* The same for derivatives: those of degree d, one order more, from degree d - 1. */
static void raise_order(const double *knot, size_t span, int d, const double *low, double *high)
{
    for (int r = 0; r <= d; r++) {
        const double *k = knot + span - (size_t)d + (size_t)r;
        high[r] = r > 0 ? d * low[r - 1] / (k[d] - k[0]) : 0;
        if (r < d)
            high[r] -= d * low[r] / (k[d + 1] - k[1]);
    }
}

static void basis_at(const struct nurbs_axis *a, double t, int order, struct basis *b)
{
    int p = a->degree;
    size_t span = span_of(a, t);
    double row[WIDTH] = {1}, next[WIDTH], slope[WIDTH];
    b->first = span - (size_t)p;
    for (int r = 0; r <= p; r++)
        b->d[2][r] = 0;
    for (int d = 1; d <= p; d++) {
        if (d == p - 1 && order > 1) {
            raise_order(a->knot, span, d, row, slope);
            raise_order(a->knot, span, p, slope, b->d[2]);
        }
        if (d == p && order > 0)
            raise_order(a->knot, span, d, row, b->d[1]);
        raise_degree(a->knot, span, d, t, row, next);
        for (int r = 0; r <= d; r++)
            row[r] = next[r];
    }
    for (int r = 0; r <= p; r++)
        b->d[0][r] = row[r];
}

static struct nurbs_pole sum_poles(const struct nurbs *s, const struct basis *u,
                                   const struct basis *v, int k, int l)
{
    struct nurbs_pole sum = {0, 0, 0, 0};
    for (int j = 0; j <= s->v.degree; j++) {
        const struct nurbs_pole *row = s->pole + (v->first + (size_t)j) * s->u.poles + u->first;
        struct nurbs_pole r = {0, 0, 0, 0};
        for (int i = 0; i <= s->u.degree; i++) {
            double c = u->d[k][i];
            r.wx += c * row[i].wx;
            r.wy += c * row[i].wy;
            r.wz += c * row[i].wz;
            r.w += c * row[i].w;
        }
        double c = v->d[l][j]; /* NOLINT(clang-analyzer-core.*): up to the degree all are set */
        sum.wx += c * r.wx;
        sum.wy += c * r.wy;
        sum.wz += c * r.wz;
        sum.w += c * r.w;
    }
    return sum;
}

/* Eq 4.20 up to the second order: what the weights' own derivatives add is taken off again. */
void nurbs_derivatives(const struct nurbs *s, struct uv at, int order, struct vec3 d[3][3])
{
    static const int binomial[3][3] = {{1, 0, 0}, {1, 1, 0}, {1, 2, 1}};
    struct basis u, v;
    double w[3][3];
    basis_at(&s->u, at.u, order, &u);
    basis_at(&s->v, at.v, order, &v);
    for (int k = 0; k <= order; k++)
        for (int l = 0; k + l <= order; l++) {
            struct nurbs_pole a = sum_poles(s, &u, &v, k, l);
            struct vec3 sum = vec(a.wx, a.wy, a.wz);
            w[k][l] = a.w;
            for (int i = 0; i <= k; i++)
                for (int j = 0; j <= l; j++)
                    if (i + j > 0)
                        sum = vec_along(sum, -binomial[k][i] * binomial[l][j] * w[i][j],
                                        d[k - i][l - j]);
            d[k][l] = vec_scale(1 / w[0][0], sum);
        }
}

struct vec3 nurbs_point(const struct nurbs *s, struct uv at)
{
    struct vec3 d[3][3];
    nurbs_derivatives(s, at, 0, d);
    return d[0][0];
}

struct nurbs_pole nurbs_curve_pole(const struct nurbs_curve *c, double t)
{
    struct basis b;
    struct nurbs_pole sum = {0, 0, 0, 0};
    basis_at(&c->t, t, 0, &b);
    for (int i = 0; i <= c->t.degree; i++) {
        const struct nurbs_pole *pole = &c->pole[b.first + (size_t)i];
        sum.wx += b.d[0][i] * pole->wx;
        sum.wy += b.d[0][i] * pole->wy;
        sum.wz += b.d[0][i] * pole->wz;
        sum.w += b.d[0][i] * pole->w;
    }
    return sum;
}

struct vec3 nurbs_curve_point(const struct nurbs_curve *c, double t)
{
    struct nurbs_pole p = nurbs_curve_pole(c, t);
    return vec_scale(1 / p.w, vec(p.wx, p.wy, p.wz));
}

struct vec3 nurbs_curve_derivative(const struct nurbs_curve *c, double t)
{
    struct basis b;
    struct nurbs_pole p = {0, 0, 0, 0}, d = {0, 0, 0, 0};
    basis_at(&c->t, t, 1, &b);
    for (int i = 0; i <= c->t.degree; i++) {
        const struct nurbs_pole *pole = &c->pole[b.first + (size_t)i];
        p.wx += b.d[0][i] * pole->wx, d.wx += b.d[1][i] * pole->wx;
        p.wy += b.d[0][i] * pole->wy, d.wy += b.d[1][i] * pole->wy;
        p.wz += b.d[0][i] * pole->wz, d.wz += b.d[1][i] * pole->wz;
        p.w += b.d[0][i] * pole->w, d.w += b.d[1][i] * pole->w;
    }
    struct vec3 point = vec_scale(1 / p.w, vec(p.wx, p.wy, p.wz));
    return vec_scale(1 / p.w, vec_along(vec(d.wx, d.wy, d.wz), -d.w, point));
}

size_t nurbs_basis(const struct nurbs_axis *axis, double t, double *value)
{
    struct basis b;
    basis_at(axis, t, 0, &b);
    for (int i = 0; i <= axis->degree; i++)
        value[i] = b.d[0][i];
    return b.first;
}

void nurbs_curve_reverse(struct nurbs_curve *c)
{
    size_t knots = c->t.poles + (size_t)c->t.degree + 1;
    double sum = c->t.from + c->t.to;
    for (size_t i = 0, k = knots - 1; i <= k && k > 0; i++, k--) {
        double low = c->t.knot[i], high = c->t.knot[k];
        c->t.knot[i] = sum - high;
        c->t.knot[k] = sum - low;
    }
    for (size_t i = 0, k = c->t.poles - 1; i < k; i++, k--) {
        struct nurbs_pole first = c->pole[i];
        c->pole[i] = c->pole[k];
        c->pole[k] = first;
    }
}

/* Samples per span, and steps of the search between two of them. */
enum { FOOT_SAMPLES = 16, FOOT_STEPS = 60 };

/* The root of (C - q) . C' between two parameters, by halving; a difference is the derivative. */
static double foot_between(const struct nurbs_curve *c, struct vec3 q, double low, double high)
{
    double h = 1e-7 * (c->t.to - c->t.from);
    for (int i = 0; i < FOOT_STEPS && high > low; i++) {
        double t = (low + high) / 2;
        struct vec3 p = nurbs_curve_point(c, fmax(t - h, c->t.from));
        struct vec3 r = nurbs_curve_point(c, fmin(t + h, c->t.to));
        bool beyond = vec_dot(vec_sub(vec_mix(p, r, 0.5), q), vec_sub(r, p)) > 0;
        *(beyond ? &high : &low) = t;
    }
    return (low + high) / 2;
}

/* The nearest place so far. */
struct nearest {
    double t, off;
};

static void look_at(const struct nurbs_curve *c, struct vec3 q, double t, struct nearest *best)
{
    double off = vec_distance(nurbs_curve_point(c, t), q);
    if (off < best->off)
        *best = (struct nearest){t, off};
}

/* Every sample; or, `between` them, the root in each part that may lead nearer than all samples:
 * taken for no longer than twice its chord, it does.  A corner, which only a knot has, is an
 * end. */
static void look_along(const struct nurbs_curve *c, struct vec3 q, bool between,
                       struct nearest *best)
{
    const struct nurbs_axis *a = &c->t;
    double least = best->off;
    for (size_t i = (size_t)a->degree; i < a->poles; i++) {
        double from = fmax(a->knot[i], a->from), to = fmin(a->knot[i + 1], a->to), last = from;
        struct vec3 p = nurbs_curve_point(c, from);
        for (int k = 1; k <= FOOT_SAMPLES && to > from; k++) {
            double t = k < FOOT_SAMPLES ? from + (to - from) * k / FOOT_SAMPLES : to;
            if (!between) {
                look_at(c, q, t, best);
                continue;
            }
            struct vec3 r = nurbs_curve_point(c, t);
            double near = (vec_distance(p, q) + vec_distance(r, q)) / 2 - vec_distance(p, r);
            if (near < least)
                look_at(c, q, foot_between(c, q, last, t), best);
            last = t;
            p = r;
        }
    }
}

double nurbs_curve_foot(const struct nurbs_curve *c, struct vec3 q)
{
    struct nearest best = {c->t.from, HUGE_VAL};
    look_at(c, q, c->t.from, &best);
    look_along(c, q, false, &best);
    look_along(c, q, true, &best);
    return best.t;
}

void nurbs_free(struct nurbs *s)
{
    free(s->u.knot);
    free(s->v.knot);
    free(s->pole);
    *s = (struct nurbs){0};
}

void nurbs_curve_free(struct nurbs_curve *c)
{
    free(c->t.knot);
    free(c->pole);
    *c = (struct nurbs_curve){0};
}

/* The second fundamental form in an orthonormal frame e1 along dS/du, e2 = n x e1: its mean and
 * half the difference of its eigenvalues without cancellation. */
static void principal_curvatures(struct vec3 d[3][3], struct nurbs_place *p)
{
    struct vec3 n = p->normal, e1 = vec_unit(d[1][0]);
    double s = vec_length(d[1][0]), q1 = vec_dot(d[0][1], e1);
    double q2 = vec_dot(d[0][1], vec_cross(n, e1));
    double a = vec_dot(d[2][0], n), b = vec_dot(d[1][1], n), c = vec_dot(d[0][2], n);
    double r = q1 / s; /* e2 is (dS/dv - r dS/du) / q2 */
    double l11 = a / (s * s), l12 = (b - r * a) / (s * q2);
    double l22 = (c - 2 * r * b + r * r * a) / (q2 * q2);
    double mean = (l11 + l22) / 2, half = hypot((l11 - l22) / 2, l12);
    p->k1 = mean + half;
    p->k2 = mean - half;
}

static struct uv middle_of(const struct nurbs *s)
{
    return (struct uv){s->u.from + (s->u.to - s->u.from) / 2,
                       s->v.from + (s->v.to - s->v.from) / 2};
}

/* The normal from the first derivatives, and how far these are from being zero or parallel: 1 at
 * best.  What they are measured by is how far the surface goes over its whole range. */
static double plain_normal(const struct nurbs *s, struct vec3 d[3][3], struct vec3 *normal)
{
    double ru = s->u.to - s->u.from, rv = s->v.to - s->v.from;
    double twist = vec_length(d[1][1]) * ru * rv;
    double along_u = vec_length(d[1][0]) * ru + vec_length(d[2][0]) * ru * ru + twist;
    double along_v = vec_length(d[0][1]) * rv + vec_length(d[0][2]) * rv * rv + twist;
    struct vec3 cross = vec_cross(d[1][0], d[0][1]);
    *normal = vec_unit(cross);
    double whole = along_u * along_v;
    return whole > 0 ? vec_length(cross) * ru * rv / whole : 0;
}

/* On a degenerate edge one derivative is zero and grows inwards as d2S/dudv: so does the cross
 * product. */
static bool edge_normal(const struct nurbs *s, struct vec3 d[3][3], struct uv at,
                        struct vec3 *normal)
{
    struct uv middle = middle_of(s);
    struct vec3 twist = d[1][1];
    bool along_u =
        vec_length(d[1][0]) * (s->u.to - s->u.from) < vec_length(d[0][1]) * (s->v.to - s->v.from);
    struct vec3 cross = along_u ? vec_cross(twist, d[0][1]) : vec_cross(d[1][0], twist);
    struct vec3 other = along_u ? d[0][1] : d[1][0];
    bool inwards = along_u ? at.v < middle.v : at.u < middle.u;
    *normal = vec_scale(inwards ? 1 : -1, vec_unit(cross));
    return vec_length(cross) > 1e-6 * vec_length(twist) * vec_length(other);
}

static struct uv moved_inside(const struct nurbs *s, struct uv at, double part)
{
    struct uv middle = middle_of(s);
    return (struct uv){at.u + part * (middle.u - at.u), at.v + part * (middle.v - at.v)};
}

/* Where neither will do: from two places inside, extrapolated. */
static struct vec3 limit_normal(const struct nurbs *s, struct uv at)
{
    struct vec3 d[3][3], near, far;
    double part = 1e-4;
    nurbs_derivatives(s, moved_inside(s, at, part / 2), 1, d);
    near = vec_unit(vec_cross(d[1][0], d[0][1]));
    nurbs_derivatives(s, moved_inside(s, at, part), 1, d);
    far = vec_unit(vec_cross(d[1][0], d[0][1]));
    return vec_unit(vec_along(near, 1, vec_sub(near, far)));
}

/* Below these the normal is taken as the limit, and the curvatures, which lose twice as many
 * digits, from a little way inside. */
static const double NORMAL_LEAST = 1e-10, CURVATURE_LEAST = 1e-5;

/* The normal and how sound the derivatives are. */
static double find_normal(const struct nurbs *s, struct uv at, struct vec3 d[3][3],
                          struct vec3 *normal)
{
    double sound = plain_normal(s, d, normal);
    if (sound <= NORMAL_LEAST && !edge_normal(s, d, at, normal))
        *normal = limit_normal(s, at);
    return sound;
}

struct vec3 nurbs_normal(const struct nurbs *s, struct uv at, struct vec3 d[3][3])
{
    struct vec3 normal;
    find_normal(s, at, d, &normal);
    return normal;
}

struct nurbs_place nurbs_place(const struct nurbs *s, struct uv at)
{
    struct vec3 d[3][3];
    struct nurbs_place p = {0}, inner = {0};
    nurbs_derivatives(s, at, 2, d);
    p.point = d[0][0];
    double sound = find_normal(s, at, d, &p.normal);
    if (sound > CURVATURE_LEAST) {
        principal_curvatures(d, &p);
        return p;
    }
    nurbs_derivatives(s, moved_inside(s, at, 1e-3), 2, d);
    if (plain_normal(s, d, &inner.normal) > CURVATURE_LEAST) {
        principal_curvatures(d, &inner);
        p.k1 = inner.k1;
        p.k2 = inner.k2;
    }
    return p;
}

struct uv nurbs_foot(const struct nurbs *s, struct vec3 q, struct uv at)
{
    for (int turn = 0; turn < 30; turn++) {
        struct vec3 d[3][3];
        nurbs_derivatives(s, at, 1, d);
        struct vec3 r = vec_sub(q, d[0][0]);
        double e = vec_dot(d[1][0], d[1][0]), f = vec_dot(d[1][0], d[0][1]);
        double g = vec_dot(d[0][1], d[0][1]), area = e * g - f * f;
        double a = vec_dot(r, d[1][0]), b = vec_dot(r, d[0][1]);
        struct uv was = at;
        if (area > 1e-20 * e * g) {
            at.u += (a * g - b * f) / area;
            at.v += (b * e - a * f) / area;
        } else { /* at a pole one of the two does not move the point */
            at.u += e > g ? a / e : 0;
            at.v += g > e ? b / g : 0;
        }
        at.u = fmin(fmax(at.u, s->u.from), s->u.to);
        at.v = fmin(fmax(at.v, s->v.from), s->v.to);
        if (fabs(at.u - was.u) <= 1e-14 * (s->u.to - s->u.from) &&
            fabs(at.v - was.v) <= 1e-14 * (s->v.to - s->v.from))
            break;
    }
    return at;
}

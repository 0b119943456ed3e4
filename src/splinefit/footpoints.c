/* footpoints - see footpoints.h. */
#include "footpoints.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "spline_lsq.h"

/* ---- a curve by spans: Taylor's polynomials at the middle of each */

enum { ORDER_MAX = BSPLINE_DEGREE_MAX + 1, KNOTS_MAX = 3 * ORDER_MAX };

struct ppform ppform_new(const struct bspline *curve)
{
    struct ppform f = {.degree = curve->degree, .width = curve->head != NULL ? 6 : 3};
    size_t order = (size_t)f.degree + 1, width = (size_t)f.width;

    f.spans = curve->poles - (size_t)f.degree;
    f.curve = mem_alloc(f.spans * order * width, sizeof(double));
    f.basis = mem_alloc(f.spans * order * order, sizeof(double));
    f.slope = mem_alloc(f.spans * 2 * (size_t)f.degree * order * width, sizeof(double));
    return f;
}

void ppform_free(struct ppform *form)
{
    free(form->curve);
    free(form->basis);
    free(form->slope);
    *form = (struct ppform){0};
}

/* Adds  factor (sign s + shift) from[]  to the polynomial to[], from of `n` coefficients. */
static void add_product(double *to, const double *from, int n, double factor, double sign,
                        double shift)
{
    for (int k = 0; k < n; k++) {
        to[k] += factor * shift * from[k];
        to[k + 1] += factor * sign * from[k];
    }
}

/*
 * The coefficients by power of the basis functions of a span: c[function * order + power]; by the
 * recurrence of Cox and de Boor (The NURBS Book, A2.2) on polynomials instead of values.
 */
static void basis_powers(int degree, const double *knot, size_t span, double *c)
{
    int order = degree + 1;
    double half = (knot[span + 1] - knot[span]) / 2, middle = knot[span] + half;
    double before[ORDER_MAX * ORDER_MAX], by = 1 / half;

    memset(c, 0, (size_t)(order * order) * sizeof *c);
    c[0] = 1;
    for (int q = 1; q <= degree; q++) {
        memcpy(before, c, (size_t)(q * order) * sizeof *c);
        memset(c, 0, (size_t)((q + 1) * order) * sizeof *c);
        for (int r = 0; r < q; r++) {
            double right = (knot[span + 1 + (size_t)r] - middle) * by;
            double left = (knot[span + 1 + (size_t)r - (size_t)q] - middle) * by;
            double factor = 1 / (right - left);
            add_product(&c[r * order], &before[r * order], q, factor, -1, right);
            add_product(&c[(r + 1) * order], &before[r * order], q, factor, 1, -left);
        }
    }
}

/* sum += factor * polynomial[0..order-1] (one number each power) for all components of `pole`. */
static void add_pole(double *sum, int order, int width, const double *polynomial,
                     const double *pole)
{
    for (int k = 0; k < order; k++)
        for (int c = 0; c < width; c++)
            sum[k * width + c] += polynomial[k] * pole[c];
}

static void pole_values(const struct bspline *b, size_t i, double value[6])
{
    struct vec3 p = b->pole[i], h = b->head != NULL ? b->head[i] : vec(0, 0, 0);

    value[0] = p.x;
    value[1] = p.y;
    value[2] = p.z;
    value[3] = h.x;
    value[4] = h.y;
    value[5] = h.z;
}

void ppform_curve(struct ppform *form, const struct bspline *b)
{
    int order = form->degree + 1;
    size_t rows = (size_t)order, room = rows * (size_t)form->width, square = rows * rows;

    form->knot = b->knot;
    memset(form->curve, 0, form->spans * room * sizeof(double));
    for (size_t span = 0; span < form->spans; span++) {
        double *basis = &form->basis[span * square];
        basis_powers(form->degree, b->knot, span + (size_t)form->degree, basis);
        for (int i = 0; i < order; i++) {
            double pole[6];
            pole_values(b, span + (size_t)i, pole);
            add_pole(&form->curve[span * room], order, form->width, &basis[i * order], pole);
        }
    }
}

/* (P_i - P_(i-1)) / (t_(i+p) - t_i), for all components. */
static void pole_slope(const struct bspline *b, size_t i, double value[6])
{
    double before[6], width = b->knot[i + (size_t)b->degree] - b->knot[i];

    pole_values(b, i, value);
    pole_values(b, i - 1, before);
    for (int c = 0; c < 6; c++)
        value[c] = (value[c] - before[c]) / width;
}

/* The derivative by knot j in a span whose first knot is knot `at`. */
static void knot_slope(const struct ppform *form, const struct bspline *b, size_t at, size_t j,
                       double *slope)
{
    int order = form->degree + 1;
    size_t p = (size_t)form->degree;
    double doubled[KNOTS_MAX] = {0}, c[ORDER_MAX * ORDER_MAX];
    size_t first = at - p, last = at + p + 1; /* knots that matter here */
    size_t n = 0;

    for (size_t i = first; i <= last; i++) {
        doubled[n++] = b->knot[i];
        if (i == j)
            doubled[n++] = b->knot[i];
    }
    size_t span = (j <= at ? at + 1 : at) - first;
    basis_powers(form->degree, doubled, span, c);
    memset(slope, 0, (size_t)(order * form->width) * sizeof *slope);
    for (int k = 0; k < order; k++) {
        size_t i = span - p + (size_t)k + first; /* number of the function among the doubled */
        double pole[6];
        if (i + p < j || i > j)
            continue;
        pole_slope(b, i, pole);
        for (int d = 0; d < 6; d++)
            pole[d] = -pole[d];
        add_pole(slope, order, form->width, &c[k * order], pole);
    }
}

void ppform_slopes(struct ppform *form, const struct bspline *b)
{
    size_t p = (size_t)form->degree, room = (p + 1) * (size_t)form->width;

    for (size_t span = 0; span < form->spans; span++)
        for (size_t k = 0; k < 2 * p; k++) {
            size_t j = span + 1 + k;
            if (j > p && j < b->poles)
                knot_slope(form, b, span + p, j, &form->slope[(span * 2 * p + k) * room]);
        }
}

double ppform_half(const struct ppform *form, size_t span)
{
    const double *from = &form->knot[(size_t)form->degree + span];
    return (from[1] - from[0]) / 2;
}

double ppform_place(const struct ppform *form, size_t span, double u)
{
    const double *from = &form->knot[(size_t)form->degree + span];
    return (2 * u - from[0] - from[1]) / (from[1] - from[0]);
}

size_t ppform_span(const struct ppform *form, size_t near, double u)
{
    const double *knot = &form->knot[form->degree];

    while (near + 1 < form->spans && u >= knot[near + 1])
        near++;
    while (near > 0 && u < knot[near])
        near--;
    return near;
}

/* Horner's rule for value and derivatives by s at once; inline, for a width that is known. */
static inline void horner(const double *c, int degree, int width, double s, double *value,
                          double *first, double *second)
{
    for (int i = 0; i < width; i++) {
        value[i] = c[degree * width + i];
        first[i] = second[i] = 0;
    }
    for (int k = degree - 1; k >= 0; k--)
        for (int i = 0; i < width; i++) {
            second[i] = second[i] * s + first[i];
            first[i] = first[i] * s + value[i];
            value[i] = value[i] * s + c[k * width + i];
        }
}

void ppform_at(const struct ppform *form, size_t span, double u, double *value, double *first,
               double *second)
{
    const double *from = &form->knot[(size_t)form->degree + span];
    double by = 2 / (from[1] - from[0]), s = (u - from[0]) * by - 1;
    const double *c = &form->curve[span * (size_t)((form->degree + 1) * form->width)];

    if (form->width == 3 && form->degree == 3)
        horner(c, 3, 3, s, value, first, second);
    else if (form->width == 3)
        horner(c, form->degree, 3, s, value, first, second);
    else
        horner(c, form->degree, 6, s, value, first, second);
    for (int i = 0; i < form->width; i++) {
        first[i] *= by;
        second[i] *= 2 * by * by;
    }
}

/* ---- foot points: Newton's method on (C - Q) . C' = 0 */

enum { STEPS = 3 };
/* A foot is found when the step to it is below a thousandth of the distance, or of the tolerance:
 * beyond its reach the distance changes by the square of that. */
static const double SMALL = 0.05;

size_t footpoints_kinds(const struct reference *places)
{
    return places->turns ? FOOTPOINT_KINDS : 1;
}

struct footpoints footpoints_new(const struct reference *places, const struct deviation *within)
{
    struct footpoints f = {.within = *within};

    f.u = mem_alloc(places->n, sizeof *f.u);
    f.off = mem_alloc(places->n * footpoints_kinds(places), sizeof *f.off);
    f.point = mem_alloc(places->n, sizeof *f.point);
    if (places->turns) {
        f.v = mem_alloc(places->n, sizeof *f.v);
        f.other = mem_alloc(places->n, sizeof *f.other);
    }
    return f;
}

void footpoints_free(struct footpoints *feet)
{
    free(feet->u);
    free(feet->v);
    free(feet->off);
    free(feet->point);
    free(feet->other);
    *feet = (struct footpoints){0};
}

void footpoints_copy(struct footpoints *to, const struct footpoints *from,
                     const struct reference *places)
{
    memcpy(to->u, from->u, places->n * sizeof *to->u);
    if (places->turns)
        memcpy(to->v, from->v, places->n * sizeof *to->v);
    to->worst = from->worst;
    to->where = from->where;
}

/* The curve at u, of the point that is followed: the tracked one or the other one.
 */
struct place {
    struct vec3 off, speed, bend; /* bend: of the tracked point only */
    struct vec3 axis;
    double reach;
};

static struct vec3 first_vec(const double *value)
{
    return vec(value[0], value[1], value[2]);
}

static void evaluate_place(const struct ppform *form, const struct reference *places, size_t k,
                           bool other, const struct footpoint *at, struct place *p)
{
    double value[6], first[6], second[6];

    ppform_at(form, at->span, at->u, value, first, second);
    struct vec3 point = first_vec(value);
    p->speed = first_vec(first);
    p->bend = first_vec(second);
    if (places->turns) {
        struct vec3 reach = vec_sub(first_vec(value + 3), point);
        p->reach = vec_length(reach);
        p->axis = vec_scale(1 / p->reach, reach);
    }
    if (other) {
        struct vec3 turn = vec_sub(first_vec(first + 3), p->speed);
        point = vec_along(point, places->offset, p->axis);
        p->speed = vec_along(p->speed, places->offset / p->reach, vec_reject(turn, p->axis));
        p->bend = vec(0, 0, 0);
    }
    p->off = vec_sub(point, other ? places->other[k] : places->point[k]);
}

/* u with a step of Newton's, inside the curve and not over half a span. */
static double newton_step(const struct ppform *form, const struct footpoint *at, double step)
{
    double most = ppform_half(form, at->span);
    double from = form->knot[0], to = form->knot[(size_t)form->degree + form->spans];
    double u = at->u + (step > most ? most : step < -most ? -most : step);

    return u < from ? from : u > to ? to : u;
}

/* Follows the foot of place k from at->u.  Returns the distance there. */
static double follow_foot(const struct ppform *form, const struct reference *places,
                          double tolerance, size_t k, bool other, struct footpoint *at)
{
    double tiny = SMALL * tolerance;
    struct place p = {0};

    for (int i = 0;; i++) {
        at->span = ppform_span(form, at->span, at->u);
        evaluate_place(form, places, k, other, at, &p);
        double square = vec_dot(p.speed, p.speed), slope = square + vec_dot(p.off, p.bend);
        if (i == STEPS || !(square > 0))
            break;
        slope = slope > 0.25 * square ? slope : 0.25 * square;
        double u = newton_step(form, at, -vec_dot(p.off, p.speed) / slope), step = u - at->u;
        at->u = u;
        if (step * step * square <= SMALL * SMALL * vec_dot(p.off, p.off) + tiny * tiny) {
            p.off = vec_along(vec_along(p.off, step, p.speed), step * step / 2, p.bend);
            p.speed = vec_along(p.speed, step, p.bend);
            break;
        }
    }
    at->off = p.off;
    at->along = vec_unit(p.speed);
    at->axis = p.axis;
    at->reach = p.reach;
    return vec_length(p.off);
}

static void follow_other(const struct ppform *form, const struct reference *places, size_t k,
                         struct footpoints *feet)
{
    struct footpoint *point = &feet->point[k], *other = &feet->other[k];
    double *off = &feet->off[k * FOOTPOINT_KINDS];

    other->u = feet->v[k];
    other->span = point->span;
    off[1] = follow_foot(form, places, feet->within.point, k, true, other);
    feet->v[k] = other->u;
    struct vec3 axis = places->other_leads ? other->axis : point->axis;
    off[2] = vec_distance(axis, places->axis[k]) * feet->within.point / feet->within.axis;
}

void footpoints_follow(const struct ppform *form, const struct reference *places,
                       struct footpoints *feet)
{
    size_t near = 0, kinds = footpoints_kinds(places);

    feet->worst = 0;
    feet->where = 0;
    for (size_t k = 0; k < places->n; k++) {
        struct footpoint *point = &feet->point[k];
        point->u = feet->u[k];
        point->span = near;
        feet->off[k * kinds] = follow_foot(form, places, feet->within.point, k, false, point);
        feet->u[k] = point->u;
        near = point->span;
        if (places->turns)
            follow_other(form, places, k, feet);
        for (size_t i = 0; i < kinds; i++)
            if (!(feet->off[k * kinds + i] <= feet->worst)) {
                feet->worst = feet->off[k * kinds + i];
                feet->where = k;
            }
    }
}

/* ---- residuals: weights, and the chain rule for what hangs on the axis */

static const double HOLD = 1e-6; /* weight of the head's distance, which nothing else holds */

/* r^(power / 2 - 1), the weight of a place whose square is r moments_times the largest. */
static double weight_of(double r, int power)
{
    double w = 1;

    for (int k = power / 2 - 1; k > 0; k /= 2, r *= r)
        if (k % 2 == 1)
            w *= r;
    return w;
}

/* weight (I - tt' + more dd') and its g: the form of a point that moves by itself. */
struct norm {
    double weight, more;
    struct vec3 t, d, off;
};

static struct norm norm_of(struct vec3 off, struct vec3 along, double part, int power)
{
    struct norm n = {.weight = weight_of(part * part, power), .more = power - 2, .t = along};

    n.off = vec_reject(off, along);
    n.d = vec_unit(n.off);
    return n;
}

/* Adds  weight (I - tt' + more dd')  to the first rows and columns. */
static void add_plain(const struct norm *n, struct residual *f)
{
    double t[3] = {n->t.x, n->t.y, n->t.z}, d[3] = {n->d.x, n->d.y, n->d.z};
    double off[3] = {n->off.x, n->off.y, n->off.z};

    for (int i = 0, e = 0; i < 3; i++) {
        f->g[i] += n->weight * off[i];
        for (int j = 0; j <= i; j++)
            f->w[e++] += n->weight * ((i == j) - t[i] * t[j] + n->more * d[i] * d[j]);
    }
}

/*
 * Adds the form of a movement  A x_point + B x_head,  B = part (I - aa'),  A = whole I - B.
 * With N the plain form:  A'NA = whole^2 N - whole (NB + BN) + BNB,  B'NA = whole BN - BNB.
 */
static void add_turned(const struct norm *n, double whole, double part, struct vec3 axis,
                       struct residual *f)
{
    struct vec3 ta = vec_reject(n->t, axis), da = vec_reject(n->d, axis);
    struct vec3 ga = vec_reject(n->off, axis);
    double a[3] = {axis.x, axis.y, axis.z}, weight = n->weight, more = n->more;
    double t[3] = {n->t.x, n->t.y, n->t.z}, d[3] = {n->d.x, n->d.y, n->d.z};
    double tb[3] = {ta.x, ta.y, ta.z}, db[3] = {da.x, da.y, da.z};
    double off[3] = {n->off.x, n->off.y, n->off.z}, gb[3] = {ga.x, ga.y, ga.z};

    for (int i = 0; i < 3; i++) {
        f->g[i] += weight * (whole * off[i] - part * gb[i]);
        f->g[i + 3] += weight * part * gb[i];
        for (int j = 0; j < 3; j++) {
            double across = (i == j) - a[i] * a[j];
            double plain = (i == j) - t[i] * t[j] + more * d[i] * d[j];
            double bn = part * (across - tb[i] * t[j] + more * db[i] * d[j]);
            double nb = part * (across - t[i] * tb[j] + more * d[i] * db[j]);
            double bnb = part * part * (across - tb[i] * tb[j] + more * db[i] * db[j]);
            f->w[residual_at(i + 3, j)] += weight * (whole * bn - bnb);
            if (j > i)
                continue;
            f->w[residual_at(i, j)] += weight * (whole * whole * plain - whole * (nb + bn) + bnb);
            f->w[residual_at(i + 3, j + 3)] += weight * bnb;
        }
    }
}

static void add_length(const struct footpoint *s, struct residual *f)
{
    double a[3] = {s->axis.x, s->axis.y, s->axis.z}, off = HOLD * (s->reach - HEAD_LENGTH);

    for (int i = 0; i < 3; i++) {
        f->g[i] -= off * a[i];
        f->g[i + 3] += off * a[i];
        for (int j = 0; j < 3; j++) {
            double w = HOLD * a[i] * a[j];
            f->w[residual_at(i + 3, j)] -= w;
            if (j > i)
                continue;
            f->w[residual_at(i, j)] += w;
            f->w[residual_at(i + 3, j + 3)] += w;
        }
    }
}

static void add_axis(const struct footpoint *s, struct vec3 axis, double scale, double part,
                     int power, struct residual *f)
{
    struct vec3 off = vec_scale(scale, vec_sub(s->axis, axis));
    struct norm n = norm_of(off, vec(0, 0, 0), part, power);

    add_turned(&n, 0, scale / s->reach, s->axis, f);
    add_length(s, f);
}

void residual_of(const struct reference *places, const struct footpoints *feet, size_t k,
                 bool other, int power, struct residual *residual)
{
    const struct footpoint *s = other ? &feet->other[k] : &feet->point[k];
    const double *off = &feet->off[k * footpoints_kinds(places)];
    struct norm n = norm_of(s->off, s->along, off[other] / feet->worst, power);

    memset(residual, 0, sizeof *residual);
    if (other)
        add_turned(&n, 1, places->offset / s->reach, s->axis, residual);
    else
        add_plain(&n, residual);
    if (places->turns && other == places->other_leads)
        add_axis(s, places->axis[k], feet->within.point / feet->within.axis, off[2] / feet->worst,
                 power, residual);
}

/* ---- moments: sums and products, with the widths known to the compiler */

static inline int triangle_size(int width)
{
    return width * (width + 1) / 2;
}

size_t span_moments_size(int degree, int width)
{
    size_t p = (size_t)degree;
    return (2 * p + 1) * (size_t)triangle_size(width) + (p + 1) * (size_t)width;
}

const double *span_moments_right(const double *moments, int degree, int width)
{
    return moments + (2 * degree + 1) * triangle_size(width);
}

static inline void add_moments(double *restrict moments, int degree, int width, double s,
                               const struct residual *restrict residual)
{
    int size = triangle_size(width);
    double power = 1, *g = moments + (2 * degree + 1) * size;

    for (int k = 0; k <= 2 * degree; k++) {
        for (int e = 0; e < size; e++)
            moments[k * size + e] += power * residual->w[e];
        for (int i = 0; k <= degree && i < width; i++)
            g[k * width + i] += power * residual->g[i];
        power *= s;
    }
}

void span_moments_add(double *moments, int degree, int width, double s,
                      const struct residual *residual)
{
    if (width == 3)
        add_moments(moments, degree, 3, s, residual);
    else
        add_moments(moments, degree, 6, s, residual);
}

static inline void moments_times(const double *moments, int degree, int width, const double *c,
                                 double *restrict y)
{
    int size = triangle_size(width);

    for (int k = 0; k <= degree; k++)
        for (int i = 0; i < width; i++) {
            double sum = 0;
            for (int l = 0; l <= degree; l++)
                for (int j = 0; j < width; j++)
                    sum += moments[(k + l) * size + residual_at(i, j)] * c[l * width + j];
            y[k * width + i] = sum;
        }
}

void span_moments_times(const double *moments, int degree, int width, const double *c, double *y)
{
    if (width == 3)
        moments_times(moments, degree, 3, c, y);
    else
        moments_times(moments, degree, 6, c, y);
}

static inline void moments_of_basis(const double *moments, int degree, int width, const double *b,
                                    double *t)
{
    int size = triangle_size(width);

    for (int l = 0; l <= degree; l++) {
        double sum[RESIDUAL_SIZE] = {0};
        for (int k = 0; k <= degree; k++)
            for (int e = 0; e < size; e++)
                sum[e] += b[k] * moments[(k + l) * size + e];
        for (int i = 0; i < width; i++)
            for (int j = 0; j < width; j++)
                t[(l * width + i) * width + j] = sum[residual_at(i, j)];
    }
}

void span_moments_of_basis(const double *moments, int degree, int width, const double *b, double *t)
{
    if (width == 3)
        moments_of_basis(moments, degree, 3, b, t);
    else
        moments_of_basis(moments, degree, 6, b, t);
}

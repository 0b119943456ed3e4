/* arcspline_normal - see arcspline_normal.h. */
#include "arcspline_normal.h"

#include <stdlib.h>
#include <string.h>

#include "math/pnorm.h"

static const double MOVED = 1e-6; /* mm, for differences */

size_t arcspline_unknowns(const struct arcspline_fit *fit)
{
    size_t inner = fit->spline.n - 1;
    return (fit->start_held ? 0 : 2) + (fit->offset != 0 ? 4 : 3) * inner;
}

struct arcspline_normal arcspline_normal_new(const struct arcspline_fit *fit)
{
    size_t n = arcspline_unknowns(fit);
    return (struct arcspline_normal){
        .unknowns = n,
        .normal = band_new(n, n > 0 ? n - 1 : 0),
        .right = mem_alloc(n + 1, sizeof(double)),
        .axis = mem_alloc(fit->spline.n + 1, sizeof(struct joint_axis_slope)),
        .turn = mem_alloc(3 * n + 3, sizeof(double))};
}

void arcspline_normal_free(struct arcspline_normal *normal)
{
    band_free(&normal->normal);
    free(normal->right);
    free(normal->axis);
    free(normal->turn);
}

/* ---- one point */

static void put(double *at, struct vec3 v)
{
    at[0] = v.x;
    at[1] = v.y;
    at[2] = v.z;
}

/* The conic's point at b is P0 + along * t + part * (P1 - P0). */
struct conic_slope {
    struct vec3 e, t;          /* chord and tangent */
    double along, part;        /* mm; no unit */
    double by_length, by_turn; /* of `along` by a change of the chord's length along itself, and of
                                  both by the cosine of half the turn, divided by them */
    double length, cosine;
};

static struct conic_slope conic_slope_of(const struct joint *from, const struct joint *to, double b)
{
    struct conic_slope c = {.e = vec_sub(to->p, from->p), .t = from->tangent, .part = b};
    double ahead = vec_dot(c.e, c.t), both = b * (1 - b);

    c.length = vec_length(c.e);
    c.cosine = c.length > 0 ? ahead / c.length : 0;
    if (c.cosine < ARCSPLINE_BLUNT)
        return c; /* the chord */
    double sum = (1 - b) * (1 - b) + 2 * both * c.cosine + b * b;
    c.by_length = both / sum;
    c.along = c.by_length * c.length;
    c.part = b * b / sum;
    c.by_turn = -2 * both / sum;
    return c;
}

/* How far the conic's point goes in direction r, subtracted. */
static void conic_row(const struct conic_slope *c, struct vec3 r, double *row)
{
    double by_turn = c->by_turn * (c->along * vec_dot(r, c->t) + c->part * vec_dot(r, c->e));
    struct vec3 e = vec_scale(c->part, r), t = vec_scale(c->along, r);

    if (c->by_turn != 0) { /* the cosine is e.t / |e| */
        struct vec3 unit = vec_scale(1 / c->length, c->e);
        e = vec_along(e, c->by_length * vec_dot(r, c->t), unit);
        e = vec_along(e, by_turn / c->length, vec_along(c->t, -c->cosine, unit));
        t = vec_along(t, by_turn, unit);
    }
    put(row + ARC_FROM, vec_sub(e, r));
    put(row + ARC_TO, vec_scale(-1, e));
    put(row + ARC_TANGENT, vec_scale(-1, t));
    row[ARC_SIDES] = row[ARC_SIDES + 1] = 0;
}

/* Adds how far the other point goes by the axes at one end of the arc. */
static void axis_row(const struct joint_axis_slope *axis, struct vec3 r, double *p, double *side)
{
    for (int i = 0; i < 3; i++)
        p[i] -= vec_dot(r, axis->by[i]);
    *side -= vec_dot(r, axis->by[3]);
}

struct foot_slopes arcspline_foot_slopes(const struct arcspline *spline, double offset,
                                         const struct joint_axis_slope *axis,
                                         const struct arc_foot *q)
{
    const struct joint *from = &spline->joint[q->arc], *to = from + 1;
    struct conic_slope c = conic_slope_of(from, to, arc_foot_conic(q));
    struct foot_slopes f;

    conic_row(&c, q->u, f.along[0]); // cppcheck-suppress uninitvar
    conic_row(&c, q->v, f.along[1]);
    if (offset == 0)
        return f;
    struct vec3 mix = vec_mix(from->axis, to->axis, q->part), unit = vec_unit(mix);
    double mixed = vec_length(mix); /* nearly on the great circle, and cheap */
    for (int i = 2; i < 4; i++) {
        struct vec3 r = i == 2 ? q->s : q->w;
        double *row = f.along[i];
        conic_row(&c, r, row);
        r = vec_scale(offset / mixed, vec_reject(r, unit));
        axis_row(&axis[q->arc], vec_scale(1 - q->part, r), row + ARC_FROM, row + ARC_SIDES);
        axis_row(&axis[q->arc + 1], vec_scale(q->part, r), row + ARC_TO, row + ARC_SIDES + 1);
    }
    return f;
}

/* ---- one arc */

/* Products of what gives an arc, lower half, and with the distances. */
struct arc_sum {
    double product[ARC_GIVEN][ARC_GIVEN], right[ARC_GIVEN];
};

/* Adds a pair of distances (x, y) and its slopes; n: what gives the arc. */
static inline void add_products(struct arc_sum *sum, int n, struct pnorm_vector d,
                                const double *restrict x, const double *restrict y)
{
    double a[ARC_GIVEN], b[ARC_GIVEN];

    for (int i = 0; i < n; i++) {
        a[i] = d.xx * x[i] + d.xy * y[i];
        b[i] = d.xy * x[i] + d.yy * y[i];
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k <= i; k++)
            sum->product[i][k] += a[i] * a[k] + b[i] * b[k];
        sum->right[i] += a[i] * d.x + b[i] * d.y;
    }
}

static void add_pair(struct arc_sum *sum, bool turns, const double *off, double tolerance, int half,
                     double scale, const double along[2][ARC_GIVEN])
{
    struct pnorm_vector d = pnorm_vector_of(off[0], off[1], half, scale);

    d.xx /= tolerance;
    d.xy /= tolerance;
    d.yy /= tolerance;
    if (turns)
        add_products(sum, ARC_GIVEN, d, along[0], along[1]);
    else
        add_products(sum, ARC_SIDES, d, along[0], along[1]);
}

/* ---- all arcs */

/* The sum of arc i is spread over these unknowns: of what gives it but its tangent, SIZE_MAX where
 * that is held. */
static void unknowns_of_arc(const struct arcspline_fit *fit, size_t arc, size_t at[ARC_GIVEN])
{
    size_t start = fit->start_held ? 0 : 2, inner = fit->spline.n - 1;

    for (size_t i = 0; i < ARC_GIVEN; i++)
        at[i] = SIZE_MAX;
    for (size_t end = 0; end < 2; end++) {
        size_t joint = arc + end;
        if (joint == 0 || joint > inner)
            continue;
        for (size_t c = 0; c < 3; c++)
            at[3 * end + c] = start + 3 * (joint - 1) + c;
        if (fit->offset != 0)
            at[ARC_SIDES + end] = start + 3 * inner + joint - 1;
    }
}

static void add_at(struct band *normal, size_t i, size_t k, double x)
{
    if (i == k)
        *band_at(normal, i, i) += 2 * x;
    else
        *band_at(normal, i > k ? i : k, i > k ? k : i) += x;
}

/* Adds t'Mt for the slopes t of the tangent by the first n unknowns, and its right side. */
static void add_tangents(struct arcspline_normal *w, size_t n, const double m[3][3],
                         const double right[3])
{
    for (size_t i = 0; i < n; i++) {
        const double *t = &w->turn[3 * i];
        double x[3], *row = band_at(&w->normal, i, i);
        for (int c = 0; c < 3; c++)
            x[c] = m[c][0] * t[0] + m[c][1] * t[1] + m[c][2] * t[2];
        for (size_t k = 0; k <= i; k++) {
            const double *s = &w->turn[3 * k];
            row[i - k] += x[0] * s[0] + x[1] * s[1] + x[2] * s[2];
        }
        w->right[i] -= right[0] * t[0] + right[1] * t[1] + right[2] * t[2];
    }
}

/* Spreads the sum of an arc over the unknowns; the first `turning` of them turn its tangent. */
static void spread_sum(struct arcspline_normal *w, const struct arc_sum *sum, size_t turning,
                       const size_t at[ARC_GIVEN])
{
    double m[3][3], mixed[ARC_GIVEN][3];

    for (int i = 0; i < ARC_GIVEN; i++)
        for (int c = 0; c < 3; c++) {
            int t = ARC_TANGENT + c;
            mixed[i][c] = i > t ? sum->product[i][t] : sum->product[t][i];
            if (i >= ARC_TANGENT && i < ARC_SIDES)
                m[i - ARC_TANGENT][c] = mixed[i][c];
        }
    add_tangents(w, turning, (const double(*)[3])m, sum->right + ARC_TANGENT);
    for (int i = 0; i < ARC_GIVEN; i++) {
        if (at[i] == SIZE_MAX)
            continue;
        for (int k = 0; k <= i; k++)
            if (at[k] != SIZE_MAX)
                add_at(&w->normal, at[i], at[k],
                       i == k ? sum->product[i][i] / 2 : sum->product[i][k]);
        for (size_t k = 0; k < turning; k++) {
            const double *t = &w->turn[3 * k];
            add_at(&w->normal, at[i], k,
                   mixed[i][0] * t[0] + mixed[i][1] * t[1] + mixed[i][2] * t[2]);
        }
        w->right[at[i]] -= sum->right[i];
    }
}

/* The slopes of the tangent go from the start of an arc to its end: it is mirrored in the chord. */
static void mirror_slopes(struct arcspline_normal *w, const struct joint *joint, size_t *turning,
                          const size_t at[ARC_GIVEN])
{
    struct vec3 e = vec_sub(joint[1].p, joint->p), t = joint->tangent;
    double l2 = vec_dot(e, e), ahead = vec_dot(t, e);

    if (at[ARC_TO] !=
        SIZE_MAX) { /* the joint at its end is an unknown that turns it from here on */
        memset(&w->turn[3 * *turning], 0, 9 * sizeof *w->turn);
        *turning += 3;
    }
    if (!(l2 > 0))
        return;
    for (size_t k = 0; k < *turning; k++) {
        double *s = &w->turn[3 * k];
        struct vec3 before = vec(s[0], s[1], s[2]);
        put(s, vec_along(vec_scale(-1, before), 2 * vec_dot(before, e) / l2, e));
    }
    for (int end = 0; end < 2; end++) {
        for (int c = 0; c < 3; c++) {
            size_t k = at[3 * end + c];
            if (k == SIZE_MAX)
                continue;
            double sign = end ? 1 : -1;
            struct vec3 d = vec(c == 0, c == 1, c == 2); /* of the chord, but for the sign */
            struct vec3 by = vec_scale(2 * ahead / l2, d);
            by = vec_along(by, 2 * vec_dot(t, d) / l2 - 4 * ahead * vec_dot(e, d) / (l2 * l2), e);
            double *s = &w->turn[3 * k];
            put(s, vec_along(vec(s[0], s[1], s[2]), sign, by));
        }
    }
}

/* How the axes change with their joints. */
static void set_axis_slopes(const struct arcspline_fit *fit, struct arcspline_normal *w)
{
    struct arcspline spline = fit->spline; /* its joints are put back */

    memset(w->axis, 0, (spline.n + 1) * sizeof *w->axis);
    for (size_t i = 1; fit->offset != 0 && i < spline.n; i++) {
        const struct joint joint = spline.joint[i];
        for (int k = 0; k < 4; k++) {
            struct joint *j = &spline.joint[i];
            *(k == 0 ? &j->p.x : k == 1 ? &j->p.y : k == 2 ? &j->p.z : &j->side) += MOVED;
            arcspline_set_axis(&spline, fit->reference, i);
            w->axis[i].by[k] = vec_scale(1 / MOVED, vec_sub(j->axis, joint.axis));
            *j = joint;
        }
    }
}

static struct arc_sum sum_of_arc(const struct arcspline_fit *fit, size_t arc, const double *off,
                                 int half, double scale, const struct joint_axis_slope *axis)
{
    const struct arc_feet *feet = &fit->feet;
    struct arc_sum sum = {{{0}}, {0}};

    for (size_t i = arc_feet_first(feet, arc); i < feet->n && feet->item[i].arc == arc; i++) {
        struct foot_slopes f =
            arcspline_foot_slopes(&fit->spline, fit->offset, axis, &feet->item[i]);
        add_pair(&sum, false, off + 2 * i, fit->tolerance, half, scale, f.along);
        if (fit->offset != 0)
            add_pair(&sum, true, off + 2 * (feet->n + i), fit->other, half, scale, f.along + 2);
    }
    return sum;
}

/* The tangent at the end shall be fit->end. */
static void add_end(const struct arcspline_fit *fit, double held, size_t turning,
                    struct arcspline_normal *w)
{
    struct vec3 off = vec_sub(fit->spline.joint[fit->spline.n].tangent, fit->end);
    double h = held * held, m[3][3] = {{h, 0, 0}, {0, h, 0}, {0, 0, h}};
    double right[3] = {h * off.x, h * off.y, h * off.z};

    add_tangents(w, turning, (const double(*)[3])m, right);
}

void arcspline_normal_set(const struct arcspline_fit *fit, const double *off, int half,
                          double scale, double held, struct arcspline_normal *w)
{
    size_t turning = fit->start_held ? 0 : 2, n = w->unknowns, at[ARC_GIVEN];
    struct vec3 t = fit->spline.joint[0].tangent, u = vec_perpendicular(t);

    memset(w->normal.item, 0, n * (w->normal.width + 1) * sizeof(double));
    memset(w->right, 0, n * sizeof(double));
    set_axis_slopes(fit, w);
    if (turning > 0) {
        put(w->turn, u);
        put(w->turn + 3, vec_cross(t, u));
    }
    for (size_t i = 0; i < fit->spline.n; i++) {
        struct arc_sum sum = sum_of_arc(fit, i, off, half, scale, w->axis);
        unknowns_of_arc(fit, i, at);
        spread_sum(w, &sum, turning, at);
        mirror_slopes(w, &fit->spline.joint[i], &turning, at);
    }
    if (held > 0)
        add_end(fit, held, turning, w);
}

/*
 * residual - weights, and the chain rule for what hangs on the axis.
 */
#include "residual.h"

#include <string.h>

static const double HOLD = 1e-6; /* weight of the head's distance, which nothing else holds */

/* r^(power / 2 - 1), the weight of a place whose square is r times the largest. */
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
    double a[3] = {s->axis.x, s->axis.y, s->axis.z}, off = HOLD * (s->reach - TRACK_LENGTH);

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

static void add_axis(const struct target *target, size_t k, const struct footpoint *s, double part,
                     int power, struct residual *f)
{
    double scale = target->tolerance / target->angle;
    struct vec3 off = vec_scale(scale, vec_sub(s->axis, target->axis[k]));
    struct norm n = norm_of(off, vec(0, 0, 0), part, power);

    add_turned(&n, 0, scale / s->reach, s->axis, f);
    add_length(s, f);
}

void residual_of(const struct target *target, const struct footpoints *feet, size_t k, bool other,
                 int power, struct residual *pull)
{
    const struct footpoint *s = other ? &feet->other[k] : &feet->point[k];
    const double *off = &feet->off[k * footpoints_kinds(target)];
    struct norm n = norm_of(s->off, s->along, off[other] / feet->worst, power);

    memset(pull, 0, sizeof *pull);
    if (other)
        add_turned(&n, 1, target->offset / s->reach, s->axis, pull);
    else
        add_plain(&n, pull);
    if (target->axis != NULL && other == target->other_leads)
        add_axis(target, k, s, off[2] / feet->worst, power, pull);
}

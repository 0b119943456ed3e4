/*
 * nurbs - evaluation by the basis functions that are not zero.
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
        double c = v->d[l][j];
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

struct vec3 nurbs_curve_point(const struct nurbs_curve *c, double t)
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
    return vec_scale(1 / sum.w, vec(sum.wx, sum.wy, sum.wz));
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

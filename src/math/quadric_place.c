/* quadric_place - a quadric or cubic evaluated: normal, foot, curvature, distances; see quadric.h.
 */
#include "math/quadric.h"

struct vec3 quadric_normal(const struct quadric *q)
{
    return vec_unit(vec_along(vec_along(q->w, -q->c[1], q->u), -q->c[2], q->v));
}

double quadric_distance(const struct quadric *q)
{
    return fabs(q->c[0]) / sqrt(1 + q->c[1] * q->c[1] + q->c[2] * q->c[2]);
}

struct vec3 quadric_foot(const struct quadric *q)
{
    double slope2 = 1 + q->c[1] * q->c[1] + q->c[2] * q->c[2];
    struct vec3 across = vec_along(vec_along(q->w, -q->c[1], q->u), -q->c[2], q->v);
    return vec_along(q->origin, q->c[0] / slope2, across);
}

/* The eigenvalues k of the second fundamental form with respect to the first:
 * (EG - F^2) k^2 - (EN - 2FM + GL) k + (LN - M^2) = 0. */
double quadric_curvature(const struct quadric *q)
{
    double wu = q->c[1], wv = q->c[2], slope = sqrt(1 + wu * wu + wv * wv);
    double E = 1 + wu * wu, F = wu * wv, G = 1 + wv * wv;
    double L = 2 * q->c[3] / slope, M = q->c[4] / slope, N = 2 * q->c[5] / slope;
    double a = E * G - F * F, b = E * N - 2 * F * M + G * L, c = L * N - M * M;
    return (b + sqrt(fmax(b * b - 4 * a * c, 0))) / (2 * a);
}

double quadric_off(const struct quadric *q, struct vec3 point)
{
    const double *c = q->c;
    struct vec3 d = vec_sub(point, q->origin);
    double u = vec_dot(d, q->u), v = vec_dot(d, q->v), w = vec_dot(d, q->w);
    double off = w - (c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v));
    double wu = c[1] + 2 * c[3] * u + c[4] * v, wv = c[2] + 2 * c[5] * v + c[4] * u;
    off -= u * u * (c[6] * u + c[7] * v) + v * v * (c[8] * u + c[9] * v);
    wu += 3 * c[6] * u * u + 2 * c[7] * u * v + c[8] * v * v;
    wv += c[7] * u * u + 2 * c[8] * u * v + 3 * c[9] * v * v;
    return off / sqrt(1 + wu * wu + wv * wv);
}

double quadric_rms(const struct quadric *q, const struct vec3 *point, size_t n)
{
    double sum2 = 0;
    for (size_t i = 0; i < n; i++) {
        double off = quadric_off(q, point[i]);
        sum2 += off * off;
    }
    return sqrt(sum2 / (double)n);
}

struct vec3 quadric_at(const struct quadric *q, double u, double v)
{
    const double *c = q->c;
    double w = c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v) +
               u * u * (c[6] * u + c[7] * v) + v * v * (c[8] * u + c[9] * v);

    return vec_along(vec_along(vec_along(q->origin, u, q->u), v, q->v), w, q->w);
}

struct vec3 quadric_nearest(const struct quadric *q, struct vec3 point)
{
    const double still = 1e-9; /* mm */
    struct vec3 d = vec_sub(point, q->origin);
    double u = vec_dot(d, q->u), v = vec_dot(d, q->v);

    for (int turn = 0; turn < 8; turn++) {
        const double *c = q->c;
        double wu =
            c[1] + 2 * c[3] * u + c[4] * v + u * (3 * c[6] * u + 2 * c[7] * v) + c[8] * v * v;
        double wv =
            c[2] + 2 * c[5] * v + c[4] * u + v * (3 * c[9] * v + 2 * c[8] * u) + c[7] * u * u;
        struct vec3 off = vec_sub(point, quadric_at(q, u, v));
        double height = vec_dot(off, q->w), slope2 = 1 + wu * wu + wv * wv;
        double su = vec_dot(off, q->u) + height * wu, sv = vec_dot(off, q->v) + height * wv;
        double skew = (wu * su + wv * sv) / slope2; /* of the inverse of the first form */
        u += su - wu * skew;
        v += sv - wv * skew;
        if (hypot(su, sv) < still)
            break;
    }
    return quadric_at(q, u, v);
}

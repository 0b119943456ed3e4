/* edge_curve - see edge_curve.h. */
#include "curve/edge_curve.h"

static const double STEP = 0.5; /* sin 30 degrees */

struct vec3 edge_handle(struct vec3 p, struct vec3 normal, struct vec3 q)
{
    struct vec3 chord = vec_sub(q, p);
    double length = vec_length(chord);
    struct vec3 tangent = vec_reject(chord, normal);
    double cosine = length > 0 ? vec_length(tangent) / length : 1;

    return vec_along(p, 2 * length / (3 * (1 + cosine)), vec_unit(tangent));
}

struct edge_curve edge_chord(struct vec3 p, struct vec3 q)
{
    return (struct edge_curve){{p, vec_mix(p, q, 1 / 3.0), vec_mix(p, q, 2 / 3.0), q}};
}

struct edge_curve edge_curve(struct vec3 p, struct vec3 p_normal, struct vec3 q,
                             struct vec3 q_normal)
{
    struct vec3 chord = vec_sub(q, p);
    double steep = STEP * vec_length(chord);

    if (fabs(vec_dot(chord, p_normal)) > steep || fabs(vec_dot(chord, q_normal)) > steep)
        return edge_chord(p, q);
    return (struct edge_curve){{p, edge_handle(p, p_normal, q), edge_handle(q, q_normal, p), q}};
}

double edge_bulge(struct vec3 p, struct vec3 p_normal, struct vec3 q, struct vec3 q_normal)
{
    struct vec3 chord = vec_sub(q, p);

    return (fabs(vec_dot(chord, p_normal)) + fabs(vec_dot(chord, q_normal))) / 8;
}

struct vec3 edge_curve_at(const struct edge_curve *curve, double s)
{
    const struct vec3 *p = curve->p;
    double t = 1 - s;
    struct vec3 ends = vec_along(vec_scale(t * t * t, p[0]), s * s * s, p[3]);

    return vec_along(vec_along(ends, 3 * t * t * s, p[1]), 3 * t * s * s, p[2]);
}

struct vec3 edge_curve_slope(const struct edge_curve *curve, double s)
{
    const struct vec3 *p = curve->p;
    double t = 1 - s;
    struct vec3 first = vec_scale(3 * t * t, vec_sub(p[1], p[0]));

    return vec_along(vec_along(first, 6 * t * s, vec_sub(p[2], p[1])), 3 * s * s,
                     vec_sub(p[3], p[2]));
}

/* The height above the plane is a cubic in Bernstein form: Newton's method, and bisection where
 * that leaves the bracket (Press et al., Numerical Recipes, 9.4). */
double edge_curve_crossing(const struct edge_curve *curve, struct vec3 normal, double height)
{
    double low = 0, high = 1, s, h[4];

    for (int i = 0; i < 4; i++)
        h[i] = vec_dot(curve->p[i], normal) - height;
    s = h[3] > h[0] ? fmin(fmax(-h[0] / (h[3] - h[0]), 0), 1) : 0.5;
    for (int i = 0; i < 60 && high - low > 1e-15; i++) {
        double t = 1 - s;
        double at = t * t * (t * h[0] + 3 * s * h[1]) + s * s * (3 * t * h[2] + s * h[3]);
        double slope =
            3 * (t * t * (h[1] - h[0]) + 2 * t * s * (h[2] - h[1]) + s * s * (h[3] - h[2]));
        if (at <= 0)
            low = s;
        else
            high = s;
        double next = slope > 0 ? s - at / slope : -1;
        if (!(next >= low && next <= high))
            next = (low + high) / 2;
        if (fabs(next - s) < 1e-14)
            return next;
        s = next;
    }
    return s;
}

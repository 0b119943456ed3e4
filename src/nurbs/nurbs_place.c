/* nurbs_place - normals, principal curvatures and foot points on a surface; see nurbs.h. */
#include "nurbs/nurbs.h"

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

struct nurbs_place nurbs_place(const struct nurbs *s, struct uv at)
{
    struct vec3 d[3][3];
    struct nurbs_place p = {0}, inner = {0};
    nurbs_derivatives(s, at, 2, d);
    p.point = d[0][0];
    double sound = plain_normal(s, d, &p.normal);
    if (sound <= NORMAL_LEAST && !edge_normal(s, d, at, &p.normal))
        p.normal = limit_normal(s, at);
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

/* flank - see flank.h. */
#include "flank.h"

enum { PLANE = 3, QUADRIC = 6 };

/* Spread across a neighbourhood by its length, below which its points are on a line. */
static const double NARROW = 0.05;

/* What a quadric may leave of what a plane leaves, to be worth its freedom. */
static const double BETTER = 0.6;

static void place(const struct quadric *q, struct vec3 p, double *u, double *v, double *w)
{
    struct vec3 d = vec_sub(p, q->origin);

    *u = vec_dot(d, q->u);
    *v = vec_dot(d, q->v);
    *w = vec_dot(d, q->w);
}

/* What the fit leaves to each of the points that it does not fix. */
static double left_over(const struct quadric *q, const struct vec3 *point, size_t n, size_t fixed)
{
    return n > fixed ? quadric_rms(q, point, n) * sqrt((double)n / (double)(n - fixed)) : 0;
}

int flank_plane(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 w,
                struct flank *sheet)
{
    struct quadric q = {.origin = origin, .w = w, .u = vec_perpendicular(w)};
    double u, v, h, mu = 0, mv = 0, mh = 0, uu = 0, uv = 0, vv = 0, uh = 0, vh = 0;

    q.v = vec_cross(w, q.u);
    if (n <= PLANE)
        return -1;
    for (size_t i = 0; i < n; i++) {
        place(&q, point[i], &u, &v, &h);
        mu += u / (double)n;
        mv += v / (double)n;
        mh += h / (double)n;
    }
    for (size_t i = 0; i < n; i++) {
        place(&q, point[i], &u, &v, &h);
        uu += (u - mu) * (u - mu);
        uv += (u - mu) * (v - mv);
        vv += (v - mv) * (v - mv);
        uh += (u - mu) * (h - mh);
        vh += (v - mv) * (h - mh);
    }
    /* the smaller eigenvalue by the larger one is the square of width by length */
    double mean = (uu + vv) / 2, half = hypot((uu - vv) / 2, uv), det = uu * vv - uv * uv;
    if (!(mean - half > NARROW * NARROW * (mean + half)) || !(det > 0))
        return -1;
    q.c[1] = (uh * vv - vh * uv) / det;
    q.c[2] = (vh * uu - uh * uv) / det;
    q.c[0] = mh - q.c[1] * mu - q.c[2] * mv;
    *sheet = (struct flank){q, left_over(&q, point, n, PLANE)};
    return 0;
}

struct flank flank_through(struct vec3 place, struct vec3 normal, struct vec3 origin, struct vec3 w)
{
    struct flank f = {.q = {.origin = origin, .w = w, .u = vec_perpendicular(w)}, .rms = 0};
    double upright = vec_dot(normal, w);

    f.q.v = vec_cross(w, f.q.u);
    f.q.c[1] = -vec_dot(normal, f.q.u) / upright;
    f.q.c[2] = -vec_dot(normal, f.q.v) / upright;
    f.q.c[0] = vec_dot(normal, vec_sub(place, origin)) / upright;
    return f;
}

void flank_bend(const struct vec3 *point, size_t n, struct flank *sheet)
{
    struct flank bent;

    if (n < 3 * QUADRIC || quadric_fit(point, n, sheet->q.origin, sheet->q.w, &bent.q) < 0)
        return;
    bent.rms = left_over(&bent.q, point, n, QUADRIC);
    if (bent.rms < BETTER * sheet->rms)
        *sheet = bent;
}

double flank_height(const struct flank *sheet, struct vec3 p)
{
    const double *c = sheet->q.c;
    double u, v, w;

    place(&sheet->q, p, &u, &v, &w);
    return c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v);
}

double flank_above(const struct flank *sheet, struct vec3 p)
{
    return vec_dot(vec_sub(p, sheet->q.origin), sheet->q.w) - flank_height(sheet, p);
}

struct vec3 flank_point(const struct flank *sheet, struct vec3 p)
{
    return vec_along(p, -flank_above(sheet, p), sheet->q.w);
}

struct vec3 flank_normal(const struct flank *sheet, struct vec3 p)
{
    const struct quadric *q = &sheet->q;
    double u, v, w;

    place(q, p, &u, &v, &w);
    double du = q->c[1] + 2 * q->c[3] * u + q->c[4] * v;
    double dv = q->c[2] + 2 * q->c[5] * v + q->c[4] * u;
    return vec_unit(vec_along(vec_along(q->w, -du, q->u), -dv, q->v));
}

/* crest - see crest.h. */
#include "crest.h"

#include <stdbool.h>

#include "math/plane_fit.h"
#include "math/ridge_direction.h"

enum { STEPS = 48, FEW = 12, SOME = 24, MANY = 48, WIDEST = FEATURE_MOST, TRIES = 5 };

static const double BEND = 0.04;   /* of the edge, at a crest */
static const double BESIDE = 0.08; /* of the edge, beside it, but no more than ... */
static const double FAR = 0.4;     /* ... mean spacings */
static const double ROUND = 0.4;   /* curvature along by that across: more is no rib */
static const double BENT = 0.5;    /* curvature across by the length of the edge: less is no rib */
static const double TIGHT = 1.5;   /* curvature by the length of the edge: so tight it is a peak */
static const double FACING = 0.3;  /* z of a normal that is seen well from above */
static const double NOISY = 0.05;  /* spacings: less noise needs no more points */

/* The surface over an edge, in equal steps. */
struct profile {
    const struct feature_cloud *cloud;
    struct vec3 a, b, up; /* ends, the normal of the neighbourhood */
    double length;        /* from a to b across `up` */
    int n;
    double height[STEPS + 1]; /* along `up`, over a */
};

/* Twice as many points where there is much noise, from few on. */
static size_t enough(const struct feature_cloud *cloud, size_t few)
{
    double noisy = cloud->noise / cloud->spacing / NOISY - 1;

    return few + (size_t)((double)few * fmin(fmax(noisy, 0), 1));
}

/* Over the way from a to b, at the height h. */
static struct vec3 over(const struct profile *p, double part, double h)
{
    struct vec3 way = vec_reject(vec_sub(p->b, p->a), p->up);

    return vec_along(vec_along(p->a, part, way), h, p->up);
}

/* The plane that the neighbourhood lies about. */
static bool find_up(struct profile *p)
{
    size_t index[WIDEST];
    struct vec3 near[WIDEST];
    struct plane_fit plane;
    double reach = 2 * vec_distance(p->a, p->b) / p->cloud->spacing;
    size_t k = (size_t)fmin(fmax(PI * reach * reach, 60), WIDEST);

    k = kdtree_nearest(p->cloud->tree, vec_mix(p->a, p->b, 0.5), k, index, NULL);
    for (size_t i = 0; i < k; i++)
        near[i] = p->cloud->point[index[i]];
    if (plane_fit(near, k, &plane) < 0)
        return false;
    p->up = plane.normal.z < 0 ? vec_scale(-1, plane.normal) : plane.normal;
    p->length = vec_length(vec_reject(vec_sub(p->b, p->a), p->up));
    return p->length > 0 && p->up.z > FACING;
}

/* A quadric through the points nearest to a place. */
static bool look_at(const struct profile *p, struct vec3 at, struct quadric *q)
{
    size_t index[SOME];
    struct vec3 near[SOME];
    size_t k = kdtree_nearest(p->cloud->tree, at, enough(p->cloud, FEW), index, NULL);

    for (size_t i = 0; i < k; i++)
        near[i] = p->cloud->point[index[i]];
    return quadric_fit(near, k, at, p->up, q) == 0;
}

/* Follows the surface from a to b, each step from the height where the one before leads. */
static bool follow(struct profile *p)
{
    double slope = 0, far = 3 * p->cloud->spacing;
    int n = (int)fmin(ceil(2 * p->length / p->cloud->spacing), STEPS);

    p->n = n > 4 ? n : 4;
    p->height[0] = 0;
    for (int i = 1; i < p->n; i++) {
        struct quadric q;
        struct vec3 way = vec_scale(1.0 / p->n, vec_reject(vec_sub(p->b, p->a), p->up));
        double h = p->height[i - 1] + slope;
        if (look_at(p, over(p, (double)i / p->n, h), &q)) {
            if (!(fabs(q.c[0]) < far))
                return false;
            h += q.c[0];
            slope = q.c[1] * vec_dot(way, q.u) + q.c[2] * vec_dot(way, q.v);
        }
        p->height[i] = h;
    }
    p->height[p->n] = vec_dot(vec_sub(p->b, p->a), p->up);
    return true;
}

/* How far a height is over the chord from end to end. */
static double over_chord(const struct profile *p, double part, double height)
{
    return height - part * p->height[p->n];
}

/* The step that is highest over the chord, or deepest under it where sign is -1; 0: none is. */
static int extreme(const struct profile *p, double sign, double *over)
{
    int top = 0;

    *over = 0;
    for (int i = 1; i < p->n; i++) {
        double off = sign * over_chord(p, (double)i / p->n, p->height[i]);
        if (off > *over) {
            *over = off;
            top = i;
        }
    }
    return top;
}

/* The way in which a surface bends least, across its w. */
static struct vec3 straight_way(const struct quadric *q, bool *rib, double *across)
{
    double xx = 2 * q->c[3], xy = q->c[4], yy = 2 * q->c[5];
    double middle = (xx + yy) / 2, half = hypot((xx - yy) / 2, xy);
    double turn = 0.5 * atan2(2 * xy, xx - yy) + (middle < 0 ? 0 : PI / 2);

    *across = middle + (middle < 0 ? -half : half);
    *rib = fabs(2 * middle - *across) <= ROUND * fabs(*across);
    return vec_along(vec_scale(cos(turn), q->u), sin(turn), q->v);
}

/* The surface along the rib at a place that is near to it; false: there is no rib. */
static bool fit_along(const struct profile *p, struct vec3 at, struct quadric *q)
{
    size_t index[RIDGE_DIRECTION_LONGER * MANY], some = enough(p->cloud, SOME);
    struct vec3 near[RIDGE_DIRECTION_LONGER * MANY];
    double across;
    bool rib;
    size_t k = kdtree_nearest(p->cloud->tree, at, RIDGE_DIRECTION_LONGER * some, index, NULL);

    for (size_t i = 0; i < k; i++)
        near[i] = p->cloud->point[index[i]];
    if (quadric_fit(near, k < some ? k : some, at, p->up, q) < 0)
        return false;
    struct vec3 way = straight_way(q, &rib, &across);
    if (fabs(across) * p->length < BENT || quadric_normal(q).z < FACING)
        return false;
    if (rib) {
        struct ridge_direction best;
        if (!ridge_direction_find(near, k, at, p->up, way, some, &best))
            return false;
        *q = best.q;
        return quadric_normal(q).z > FACING &&
               best.rms < 1.6 * p->cloud->noise + 0.15 * p->cloud->spacing;
    }
    double rms = quadric_rms(q, near, k < some ? k : some);
    return fabs(across) * p->length > TIGHT &&
           rms < 1.6 * p->cloud->noise + 0.1 * p->cloud->spacing;
}

/* Along the way over the edge: first and second derivative of the surface, by mm. */
static void derive(const struct profile *p, const struct quadric *q, double *slope, double *bend)
{
    struct vec3 way = vec_unit(vec_reject(vec_sub(p->b, p->a), p->up));
    double u = vec_dot(way, q->u), v = vec_dot(way, q->v);

    *slope = q->c[1] * u + q->c[2] * v;
    *bend = 2 * (q->c[3] * u * u + q->c[4] * u * v + q->c[5] * v * v);
}

static void add_point(struct crest *c, int at, double part, const struct quadric *q)
{
    for (int i = c->n++; i > at; i--) {
        c->part[i] = c->part[i - 1];
        c->place[i] = c->place[i - 1];
        c->normal[i] = c->normal[i - 1];
        c->kmax[i] = c->kmax[i - 1];
    }
    c->part[at] = part;
    c->place[at] = vec_along(q->origin, q->c[0], q->w);
    c->normal[at] = quadric_normal(q);
    c->kmax[at] = quadric_curvature(q);
    if (c->top >= at)
        c->top++;
}

/* The crest itself, from the step nearest to it. */
static bool climb(const struct profile *p, int step, double sign, struct crest *c)
{
    double part = (double)step / p->n, rim = fmin(0.06, 0.15 * p->cloud->spacing / p->length);
    double h = p->height[step];
    struct quadric q;

    for (int i = 0; i < TRIES; i++) {
        double slope, bend;
        if (!fit_along(p, over(p, part, h), &q))
            return false;
        h += q.c[0];
        derive(p, &q, &slope, &bend);
        if (!(sign * bend < 0))
            return false;
        double shift = -slope / bend / p->length, most = 2.0 / p->n;
        if (i + 1 < TRIES)
            part += fmin(fmax(shift, -most), most);
    }
    double least = fmax(BEND * p->length / 2, 1.3 * p->cloud->noise);
    if (!(part > rim && part < 1 - rim) || sign * over_chord(p, part, h) < least)
        return false;
    add_point(c, 0, part, &q);
    c->top = 0;
    return true;
}

/* The step that is farthest off the chord between two places on the way. */
static int off_chord(const struct profile *p, double from, double h0, double to, double h1,
                     double *most)
{
    int worst = -1;

    *most = 0;
    for (int i = 1; i < p->n; i++) {
        double part = (double)i / p->n, s = (part - from) / (to - from);
        if (!(s > 0 && s < 1))
            continue;
        double off = fabs(p->height[i] - h0 - s * (h1 - h0));
        if (off > *most) {
            *most = off;
            worst = i;
        }
    }
    return worst;
}

/* Puts a point where the surface is farthest off the chain.  False: nowhere far enough. */
static bool refine(const struct profile *p, struct crest *c)
{
    double apart = p->cloud->spacing / p->length;
    double most = fmax(fmin(BESIDE * p->length, FAR * p->cloud->spacing), 2 * p->cloud->noise);
    int worst = -1, at = 0;

    for (int i = 0; i <= c->n; i++) {
        double from = i > 0 ? c->part[i - 1] : 0, to = i < c->n ? c->part[i] : 1, off;
        double h0 = i > 0 ? vec_dot(vec_sub(c->place[i - 1], p->a), p->up) : 0;
        double h1 = i < c->n ? vec_dot(vec_sub(c->place[i], p->a), p->up) : p->height[p->n];
        int step = off_chord(p, from, h0, to, h1, &off);
        double part = (double)step / p->n;
        if (off > most && part - from > apart && to - part > apart) {
            most = off;
            worst = step;
            at = i;
        }
    }
    double part = (double)worst / p->n;
    struct quadric q;
    if (worst < 0 || !fit_along(p, over(p, part, p->height[worst]), &q))
        return false;
    add_point(c, at, part, &q);
    return true;
}

struct crest crest_find(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b)
{
    struct profile p = {.cloud = cloud, .a = a, .b = b};
    struct crest c = {.n = 0, .top = -1};
    double sign[2] = {1, -1}, over[2];
    int step[2];

    if (!find_up(&p) || !follow(&p))
        return c;
    for (int i = 0; i < 2; i++)
        step[i] = extreme(&p, sign[i], &over[i]);
    int first = over[0] > over[1] ? 0 : 1;
    for (int i = 0; i < 2 && c.n == 0; i++) {
        int k = i == 0 ? first : 1 - first;
        if (over[k] > fmax(BEND * p.length, cloud->noise))
            climb(&p, step[k], sign[k], &c);
    }
    while (c.n < CREST_MOST && refine(&p, &c))
        ;
    return c;
}

/* crest - see feature_steps.h. */
#include <stdbool.h>

#include "feature_steps.h"
#include "math/ridge_direction.h"

/* Steps over an edge at most; points that a step takes, and a place on a rib, at least, and there
 * at most; points that serve all steps; how often a crest is looked for from where the last look
 * found it. */
enum { STEPS = 48, FEW = 12, SOME = 24, MANY = 48, SHARED = 96, TRIES = 5 };

static const double STEP = 0.5;    /* spacings */
static const double BEND = 0.04;   /* of the edge, at a crest */
static const double BESIDE = 0.08; /* of the edge, beside it, but no more than ... */
static const double FAR = 0.4;     /* ... mean spacings */
static const double ROUND = 0.4;   /* curvature along by that across: more is no rib */
static const double BENT = 0.5;    /* curvature across by the length of the edge: less is no rib */
static const double TIGHT = 1.5;   /* curvature by the length of the edge: so tight it is a peak */
static const double FACING = 0.3;  /* z of a normal that is seen well from above */
static const double NOISY = 0.05;  /* spacings: less noise needs no more points */
static const double STILL = 0.03;  /* spacings: a step that is no longer comes to rest */

/* ---- the surface over an edge, in equal steps */

struct profile {
    const struct feature_cloud *cloud;
    struct vec3 a, b, up; /* ends, the normal of the neighbourhood */
    double length;        /* from a to b across `up` */
    int n;
    double height[STEPS + 1]; /* along `up`, over a */
    struct vec3 near[SHARED]; /* points about the middle that serve all steps, 0: too many would */
    size_t gathered;
};

/* Twice as many points where there is much noise, from few on. */
static size_t points_needed(const struct feature_cloud *cloud, size_t few)
{
    double noisy = cloud->noise / cloud->spacing / NOISY - 1;

    return few + (size_t)((double)few * fmin(fmax(noisy, 0), 1));
}

/* Over the way from a to b, at the height h. */
static struct vec3 place_over(const struct profile *p, double part, double h)
{
    struct vec3 way = vec_reject(vec_sub(p->b, p->a), p->up);

    return vec_along(vec_along(p->a, part, way), h, p->up);
}

/* Is the neighbourhood seen from above, and no edge along its normal? */
static bool measure_way(struct profile *p)
{
    p->length = vec_length(vec_reject(vec_sub(p->b, p->a), p->up));
    return p->length > 0 && p->up.z > FACING;
}

/* The points that are nearest to any step lie in a ball about the middle. */
static void gather_points(struct profile *p)
{
    double each =
        (double)points_needed(p->cloud, FEW) / (PI * p->up.z); /* spacings^2 that a step takes */
    double reach = p->length / 2 / p->cloud->spacing + sqrt(each);
    double k = ceil(PI * p->up.z * reach * reach);

    p->gathered = 0;
    if (k <= SHARED)
        p->gathered = feature_near(p->cloud, vec_mix(p->a, p->b, 0.5), (size_t)k, p->near);
}

/* A quadric through the points nearest to a place. */
static bool fit_at(const struct profile *p, struct vec3 at, struct quadric *q)
{
    struct vec3 near[SOME];
    size_t k = points_needed(p->cloud, FEW);

    if (p->gathered >= k)
        k = neighbourhood_along(p->near, p->gathered, at, p->up, 1, k, near);
    else
        k = feature_near(p->cloud, at, k, near);
    return quadric_fit(near, k, at, p->up, q) == 0;
}

/* Follows the surface from a to b, each step from the height where the one before leads. */
static bool follow_surface(struct profile *p)
{
    double slope = 0, far = 3 * p->cloud->spacing;
    int n = (int)fmin(ceil(p->length / (STEP * p->cloud->spacing)), STEPS);

    p->n = n > 4 ? n : 4;
    p->height[0] = 0;
    gather_points(p);
    for (int i = 1; i < p->n; i++) {
        struct quadric q;
        struct vec3 way = vec_scale(1.0 / p->n, vec_reject(vec_sub(p->b, p->a), p->up));
        double h = p->height[i - 1] + slope;
        if (fit_at(p, place_over(p, (double)i / p->n, h), &q)) {
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
static int extreme_step(const struct profile *p, double sign, double *over)
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

/* ---- the surface at one place, along the rib */

/* Points about a place of the crest, which serve places beside it too, and how it runs there, unit;
 * none to begin with. */
struct hood {
    struct vec3 near[RIDGE_DIRECTION_LONGER * MANY], at, way;
    size_t n;
};

/* The way in which a surface bends least, across its w. */
static struct vec3 straight_direction(const struct quadric *q, bool *rib, double *across)
{
    double xx = 2 * q->c[3], xy = q->c[4], yy = 2 * q->c[5];
    double middle = (xx + yy) / 2, half = hypot((xx - yy) / 2, xy);
    double turn = 0.5 * atan2(2 * xy, xx - yy) + (middle < 0 ? 0 : PI / 2);

    *across = middle + (middle < 0 ? -half : half);
    *rib = fabs(2 * middle - *across) <= ROUND * fabs(*across);
    return vec_along(vec_scale(cos(turn), q->u), sin(turn), q->v);
}

/* The points leave a surface along a rib no more than noise and rounding do. */
static bool is_explained(const struct profile *p, double rms, double round)
{
    return rms < 1.6 * p->cloud->noise + round * p->cloud->spacing;
}

/* The surface along the rib at a place beside the one whose points these are. */
static bool fit_beside(const struct profile *p, struct vec3 at, struct hood *hood,
                       struct quadric *q)
{
    size_t some = points_needed(p->cloud, SOME);
    struct ridge_direction best;
    double across;
    bool rib;

    if (!ridge_direction_follow(hood->near, hood->n, at, p->up, hood->way, some, &best))
        return false;
    *q = best.q;
    hood->way = best.way;
    straight_direction(q, &rib, &across);
    return fabs(across) * p->length >= BENT && quadric_normal(q).z > FACING &&
           is_explained(p, best.rms, 0.15);
}

/* The surface along the rib at a place that is near to it; false: there is no rib. */
static bool fit_along(const struct profile *p, struct vec3 at, struct hood *hood, struct quadric *q)
{
    size_t some = points_needed(p->cloud, SOME);
    double across;
    bool rib;

    /* cppcheck-suppress ctuuninitvar ; n alone says whether there is anything in it */
    if (hood->n > 0 && vec_distance(at, hood->at) < p->cloud->spacing)
        return fit_beside(p, at, hood, q);
    size_t k = feature_near(p->cloud, at, RIDGE_DIRECTION_LONGER * some, hood->near);
    hood->n = 0;
    if (quadric_fit(hood->near, k < some ? k : some, at, p->up, q) < 0)
        return false;
    struct vec3 way = straight_direction(q, &rib, &across);
    if (fabs(across) * p->length < BENT || quadric_normal(q).z < FACING)
        return false;
    if (rib) {
        struct ridge_direction best;
        if (!ridge_direction_find(hood->near, k, at, p->up, way, some, &best))
            return false;
        *q = best.q;
        hood->n = k;
        hood->at = at;
        hood->way = best.way;
        return quadric_normal(q).z > FACING && is_explained(p, best.rms, 0.15);
    }
    double rms = quadric_rms(q, hood->near, k < some ? k : some);
    return fabs(across) * p->length > TIGHT && is_explained(p, rms, 0.1);
}

/* Along the way over the edge: first and second derivative of the surface, by mm. */
static void slope_and_bend(const struct profile *p, const struct quadric *q, double *slope,
                           double *bend)
{
    struct vec3 way = vec_unit(vec_reject(vec_sub(p->b, p->a), p->up));
    double u = vec_dot(way, q->u), v = vec_dot(way, q->v);

    *slope = q->c[1] * u + q->c[2] * v;
    *bend = 2 * (q->c[3] * u * u + q->c[4] * u * v + q->c[5] * v * v);
}

/* ---- the crest, and places beside it */

static struct vec3 place_of(const struct quadric *q)
{
    return vec_along(q->origin, q->c[0], q->w);
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
    c->place[at] = place_of(q);
    c->normal[at] = quadric_normal(q);
    c->kmax[at] = quadric_curvature(q);
    if (c->top >= at)
        c->top++;
}

/* The crest itself, from the step nearest to it. */
static bool find_crest(const struct profile *p, int step, double sign, struct crest *c)
{
    double part = (double)step / p->n, rim = fmin(0.06, 0.15 * p->cloud->spacing / p->length);
    double h = p->height[step];
    struct hood hood;
    struct quadric q;

    hood.n = 0;
    for (int i = 0; i < TRIES; i++) {
        double slope, bend;
        if (!fit_along(p, place_over(p, part, h), &hood, &q))
            return false;
        h += q.c[0];
        slope_and_bend(p, &q, &slope, &bend);
        if (!(sign * bend < 0))
            return false;
        double shift = -slope / bend / p->length, most = 2.0 / p->n;
        if (fabs(shift) * p->length < STILL * p->cloud->spacing)
            break;
        if (i + 1 < TRIES)
            part += fmin(fmax(shift, -most), most);
    }
    double least = fmax(BEND * p->length / 2, 1.3 * p->cloud->noise);
    if (!(part > rim && part < 1 - rim) || sign * over_chord(p, part, h) < least ||
        !feature_has_points(p->cloud, place_of(&q)))
        return false;
    add_point(c, 0, part, &q);
    c->top = 0;
    return true;
}

/* Puts a point where the surface is farthest off the chain.  False: nowhere far enough. */
static bool add_farthest(const struct profile *p, struct crest *c)
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
    struct hood hood;
    struct quadric q;
    hood.n = 0;
    if (worst < 0 || !fit_along(p, place_over(p, part, p->height[worst]), &hood, &q) ||
        !feature_has_points(p->cloud, place_of(&q)))
        return false;
    add_point(c, at, part, &q);
    return true;
}

struct crest crest_find(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                        struct vec3 up)
{
    struct profile p = {.cloud = cloud, .a = a, .b = b, .up = up};
    struct crest c = {.n = 0, .top = -1};
    double sign[2] = {1, -1}, over[2];
    int step[2];

    if (!measure_way(&p) || !follow_surface(&p))
        return c;
    for (int i = 0; i < 2; i++)
        step[i] = extreme_step(&p, sign[i], &over[i]);
    int first = over[0] > over[1] ? 0 : 1;
    for (int i = 0; i < 2 && c.n == 0; i++) {
        int k = i == 0 ? first : 1 - first;
        if (over[k] > fmax(BEND * p.length, cloud->noise))
            find_crest(&p, step[k], sign[k], &c);
    }
    while (c.n < CREST_MOST && add_farthest(&p, &c))
        ;
    return c;
}

/* upsample - see upsample.h. */
#include "cloud/upsample.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud/upsample_surface.h"
#include "math/triangles.h"

enum {
    FEWEST = UPSAMPLE_FEWEST,
    NEAR = UPSAMPLE_NEAR,
    RINGS = 14,
    RINGS_MOST = 40, /* where the scan is sparse for the ball and has few points */
    BRIDGED = 8,     /* rings: no farther beyond a border, or in a hole than the radius, or ... */
    SAMPLE = 1500,
    SECTORS = 32
};

static const double OF_ALL = 1.4; /* ... mean distances of points */
static const double PLACES = 2e7; /* of all points together, but for those of RINGS */
static const double MUCH = 1.5;   /* spread of a neighbourhood by the noise: more is none */
static const double VAGUE = 5;    /* of the sinking: a surface less certain than this is none */

/* Of what is allowed, beside a blunt edge: so far off a surface points may be, and surfaces of
 * neighbours off a place. */
static const double ROUGH = 5, ACROSS = 3;

/* Noises that a point may be off its surface; of the way to the nearest point: points so near to a
 * place are about it, or surround it as its nearest do. */
static const double SIGMAS = 4, ABOUT = 2, SURROUND = 3;

/* Of the way from a place to the last point of its neighbourhood: so near is the first at least,
 * where they surround it, and where they do not. */
static const double HOLE = 0.8, BEYOND = 0.4;

/* Points so far apart let the ball sink as far as it may. */
static double gap_of(const struct upsample *fill)
{
    return sqrt(6 * fill->radius * fill->sink);
}

bool upsample_needed(const struct upsample *fill)
{
    const struct point_grid *b = fill->point_grid;
    size_t sample = b->n < SAMPLE ? b->n : SAMPLE, wide = 0, seen = 0;

    for (size_t i = 0; i < sample; i++) {
        struct upsample_hood near;
        upsample_hood_find(fill, i * b->n / sample, 7, &near);
        if (near.n < 7)
            continue;
        seen++;
        wide += sqrt(near.distance2[6]) > gap_of(fill);
    }
    return 10 * wide > seen;
}

/* A surface about a point, and how far the points of the neighbourhood are off it. */
struct local_surface {
    const struct upsample_surface *surface;
    bool known; /* off[] */
    double off[NEAR];
    bool exact;   /* points are where the surface is, not beside it by noise */
    bool smooth;  /* as the ball asks for, beside it too */
    bool beyond;  /* so near it a place may be beyond a border */
    bool rough;   /* an edge may be on it */
    bool doubted; /* it was, at a place */
};

/* Rings of places about a point, at most. */
static double most_rings(const struct upsample *fill)
{
    return fmax(RINGS, fmin(RINGS_MOST, sqrt(PLACES / (double)fill->point_grid->n)));
}

/* How far a point may be off a surface that is to be used at a place so far from it, mm.  A ball
 * that touches the part there is so far off its tangent plane, twice, that the point stays
 * touched; and a surface that is vague is none. */
static double allowed(const struct upsample *fill, double distance2, bool rough)
{
    double touched = distance2 / (4 * fill->radius);
    double shape = fmax(fill->sink, fmin(touched, VAGUE * fill->sink));

    return (rough ? ROUGH : 1) * shape + SIGMAS * fill->noise;
}

/* Directions in a plane: those furthest to the left and to the right while all are in one half
 * plane, and then none. */
struct fan {
    size_t n;
    bool around; /* no half plane is without any of them */
    double left[2], right[2];
};

/* How far the direction x, y is to the left of another one. */
static double left_of(const double from[2], double x, double y)
{
    return from[0] * y - from[1] * x;
}

static void fan_set(double side[2], double x, double y)
{
    side[0] = x;
    side[1] = y;
}

static void fan_add(struct fan *fan, double x, double y)
{
    if (fan->around)
        return;
    if (fan->n++ == 0) {
        fan_set(fan->left, x, y);
        fan_set(fan->right, x, y);
        return;
    }
    double left = left_of(fan->left, x, y), right = left_of(fan->right, x, y);
    bool back = left == 0 && right == 0 && fan->left[0] * x + fan->left[1] * y < 0;
    fan->around = left > 0 && right < 0;
    if ((left > 0 && right >= 0) || back)
        fan_set(fan->left, x, y);
    else if (right < 0 && left <= 0)
        fan_set(fan->right, x, y);
}

/* So far about point i points surround it, seen from above; or the nearest of AROUND reach. */
static double surrounded_within(const struct point_grid *b, size_t i)
{
    enum { AROUND = 64 };
    uint32_t index[AROUND];
    double distance2[AROUND];
    size_t n = point_grid_nearest(b, b->point[i], AROUND, index, distance2), k = 0;
    struct fan fan = {.n = 0};

    for (; k < n && !fan.around; k++) {
        struct vec3 to = vec_sub(b->point[index[k]], b->point[i]);
        if (index[k] != i)
            fan_add(&fan, to.x, to.y);
    }
    return k > 0 ? sqrt(distance2[k - 1]) : 0;
}

double upsample_gap(const struct upsample *fill)
{
    const struct point_grid *b = fill->point_grid;
    size_t sample = b->n < SAMPLE ? b->n : SAMPLE;
    double within[SAMPLE];

    if (!fill->lines || sample == 0)
        return point_grid_spacing(b);
    for (size_t i = 0; i < sample; i++)
        within[i] = surrounded_within(b, i * b->n / sample);
    return doubles_select(within, sample, sample / 2);
}

/* The ways from a place to the points of a neighbourhood but its own, the first. */
struct ways {
    size_t n; /* the first is not set */
    struct vec3 to[NEAR];
    double length2[NEAR];
    size_t last; /* the one that was nearer to the place asked for before */
    const struct quadric *q;
    double high; /* mm: no place that is asked for is farther off the plane of q */
    double along_u, along_v, enough; /* of the last */
};

/* How far the surface is off the plane u, v at most, up to `u` and `v` from its origin. */
static double highest(const struct upsample_surface *surface, double u, double v)
{
    const double *c = surface->q.c;
    double high = 0;

    if (!surface->facetted)
        return fabs(c[0]) + u * (fabs(c[1]) + fabs(c[3]) * u + fabs(c[4]) * v) +
               v * (fabs(c[2]) + fabs(c[5]) * v) + u * u * (fabs(c[6]) * u + fabs(c[7]) * v) +
               v * v * (fabs(c[8]) * u + fabs(c[9]) * v);
    for (int k = 0; k < surface->facets.n; k++) {
        c = surface->facets.plane[k];
        high = fmax(high, fabs(c[0]) + u * fabs(c[1]) + v * fabs(c[2]));
    }
    return high;
}

/* From a place near a surface to places of it within `reach`. */
static void set_ways(const struct upsample_hood *near, struct vec3 from,
                     const struct upsample_surface *surface, double reach, struct ways *ways)
{
    struct vec3 at = quadric_local(&surface->q, from);

    ways->n = near->n < NEAR ? near->n : NEAR;
    ways->last = 0;
    ways->q = &surface->q;
    ways->high = fabs(at.z) + highest(surface, fabs(at.x) + reach, fabs(at.y) + reach);
    ways->along_u = ways->along_v = 0;
    ways->enough = HUGE_VAL;
    for (size_t i = 1; i < ways->n; i++) {
        ways->to[i] = vec_sub(near->point[i], from);
        ways->length2[i] = vec_dot(ways->to[i], ways->to[i]);
    }
}

/* Point i is nearer to the end of the way `out` than its beginning is. */
static bool is_nearer(const struct ways *ways, size_t i, struct vec3 out)
{
    return 2 * vec_dot(out, ways->to[i]) > ways->length2[i];
}

static void keep_last(struct ways *ways, size_t i)
{
    const double rounding = 1e-9; /* mm */
    struct vec3 to = ways->to[i];
    double off = fabs(vec_dot(to, ways->q->w)) * ways->high;

    ways->last = i;
    ways->along_u = 2 * vec_dot(to, ways->q->u);
    ways->along_v = 2 * vec_dot(to, ways->q->v);
    ways->enough = ways->length2[i] + 2 * off + rounding * (1 + sqrt(ways->length2[i]));
}

/* The last one surely is nearer to a place of the quadric, so far along u and v, wherever it is off
 * the plane. */
static bool is_last_nearer(const struct ways *ways, double u, double v)
{
    return u * ways->along_u + v * ways->along_v > ways->enough;
}

/* None of them is. */
static bool is_nearest(struct ways *ways, struct vec3 out)
{
    if (ways->last > 0 && is_nearer(ways, ways->last, out))
        return false;
    for (size_t i = 1; i < ways->n; i++)
        if (is_nearer(ways, i, out)) {
            keep_last(ways, i);
            return false;
        }
    return true;
}

/* Of a p that is nearer to `from` than to the other points: true if all points about bear the
 * surface out, and p is inside of those that do.  *off: of the points about from the surface, the
 * nearer the more. */
static bool is_between(const struct upsample *fill, const struct upsample_hood *near,
                       const struct local_surface *on, struct vec3 from, struct vec3 p, double *off)
{
    size_t k = near->n < NEAR ? near->n : NEAR;
    struct vec3 out = vec_sub(p, from);
    double out2 = vec_dot(out, out), weights = 0;
    double beside2 = near->distance2[k < FEWEST ? k - 1 : FEWEST - 1];
    struct fan fan = {.n = 0};

    *off = 0;
    beside2 = fmax(SURROUND * SURROUND * out2, beside2);
    for (size_t i = 0; i < k; i++) {
        struct vec3 beside = vec_sub(near->point[i], p);
        double far2 = vec_dot(beside, beside);
        bool about = far2 <= ABOUT * ABOUT * out2, around = far2 <= beside2 && !fan.around;
        if (!about && !around)
            continue;
        double least = allowed(fill, fmin(far2, ABOUT * out2), on->rough);
        bool borne = fabs(on->off[i] - on->off[0]) <= least;
        if (about && !borne)
            return false;
        if (borne && around)
            fan_add(&fan, vec_dot(beside, on->surface->q.u), vec_dot(beside, on->surface->q.v));
        if (about) {
            double weight = 1 / sqrt(far2) - 1 / (ABOUT * sqrt(out2));
            *off += weight * weight * on->off[i];
            weights += weight * weight;
        }
    }
    *off = on->exact && weights > 0 ? *off / weights : 0;
    return fan.around;
}

/* How deep the ball would sink between the points. */
static double sink_between(const struct upsample *fill, const struct upsample_hood *near)
{
    size_t sixth = near->n > 6 ? 6 : near->n - 1;

    return near->distance2[sixth] / (6 * fill->radius);
}

/* That is deep enough to be looked at. */
static bool may_sink(const struct upsample *fill, const struct upsample_hood *near)
{
    return near->n > 0 && sink_between(fill, near) > fill->sink / 4;
}

/* And deeper than they are off the surface. */
static bool would_sink(const struct upsample *fill, const struct upsample_hood *near, double spread)
{
    double sink = sink_between(fill, near);

    return may_sink(fill, near) && spread <= fmax(fmax(fill->sink, sink / 2), MUCH * fill->noise);
}

/* The ball does not fit in, so that it can't sink in either, and what is there only looks like a
 * surface, as in a corner. */
static bool is_hollow(const struct upsample *fill, const struct quadric *q)
{
    struct quadric up = *q;

    quadric_face_up(&up);
    return quadric_curvature(&up) >= 1 / fill->radius;
}

/* Surfaces of neighbours: a point on scan lines that are far apart against the points on them has
 * few lines about it, and a surface goes through these whatever is between. */
struct witnesses {
    bool asked;
    bool known[NEAR];
    struct upsample_surface of[NEAR];
};

/* Points of a smooth surface are no further off it, on average. */
static double even_of(const struct upsample *fill)
{
    return fmax(fill->sink, MUCH * fill->noise);
}

/* About point i. */
static void find_surface(const struct upsample *fill, size_t i, struct upsample_surface *surface)
{
    struct upsample_hood near;

    upsample_hood_find(fill, i, NEAR, &near);
    upsample_surface_about(fill, &near, surface);
    if (surface->spread < HUGE_VAL)
        upsample_facets_find(fill, i, even_of(fill), surface);
}

/* The surfaces of the MOST neighbours nearest to p across from point i go through p too. */
static bool is_witnessed(const struct upsample *fill, const struct upsample_hood *near,
                         const struct local_surface *on, struct vec3 from, struct vec3 p,
                         struct witnesses *witness)
{
    enum { MOST = 3 };
    const double across = 0.5;
    struct vec3 out = vec_unit(vec_sub(p, from));
    double least = (on->rough ? ACROSS : 1) * VAGUE * fill->sink, before = 0;

    for (int w = 0; w < MOST; w++) {
        double nearest = HUGE_VAL;
        size_t k = near->n;
        for (size_t i = 1; i < near->n && i < NEAR; i++) {
            struct vec3 to = vec_sub(near->point[i], from);
            double far = vec_distance(near->point[i], p);
            if (far > before && far < nearest && vec_dot(to, out) > across * vec_length(to)) {
                nearest = far;
                k = i;
            }
        }
        if (k == near->n)
            return w > 0;
        if (!witness->known[k])
            find_surface(fill, near->index[k], &witness->of[k]);
        witness->known[k] = true;
        if (!(witness->of[k].spread < HUGE_VAL) ||
            fabs(upsample_surface_off(&witness->of[k], p)) > least)
            return false;
        before = nearest;
    }
    return true;
}

/* No point of the scan is over or under a half plane beyond p seen from above, so far: the scan
 * ends there, whatever is below. */
static bool is_at_border(const struct point_grid *b, struct vec3 p, double reach)
{
    struct fan fan = {.n = 0};
    size_t left = point_grid_column(b, p.x - reach), right = point_grid_column(b, p.x + reach);
    size_t low = point_grid_row(b, p.y - reach), high = point_grid_row(b, p.y + reach);
    bool known[SECTORS] = {false};

    for (size_t row = low; row <= high; row++) {
        size_t from = b->first[row * b->columns + left];
        size_t end = b->first[row * b->columns + right + 1];
        for (size_t i = from; i < end; i++) {
            double x = b->point[i].x - p.x, y = b->point[i].y - p.y;
            if (x * x + y * y > reach * reach)
                continue;
            size_t sector = (size_t)((atan2(y, x) + PI) / (2 * PI) * SECTORS) % SECTORS;
            if (!known[sector])
                fan_add(&fan, x, y);
            known[sector] = true;
        }
    }
    return !fan.around;
}

/* The points nearest to p surround it on a surface, or, where it may be beyond, the scan ends
 * there. */
static bool is_open(const struct upsample *fill, const struct upsample_hood *near,
                    const struct quadric *q, struct vec3 p, bool beyond)
{
    double far2 = near->distance2[near->n - 1];
    struct fan fan = {.n = 0};

    for (size_t k = 0; k < near->n; k++) {
        struct vec3 beside = vec_sub(near->point[k], p);
        fan_add(&fan, vec_dot(beside, q->u), vec_dot(beside, q->v));
    }
    return fan.around || (beyond && near->distance2[0] <= BEYOND * BEYOND * far2 &&
                          is_at_border(fill->point_grid, p, fmax(fill->radius, sqrt(far2))));
}

/* A place that the surface about none of the points beside reaches, in a hole or beyond the border
 * of a scan: true where the surface about the place itself is smooth, and certain enough there.
 * *p: moved to it. */
static bool is_bridged(const struct upsample *fill, const struct local_surface *on, struct vec3 *p)
{
    struct upsample_hood near;
    struct quadric q;
    double much = even_of(fill);

    near.n = point_grid_nearest(fill->point_grid, *p, NEAR, near.index, near.distance2);
    for (size_t j = 0; j < near.n; j++)
        near.point[j] = fill->point_grid->point[near.index[j]];
    if (near.n < NEAR || near.distance2[0] > HOLE * HOLE * near.distance2[near.n - 1])
        return false;
    double spread =
        upsample_surface_fit(&near, NEAR, *p, quadric_normal_at(&on->surface->q, *p), &q);
    if (spread * fmax(1, sqrt(q.variance)) > much || is_hollow(fill, &q) ||
        !is_open(fill, &near, &q, *p, on->beyond))
        return false;
    if (!on->exact) /* it goes through more points */
        return fabs(quadric_distance(&q)) <= much;
    *p = quadric_at(&q, 0, 0);
    return true;
}

/* Most surfaces have no place between points that they are asked for. */
static void measure_off(const struct upsample_hood *near, struct local_surface *on)
{
    for (size_t k = 0; !on->known && k < near->n && k < NEAR; k++)
        on->off[k] = upsample_surface_off(on->surface, near->point[k]);
    on->known = true;
}

/* Seen from above the surface bends down at a place of it, or one way far more than up another. */
static bool is_convex_at(const struct quadric *q, struct vec3 p)
{
    const double much = 0.1, *c = q->c;
    struct vec3 at = quadric_local(q, p);
    double up = q->w.z < 0 ? -1 : 1;
    double uu = up * (2 * c[3] + 6 * c[6] * at.x + 2 * c[7] * at.y);
    double vv = up * (2 * c[5] + 2 * c[8] * at.x + 6 * c[9] * at.y);
    double uv = c[4] + 2 * c[7] * at.x + 2 * c[8] * at.y, sum = uu + vv;

    return sum < 0 && uu * vv - uv * uv > -much * sum * sum;
}

/* All points about the place bear it out, and the surfaces across where they are asked. */
static bool is_borne_out(const struct upsample *fill, const struct upsample_hood *near,
                         const struct local_surface *on, struct vec3 from, struct vec3 p,
                         struct witnesses *witness, double *off)
{
    return is_between(fill, near, on, from, p, off) &&
           (!witness->asked || is_witnessed(fill, near, on, from, p, witness));
}

/* Where the surface is at the place `at` beside `from`, if it is known there. */
static bool is_known_at(const struct upsample *fill, const struct upsample_hood *near,
                        struct local_surface *on, struct vec3 from, struct witnesses *witness,
                        struct vec3 *at)
{
    double off;

    on->rough = false;
    if (!is_borne_out(fill, near, on, from, *at, witness, &off)) {
        if (on->smooth && is_bridged(fill, on, at))
            return true;
        /* through the few lines about goes a surface that bends in any way */
        on->doubted = on->doubted || fill->lines;
        if (!on->surface->facetted && !is_convex_at(&on->surface->q, *at))
            return false;
        on->rough = on->doubted = true;
        if (!is_borne_out(fill, near, on, from, *at, witness, &off))
            return false;
    }
    *at = vec_along(*at, off, on->surface->q.w);
    return true;
}

/* Moves a place to within `least` of the plane through the points nearest to it. */
static struct vec3 moved_near(const struct upsample_hood *near, struct vec3 p, double least)
{
    enum { FLAT = 5 };
    size_t k = near->n < NEAR ? near->n : NEAR, n = 0;
    struct vec3 nearest[FLAT + 1], mean = {0, 0, 0};

    for (size_t i = 0; i < k; i++) {
        size_t at = n;
        for (; at > 0 && vec_distance(near->point[i], p) < vec_distance(nearest[at - 1], p); at--)
            nearest[at] = nearest[at - 1];
        nearest[at] = near->point[i];
        n = n < FLAT ? n + 1 : FLAT;
    }
    for (size_t i = 0; i < n; i++)
        mean = vec_along(mean, 1 / (double)n, nearest[i]);
    struct vec3 normal = plane_normal(nearest, n);
    double off = vec_dot(vec_sub(p, mean), normal);
    return vec_along(p, fmax(-least, fmin(off, least)) - off, normal);
}

/* A surface of few points on one side of an edge, beside which the others do not count, swings as
 * it likes between them: where it is not certain to a part of the noise, a place of it is moved as
 * near to the points about as noise may have thrown these. */
static struct vec3 place_of(const struct upsample *fill, const struct upsample_hood *near,
                            const struct upsample_surface *surface, struct vec3 p)
{
    const double part = 0.7;
    struct vec3 d = vec_sub(p, surface->q.origin);
    double variance = surface->q.variance + surface->q.tilt * vec_dot(d, d);

    return surface->facetted || variance <= part * part ? p
                                                        : moved_near(near, p, SIGMAS * fill->noise);
}

/* False: at a place the surface is doubtful, as by an edge. */
static bool add_between(const struct upsample *fill, const struct upsample_hood *near,
                        struct vec3 p, const struct upsample_surface *surface, bool exact,
                        struct vec3s *to)
{
    const struct quadric *q = &surface->q;
    /* on scan lines a surface goes through few of them that has nothing to do with the part */
    bool smooth = !fill->lines && surface->spread <= even_of(fill);
    struct local_surface on = {.surface = surface, .exact = exact};
    struct witnesses witness;
    size_t last = near->n < FEWEST ? near->n : FEWEST;
    double pitch = 0.75 * gap_of(fill);
    double reach = fmin(sqrt(near->distance2[last - 1]), most_rings(fill) * pitch);
    struct vec3 off = vec_sub(p, q->origin);
    double u0 = vec_dot(off, q->u), v0 = vec_dot(off, q->v);
    int rings = (int)triangles_rings(reach, pitch);
    double beyond = fmin(OF_ALL * point_grid_spacing(fill->point_grid), reach);
    double wide = fmin(fmax(beyond, fill->radius), reach);
    int border = (int)fmax(BRIDGED, beyond / pitch), hole = (int)fmax(BRIDGED, wide / pitch);
    struct ways ways;

    if (is_hollow(fill, q))
        return true;
    set_ways(near, p, surface, reach, &ways);
    witness.asked = exact && fill->lines;
    memset(witness.known, 0, sizeof witness.known);
    for (int j = -rings; j <= rings; j++) {
        for (int i = -rings; i <= rings; i++) {
            double u, v;
            triangles_at(pitch, i, j, &u, &v);
            if ((i == 0 && j == 0) || is_last_nearer(&ways, u, v) || hypot_compare(u, v, reach) > 0)
                continue;
            struct vec3 at = upsample_surface_at(surface, u0 + u, v0 + v);
            if (!is_nearest(&ways, vec_sub(at, p)))
                continue;
            measure_off(near, &on);
            on.smooth = smooth && abs(i) <= hole && abs(j) <= hole;
            on.beyond = abs(i) <= border && abs(j) <= border;
            if (is_known_at(fill, near, &on, p, &witness, &at))
                *array_push(to) = exact ? at : place_of(fill, near, surface, at);
        }
    }
    return !on.doubted;
}

void upsample_on(const struct upsample *fill, size_t i, struct vec3 p,
                 const struct upsample_surface *surface, struct vec3s *to)
{
    struct upsample_hood near;

    upsample_hood_find(fill, i, NEAR, &near);
    if (would_sink(fill, &near, surface->spread))
        add_between(fill, &near, p, surface, false, to);
}

double upsample_about(const struct upsample *fill, size_t i, struct vec3s *to)
{
    struct upsample_surface surface;
    struct upsample_hood near;

    upsample_hood_find(fill, i, NEAR, &near);
    if (!may_sink(fill, &near))
        return 0;
    upsample_surface_about(fill, &near, &surface);
    if (surface.spread == HUGE_VAL)
        return 0;
    if (!would_sink(fill, &near, surface.spread))
        return surface.spread;
    size_t before = to->n;
    if (!add_between(fill, &near, near.point[0], &surface, true, to) &&
        upsample_facets_find(fill, i, even_of(fill), &surface)) {
        to->n = before;
        add_between(fill, &near, near.point[0], &surface, true, to);
    }
    return surface.spread;
}

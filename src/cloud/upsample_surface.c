/* upsample_surface - see upsample_surface.h. */
#include "cloud/upsample_surface.h"

#include "math/cubic.h"

enum { QUADRIC = 6, CUBIC = 10 };

/* Terms of a facet, whose points are chosen, too; and so much less facets cost than one surface
 * where it is not by chance, in squares of the noise. */
enum { OF_FACET = 4, CHANCE = 6 };

/* Of how far the points of a neighbourhood are: so far they are apart where each is of a line. */
static const double ACROSS = 5;

/* Facets leave no more of what a surface does: of noise that of 24 points, with fourteen degrees of
 * freedom, is off by 1.4 times in one case of twenty. */
static const double ALIKE = 1.3;

void upsample_hood_find(const struct upsample *fill, size_t i, size_t k, struct upsample_hood *near)
{
    const struct point_grid *b = fill->point_grid;

    near->n = near_lists_nearest(fill->near, b, i, k, near->index, near->distance2);
    for (size_t j = 0; j < near->n; j++)
        near->point[j] = b->point[near->index[j]];
    near->point[0] = b->point[i];
}

/* The quadric through the fewest points that carry one: on laser lines it takes more.  HUGE_VAL:
 * there is none. */
static double fit_quadric(const struct upsample_hood *near, struct quadric *q)
{
    for (size_t k = UPSAMPLE_FEWEST; k <= near->n && k <= UPSAMPLE_NEAR; k += UPSAMPLE_FEWEST / 2)
        if (quadric_settle(near->point, k, near->point[0], plane_normal(near->point, k), q) == 0)
            return quadric_spread(q, near->point, k, QUADRIC);
    return HUGE_VAL;
}

/* The cubic through the first k points in place of a quadric of this spread, where it leaves less.
 * Returns the spread. */
static double fit_closer(const struct upsample_hood *near, size_t k, double spread,
                         struct quadric *q)
{
    struct quadric cubic;

    if (cubic_fit(near->point, NULL, k, q->origin, quadric_normal(q), &cubic) < 0)
        return spread;
    double less = quadric_spread(&cubic, near->point, k, CUBIC);
    if (!(less < spread))
        return spread;
    *q = cubic;
    return less;
}

void upsample_surface_find(const struct upsample_hood *near, struct upsample_surface *surface)
{
    double spread = fit_quadric(near, &surface->q);

    surface->facetted = false;
    surface->spread = spread < HUGE_VAL && near->n >= UPSAMPLE_FEW
                          ? fit_closer(near, UPSAMPLE_FEW, spread, &surface->q)
                          : spread;
}

/* Of the n nearest points those that are so far apart, the nearest first: on as many lines as along
 * one of them. */
static void pick_apart(const struct point_grid *b, const uint32_t *index, const double *distance2,
                       size_t n, struct upsample_hood *hood)
{
    const double apart = sqrt(distance2[n - 1]) / ACROSS;

    hood->n = 0;
    for (size_t k = 0; k < n && hood->n < UPSAMPLE_NEAR; k++) {
        struct vec3 p = b->point[index[k]];
        size_t j = 0;
        while (j < hood->n && vec_distance(hood->point[j], p) > apart)
            j++;
        if (j < hood->n)
            continue;
        hood->index[hood->n] = index[k];
        hood->distance2[hood->n] = distance2[k];
        hood->point[hood->n++] = p;
    }
}

void upsample_surface_about(const struct upsample *fill, const struct upsample_hood *near,
                            struct upsample_surface *surface)
{
    uint32_t index[UPSAMPLE_LINES];
    double distance2[UPSAMPLE_LINES];
    struct upsample_hood wide;

    upsample_surface_find(near, surface);
    if (!fill->lines)
        return;
    for (size_t k = 2 * UPSAMPLE_NEAR; surface->spread == HUGE_VAL && k <= UPSAMPLE_LINES; k *= 2) {
        size_t n = point_grid_nearest(fill->point_grid, near->point[0], k, index, distance2);
        if (n < k)
            return;
        pick_apart(fill->point_grid, index, distance2, n, &wide);
        upsample_surface_find(&wide, surface);
    }
}

double upsample_surface_fit(const struct upsample_hood *near, size_t k, struct vec3 origin,
                            struct vec3 guess, struct quadric *q)
{
    if (quadric_settle(near->point, k, origin, guess, q) < 0)
        return HUGE_VAL;
    return fit_closer(near, k, quadric_spread(q, near->point, k, QUADRIC), q);
}

/* 1, or -1 where the quadric faces down. */
static double upwards(const struct quadric *q)
{
    return q->w.z < 0 ? -1 : 1;
}

/* The points bend down as a whole, and facets, which are farther off the more they bend, may be as
 * near to them as a surface of this spread is. */
static bool may_be_facets(const struct vec3 *local, size_t n, double reach2, double spread)
{
    const double part = 0.009;
    struct quadric q, frame = quadric_frame(vec(0, 0, 0), vec(0, 0, 1));

    if (quadric_fit_local(local, n, &frame, &q) < 0)
        return false;
    double sum = q.c[3] + q.c[5];
    return sum < 0 && spread > part * (hypot(q.c[3] - q.c[5], q.c[4]) - sum) * reach2;
}

bool upsample_facets_find(const struct upsample *fill, size_t i, double even,
                          struct upsample_surface *surface)
{
    const double nearly = 3; /* of the spread: fewer facets, of fewer points, may do */
    const struct point_grid *b = fill->point_grid;
    uint32_t index[LEAST_PLANES_POINTS];
    double distance2[LEAST_PLANES_POINTS];
    struct vec3 local[LEAST_PLANES_POINTS];

    if (!(surface->spread > even))
        return false;
    size_t n = point_grid_nearest(b, b->point[i], LEAST_PLANES_POINTS, index, distance2);
    for (size_t k = 0; k < n; k++) {
        local[k] = quadric_local(&surface->q, b->point[index[k]]);
        local[k].z *= upwards(&surface->q);
    }
    if (n < LEAST_PLANES_POINTS || !may_be_facets(local, n, distance2[n - 1], surface->spread))
        return false;
    do {
        if (least_planes_fit(local, n, even, &surface->facets) != 0)
            return false;
        surface->facetted = surface->facets.rms < ALIKE * surface->spread;
        n -= n / 4;
    } while (n > UPSAMPLE_NEAR && !surface->facetted &&
             surface->facets.rms < nearly * surface->spread);
    return surface->facetted;
}

/* What surfaces of so many terms leave of n points, in squares of the noise, and twice the terms,
 * for more of these leave less by chance (Akaike 1974). */
static double cost_of(double rms, double sigma, size_t n, int terms)
{
    return rms * rms * (double)n / (sigma * sigma) + 2 * terms;
}

/* Of the better one of a quadric and a cubic, which is asked where the quadric costs more than
 * noise alone; no facets are looked for where it does not, or the quadric is hollow: 0. */
static double cost_of_one(const struct vec3 *local, size_t n, double sigma)
{
    const struct vec3 zero = {0, 0, 0}, up = {0, 0, 1};
    struct quadric q, frame = quadric_frame(zero, up);

    if (quadric_fit_local(local, n, &frame, &q) < 0)
        return 0;
    double cost = cost_of(quadric_rms_local(&q, local, n), sigma, n, QUADRIC), noise = (double)n;
    if (cost <= noise + CHANCE || q.c[3] + q.c[5] >= 0)
        return 0;
    if (cubic_fit(local, NULL, n, zero, up, &q) == 0)
        cost = fmin(cost, cost_of(quadric_rms_local(&q, local, n), sigma, n, CUBIC));
    return cost > noise + CHANCE ? cost : 0;
}

/* Facets through n points that cost less; false: there are none. */
static bool fit_cheaper(const struct vec3 *local, size_t n, double sigma,
                        struct least_planes *facets)
{
    double one = cost_of_one(local, n, sigma), even = sigma * (1 + 0.5 / sqrt((double)n));

    if (!(one > 0) || least_planes_fit(local, n, even, facets) != 0)
        return false;
    double free = 1 - 3.0 * facets->n / (double)n; /* of rms, which is for their freedom */
    return cost_of(facets->rms * sqrt(free), sigma, n, OF_FACET * facets->n) + CHANCE < one;
}

bool upsample_facets_explain(const struct upsample *fill, struct vec3 p,
                             struct upsample_surface *surface, double *reach)
{
    const double most = 1.75, even = 1.2; /* of the noise: what facets leave, and where these do */
    const struct point_grid *b = fill->point_grid;
    uint32_t index[LEAST_PLANES_POINTS];
    double distance2[LEAST_PLANES_POINTS], least = most * fill->noise;
    struct vec3 local[LEAST_PLANES_POINTS];
    size_t n = point_grid_nearest(b, p, LEAST_PLANES_POINTS, index, distance2);

    for (size_t k = 0; k < n; k++) {
        local[k] = quadric_local(&surface->q, b->point[index[k]]);
        local[k].z *= upwards(&surface->q);
    }
    for (; n > UPSAMPLE_NEAR && least > even * fill->noise; n -= n / 4) {
        struct least_planes facets;
        if (!fit_cheaper(local, n, fill->noise, &facets) || facets.rms >= least)
            continue;
        surface->facets = facets;
        surface->facetted = true;
        surface->spread = least = facets.rms;
        *reach = sqrt(distance2[n - 1]);
    }
    return surface->facetted;
}

double upsample_surface_off(const struct upsample_surface *surface, struct vec3 p)
{
    if (!surface->facetted)
        return quadric_off(&surface->q, p);
    struct vec3 at = quadric_local(&surface->q, p);
    return at.z - upwards(&surface->q) * least_planes_at(&surface->facets, at.x, at.y);
}

struct vec3 upsample_surface_at(const struct upsample_surface *surface, double u, double v)
{
    struct vec3 at = quadric_at(&surface->q, u, v);

    return surface->facetted ? vec_along(at, -upsample_surface_off(surface, at), surface->q.w) : at;
}

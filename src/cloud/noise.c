/* noise - see noise.h. */
#include "cloud/noise.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/quadric.h"
#include "sided_noise.h"

enum { FEWEST = 16, MOST = 512, TERMS = 6 };
enum { SOME = 250 }; /* places, and up to twice as many */

/* Variance of the bend over twice the points. */
static const double GROWTH = 8;

static const double SIGMA_OF_MEDIAN = 1.4826; /* the median of the sizes, normally distributed */

static const double WHITE = 1.35; /* spread of twice the points by that of once, at most */
static const double EVEN = 3;     /* spread of the roughest tenth by that of the smoothest */

/* The tenth of the variances is 0.49 of the true one where all are noise, 0.72 where a third is.
 * One of a hundred is above 2.4 times the true one; another group begins at 4 times (twice as far
 * off), with few between.  A quarter of noise is above 1.25 of the true one, and one below 0.67:
 * 1.86 times, and more by chance. */
static const double TENTH = 0.6, GROUP = 2.4, APART = 4, BETWEEN = 0.1, LEAST = 0.12, OTHERS = 0.1,
                    QUARTERS = 2.2;
enum { ROUNDS = 8 };

/* Of noise alone a quarter of the variances is below 0.72 of the true one (which is taken as the
 * median), a twentieth below 0.42, and where noise is half of all, below 0.93 and 0.52: 1.92 times
 * at most; two fifths are below 2.76 times at most; over twice the points a quarter is 1.14 times
 * as large.  And by chance a fifth more.  The quarter is 0.82 of the true one where noise is three
 * quarters of all, and a tenth more or less otherwise. */
static const double PART_QUARTER = 2.3, PART_MORE = 3.3, PART_TWICE = 1.4, PART_THIRD = 0.82;

static const double CELL = 3; /* width of a cell in mean spacings of the points */

/* Noise of a point tells nothing of its neighbour's.  What a fit leaves of it does, and against it:
 * the covariance of two residuals is the one beside the diagonal of the projection off the fit,
 * below zero for neighbours (Belsley, Kuh and Welsch, Regression Diagnostics, 1980, 2.1).  As the
 * product of what two neighbours are off by the square of what one is: of noise -0.3 to -0.5 as
 * measured, of steps that points are too far apart for -0.19 to 0.15. */
static const double NOISE_ALONE = -0.2;

/* Noise and facets as small as a few points have -0.15 to -0.28, noise alone -0.28 to -0.5. */
static const double NOISE_MIXED = -0.28;

struct measurement {
    const struct point_grid *point_grid;
    const uint32_t *place;
    double *fewer, *twice; /* variance at each place; negative: none */
    double *shared;        /* how far neighbours share what they are off by; HUGE_VAL: unknown */
};

/* What the points leave of their freedom, made comparable: the median of a chi squared
 * distribution is not its mean (Wilson and Hilferty 1931). */
static double variance_of(const struct quadric *q, const struct vec3 *near, size_t n)
{
    double rms = quadric_rms(q, near, n), freedom = (double)(n - TERMS);
    double median = 1 - 2 / (9 * freedom);
    return rms * rms * (double)n / (freedom * median * median * median);
}

struct neighbourhood {
    uint32_t index[2 * MOST];
    double distance2[2 * MOST];
    struct vec3 point[2 * MOST];
};

static size_t find_neighbours(const struct point_grid *b, struct vec3 from, size_t k,
                              struct neighbourhood *near)
{
    size_t n = point_grid_nearest(b, from, k, near->index, near->distance2);
    for (size_t i = 0; i < n; i++)
        near->point[i] = b->point[near->index[i]];
    return n;
}

/* Of the nearest points what each is off the surface, times what its neighbour is, as a share of
 * the square.  The neighbour is the nearest along the surface: of points as far along it the
 * nearest in space would be the one that is off alike. */
static double shared_off(const struct quadric *q, const struct vec3 *near)
{
    double off[FEWEST], product = 0, square = 0;
    struct vec3 at[FEWEST];

    for (size_t i = 0; i < FEWEST; i++) {
        off[i] = quadric_off(q, near[i]);
        at[i] = quadric_local(q, near[i]);
        at[i].z = 0;
    }
    for (size_t i = 0; i < FEWEST; i++) {
        size_t next = i == 0 ? 1 : 0;
        for (size_t j = 0; j < FEWEST; j++)
            if (j != i && vec_distance(at[i], at[j]) < vec_distance(at[i], at[next]))
                next = j;
        product += off[i] * off[next];
        square += off[i] * off[i];
    }
    return square > 0 ? product / square : HUGE_VAL;
}

/* The fewest points about a place that carry a quadric, and twice as many.  They are gathered once
 * more about its foot: those nearest to a point that is off the surface are off to the same side.
 */
static void measure_at(const struct measurement *m, size_t i, struct neighbourhood *near)
{
    const struct point_grid *b = m->point_grid;
    struct vec3 place = b->point[m->place[i]];

    for (size_t k = FEWEST; k <= MOST; k *= 2) {
        struct quadric q;
        if (find_neighbours(b, place, 2 * k, near) < 2 * k)
            return;
        if (quadric_fit_free(near->point, k, near->point[0], &q) < 0)
            continue;
        find_neighbours(b, quadric_foot(&q), 2 * k, near);
        struct vec3 normal = quadric_normal(&q), origin = near->point[0];
        if (quadric_settle(near->point, k, origin, normal, &q) < 0)
            continue;
        m->fewer[i] = variance_of(&q, near->point, k);
        m->shared[i] = shared_off(&q, near->point);
        if (quadric_settle(near->point, 2 * k, origin, normal, &q) == 0)
            m->twice[i] = variance_of(&q, near->point, 2 * k);
        return;
    }
}

static void measure_places(void *context, size_t from, size_t to)
{
    const struct measurement *m = context;
    struct neighbourhood near;
    for (size_t i = from; i < to; i++) {
        m->fewer[i] = m->twice[i] = -1;
        m->shared[i] = HUGE_VAL;
        measure_at(m, i, &near);
    }
}

/* Brings those that are there to the front, in order; returns how many. */
static size_t sort_measured(double *value, size_t n)
{
    size_t found = 0;
    for (size_t i = 0; i < n; i++)
        if (value[i] >= 0)
            value[found++] = value[i];
    doubles_sort(value, found);
    return found;
}

/* Those of `value`, in order, that are below `most`. */
static size_t count_below(const double *value, size_t n, double most)
{
    size_t below = 0;

    while (below < n && value[below] < most)
        below++;
    return below;
}

/* Of variances in order, in two groups: that of the lower ones, which are as noise alone lets them
 * be (a chi squared distribution); else 0. */
static double lower_group(const double *variance, size_t n)
{
    double of = variance[n / 10] / TENTH;
    size_t low = 0;

    for (int round = 0; round < ROUNDS; round++) {
        low = count_below(variance, n, GROUP * of);
        of = variance[low / 2];
    }
    size_t high = n - count_below(variance, n, APART * of);
    bool parted = (double)(n - low - high) <= BETWEEN * (double)low;
    bool even = variance[3 * low / 4] <= QUARTERS * variance[low / 4];

    return (double)low >= LEAST * (double)n && (double)high >= OTHERS * (double)n && parted && even
               ? of
               : 0;
}

/* Of variances in order, of places and over twice their points: the noise of the lower ones, where
 * two fifths and more of them are as noise alone lets them be, whatever the others are; else 0. */
static double lower_part(const double *variance, size_t n, const double *twice, size_t m)
{
    double least = variance[n / 20], quarter = variance[n / 4], more = variance[2 * n / 5];
    bool even = quarter <= PART_QUARTER * least && more <= PART_MORE * least;

    return even && twice[m / 4] <= PART_TWICE * quarter ? quarter / PART_THIRD : 0;
}

/* Some places, all over the scan, before the others; returns how many, 0 where they are few. */
static size_t some_first(const uint32_t *place, size_t n, uint32_t *order)
{
    size_t step = n / SOME, at = 0;

    if (step < 2)
        step = n; /* all are others */
    for (size_t i = 0; i < n && step < n; i += step)
        order[at++] = place[i];
    size_t some = at;
    for (size_t i = 0; i < n; i++)
        if (step == n || i % step != 0)
            order[at++] = place[i];
    return some;
}

/* Whether what was measured at the first places tells that no noise is to be found. */
static bool none_at_some(const struct measurement *m, size_t some)
{
    double fewer[2 * SOME], twice[2 * SOME];

    memcpy(fewer, m->fewer, some * sizeof *fewer);
    memcpy(twice, m->twice, some * sizeof *twice);
    size_t n = sort_measured(fewer, some), k = sort_measured(twice, some);
    return sided_noise_surely_none(fewer, n, twice, k);
}

/* The same by the better side of each place, where edges are at most of them: eighteen fits each,
 * and so at all places only where some do not tell that there is nothing to find.  Takes other
 * values in the place of what was measured. */
static double by_sides(const struct measurement *m, size_t places, int threads)
{
    uint32_t *order = mem_alloc(places, sizeof *order);
    size_t some = some_first(m->place, places, order), fewer = 0, twice = 0;

    sided_noise_measure(m->point_grid, order, some, threads, m->fewer, m->twice);
    if (!none_at_some(m, some)) {
        sided_noise_measure(m->point_grid, order + some, places - some, threads, m->fewer + some,
                            m->twice + some);
        fewer = sort_measured(m->fewer, places);
        twice = sort_measured(m->twice, places);
    }
    free(order);
    return 2 * fewer > places && 2 * twice > places
               ? sided_noise_variance(m->fewer, fewer, m->twice, twice)
               : 0;
}

size_t noise_place(size_t i, size_t n)
{
    size_t places = n < NOISE_PLACES ? n : NOISE_PLACES;

    return (size_t)(((double)i + 0.5) / (double)places * (double)n);
}

struct noise noise_measure(const struct point_grid *point_grid, int threads)
{
    size_t places = point_grid->n < NOISE_PLACES ? point_grid->n : NOISE_PLACES;
    uint32_t place[NOISE_PLACES];

    for (size_t i = 0; i < places; i++)
        place[i] = (uint32_t)noise_place(i, point_grid->n);
    return noise_measure_at(point_grid, place, places, threads);
}

struct noise noise_measure_at(const struct point_grid *point_grid, const uint32_t *place,
                              size_t places, int threads)
{
    struct measurement m = {point_grid, place, mem_alloc(places, sizeof(double)),
                            mem_alloc(places, sizeof(double)), mem_alloc(places, sizeof(double))};
    struct noise noise = {.sigma = 0};
    parallel_for(threads, places, measure_places, &m);
    size_t fewer = sort_measured(m.fewer, places), twice = sort_measured(m.twice, places);
    if (fewer > 0 && twice > 0) {
        double narrow = m.fewer[fewer / 2], wide = m.twice[twice / 2];
        noise.sigma = sqrt(fmax((GROWTH * narrow - wide) / (GROWTH - 1), 0));
        double shared = doubles_select(m.shared, places, places / 2);
        noise.alike = noise.sigma < point_grid->cell / CELL && wide <= WHITE * WHITE * narrow &&
                      m.fewer[9 * fewer / 10] <= EVEN * EVEN * m.fewer[fewer / 10] &&
                      shared <= NOISE_ALONE;
        noise.mixed = noise.alike && shared > NOISE_MIXED;
        double lower = lower_group(m.fewer, fewer);
        if (!(lower > 0) && shared <= NOISE_ALONE)
            lower = lower_part(m.fewer, fewer, m.twice, twice);
        if (!(lower > 0) && !noise.alike && sqrt(narrow) > NOISE_NONE * point_grid->cell) {
            lower = by_sides(&m, places, threads);
            noise.sided = sqrt(lower) > NOISE_NONE * point_grid->cell;
        }
        noise.even = noise.alike ? 0 : sqrt(lower);
        if (noise.even < NOISE_NONE * point_grid->cell)
            noise.even = 0;
    }
    free(m.fewer);
    free(m.twice);
    free(m.shared);
    return noise;
}

double noise_sigma(const struct point_grid *point_grid, int threads)
{
    return noise_measure(point_grid, threads).sigma;
}

double noise_of_distances(double *distance, size_t n)
{
    if (n == 0)
        return 0;
    return SIGMA_OF_MEDIAN * doubles_select(distance, n, n / 2);
}

/* rounding - see rounding.h. */
#include "rounding.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"

/* Points whose heights are compared first. */
enum { SOME = 4096 };

/* Steps by the spacing of the points: finer ones are no more than noise is, and a coarser one is
 * how they were sampled, or the part.  So much nearer two heights are one. */
static const double FINEST = 0.04, COARSEST = 0.3, ONE = 0.05;

/* In steps: heights are off whole ones by less. */
static const double OFF = 0.1;

/* The fewest heights, and of the steps over all of them so many: a few are levels of the part. */
enum { FEWEST = 12, PART = 3 };

/* Some of the heights, upwards, each once: how many. */
static size_t sort_heights(const struct vec3 *point, size_t n, double apart, double *height)
{
    size_t some = 0, kept = 0;

    for (size_t i = 0, by = n / SOME + 1; i < n; i += by)
        height[some++] = point[i].z;
    doubles_sort(height, some);
    for (size_t i = 0; i < some; i++)
        if (kept == 0 || height[i] - height[kept - 1] > apart)
            height[kept++] = height[i];
    return kept;
}

static double least_gap(const double *height, size_t n)
{
    double least = HUGE_VAL;

    for (size_t i = 1; i < n; i++)
        least = fmin(least, height[i] - height[i - 1]);
    return least;
}

static bool is_whole(double steps)
{
    return fabs(steps - round(steps)) <= OFF;
}

/* The step about so large that all gaps are whole numbers of; 0: there is none. */
static double common_step(const double *height, size_t n, double about)
{
    double steps = 0;

    for (size_t i = 1; i < n; i++)
        steps += round((height[i] - height[i - 1]) / about);
    double step = (height[n - 1] - height[0]) / steps;
    for (size_t i = 1; i < n; i++)
        if (!is_whole((height[i] - height[i - 1]) / step))
            return 0;
    return (double)n * PART >= steps ? step : 0;
}

double rounding_step(const struct vec3 *point, size_t n, double spacing)
{
    double height[SOME];
    size_t heights = sort_heights(point, n, ONE * FINEST * spacing, height);

    if (heights < FEWEST)
        return 0;
    double about = least_gap(height, heights);
    if (about < FINEST * spacing || about > COARSEST * spacing)
        return 0;
    double step = common_step(height, heights, about);
    for (size_t i = 0; step > 0 && i < n; i++)
        if (!is_whole((point[i].z - height[0]) / step))
            return 0;
    return step;
}

bool rounding_left(double step, double sigma)
{
    const double least = 0.12; /* steps; all of it is 0.29 */

    return sigma >= least * step;
}

/* 0 to 1, by the bits of a place (the finalizer of MurmurHash3, Appleby 2011). */
static double spread_of(struct vec3 p, double step)
{
    const double fine = 1e4; /* places by mm */
    uint64_t h = (uint64_t)llround(p.x * fine) * 0x9e3779b97f4a7c15U;

    h = (h ^ (uint64_t)llround(p.y * fine)) * 0xbf58476d1ce4e5b9U;
    h ^= (uint64_t)llround(p.z / step);
    h = (h ^ h >> 33) * 0xff51afd7ed558ccdU;
    h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53U;
    return (double)((h ^ h >> 33) >> 11) * 0x1p-53;
}

void rounding_spread(double step, const struct vec3 *point, size_t n, struct vec3 *spread)
{
    for (size_t i = 0; i < n; i++) {
        spread[i] = point[i];
        spread[i].z += step * (spread_of(point[i], step) - 0.5);
    }
}

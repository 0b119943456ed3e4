/*
 * sided_noise - how noisy a scan is of which most places are near edges: by one side of these.
 *
 * About a place a quadric is fitted to its nearest points all around, and to those on one side of
 * a line through it, eight ways; the one that leaves its points the least tells.  So blunt edges
 * that most neighbourhoods go over, as of facets, are not taken for noise.  What the best of nine
 * leaves where there is noise alone is known, from 75,000 places of planes.
 */
#ifndef CLOUDMILL_CLOUD_SIDED_NOISE_H
#define CLOUDMILL_CLOUD_SIDED_NOISE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "math/point_grid.h"

/* At the points of which the numbers are place[]: the least variance that is left of the fewest
 * points and of twice as many, mm^2; negative: none. */
void sided_noise_measure(const struct point_grid *point_grid, const uint32_t *place, size_t places,
                         int threads, double *fewer, double *twice);

/* Of such variances, in order: that of the noise.  0: what is left is not as noise alone lets it
 * be, or grows with the width as shape does. */
double sided_noise_variance(const double *fewer, size_t n, const double *twice, size_t m);

/* Of such variances of some hundreds of the places alone: true only where all would not be as noise
 * alone lets them be, either. */
bool sided_noise_surely_none(const double *fewer, size_t n, const double *twice, size_t m);

#endif

/*
 * noise - how noisy a scan is, from the scan alone.
 *
 * Noise is said in one standard deviation everywhere, in mm; who needs a bound multiplies it by a
 * constant that has a name.
 *
 * At up to NOISE_PLACES places over the cloud a quadric is fitted to the fewest nearest points that
 * carry one and to twice as many.  What the fits leave, for their degrees of freedom, is noise and
 * what of the surface is no quadric: the latter grows with the width as its third power or faster,
 * so that its variance is GROWTH times as large over twice the points, and the former does not
 * grow.
 * Medians over the places, so that edges, outliers and the few tight bends do not count.  Where
 * most places lie over edges, as of terraces, a median is of these: then the variances fall into
 * two groups with nothing between, and the lower one tells.  Where nearly all places lie over blunt
 * edges, as of facets, the quadrics of one side of each place may tell (sided_noise.h).
 */
#ifndef CLOUDMILL_NOISE_H
#define CLOUDMILL_NOISE_H

#include <stdbool.h>

#include "math/point_grid.h"

#define NOISE_NONE 0.0007 /* of a cell's width: a scan without noise */

struct noise {
    double sigma; /* standard deviation of the points from the surface, along its normal, mm; 0
                     where the surface explains all */
    bool alike;   /* the points are spread about the surface alike everywhere and however wide one
                     looks, less than they are apart, and each otherwise than its neighbour: by the
                     scanner, not by the shape of a rough part */
    bool mixed;   /* and each so little otherwise that a part of it may be shape */
    double even;  /* not alike: the standard deviation of those places that a quadric explains, mm,
                     where they are a fifth of all, alike among themselves, and the others, a tenth
                     or more, as over steps, far off; or where it explains one side of most
                     places; else 0 */
    bool sided;   /* the latter */
};

struct noise noise_measure(const struct point_grid *point_grid, int threads);

/* The same at the points of which the numbers are place[], of a grid that holds a scan about these
 * alone; and the number in its order of place i of those where noise_measure looks at n points. */
enum { NOISE_PLACES = 2000 };
size_t noise_place(size_t i, size_t n);
struct noise noise_measure_at(const struct point_grid *point_grid, const uint32_t *place,
                              size_t places, int threads);

/* Its sigma alone. */
double noise_sigma(const struct point_grid *point_grid, int threads);

/* Standard deviation of n normally distributed numbers about 0, of which `distance` are the sizes:
 * from their median, so that a few large ones do not count (Hampel 1974).  Changes their order.  0
 * of none.
 */
double noise_of_distances(double *distance, size_t n);

#endif

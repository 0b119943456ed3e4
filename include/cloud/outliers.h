/*
 * outliers - points of a scan that are not on its surface: points twice, outliers, points under a
 * roof.
 *
 * Each function marks points of `point_grid` in out[] (as many bytes as points) with 1, beside what
 * is marked already, and returns how many it marked; point_grid_remove takes them out.
 */
#ifndef CLOUDMILL_OUTLIERS_H
#define CLOUDMILL_OUTLIERS_H

#include "math/point_grid.h"

/* Points equal in x, y and z to one that is kept. */
size_t outliers_twice(const struct point_grid *point_grid, unsigned char *out);

/*
 * Outliers, `sigma` being the noise of the scan (mm, noise.h): points that
 *   - are isolated: the eighth nearest neighbour is more than three times as far as that of the
 *     points next to them (after the local outlier factor: Breunig, Kriegel, Ng, Sander 2000), but
 *     for a sparse surface beside a dense one, as a wall's: more than eight of the 24 are as far,
 *     or more than twelve mean spacings, where no facet would reach them, or
 *   - are off a quadric through their 24 nearest neighbours, fitted by Tukey's biweight, by more
 *     than six sigma, eight times what the neighbours are off, and a tenth of their spacing.
 * So a clump of up to eight points floating anywhere is found, an edge or a wall is none.  Asked of
 * those points only that are off a robust quadric over their cell and the eight around it, or have
 * no other point of their cell near them.
 */
size_t outliers_isolated(const struct point_grid *point_grid, double sigma, int threads,
                         unsigned char *out);

/* Points that a tool from above cannot reach: within the cells about them, in every eighth of the
 * turn, points stand above them more than four times as high as they are away. */
size_t outliers_under_roof(const struct point_grid *point_grid, int threads, unsigned char *out);

#endif

/*
 * near_lists - the nearest points of each point of a grid, found once for all who ask for them.
 *
 * A list takes NEAR_LIST * 4 bytes; of clouds above NEAR_LISTS_MOST points there are none, and
 * they are looked for each time.  The answers are those of point_grid_nearest, to the bit.
 */
#ifndef CLOUDMILL_NEAR_LISTS_H
#define CLOUDMILL_NEAR_LISTS_H

#include "math/point_grid.h"

enum { NEAR_LIST = 40, NEAR_LISTS_MOST = 1 << 17 };

struct near_lists {
    uint32_t *index; /* NEAR_LIST of each point, nearest first; NULL: there are none */
};

struct near_lists near_lists_of(const struct point_grid *point_grid, int threads);

void near_lists_free(struct near_lists *lists);

/* The k points nearest to point i, nearest first, as by point_grid_nearest of the same grid. */
size_t near_lists_nearest(const struct near_lists *lists, const struct point_grid *point_grid,
                          size_t i, size_t k, uint32_t *index, double *distance2);

#endif

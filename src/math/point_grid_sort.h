/*
 * point_grid_sort - the points of a grid that is laid out, sorted in place into its cells, row by
 * row, in each by x, y, z: a counting sort by parts of the grid, then by cells, then by value.
 * Sets `first`.  The order is the same for any number of threads and any order before.
 */
#ifndef CLOUDMILL_POINT_GRID_SORT_H
#define CLOUDMILL_POINT_GRID_SORT_H

#include "math/point_grid.h"

void point_grid_sort(struct point_grid *point_grid, int threads);

#endif

/*
 * cell_surface - how far a scan is from places, asked at very many of them: the surface about the
 * middle of each cell of its grid is fitted once.
 */
#ifndef CLOUDMILL_CELL_SURFACE_H
#define CLOUDMILL_CELL_SURFACE_H

#include <stdbool.h>

#include "math/point_grid.h"
#include "math/quadric.h"

struct cell_surfaces {
    const struct point_grid *scan;
    struct quadric *of; /* each cell's cubic (math/moment_fit.h) ... */
    bool *fitted;       /* ... where it has one that leaves little of the points */
};

/* For all cells of the scan's grid, by so many threads. */
struct cell_surfaces cell_surfaces_make(const struct point_grid *scan, int threads);
void cell_surfaces_free(struct cell_surfaces *cells);

/* How far the scan is from a place, mm: by the surface of its cell or, where that has none, by a
 * quadric through the nearest points or, where they carry none, their plane. */
double cell_surfaces_off(const struct cell_surfaces *cells, struct vec3 at);

#endif

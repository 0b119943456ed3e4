/*
 * stream_surface - the vertices of a cloud_stream on the surface of its scan, band by band of rows:
 * only the points about one band are in memory (stream_bands.h).
 *
 * In a band the functions that make the mesh of a cloud in memory (meshing/node_heights.h,
 * scan_normals.h, smooth_nodes.h) see the same vertices, facets and points, these sorted into the
 * same cells, so that they find the same, bit by bit.  What a whole mesh is asked for beside (the
 * noise, how many points most surfaces take) is found from the points about those places that are
 * looked at in memory too, which are gathered in one look.
 *
 * Sums of moments by cells, in place of the points, would need more: a cubic's 39 are 312 bytes a
 * node, and the eight points that it has with three spacings to a cell are 192.
 */
#ifndef CLOUDMILL_STREAM_SURFACE_H
#define CLOUDMILL_STREAM_SURFACE_H

#include "math/point_grid.h"
#include "stage/cloud_stream.h"

/* How many points there are in each cell of the scan's grid and in each row of the mesh's. */
struct stream_counts {
    struct point_grid cells; /* without points */
    uint32_t *of_cell;
    size_t *of_row;
};

struct stream_counts *stream_counts_new(const struct cloud_stream *stream);
void stream_counts_add(struct stream_counts *counts, const struct grid *grid,
                       const struct vec3 *point, size_t n);
void stream_counts_free(struct stream_counts *counts);

#endif

/*
 * trim_grid - the part of a grid of parameter lines that lies inside closed polygons, as triangles.
 *
 * Cells that no polygon crosses become two triangles; of the others the part inside is cut out
 * exactly along the polygon and cut up.  No hole comes to lie inside a cell, and neighbouring cells
 * share the points where a polygon crosses between them, so that the triangles leave no gaps.
 */
#ifndef CLOUDMILL_TRIM_GRID_H
#define CLOUDMILL_TRIM_GRID_H

#include "mesh/mesh.h"
#include "nurbs/uv_polygon.h"

struct uvmesh {
    struct uvs at;
    struct faces face; /* counter-clockwise in the plane of u and v */
    size_t unclear;    /* cells where the polygons cross themselves or each other: all or nothing */
};

/*
 * u and v are the lines, rising; the first and the last bound the grid.  Inside is what an odd
 * number of loops go round, or an even number where `open`.  A loop that crosses no line gets one:
 * `u` grows. Points of the loops outside the grid may be a little off: they are moved to its edge.
 */
void trim_grid(struct doubles *u, const struct doubles *v, const struct uv_polygon *loops,
               bool open, struct uvmesh *mesh);

void uvmesh_free(struct uvmesh *mesh);

#endif

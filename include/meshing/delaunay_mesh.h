/*
 * delaunay_mesh - a mesh of the points of a scan themselves: all of them, or as few as are needed.
 */
#ifndef CLOUDMILL_DELAUNAY_MESH_H
#define CLOUDMILL_DELAUNAY_MESH_H

#include "mesh/mesh.h"

struct delaunay_mesh_options {
    double gap;   /* no facet over an empty disc wider than this, mm */
    double error; /* no point over a facet farther off than this, mm; 0: not asked for */
    size_t keep;  /* no more vertices than this; 0: as many as needed */
};

/*
 * Appends vertices and facets, counter-clockwise, of the Delaunay triangulation of n points, 3 at
 * least, seen from above; facets over holes and beyond the border (scan_border.h) stay out.
 *
 * With an error or a count, of some of them: first of the border, whose lines between points that
 * are within a quarter of the error of it are edges of the mesh for good; then always the point
 * farthest from its facet, in space (M. Garland, P. Heckbert 1995), until none is farther off than
 * the error or there are as many as asked for.  Without an error the border takes no more than half
 * of these, or a little more where two borders are close.  O(n log n).
 */
void delaunay_mesh_make(const struct vec3 *point, size_t n,
                        const struct delaunay_mesh_options *options, struct mesh *mesh);

#endif

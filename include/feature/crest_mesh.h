/*
 * crest_mesh - ribs and grooves that a mesh cuts off, put into it.
 */
#ifndef CLOUDMILL_CREST_MESH_H
#define CLOUDMILL_CREST_MESH_H

#include "mesh/mesh.h"

struct crests {
    size_t found;    /* edges that got points */
    size_t too_many; /* edges to be looked at: so many that the last look was left out; else 0 */
};

/*
 * Looks at every edge whose ends have normals that turn, or that is long, for a crest (crest.h),
 * on a mesh of fewer than 6000 edges at all of them, and puts the points of that into it: the
 * facets beside are cut up between them, from crest to crest.  Then at those that come of it, twice
 * more, but along rows only at edges between old vertices.  Edges with a vertex numbered `first` or
 * up, which are those of creases and walls (feature_cut.h), stay as they are.  New vertices come in
 * the order from an edge's first vertex to its second; those of an edge along a row get its row and
 * the column of its first vertex, the others row and column -1.
 *
 * The n points of the cloud, none of them on a wall; `spacing` is their mean spacing, `noise` one
 * standard deviation, mm.  The mesh must have normals.  12,000 edges are looked at, of more than
 * 400,000 points 4,000; where a look needs more it is the end.  The result does not depend on the
 * number of threads.
 */
struct crests crest_mesh_keep(struct mesh *mesh, size_t first, const struct vec3 *point, size_t n,
                              double spacing, double noise, int threads);

#endif

/*
 * crest_mesh - ribs and grooves that a mesh cuts off, put into it.
 */
#ifndef CLOUDMILL_CREST_MESH_H
#define CLOUDMILL_CREST_MESH_H

#include "base/effort.h"
#include "mesh/mesh.h"

struct crest_mesh_options {
    double spacing, noise; /* of the points: their mean spacing, one standard deviation, mm */
    double effort;         /* effort.h */
    int threads;           /* of which the result does not depend */
};

struct crests {
    size_t found;            /* edges that got points */
    size_t edges;            /* that the mesh had, at most */
    size_t wanted;           /* edges that would have been looked at in all ... */
    enum effort_bound bound; /* ... but for this */
};

/*
 * Looks at every edge whose ends have normals that turn, or that is long, for a crest (crest.h),
 * on a small mesh (EFFORT_CREST_EDGES) at all of them, and puts the points of that into it: the
 * facets beside are cut up between them, from crest to crest.  Then at those that come of it, twice
 * more, but along rows only at edges between old vertices.  Edges with a vertex numbered `first` or
 * up, which are those of creases and walls (feature_cut.h), stay as they are.  New vertices come in
 * the order from an edge's first vertex to its second; those of an edge along a row get its row and
 * the column of its first vertex, the others row and column -1.
 *
 * The n points of the cloud are on no wall.  The mesh must have normals.  Where a look needs more
 * edges than EFFORT_CRESTS, or on large scans EFFORT_CRESTS_LARGE, has left it is the end.
 */
struct crests crest_mesh_keep(struct mesh *mesh, size_t first, const struct vec3 *point, size_t n,
                              const struct crest_mesh_options *options);

#endif

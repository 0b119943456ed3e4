/*
 * guard_mesh - the surface of a mesh as points that are dense enough to keep a ball off it, and its
 * sharp edges.  Of a scan: guard_points.h.
 */
#ifndef CLOUDMILL_GUARD_MESH_H
#define CLOUDMILL_GUARD_MESH_H

#include "base/array.h"
#include "math/point_grid.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"

/* What of a facet and the curved triangle over it is the part. */
enum guard_facets {
    GUARD_CURVED, /* the curved triangle: the mesh is of a surface, and is judged by that */
    GUARD_NEAR,   /* that, and the facet less GUARD_OFF, where that is above: judged by either */
    GUARD_UPPER,  /* the upper of both: the normals were made from the facets */
    GUARD_FLAT    /* the facets, as who judges by the mesh alone takes them */
};

/* mm: so far a ball may be below a facet whose normals say that the surface is below it. */
#define GUARD_OFF 0.01

struct guard_mesh_options {
    double spacing; /* of the points, mm, at most ... */
    double most;    /* ... unless that makes more than so many beside the vertices */
    enum guard_facets facets;
    int threads;
};

/*
 * Appends the points of a mesh with vertex normals: each facet as the curved triangle that its
 * vertices and normals span (PN triangle, Vlachos et al. 2001, but with handles that make edges of
 * a sphere circular to the sixth order), sampled no coarser than the spacing.  The flat facet alone
 * would not do: in a hollow it is above the surface by its sagitta.  Only a facet that is more
 * than 30 degrees off one of its vertices' normals, as at a step or an edge, is sampled flat.
 * Returns the spacing, mm.  `edges`: those of the mesh, if they are known already; or NULL.
 */
double guard_points_of_mesh(const struct mesh *mesh, const struct mesh_edges *edges,
                            const struct guard_mesh_options *options, struct vec3s *points);

/*
 * Appends points no further than `spacing` mm apart on the convex edges of a mesh: those between
 * two facets that have vertices of their own there, at the same places, and fall off from each
 * other to both sides.  A scan seldom has points on its edges, and a ball that rolls over them
 * would sink in between the points beside.  With a scan only where its points about are on the two
 * facets: elsewhere the mesh bridges what the scan knows nothing of.
 */
void guard_points_of_edges(const struct mesh *mesh, double spacing, const struct point_grid *scan,
                           struct vec3s *points);

#endif

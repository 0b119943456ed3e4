/*
 * feature - sharp edges, walls and narrow ribs of a scan, put into its mesh.
 *
 * In: a mesh with normals whose vertices are points of the scan, and the scan, the points of its
 * walls last (cloud/wall_points.h).  Out: the mesh cut open along creases and walls, with vertices
 * on the crests of ribs and in grooves.  The stages (feature_steps.h):
 *
 *   1. Doubtful edges: normals differ at their ends, they leave the surface, or they are steep.
 *   2. Between the ends of each the points are divided between two sheets (feature_crease.c), or
 *      between two levels and a wall (feature_wall.c).  Two sheets must fit them better than one
 *      surface, and their crease must be no rounded edge.
 *   3. Gaps in the lines that the features make over the mesh are closed (feature_link.c), and
 *      vertices beside them make room (feature_relocate.c); with these, stage 2 again.
 *   4. The mesh is cut open along the features (feature_cut.c; Chui, Chiu, Yu 2007, section 7,
 *      figures 45 and 46), with a vertex where they meet within a facet (feature_corner.c).
 *   5. Only features that bring the mesh closer to the scan are kept (feature_accept.c).
 *   6. Ribs and grooves: of edges that may cut one off (crest_mesh.c) the surface over each is
 *      followed from end to end (crest.c), and the mesh gets the places on its crest
 *      (crest_insert.c).
 */
#ifndef CLOUDMILL_FEATURE_H
#define CLOUDMILL_FEATURE_H

#include "base/effort.h"
#include "math/point_grid.h"
#include "mesh/mesh.h"
#include "meshing/feature_zone.h"

/* The points, as wall_points_part put them in order. */
struct feature_scan {
    struct vec3 *point;
    size_t n, flat; /* the first `flat` of them are on no wall: these get sorted (point_grid.h) */
    double spacing; /* mean spacing of the points, mm */
    double noise;   /* one standard deviation, mm */
    const struct point_grid *sorted; /* the first `flat` with that spacing; NULL: not yet */
    const struct feature_zone *zone; /* where creases and walls are known to run: the search begins
                                        near to it; NULL: everywhere */
};

struct feature_mesh {
    size_t creases, walls; /* edges of the mesh that cross one */
    struct vec3s place;    /* along them; for the caller to free */
    size_t doubtful;       /* edges that might cross a crease: more than EFFORT_CREASES, and none of
                              them is looked at */
};

/*
 * Looks at every edge of the mesh that is steep, or at whose ends the normals differ, for a wall or
 * a crease between its ends, and cuts the mesh open there, where that brings it closer to the
 * points.  The vertices beside it get the normal of
 * their side, and those nearer to it than a quarter of the edge move away from it on their side,
 * for the facets' sake.
 *
 * The mesh must have normals.  `effort`: effort.h.  The result does not depend on the number of
 * threads.
 */
struct feature_mesh feature_mesh_keep(struct mesh *mesh, const struct feature_scan *scan,
                                      double effort, int threads);

struct feature_walls {
    size_t found; /* edges of the mesh that cross a wall */
    size_t edges; /* of the mesh, where walls were found that are too short on so many
                     (EFFORT_WALLS); else 0 */
};

/* The walls of a mesh, which needs no normals.  None where there are no six edges one beside the
 * other that cross one, on a large mesh twenty-four: that is the roughness of a scan. */
struct feature_walls feature_mesh_walls(const struct mesh *mesh, const struct feature_scan *scan,
                                        double effort, int threads);

/* The same, and the mesh, which must have normals, cut open along those of them that bring it
 * closer to the points: these are found.  One look, and no vertex makes room: to see what walls are
 * worth. */
struct feature_walls feature_mesh_try_walls(struct mesh *mesh, const struct feature_scan *scan,
                                            double effort, int threads);

struct crest_mesh_options {
    double spacing, noise; /* of the points: their mean spacing, one standard deviation, mm */
    double effort;         /* effort.h */
    int threads;           /* of which the result does not depend */
    const struct point_grid *sorted; /* the points with that spacing; NULL: not yet */
};

struct crests {
    size_t found;            /* edges that got points */
    size_t facets;           /* that the mesh had, at most */
    size_t wanted;           /* edges that would have been looked at in all ... */
    enum effort_bound bound; /* ... but for this */
};

/*
 * Looks at every edge whose ends have normals that turn, or that is long, for a crest,
 * on a small mesh (EFFORT_CREST_FACETS) at all of them, and puts the points of that into it: the
 * facets beside are cut up between them, from crest to crest.  Then at those that come of it, twice
 * more, but along rows only at edges between old vertices.  Edges with a vertex numbered `first` or
 * up, which are those of creases and walls, stay as they are.  New vertices come in
 * the order from an edge's first vertex to its second; those of an edge along a row get its row and
 * the column of its first vertex, the others row and column -1.
 *
 * The n points of the cloud are on no wall, and get sorted.  The mesh must have normals.  Where a
 * look needs more edges than EFFORT_CRESTS, or on large scans EFFORT_CRESTS_LARGE, has left it is
 * the end.
 */
struct crests crest_mesh_keep(struct mesh *mesh, size_t first, struct vec3 *point, size_t n,
                              const struct crest_mesh_options *options);

#endif

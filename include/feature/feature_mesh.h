/*
 * feature_mesh - creases and walls of a scan found and put into its mesh.
 */
#ifndef CLOUDMILL_FEATURE_MESH_H
#define CLOUDMILL_FEATURE_MESH_H

#include "mesh/mesh.h"

/* The points, as wall_points_part put them in order. */
struct feature_scan {
    const struct vec3 *point;
    size_t n, flat; /* the first `flat` of them are on no wall */
    double spacing; /* mean spacing of the points, mm */
    double noise;   /* one standard deviation, mm */
};

struct feature_mesh {
    size_t creases, walls; /* edges of the mesh that cross one */
    struct vec3s place;    /* along them; for the caller to free */
    size_t doubtful;       /* edges that might cross a crease: more than EFFORT_CREASES, and none of
                              them is looked at */
};

/*
 * Looks at every edge of the mesh that is steep, or at whose ends the normals differ, for a wall or
 * a crease between its ends (feature.h), and cuts the mesh open there (feature_cut.h), where that
 * brings it closer to the points (feature_accept.h).  The vertices beside it get the normal of
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

#endif

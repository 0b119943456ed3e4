/*
 * feature_mesh - creases and walls of a cloud found and put into its mesh.
 */
#ifndef CLOUDMILL_FEATURE_MESH_H
#define CLOUDMILL_FEATURE_MESH_H

#include "mesh/mesh.h"

struct feature_mesh {
    size_t creases, walls; /* edges of the mesh that cross one */
    struct vec3s place;    /* along them; for the caller to free */
    size_t too_many;       /* edges that might be on a crease, more than are looked at: none is */
};

/* How many edges of the mesh cross a wall; it needs no normals.  The points as below.  0 where
 * there are no six of them one beside the other, on a mesh of more than 200,000 edges twenty-four:
 * that is the roughness of a scan. */
size_t feature_mesh_walls(const struct mesh *mesh, const struct vec3 *point, size_t n, size_t flat,
                          double spacing, double noise, int threads);

/*
 * Looks at every edge of the mesh that is steep, or at whose ends the normals differ, for a wall or
 * a crease between its ends (feature.h), and cuts the mesh open there (feature_cut.h), where that
 * brings it closer to the points (feature_accept.h).  The vertices
 * beside it get the normal of their side, and those nearer to it than a quarter of the edge move
 * away from it on their side, for the facets' sake.
 *
 * The n points as wall_points_part put them, the first `flat` of them on no wall; `spacing` is
 * their mean spacing, `noise` one standard deviation, mm.  The mesh must have normals.  The result
 * does not depend on the number of threads.
 */
struct feature_mesh feature_mesh_keep(struct mesh *mesh, const struct vec3 *point, size_t n,
                                      size_t flat, double spacing, double noise, int threads);

#endif

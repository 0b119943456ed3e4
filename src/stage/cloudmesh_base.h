/*
 * cloudmesh_base - the steps that cloudmesh.c and cloudmesh_within.c put together: nodes by a grid,
 * normals, creases and walls.
 */
#ifndef CLOUDMILL_CLOUDMESH_BASE_H
#define CLOUDMILL_CLOUDMESH_BASE_H

#include "stage/cloudmesh.h"

/* The cloud as wall_points_part put it in order. */
struct cloud_parts {
    double mean; /* spacing of the points, mm */
    size_t flat; /* so many of them lie on no wall */
};

/* Three times the mean spacing, to three digits: so that -t can say the same. */
double cloudmesh_three_spacings(double mean);

/* The grid's mesh of the points, without normals.  -1: as cloudmesh_make. */
int cloudmesh_by_grid(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                      const struct vec3s *points, struct mesh *mesh, struct cloudmesh *result,
                      struct error *error);

/* Normals, and vertices moved where there is noise, from n points, which it sorts. */
int cloudmesh_normals(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error);

/* Creases and walls put into the mesh, and its normals to the side that is seen. */
void cloudmesh_edges(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                     const struct vec3s *points, double noise, int threads, struct mesh *mesh,
                     struct cloudmesh *result);

/* Is there a wall between two nodes of a grid? */
bool cloudmesh_has_walls(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                         const struct vec3s *points, double noise, int threads);

/* Two meshes, and what came of them, change places. */
void cloudmesh_swap(struct mesh *other, struct cloudmesh *other_result, struct mesh *mesh,
                    struct cloudmesh *result);

/* Puts `other` in the place of `mesh` where that is closer to the points (squares, every so many of
 * them). */
void cloudmesh_closer(const struct cloudmesh_options *options, const struct vec3s *points,
                      int threads, struct mesh *other, struct cloudmesh *other_result,
                      struct mesh *mesh, struct cloudmesh *result);

/* Of a mesh that was only tried. */
void cloudmesh_drop(struct mesh *mesh, struct cloudmesh *result);

/* The mesh by a grid: vertices are chosen from the points of walls, unless it is closer to all
 * points without: steep flanks are no walls.  result->edge is for the caller to free. */
int cloudmesh_on_grid(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                      int threads, struct mesh *mesh, struct cloudmesh *result,
                      struct error *error);

/* The mesh within an error; the same. */
int cloudmesh_within(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error);

#endif

/*
 * cloudmesh_base - the steps that cloudmesh.c puts together: nodes by a grid or by an error, and
 * normals.
 */
#ifndef CLOUDMILL_CLOUDMESH_BASE_H
#define CLOUDMILL_CLOUDMESH_BASE_H

#include "cloudmesh.h"

/* The cloud as wallpoints_part put it in order. */
struct cloud_parts {
    double mean; /* spacing of the points, mm */
    size_t flat; /* so many of them lie on no wall */
};

/* The grid's mesh of the points, without normals.  -1: as cloudmesh_make. */
int cloudmesh_by_grid(const struct cloudmesh_wish *wish, const struct cloud_parts *parts,
                      const struct vec3s *points, struct mesh *mesh, struct cloudmesh *made,
                      struct error *error);

/* The mesh that an error asks for, without normals; sorts the points on no wall. */
int cloudmesh_by_error(const struct cloudmesh_wish *wish, const struct cloud_parts *parts,
                       struct vec3s *points, int threads, struct mesh *mesh,
                       struct cloudmesh *made, struct error *error);

/* Normals, and vertices moved where there is noise, from n points, which it sorts. */
int cloudmesh_normals(const struct cloudmesh_wish *wish, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error);

#endif

/*
 * cloudmesh - from the points of a cloud, cleaned, to its mesh: grid or rows, normals, edges and
 * walls, parts with projections of their own; and what is to be said of it.
 */
#ifndef CLOUDMILL_CLOUDMESH_H
#define CLOUDMILL_CLOUDMESH_H

#include <stdbool.h>

#include "base/error.h"
#include "meshing/meshing.h"
#include "mesh/mesh.h"
#include "stage/normals.h"

/* What is asked for. */
struct cloudmesh_options {
    double spacing;   /* of the grid, mm; 0: from the cloud */
    double error;     /* rows by an error, mm; 0: the spacing counts */
    double max_gap;   /* mm, 0: from the cloud */
    double direction; /* of the rows, degrees */
    const struct normal_estimator *normals;
    int neighbours; /* 0: chosen */
    double effort;  /* effort.h */
    bool paper;     /* as published */
    bool smooth;    /* look for no creases and no walls */
    bool subdivide; /* parts by orientation, each with a projection of its own */
    bool silent;    /* of what became of the vertices: a trial */
};

/* What came of it. */
struct cloudmesh {
    struct grid_mesh_count count;
    struct grid grid;
    struct adaptive_rows rows; /* with an error: of the worst part; how far points are in space */
    size_t creases, walls;     /* edges that cross one */
    size_t crests;             /* edges that got points on a rib or in a groove */
    struct vec3s edge; /* where: of no use to the caller of cloudmesh_make, and empty there */
};

/* Mean spacing of the points, mm; 0 where they cover no area. */
double cloudmesh_spacing(const struct cloudmesh_options *options, const struct vec3 *point,
                         size_t n);

/*
 * The mesh of the points; sorts them.  `noise` (mm) is what vertices are rid of by moving them, 0:
 * none.  The ledger and the maker go to mesh->origin.  -1 and why (without the name of a file): no
 * area, no facet, a spacing or a gap out of proportion.
 */
int cloudmesh_make(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                   int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error);

#endif

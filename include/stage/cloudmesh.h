/*
 * cloudmesh - from the points of a cloud to its mesh, and what is to be said of it.
 *
 * In: points that cloud_prepare.h has cleaned.  Out: a mesh with normals.  The stages:
 *
 *   1. --subdivide: the cloud in parts, each in its own projection (cloud/segment.h)
 *   2. nodes by a grid, or with -e rows and points between them (meshing/meshing.h); with -e of the
 *      surface that noisy points lie about, and clear of creases and walls that a grid has found
 *      before; without room for these where that is closer
 *   3. normals, and noise taken out of the vertices (normals.h)
 *   4. creases, walls and, without -e, ribs (feature/feature.h); twice where there are walls, with
 *      and without vertices on them: the mesh closer to the points is the result
 *   5. the parts joined (meshing/mesh_join.h)
 *
 * The ways that paper 1 reviews take the place of stages 2 to 4: enum cloudmesh_method.
 *
 * What a large cloud is looked at less for, and by how much, is said (base/effort.h).
 */
#ifndef CLOUDMILL_CLOUDMESH_H
#define CLOUDMILL_CLOUDMESH_H

#include <stdbool.h>

#include "base/error.h"
#include "meshing/meshing.h"
#include "mesh/mesh.h"
#include "stage/normals.h"

/* The way to the nodes. */
enum cloudmesh_method {
    CLOUDMESH_CHUI,     /* the stages above: Chui, Chiu, Yu 2007 */
    CLOUDMESH_DELAUNAY, /* points of the scan, all or few (meshing/delaunay_mesh.h) */
    CLOUDMESH_LIN,      /* a rectangular grid by interpolation (meshing/lin_grid.h) */
};

/* What is asked for. */
struct cloudmesh_options {
    enum cloudmesh_method method;
    double spacing;   /* of the grid, mm; 0: from the cloud */
    double error;     /* rows by an error, mm; 0: the spacing counts */
    double max_gap;   /* mm, 0: from the cloud */
    double direction; /* of the rows, degrees */
    int keep;         /* CLOUDMESH_DELAUNAY: as many vertices, 0: as many as needed */
    const struct normal_estimator *normals;
    int neighbours;      /* 0: chosen */
    double effort;       /* effort.h */
    double mean;         /* spacing of the points, mm, where it is known; 0: it is measured */
    bool paper;          /* as published */
    bool scan_nodes;     /* vertices are points of the scan, as published */
    bool smooth;         /* look for no creases, walls and ribs, nor for facets turned over */
    bool subdivide;      /* parts by orientation, each with a projection of its own */
    struct vec3 outside; /* of their surface is the side seen from there; zero: from above */
    bool silent;         /* a trial: nothing is said */
    bool explained;      /* noise is taken out only where a surface soon explains the points */
    bool edges_only; /* a trial that shows where creases and walls are: no ribs are looked for */
    const struct feature_zone *zone; /* where they are known to be; NULL: nothing is known */
    struct smoothed_parts *parts; /* of a part: they get what is said of noise; NULL: of no part */
};

/* What came of it. */
struct cloudmesh {
    struct grid_mesh_count count;
    struct grid grid;
    struct adaptive_rows rows; /* with an error: of the worst part; how far points are in space */
    size_t creases, walls;     /* edges that cross one */
    size_t crests;             /* edges that got points on a rib or in a groove */
    size_t turned;             /* facets left out: they face against the points about them ... */
    double turned_part;        /* ... which part of the area these are */
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

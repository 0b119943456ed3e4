/*
 * mesh_repair - a foreign mesh made fit to be cut: what is no facet left out, all facets turned the
 * same way round and out of the material, normals where there are none.
 */
#ifndef CLOUDMILL_MESH_REPAIR_H
#define CLOUDMILL_MESH_REPAIR_H

#include <stdbool.h>

#include "mesh/mesh.h"

/* What was found and done. */
struct mesh_repair_report {
    size_t welded;     /* vertices at the same place as another one, made one with it */
    size_t no_area;    /* facets without area, left out */
    size_t doubled;    /* facets that were there before, left out */
    size_t many;       /* edges with more than two facets */
    size_t flipped;    /* facets turned to agree with their neighbours */
    size_t sheets;     /* connected pieces */
    size_t closed;     /* of them without a border */
    size_t turned;     /* pieces that faced away and were turned as a whole */
    size_t normals;    /* vertex normals away from their facets: turned, or the facets' mean */
    bool normals_made; /* the mesh had none */
};

/*
 * Mends the mesh in place.  The facets of a connected piece are turned the way most of them are.
 * A closed piece encloses its material.  An open one faces `up`, a unit vector, when more than a
 * tenth of its area does not cancel: a mesh that has normals is turned as a whole, its normals with
 * it, and one without piece by piece.  Without normals, vertices at one place become one, facets
 * that meet at more than 30 degrees get vertices of their own, and normals are the mean of the
 * facets', each weighted by its angle at the vertex; but a facet that these would bend by more than
 * 0.01 mm stays flat, with vertices and a normal of its own.  Rows and columns are
 * dropped, and kmax where normals were made.  A mesh that loses all its facets is left without.
 */
struct mesh_repair_report mesh_repair(struct mesh *mesh, struct vec3 up, int threads);

/* A smooth surface by the normals of the vertices is more than 0.01 mm off some facet. */
bool mesh_is_coarse(const struct mesh *mesh);

/* It has sharp edges: vertices at one place with normals more than 2.5 degrees apart. */
bool mesh_is_sharp(const struct mesh *mesh);

#endif

/*
 * slice - where planes cross a mesh: chains of contact points (paper 2, 2.2).
 *
 * Every point lies on an edge of a facet, and two that follow each other on edges of one facet, but
 * where one less than 1e-3 mm from the one before is left out.
 * A vertex on the plane, or within ON_PLANE of it, counts as below it: each crossing is found once,
 * and a border along the plane as a whole.
 */
#ifndef CLOUDMILL_SLICE_H
#define CLOUDMILL_SLICE_H

#include <stdbool.h>

#include "base/array.h"
#include "mesh/mesh.h"
#include "curve/motion.h"

/* Points [from, to) of the contacts. */
struct slice_chain {
    size_t from, to;
    bool closed; /* goes back to its first point, which is its last one too */
};

struct slice_chains {
    struct contacts point;
    struct {
        size_t n, cap;
        struct slice_chain *item;
    } chain;
};

void slice_chains_free(struct slice_chains *chains);

/* Ends the chain that begins at point `from`, or drops it if it has only one point. */
void slice_chains_end(struct slice_chains *chains, size_t from, bool closed);

/* Length of all chains, mm. */
double slice_chains_length(const struct slice_chains *chains);

void contacts_reverse(struct contact *contact, size_t n);

/* How far n contacts go in the direction of the cross product of the plane's and the surface's
 * normals, mm; negative: they go the other way. */
double contacts_forward(const struct contact *contact, size_t n, struct vec3 normal);

struct slice;

/*
 * Prepares a mesh with normals for planes of this unit normal.  The mesh must outlive it.  `smooth`
 * takes the edges as the surface runs there (mesh_edge_curve), not as straight: points are then on
 * the surface to the fourth order of an edge's length.  `threads` as in parallel.h.
 */
struct slice *slice_new(const struct mesh *mesh, struct vec3 normal, bool smooth, int threads);

void slice_free(struct slice *cut);

/* The edges of the mesh, which it has found. */
const struct mesh_edges *slice_edges(const struct slice *cut);

/* Lowest and highest of the facets' vertices along the planes' normal, mm. */
double slice_low(const struct slice *cut);
double slice_high(const struct slice *cut);

/*
 * Appends the chains of the plane with x . normal = height.  A chain runs as the cross product of
 * the plane's and the surface's normals; it ends at a border of the mesh, and at an edge that has
 * more than two facets.  Points nearer than CROWDED to the last one are left out, and chains of
 * one point.  Points lie on the plane within rounding; their normals are those of the vertices,
 * mixed, and perpendicular to the edge as it runs.
 */
void slice_at(struct slice *cut, double height, struct slice_chains *chains);

#endif

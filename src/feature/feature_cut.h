/*
 * feature_cut - a mesh cut open along creases and walls (paper 1, 7, figs 45 and 46).
 */
#ifndef CLOUDMILL_FEATURE_CUT_H
#define CLOUDMILL_FEATURE_CUT_H

#include "feature.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"

/*
 * Puts the vertices of each edge's feature into the mesh, and facets in place of those that it
 * crosses.  At a crease there are two vertices at one place, each with the normal of its side; at a
 * wall four, two at its top and two at its foot, of which the inner two have the normal of the
 * wall, and vertical facets between them.  They come in the order from the edge's first vertex to
 * its second; those of an edge along a row get its row and the column of its first vertex, the
 * others row and column -1.  Where two walls, or the creases between three sheets, meet within a
 * facet, that corner gets vertices too (feature_corner.h), after those of all edges.
 *
 * feature[edges->n]: FEATURE_NONE leaves the edge as it is.  The mesh must have normals.
 */
void feature_cut(struct mesh *mesh, const struct mesh_edges *edges, const struct feature *feature);

#endif

/*
 * feature_relocate - the vertices beside creases and walls, put where these leave room for facets.
 */
#ifndef CLOUDMILL_FEATURE_RELOCATE_H
#define CLOUDMILL_FEATURE_RELOCATE_H

#include "feature.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"

struct feature_relocate {
    struct mesh *mesh;
    const struct mesh_edges *edges;
    const struct feature *feature; /* of each edge */
    double spacing, noise;         /* of the cloud, mm */
};

/* Vertices nearer to a feature than a quarter of its edge, of the facets beside it, move away from
 * it along the sheet of their side, and onto that when they are far off it, as points on a wall
 * are. Where a corner of two features juts out of its facet they move on to make room for it.
 * beside[] gets which vertices have a feature near to them. */
void feature_relocate_places(const struct feature_relocate *s, unsigned char *beside);

/* Vertices with a feature on one of their edges get the normal of their side. */
void feature_relocate_normals(const struct feature_relocate *s);

/* Where there is noise the sheets of a feature tell best where the vertices beside it are: these go
 * to the mean of what their features say. */
void feature_relocate_feet(const struct feature_relocate *s);

/* Vertices that have no feature near to them are as they were `before`, normals too. */
void feature_relocate_back(const struct feature_relocate *s, const struct mesh *before);

#endif

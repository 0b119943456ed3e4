/*
 * featuresettle - the vertices beside creases and walls, put where these leave room for facets.
 */
#ifndef CLOUDMILL_FEATURESETTLE_H
#define CLOUDMILL_FEATURESETTLE_H

#include "feature.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"

struct featuresettle {
    struct mesh *mesh;
    const struct mesh_edges *edges;
    const struct feature *feature; /* of each edge */
    double spacing, noise;         /* of the cloud, mm */
};

/* Vertices nearer to a feature than a quarter of its edge, of the facets beside it, move away from
 * it along the sheet of their side, and onto that when they are far off it, as points on a wall
 * are. Where a corner of two features juts out of its facet they move on to make room for it.
 * beside[] gets which vertices have a feature near to them. */
void featuresettle_places(const struct featuresettle *s, unsigned char *beside);

/* Vertices with a feature on one of their edges get the normal of their side. */
void featuresettle_normals(const struct featuresettle *s);

/* Where there is noise the sheets of a feature tell best where the vertices beside it are: these go
 * to the mean of what their features say. */
void featuresettle_feet(const struct featuresettle *s);

/* Vertices that have no feature near to them are as they were `before`, normals too. */
void featuresettle_back(const struct featuresettle *s, const struct mesh *before);

#endif

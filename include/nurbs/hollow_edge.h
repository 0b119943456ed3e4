/*
 * hollow_edge - sharp edges of the joined surfaces that are hollow, where no ball fits: between two
 * surfaces, and in one whose knots let it have a kink.
 */
#ifndef CLOUDMILL_HOLLOW_EDGE_H
#define CLOUDMILL_HOLLOW_EDGE_H

#include "nurbs/patch_mesh.h"

struct hollow_edge {
    double angle;    /* between the two normals, radians; 0: no edge is hollow */
    struct vec3 at;  /* the middle of a facet's side, mm */
    struct uv uv[2]; /* there on the surface on either side */
    int sheet[2];
};

/*
 * The sharpest hollow edge of all, *sharpest, and that within each surface: [sheet], which the
 * caller frees.  The patches are joined and turned.  An edge is one side of two facets, each with
 * the normals of its surface at both ends; it is sharp where these are more than PATCH_MESH_SMOOTH
 * apart at either end.
 */
struct hollow_edge *hollow_edges_find(const struct patch_mesh *mesh, struct hollow_edge *sharpest);

#endif

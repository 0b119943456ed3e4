/*
 * patch_weld - places that are one on the printed digits made one.
 */
#ifndef CLOUDMILL_PATCH_WELD_H
#define CLOUDMILL_PATCH_WELD_H

#include "nurbs/patch.h"
#include "nurbs/patch_mesh.h"

/*
 * Rounds all points to PATCH_MESH_DIGITS, and gives those of the same body that then are the same
 * one place: a reader of the mesh joins them, and what is said of the skin must be true of what is
 * written.  Places of different bodies (patch.h) stay apart.  Returns how many became one with
 * another.
 */
size_t patch_mesh_weld(struct patch_mesh *patch_mesh, const struct patches *patches);

#endif

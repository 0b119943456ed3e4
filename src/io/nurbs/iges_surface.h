/*
 * iges_surface - the surfaces of an IGES file: entities 128 (rational B-spline surface) and those
 * of iges_construct.h, with what trims them: 144 (with 142), 143 (with 141), or the faces of
 * solids, 510 (with 508).
 */
#ifndef CLOUDMILL_IGES_SURFACE_H
#define CLOUDMILL_IGES_SURFACE_H

#include "iges.h"
#include "nurbs/patch.h"

/*
 * Appends all surfaces, in the order of their directory entries, in mm: each once for each entity
 * that trims it, or once as it is.  A loop is given by curves in the parameters or, where the file
 * prefers these or has no others, or the surface is no B-spline, by curves in space.  Surfaces that
 * are not read go to patches->left.  `mm` > 0 takes the place of the file's own unit.  A file
 * without a surface is an error.
 */
int iges_surfaces(const struct iges *iges, double mm, struct patches *patches, struct error *error);

#endif

/*
 * retilt - the tool axis of a whole path set anew (tilt.h).
 */
#ifndef CLOUDMILL_RETILT_H
#define CLOUDMILL_RETILT_H

#include "io/path/path.h"

/*
 * Tilts all cutting runs by `angle` radians.  The moves that lead to a run and away from it and
 * have the axis of its end take the new axis, their ball where it was.  A path without a ball
 * cutter, or without contact points and normals, is an error.
 */
int retilt_path(struct path *path, double angle, bool frenet, struct error *error);

#endif

/*
 * path_tilt - the tool axis of a whole path set anew (tilt.h).
 */
#ifndef CLOUDMILL_PATH_TILT_H
#define CLOUDMILL_PATH_TILT_H

#include "io/path/path.h"

/*
 * Tilts all cutting runs by `angle` radians.  The moves that lead to a run and away from it and
 * have the axis of its end take the new axis, their ball where it was.  A path without a ball
 * cutter, or without contact points and normals, is an error.
 */
int path_set_tilt(struct path *path, double angle, bool frenet, struct error *error);

#endif

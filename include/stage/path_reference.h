/*
 * path_reference - a path of points told anew by another point of the tool.
 */
#ifndef CLOUDMILL_PATH_REFERENCE_H
#define CLOUDMILL_PATH_REFERENCE_H

#include "io/path/path.h"

/*
 * Moves all points of the path to what `track` says: the tip, the ball's centre, or the contact
 * point (a point without one, as on the way to the part, stays at the tip then), and notes it in
 * the head.  An error: a path without a ball cutter, with arcs or B-splines, or of contact points
 * where other ones are wanted; contact points wanted where a path has none.
 */
int path_set_reference(struct path *path, enum path_track track, struct error *error);

#endif

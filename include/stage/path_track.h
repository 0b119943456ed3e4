/*
 * path_track - a path of points programmed by another point of the tool.
 */
#ifndef CLOUDMILL_PATH_TRACK_H
#define CLOUDMILL_PATH_TRACK_H

#include "io/path/path.h"

/*
 * Moves all points of the path to the one that `track` names: the tip, the ball's centre, or the
 * contact point (a point without one, as on the way to the part, stays at the tip then), and notes
 * it in the head.  An error: a path without a ball cutter, with arcs or B-splines, or of contact
 * points where other ones are wanted; contact points wanted where a path has none.
 */
int path_set_track(struct path *path, enum path_track track, struct error *error);

#endif

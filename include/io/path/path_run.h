/*
 * path_run - a cutting run of a path as the fitters see it.
 */
#ifndef CLOUDMILL_PATH_RUN_H
#define CLOUDMILL_PATH_RUN_H

#include "io/path/path.h"
#include "curve/run.h"

/*
 * Appends the items [from, to) that path_next_run found to `run`, all of them `given`, and sets its
 * radius: that of the path's ball, or 0 when there is none or the path tracks contact points; the
 * tip and the centre are then both the tracked point.
 */
void path_run_take(const struct path *path, size_t from, size_t to, struct run *run);

#endif

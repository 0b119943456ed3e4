/*
 * path_run - a cutting run of a path as the fitters see it.
 */
#ifndef CLOUDMILL_PATH_RUN_H
#define CLOUDMILL_PATH_RUN_H

#include "io/path/path.h"
#include "curve/run.h"

/*
 * The items [from, to) that path_next_run found as a run, all of them `given`.  Its radius is that
 * of the path's ball, or 0 when there is none or the path tracks contact points; the tip and the
 * centre are then both the tracked point.
 */
struct run path_run_read(const struct path *path, size_t from, size_t to);

/* The direction of the straight motions before the item at which a run begins, or after that at
 * which it ends, unit: between passes too, but with no rapid; zero where there are none. */
struct vec3 path_run_direction(const struct path *path, size_t at, bool before);

/* The surface's normal at an item, or at the next one in the same place; zero: not known. */
struct vec3 path_run_normal(const struct path *path, size_t at);

#endif

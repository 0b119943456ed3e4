/*
 * path_motion - a path as a motion that is evaluated by formulas of its own (simulate/nc_motion.h),
 * for what compares a program with it.
 */
#ifndef CLOUDMILL_PATH_MOTION_H
#define CLOUDMILL_PATH_MOTION_H

#include "io/path/path.h"
#include "simulate/nc_motion.h"

/* Holes of drilling cycles are left out.  -1: the path tracks the contact point. */
int path_motion_of(const struct path *path, struct nc_motion *motion, struct error *error);

#endif

/*
 * cl - the motion of a path stream.
 */
#ifndef READBACK_CL_H
#define READBACK_CL_H

#include "base/array.h"
#include "simulate/nc_motion.h"
#include "io/path/path.h"

/* Reads a path and makes its motion: straight moves and arcs with the axis on the great circle in
 * proportion, splines by their poles (not their fallback points), holes as the motions that they
 * stand for. */
int cl_read(const char *file, struct path *path, struct nc_motion *nc_motion, struct error *error);

#endif

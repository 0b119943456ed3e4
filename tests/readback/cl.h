/*
 * cl - the motion of a path stream or CL file, read by the tests alone.
 *
 * Written from man/cloudmill-path.5 and the makers' descriptions of their CL files; it includes
 * nothing of io/path, so that a CIRCLE or a unit that is misread there differs from what is read
 * here, and is seen.
 */
#ifndef READBACK_CL_H
#define READBACK_CL_H

#include "base/error.h"
#include "simulate/nc_motion.h"

/* What a path says besides its motion. */
struct cl {
    bool has_cutter;
    double diameter, corner; /* of its first tool, mm */
};

/* Radius of the ball, mm; 0: the tool has none, or is not given. */
double cl_ball(const struct cl *cl);

/* Straight moves and arcs with the axis on the great circle in proportion, splines by their poles
 * (not their fallback points), holes as the motions that they stand for. */
int cl_read(const char *file, struct cl *cl, struct nc_motion *motion, struct error *error);

#endif

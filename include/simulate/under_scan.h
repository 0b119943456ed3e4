/*
 * under_scan - does a tool come under a scan, where no point stands for the material that is there?
 *
 * A scan is a shell.  Below a point of its roof (what faces up with nothing of the scan below it)
 * is material, down to the bottom: the upright line below such a point may not be in the tool.
 * That is looked at for the ball and for spheres within the tool above it, in places along the
 * motion and up the tool a part of the radius apart; what is level with the point or above is the
 * business of deviation_map.h and holder_collision.h.  Lengths in mm.
 */
#ifndef CLOUDMILL_UNDER_SCAN_H
#define CLOUDMILL_UNDER_SCAN_H

#include "simulate/nc_motion.h"
#include "simulate/tool_shape.h"

struct under_scan_options {
    const struct nc_motion *motion;
    const struct tool_shape *tool; /* above the ball */
    double radius;                 /* of the ball */
    double allowed;                /* not told up to this depth */
    double bottom; /* z of the scan's lowest point, say: below it nothing is known; -HUGE_VAL: all
                      the way down is material */
    int threads;   /* as of parallel_for */
};

/* What was found; all zero where there is nothing. */
struct under_scan {
    double depth;   /* of the upright line of a roof point in the tool, the deepest */
    size_t piece;   /* there */
    struct vec3 at; /* on the tool's middle line */
    double height;  /* of `at`, above the ball's centre up the tool; 0: it is the ball */
    double width;   /* radius of the tool at that height */
    size_t pieces;  /* that are deeper than is allowed */
};

/* With n points of the roof. */
struct under_scan under_scan_find(const struct under_scan_options *options, const struct vec3 *roof,
                                  size_t n);

#endif

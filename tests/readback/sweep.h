/*
 * sweep - two courses walked side by side: how far is one from the other, in order?
 *
 * Both are made into dense chains of poses.  Each pose of the one is looked for on the other, near
 * the place where the pose before it was found: so a block or a pass left out, taken twice,
 * swapped or cut off is a distance, not something that a nearer place elsewhere hides.
 */
#ifndef READBACK_SWEEP_H
#define READBACK_SWEEP_H

#include "simulate/nc_motion.h"
#include "base/error.h"

struct sample {
    struct nc_motion_pose pose;
    bool joined;   /* the tool cuts on its way from the sample before to this one */
    double length; /* of the cut up to here, mm, with the turn of the axis by its weight */
    size_t piece;
};

struct samples {
    size_t n, cap;
    struct sample *item;
    double weight; /* of the axis, mm a radian: what is beside what where the tip hardly moves */
    double radius; /* of the ball, mm: its centre is so far up the tool axis */
};

/* The cutting pieces of a nc_motion, straight between samples to 1e-5 mm and 0.001 degrees, without
 * the ways back down from a turn off the part. */
void sweep_chain(const struct nc_motion *nc_motion, struct samples *chain);

/* Straight cuts one behind the other on a line, with rapids along it between, become one cut: a
 * hole drilled in steps. */
void sweep_join_steps(struct nc_motion *nc_motion);

/* Length of the tip's way, mm. */
double sweep_length(const struct samples *chain);

struct sweep {
    double tip, axis, ball;      /* worst, mm and degrees; of the ball's centre */
    size_t tip_at, tool_axis_at; /* samples of `from` there */
    bool beyond;                 /* some sample is beyond the limits ... */
    size_t first;                /* ... and this is the first */
};

/* Walks all of `from` along `to`. */
struct sweep sweep_walk(const struct samples *from, const struct samples *to, double tip_limit,
                        double axis_limit);

/*
 * The rapid moves: each place that a rapid move of the path ends at must be met by the program's
 * rapid moves in order; further places of the program must lie at the path's greatest height, on
 * the straight way between two such places, or up the tool axis from a cut.
 * -1 with the place that is missing or too many.
 */
int sweep_rapids(const struct nc_motion *program, const struct nc_motion *path, double tip_limit,
                 double axis_limit, struct error *error);

#endif

/*
 * centre_path - where the centre of the tool's ball goes, as straight segments.
 *
 * Lengths in mm.  A motion that tracks the tip has the ball's centre one radius up the tool
 * axis.
 */
#ifndef CLOUDMILL_CENTRE_PATH_H
#define CLOUDMILL_CENTRE_PATH_H

#include "math/box.h"
#include "simulate/nc_motion.h"

struct centre_segment {
    struct vec3 a, b;
    float s[2];     /* of its piece, from 0 to 1 */
    unsigned piece; /* of the motion */
    bool on;        /* the ball touches the part at its middle (set by deviation_map_run) */
};

struct centre_path {
    size_t n, cap;
    struct centre_segment *item;
};

struct centre_path_options {
    double radius;          /* of the ball, mm */
    double flat;            /* segments are so near to where the centre goes, mm, ... */
    const struct box *part; /* ... but far off this, ten of its diagonals, by a hundredth of the
                               rest of that way: a program may go to where there is nothing, in
                               rounds of many metres; NULL: everywhere */
};

/* Appends the segments of one piece. */
void centre_path_piece(const struct nc_motion *motion, size_t piece,
                       const struct centre_path_options *options, struct centre_path *path);

/* All pieces at feed. */
void centre_path_cut(const struct nc_motion *motion, const struct centre_path_options *options,
                     struct centre_path *path);

/* All rapid pieces. */
void centre_path_rapid(const struct nc_motion *motion, const struct centre_path_options *options,
                       struct centre_path *path);

#endif

/*
 * centre_path - where the centre of the tool's ball goes, as straight segments.
 *
 * Lengths in mm.  A motion that tracks the tip has the ball's centre one radius up the tool
 * axis.
 */
#ifndef CLOUDMILL_CENTRE_PATH_H
#define CLOUDMILL_CENTRE_PATH_H

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

/* Appends the segments of one piece, within `flat` mm of where the centre goes. */
void centre_path_piece(const struct nc_motion *motion, size_t piece, double radius, double flat,
                       struct centre_path *path);

/* All pieces at feed. */
void centre_path_cut(const struct nc_motion *motion, double radius, double flat,
                     struct centre_path *path);

/* All rapid pieces. */
void centre_path_rapid(const struct nc_motion *motion, double radius, double flat,
                       struct centre_path *path);

#endif

/*
 * ballpath - where the centre of the tool's ball goes, as straight segments.
 *
 * Lengths in mm.  A course that tracks the tip has the ball's centre one radius up the tool axis.
 */
#ifndef CLOUDMILL_BALLPATH_H
#define CLOUDMILL_BALLPATH_H

#include "simulate/course.h"

struct ball_segment {
    struct vec3 a, b;
    float s[2];     /* of its piece, from 0 to 1 */
    unsigned piece; /* of the course */
    bool on;        /* the ball touches the part half way (set by ballroll_run) */
};

struct ball_path {
    size_t n, cap;
    struct ball_segment *item;
};

/*
 * Appends the segments of one piece, no further than `flat` mm from the way of the centre, and
 * `up` mm further up the tool axis than the centre.
 */
void ballpath_piece(const struct course *course, size_t piece, double radius, double up,
                    double flat, struct ball_path *path);

/* All pieces at feed. */
void ballpath_cut(const struct course *course, double radius, double flat, struct ball_path *path);

/* All rapid pieces, with further balls of the same radius, half a radius apart, over `shank` mm:
 * a shaft as thick as the ball. */
void ballpath_rapid(const struct course *course, double radius, double shank, double flat,
                    struct ball_path *path);

#endif

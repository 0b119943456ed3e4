/*
 * ball - how deep the tool's ball goes into the part along a motion.
 */
#ifndef READBACK_BALL_H
#define READBACK_BALL_H

#include "simulate/nc_motion.h"

/* Distance of a point from the part's surface, mm. */
struct surface {
    double (*distance)(const void *data, struct vec3 p);
    const void *data;
};

struct depth {
    double worst;     /* mm, negative: it never touches */
    struct vec3 ball; /* the ball's centre there */
    size_t piece;
};

/* Along all of the motion, rapid moves too; found to 0.01 mm of way. */
struct depth ball_depth(const struct nc_motion *motion, double radius,
                        const struct surface *surface);

/* Only at the ends of pieces that were given with a contact point. */
struct depth ball_nodes(const struct nc_motion *motion, double radius,
                        const struct surface *surface);

#endif

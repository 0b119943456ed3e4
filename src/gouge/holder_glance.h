/*
 * holder_glance - which guard points may shank and holder come near to on a short motion?  Asked
 * once for the whole of it, not pose by pose: most motions need no more.
 *
 * What is above the ball is a stack of truncated cones, each a convex body, and the signed distance
 * from a convex body is a convex function: it is nowhere less than its tangent plane at one place
 * says.  So a point at distance d with gradient g, seen from the tool in one pose, is clear of it
 * as long as it goes no farther than d against g, seen from there.  A point that passes along the
 * tool costs nothing.
 */
#ifndef CLOUDMILL_HOLDER_GLANCE_H
#define CLOUDMILL_HOLDER_GLANCE_H

#include "curve/motion.h"
#include "gouge/gouge.h"

enum { GLANCE_PARTS = 4, GLANCE_POSES = 2 * GLANCE_PARTS + 1 };

struct holder_glance {
    const struct holder *holder;
    struct pose pose[GLANCE_POSES]; /* at even parameters; p is the centre of the ball */
    double least;                   /* mm: nearer is near */

    /* No place of the holder is farther than this from where it is in the middle of the motion, and
     * of each of its parts, mm. */
    double moved, part_moved;
    /* Between two poses a place beside the holder goes off the straight way from one to the other
     * by no more, aside and along together, mm. */
    double bent;
};

/* Fills in the last three.  How far the motion goes off the straight way between two poses is told
 * by the one in the middle of each part. */
void holder_glance_measure(struct holder_glance *glance);

/* Appends the guard points that may come near. */
void holder_glance_gather(const struct gouge_check *guard, const struct holder_glance *glance,
                          struct vec3s *near);

/* Appends those of the points [from, to) of the same list. */
void holder_glance_choose(const struct holder_glance *glance, size_t from, size_t to,
                          struct vec3s *near);

#endif

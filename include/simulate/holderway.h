/*
 * holderway - shank and holder followed along a course: where do they run into something?
 *
 * The stack is looked at where it stands; as far as it is clear, so far it may move before it has
 * to be looked at again.  Where it is not clear the piece is halved until the depth is known within
 * a tenth, or 0.005 mm, or a quarter of the tolerance; a piece that is known to hit is looked at
 * only for what is deeper than all before it.  Lengths in mm.
 */
#ifndef CLOUDMILL_HOLDERWAY_H
#define CLOUDMILL_HOLDERWAY_H

#include "simulate/course.h"
#include "simulate/obstacle.h"

struct holderway {
    /* set by the caller */
    const struct course *course;
    const struct holder *holder;
    struct obstacle *obstacle;
    double radius;    /* of the ball */
    double tolerance; /* that it may be deep without being told */
    /* found so far */
    double depth; /* the deepest, above tolerance; 0: clear */
    size_t piece; /* there */
    struct vec3 at;
    size_t pieces; /* that are deeper than the tolerance */
    /* while it goes */
    double budget; /* how far the stack may move before it has to be looked at */
    bool known;    /* `last` holds */
    struct course_pose last;
    bool hit; /* this piece is one of `pieces` */
};

/* Follows one piece; pieces come in their order, those between may be left out. */
void holderway_piece(struct holderway *way, size_t piece);

#endif

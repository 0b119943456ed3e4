/*
 * holder_collision - shank and holder followed along a nc_motion: where do they run into something?
 *
 * The stack is looked at where it stands; as far as it is clear, so far it may move before it has
 * to be looked at again.  Where it is not clear the piece is halved until the depth is known within
 * a tenth, or 0.005 mm, or a quarter of the tolerance; a piece that is known to hit is looked at
 * only for what is deeper than all before it.  Lengths in mm.
 */
#ifndef CLOUDMILL_HOLDER_COLLISION_H
#define CLOUDMILL_HOLDER_COLLISION_H

#include "simulate/nc_motion.h"
#include "simulate/collision_body.h"

struct holder_collision {
    /* set by the caller */
    const struct nc_motion *nc_motion;
    const struct holder *holder;
    struct collision_body *obstacle;
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
    struct nc_motion_pose last;
    bool hit; /* this piece is one of `pieces` */
};

/* Follows one piece; pieces come in their order, those between may be left out. */
void holder_collision_piece(struct holder_collision *way, size_t piece);

#endif

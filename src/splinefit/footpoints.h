/*
 * footpoints - the foot points of a target's places on a curve, followed while the curve moves, and
 * how far the curve is from them.
 */
#ifndef CLOUDMILL_FOOTPOINTS_H
#define CLOUDMILL_FOOTPOINTS_H

#include "ppform.h"
#include "target.h"

enum { FOOTPOINT_KINDS = 3 };

/* The curve at a foot. */
struct footpoint {
    size_t span;
    double u;
    struct vec3 off;   /* from the place to the curve, mm */
    struct vec3 along; /* unit: its direction */
    struct vec3 axis;  /* unit, with a turning axis only */
    double reach;      /* and from the point to the head, mm */
};

struct footpoints {
    double *u; /* of the tracked point */
    double *v; /* of the other end of the radius; NULL with a fixed axis */
    double
        *off; /* for each place, FOOTPOINT_KINDS (with a fixed axis 1) in turn: distance of the
                 point, distance of the other end, angle of the axis times tolerance / angle, mm */
    struct footpoint *point, *other; /* at u and v, as they were last followed to */
    double worst;                    /* the largest of `off`, mm */
    size_t where;                    /* and its place */
};

/* How many distances each place has. */
size_t footpoints_kinds(const struct target *target);

struct footpoints footpoints_new(const struct target *target);
void footpoints_free(struct footpoints *feet);

/* Copies where the feet stand, u and v, and the largest distance; not what is to be found there. */
void footpoints_copy(struct footpoints *to, const struct footpoints *from,
                     const struct target *target);

/*
 * Newton's steps from the feet as they are (at most half a span each, so that no foot jumps to
 * another branch; until they are small against the distance), then the distances.
 */
void footpoints_follow(const struct ppform *form, const struct target *target,
                       struct footpoints *feet);

#endif

/*
 * feet - the foot points of a target's places on a curve, followed while the curve moves, and how
 * far the curve is from them.
 */
#ifndef CLOUDMILL_FEET_H
#define CLOUDMILL_FEET_H

#include "spanform.h"
#include "target.h"

enum { FEET_KINDS = 3 };

/* The curve at a foot, as the two points and the axis, with derivatives of the two points. */
struct stance {
    size_t span;
    struct vec3 point, speed, bend; /* of the tracked point, and its derivatives */
    struct vec3 reach;              /* head - point */
    struct vec3 other, other_speed;
    struct vec3 axis;
};

struct feet {
    double *u;   /* of the tracked point */
    double *v;   /* of the other end of the radius; NULL with a fixed axis */
    double *off; /* for each place, FEET_KINDS (with a fixed axis 1) in turn: distance of the point,
                    distance of the other end, angle of the axis times tolerance / angle, mm */
    double worst; /* the largest of these, mm */
    size_t where; /* and its place */
};

/* How many distances each place has. */
size_t feet_kinds(const struct target *target);

struct feet feet_new(const struct target *target);
void feet_free(struct feet *feet);
void feet_copy(struct feet *to, const struct feet *from, const struct target *target);

struct stance stance_at(const struct spanform *form, const struct target *target, size_t near,
                        double u);

/*
 * Newton's steps from the feet as they are (at most half a span each, so that no foot jumps to
 * another branch), then the distances.
 */
void feet_follow(const struct spanform *form, const struct target *target, struct feet *feet);

#endif

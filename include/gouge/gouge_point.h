/*
 * gouge_point - contact points made clear of the part one by one, and those between two of them
 * that straight lines need.
 */
#ifndef CLOUDMILL_GOUGE_POINT_H
#define CLOUDMILL_GOUGE_POINT_H

#include "curve/tool_axis.h"
#include "gouge/gouge.h"
#include "curve/run.h"

struct gouge_lift_options {
    const struct gouge_check *guard; /* NULL: nothing is lifted */
    double offset;                   /* of the centre from the part, mm */
    double limit;                    /* highest lift, mm */
    bool between;                    /* put points between those that are given */
    double tolerance;                /* of straight lines against the curve and the part, mm */
    double step;                     /* no points nearer than this are put between, mm */
    double stands;                   /* what may stand under a ball that was lifted, mm */
    struct tool_axis_options axis;
    struct tool_axis_feed feed;
};

/* A point with what became of it. */
struct gouge_point {
    struct run_point p;   /* its normal as it was */
    struct vec3 touching; /* the centre before the lift */
    bool missed;          /* no lift within the limit clears it, or no tool from outside comes to
                             it: it is straight up in z as far as it takes */
    struct kdtree_touch touch; /* what stopped the ball */
};

struct gouge_points {
    size_t n, cap;
    struct gouge_point *item;
};

/* Puts the centre of a point where it is said, the axis as the rule says for there, and the tip by
 * the ball's radius. */
void gouge_point_place(struct run_point *p, struct vec3 centre,
                       const struct gouge_lift_options *rule, double radius);

/* A contact point with its normal, lifted.  `touch`: guard points likely to be in its way. */
struct gouge_point gouge_point_from(const struct run_point *p, const struct kdtree_touch *touch,
                                    const struct gouge_lift_options *rule, double radius);

/* Half way between two, lifted itself. */
struct gouge_point gouge_point_halfway(const struct gouge_point *a, const struct gouge_point *b,
                                       const struct gouge_lift_options *rule, double radius);

/* The ball goes no deeper than the tolerance on the straight line between two points where it is
 * clear. */
bool gouge_point_clear(const struct run_point *a, const struct run_point *b,
                       const struct gouge_lift_options *rule);

/* Nothing comes between them, for where they would touch they are nearer than two steps. */
bool gouge_point_near(const struct gouge_point *a, const struct gouge_point *b,
                      const struct gouge_lift_options *rule);

/* Appends the points between a and b that straight lines need, to stay within the tolerance of what
 * is lifted half way, or under it where the ball is clear there. */
void gouge_point_between(const struct gouge_point *a, const struct gouge_point *b,
                         const struct gouge_lift_options *rule, double radius,
                         struct gouge_points *to);

#endif

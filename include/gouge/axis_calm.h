/*
 * axis_calm - the tool axes of runs that are cut one after the other, made alike where one ends and
 * the next begins, and calm all along: so that links do not turn what the runs do not need.
 *
 * The angles of a machine's rotary axes are averaged along the chain of runs, over lengths that
 * become smaller, as far as each axis stays near its rule or no further off it than it was, to its
 * side of the pole, and the whole tool clear, at all points and on the straight lines between;
 * beside places where it would not be, axes stay as they were, and are then eased as far as they
 * are clear (axis_chain.h).
 */
#ifndef CLOUDMILL_AXIS_CALM_H
#define CLOUDMILL_AXIS_CALM_H

#include "curve/run.h"
#include "gouge/gouge.h"
#include "machine/kinematics.h"

struct axis_calm_options {
    const struct gouge_check *guard;
    const struct holder *holder;
    struct kinematic_chain chain; /* of two axes */
    double radius;                /* of the ball, mm */
    double tolerance; /* half of it a guard point may be in the tool, and a tenth of it a tip that
                         goes straight may swing the ball off a straight line, mm */
    double inward;    /* how far rules may lean near a run's ends (axis_smooth_rules), radians */
    int threads;      /* that work on a chain; 0: as many as there are processors */
};

/* A run, end to end with those before and after it. */
struct axis_calm_run {
    struct run_point *point;
    const struct vec3 *rule; /* the axis by the rule at each point; NULL: a link, which has none */
    size_t n;                /* at least 1 */
    double play;             /* how far an axis may be off its rule, radians */
    bool joined;             /* a straight motion leads to it from the run before */
};

/* Changes axes and tips of the points. */
void axis_calm_chain(const struct axis_calm_options *options, const struct axis_calm_run run[],
                     size_t n);

#endif

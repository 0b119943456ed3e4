/*
 * axis_plan - the tool axes of a run, chosen over the run as a whole: where the tool is clear, near
 * the rule of the axis, with as little motion of a machine's rotary axes as that allows.
 *
 *   1  nodes along the path of the ball's centre, no more than NODES apart, and at each of them the
 *      open directions (access.h) that the machine reaches, and the axis by the rule if it is open
 *   2  dynamic programming over the nodes: a direction costs by how far it is off the rule, little
 *      within `play`, much beyond; a step to a neighbouring direction costs what the rotary axes
 *      turn (rotary_cost.h)
 *   3  the angles of the rotary axes are averaged along the run over lengths that become smaller,
 *      each as far as its direction stays open and as near to the rule as in 2
 *   4  the points of the run get the axes of the nodes, and there are points between where the axis
 *      bends there; the tool is checked at all points and on the straight lines between; where it
 *      is not clear nodes are added, and all begins again
 *
 * A place that no direction reaches is told, and not cut.
 */
#ifndef CLOUDMILL_AXIS_PLAN_H
#define CLOUDMILL_AXIS_PLAN_H

#include "curve/run.h"
#include "gouge/gouge.h"
#include "machine/kinematics.h"

struct axis_planner_options {
    const struct gouge_check *guard; /* NULL: nothing is in the way */
    double radius;                   /* of the ball, mm */
    struct holder holder;            /* flute, shank and holder above the ball */
    struct kinematic_chain chain;    /* of the machine; of one axis, which is across the tool:
                                        the directions of a circle; none: the rule's alone */
    double tolerance; /* half of it a guard point may be in the tool, and a tenth of it a tip that
                         goes straight may swing the ball off a straight line, mm */
    bool between;     /* points may be put between those of a run */
    bool fixed;       /* the rule's axis is taken where it is clear, with no margin */
    double play;      /* how far axes may be off their rule to turn less, radians */
    double limit;     /* and how far to be clear, radians */
    double inward;    /* and how far rules may lean near a run's ends (axis_smooth_rules) */
    int threads;      /* 0: as many as there are processors */
};

struct axis_planner;
struct axis_planner *axis_planner_new(const struct axis_planner_options *options);
void axis_planner_free(struct axis_planner *planner);

/* Runs from now on have this play, radians. */
void axis_planner_play(struct axis_planner *planner, double play);

/* What becomes of a point: it is cut, from the point before; the tool has to be lifted before it;
 * no axis reaches it. */
enum axis_plan_state { AXIS_PLAN_CUT, AXIS_PLAN_BREAK, AXIS_PLAN_SKIP };

/* Runs with their axes planned, end to end.  Starts as all zero. */
struct axis_plan {
    struct run run;
    struct ints state; /* enum axis_plan_state of each point of the run */
    double leaned;     /* how far an axis is off its rule at most, radians */
};

void axis_plan_free(struct axis_plan *plan);

/* Appends the points of a run, whose axes are those of the rule. */
void axis_plan_run(const struct axis_planner *planner, const struct run *run,
                   struct axis_plan *plan);

#endif

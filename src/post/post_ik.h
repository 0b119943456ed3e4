/*
 * post_ik - from a pose of the path to the words that bring the machine there.
 */
#ifndef CLOUDMILL_POST_IK_H
#define CLOUDMILL_POST_IK_H

#include "post_planner.h"

/* The words of a pose with the rotary axes at q (radians). */
struct machine_pose post_ik_pose(const struct nc_planner *planner, struct pose to,
                                 const double q[]);

/*
 * The words that reach a pose from where the program stands, s (0 to 1) along the next motion: with
 * the angles that the planner aims at, else the nearest.  -1 with the error filled and the plan
 * unmet: the rotary or the linear axes would leave their travel.
 */
int post_ik_reach(struct nc_planner *planner, struct pose to, double s,
                  struct machine_pose *target);

/*
 * Its usual case: the rotary axes go on beside where they stand (ik_near).  The travel of the
 * linear axes is the caller's to check.  *off: how far the printed digits are off the pose, at the
 * tracked point and, as a chord, at the tool axis.  False: nothing is done.
 */
bool post_ik_reach_near(const struct nc_planner *planner, const struct pose *to,
                        struct machine_pose *target, struct pose_deviation *off);

/* How far a tool axis may be off the singular direction to be said as it, radians; 0: it may not.
 */
double post_ik_near_pole(const struct nc_planner *planner);

/* The tool axis is so near to the singular direction that it is said as that, and turns no axis. */
bool post_ik_says_pole(const struct nc_planner *planner, struct vec3 axis);

/*
 * Where between s0 and s1 a straight motion or an arc comes so near to the singular direction that
 * it may as well go through it, by what is allowed; s1: nowhere, or one of its ends is said as it.
 * Vectors alone: there the control would turn an axis half about in a place, and post_ik_reach says
 * the singular direction instead.
 */
double post_ik_pole_between(const struct nc_planner *planner, const struct motion *motion,
                            double s0, double s1);

/* The angles of the axis nearest to `from`, whatever the travel; false: there are none. */
bool post_ik_nearest(const struct kinematic_chain *chain, struct vec3 axis, const double from[],
                     double q[]);

/* Degrees: an angle that is beyond the end of its travel by less is at the end. */
#define POST_IK_AT_END 1e-4

/*
 * A motion at feed from s0, where the program is, to `to` at s1: where vectors leave the rotary
 * axes to the control, these go on with the tool from where they stand, beside the singular
 * direction by far more than it turns; `to` gets the angles that they come to.  False: they would
 * leave their travel on the way.  With rotary words nothing is changed, and true.
 */
bool post_ik_follow(const struct nc_planner *planner, const struct motion *motion, double s0,
                    double s1, struct machine_pose *to);

/* How far from 0 a tip may be for the linear axes to keep their travel however the rotary axes
 * stand: a turn about c takes p no further from 0 than |p| + 2 |c|. */
double post_ik_safe_radius(const struct machine *m);

/* A linear axis of X, Y, Z that is out of its travel there, by more than half of the last digit
 * that is printed; -1: none. */
int post_ik_out_of_travel(const struct nc_planner *planner, const double at[3]);

/* The same when the tip is there. */
int post_ik_linear_over(const struct nc_planner *planner, struct vec3 tip, const double q[]);

/* -1, the error filled and the plan unmet: `what` names the value, as "a position of". */
int post_ik_tell_over(struct nc_planner *planner, struct vec3 tip, int axis, const char *what,
                      double value);

/* -1: the linear axes, as they stand when the tip is there (seen from the work offset), would
 * leave their travel. */
int post_ik_check_linear(struct nc_planner *planner, const struct machine_pose *to);

/* The same between s0 and s1 of an arc or a curve, which bulge beyond their ends. */
int post_ik_check_between(struct nc_planner *planner, const struct motion *motion, double s0,
                          double s1);

/*
 * The chain with the tool of this number: where the machine file has lengths of tools, the centres
 * of heads are seen from the spindle's nose, and the tool's length (mm; the chain's unit is `unit`
 * mm) is added along the tool.  False: it has lengths, but not of this tool.
 */
bool post_ik_chain(const struct machine *machine, int tool, double unit,
                   struct kinematic_chain *chain);

#endif

/*
 * rotary_cost - how far the rotary axes of a machine turn from one direction of the tool axis to
 * the next.
 *
 * Whatever the machine, one of its rotary axes sets how far the tool axis leans from the machine's
 * Z and one in which direction (A or B, and C): so far does each of them turn.  Every lean has two
 * solutions, to one side and, half a turn further, to the other; the one with the shorter travel
 * counts.
 */
#ifndef CLOUDMILL_ROTARY_COST_H
#define CLOUDMILL_ROTARY_COST_H

#include "curve/tool_axis.h"
#include "machine/kinematics.h"

/* How far both rotary axes together turn between two unit vectors, radians. */
double rotary_travel(struct vec3 from, struct vec3 to);

/* An axis and how far it leans from Z, for one that is asked about many times; the travel between
 * two by the shorter of the two ways, and by that with the solution of the same side alone. */
struct rotary_leaning {
    struct vec3 axis;
    double lean; /* radians */
};
struct rotary_leaning rotary_leaning_of(struct vec3 axis);
double rotary_leaning_travel(const struct rotary_leaning *from, const struct rotary_leaning *to);
double rotary_leaning_travel_one(const struct rotary_leaning *from,
                                 const struct rotary_leaning *to);

/* The same for a chain of two axes whose one nearest the work turns about `pole`: there it has no
 * direction.  `both`: its travel has both solutions, so that a way through the pole turns
 * nothing. */
struct rotary_frame {
    struct vec3 x, y, pole;
    bool both;
};

/* Of one axis it is the pole; Z and both for none. */
struct rotary_frame rotary_frame_of(const struct kinematic_chain *chain);

/* The axes that a chain of one rotary axis has, where that is across the tool; else no circle. */
struct axis_circle rotary_circle(const struct kinematic_chain *chain);

/* The angle off the pole, and the direction there, radians. */
struct rotary_angles {
    double lean, turn;
};

/* The angles of an axis that are nearest to others: of either solution, if there are both, and any
 * whole turn.  At the pole the turn stays. */
struct rotary_angles rotary_angles_near(const struct rotary_frame *frame, struct vec3 axis,
                                        struct rotary_angles to);
struct vec3 rotary_axis(const struct rotary_frame *frame, struct rotary_angles angles);

/* The angles at s, 0 to 1, of a way between two: the lean goes evenly, and so does the turn, unless
 * the way leads past the pole; then it turns the less the nearer it is to it. */
struct rotary_angles rotary_angles_between(struct rotary_angles from, struct rotary_angles to,
                                           double s);

/* Where the way is at the pole, between 0 and 1; -1: nowhere. */
double rotary_pole_between(struct rotary_angles from, struct rotary_angles to);

/* True if the chain has the direction within its travel: one without rotary axes that of its tool
 * alone, which matters where an axis is to be fixed. */
bool rotary_reaches(const struct kinematic_chain *chain, struct vec3 axis);

/* True if no travel is in the way of the direction: the same, but of a chain without rotary axes,
 * for of these nothing is known then, any direction. */
bool rotary_allows(const struct kinematic_chain *chain, struct vec3 axis);

/* What rotary_reaches says for all directions between two, on the great circle: looked at every
 * degree, and of a turn of less at each quarter; where one solution ends and the other begins, more
 * closely.  A chain of no axes: true. */
bool rotary_reaches_between(const struct kinematic_chain *chain, struct vec3 from, struct vec3 to);

enum { ROTARY_LEAN_DIRECTIONS = 24 };

/* How many leans rotary_lean knows from `least` to `most` radians off the normal. */
int rotary_leans(double least, double most);

/* Number i of them, 0 <= i < rotary_leans(): lead and tilt of the rule, so that the axis is off the
 * normal by least, or in even steps up to most, in each of ROTARY_LEAN_DIRECTIONS. */
struct tool_axis_options rotary_lean(double least, double most, int i);

#endif

/*
 * ik_choose - of the angles that have a direction, those to go to from where the rotary axes
 * stand.
 */
#ifndef CLOUDMILL_IK_CHOOSE_H
#define CLOUDMILL_IK_CHOOSE_H

#include "machine/kinematics.h"

/* What a turn of the i-th axis counts beside one of the slowest: by the time that it takes, where
 * the axes' speeds are known; else all count alike. */
double ik_weight(const struct kinematic_chain *chain, int i);

/* How far the axes turn from a to b, all together, by these weights. */
double ik_travel(const struct kinematic_chain *chain, const double a[], const double b[]);

/* How far the axis that turns most turns from a to b, radians. */
double ik_most_turn(const struct kinematic_chain *chain, const double a[], const double b[]);

/*
 * Of the solutions turned by whole turns into the travel, the one to go to from the angles `from`:
 * the smallest move of the master axis, then of the other, then nearest to zero.  With `smooth`
 * the shortest ik_travel instead, then as before.  `only` 0 or 1
 * allows that solution alone, -1 both.  A free axis stays as it is.  -1 when none is within the
 * travel; *over is then the axis that is over (-1: the chain cannot reach the direction).
 */
int ik_choose(const struct kinematic_chain *chain, struct vec3 axis, const double from[],
              bool smooth, int only, double q[], int *over);

#endif

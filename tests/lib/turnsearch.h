/* turnsearch - the shortest way of rotary axes through given directions, by trying, for unit tests.
 */
#ifndef CLOUDMILL_TEST_TURNSEARCH_H
#define CLOUDMILL_TEST_TURNSEARCH_H

#include "machine/kinematics.h"

enum { ANGLES = 40 };

struct angles {
    int n;
    double q[ANGLES][2];
};

/* All angles within the travel that bring the tool to the direction, up to two turns from zero: by
 * Newton's method from many starts. */
struct angles angles_all(const struct kinematic_chain *chain, struct vec3 axis);

/* How far both axes turn, each by the time that it needs beside the slower one. */
double angles_way(const struct kinematic_chain *chain, const double a[], const double b[]);

/* The fewest turns back from `from` through n directions, and the shortest way with so many; a step
 * without a turn is less than a right angle.  -1: no way. */
int angles_least(const struct kinematic_chain *chain, const struct vec3 axis[], int n,
                 const double from[], double *way);

#endif

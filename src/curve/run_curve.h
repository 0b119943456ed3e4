/*
 * run_curve - the smooth curve from one point of a run to the next: the cubic Hermite curve of the
 * centre and of the axis, and the tip that follows from both.
 */
#ifndef CLOUDMILL_RUN_CURVE_H
#define CLOUDMILL_RUN_CURVE_H

#include "curve/run.h"

/* What it starts or ends with. */
struct run_curve_end {
    const struct run_point *point;
    struct vec3 tangent; /* of the ball's path, unit */
    struct vec3 turn;    /* derivative of the axis by the length of that path, 1/mm */
};

struct run_curve {
    const struct run_point *a, *b;
    struct vec3 va, vb; /* derivatives of the centre at its ends, mm */
    struct vec3 wa, wb; /* derivatives of the axis */
    bool great_circle;  /* that has the axis instead of these: its ends are more than 60 degrees
                           apart */
};

struct run_curve run_curve_between(struct run_curve_end a, struct run_curve_end b);

/* At t in [0, 1]; with normal and contact where both ends have them.  `radius` of the ball, mm. */
struct run_point run_curve_at(const struct run_curve *c, double t, double radius);

/*
 * Appends as many points, and its end, that straight lines from its start on stay within `chord` mm
 * of it at the tip and the centre.  Returns how far the straight line from its start to its end is
 * off.
 */
double run_curve_densify(const struct run_curve *c, double chord, struct run *dense);

#endif

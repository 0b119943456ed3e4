/*
 * knots_step - Gauss-Newton steps of a B-spline's poles and inner knots together.
 *
 * What is to become small is the sum of off^power over all places of a target, off the distance at
 * the foot points (residual.h).
 */
#ifndef CLOUDMILL_KNOTS_STEP_H
#define CLOUDMILL_KNOTS_STEP_H

#include "math/band.h"
#include "footpoints.h"

struct knots_step {
    size_t unknowns;
    size_t *pole;       /* the first of its `width` unknowns; inner poles only */
    size_t *knot;       /* the unknown of a knot; inner knots only */
    struct band normal; /* the normal equations, undamped */
    struct band factor;
    double *right, *step; /* their right-hand side, their solution */
    double *scale;        /* what the damping of each unknown is measured by */
    double *moments;      /* of all spans (span_moments.h) */
};

/* For curves of this degree, number of poles, and with a head or without. */
struct knots_step knots_step_new(const struct bspline *curve);
void knots_step_free(struct knots_step *s);

/* Sets up the equations, at feet that were followed on the curve of `form`.  `power` is even. */
void knots_step_equations(struct knots_step *s, const struct ppform *form,
                          const struct target *target, const struct footpoints *feet, int power);

/*
 * Solves them with `damping` times the diagonal added (Marquardt) and moves poles and knots of
 * `from` to those of *to.  False when that can not be, or when inner knots would come nearer to
 * each other than a fifth of what they were, or than `nearest`.
 */
bool knots_step_move(struct knots_step *s, double damping, double nearest,
                     const struct bspline *from, struct bspline *to);

#endif

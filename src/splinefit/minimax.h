/*
 * minimax - a B-spline's poles and inner knots moved until its largest distance from a reference is
 * small enough, or as small as it gets.
 */
#ifndef CLOUDMILL_MINIMAX_H
#define CLOUDMILL_MINIMAX_H

#include "footpoints.h"
#include "math/band.h"

/*
 * Gauss-Newton steps of poles and inner knots together.  What is to become small is the sum of
 * off^power over all places of a reference, off the distance at the foot points (footpoints.h).
 */
struct knots_step {
    size_t unknowns;
    size_t *pole;       /* the first of its `width` unknowns; inner poles only */
    size_t *knot;       /* the unknown of a knot; inner knots only */
    struct band normal; /* the normal equations, undamped */
    struct band factor;
    double *right, *step; /* their right-hand side, their solution */
    double *scale;        /* what the damping of each unknown is measured by */
    double *moments;      /* of all spans (span_moments_size) */
};

/* For curves of this degree, number of poles, and with a head or without. */
struct knots_step knots_step_new(const struct bspline *curve);
void knots_step_free(struct knots_step *s);

/* Sets up the equations, at feet that were followed on the curve of `form`.  `power` is even. */
void knots_step_equations(struct knots_step *s, const struct ppform *form,
                          const struct reference *places, const struct footpoints *feet, int power);

/*
 * Solves them with `damping` times the diagonal added (Marquardt) and moves poles and knots of
 * `from` to those of *to.  False when that can not be, or when inner knots would come nearer to
 * each other than a fifth of what they were, or than `nearest`.
 */
bool knots_step_move(struct knots_step *s, double damping, double nearest,
                     const struct bspline *from, struct bspline *to);

/* A curve and the feet of places of a reference on it. */
struct candidate {
    struct bspline curve;
    struct footpoints feet;
};

/* Least squares on these knots (0 to the length of the places, of which the candidate gets a copy),
 * with the places at the parameters u; `within` is what they may be off.  False when the places do
 * not determine the poles. */
bool candidate_new(const struct reference *places, const struct deviation *within,
                   const struct bspline *form, const double *knot, const double *u,
                   struct candidate *candidate);

struct candidate candidate_copy(const struct candidate *candidate, const struct reference *places);
void candidate_free(struct candidate *candidate);

/* The same curve with the feet of other places of the same reference, still to be followed; the
 * worst place stays.*/
struct candidate candidate_onto(const struct candidate *candidate, const struct reference *from,
                                const struct reference *to);

/*
 * Levenberg's and Marquardt's steps for the sum of the distances to the power 2, 4, 8 ... 64, until
 * no place is off by more than `goal` mm (true).  False as soon as that is out of reach: the
 * distances' mean by the norm is never above the largest one, so that a minimum of it above `goal`
 * is the end of it.  Each step takes its number of distances from *effort; false when that is used
 * up. More patience than 1 takes that many times the steps.
 */
bool minimax_fit(const struct reference *places, double goal, int patience,
                 struct candidate *candidate, double *effort);

#endif

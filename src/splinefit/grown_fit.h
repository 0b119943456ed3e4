/*
 * grown_fit - B-splines through the same places by least squares, one after the other with knots
 * that are mostly those of the one before, and how far each of their spans is off.
 *
 * What a span adds to the normal equations depends on the knots about it alone and is kept as long
 * as these stay; what it is off is kept as long as its poles stay, too, but for a 100,000th of the
 * tolerance.  So a knot that is taken out costs the spans about it, and the others no more than
 * their equations' solution.
 */
#ifndef CLOUDMILL_GROWN_FIT_H
#define CLOUDMILL_GROWN_FIT_H

#include "splinefit/splinefit.h"

/* What is known of the spans of a curve. */
struct grown_spans {
    size_t n;
    size_t *end;  /* behind the last item that belongs to a span: a place, or a middle after one */
    double *item; /* its sums, its poles when it was measured, and what it was off */
};

struct grown_fit {
    const struct reference *reference;
    const struct vec3 *head; /* at its points; NULL: the axis is fixed */
    double tolerance, angle;
    bool between; /* it is measured between its places, too */

    struct bspline curve;
    double *off; /* by span of the curve, in parts of the tolerance; free to be written to */

    struct grown_spans known, next; /* of the curve's spans, and of those to come */
    double *basis;                  /* what is not zero, by item */
};

/* Room for curves of as many poles as there are places; the curve is empty. */
struct grown_fit grown_fit_new(const struct reference *reference, const struct vec3 *head,
                               int degree);
void grown_fit_free(struct grown_fit *fit);

/*
 * Fits and measures the curve with these inner knots, rising: lengths of the reference.  The
 * largest figure in fit->off; infinite when the places do not determine a curve.  A figure above
 * `enough` may be less than it should be.
 */
double grown_fit_knots(struct grown_fit *fit, const double *inner, size_t n, double enough);

#endif

/*
 * grown_knots - a B-spline by least squares whose knots stand where the data asks for them, found
 * in a time that is linear in the data: for paths of so many points that free_knots.h has little
 * time for each, and for data whose noise it would follow until its time is up.
 *
 * From few knots on, each span that is off by more than the tolerance is divided, until none is.
 * Then those knots are taken out that the curve can do without, a third of them at a time: each
 * pass takes out what is missed least and stands apart, and puts back what turns out to be needed.
 */
#ifndef CLOUDMILL_GROWN_KNOTS_H
#define CLOUDMILL_GROWN_KNOTS_H

#include "free_knots.h"

/*
 * The parameters of the points are the lengths of the reference. `before`: a curve for nearly the
 * same data, from whose knots it begins, or NULL; of these only the ones near to what has moved
 * (options->moved) are tried to be taken out: the others were needed before. Nothing is found where
 * it would take as many poles as there are points. No knots are nearer to each other than
 * options->least unless the tolerance needs it: then they come closer, seven tenths each time that
 * no curve is found, down to 0.02 mm. `known` and `work` of the options are not looked at.
 */
struct free_knots_result grown_knots_fit(const struct reference *reference,
                                         const struct free_knots_options *options,
                                         const struct bspline *before);

#endif

/*
 * approximate - curves and surfaces that are given by a function as cubic splines: offsets, and
 * curves in the parameters of a surface brought into space.
 *
 * The function is interpolated at the Greville abscissae of cubic splines (de Boor, A Practical
 * Guide to Splines, chapter XIII), on knots that are doubled until the middles between the
 * abscissae agree with it within the tolerance, or the knots are APPROXIMATE_MOST.
 */
#ifndef CLOUDMILL_APPROXIMATE_H
#define CLOUDMILL_APPROXIMATE_H

#include "nurbs/nurbs.h"

/* Spans of a curve, and of a surface in each direction, at most; four between two places that are
 * given there always are. */
enum { APPROXIMATE_MOST = 4096, APPROXIMATE_MOST_2 = 512 };

typedef struct vec3 approximate_curve_fn(const void *context, double t);

/* The function over at[0..n], rising; it may have kinks at these places.  `error` gets the largest
 * difference that was seen (or NULL).  The caller frees the curve. */
struct nurbs_curve approximate_curve(approximate_curve_fn *f, const void *context, const double *at,
                                     size_t n, double tolerance, double *error);

/* By the size of a surface: how near its offset is approximated, where the knots suffice. */
#define APPROXIMATE_OFFSET 1e-9

/* The surface that lies `distance` mm off another one along its normals, with the same parameters
 * and range; `error` as above. */
struct nurbs approximate_offset(const struct nurbs *surface, double distance, double *error);

#endif

/*
 * flatten - a B-spline motion as straight pieces that provably stay within a chord error.
 *
 * The motion has two points to look at: the one that the curve's poles stand for (the tracked
 * point, as a rule the tool tip), and another one on the tool's axis, `offset` mm further up (from
 * the tip to the ball's centre: its radius; 0: there is none).
 */
#ifndef CLOUDMILL_FLATTEN_H
#define CLOUDMILL_FLATTEN_H

#include "base/array.h"
#include "curve/bspline.h"
#include "math/vec.h"

/* The vertices: parameter, tracked point, the other point, unit axis. */
struct flat {
    struct doubles u;
    struct vec3s point, other, axis;
};

/*
 * Appends the curve's start and the ends of its pieces to `flat`.  In each span the number of
 * pieces follows from bounds of the second derivatives, |C - chord| <= h^2 / 8 max |C"|, taken from
 * the derivatives' own poles, for the point and for the other one.  `axis`: of a curve without
 * head.  False when a pole or knot is not finite, when the head comes nearer to the tracked point
 * than half its length, or when a span needs more than PIECES_MAX pieces.
 */
bool flatten(const struct bspline *curve, double offset, struct vec3 axis, double chord,
             struct flat *flat);

void flat_free(struct flat *flat);

#endif

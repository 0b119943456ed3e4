/*
 * cone_tip - the tip of a cone, round or not, that a scan has no point on: where straight lines
 * down the surface, continued, meet.
 *
 * About the axis of the cone, r and t from the tip across it:
 *   w = h - r (a0 + a1 cos t + b1 sin t + ... + a3 cos 3t + b3 sin 3t) - c r^2
 * by least squares; where the tip is across the axis, by a search.
 */
#ifndef CLOUDMILL_CONE_TIP_H
#define CLOUDMILL_CONE_TIP_H

#include "math/quadric.h"

enum { CONE_TERMS = 9 };

struct cone_tip {
    struct quadric frame; /* origin: of the search; the tip is over u, v of the origin */
    double u, v;
    double c[CONE_TERMS]; /* h, a0, a1, b1, a2, b2, a3, b3, c */
    double rms;           /* of the points' distances, for those that the fit leaves free, mm */
    double worst;         /* of them, mm */
    double reach;         /* the points go round the tip so far, mm across the axis */
};

/*
 * The cone through n points, no more than CONE_POINTS, the first of them the highest.  -1: none
 * whose points are off it by less than `rms` on average and all round its tip, and that is
 * pointed: two lines opposite each other make a corner of more than 20 degrees.
 */
enum { CONE_POINTS = 256 };
int cone_tip_fit(const struct vec3 *point, size_t n, double rms, struct cone_tip *tip);

/* The place r from the tip across the axis, in direction t (radians). */
struct vec3 cone_tip_at(const struct cone_tip *tip, double r, double t);

#endif

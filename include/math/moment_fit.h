/*
 * moment_fit - the quadric and the cubic about a place of a scan, both from one set of sums.
 *
 * The points within a ball about the place are gone through once, in the order of the scan's cells,
 * and their moments u^i v^j (i + j <= 6), u^i v^j w (i + j <= 3) and w^2 added up, in the frame of
 * a guessed normal and about the place itself, so that no digits are lost far from the origin of
 * coordinates.  The first six rows of Cholesky's factor of the cubic's normal equations are the
 * factor of the quadric's: so both surfaces, and what each leaves of the heights, follow from the
 * sums without another look at the points.
 *
 * It is the first round of a fit: points that it does not explain are for a robust second one
 * (quadric.h, surface_fit.h).
 */
#ifndef CLOUDMILL_MOMENT_FIT_H
#define CLOUDMILL_MOMENT_FIT_H

#include "math/point_grid.h"
#include "math/quadric.h"

enum { MOMENT_FIT_LEAST = 16, MOMENT_FIT_MOST = 1024 }; /* points */

struct moment_fit {
    struct quadric quadric, cubic; /* origin: the place */
    double quadric_spread;         /* of the points about each, for their freedom, along w, mm */
    double cubic_spread;
    double lean; /* of the points' middle from the place, in radii: 0.42 at a straight border */
    size_t n;    /* points */
};

/* The radius of a ball that holds about k points of a surface with this normal, where they are
 * `spacing` apart seen from above. */
double moment_fit_radius(double k, double spacing, struct vec3 normal);

/* The surfaces through the points within `radius` of the place, their w axis along `guess` (unit)
 * or, where they lean much against that, along the cubic's own normal.  -1: fewer points than
 * MOMENT_FIT_LEAST or more than MOMENT_FIT_MOST, or they carry no cubic. */
int moment_fit_ball(const struct point_grid *scan, struct vec3 place, struct vec3 guess,
                    double radius, struct moment_fit *fit);

/* Of the two the one whose normal is likely to be nearer to the truth: a cubic's is more uncertain,
 * through noise, and a quadric's is off where the surface is none. */
const struct quadric *moment_fit_better(const struct moment_fit *fit);

/* Spread of the points about that. */
double moment_fit_spread(const struct moment_fit *fit);

#endif

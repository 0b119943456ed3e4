/*
 * height_fit - a bicubic B-spline surface as heights over a rectangle, by least squares (Bradley
 * and Vickers 1993, Park and Kim 1995, as paper 1 reviews them; Piegl and Tiller, The NURBS Book,
 * 9.4).
 *
 * Over parameters that are places x, y of the plan, with poles over the Greville abscissae, the
 * surface is z = sum z_ij N_i(x) N_j(y): linear in the heights of the poles, so that scattered
 * points serve as they are.  A little bending energy is added, so that poles without points near
 * them, in holes and at uneven borders, go on smoothly.
 */
#ifndef CLOUDMILL_HEIGHT_FIT_H
#define CLOUDMILL_HEIGHT_FIT_H

#include <stdbool.h>

#include "math/vec.h"
#include "nurbs/nurbs.h"

/* Cubic in both directions, with the end knots four times each. */
struct height_fit {
    struct nurbs_axis x, y;
    double *z; /* [j * x.poles + i] */
};

/* All heights zero; knots as they are given: the inner ones, rising, within the range. */
struct height_fit height_fit_new(const double range_x[2], const double *knot_x, size_t knots_x,
                                 const double range_y[2], const double *knot_y, size_t knots_y);
void height_fit_free(struct height_fit *fit);

/*
 * The heights that leave the least sum of squares to n points, seen along z, plus `smooth` times
 * the bending energy (the integral of z_xx^2 + 2 z_xy^2 + z_yy^2), in units of the points' density
 * times the fourth power of a mean knot span: at 1e-5 it is far less than what knots leave.  False:
 * there are too few points for a plane.  Time O(n + poles width^2), width three times the smaller
 * count of poles.
 */
bool height_fit_solve(struct height_fit *fit, const struct vec3 *point, size_t n, double smooth);

/* The height over a place and its slopes along x and y. */
double height_fit_at(const struct height_fit *fit, double x, double y, double slope[2]);

/* How far a point is from the surface, to first order, mm: above it positive. */
double height_fit_off(const struct height_fit *fit, struct vec3 p);

/* It as a surface, over the parameters x and y.  The caller frees it. */
struct nurbs height_fit_surface(const struct height_fit *fit);

#endif

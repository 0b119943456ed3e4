/*
 * arcspline_normal - the normal equations for a step of all joints of an arc spline at once, summed
 * arc by arc.
 *
 * How far a point is off its arc depends on what gives the arc alone: its two joints, the axes
 * there, and its tangent at the start.  So its products go into a small sum of its arc, and only
 * that sum is spread over the unknowns, for the tangent at an arc's start changes with every joint
 * before it: mirrored from arc to arc, linearly.  Of n points and m arcs the cost is n + m^3,
 * whereas a column of slopes for each unknown would cost n m^2.
 */
#ifndef CLOUDMILL_ARCSPLINE_NORMAL_H
#define CLOUDMILL_ARCSPLINE_NORMAL_H

#include "arcspline.h"
#include "math/band.h"

/* What gives an arc, in this order: the joints at its start and end (x, y, z each), its tangent at
 * the start, and how far the axes at both joints are turned sideways. */
enum { ARC_FROM = 0, ARC_TO = 3, ARC_TANGENT = 6, ARC_SIDES = 9, ARC_GIVEN = 11 };

/* How the axis at a joint changes with it: by p's x, y, z and by side. */
struct joint_axis_slope {
    struct vec3 by[4];
};

/*
 * How the distances of one point (arcspline_residual) change with what gives its arc: along u and
 * v; with an offset along s and w too.  To first order: the feet are kept, for along the arc
 * nothing changes.  An arc is taken as a conic, ((1 - b)^2 P0 + 2 b (1 - b) c M + b^2 P1) / sum,
 * with M where its tangents meet and c the cosine of half its turn: no angle functions are needed.
 */
struct foot_slopes {
    double along[4][ARC_GIVEN];
};

struct foot_slopes arcspline_foot_slopes(const struct arcspline *spline, double offset,
                                         const struct joint_axis_slope *axis,
                                         const struct arc_foot *foot);

/* The equations: normal * step = right, for the unknowns in the order of
 * arcspline_unknowns. */
struct arcspline_normal {
    size_t unknowns;
    struct band normal;
    double *right;
    struct joint_axis_slope *axis; /* of all joints */
    double *turn; /* how the tangent that the sum has come to changes: 3 for each unknown */
};

struct arcspline_normal arcspline_normal_new(const struct arcspline_fit *fit);
void arcspline_normal_free(struct arcspline_normal *normal);

/*
 * The unknowns of a fit: the tangent at the start, turned along two directions across it (unless it
 * is held); x, y, z of the inner joints; and with an offset their sides.
 */
size_t arcspline_unknowns(const struct arcspline_fit *fit);

/*
 * Sets the equations for the pnorm `half` of the distances `off`, in tolerances, by `scale`
 * (math/pnorm.h), plus the squares of the end's tangent off fit->end, by `held` for a radian; 0: it
 * is free.
 */
void arcspline_normal_set(const struct arcspline_fit *fit, const double *off, int half,
                          double scale, double held, struct arcspline_normal *normal);

#endif

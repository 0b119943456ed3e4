/*
 * tool_axis - the direction of the tool axis at a contact point (paper 1, 1 and fig. 2, 3.5).
 *
 * The frame is that of the surface (Darboux), not of the curve: n the surface normal, T the feed
 * direction perpendicular to n, B = +-(n x T).  T comes from the direction of the whole row (or
 * plane), not from one point to the next: scanned points wiggle sideways, the axis must not.  The
 * sign of B is fixed by the direction of the step from row to row, so that the tool leans to the
 * same side on zig and on zag.
 */
#ifndef CLOUDMILL_TOOL_AXIS_H
#define CLOUDMILL_TOOL_AXIS_H

#include "math/vec.h"

enum axis_kind {
    AXIS_LEAN,       /* off the normal by tilt (sideways) and lead (along the feed) */
    AXIS_TO_POINT,   /* the spindle points to a point, above the part */
    AXIS_FROM_POINT, /* the spindle points away from a point, below or inside the part */
    AXIS_CIRCLE,     /* the axis goes through the nearest point of a circle */
    AXIS_FIXED       /* everywhere the same */
};

/* The great circle of axes that a machine of one rotary axis has. */
struct axis_circle {
    struct vec3 pole; /* unit, what they turn about; zero: there is none, any axis may be */
    struct vec3 zero; /* unit, across it: the axis at 0 */
    double min, max;  /* travel, radians */
};

/* The axis of the circle that is nearest to a unit vector, or the vector itself if there is none;
 * beyond its travel, the end that is less of a turn away; along the pole, the one at 0. */
struct vec3 axis_circle_nearest(const struct axis_circle *circle, struct vec3 axis);

struct tool_axis_options {
    enum axis_kind kind;
    double tilt;               /* LEAN: radians, positive towards the next row */
    double lead;               /* LEAN: radians, positive the way the tool feeds */
    struct vec3 point;         /* TO_POINT, FROM_POINT; CIRCLE: its centre; mm */
    struct vec3 direction;     /* FIXED: unit, tip to spindle; CIRCLE: unit, its axis */
    double radius;             /* CIRCLE: mm */
    struct axis_circle circle; /* the axis is the nearest of these to the one by the rule */
};

/* What stays the same along one strip, in the direction it is cut. */
struct tool_axis_feed {
    struct vec3 along; /* horizontal unit vector, the way the tool feeds */
    struct vec3 side;  /* unit vector, towards the next row; not turned on the way back; horizontal
                          but for planes that are not upright */
    struct vec3 up;    /* unit, out of the plane that rows lie in; zero: up in z */
    struct vec3 plane; /* zero, or for a run in a plane: its unit normal, with n on the left of T;
                          T is then in the plane, plane x n */
};

/*
 * The axis, a unit vector from the tip to the spindle, for the ball's centre and the unit normal
 * where it touches.  LEAN: n + tan(lead) T + tan(tilt) B made a unit vector, which is
 * cos(theta) n + sin(theta) (cos(psi) T + sin(psi) B): with one of them zero the other one is
 * theta.
 */
struct vec3 tool_axis_at(const struct tool_axis_options *rule, const struct tool_axis_feed *feed,
                         struct vec3 centre, struct vec3 normal);

#endif

/*
 * motion - one piece of a path: straight, on an arc or on a B-spline.  The main header of curve/,
 * which holds the curves that a tool moves along and knows nothing of files or machines:
 *
 *   run.h         a cutting run: the points that one pass of the ball goes through, their tangents
 *                 and corners, and the smooth path between them
 *   reference.h   part of a run as the polyline that a fitted curve has to follow, and how far a
 *                 curve is off it
 *   motion.h      a fitted piece as it is driven: pose by parameter, length
 *   arc.h         circular arcs by a point, a tangent and an end; biarc.h: two of them, joined
 *   bspline.h     B-splines; cubic_form.h: any as a cubic one
 *   flatten.h     a B-spline as straight pieces within a chord error
 *   polyline.h    feet on a polyline, and the distance between two of them
 *   edge_curve.h  the edge of a facet as the surface runs there
 *   tool_axis.h   the tool axis at a contact point
 *
 * Along a straight line and an arc the tool axis turns on the great circle between the two end
 * axes, in proportion to the length; along a B-spline it is the direction from the curve to its
 * head.
 */
#ifndef CLOUDMILL_MOTION_H
#define CLOUDMILL_MOTION_H

#include "curve/bspline.h"
#include "math/vec.h"

/* Where the tool is: the tracked point and the unit axis from the tip to the spindle. */
struct pose {
    struct vec3 p, a;
};

struct poses {
    size_t n, cap;
    struct pose *item;
};

/* Where the ball touches the surface, and the surface's unit normal there. */
struct contact {
    struct vec3 p, n;
};

struct contacts {
    size_t n, cap;
    struct contact *item;
};

enum motion_kind { MOTION_LINE, MOTION_ARC, MOTION_SPLINE };

struct motion {
    enum motion_kind kind;
    struct pose from, to;
    struct vec3 centre, axis;    /* ARC: axis of the right-hand turn, unit */
    double sweep;                /* ARC: radians, 0 to 2 pi; start = end: 2 pi */
    const struct bspline *curve; /* SPLINE: belongs to the path */
};

struct motion motion_line(struct pose from, struct pose to);

/* The ends may lie a little off the circle or its plane: radius and height go over evenly. */
struct motion motion_arc(struct pose from, struct pose to, struct vec3 centre, struct vec3 axis);

/* The whole curve; it starts at its first pole, wherever `from` is. */
struct motion motion_spline(struct pose from, struct pose to, const struct bspline *curve);

/* The pose at s, 0 to 1: in proportion to length on a line and an arc, to the parameter on a
 * B-spline. */
struct pose motion_at(const struct motion *motion, double s);

/* The same, for those who ask at several places: `turn` is the great circle from its axis at the
 * start to that at the end. */
struct pose motion_on(const struct motion *motion, const struct great_circle *turn, double s);

/* Length of the tracked point's path, mm (a B-spline's within about 1e-4 of it). */
double motion_length(const struct motion *motion);

/* The parameter s of the next end of a knot span after s; 1 on lines and arcs. */
double motion_next_knot(const struct motion *motion, double s);

#endif

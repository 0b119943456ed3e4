/*
 * run - a cutting run as a fitter sees it: tip, ball centre, axis and surface normal at points
 * that are dense enough for straight lines between them to stand for the path.
 */
#ifndef CLOUDMILL_RUN_H
#define CLOUDMILL_RUN_H

#include <stdbool.h>

#include "base/array.h"
#include "math/vec.h"

struct run_point {
    struct vec3 tip;     /* of the tool, mm */
    struct vec3 ball;    /* its centre: tip + radius * axis */
    struct vec3 axis;    /* unit, tip to spindle */
    struct vec3 contact; /* on the surface, mm; only where `normal` is not zero */
    struct vec3 normal;  /* unit; zero: not known */
    bool given;          /* a point of the input; false: put between by run_densify */
    bool straight;       /* to the next point the path is the straight line, not the smooth curve */
};

struct run {
    size_t n, cap;
    struct run_point *item;
    double radius; /* of the ball, mm */
    bool edges;    /* no scan guards what is fitted: an edge of the way must not be rounded */
};

/* Is its contact point known? */
static inline bool run_point_touches(const struct run_point *p)
{
    return vec_dot(p->normal, p->normal) > 0.5;
}

/* How far the centre stands above its contact point along the normal, mm; the radius, unless the
 * ball was lifted. */
static inline double run_point_height(const struct run_point *p)
{
    return vec_dot(vec_sub(p->ball, p->contact), p->normal);
}

/*
 * Tangents of the ball's path, unit: three-point (Bessel) tangents of the centres, projected
 * perpendicular to the normal where there is one (a centre that is lifted off its contact point
 * has those of the centres alone where they keep near to the chords, else the slope of its lift);
 * where a curve along them would go more than 0.01 mm astray over a chord they give way to those of
 * the centres alone, or beside a sharp turn (with `edges` any that does not go on at the longer
 * chord's other end) to the longer chord, as far as these go less astray;
 * points that coincide have one tangent, all of them the zero vector when the run has no length.
 * At the ends T0 = 2 (v0 . T1) v0 - T1, v0 the first chord.  Paper 1, 3.4 instead with `forward`:
 * n x (PiPi+1 x n).  tangent[n].
 */
void run_tangents(const struct run *run, bool forward, struct vec3 *tangent);

/* The centre half way from point i to the next on the cubic between them (as of run_densify), by
 * the run's tangents. */
struct vec3 run_middle(const struct run *run, const struct vec3 *tangent, size_t i);

/* The motion of the ball over which a place is the least detour, of those that begin at the points
 * [from, to); by its first point. */
size_t run_motion_at(const struct run *run, size_t from, size_t to, struct vec3 place);

/*
 * Appends the indices of the inner points where the ball's path turns by more than 60 degrees: the
 * corners; and the ends of each block off the part that swings the ball (run_densify).  With
 * `edges` also those where each tangent would take a curve astray and the path bends at neither
 * neighbour half as much for each mm, as where a ball comes from one face to another.  Tangents on
 * the two sides of a corner are those of the two pieces that it parts.
 */
void run_corners(const struct run *run, struct sizes *corner);

/*
 * The reference curve of a run: between two points the centre follows the cubic Hermite curve with
 * run_tangents' tangents (at a speed that comes nearest to a circle), the axis the cubic with
 * three-point derivatives by the centre's path, made a unit vector (the great circle where axes are
 * more than 60 degrees apart or the centre stands still), and the tip follows from both.  In a
 * block off the part that moves the centre farther than the tip and turns the axis by more than 15
 * degrees, or that would take the tip off the line that its points are on, the tip goes straight,
 * as a control has it, and the centre follows from tip and axis.  Corners are kept, and so are
 * straight lines, along which what is beside them begins and ends.  Appends to `dense` (which has
 * the same radius) all points and as many between, that straight lines between neighbours stay
 * within `chord` mm of the curve at the tip and the centre: an interval that is straight enough
 * gets none, so that dense data comes back as it is.
 * Returns the largest distance between the curve and the straight lines of the *input*.
 */
double run_densify(const struct run *run, double chord, struct run *dense);

#endif

/*
 * reference - the polyline that a fitted curve has to follow, and how far a curve is off it.
 *
 * A reference is part of a cutting run, seen from the point that is programmed: the tip or the
 * ball's centre.  Beside this point goes the other one of the two, at the same distance along the
 * tool axis.  Between neighbours both move on straight lines.
 *
 * A place on a reference is an index with a fraction: 3.5 is halfway between points 3 and 4.
 */
#ifndef CLOUDMILL_REFERENCE_H
#define CLOUDMILL_REFERENCE_H

#include <stdbool.h>

#include "curve/polyline.h"
#include "curve/run.h"
#include "math/vec.h"

struct reference {
    size_t n;
    struct vec3 *point;   /* the programmed one */
    struct vec3 *other;   /* point + offset * axis */
    struct vec3 *axis;    /* unit */
    struct vec3 *tangent; /* of the point's path (run_tangents); reference_of alone */
    double *chord;        /* from point k to point k + 1, mm; n - 1 of them */
    double *length;       /* sum of the chords up to point k, mm */
    struct stays point_stays, other_stays; /* where the points stay; reference_of alone */
    double offset;    /* mm: from the tip to the centre the radius, from the centre to the tip
                             the negative radius; 0: there is no other point */
    bool turns;       /* the axis is not the same everywhere */
    bool flat[3];     /* this component is 0 in every axis, as where a machine turns about X
                             alone: it stays so (reference_of, reference_distinct) */
    bool other_leads; /* the axis turns, and the other point has the longer path: its places
                             tell better which axes belong together */
};

/*
 * n points of a run from `from` on, for arcs.  A chord is the way of the programmed point.
 * `centre`: that is the ball's centre, not the tip.  `forward`: the tangents are those of paper 1
 * (run_tangents).
 */
struct reference reference_of(const struct run *run, size_t from, size_t n, bool centre,
                              bool forward);

/*
 * A whole run, for splines.  A chord is the root of the mean square of the ways of both points
 * (without a ball: of the programmed point and one 1 mm along the axis), so that a turn of the axis
 * in one place has a length too.  Points that repeat the one before are left out, but not the last.
 */
struct reference reference_distinct(const struct run *run, bool centre);

/*
 * About `parts` points (at most 3 (parts + 1)), as evenly spaced as the points of the reference
 * allow: those that are near to the last one taken are left out, and where the next one is far,
 * points on the straight line to it are put between.  `other` and `axis` are NULL unless the axis
 * turns; `length` is that of the reference; `chord` is NULL.
 */
struct reference reference_sample(const struct reference *reference, size_t parts);

void reference_free(struct reference *reference);

/* Fills point_stays and other_stays. */
void reference_find_stays(struct reference *reference);

/* v with those components that are 0 in every axis taken from `zero`. */
struct vec3 reference_flat(const struct reference *reference, struct vec3 v, struct vec3 zero);

/* A unit vector without the components that are 0 in every axis. */
struct vec3 reference_flat_axis(const struct reference *reference, struct vec3 axis);

struct vec3 reference_point(const struct reference *reference, double place);
struct vec3 reference_axis(const struct reference *reference, double place);

/* The interval between points that holds the place, and the place's fraction of it. */
size_t reference_interval(const struct reference *reference, double place, double *part);

/* The tool axis is the same at the points `from` to `to`. */
bool reference_axis_still(const struct reference *reference, size_t from, size_t to);

/* The place nearest to q: the next minimum of the distance, downhill from `place`. */
double reference_place(const struct reference *reference, struct vec3 q, double place);

/* How far a curve is off a reference, or may be: distances both ways. */
struct deviation {
    double point; /* of the programmed point, mm */
    double other; /* of the other point, mm */
    double axis;  /* between the axes at matching places, radians */
};

/* No figure of `found` is above that of `within`. */
bool deviation_within(const struct deviation *found, const struct deviation *within);

/* The larger of each. */
struct deviation deviation_worst(struct deviation a, struct deviation b);

#endif

/*
 * track - a cutting run as a fitter of splines sees it: the points that its curve is to follow.
 *
 * The tracked point is what the poles will stand for; beside it there is the other end of the
 * ball's radius, whose way has to be kept too, and the head, which carries the axis.
 */
#ifndef CLOUDMILL_TRACK_H
#define CLOUDMILL_TRACK_H

#include <stdbool.h>

#include "curve/bspline.h"
#include "curve/run.h"
#include "math/vec.h"

enum { TRACK_LENGTH = 100 }; /* from the tracked point to the head, mm */

struct track {
    size_t n;
    struct vec3 *point;
    struct vec3 *other; /* point + offset * axis */
    struct vec3 *axis;  /* unit */
    struct vec3 *head;  /* point + TRACK_LENGTH * axis; NULL: the axis is the same everywhere */
    double *chord;      /* from point k to point k + 1, mm: the root of the mean square of how far
                           the point and the other one move; n - 1 of them */
    double offset;      /* mm: from the tip to the centre the radius, from the centre to the tip
                           the negative radius; 0: the tracked point alone counts */
};

/*
 * From the points of a run: the ball's centre is tracked with `centre`, else the tip.  Points that
 * repeat the one before (chord below 1e-7 mm) are left out, but never the last one.
 */
struct track track_new(const struct run *run, bool centre);

void track_free(struct track *track);

/* A new curve with a head when the track has one, its knots and poles still zero. */
struct bspline track_curve(const struct track *track, int degree, size_t poles);

/* Degree 1 from the first point to the last, with knots 0 and 1. */
struct bspline track_straight(const struct track *track);

/* Degree 1 through all points, with knots at the sums of the chords. */
struct bspline track_polyline(const struct track *track);

#endif

/*
 * target - what a curve with free knots is fitted to: places along a track, none far from the next.
 */
#ifndef CLOUDMILL_TARGET_H
#define CLOUDMILL_TARGET_H

#include <stdbool.h>

#include "splinefit/track.h"
#include "math/vec.h"

struct target {
    size_t n;           /* at least 2 */
    double *at;         /* way from the start, mm: sums of the track's chords, rising */
    struct vec3 *point; /* tracked point */
    struct vec3 *other; /* other end of the radius; these two with a turning axis only */
    struct vec3 *axis;  /* unit; else NULL */
    double offset;      /* of the other end from the point along the axis, mm */
    double tolerance;   /* of point and other end, mm */
    double angle;       /* of the axis, radians */
    bool other_leads;   /* the other end moves more: the axes are compared at its feet */
};

/*
 * About `parts` places, as equally spaced as the track's points allow: points that are near to the
 * last one taken are left out, and where the next one is far, places on the straight line to it are
 * put between.
 */
struct target target_new(const struct track *track, size_t parts, double tolerance, double angle);

void target_free(struct target *target);

#endif

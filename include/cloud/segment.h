/*
 * segment - a cloud that no single projection serves, divided by orientation (paper 1, 7).
 */
#ifndef CLOUDMILL_SEGMENT_H
#define CLOUDMILL_SEGMENT_H

#include "base/array.h"
#include "math/vec.h"

/* One part: what is seen without steep places along its own direction. */
struct segment {
    struct vec3 across, up; /* unit, perpendicular: from row to row, and of the projection ... */
    struct vec3 along;      /* ... and along the rows: along x across = up */
    struct vec3s point;     /* its own, those of its neighbours within the overlap, and beyond its
                               sharp edges points that its surface is continued to */
    size_t own;             /* how many are its own: the first ones */
};

struct segments {
    size_t n, cap;
    struct segment *item;
    size_t left_out; /* points in none of them */
    double spacing;  /* mean spacing of the points on their surface, mm */
};

struct segments_options {
    double overlap;      /* mm; 0: four and a half mean spacings */
    double direction;    /* of the rows of the part that is seen from above, degrees from x */
    struct vec3 outside; /* unit: the side of the surface that is seen from there is its outside */
    int threads;
};

enum { SEGMENTS_LEAST = 16 }; /* so few points are in no part */

/*
 * Each point goes to the direction that is nearest to its normal, of as few as serve it within 50
 * degrees: straight up first, then those of 32 directions around and 45 degrees up and down that
 * serve most of what is left.  The connected pieces of these are the parts.  Points nearer
 * than the overlap to those of a part belong to it too, if they
 * face it within 70 degrees and no sharp edge is between; beyond sharp edges its surface is
 * continued instead, by two thirds of the overlap.  The rows of the part that is
 * seen from above run in the direction asked for; those of others are horizontal.  Parts come from
 * the top down and round.
 */
struct segments segments_find(const struct vec3 *point, size_t n,
                              const struct segments_options *options);

void segments_free(struct segments *parts);

/* Fills normal[n] of the surface at each of more than SEGMENTS_LEAST points, all on one side of
 * them, as they are divided by: the side that is seen from `outside`. */
void segments_normals(const struct vec3 *point, size_t n, struct vec3 outside, int threads,
                      struct vec3 *normal);

/* Into the part's own axes: along, across, up; and back. */
struct vec3 segment_in(const struct segment *part, struct vec3 p);
struct vec3 segment_out(const struct segment *part, struct vec3 p);

#endif

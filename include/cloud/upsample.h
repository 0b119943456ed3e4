/*
 * upsample - points put between those of a sparse scan, on surfaces through the nearest of them, so
 * that a ball does not sink in.
 */
#ifndef CLOUDMILL_UPSAMPLE_H
#define CLOUDMILL_UPSAMPLE_H

#include <stdbool.h>

#include "base/array.h"
#include "math/near_lists.h"

struct upsample_surface; /* upsample_surface.h */

struct upsample {
    const struct point_grid *point_grid; /* the scan */
    double radius;                       /* of the ball, mm */
    double sink;                         /* how deep it may sink between points, mm */
    double noise;                        /* standard deviation of the points, mm; 0: none */
    bool lines; /* the scan is on lines (scan_lines.h): the surfaces of neighbours must agree */
    const struct near_lists *near; /* of its points, or NULL */
};

/* The ball sinks deeper in more than a tenth of the places. */
bool upsample_needed(const struct upsample *fill);

/* What its points are apart where they are on lines from one of these to the next: so far is the
 * last that it takes to surround a point, mm, the median; else the spacing of the point_grid. */
double upsample_gap(const struct upsample *fill);

/*
 * Appends points about point i of the point_grid, which the surface has at p, as dense as the ball
 * asks for: those nearer to i than to the other points, inside of these, and where all points about
 * are on it, so that none is put over an edge or into a corner.  None either where it is so
 * hollow that the ball does not go in.  In a hole, and a little beyond where the scan ends, only
 * where a surface about the place itself is as smooth and certain as the ball asks for: else no
 * hole is filled and no border moves.  Where points about are farther off, as over blunt edges that
 * none of them is on, and it bends down there, a place is put all the same, moved to where they
 * are.  Where its quadric's variance and tilt leave it uncertain at a place by 0.7 of the noise,
 * that is put within four noises of the points nearest to it.  Where its spread is more than noise
 * and the ball's sinking explain, nothing is appended.
 */
void upsample_on(const struct upsample *fill, size_t i, struct vec3 p,
                 const struct upsample_surface *surface, struct vec3s *to);

/*
 * The same on a surface through the nearest points as they are: of the second degree through 16 to
 * 32 of them, or of the third through 24 where that leaves less; or, where such a place is doubtful
 * and facets that meet in edges between points explain more points as well, on these.  Returns how
 * far the points are off the former (one standard deviation, mm), 0 where the ball asks for none.
 */
double upsample_about(const struct upsample *fill, size_t i, struct vec3s *to);

#endif

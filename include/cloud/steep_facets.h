/*
 * steep_facets - the surface between the points of a steep flank, that a scan from above has few
 * of.
 *
 * Seen from above points are as dense on a flank as elsewhere; on the flank itself they are farther
 * apart by the root of its slope: at 89 degrees eight times.  Among the points nearest to one of
 * them in space are then those of the rim and the foot, no surface goes through all of these, and a
 * ball sinks in.  What such a scan tells is no less than this: its points see the same flank from
 * one to the next.  So places are put on the facets of its Delaunay triangulation, seen from above,
 * that are steep and so long that a ball would sink in.  Not on those of a hollow, where another
 * facet stands up beside: they are in front of the part; nor on those over holes and beyond the
 * border, whose circles are wide; nor on those that noise may have put up.
 */
#ifndef CLOUDMILL_STEEP_FACETS_H
#define CLOUDMILL_STEEP_FACETS_H

#include <stdbool.h>

#include "math/point_grid.h"

struct steep_facets_options {
    const struct vec3 *place; /* where the points of the scan are taken to be; NULL: as they are */
    double radius;            /* of the ball, mm */
    double sink;              /* how deep it may sink between places, mm */
    double noise;             /* standard deviation of the points, mm */
    double longest;           /* mean spacings, at least, of a facet's longest edge */
    bool sure;                /* only what is steeper, and less hollow, than it has to be */
    int threads;              /* as of parallel_for */
};

/* Appends the places; returns how many facets these are on. */
size_t steep_facets(const struct point_grid *scan, const struct steep_facets_options *options,
                    struct vec3s *to);

/* For who asks what a ball of this radius could reach: those whose points are so far apart that
 * these alone do not tell.  Where they are nearer what stays below is to be asked of the points, as
 * ever: it is a sign, too, that so few points are not enough. */
void steep_facets_asked(const struct point_grid *scan, double radius, double noise, int threads,
                        struct vec3s *to);

/* For who asks whether such a ball went in between the points: the sure ones.  `scan` as it was
 * scanned, and its points taken to be at `place` (NULL: where they are), as for who keeps a ball
 * off: of points moved other facets meet where one side hangs over the other. */
void steep_facets_sure(const struct point_grid *scan, const struct vec3 *place, double radius,
                       double noise, int threads, struct vec3s *to);

#endif

/*
 * edge_points - the sharp convex edges and tips of a scan that has no points on them: where the
 * surfaces on both sides, continued, meet.
 *
 * Between points on two sides of an edge a chord lies inside the part, and a ball that follows it
 * cuts the edge off.  So:
 *   1. A point whose neighbourhood is no one quadric gets the surface of its own side, its flank:
 *      of the planes through it and two of its neighbours the one that most neighbours lie on
 *      (RANSAC, Fischler and Bolles 1981, but all of them), fitted to these, and bent where that is
 *      better (side_fit.h).  It counts if the flanks of the points on it agree.  A point that none
 *      of these tell gets the level top of a narrow wall, whose points lie along a line, or a
 *      quadric of neighbours along a rib (ridge_direction.h).  Under noise a flank that is
 *      certain goes through as many points about as one surface explains: continued to an edge, one
 *      through a dozen is off by one or two noises.
 *   2. Where the flanks of two neighbours are no continuation of each other and each of the two
 *      lies below the flank of the other, points are put on the curve in which these intersect, and
 *      at a tip where they meet a third flank; no further than REACH spacings from a point of the
 *      scan.
 *   3. Where the ball would sink in between points of a flank that is certain, has an edge, or is a
 *      rib's, points are put on it, up to its edges and into sharp hollows, where points or edges
 *      of the flank are on all sides, or one that is certain goes on above another flank; for no
 *      surface of all nearest points goes through there.
 *   4. Where points lie below a flank, so steeply that a wall must be between, or as far below it
 *      as it is above their own surface, nobody knows where the wall is: a flank goes on up to
 *      these points, at a corner a little beyond, and down to them goes a wall, so that a ball is
 *      kept off whatever may be there.  Only flanks are continued that are certain: their points
 *      are off them by no more than noise, or than a ball may sink.  Where a square corner that
 *      holds the upper points stands out between two points below, its wall hangs there, too, as
 *      far as a flank goes on; points below of no known surface are a floor where they are as low
 *      wherever they are; and over the foot of a wall of 8 spacings and more (of the foot's own,
 *      which are wider, 5.7 where there is no noise) one hangs whatever is known of the surfaces,
 *      as over round teeth.  A point that noise alone may have thrown down is below nothing; and
 *      where a flank is short or not certain, no wall stands on a point from which the scan goes up
 *      to it without one.
 *   5. The tip of a cone is put where its straight lines, continued, meet (cone_tip.h), and places
 *      round it as far as all neighbours know.  Where sides are so narrow, or bend so much, that
 *      none is certain, both sides of a crest, sharp or rounded, are fitted together (crest_fit.h),
 *      and places put on it and on them.
 *   6. Where a point is the foremost of its neighbours over 60 degrees of directions, as on an edge
 *      or a tip, and neither its surface nor a place of an edge is known, the part may go on in
 *      front of it; the same where a point stands out from those about it, and these are off any
 *      surface that bends, by more than noise explains, as on a rib as thin as points are apart;
 *      and at corners of less than 75 degrees of flanks that end above a wall, and at spurs, which
 *      are such corners farther about, whether their own few points tell or not.  It is counted, if
 *      there are two such points near each other, the scan goes on round them, and the surface of a
 *      third of the points about is certain (elsewhere all of it is rough).  Points are put so far
 *      in front of it, from there to its neighbours, and between two of them that may be on one
 *      feature; what is farther between and beyond these stays unknown.
 * On scan lines (scan_lines.h) flanks are those of neighbours on several lines, for through three
 * lines a smooth surface goes whatever is between; where these do not tell, of neighbours on few.
 * No edge is put where points near to it lie off both flanks, and on no flank of their own: there
 * the scan knows a rounding.  Flanks are seen from above: their normals point up.
 */
#ifndef CLOUDMILL_EDGE_POINTS_H
#define CLOUDMILL_EDGE_POINTS_H

#include <stdbool.h>

#include "math/near_lists.h"

struct edge_points_options {
    const struct point_grid *point_grid; /* the scan, without outliers */
    double noise;                        /* standard deviation of its points, mm */
    double along;                        /* distance of points along an edge, mm */
    double sink;                         /* how far off a flank that is certain may be, mm */
    bool fill;                           /* flanks, too, get points as dense, up to their edges */
    bool met; /* only edges that flanks meet in, tips, and these flanks (1 to 3, and the tip of 5):
                 nothing is taken to go on that the scan does not know, unless walls hang from so
                 many points, one in seven, that these are what the scan is of */
    int threads;
    const struct near_lists *near; /* of the scan's points, or NULL */
};

/* True if point i lies on such a flank of its neighbours, which make one without it, and is not
 * apart from them. */
bool edge_flank_holds(const struct point_grid *point_grid, double noise, size_t i);

/* Points of flanks that were continued to the points below, and the widest way to these; points
 * whose own surface is certain; and the foremost points of sharp edges whose sides are not
 * known. */
struct edge_gaps {
    size_t n;
    double widest; /* mm, seen from above */
    struct vec3 at;
    size_t certain;        /* points whose surface is */
    size_t unknown, spurs; /* spurs: how many of these are */
    size_t features;       /* groups of these near each other */
    size_t large;          /* and stand out so far that the points do not tell their shape */
    double depth;          /* the edges may stand so far in front of these, mm, ... */
    struct vec3 unknown_at;
};

/* Appends the points, those on edges last; returns how many these are.  *gaps: edges that the scan
 * does not resolve. */
size_t edge_points(const struct edge_points_options *options, struct vec3s *to,
                   struct edge_gaps *gaps);

#endif

/*
 * rim_points - the surface of a scan, gone on with beyond its rim.
 *
 * Seen from above a scan ends where the scanner saw no more: the part goes on, by less than points
 * are apart until it turns down, or down a flank too steep to be seen.  A ball that follows the
 * last points from beside would go into that.  So from each point that has none of the scan to one
 * side, seen from above over a third of a turn, places go on along the quadric of the points about
 * it where that goes down; down a steep flank straight on, as far as the ball is wide, and from
 * there upright.  Where no quadric goes through these points, as on an edge rounded more sharply
 * than they are apart, along the plane of the nearest, up too; and from the tip of what is as
 * narrow as that along the highest chord from a point behind.  To a ball that touches the scan they
 * are no hindrance, but where it is so sharp: it touches them, too, or less.
 */
#ifndef CLOUDMILL_RIM_POINTS_H
#define CLOUDMILL_RIM_POINTS_H

#include "base/array.h"
#include "math/point_grid.h"

struct rim_points_options {
    double pitch;  /* of the places, mm */
    double gap;    /* of those that hang down from there, mm */
    double radius; /* of the ball, mm */
    double noise;  /* standard deviation of the points, mm */
    int threads;   /* as of parallel_for */
};

/* Appends the places; returns how many points are at the rim. */
size_t rim_points(const struct point_grid *scan, const struct rim_points_options *options,
                  struct vec3s *to);

/* The same for who asks what a ball of this radius could reach, as those find them who keep it
 * off. */
void rim_points_asked(const struct point_grid *scan, double radius, double noise, int threads,
                      struct vec3s *to);

#endif

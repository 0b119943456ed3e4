/*
 * deviation_map - the ball rolled over all points of the part: what it leaves, and where it gouges.
 *
 * The deviation of a point is its distance to the nearest place of the ball's centre less the
 * radius: above zero material is left on it, below zero the ball went in so deep.  The region that
 * is judged are all points that part_coverage.h does not find out of reach; or of a program that is
 * to cut a part of them, those that the ball reached within tolerance and limit, or that are left
 * among places where it touches the part by no more than `band`.  A ball also comes near to points
 * beside a region, which are not to be cut: of those that are left the ones next to points that are
 * none of it are not judged.
 */
#ifndef CLOUDMILL_DEVIATION_MAP_H
#define CLOUDMILL_DEVIATION_MAP_H

#include "base/array.h"
#include "simulate/centre_path.h"

struct deviation_map_options {
    double radius;
    double tolerance; /* mm */
    double band;      /* the ball is off the part where it is higher than this, mm */
    int threads;      /* as of parallel_for */
    bool gouges;      /* of interest are only points that are gouged beyond the tolerance */
    double limit;     /* what may stay on a point that is cut, mm, if less than the tolerance */
};

enum { DEVIATION_MAP_PERCENTILES = 3 }; /* 50, 95, 99 */

struct deviation_map {
    double touch;          /* the ball is on the part where it is no further off all points, mm */
    size_t points, cut;    /* all, and those of the region cut */
    size_t gouged, left;   /* of these beyond the tolerance */
    double *deviation;     /* of each point, HUGE_VAL: no path, or gouges alone are looked for */
    unsigned *segment;     /* of each point, the nearest of the path; UINT_MAX: none */
    unsigned char *region; /* of each point: 1 when it is of the region that is judged */
    double gouge, over;    /* worst, mm, 0 at least */
    size_t gouge_at, over_at; /* points there */
    double gouge_part[DEVIATION_MAP_PERCENTILES], over_part[DEVIATION_MAP_PERCENTILES];
};

/* Rolls the ball along the path over n points; sets `on` of each segment.  The region is that of a
 * program that cuts a part. */
void deviation_map_run(struct centre_path *path, const struct vec3 *point, size_t n,
                       const struct deviation_map_options *options, struct deviation_map *map);

/* Sums up the points of the region, again after it was changed. */
void deviation_map_sum(const struct deviation_map_options *options, struct deviation_map *map);

void deviation_map_free(struct deviation_map *map);

#endif

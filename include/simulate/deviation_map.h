/*
 * deviation_map - the ball rolled over all points of the part: what it leaves, and where it gouges.
 *
 * The deviation of a point is its distance to the nearest place of the ball's centre less the
 * radius: above zero material is left on it, below zero the ball went in so deep.  Points belong
 * to the region cut when the ball reached them within the tolerance, or when they are left among
 * places where it touches the part (not beside them) by no more than `band`.
 */
#ifndef CLOUDMILL_DEVIATION_MAP_H
#define CLOUDMILL_DEVIATION_MAP_H

#include "base/array.h"
#include "simulate/centre_path.h"

struct deviation_map_options {
    double radius;
    double tolerance; /* mm */
    double band;      /* material above this was not meant to be cut, mm */
    int threads;      /* as of parallel_for */
};

enum { DEVIATION_MAP_PERCENTILES = 3 }; /* 50, 95, 99 */

struct deviation_map {
    size_t points, cut;    /* all, and those of the region cut */
    size_t gouged, left;   /* of these beyond the tolerance */
    double *deviation;     /* of each point, at most band */
    unsigned *segment;     /* of each point, the nearest of the path; UINT_MAX: beyond the band */
    unsigned char *region; /* of each point: 1 when it is of the region cut */
    double gouge, over;    /* worst, mm, 0 at least */
    size_t gouge_at, over_at; /* points there */
    double gouge_part[DEVIATION_MAP_PERCENTILES], over_part[DEVIATION_MAP_PERCENTILES];
};

/* Rolls the ball along the path over n points; sets `on` of each segment. */
void deviation_map_run(struct centre_path *path, const struct vec3 *point, size_t n,
                       const struct deviation_map_options *options, struct deviation_map *map);

void deviation_map_free(struct deviation_map *map);

#endif

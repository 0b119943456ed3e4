/*
 * sheets - scans over each other that do not meet: two layers of points where there is one surface.
 *
 * At up to PLACES places a quadric goes through the NEAR nearest points.  There are two sheets
 * where the distances from it fall into two groups (the best split of them in two, after Otsu
 * 1979), each of at least a quarter, whose means are more than APART times as far apart as the
 * points of a group are spread, and which lie among each other: a point's nearest neighbour is of
 * the other group about as often as by chance, as it is not at a step or a crease; and the nearest
 * of the other group are round most points of both, as they are not about a rib or a pocket.  Steep
 * places are left out, where the two sides of a thin wall are no sheets.
 */
#ifndef CLOUDMILL_SHEETS_H
#define CLOUDMILL_SHEETS_H

#include "math/point_grid.h"

struct sheets {
    size_t places;   /* with two sheets; 0: there are none */
    size_t looked;   /* of so many */
    double distance; /* of the sheets, the median of these places, mm: how far on average the points
                        of each are off a quadric through the other's */
    double widest;   /* the largest, mm, and where */
    struct vec3 at;
};

/* Fewer than three places are none, nor are any beside points that are marked in out[] (NULL: none
 * is): an outlier or two among others look like a sheet. */
struct sheets sheets_find(const struct point_grid *point_grid, const unsigned char *out,
                          int threads);

#endif

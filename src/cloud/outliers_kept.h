/*
 * outliers_kept - which of the points that are off a surface, or isolated, are no outliers all the
 * same: those that others bear out (cloud/outliers.h says which); and the neighbours by which both
 * are told.
 */
#ifndef CLOUDMILL_OUTLIERS_KEPT_H
#define CLOUDMILL_OUTLIERS_KEPT_H

#include <stdbool.h>

#include "cloud/outliers.h"
#include "math/point_grid.h"

/* The neighbours that a point is compared with, itself left out, nearest first. */
struct outliers_hood {
    uint32_t index[OUTLIERS_NEAR];
    struct vec3 point[OUTLIERS_NEAR];
    double distance2[OUTLIERS_NEAR + 1]; /* mm2: of the point itself, 0, and then of these */
    double spacing;                      /* of them on a surface, mm */
};

/* False: the scan has too few points. */
bool outliers_hood_find(const struct point_grid *point_grid, size_t i, struct outliers_hood *hood);

/* A point that is no further off a surface of its neighbours, mm, is on it, whatever these are off
 * it; `sigma`: the noise of the scan, mm. */
double outliers_least(const struct outliers_hood *hood, double sigma);

/* Seen from above, within 2.5 spacings, nearly all points not marked are higher than point i. */
bool outliers_is_beneath(const struct point_grid *point_grid, const unsigned char *out, size_t i);

/* Takes the mark (1) off points in out[], as many as points, that others bear out: several in a row
 * from the surface on, as on a needle, or beside each other, as on a thin rib or plate; points on
 * the surface that others make, as on one side of a thin edge or a wall seen at few places; points
 * of a step or below a rim; and those of several that stand as high over what is about them, as on
 * a thin rib whose points are anywhere.  All others keep it.  `sigma`: the noise of the scan, mm.
 */
void outliers_keep(const struct point_grid *point_grid, double sigma, unsigned char *out);

#endif

/*
 * outliers_kept - which of the points that are off a surface, or isolated, are no outliers all the
 * same: those that others bear out (cloud/outliers.h says which).
 */
#ifndef CLOUDMILL_OUTLIERS_KEPT_H
#define CLOUDMILL_OUTLIERS_KEPT_H

#include "math/point_grid.h"

/* Takes the mark (1) off points in out[], as many as points, that others bear out: several in a row
 * from the surface on, as on a needle, or beside each other, as on a thin rib or plate; points on
 * the surface that others make, as on one side of a thin edge or a wall seen at few places; points
 * of a step or below a rim; and those of several that stand as high over what is about them, as on
 * a thin rib whose points are anywhere.  All others keep it.  `sigma`: the noise of the scan, mm.
 */
void outliers_keep(const struct point_grid *point_grid, double sigma, unsigned char *out);

#endif

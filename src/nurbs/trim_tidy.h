/*
 * trim_tidy - a polygon in the parameters without what is only rounding.
 */
#ifndef CLOUDMILL_TRIM_TIDY_H
#define CLOUDMILL_TRIM_TIDY_H

#include "nurbs/nurbs.h"

/* Brings corners that lie within rounding (a part of the tolerance, mm) of the border of the range
 * onto it, and drops those that repeat the one before, and ways there and back again. */
void trim_tidy(const struct nurbs *s, double tolerance, struct uvs *loop);

#endif

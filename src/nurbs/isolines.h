/*
 * isolines - the parameter lines of the grid that a surface is tessellated by.
 */
#ifndef CLOUDMILL_ISOLINES_H
#define CLOUDMILL_ISOLINES_H

#include "base/array.h"
#include "nurbs/nurbs.h"

/* n cells over the range, equal between the breaks (nurbs_axis_breaks); every break is a line. */
void isolines_equal(const struct nurbs_axis *axis, int n, struct doubles *line);

/*
 * As many cells in u and in v as the tolerance needs, denser where the surface bends more: so that
 * the bound of Filip, Magedson and Markot (1986) on the distance between a triangle and the
 * surface, with the second derivatives taken along the normal, is `tolerance` / `finer` squared.  `border`: the ends of the ranges bound
 * the surface, and their curves keep the tolerance too, where they bend within the surface (the rim
 * of a disc).
 */
void isolines_bent(const struct nurbs *s, double tolerance, double finer, bool border,
                   struct doubles *u, struct doubles *v);

#endif

/*
 * isolines - the parameter lines of the grid that a surface is tessellated by.
 */
#ifndef CLOUDMILL_ISOLINES_H
#define CLOUDMILL_ISOLINES_H

#include <stdbool.h>

#include "base/array.h"
#include "nurbs/nurbs.h"

/* n cells over the range, equal between the breaks (nurbs_axis_breaks); every break is a line. */
void isolines_equal(const struct nurbs_axis *axis, int n, struct doubles *line);

/* How far a surface bends along lines of u and of v, whatever the tolerance. */
struct isolines_bend {
    struct doubles at_u, root_u, at_v, root_v;
};

/* Which ends of the ranges bound the patch: u.from and u.to, v.from and v.to. */
struct isolines_border {
    bool u[2], v[2];
};

/* The curves at the ends of the ranges that bound the patch keep the tolerance too, where they bend
 * within the surface (the rim of a disc).  The caller frees `bend`. */
void isolines_measure(const struct nurbs *s, const struct isolines_border *border,
                      struct isolines_bend *bend);

/*
 * As many cells in u and in v as the tolerance needs, denser where the surface bends more: so that
 * the bound of Filip, Magedson and Markot (1986) on the distance between a triangle and the
 * surface, with the second derivatives taken along the normal, is `tolerance` / `finer` squared.
 */
void isolines_bent(const struct isolines_bend *bend, double tolerance, double finer,
                   struct doubles *u, struct doubles *v);

void isolines_bend_free(struct isolines_bend *bend);

#endif

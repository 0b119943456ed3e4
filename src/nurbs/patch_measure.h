/*
 * patch_measure - area of a trimmed surface and what it adds to the volume of a body, from the
 * surface itself: as near whatever the tolerance of its triangles is.
 *
 * The part of the parameters inside the loops as triangles no knot line runs through, and in each
 * the formula of degree 5 with seven places (Radon 1948; Stroud, Approximate Calculation of
 * Multiple Integrals, T2:5-1) for the area element and, by the theorem of Gauss, the volume.
 */
#ifndef CLOUDMILL_PATCH_MEASURE_H
#define CLOUDMILL_PATCH_MEASURE_H

#include "nurbs/patch.h"

struct patch_measure {
    double area;   /* mm^2 */
    double volume; /* mm^3: a third of the flux of x - origin through it along dS/du x dS/dv */
    bool sound;    /* false: its trimming is not clear, and the figures are not to be used */
};

/* `size` is about how large the trimmed surface is, mm: its loops are followed to a ten-thousandth
 * of it, and bent as they are. */
struct patch_measure patch_measure(const struct patch *patch, double size, struct vec3 origin);

#endif

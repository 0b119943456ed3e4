/*
 * footprint - what a cloud covers, seen from above (along z).
 *
 * The grid's own axes may be turned about z against the scan's (paper 1, 3.1: the direction of
 * the rows); a footprint's box lies along them.
 */
#ifndef CLOUDMILL_FOOTPRINT_H
#define CLOUDMILL_FOOTPRINT_H

#include <stddef.h>

#include "base/error.h"
#include "math/vec.h"

struct footprint {
    double cosine, sine;           /* of the direction of the rows, from the scan's x axis */
    double xmin, xmax, ymin, ymax; /* box of the points along the grid's axes, mm */
};

/* `direction` in degrees; n > 0. */
struct footprint footprint_of(const struct vec3 *point, size_t n, double direction);

/* A point in the grid's axes. */
static inline struct vec3 footprint_turn(const struct footprint *f, struct vec3 p)
{
    return vec(f->cosine * p.x + f->sine * p.y, f->cosine * p.y - f->sine * p.x, p.z);
}

/* Points that carry no surface: fewer than 3, all in one place, all on one line or in two clumps
 * far apart seen from above: -1 and why (without the name of a file). */
int footprint_check(const struct vec3 *point, size_t n, struct error *error);

/*
 * Mean spacing of the points, mm: sqrt(area / n), the area being that of the cells with points in
 * them; the cells are five times as wide as the spacing that follows from them, so that neither
 * the gaps between laser lines nor an empty corner of the box deceive.
 */
double footprint_spacing(const struct footprint *f, const struct vec3 *point, size_t n);

#endif

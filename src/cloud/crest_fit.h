/*
 * crest_fit - a crest, both of its sides fitted together: where flanks are so narrow or bent that
 * neither carries a surface of its own, the two and what they have in common do.
 *
 * Seen from above the crest is an arc of a circle, with s along its tangent and d (signed) the
 * distance from it:
 *   z = t0 + t1 s + t2 s^2 - (m + n s) |d|
 * with m and n for each side, by least squares of the distances across the sides (Gauss-Newton, as
 * Levenberg and Marquardt damp it).  Points that are on neither side are left out step by step.
 * Where no sharp crest explains the points, one that an arc of a circle rounds may: in the plane
 * across it, it touches both sides.
 * Lengths in mm.
 */
#ifndef CLOUDMILL_CREST_FIT_H
#define CLOUDMILL_CREST_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

enum { CREST_POINTS = 128, CREST_TERMS = 8 };

/* What a point is to a crest: on a side; on what begins at the foot of a side; or on something
 * else, which the crest does not explain. */
enum crest_role { CREST_SIDE, CREST_FOOT, CREST_OTHER };

struct crest_fit {
    struct vec3 origin;  /* s and d begin at this point, as seen from above */
    double way_x, way_y; /* unit: the tangent */
    double off, bend;    /* of the crest from the origin; curvature, 1/mm */
    double
        c[CREST_TERMS]; /* t0, t1, t2, m and n where d < 0, m and n where d > 0, radius; 0: sharp */
    double far[2];      /* the points of both sides reach so far from the crest, */
    double from, to;    /* and from there to there along it */
    double rms;         /* of their distances, for those that the fit leaves free */
};

/*
 * The crest through n points about point[0], nearest first as seen from above, CREST_POINTS at
 * most, `spacing` apart; `within`: points of its sides are off them by no more, and by `even` on
 * average.  Fills the roles of all n.  -1: there is none that explains all points next to point[0].
 */
int crest_fit_find(const struct vec3 *point, size_t n, double spacing, double within, double even,
                   struct crest_fit *fit, enum crest_role *role);

/* The same, begun with a crest that was found about another point. */
int crest_fit_follow(const struct vec3 *point, size_t n, double spacing, double within, double even,
                     const struct crest_fit *from, struct crest_fit *fit, enum crest_role *role);

/* What n points are to it. */
void crest_fit_roles(const struct crest_fit *fit, const struct vec3 *point, size_t n,
                     double spacing, double within, enum crest_role *role);

/* Along and across the crest, of a place seen from above; false: nobody knows. */
bool crest_fit_local(const struct crest_fit *fit, double x, double y, double *s, double *d);

/* The place of the crest or its sides there; false: it has none. */
bool crest_fit_at(const struct crest_fit *fit, double s, double d, struct vec3 *place);

#endif

/*
 * height_knots - the B-spline surface with few poles that comes within an error of all points:
 * knots where the error is (Park and Kim 1995).
 *
 * Knots of each direction follow a density, which grows where a strip between two knots has larger
 * errors than the others: the errors of all strips become alike, as the error of a cubic by the
 * fourth power of its span has it (C. de Boor, Good approximation by splines with variable knots,
 * 1973).  Counts of poles grow in the direction that lowers the error most until it is kept, then
 * shrink as long as it is.
 */
#ifndef CLOUDMILL_HEIGHT_KNOTS_H
#define CLOUDMILL_HEIGHT_KNOTS_H

#include "nurbs/height_fit.h"

struct height_knots_options {
    double error;   /* mm */
    double smooth;  /* height_fit_solve */
    bool uniform;   /* knots at equal distances instead */
    size_t sampled; /* so many points are enough to look for knots; the fit is to all */
};

struct height_knots {
    struct height_fit fit;
    double worst; /* distance of a point, mm, to first order; above the error: it is not kept */
    size_t fits;  /* tried */
    bool bounded; /* more poles were too much work, or too many for the points */
};

/* Of n points over the rectangle.  -1: no fit at all. */
int height_knots_search(const struct vec3 *point, size_t n, const double range_x[2],
                        const double range_y[2], const struct height_knots_options *options,
                        struct height_knots *result);

#endif

/*
 * cloud_surface - from the points of a cloud to a NURBS surface: the indirect way of paper 1, fig.
 * 1.
 *
 *   1. the border of the scan and of its holes, which the surface is trimmed by (scan_border.h)
 *   2. a surface over the rectangle about the points: by least squares with knots where the error
 *      is (nurbs/height_knots.h), or patches on a net (nurbs/net_patches.h), whose corners have the
 *      height, and the slopes, of a surface of the third degree through the points about them; a
 *      corner beyond the points goes on from those beside it
 *   3. how far the points are from it
 */
#ifndef CLOUDMILL_CLOUD_SURFACE_H
#define CLOUDMILL_CLOUD_SURFACE_H

#include "base/error.h"
#include "nurbs/patch.h"

enum cloud_surface_kind { CLOUD_SURFACE_BSPLINE, CLOUD_SURFACE_FERGUSON, CLOUD_SURFACE_BEZIER };

struct cloud_surface_options {
    enum cloud_surface_kind kind;
    double error;     /* of the points from it, mm */
    double spacing;   /* of the net, mm; 0: by the error */
    double mean;      /* spacing of the points, mm */
    double gap;       /* a hole is wider than this, mm */
    double noise;     /* of the points, mm */
    double direction; /* of u, degrees from x towards y */
    double smooth;    /* of the B-spline: height_fit_solve */
    bool uniform;     /* its knots are at equal distances */
    bool untrimmed;
    int threads;
};

struct cloud_surface {
    struct patches patches; /* one surface */
    double worst, rms;      /* distance of the points, to first order, mm */
    struct vec3 at;         /* of the worst */
    double spacing;         /* of the net, mm */
    size_t fits, holes;     /* tried; in the border */
};

/* -1 and why: no area, no fit. */
int cloud_surface_make(const struct cloud_surface_options *options, const struct vec3s *points,
                       struct cloud_surface *result, struct error *error);

#endif

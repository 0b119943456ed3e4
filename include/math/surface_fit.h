/*
 * surface_fit - the surface that the noisy points of a scan are samples of, about one place: a
 * cubic or, where they determine none, a quadric, through as many of them as agree, outliers
 * without weight (Tukey's biweight).
 *
 * It is the robust one of a family of local surfaces, each through given points by least squares:
 *   plane_fit.h   a plane, distances across it; plane_normal (quadric.h) is the quick one
 *   quadric.h     second degree, heights over a frame; and what both quadric and cubic are asked:
 *                 normal, foot, curvature, distance
 *   cubic.h       third degree, as a struct quadric too
 *   moment_fit.h  quadric and cubic at once, of the points in a ball: the first round
 *   side_fit.h    plane or quadric on one side of an edge, in a frame that all sides share
 *   ridge_direction.h   along a rib or a groove
 *
 * How many points is a trade: through k points of noise sigma the foot of the place is uncertain by
 * about 2 sigma / sqrt(k) within the cloud and by more at its border, but the wider the
 * neighbourhood, the less of the surface is a cubic.  So the widest neighbourhood is taken whose
 * foot and normal agree with those of its nearer halves within what noise explains (O. Lepski's
 * rule, Theory of Probability and its Applications 35, 1991).  Where even few points are curved too
 * much, as on a rib or in a groove, they are taken from a neighbourhood that is longer the way it
 * runs; that way is the one in which such a neighbourhood is fitted best.
 *
 * All this is the second round.  In the first, one set of sums over a ball (moment_fit.h) and one
 * over its nearer half, or over a wider one, tell whether noise explains the points about a place:
 * of most surfaces it does.
 */
#ifndef CLOUDMILL_SURFACE_FIT_H
#define CLOUDMILL_SURFACE_FIT_H

#include <stdbool.h>

#include "math/point_grid.h"
#include "math/quadric.h"

struct surface_fit_options {
    const struct point_grid *point_grid; /* the scan */
    double sigma;                        /* its noise, one standard deviation, mm (noise.h) */
    size_t neighbours;                   /* to begin with */
    bool along; /* look along ribs and grooves, and again where no surface holds the points at all:
                   which takes its time */
    bool first; /* the first round alone: where it explains the points */
};

struct surface_fit {
    struct quadric q; /* its origin is the place, or the foot of that on a first fit */
    double offset;    /* of the place from the surface, signed along the first guess, mm */
    double spread;    /* of the points that count, for their freedom, mm */
    double reach;     /* of the neighbourhood, mm */
    size_t n;         /* points */
};

/* Room for a neighbourhood: one for each thread. */
struct surface_fit_hood;
struct surface_fit_hood *surface_fit_hood_new(void);
void surface_fit_hood_free(struct surface_fit_hood *hood);

/* How many points half of the places can take, by a sample of them.  `guess`: the normal
 * there, roughly, on either side. */
size_t surface_fit_typical(const struct surface_fit_options *rule, const struct vec3 *place,
                           const struct vec3 *guess, size_t n, int threads);

/* The surface about a place, from rule->neighbours points or, where these do not agree, fewer; from
 * up to four times as many where they tell little, as at a border, and from more still where they
 * carry none.  False: there is none. */
bool surface_fit_at(const struct surface_fit_options *rule, struct vec3 place, struct vec3 guess,
                    struct surface_fit_hood *hood, struct surface_fit *fit);

/* True if noise alone explains how the points are spread about it. */
bool surface_fit_holds(const struct surface_fit *fit, double sigma);

#endif

/*
 * settle - where a point of a noisy scan would be without its noise, by as few neighbours as tell.
 *
 * It moves onto the quadric through the most of its neighbours, MOST down to FEWEST, that lie about
 * one within ALIKE of the noise; where even the fewest do not, at an edge, it stays.  Small
 * neighbourhoods follow what larger ones (surface_fit.h) smooth over, and keep more of the noise.
 */
#ifndef CLOUDMILL_SETTLE_H
#define CLOUDMILL_SETTLE_H

#include "math/point_grid.h"

/* sigma: one standard deviation of the noise, mm, above 0. */
struct vec3 settle_point(const struct point_grid *grid, double sigma, struct vec3 p);

#endif

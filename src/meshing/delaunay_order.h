/*
 * delaunay_order - the order in which points are put into a triangulation: rounds, each about
 * eight times as large as the one before, of points chosen by chance; in a round along a Hilbert
 * curve, so that each point is near to the last one.
 */
#ifndef CLOUDMILL_DELAUNAY_ORDER_H
#define CLOUDMILL_DELAUNAY_ORDER_H

#include <stddef.h>

#include "math/uv.h"

/* The numbers of n points in that order, for the caller to free; always the same. */
int *delaunay_order(const struct uv *at, size_t n);

#endif

/*
 * stock_rest - what a stock leaves on the part.
 *
 * Of a point the distance to the nearest place of the stock's surface, found by steps along its
 * slope from the place above the point; the surface between columns is bilinear.  Points that have
 * others of the part far above them lie under it, and are left out.
 */
#ifndef CLOUDMILL_STOCK_REST_H
#define CLOUDMILL_STOCK_REST_H

#include "simulate/stock.h"

enum { STOCK_REST_PERCENTILES = 3, STOCK_REST_BINS = 1 << 16 }; /* 50, 95, 99 */

struct stock_rest {
    const struct vec3 *point;
    size_t points;         /* that are measured */
    size_t *order, *first; /* by tile of the stock: order[first[k]] to order[first[k + 1] - 1] */
    float *thick;          /* of each in `order` */
    double bin;            /* mm of each bin */
    size_t *count;         /* points in each bin */
};

struct stock_rest_sum {
    double worst;
    struct vec3 at;                      /* the point there */
    double part[STOCK_REST_PERCENTILES]; /* no finer than a bin: 1/65536 of the stock's height */
};

/* Keeps a pointer to the points. */
struct stock_rest stock_rest_new(const struct vec3 *point, size_t n, const struct stock *stock);
void stock_rest_free(struct stock_rest *rest);

/* Thickness at one point. */
double stock_rest_at(const struct stock *stock, struct vec3 p);

/* Looks again at the points whose tile was cut since the last time, or lies beside such a one. */
struct stock_rest_sum stock_rest_update(struct stock_rest *rest, struct stock *stock);

#endif

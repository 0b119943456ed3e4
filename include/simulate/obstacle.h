/*
 * obstacle - what shank and holder may run into: points of the part, or the stock as it is.
 */
#ifndef CLOUDMILL_OBSTACLE_H
#define CLOUDMILL_OBSTACLE_H

#include <stdbool.h>

#include "simulate/stock.h"
#include "simulate/tiles.h"

struct obstacle {
    struct tiles tiles;
    /* of the points of a part */
    const struct vec3 *point;
    size_t *order, *first; /* points of cell k: order[first[k]] to order[first[k + 1] - 1] */
    /* of a stock, whose changes it follows */
    struct stock *stock;
    struct vec3 hint; /* what was nearest the last time */
    bool hinted;
};

/* Keeps a pointer to the points. */
struct obstacle obstacle_points(const struct vec3 *point, size_t n);

/* The surface of the stock: tops of its columns, and the walls between them. */
struct obstacle obstacle_stock(struct stock *stock);

void obstacle_free(struct obstacle *obstacle);

/* What of it is nearest to the holder where it stands; below zero it is inside. */
void obstacle_nearest(struct obstacle *obstacle, struct tiles_search *search);

#endif

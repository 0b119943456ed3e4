/*
 * collision_body - what shank and holder may run into: points of the part, or the stock as it is.
 */
#ifndef CLOUDMILL_COLLISION_BODY_H
#define CLOUDMILL_COLLISION_BODY_H

#include <stdbool.h>

#include "simulate/stock.h"
#include "simulate/tiles.h"

struct collision_body {
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
struct collision_body collision_body_points(const struct vec3 *point, size_t n);

/* The surface of the stock: tops of its columns, and the walls between them. */
struct collision_body collision_body_stock(struct stock *stock);

void collision_body_free(struct collision_body *obstacle);

/* What of it is nearest to the holder where it stands; below zero it is inside. */
void collision_body_nearest(struct collision_body *obstacle, struct tiles_search *search);

#endif

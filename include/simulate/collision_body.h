/*
 * collision_body - what shank and holder may run into: points of the part, or the stock as it is.
 */
#ifndef CLOUDMILL_COLLISION_BODY_H
#define CLOUDMILL_COLLISION_BODY_H

#include <stdbool.h>

#include "gouge/holder.h"
#include "math/height_pyramid.h"
#include "simulate/stock.h"

struct collision_body {
    struct height_pyramid heights;
    /* of the points of a part */
    const struct vec3 *point;
    size_t *order, *first; /* points of cell k: order[first[k]] to order[first[k + 1] - 1] */
    /* of a stock, whose changes it follows */
    struct stock *stock;
    struct vec3 hint; /* what was nearest the last time */
    bool hinted;
};

/* A search: where shank and holder are, and what was found so far. */
struct holder_search {
    const struct holder *holder;
    struct vec3 centre, axis; /* of the ball; up the tool */
    double distance;          /* to the nearest place; on entry: what is no nearer is ignored */
    double enough;            /* a place nearer than this ends the search */
    struct vec3 at;           /* that place, if the distance got smaller */
};

/* Keeps a pointer to the points. */
struct collision_body collision_body_points(const struct vec3 *point, size_t n);

/* The surface of the stock: tops of its columns, and the walls between them. */
struct collision_body collision_body_stock(struct stock *stock);

void collision_body_free(struct collision_body *obstacle);

/* What of it is nearest to the holder where it stands; below zero it is inside. */
void collision_body_nearest(struct collision_body *obstacle, struct holder_search *search);

#endif

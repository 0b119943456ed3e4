/*
 * tiles - boxes over a grid of cells in X and Y, four of each level in one of the next: what of a
 * surface is nearest to a tool's shank and holder?
 *
 * A cell's box reaches from the lowest to the highest place of the surface in it.  What the surface
 * is, the one who made the tiles knows: it looks at a cell when its box comes near enough.
 */
#ifndef CLOUDMILL_TILES_H
#define CLOUDMILL_TILES_H

#include "gouge/holder.h"

enum { TILES_LEVELS = 16 };

struct tile {
    double low, high; /* of Z; low > high: nothing is in it */
};

struct tiles {
    double x, y;   /* corner of the first cell */
    double dx, dy; /* size of a cell */
    int levels, nx[TILES_LEVELS], ny[TILES_LEVELS];
    struct tile *level[TILES_LEVELS]; /* 0: the cells, along X first */
};

/* A search: where the holder stands, and what was found so far. */
struct tiles_search {
    const struct holder *holder;
    struct vec3 centre, axis; /* of the ball; up the tool */
    double distance;          /* to the nearest place, on entry: further ones are of no interest */
    double enough;            /* a place nearer than this ends the search */
    struct vec3 at;           /* that place, when the distance got smaller */
};

/* Looks at all places of a cell: tiles_look for each. */
typedef void tiles_visit(void *what, int i, int j, struct tiles_search *search);

/* nx x ny cells with nothing in them. */
struct tiles tiles_new(double x, double y, double dx, double dy, int nx, int ny);
void tiles_free(struct tiles *tiles);

/* Gives a cell its box and puts the boxes above it right. */
void tiles_set(struct tiles *tiles, int i, int j, struct tile tile);

/* One place more for the search; returns its distance. */
double tiles_look(struct tiles_search *search, struct vec3 place);

void tiles_nearest(const struct tiles *tiles, tiles_visit *visit, void *what,
                   struct tiles_search *search);

#endif

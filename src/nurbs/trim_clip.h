/*
 * trim_clip - the part of one cell of a grid to the left of the lines that run through it.
 */
#ifndef CLOUDMILL_TRIM_CLIP_H
#define CLOUDMILL_TRIM_CLIP_H

#include <stdbool.h>

#include "base/array.h"

/* A line through a cell, from border to border: vertices first..first + n - 1 of a list of ids. */
struct trim_chain {
    size_t cell, first, n;
    int side_in, side_out; /* bottom, right, top, left: 0 to 3 */
    double in, out;        /* how far along the side, counter-clockwise */
    bool used;             /* for trim_clip */
};

struct trim_chains {
    size_t n, cap;
    struct trim_chain *item;
};

/* Polygons one behind the other: polygon i ends in front of end.item[i]. */
struct polygons {
    struct ints id;
    struct sizes end;
};

/*
 * The n chains of one cell, their ids, and the cell's corners counter-clockwise from the lower
 * left, joined to closed polygons (Weiler and Atherton 1977).  False when chains do not enter and
 * leave by turns along the border.
 */
bool trim_clip(struct trim_chain *chain, size_t n, const int *id, const int corner[4],
               struct polygons *polygons);

void polygons_free(struct polygons *polygons);

#endif

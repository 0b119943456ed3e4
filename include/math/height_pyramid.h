/*
 * height_pyramid - the lowest and the highest Z of a surface over each cell of a grid in X and Y,
 * over each four cells together, and so on up to one cell that holds everything.
 *
 * It answers two questions of a search from above, and has the surface itself looked at only where
 * that matters: how high is anything beside a segment, and what is nearest to a body?
 */
#ifndef CLOUDMILL_HEIGHT_PYRAMID_H
#define CLOUDMILL_HEIGHT_PYRAMID_H

#include <stddef.h>

#include "math/vec.h"

enum { HEIGHT_PYRAMID_LEVELS = 24 };

struct height_range {
    double low, high; /* of Z, mm; low > high: the cell is empty */
};

struct height_level {
    int columns, rows;
    struct height_range *cell; /* row by row, along X first */
};

struct height_pyramid {
    double x, y;   /* the corner with the smallest x and y, mm */
    double dx, dy; /* size of a cell of level 0, mm */
    int levels;    /* cell (i, j) of a level holds those of the level before from (2 i, 2 j) on */
    struct height_level level[HEIGHT_PYRAMID_LEVELS];
};

struct height_cell {
    int column, row; /* of level 0 */
};

/* Empty cells. */
struct height_pyramid height_pyramid_new(double x, double y, double dx, double dy, int columns,
                                         int rows);

/* The heights of points, about sixteen to a cell where they lie evenly; no levels if n is 0. */
struct height_pyramid height_pyramid_over(const struct vec3 *point, size_t n);

void height_pyramid_free(struct height_pyramid *pyramid);

/* Gives a cell its range and brings the levels above it up to date. */
void height_pyramid_set(struct height_pyramid *pyramid, struct height_cell at,
                        struct height_range range);

/* The cell that `at` lies over, or the nearest one of the border. */
struct height_cell height_pyramid_cell(const struct height_pyramid *p, struct vec3 at);

/* Nothing that is nearer than `radius` to the segment from a to b, seen from above, is higher than
 * this: mm; -INFINITY where there is nothing.  Looked up in cells an eighth as wide as the area
 * asked for, or in the smallest. */
double height_pyramid_top(const struct height_pyramid *pyramid, struct vec3 a, struct vec3 b,
                          double radius);

/* A search for what is nearest to a body. */
struct height_search {
    /* No point of the box about `middle` that reaches `half` along X, Y and Z is nearer. */
    double (*bound)(void *context, struct vec3 middle, struct vec3 half);
    /* Looks at everything over a cell; returns how near the nearest is that was found so far. */
    double (*visit)(void *context, struct height_cell cell);
    void *context;
    double nearest; /* on entry: what is no nearer is of no interest */
    double enough;  /* anything nearer than this ends the search */
};

/* Visits the cells that may hold something nearer than what was found so far, nearest first. */
void height_pyramid_search(const struct height_pyramid *pyramid, struct height_search *search);

#endif

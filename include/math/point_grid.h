/*
 * point_grid - a cloud sorted in place into square cells seen from above: what is near, and what
 * lies over a place.
 *
 * The points are sorted within their own array: row by row of cells, in each cell by x, y, z.  So
 * their order, and whatever is computed in it, does not depend on the order of the file, and equal
 * points are neighbours.  Besides the points there are four bytes a cell.
 */
#ifndef CLOUDMILL_POINT_GRID_H
#define CLOUDMILL_POINT_GRID_H

#include <stdbool.h>
#include <stdint.h>

#include "base/array.h"
#include "base/error.h"
#include "math/vec.h"

struct point_grid {
    struct vec3 *point; /* the caller's */
    size_t n;
    double x, y, cell; /* lower left corner of the cells, their width, mm */
    size_t columns, rows;
    uint32_t *first; /* cell row * columns + column holds the points [first[cell], first[cell + 1])
                        of the array */
};

/*
 * Sorts n points, whose mean spacing is about `spacing` mm, into cells CELLS_WIDE times as wide.  A
 * few points far off do not widen the grid: they go to the cells at its border.  -1: no points, or
 * 2^32 and more; says why.
 */
int point_grid_make(struct vec3 *point, size_t n, double spacing, int threads,
                    struct point_grid *point_grid, struct error *error);
void point_grid_free(struct point_grid *point_grid);

/*
 * For a cloud that is never whole in memory: the cells that point_grid_make lays over n points in
 * the box from `low` to `high` (where the box is mostly empty, cells over all of it), without
 * points; and some of them, all those of the cells that are looked at, sorted into these.  What is
 * found there is what would be found in the grid of all points, in the same order.
 */
struct point_grid point_grid_lattice(struct vec3 low, struct vec3 high, size_t n, double spacing);
int point_grid_make_in(const struct point_grid *lattice, struct vec3 *point, size_t n, int threads,
                       struct point_grid *point_grid, struct error *error);

/* The number of a place's cell, from 0 on row by row. */
size_t point_grid_cell(const struct point_grid *point_grid, struct vec3 place);

/* The mean spacing of the points, by the width of the cells. */
double point_grid_spacing(const struct point_grid *point_grid);

/* The column and the row of a place; of one outside, of the nearest cell. */
size_t point_grid_column(const struct point_grid *point_grid, double x);
size_t point_grid_row(const struct point_grid *point_grid, double y);

/* A walk over the points of the cells that a place and its surroundings, as far as `reach` to all
 * four sides, are in: all points so near to it as seen from above, in their order, and some more.
 *     struct point_grid_walk walk = point_grid_about(grid, place, reach);
 *     for (size_t k; point_grid_next(&walk, &k);) */
struct point_grid_walk {
    const struct point_grid *grid;
    size_t left, right; /* columns */
    size_t row, high;   /* the next row of cells, and the last one */
    size_t next, end;   /* the next point, and where those of its row end */
};

struct point_grid_walk point_grid_about(const struct point_grid *point_grid, struct vec3 place,
                                        double reach);

/* The next point's index; false: there is none. */
static inline bool point_grid_next(struct point_grid_walk *w, size_t *k)
{
    while (w->next == w->end) {
        if (w->row > w->high)
            return false;
        size_t cells = w->row++ * w->grid->columns;
        w->next = w->grid->first[cells + w->left];
        w->end = w->grid->first[cells + w->right + 1];
    }
    *k = w->next++;
    return true;
}

/* Appends the indices of the points over (or under) the triangle a b c, whose corners go round
 * counter-clockwise seen from above; `border` mm2 (twice an area): how far beside it counts yet. */
void point_grid_over(const struct point_grid *point_grid, struct vec3 a, struct vec3 b,
                     struct vec3 c, double border, struct sizes *found);

/* Appends the indices of all points within `radius` of q (<=), in their order. */
void point_grid_within(const struct point_grid *point_grid, struct vec3 q, double radius,
                       struct sizes *found);

/* Removes the points i with out[i] not 0; the others close up. */
void point_grid_remove(struct point_grid *point_grid, const unsigned char *out);

/* The k points nearest to q in space, nearest first (fewer when there are fewer); of points equally
 * near the first in the array.  Their indices, and their squared distances.  Returns how many. */
size_t point_grid_nearest(const struct point_grid *point_grid, struct vec3 q, size_t k,
                          uint32_t *index, double *distance2);

/* The same points themselves, at most POINT_GRID_NEAR of them. */
enum { POINT_GRID_NEAR = 64 };
size_t point_grid_near(const struct point_grid *point_grid, struct vec3 q, size_t k,
                       struct vec3 *near);

#endif

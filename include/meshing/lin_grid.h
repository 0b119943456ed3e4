/*
 * lin_grid - scanned points put in order on a rectangular grid by linear interpolation along rows
 * of points and between them (Lin and Liu 1998; paper 1, section 2.2, figs 7 and 8).
 *
 * A row of points is a band of the cloud as high as the points are apart, in the order of x: the
 * lines of a scanner fall into bands of their own or, where they are closer or slanted, their
 * points take turns in one.  On each column of the grid a row has the place on the straight line
 * between its two points beside the column; a node has the height between those of the two rows
 * beside it.  At a border both steps go on along the last straight line, if that is no steeper than
 * 70 degrees.
 */
#ifndef CLOUDMILL_LIN_GRID_H
#define CLOUDMILL_LIN_GRID_H

#include "base/error.h"
#include "cloud/plan_extent.h"

struct lin_grid_options {
    double spacing; /* largest distance of columns, and of rows, mm */
    double mean;    /* spacing of the points, mm */
    double gap;     /* no interpolation over more than this, mm */
    double reach;   /* no extrapolation by more than this, mm */
};

struct lin_grid {
    struct plan_extent extent; /* nodes stand from border to border of it */
    double dx, dy;             /* distance of columns and of rows, mm */
    size_t columns, rows;      /* 2 at least */
    double *z;                 /* [row * columns + column], mm; NAN: there are no points near */
};

/* -1: it would have more than 50 nodes for each of the n points (and 1,000). */
int lin_grid_make(const struct plan_extent *extent, const struct vec3 *point, size_t n,
                  const struct lin_grid_options *options, struct lin_grid *grid,
                  struct error *error);

void lin_grid_free(struct lin_grid *grid);

/* A node in the scan's axes, which has a height. */
struct vec3 lin_grid_node(const struct lin_grid *grid, size_t column, size_t row);

#endif

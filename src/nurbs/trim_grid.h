/*
 * trim_grid - the part of a grid of parameter lines that lies inside closed polygons, as triangles.
 *
 * Cells that no polygon crosses become two triangles each.  Of the others the part inside is cut
 * out exactly along the polygon and triangulated.  Neighbouring cells share the points where a
 * polygon crosses from one to the other, so that the triangles leave no gaps.
 *
 * Stages: corners and lines are snapped to whole numbers (trim_snap); each polygon is followed from
 * cell to cell and leaves a chain in each (in trim_grid); the chains of a cell and its corners are
 * joined to polygons (trim_clip: Weiler and Atherton 1977), which are cut up by their ears.
 */
#ifndef CLOUDMILL_TRIM_GRID_H
#define CLOUDMILL_TRIM_GRID_H

#include <stdint.h>

#include "base/array.h"
#include "math/faces.h"
#include "trim_loops.h"

struct uvmesh {
    struct uvs at;
    struct faces face; /* counter-clockwise in the plane of u and v */
    size_t unclear;    /* cells where the polygons cross themselves or each other: all or nothing */
};

/*
 * u and v are the lines, rising; the first and the last bound the grid.  Inside is what an odd
 * number of loops go round, or an even number where `open`.  A loop that crosses no line gets one:
 * `u` grows.  Points of the loops may be a little outside the grid: they are moved to its edge.
 */
void trim_grid(struct doubles *u, const struct doubles *v, const struct uv_polygon *loops,
               bool open, struct uvmesh *mesh);

void uvmesh_free(struct uvmesh *mesh);

/*
 * One parameter as whole numbers, so that the side of a grid line on which a place lies is decided
 * without rounding: the lines are even numbers, all other places odd ones.
 */
struct trim_snap {
    double from, width; /* of the grid, in the parameter */
    size_t n;
    int64_t *line; /* rising */
};

/* Of these lines, at least two, no two of them within 1e-6 of the whole width. */
struct trim_snap trim_snap_new(const struct doubles *line);

/* How many lines lie below x; the column that x lies in is one less. */
size_t trim_snap_below(const struct trim_snap *snap, int64_t x);

/*
 * The whole number of the place x, odd.  A place within rounding of a line (4.5e-7 of the
 * whole width) goes to the number beside the line: outside the grid for the first and the last
 * line, else to the side of the sign of `inwards`, so that a polygon along the line leaves no
 * sliver.
 */
int64_t trim_snap_place(const struct trim_snap *snap, double x, double inwards);

void trim_snap_free(struct trim_snap *snap);

/* The part of a polygon in one cell, from border to border: vertices first..first + n - 1 of a list
 * of ids. */
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

/* Polygons in one list: polygon i ends before end.item[i]. */
struct polygons {
    struct ints id;
    struct sizes end;
};

/*
 * The part of a cell to the left of its n chains: the chains, their ids, and the cell's corners
 * counter-clockwise from the lower left, joined to closed polygons.  False when chains do not enter
 * and leave by turns along the border of the cell.
 */
bool trim_clip(struct trim_chain *chain, size_t n, const int *id, const int corner[4],
               struct polygons *polygons);

void polygons_free(struct polygons *polygons);

#endif

/*
 * trim_snap - places in the plane of two parameters as whole numbers, so that what lies on which
 * side of a grid line is decided without rounding: the lines are even, all other places odd.
 */
#ifndef CLOUDMILL_TRIM_SNAP_H
#define CLOUDMILL_TRIM_SNAP_H

#include <stdint.h>

#include "base/array.h"

/* One parameter: the lines of the grid on the lattice, rising. */
struct trim_lattice {
    double from, width; /* of the grid, in the parameter */
    size_t n;
    int64_t *line;
};

/* The lattice of these lines, at least two, no two of them within 1e-6 of the whole width. */
struct trim_lattice trim_snap_new(const struct doubles *line);

/* How many lines lie below x; the column that x lies in is one less. */
size_t trim_snap_below(const struct trim_lattice *lattice, int64_t x);

/*
 * The place of x, odd.  Within 6e-8 of the whole width a line counts as met: then the place is one
 * step beside it, outside the grid for the first and the last line, else to the side of the sign of
 * `inwards`, so that a polygon along the line leaves no sliver.
 */
int64_t trim_snap_place(const struct trim_lattice *lattice, double x, double inwards);

void trim_snap_free(struct trim_lattice *lattice);

#endif

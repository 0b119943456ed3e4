/*
 * roofs - how high points stand, cell by cell of a grid seen from above: what tells that a ball
 * high over them touches none, without a look at the points.
 */
#ifndef CLOUDMILL_ROOFS_H
#define CLOUDMILL_ROOFS_H

#include <stddef.h>

#include "math/vec.h"

enum { ROOFS_LEVELS = 24 };

struct roofs_level {
    size_t columns, rows;
    double *top; /* by row: the highest z in each cell, -INFINITY in an empty one */
};

struct roofs {
    double x, y, cell; /* the corner with the smallest x and y; width of a cell, mm */
    size_t columns, rows, levels;
    struct roofs_level level[ROOFS_LEVELS]; /* of each four cells of the one before make one */
    double *top;                            /* of all levels */
};

/* About sixteen points to a cell, where they lie evenly. */
struct roofs roofs_over(const struct vec3 *point, size_t n);
void roofs_free(struct roofs *roofs);

/* No point that is nearer than `radius` to the straight way from a to b, seen from above, is higher
 * than this: mm; -INFINITY where there are none.  Looked up in cells that are an eighth as wide as
 * what is looked at, or the narrowest. */
double roofs_top(const struct roofs *roofs, struct vec3 a, struct vec3 b, double radius);

#endif

/*
 * height_pyramid - how high points stand, cell by cell of a grid seen from above: what tells that a
 * ball high over them touches none, without a look at the points.
 */
#ifndef CLOUDMILL_HEIGHT_PYRAMID_H
#define CLOUDMILL_HEIGHT_PYRAMID_H

#include <stddef.h>

#include "math/vec.h"

enum { HEIGHT_PYRAMID_LEVELS = 24 };

struct height_pyramid_level {
    size_t columns, rows;
    double *top; /* by row: the highest z in each cell, -INFINITY in an empty one */
};

struct height_pyramid {
    double x, y, cell; /* the corner with the smallest x and y; width of a cell, mm */
    size_t columns, rows, levels;
    struct height_pyramid_level
        level[HEIGHT_PYRAMID_LEVELS]; /* of each four cells of the one before make one */
    double *top;                      /* of all levels */
};

/* About sixteen points to a cell, where they lie evenly. */
struct height_pyramid height_pyramid_over(const struct vec3 *point, size_t n);
void height_pyramid_free(struct height_pyramid *height_pyramid);

/* No point that is nearer than `radius` to the straight way from a to b, seen from above, is higher
 * than this: mm; -INFINITY where there are none.  Looked up in cells that are an eighth as wide as
 * what is looked at, or the narrowest. */
double height_pyramid_top(const struct height_pyramid *height_pyramid, struct vec3 a, struct vec3 b,
                          double radius);

#endif

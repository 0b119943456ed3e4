/*
 * stock - what is left of a block while the ball cuts it: columns of material along Z.
 *
 * Columns stand on a grid in X and Y, each a list of intervals of Z (dexels), so that what a ball
 * leaves standing above itself stays.  The ball moves along straight pieces, each an exact
 * capsule; a column is cut exactly where its middle line passes through, whatever the grid.  What
 * the grid decides is how finely the block is looked at: a volume is the sum over the columns
 * (midpoint rule).  Lengths in mm.
 */
#ifndef CLOUDMILL_STOCK_H
#define CLOUDMILL_STOCK_H

#include <stddef.h>

#include "base/array.h"
#include "math/vec.h"

enum { STOCK_TILE = 8, STOCK_NONE = -1 };

/* Marks of a tile of columns that has changed, one for each part that follows the stock. */
enum { STOCK_FOR_HOLDER = 1, STOCK_FOR_LEFT = 2 };

/* The uppermost interval of one column; low >= high: nothing is left. */
struct stock_column {
    double low, high;
    float taken;   /* of its height in the pass ... */
    unsigned pass; /* ... that cut it last */
    int more;      /* the interval below it, of stock.more; STOCK_NONE: it is the last */
};

struct stock_interval {
    double low, high;
    int more;
};

struct stock {
    double x, y;                 /* of the first column's middle line */
    double dx, dy;               /* from one column to the next */
    int nx, ny;                  /* columns along X and Y */
    double bottom;               /* no column reaches lower */
    struct stock_column *column; /* along X first */
    struct {
        size_t n, cap;
        struct stock_interval *item;
    } more;
    int tiles_x, tiles_y; /* tiles of STOCK_TILE x STOCK_TILE columns */
    unsigned char *changed;
    struct ints holder; /* the tiles marked STOCK_FOR_HOLDER */
};

/* A box between two corners, its columns no further than `cell` mm apart, at least 2 x 2. */
struct stock stock_box(struct vec3 low, struct vec3 high, double cell);
void stock_free(struct stock *stock);

/* The middle of column (i, j). */
static inline double stock_x(const struct stock *s, int i)
{
    return s->x + i * s->dx;
}

static inline double stock_y(const struct stock *s, int j)
{
    return s->y + j * s->dy;
}

static inline struct stock_column *stock_at(const struct stock *s, int i, int j)
{
    return &s->column[(size_t)j * (size_t)s->nx + (size_t)i];
}

/* The column that a place is nearest to, as seen from above. */
static inline void stock_nearest(const struct stock *s, struct vec3 p, size_t *i, size_t *j)
{
    *i = (size_t)fmin(fmax((p.x - s->x) / s->dx + 0.5, 0), s->nx - 1);
    *j = (size_t)fmin(fmax((p.y - s->y) / s->dy + 0.5, 0), s->ny - 1);
}

/* Of n points column[i], along X first, is the one that point i is nearest to; the height of the
 * highest of each column, -HUGE_VAL where there is none.  To be freed. */
double *stock_highest(const struct stock *s, const struct vec3 *point, size_t n, size_t *column);

/* What one straight move of the ball takes off. */
struct stock_bite {
    double volume; /* mm^3 */
    double depth;  /* the deepest, along the normal of the cut */
    struct vec3 at;
};

/*
 * The ball goes straight from a to b.  With `pass` above 0 it cuts, and a bite's depth is all that
 * pieces of that pass took at the place; with 0 nothing is cut, only found.
 */
struct stock_bite stock_capsule(struct stock *stock, struct vec3 a, struct vec3 b, double radius,
                                unsigned pass);

/* Material left, mm^3. */
double stock_volume(const struct stock *stock);

/* How much material of a column stands above z, mm. */
double stock_above(const struct stock *stock, const struct stock_column *column, double z);

#endif

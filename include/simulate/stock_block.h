/*
 * stock_block - the block that a part is cut from: a box around its points, or its surface and
 * more.  Lengths in mm.
 */
#ifndef CLOUDMILL_STOCK_BLOCK_H
#define CLOUDMILL_STOCK_BLOCK_H

#include "simulate/stock.h"

enum stock_kind {
    STOCK_AROUND,  /* the box around the points, on its sides and its top `allowance` larger */
    STOCK_BETWEEN, /* the box between low and high */
    STOCK_OFFSET   /* all within `allowance` of the surface or below it */
};

struct stock_options {
    enum stock_kind kind;
    double allowance; /* mm */
    struct vec3 low, high;
};

/*
 * How far columns are apart when nobody says: a five-hundredth of the longer side, no less than a
 * twenty-fifth of the ball's radius, mm.
 */
double stock_cell(const struct stock_options *options, const struct vec3 *point, size_t n,
                  double radius);

/*
 * The block for n points, its columns `cell` mm apart.  For STOCK_OFFSET the surface's height over
 * a column is that of the quadric through the NEAR nearest points seen from above; it is offset
 * along its normals, and by balls about it where it is hollow.  Columns further from all points,
 * seen from above, than two of their mean distances and the allowance are empty.
 */
struct stock stock_new(const struct stock_options *options, const struct vec3 *point, size_t n,
                       double cell);

#endif

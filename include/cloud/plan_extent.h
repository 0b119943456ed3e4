/*
 * plan_extent - what a cloud covers, seen from above (along z).
 *
 * The grid's own axes may be turned about z against the scan's (paper 1, 3.1: the direction of
 * the rows); a plan_extent's box lies along them.
 */
#ifndef CLOUDMILL_PLAN_EXTENT_H
#define CLOUDMILL_PLAN_EXTENT_H

#include <stddef.h>

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "math/vec.h"

struct plan_extent {
    double cosine, sine;           /* of the direction of the rows, from the scan's x axis */
    double xmin, xmax, ymin, ymax; /* box of the points along the grid's axes, mm */
};

/* `direction` in degrees; n > 0. */
struct plan_extent plan_extent_of(const struct vec3 *point, size_t n, double direction);

/* The same of points that come in blocks. */
struct plan_extent plan_extent_begin(double direction);
void plan_extent_add(struct plan_extent *f, const struct vec3 *point, size_t n);

/* A point in the grid's axes. */
static inline struct vec3 plan_extent_turn(const struct plan_extent *f, struct vec3 p)
{
    return vec(f->cosine * p.x + f->sine * p.y, f->cosine * p.y - f->sine * p.x, p.z);
}

/* The way back from them. */
static inline struct vec3 plan_extent_turn_back(const struct plan_extent *f, struct vec3 p)
{
    return vec(f->cosine * p.x - f->sine * p.y, f->sine * p.x + f->cosine * p.y, p.z);
}

/* Points that carry no surface: fewer than 3, all in one place, all on one line or in two clumps
 * far apart seen from above: -1 and why (without the name of a file). */
int plan_extent_check(const struct vec3 *point, size_t n, struct error *error);

/*
 * Mean spacing of the points, mm: sqrt(area / n), the area being that of the cells with points in
 * them; the cells are five times as wide as the spacing that follows from them, so that neither
 * the gaps between laser lines nor an empty corner of the box deceive.
 */
double plan_extent_spacing(const struct plan_extent *f, const struct vec3 *point, size_t n);

/* The same, step by step, of points that come in blocks, as often as asked for: a width; all points
 * to the cells of that width; their area; true: again. */
struct plan_spacing {
    size_t n;
    double spacing; /* so far, mm */
    int rounds;
};

struct plan_spacing plan_spacing_begin(const struct plan_extent *f, size_t n);
double plan_spacing_width(const struct plan_spacing *s);
bool plan_spacing_next(struct plan_spacing *s, double area);

/* The cells of an extent, divided evenly into such near `width`, that have points in them. */
struct plan_cells {
    struct plan_extent extent;
    double columns, rows, right, up; /* how many, and how many a mm */
    size_t n, mask;                  /* a set with open addressing, empty where zero */
    uint64_t *key, last;             /* mask 0: a bit for each cell */
};

/* n: points that will come.  The end returns the area of the cells with points, mm2. */
struct plan_cells plan_cells_begin(const struct plan_extent *f, size_t n, double width);
void plan_cells_add(struct plan_cells *cells, const struct vec3 *point, size_t n);
double plan_cells_end(struct plan_cells *cells);

#endif

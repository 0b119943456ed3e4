/* raster - see raster.h. */
#include "raster.h"

#include <stdlib.h>

#include "base/array.h"

static size_t cell_count(double from, double to, double cell)
{
    double n = ceil((to - from) / cell);
    return n >= 1 ? (size_t)n : 1;
}

struct raster raster_new(double left, double bottom, double right, double top, double cell)
{
    struct raster r = {.left = left, .bottom = bottom, .cell = cell};
    r.columns = cell_count(left, right, cell);
    r.rows = cell_count(bottom, top, cell);
    size_t n = r.columns * r.rows;
    r.depth = mem_alloc(n, sizeof *r.depth);
    r.owner = mem_alloc(n, sizeof *r.owner);
    for (size_t i = 0; i < n; i++)
        r.depth[i] = -INFINITY;
    return r;
}

void raster_free(struct raster *raster)
{
    free(raster->depth);
    free(raster->owner);
    raster->depth = NULL;
    raster->owner = NULL;
}

/* The cell along one direction, within 0 to n - 1. */
static size_t cell_along(double from, double x, double cell, size_t n)
{
    double i = floor((x - from) / cell);
    if (!(i > 0))
        return 0;
    return i < (double)n ? (size_t)i : n - 1;
}

size_t raster_cell(const struct raster *r, double x, double y)
{
    return cell_along(r->bottom, y, r->cell, r->rows) * r->columns +
           cell_along(r->left, x, r->cell, r->columns);
}

static void draw(struct raster *r, size_t cell, double depth, size_t owner)
{
    if (depth > r->depth[cell]) {
        r->depth[cell] = depth;
        r->owner[cell] = owner;
    }
}

bool raster_point(struct raster *r, struct vec3 p, size_t owner)
{
    size_t cell = raster_cell(r, p.x, p.y);
    bool empty = isinf(r->depth[cell]);
    draw(r, cell, p.z, owner);
    return empty;
}

/* The cells that a box touches: columns [c0, c1], rows [r0, r1]. */
struct arc_window {
    size_t c0, c1, r0, r1;
};

static struct arc_window window(const struct raster *r, double left, double bottom, double right,
                                double top)
{
    return (struct arc_window){cell_along(r->left, left, r->cell, r->columns),
                               cell_along(r->left, right, r->cell, r->columns),
                               cell_along(r->bottom, bottom, r->cell, r->rows),
                               cell_along(r->bottom, top, r->cell, r->rows)};
}

static struct vec3 cell_middle(const struct raster *r, size_t column, size_t row)
{
    return vec(r->left + ((double)column + 0.5) * r->cell,
               r->bottom + ((double)row + 0.5) * r->cell, 0);
}

void raster_disc(struct raster *r, struct vec3 p, double radius, size_t owner)
{
    struct arc_window w = window(r, p.x - radius, p.y - radius, p.x + radius, p.y + radius);
    for (size_t row = w.r0; row <= w.r1; row++)
        for (size_t column = w.c0; column <= w.c1; column++) {
            struct vec3 m = cell_middle(r, column, row);
            if (hypot(m.x - p.x, m.y - p.y) <= radius)
                draw(r, row * r->columns + column, p.z, owner);
        }
}

/* A plane triangle over the cells: its depth in the middle of one, NAN beside it. */
struct cover {
    struct vec3 a, b, c;
    double all;
    struct arc_window window;
};

static bool cover_begin(const struct raster *r, struct vec3 a, struct vec3 b, struct vec3 c,
                        struct cover *cover)
{
    *cover = (struct cover){.a = a, .b = b, .c = c, .all = vec_orient_xy(a, b, c)};
    cover->window = window(r, fmin(a.x, fmin(b.x, c.x)), fmin(a.y, fmin(b.y, c.y)),
                           fmax(a.x, fmax(b.x, c.x)), fmax(a.y, fmax(b.y, c.y)));
    return fabs(cover->all) > 0;
}

static double cover_depth(const struct cover *k, struct vec3 m)
{
    double u = vec_orient_xy(m, k->b, k->c) / k->all, v = vec_orient_xy(k->a, m, k->c) / k->all,
           t = 1 - u - v;
    bool inside = u >= -1e-12 && v >= -1e-12 && t >= -1e-12;
    return inside ? u * k->a.z + v * k->b.z + t * k->c.z : NAN;
}

void raster_triangle(struct raster *r, struct vec3 a, struct vec3 b, struct vec3 c, size_t owner)
{
    struct cover k;
    if (!cover_begin(r, a, b, c, &k))
        return;
    for (size_t row = k.window.r0; row <= k.window.r1; row++)
        for (size_t column = k.window.c0; column <= k.window.c1; column++)
            draw(r, row * r->columns + column, cover_depth(&k, cell_middle(r, column, row)), owner);
}

bool raster_hides(const struct raster *r, struct vec3 a, struct vec3 b, struct vec3 c, double slack)
{
    struct cover k;
    if (!cover_begin(r, a, b, c, &k))
        return false;
    for (size_t row = k.window.r0; row <= k.window.r1; row++)
        for (size_t column = k.window.c0; column <= k.window.c1; column++)
            if (cover_depth(&k, cell_middle(r, column, row)) + slack <
                r->depth[row * r->columns + column])
                return true;
    return false;
}

bool raster_visible(const struct raster *r, struct vec3 p, double slack)
{
    return p.z + slack >= r->depth[raster_cell(r, p.x, p.y)];
}

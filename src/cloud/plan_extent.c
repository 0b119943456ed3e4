/* plan_extent - see plan_extent.h. */
#include "cloud/plan_extent.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"

struct plan_extent plan_extent_of(const struct vec3 *point, size_t n, double direction)
{
    double quarter = direction / 90, turn = RADIANS(direction);
    struct plan_extent f = {cos(turn), sin(turn), 0, 0, 0, 0};
    if (quarter == floor(quarter)) { /* no cos 90 = 6e-17: points in rows stay in rows */
        f.cosine = round(f.cosine);
        f.sine = round(f.sine);
    }
    struct vec3 p = plan_extent_turn(&f, point[0]);
    f.xmin = f.xmax = p.x;
    f.ymin = f.ymax = p.y;
    for (size_t i = 1; i < n; i++) {
        p = plan_extent_turn(&f, point[i]);
        f.xmin = p.x < f.xmin ? p.x : f.xmin;
        f.xmax = p.x > f.xmax ? p.x : f.xmax;
        f.ymin = p.y < f.ymin ? p.y : f.ymin;
        f.ymax = p.y > f.ymax ? p.y : f.ymax;
    }
    return f;
}

static double distance2(struct vec3 a, struct vec3 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/* The point farthest from p, seen from above. */
static struct vec3 farthest_point(const struct vec3 *point, size_t n, struct vec3 p)
{
    struct vec3 far = p;
    double most = -1;
    for (size_t i = 0; i < n; i++) {
        double d2 = distance2(point[i], p);
        if (d2 > most) {
            most = d2;
            far = point[i];
        }
    }
    return far;
}

/* Are all points so near to a or to b that there is nothing else between these two? */
static bool two_clumps(const struct vec3 *point, size_t n, struct vec3 a, struct vec3 b)
{
    const double near2 = 1e-6 * distance2(a, b);
    for (size_t i = 0; i < n; i++)
        if (distance2(point[i], a) > near2 && distance2(point[i], b) > near2)
            return false;
    return true;
}

/* Does one point stand off the line from a to b by a part of its length that matters? */
static bool is_wide(const struct vec3 *point, size_t n, struct vec3 a, struct vec3 b)
{
    const double narrow = 1e-6;
    double least = narrow * distance2(a, b);
    for (size_t i = 0; i < n; i++) {
        double across = vec_orient_xy(a, b, point[i]);
        if (fabs(across) > least)
            return true;
    }
    return false;
}

int plan_extent_check(const struct vec3 *point, size_t n, struct error *error)
{
    if (n == 0)
        return error_set(error, "no points");
    if (n < 3)
        return error_set(error, "found %zu point%s, expected at least 3", n, n == 1 ? "" : "s");
    struct vec3 a = point[0], b = farthest_point(point, n, a);
    if (distance2(a, b) == 0)
        return error_set(error,
                         "all %zu points are in one place seen from above (%g, %g), expected "
                         "points over an area",
                         n, a.x, a.y);
    if (two_clumps(point, n, a, b))
        return error_set(error,
                         "found points %g mm apart and nothing between, at (%g, %g) and (%g, %g): "
                         "an outlier far off?, expected one cloud",
                         sqrt(distance2(a, b)), a.x, a.y, b.x, b.y);
    if (is_wide(point, n, a, b))
        return 0;
    a = farthest_point(point, n, b); /* b is one end, this the other */
    return error_set(error,
                     "all %zu points are on one line seen from above, from (%g, %g) to (%g, %g), "
                     "expected points over an area",
                     n, a.x, a.y, b.x, b.y);
}

/* A set of cells: open addressing, empty where zero. */
struct cells {
    size_t n, mask;
    uint64_t *key;
};

static void add_cell(struct cells *c, uint64_t key)
{
    size_t at = (size_t)(key * 0x9E3779B97F4A7C15u >> 32) & c->mask;
    while (c->key[at] != 0 && c->key[at] != key)
        at = (at + 1) & c->mask;
    c->n += c->key[at] == 0;
    c->key[at] = key;
}

/* How many cells of its width a length has: a whole number from 1 to 2e9. */
static double cells_along(double length, double width)
{
    return fmin(fmax(round(length / width), 1), 2e9);
}

/* Area of the cells with points in them, the box divided evenly into cells near `width`. */
static double occupied_area(const struct plan_extent *f, const struct vec3 *point, size_t n,
                            double width)
{
    double w = f->xmax - f->xmin, h = f->ymax - f->ymin;
    double columns = cells_along(w, width), rows = cells_along(h, width);
    double right = columns / w, up = rows / h;
    double most = fmin((double)n, columns * rows);
    size_t size = 64;
    while ((double)size < 2 * most)
        size *= 2;
    struct cells cells = {0, size - 1, mem_alloc(size, sizeof *cells.key)};
    uint64_t last = 0;
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = plan_extent_turn(f, point[i]);
        double column = (p.x - f->xmin) * right, row = (p.y - f->ymin) * up;
        column = column < columns ? column : columns - 1;
        row = row < rows ? row : rows - 1;
        uint64_t key = ((uint64_t)column << 32 | (uint64_t)row) + 1;
        if (key != last) /* scanned in order, most points fall into the cell of the one before */
            add_cell(&cells, key);
        last = key;
    }
    free(cells.key);
    return (double)cells.n / (right * up);
}

double plan_extent_spacing(const struct plan_extent *f, const struct vec3 *point, size_t n)
{
    enum { CELL = 5, ROUNDS = 20 };
    double spacing = sqrt((f->xmax - f->xmin) * (f->ymax - f->ymin) / (double)n);
    for (int i = 0; i < ROUNDS; i++) {
        double next = sqrt(occupied_area(f, point, n, CELL * spacing) / (double)n);
        bool settled = fabs(next - spacing) < 0.05 * spacing;
        spacing = next;
        if (settled)
            break;
    }
    return spacing;
}

/* footprint - see footprint.h. */
#include "footprint.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "array.h"

struct footprint footprint_of(const struct vec3 *point, size_t n, double direction)
{
    double quarter = direction / 90, turn = RADIANS(direction);
    struct footprint f = {cos(turn), sin(turn), 0, 0, 0, 0};
    if (quarter == floor(quarter)) { /* no cos 90 = 6e-17: points in rows stay in rows */
        f.cosine = round(f.cosine);
        f.sine = round(f.sine);
    }
    struct vec3 p = footprint_turn(&f, point[0]);
    f.xmin = f.xmax = p.x;
    f.ymin = f.ymax = p.y;
    for (size_t i = 1; i < n; i++) {
        p = footprint_turn(&f, point[i]);
        f.xmin = p.x < f.xmin ? p.x : f.xmin;
        f.xmax = p.x > f.xmax ? p.x : f.xmax;
        f.ymin = p.y < f.ymin ? p.y : f.ymin;
        f.ymax = p.y > f.ymax ? p.y : f.ymax;
    }
    return f;
}

/* The point farthest from p, seen from above. */
static struct vec3 farthest(const struct vec3 *point, size_t n, struct vec3 p)
{
    struct vec3 far = p;
    double most = -1;
    for (size_t i = 0; i < n; i++) {
        double d = hypot(point[i].x - p.x, point[i].y - p.y);
        if (d > most) {
            most = d;
            far = point[i];
        }
    }
    return far;
}

/* Are all points so near to a or to b that there is nothing else between these two? */
static bool two_clumps(const struct vec3 *point, size_t n, struct vec3 a, struct vec3 b)
{
    const double near = 1e-3 * hypot(b.x - a.x, b.y - a.y);
    for (size_t i = 0; i < n; i++)
        if (hypot(point[i].x - a.x, point[i].y - a.y) > near &&
            hypot(point[i].x - b.x, point[i].y - b.y) > near)
            return false;
    return true;
}

int footprint_check(const struct vec3 *point, size_t n, struct error *error)
{
    enum { NARROWEST = 1000000 }; /* times as long as wide */
    if (n == 0)
        return error_set(error, "no points");
    if (n < 3)
        return error_set(error, "found %zu point%s, expected at least 3", n, n == 1 ? "" : "s");
    struct vec3 a = farthest(point, n, point[0]);
    struct vec3 b = farthest(point, n, a);
    double length = hypot(b.x - a.x, b.y - a.y), width = 0;
    if (length == 0)
        return error_set(error,
                         "all %zu points are in one place seen from above (%g, %g), expected "
                         "points over an area",
                         n, a.x, a.y);
    if (two_clumps(point, n, a, b))
        return error_set(error,
                         "found points %g mm apart and nothing between, at (%g, %g) and (%g, %g): "
                         "an outlier far off?, expected one cloud",
                         length, a.x, a.y, b.x, b.y);
    for (size_t i = 0; i < n; i++) {
        double across = (b.x - a.x) * (point[i].y - a.y) - (b.y - a.y) * (point[i].x - a.x);
        width = fmax(width, fabs(across) / length);
    }
    if (width * NARROWEST <= length)
        return error_set(error,
                         "all %zu points are on one line seen from above, from (%g, %g) to "
                         "(%g, %g), expected points over an area",
                         n, a.x, a.y, b.x, b.y);
    return 0;
}

/* A set of cells: open addressing, empty where zero. */
struct cells {
    size_t n, mask;
    uint64_t *key;
};

static void add_cell(struct cells *c, uint32_t i, uint32_t j)
{
    uint64_t key = ((uint64_t)i << 32 | j) + 1;
    uint64_t mixed = key * 0x9E3779B97F4A7C15u;
    size_t at = (size_t)(mixed >> 20) & c->mask;
    while (c->key[at] != 0 && c->key[at] != key)
        at = (at + 1) & c->mask;
    c->n += c->key[at] == 0;
    c->key[at] = key;
}

/* Area of the cells with points in them, the box parted evenly into cells near `width`. */
static double occupied(const struct footprint *f, const struct vec3 *point, size_t n, double width)
{
    double w = f->xmax - f->xmin, h = f->ymax - f->ymin;
    double columns = fmin(fmax(round(w / width), 1), 2e9),
           rows = fmin(fmax(round(h / width), 1), 2e9);
    size_t size = 64;
    while (size < 2 * n)
        size *= 2;
    struct cells cells = {0, size - 1, mem_alloc(size, sizeof *cells.key)};
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = footprint_turn(f, point[i]);
        double column = (p.x - f->xmin) / w * columns, row = (p.y - f->ymin) / h * rows;
        add_cell(&cells, (uint32_t)fmin(column, columns - 1), (uint32_t)fmin(row, rows - 1));
    }
    free(cells.key);
    return (double)cells.n * (w / columns) * (h / rows);
}

double footprint_spacing(const struct footprint *f, const struct vec3 *point, size_t n)
{
    enum { CELL = 5, ROUNDS = 20 };
    double spacing = sqrt((f->xmax - f->xmin) * (f->ymax - f->ymin) / (double)n);
    for (int i = 0; i < ROUNDS; i++) {
        double next = sqrt(occupied(f, point, n, CELL * spacing) / (double)n);
        bool settled = fabs(next - spacing) < 0.05 * spacing;
        spacing = next;
        if (settled)
            break;
    }
    return spacing;
}

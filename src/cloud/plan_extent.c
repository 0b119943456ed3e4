/* plan_extent - see plan_extent.h. */
#include "cloud/plan_extent.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/pair.h"

struct plan_extent plan_extent_begin(double direction)
{
    double quarter = direction / 90, turn = RADIANS(direction);
    struct plan_extent f = {cos(turn), sin(turn), INFINITY, -INFINITY, INFINITY, -INFINITY};
    if (quarter == floor(quarter)) { /* no cos 90 = 6e-17: points in rows stay in rows */
        f.cosine = round(f.cosine);
        f.sine = round(f.sine);
    }
    return f;
}

void plan_extent_add(struct plan_extent *f, const struct vec3 *point, size_t n)
{
    pair least = {f->xmin, f->ymin}, most = {f->xmax, f->ymax};
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = plan_extent_turn(f, point[i]);
        pair at = {p.x, p.y};
        least = pair_lesser(at, least);
        most = pair_greater(at, most);
    }
    f->xmin = least[0], f->ymin = least[1];
    f->xmax = most[0], f->ymax = most[1];
}

struct plan_extent plan_extent_of(const struct vec3 *point, size_t n, double direction)
{
    struct plan_extent f = plan_extent_begin(direction);
    plan_extent_add(&f, point, n);
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

/* So many cells for each point have a bit each: no more memory than the set takes. */
static const double BITS = 64;

static void add_bit(struct plan_cells *c, uint64_t cell)
{
    uint64_t *bits = &c->key[cell / 64], bit = (uint64_t)1 << cell % 64;
    c->n += (*bits & bit) == 0;
    *bits |= bit;
}

static void add_cell(struct plan_cells *c, uint64_t key)
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

struct plan_cells plan_cells_begin(const struct plan_extent *f, size_t n, double width)
{
    double w = f->xmax - f->xmin, h = f->ymax - f->ymin;
    struct plan_cells c = {
        .extent = *f, .columns = cells_along(w, width), .rows = cells_along(h, width)};
    c.right = c.columns / w;
    c.up = c.rows / h;
    double most = fmin((double)n, c.columns * c.rows);
    if (c.columns * c.rows <= BITS * (double)n) {
        c.key = mem_alloc((size_t)(c.columns * c.rows) / 64 + 1, sizeof *c.key);
        return c;
    }
    size_t size = 64;
    while ((double)size < 2 * most)
        size *= 2;
    c.mask = size - 1;
    c.key = mem_alloc(size, sizeof *c.key);
    return c;
}

void plan_cells_add(struct plan_cells *c, const struct vec3 *point, size_t n)
{
    const struct plan_extent *f = &c->extent;
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = plan_extent_turn(f, point[i]);
        double column = (p.x - f->xmin) * c->right, row = (p.y - f->ymin) * c->up;
        column = column < c->columns ? column : c->columns - 1;
        row = row < c->rows ? row : c->rows - 1;
        if (c->mask == 0) {
            add_bit(c, (uint64_t)(int64_t)row * (uint64_t)(int64_t)c->columns +
                           (uint64_t)(int64_t)column);
            continue;
        }
        uint64_t key = ((uint64_t)column << 32 | (uint64_t)row) + 1;
        if (key != c->last) /* scanned in order, most points fall into the cell of the one before */
            add_cell(c, key);
        c->last = key;
    }
}

double plan_cells_end(struct plan_cells *c)
{
    free(c->key);
    c->key = NULL;
    return (double)c->n / (c->right * c->up);
}

struct plan_spacing plan_spacing_begin(const struct plan_extent *f, size_t n)
{
    double spacing = sqrt((f->xmax - f->xmin) * (f->ymax - f->ymin) / (double)n);
    return (struct plan_spacing){.n = n, .spacing = spacing};
}

double plan_spacing_width(const struct plan_spacing *s)
{
    const double cell = 5;
    return cell * s->spacing;
}

bool plan_spacing_next(struct plan_spacing *s, double area)
{
    enum { ROUNDS = 20 };
    double next = sqrt(area / (double)s->n);
    bool settled = fabs(next - s->spacing) < 0.05 * s->spacing;
    s->spacing = next;
    return !settled && ++s->rounds < ROUNDS;
}

double plan_extent_spacing(const struct plan_extent *f, const struct vec3 *point, size_t n)
{
    struct plan_spacing s = plan_spacing_begin(f, n);
    struct plan_cells cells;
    do {
        cells = plan_cells_begin(f, n, plan_spacing_width(&s));
        plan_cells_add(&cells, point, n);
    } while (plan_spacing_next(&s, plan_cells_end(&cells)));
    return s.spacing;
}

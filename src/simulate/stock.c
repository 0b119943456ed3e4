/* stock - see stock.h. */
#include "simulate/stock.h"

#include <stdbool.h>
#include <stdlib.h>

#define DUST 1e-9 /* mm: what rounding makes */

struct stock stock_box(struct vec3 low, struct vec3 high, double cell)
{
    struct stock s = {.bottom = low.z};
    s.nx = (int)fmax(2, ceil((high.x - low.x) / cell - 1e-9));
    s.ny = (int)fmax(2, ceil((high.y - low.y) / cell - 1e-9));
    s.dx = (high.x - low.x) / s.nx;
    s.dy = (high.y - low.y) / s.ny;
    s.x = low.x + s.dx / 2;
    s.y = low.y + s.dy / 2;
    s.column = mem_alloc((size_t)s.nx * (size_t)s.ny, sizeof *s.column);
    for (int k = 0; k < s.nx * s.ny; k++)
        s.column[k] = (struct stock_column){low.z, high.z, 0, 0, STOCK_NONE};
    s.tiles_x = (s.nx + STOCK_TILE - 1) / STOCK_TILE;
    s.tiles_y = (s.ny + STOCK_TILE - 1) / STOCK_TILE;
    s.changed = mem_alloc((size_t)s.tiles_x * (size_t)s.tiles_y, 1);
    return s;
}

double *stock_highest(const struct stock *s, const struct vec3 *point, size_t n, size_t *column)
{
    size_t columns = (size_t)s->nx * (size_t)s->ny;
    double *highest = mem_alloc(columns, sizeof *highest);
    for (size_t k = 0; k < columns; k++)
        highest[k] = -HUGE_VAL;
    for (size_t k = 0; k < n; k++) {
        size_t i, j;
        stock_nearest(s, point[k], &i, &j);
        column[k] = j * (size_t)s->nx + i;
        highest[column[k]] = fmax(highest[column[k]], point[k].z);
    }
    return highest;
}

void stock_free(struct stock *stock)
{
    free(stock->column);
    free(stock->changed);
    array_free(&stock->more);
    array_free(&stock->holder);
}

/* Marks the tile with all marks. */
static void mark_changed(struct stock *stock, int tile)
{
    if (!(stock->changed[tile] & STOCK_FOR_HOLDER))
        *array_push(&stock->holder) = tile;
    stock->changed[tile] = STOCK_FOR_HOLDER | STOCK_FOR_LEFT;
}

/* The part of [low, high] that lies between a and b. */
static double overlap(double low, double high, double a, double b)
{
    return fmax(0, fmin(high, b) - fmax(low, a));
}

/* How much of a column lies between a and b. */
static double height_between(const struct stock *s, const struct stock_column *c, double a,
                             double b)
{
    double sum = overlap(c->low, c->high, a, b);
    for (int k = c->more; k != STOCK_NONE; k = s->more.item[k].more)
        sum += overlap(s->more.item[k].low, s->more.item[k].high, a, b);
    return sum;
}

/* Takes what lies between a and b out of an interval; what stays below it, when something stays
 * above too, becomes an interval of its own. */
static void take_out(struct stock *s, double *low, double *high, int *more, double a, double b)
{
    if (a >= *high || b <= *low)
        return;
    if (a > *low && b < *high) {
        struct stock_interval below = {*low, a, *more};
        *more = (int)s->more.n;
        *low = b;
        *array_push(&s->more) = below; /* may move what `more` points into, so it comes last */
    } else if (a > *low) {
        *high = a;
    } else {
        *low = fmin(b, *high);
    }
}

static void cut_column(struct stock *s, struct stock_column *c, double a, double b)
{
    take_out(s, &c->low, &c->high, &c->more, a, b);
    for (int k = c->more; k != STOCK_NONE; k = s->more.item[k].more) {
        struct stock_interval at = s->more.item[k];
        take_out(s, &at.low, &at.high, &at.more, a, b);
        s->more.item[k] = at;
    }
    while (c->low >= c->high && c->more != STOCK_NONE) { /* the uppermost is one with material */
        struct stock_interval below = s->more.item[c->more];
        c->low = below.low;
        c->high = below.high;
        c->more = below.more;
    }
}

/* A straight move of the ball. */
struct capsule {
    struct vec3 a, b, e; /* e: unit vector from a to b */
    double length, radius;
};

/* The part of a vertical line in the capsule, as heights over a. */
struct chord {
    double low, high;
};

/* What of the line at (x, y) from a lies in the ball about (0, 0, z). */
static void join_ball(struct chord *chord, double x, double y, double z, double radius)
{
    double w2 = radius * radius - x * x - y * y;
    if (w2 < 0)
        return;
    chord->low = fmin(chord->low, z - sqrt(w2));
    chord->high = fmax(chord->high, z + sqrt(w2));
}

/* What of it lies in the cylinder between both balls. */
static void join_cylinder(struct chord *chord, const struct capsule *c, double x, double y)
{
    double k = x * c->e.x + y * c->e.y, ez = c->e.z;
    double a = 1 - ez * ez, b = k * ez, q = x * x + y * y - k * k - c->radius * c->radius;
    double root2 = b * b - a * q, from = -HUGE_VAL, to = HUGE_VAL;
    if (a < 1e-12 || root2 < 0)
        return;
    if (fabs(ez) > 1e-12) {
        from = fmin(-k / ez, (c->length - k) / ez);
        to = fmax(-k / ez, (c->length - k) / ez);
    } else if (k < 0 || k > c->length) {
        return;
    }
    from = fmax(from, (b - sqrt(root2)) / a);
    to = fmin(to, (b + sqrt(root2)) / a);
    if (from < to) {
        chord->low = fmin(chord->low, from);
        chord->high = fmax(chord->high, to);
    }
}

/* Convex as the capsule is, the line goes through it from the lowest of these to the highest. */
static struct chord chord_at(const struct capsule *c, double x, double y)
{
    struct chord chord = {HUGE_VAL, -HUGE_VAL};
    struct vec3 d = vec_sub(c->b, c->a);
    join_ball(&chord, x, y, 0, c->radius);
    join_ball(&chord, x - d.x, y - d.y, d.z, c->radius);
    join_cylinder(&chord, c, x, y);
    return chord;
}

/* The share of Z in the normal of the capsule at a place on it, seen from a. */
static double upright_share(const struct capsule *c, struct vec3 p)
{
    double s = fmin(fmax(vec_dot(p, c->e), 0), c->length);
    return fmin(1, fabs(p.z - s * c->e.z) / c->radius);
}

/*
 * Is it plain that nothing is taken, with the top of a column at p from a?  When it lies outside
 * and no higher than the middle line, what of the column is in the capsule lies over the top.
 */
static bool is_clear(const struct capsule *c, struct vec3 p)
{
    double along = vec_dot(p, c->e);
    struct vec3 d = vec_along(p, along < 0 ? 0 : along > c->length ? -c->length : -along, c->e);
    return p.z <= fmax(0, c->b.z - c->a.z) && vec_dot(d, d) >= c->radius * (c->radius - 2 * DUST);
}

static void cut_by_capsule(struct stock *s, int i, int j, const struct capsule *c, unsigned pass,
                           struct stock_bite *sum)
{
    struct stock_column *column = stock_at(s, i, j);
    double x = stock_x(s, i), y = stock_y(s, j);
    struct vec3 top = vec(x - c->a.x, y - c->a.y, column->high - c->a.z);
    if (is_clear(c, top))
        return;
    struct chord chord = chord_at(c, top.x, top.y);
    double low = chord.low + c->a.z, high = chord.high + c->a.z;
    if (low >= column->high || (column->more == STOCK_NONE && high <= column->low))
        return;
    double taken = height_between(s, column, low, high), depth = taken;
    if (taken < DUST)
        return;
    if (pass > 0) {
        column->taken = (float)taken + (column->pass == pass ? column->taken : 0);
        column->pass = pass;
        depth = (double)column->taken;
        cut_column(s, column, low, high);
        mark_changed(s, j / STOCK_TILE * s->tiles_x + i / STOCK_TILE);
    }
    depth *= upright_share(c, vec(top.x, top.y, chord.low));
    sum->volume += taken * s->dx * s->dy;
    if (depth > sum->depth) {
        sum->depth = depth;
        sum->at = vec(x, y, low);
    }
}

/* Where the line at this y enters and leaves the capsule, seen from above. */
static bool chord_of_row(const struct capsule *c, double y, double *from, double *to)
{
    struct vec3 n = vec_unit(vec(-c->e.y, c->e.x, 0));
    const struct vec3 end[2] = {c->a, c->b};
    struct vec3 corner[4];
    *from = HUGE_VAL;
    *to = -HUGE_VAL;
    for (int k = 0; k < 2; k++) {
        double w2 = c->radius * c->radius - (y - end[k].y) * (y - end[k].y);
        if (w2 >= 0) {
            *from = fmin(*from, end[k].x - sqrt(w2));
            *to = fmax(*to, end[k].x + sqrt(w2));
        }
        corner[k] = vec_along(end[k], c->radius, n);
        corner[3 - k] = vec_along(end[k], -c->radius, n);
    }
    for (int k = 0; k < 4; k++) {
        struct vec3 p = corner[k], q = corner[(k + 1) % 4];
        if ((p.y > y) == (q.y > y))
            continue;
        double x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
        *from = fmin(*from, x);
        *to = fmax(*to, x);
    }
    return *from <= *to;
}

/* The first and last of n columns at `first` + k * step that lie between from and to. */
static void columns_between(double from, double to, double first, double step, int n, int *low,
                            int *high)
{
    *low = (int)fmin(fmax(ceil((from - first) / step), 0), n);
    *high = (int)fmax(fmin(floor((to - first) / step), n - 1), -1);
}

struct stock_bite stock_capsule(struct stock *s, struct vec3 a, struct vec3 b, double radius,
                                unsigned pass)
{
    struct capsule c = {a, b, vec_unit(vec_sub(b, a)), vec_distance(a, b), radius};
    struct stock_bite sum = {0, 0, a};
    int j0, j1, i0, i1;
    columns_between(fmin(a.y, b.y) - radius, fmax(a.y, b.y) + radius, s->y, s->dy, s->ny, &j0, &j1);
    for (int j = j0; j <= j1; j++) {
        double from, to;
        if (!chord_of_row(&c, stock_y(s, j), &from, &to))
            continue;
        columns_between(from, to, s->x, s->dx, s->nx, &i0, &i1);
        for (int i = i0; i <= i1; i++)
            cut_by_capsule(s, i, j, &c, pass, &sum);
    }
    return sum;
}

double stock_volume(const struct stock *s)
{
    double sum = 0;
    for (int k = 0; k < s->nx * s->ny; k++)
        sum += stock_above(s, &s->column[k], s->bottom);
    return sum * s->dx * s->dy;
}

double stock_above(const struct stock *s, const struct stock_column *column, double z)
{
    return height_between(s, column, z, HUGE_VAL);
}

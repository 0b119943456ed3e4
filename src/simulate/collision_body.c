/* collision_body - see collision_body.h. */
#include "simulate/collision_body.h"

#include <stdlib.h>

#include "base/array.h"

enum { IN_CELL = 8, CELLS_MOST = 2048 };

static int clamp(double x, int n)
{
    return x < 0 ? 0 : x >= n ? n - 1 : (int)x;
}

static size_t cell_of(const struct tiles *t, struct vec3 p)
{
    int i = clamp((p.x - t->x) / t->dx, t->nx[0]), j = clamp((p.y - t->y) / t->dy, t->ny[0]);
    return (size_t)j * (size_t)t->nx[0] + (size_t)i;
}

/* Points in the order of their cells, each cell with its box. */
static void fill(struct collision_body *o, size_t n)
{
    size_t cells = (size_t)o->tiles.nx[0] * (size_t)o->tiles.ny[0];
    o->order = mem_alloc(n, sizeof *o->order);
    o->first = mem_alloc(cells + 2, sizeof *o->first);
    for (size_t i = 0; i < n; i++)
        o->first[cell_of(&o->tiles, o->point[i]) + 2]++;
    for (size_t k = 2; k < cells + 2; k++)
        o->first[k] += o->first[k - 1];
    for (size_t i = 0; i < n; i++)
        o->order[o->first[cell_of(&o->tiles, o->point[i]) + 1]++] = i;
    for (size_t k = 0; k < cells; k++) {
        struct tile tile = {HUGE_VAL, -HUGE_VAL};
        for (size_t i = o->first[k]; i < o->first[k + 1]; i++) {
            tile.low = fmin(tile.low, o->point[o->order[i]].z);
            tile.high = fmax(tile.high, o->point[o->order[i]].z);
        }
        size_t nx = (size_t)o->tiles.nx[0];
        tiles_set(&o->tiles, (int)(k % nx), (int)(k / nx), tile);
    }
}

struct collision_body collision_body_points(const struct vec3 *point, size_t n)
{
    struct collision_body o = {.point = point};
    struct vec3 low = point[0], high = point[0];
    for (size_t i = 1; i < n; i++) {
        low = vec(fmin(low.x, point[i].x), fmin(low.y, point[i].y), 0);
        high = vec(fmax(high.x, point[i].x), fmax(high.y, point[i].y), 0);
    }
    double area = (high.x - low.x) * (high.y - low.y);
    double side = fmax(hypot(high.x - low.x, high.y - low.y), 1e-6);
    double cell = fmax(sqrt(area * IN_CELL / (double)n), side / CELLS_MOST);
    int nx = (int)((high.x - low.x) / cell) + 1, ny = (int)((high.y - low.y) / cell) + 1;
    o.tiles = tiles_new(low.x, low.y, cell, cell, nx, ny);
    fill(&o, n);
    return o;
}

static void visit_points(void *what, int i, int j, struct tiles_search *search)
{
    struct collision_body *o = what;
    size_t k = (size_t)j * (size_t)o->tiles.nx[0] + (size_t)i;
    for (size_t m = o->first[k]; m < o->first[k + 1]; m++)
        tiles_look(search, o->point[o->order[m]]);
}

/* Top of a column; where nothing is left, or beside the grid, the bottom. */
static double top_of(const struct stock *s, int i, int j)
{
    if (i < 0 || j < 0 || i >= s->nx || j >= s->ny)
        return s->bottom;
    const struct stock_column *c = stock_at(s, i, j);
    return c->low < c->high ? c->high : s->bottom;
}

/* The lowest top beside a column: down to it there is a wall. */
static double wall_foot(const struct stock *s, int i, int j)
{
    return fmin(fmin(top_of(s, i - 1, j), top_of(s, i + 1, j)),
                fmin(top_of(s, i, j - 1), top_of(s, i, j + 1)));
}

struct columns {
    int i0, i1, j0, j1;
};

static struct columns columns_of(const struct stock *s, int i, int j)
{
    return (struct columns){i * STOCK_TILE, (int)fmin((i + 1) * STOCK_TILE, s->nx), j * STOCK_TILE,
                            (int)fmin((j + 1) * STOCK_TILE, s->ny)};
}

static void set_tile(struct collision_body *o, int i, int j)
{
    const struct stock *s = o->stock;
    struct columns at = columns_of(s, i, j);
    struct tile tile = {HUGE_VAL, -HUGE_VAL};
    for (int v = at.j0; v < at.j1; v++)
        for (int u = at.i0; u < at.i1; u++) {
            double top = top_of(s, u, v);
            tile.high = fmax(tile.high, top);
            tile.low = fmin(tile.low, fmin(top, wall_foot(s, u, v)));
        }
    tiles_set(&o->tiles, i, j, tile);
}

struct collision_body collision_body_stock(struct stock *s)
{
    struct collision_body o = {.stock = s};
    double dx = s->dx * STOCK_TILE, dy = s->dy * STOCK_TILE;
    o.tiles = tiles_new(s->x - s->dx / 2, s->y - s->dy / 2, dx, dy, s->tiles_x, s->tiles_y);
    for (int j = 0; j < s->tiles_y; j++)
        for (int i = 0; i < s->tiles_x; i++)
            set_tile(&o, i, j);
    return o;
}

/* Tiles beside one that was cut have new walls. */
static void mark_beside(struct stock *s, int tile)
{
    int i = tile % s->tiles_x, j = tile / s->tiles_x;
    for (int k = 0; k < 4; k++) {
        int u = i + (k == 0) - (k == 1), v = j + (k == 2) - (k == 3), n = v * s->tiles_x + u;
        if (u < 0 || v < 0 || u >= s->tiles_x || v >= s->tiles_y ||
            (s->changed[n] & STOCK_FOR_HOLDER))
            continue;
        s->changed[n] |= STOCK_FOR_HOLDER;
        *array_push(&s->holder) = n;
    }
}

static void follow(struct collision_body *o)
{
    struct stock *s = o->stock;
    size_t cut = s->holder.n;
    for (size_t k = 0; k < cut; k++)
        mark_beside(s, s->holder.item[k]);
    for (size_t k = 0; k < s->holder.n; k++) {
        int tile = s->holder.item[k];
        set_tile(o, tile % s->tiles_x, tile / s->tiles_x);
        s->changed[tile] &= (unsigned char)~STOCK_FOR_HOLDER;
    }
    s->holder.n = 0;
}

/* The top of a column and, where they may be nearer than what was found, places down its wall. */
static void look_at_column(const struct stock *s, int i, int j, struct tiles_search *search)
{
    double top = top_of(s, i, j), foot = wall_foot(s, i, j), step = fmin(s->dx, s->dy);
    struct vec3 place = vec(stock_x(s, i), stock_y(s, j), top);
    if (top <= s->bottom)
        return;
    double distance = tiles_look(search, place);
    while (place.z - step > foot && distance - (place.z - foot) < search->distance) {
        /* as far as nothing can be nearer than what was found already */
        place.z -= fmax(step, distance - search->distance);
        if (place.z > foot)
            distance = tiles_look(search, place);
    }
}

static void visit_stock(void *what, int i, int j, struct tiles_search *search)
{
    const struct collision_body *o = what;
    struct columns at = columns_of(o->stock, i, j);
    for (int v = at.j0; v < at.j1; v++)
        for (int u = at.i0; u < at.i1; u++)
            look_at_column(o->stock, u, v, search);
}

void collision_body_free(struct collision_body *obstacle)
{
    tiles_free(&obstacle->tiles);
    free(obstacle->order);
    free(obstacle->first);
}

/* What was nearest the last time is near still. */
static void begin(const struct collision_body *o, struct tiles_search *search)
{
    const struct stock *s = o->stock;
    if (s)
        look_at_column(s, clamp((o->hint.x - s->x) / s->dx + 0.5, s->nx),
                       clamp((o->hint.y - s->y) / s->dy + 0.5, s->ny), search);
    else
        tiles_look(search, o->hint);
}

void collision_body_nearest(struct collision_body *o, struct tiles_search *search)
{
    double before = search->distance;
    if (o->stock)
        follow(o);
    if (o->hinted)
        begin(o, search);
    if (search->distance >= search->enough)
        tiles_nearest(&o->tiles, o->stock ? visit_stock : visit_points, o, search);
    if (search->distance < before) {
        o->hinted = true;
        o->hint = search->at;
    }
}

/* stock - see stock.h. */
#include "simulate/stock.h"

#include <stdbool.h>
#include <stdlib.h>

#include "math/box.h"
#include "math/height_pyramid.h"
#include "math/kdtree.h"
#include "math/quadric.h"

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

/* ---- the block */

enum {
    NEAR = 12,     /* points that the height of the surface is from */
    LONGEST = 500, /* columns along the longer side, and ... */
    RADIUS = 25,   /* ... along the ball's radius, at most, when nobody says */
    SPACINGS = 2   /* of the points: columns further from all of them are empty */
};

static struct stock_options box_of(const struct stock_options *options, const struct vec3 *point,
                                   size_t n)
{
    struct stock_options box = *options;
    double more = options->allowance;
    if (options->kind == STOCK_BETWEEN)
        return box;
    struct box part = box_around(point, n);
    box.low = vec_add(part.low, vec(-more, -more, 0));
    box.high = vec_add(part.high, vec(more, more, more));
    return box;
}

double stock_cell(const struct stock_options *options, const struct vec3 *point, size_t n,
                  double radius)
{
    struct stock_options box = box_of(options, point, n);
    double side = fmax(box.high.x - box.low.x, box.high.y - box.low.y);
    return fmax(side / LONGEST, radius / RADIUS);
}

/* Points of a surface, and where they are seen from above. */
struct seen {
    struct vec3s point;
    struct kdtree *tree;
};

static void index_from_above(struct seen *seen)
{
    struct vec3s flat = {0};
    for (size_t i = 0; i < seen->point.n; i++)
        *array_push(&flat) = vec(seen->point.item[i].x, seen->point.item[i].y, 0);
    seen->tree = kdtree_new(flat.item, flat.n);
    array_free(&flat);
}

/*
 * The surface over (x, y): its height, and its normal, upward.  By the quadric through the nearest
 * points as seen from above, or where they carry none, as on a line, by the nearest.  False: no
 * point is within `reach`, seen from above.
 */
static bool surface_at(const struct seen *seen, double x, double y, double reach, struct vec3 *foot,
                       struct vec3 *normal)
{
    size_t near[NEAR];
    double distance2[NEAR];
    size_t n = kdtree_nearest(seen->tree, vec(x, y, 0), NEAR, near, distance2);
    struct vec3 point[NEAR];
    struct quadric q;
    if (n == 0 || distance2[0] > reach * reach)
        return false;
    const struct vec3 *of = seen->point.item;
    if (!of)
        return false;
    for (size_t i = 0; i < n; i++)
        point[i] = of[near[i]];
    *foot = vec(x, y, point[0].z);
    *normal = vec(0, 0, 1);
    if (quadric_fit(point, n, *foot, *normal, &q) == 0) {
        foot->z += q.c[0];
        *normal = quadric_normal(&q);
    }
    return true;
}

/* The highest of the points of each cell of the grid: what the sky sees. */
static void keep_highest(const struct stock *s, const struct vec3 *point, size_t n,
                         struct vec3s *kept)
{
    size_t columns = (size_t)s->nx * (size_t)s->ny;
    double *highest = mem_alloc(columns, sizeof *highest);
    size_t *column = mem_alloc(n, sizeof *column);
    for (size_t k = 0; k < columns; k++)
        highest[k] = -HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        double u = fmin(fmax((point[i].x - s->x) / s->dx + 0.5, 0), s->nx - 1);
        double v = fmin(fmax((point[i].y - s->y) / s->dy + 0.5, 0), s->ny - 1);
        column[i] = (size_t)v * (size_t)s->nx + (size_t)u;
        highest[column[i]] = fmax(highest[column[i]], point[i].z);
    }
    for (size_t i = 0; i < n; i++)
        if (point[i].z > highest[column[i]] - 2 * (s->dx + s->dy))
            *array_push(kept) = point[i];
    free(highest);
    free(column);
}

/* The ball over one column that reaches highest there: balls stand on all columns with a surface.
 */
struct balls {
    struct height_pyramid surface; /* its height over each column */
    double radius;
};

struct highest {
    double x, y; /* of the column */
    double z;    /* that high so far */
    int i, j;    /* by the ball on this column */
};

/* How far x is beyond the middles of the columns from `first` on, n of them. */
static double distance_beyond(double x, double corner, double step, int first, int n)
{
    double low = corner + (first + 0.5) * step;
    return fmax(0, fmax(low - x, x - low - (n - 1) * step));
}

static void find_highest(const struct balls *b, int level, int i, int j, struct highest *top)
{
    const struct height_pyramid *t = &b->surface;
    const struct height_level *l = &t->level[level];
    if (i >= l->columns || j >= l->rows)
        return;
    double z = l->cell[(size_t)j * (size_t)l->columns + (size_t)i].high;
    double x = distance_beyond(top->x, t->x, t->dx, i << level, 1 << level);
    double y = distance_beyond(top->y, t->y, t->dy, j << level, 1 << level);
    double w2 = b->radius * b->radius - x * x - y * y;
    if (w2 < 0 || (z < top->z && w2 <= (top->z - z) * (top->z - z)))
        return;
    if (level == 0 && z + sqrt(w2) > top->z)
        *top = (struct highest){top->x, top->y, z + sqrt(w2), i, j};
    for (int c = 0; c < 4 && level > 0; c++)
        find_highest(b, level - 1, 2 * i + c % 2, 2 * j + c / 2, top);
}

/* Columns as high as balls of the allowance about the surface reach. */
static void raise_by_balls(struct stock *s, const struct balls *balls)
{
    int top = balls->surface.levels - 1;
    for (int j = 0; j < s->ny; j++) {
        int from = 0, to = j; /* the ball of the column before is near the highest here */
        for (int i = 0; i < s->nx; i++) {
            struct highest at = {stock_x(s, i), stock_y(s, j), s->bottom, from, to};
            find_highest(balls, 0, from, to, &at);
            find_highest(balls, top, 0, 0, &at);
            stock_at(s, i, j)->high = at.z;
            from = at.i;
            to = at.j;
        }
    }
}

/* The surface over each column, raised by balls; and pushed out along its normals. */
static void offset_surface(struct stock *s, const struct seen *part, double reach, double allowance,
                           struct vec3s *pushed)
{
    struct balls balls = {
        height_pyramid_new(s->x - s->dx / 2, s->y - s->dy / 2, s->dx, s->dy, s->nx, s->ny),
        allowance};
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++) {
            struct vec3 p, normal;
            if (!surface_at(part, stock_x(s, i), stock_y(s, j), reach, &p, &normal))
                continue;
            height_pyramid_set(&balls.surface, (struct height_cell){i, j},
                               (struct height_range){p.z, p.z});
            *array_push(pushed) = vec_along(p, allowance, normal);
        }
    raise_by_balls(s, &balls);
    height_pyramid_free(&balls.surface);
}

static void lay_over(struct stock *s, const struct seen *pushed)
{
    double reach = 1.5 * fmax(s->dx, s->dy);
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++) {
            struct vec3 p, normal;
            struct stock_column *c = stock_at(s, i, j);
            if (surface_at(pushed, stock_x(s, i), stock_y(s, j), reach, &p, &normal))
                c->high = fmax(c->high, p.z);
        }
}

struct stock stock_new(const struct stock_options *options, const struct vec3 *point, size_t n,
                       double cell)
{
    struct stock_options box = box_of(options, point, n);
    struct stock s = stock_box(box.low, box.high, cell);
    struct seen part = {0}, pushed = {0};
    if (options->kind != STOCK_OFFSET)
        return s;
    double area = (box.high.x - box.low.x) * (box.high.y - box.low.y);
    double reach = fmax(SPACINGS * sqrt(area / (double)n), 2 * fmax(s.dx, s.dy));
    keep_highest(&s, point, n, &part.point);
    index_from_above(&part);
    offset_surface(&s, &part, reach, options->allowance, &pushed.point);
    index_from_above(&pushed);
    lay_over(&s, &pushed);
    kdtree_free(part.tree);
    kdtree_free(pushed.tree);
    array_free(&part.point);
    array_free(&pushed.point);
    return s;
}

/* ---- what is left on the part */

enum {
    STEPS = 4, /* along the slope, to the nearest place */
    UNDER = 4  /* columns that a point may be under the highest of its column */
};

/* The surface that one comes to from z upward in a column; above all material the top of it. */
static double surface_of(const struct stock *s, int i, int j, double z)
{
    const struct stock_column *c = stock_at(s, i, j);
    struct stock_interval at = {c->low, c->high, c->more};
    for (;;) {
        if (at.low >= at.high || (at.low > z && at.more == STOCK_NONE))
            return s->bottom;
        if (at.low <= z || at.more == STOCK_NONE)
            return at.high;
        at = s->more.item[at.more];
    }
}

/* Height and slopes of the surface at (x, y). */
struct spot {
    double height, slope_x, slope_y;
};

static struct spot spot_at(const struct stock *s, double x, double y, double z)
{
    double u = fmin(fmax((x - s->x) / s->dx, 0), s->nx - 1);
    double v = fmin(fmax((y - s->y) / s->dy, 0), s->ny - 1);
    int i = (int)fmin(u, s->nx - 2), j = (int)fmin(v, s->ny - 2);
    double a = surface_of(s, i, j, z), b = surface_of(s, i + 1, j, z);
    double c = surface_of(s, i, j + 1, z), d = surface_of(s, i + 1, j + 1, z);
    u -= i;
    v -= j;
    double low = a + u * (b - a), high = c + u * (d - c);
    return (struct spot){low + v * (high - low), (b - a + v * (d - c - b + a)) / s->dx,
                         (high - low) / s->dy};
}

double stock_rest_at(const struct stock *s, struct vec3 p)
{
    double x = p.x, y = p.y, best = HUGE_VAL;
    for (int k = 0; k < STEPS; k++) {
        struct spot at = spot_at(s, x, y, p.z);
        if (k == 0 && at.height <= p.z)
            return 0;
        best = fmin(best, vec_distance(p, vec(x, y, at.height)));
        /* the foot of p on the plane that touches there */
        double rise = at.height - p.z + at.slope_x * (p.x - x) + at.slope_y * (p.y - y);
        double n2 = at.slope_x * at.slope_x + at.slope_y * at.slope_y + 1;
        x = p.x - at.slope_x * rise / n2;
        y = p.y - at.slope_y * rise / n2;
    }
    return best;
}

static size_t tile_of(const struct stock *s, struct vec3 p)
{
    double i = fmin(fmax((p.x - s->x) / s->dx + 0.5, 0), s->nx - 1);
    double j = fmin(fmax((p.y - s->y) / s->dy + 0.5, 0), s->ny - 1);
    return (size_t)j / STOCK_TILE * (size_t)s->tiles_x + (size_t)i / STOCK_TILE;
}

static size_t column_of(const struct stock *s, struct vec3 p)
{
    double i = fmin(fmax((p.x - s->x) / s->dx + 0.5, 0), s->nx - 1);
    double j = fmin(fmax((p.y - s->y) / s->dy + 0.5, 0), s->ny - 1);
    return (size_t)j * (size_t)s->nx + (size_t)i;
}

/* Which points are measured: not those far under the highest of their column. */
static bool *points_in_sight(const struct vec3 *point, size_t n, const struct stock *s)
{
    size_t columns = (size_t)s->nx * (size_t)s->ny;
    double *highest = mem_alloc(columns, sizeof *highest);
    bool *asked = mem_alloc(n, sizeof *asked);
    for (size_t k = 0; k < columns; k++)
        highest[k] = -HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        double *at = &highest[column_of(s, point[i])];
        *at = fmax(*at, point[i].z);
    }
    for (size_t i = 0; i < n; i++)
        asked[i] = point[i].z >= highest[column_of(s, point[i])] - UNDER * fmax(s->dx, s->dy);
    free(highest);
    return asked;
}

static size_t bin_of(const struct stock_rest *rest, double thick)
{
    return (size_t)fmin(thick / rest->bin, STOCK_REST_BINS - 1);
}

struct stock_rest stock_rest_new(const struct vec3 *point, size_t n, const struct stock *s)
{
    struct stock_rest rest = {.point = point};
    size_t tiles = (size_t)s->tiles_x * (size_t)s->tiles_y;
    double top = s->bottom;
    bool *asked = points_in_sight(point, n, s);
    rest.order = mem_alloc(n, sizeof *rest.order);
    rest.thick = mem_alloc(n, sizeof *rest.thick);
    rest.first = mem_alloc(tiles + 2, sizeof *rest.first);
    rest.count = mem_alloc(STOCK_REST_BINS, sizeof *rest.count);
    for (size_t i = 0; i < n; i++)
        rest.first[tile_of(s, point[i]) + 2] += asked[i];
    for (size_t k = 2; k < tiles + 2; k++)
        rest.first[k] += rest.first[k - 1];
    for (size_t i = 0; i < n; i++)
        if (asked[i])
            rest.order[rest.first[tile_of(s, point[i]) + 1]++] = i;
    free(asked);
    rest.points = rest.first[tiles];
    for (int k = 0; k < s->nx * s->ny; k++)
        top = fmax(top, s->column[k].high);
    rest.bin = fmax(top - s->bottom, 1e-9) / STOCK_REST_BINS;
    for (size_t i = 0; i < rest.points; i++) {
        rest.thick[i] = (float)stock_rest_at(s, point[rest.order[i]]);
        rest.count[bin_of(&rest, (double)rest.thick[i])]++;
    }
    return rest;
}

void stock_rest_free(struct stock_rest *rest)
{
    free(rest->order);
    free(rest->first);
    free(rest->thick);
    free(rest->count);
}

static bool cut_near(const struct stock *s, int i, int j)
{
    for (int v = j - 1; v <= j + 1; v++)
        for (int u = i - 1; u <= i + 1; u++)
            if (u >= 0 && v >= 0 && u < s->tiles_x && v < s->tiles_y &&
                (s->changed[v * s->tiles_x + u] & STOCK_FOR_LEFT))
                return true;
    return false;
}

static void measure_tile(struct stock_rest *rest, const struct stock *s, size_t tile)
{
    for (size_t i = rest->first[tile]; i < rest->first[tile + 1]; i++) {
        rest->count[bin_of(rest, (double)rest->thick[i])]--;
        rest->thick[i] = (float)stock_rest_at(s, rest->point[rest->order[i]]);
        rest->count[bin_of(rest, (double)rest->thick[i])]++;
    }
}

static struct stock_rest_sum sum_up(const struct stock_rest *rest)
{
    static const double share[STOCK_REST_PERCENTILES] = {0.50, 0.95, 0.99};
    struct stock_rest_sum sum = {0};
    size_t below = 0;
    int k = 0;
    for (size_t i = 0; i < rest->points; i++)
        if (i == 0 || (double)rest->thick[i] > sum.worst) {
            sum.worst = (double)rest->thick[i];
            sum.at = rest->point[rest->order[i]];
        }
    for (size_t b = 0; rest->points > 0 && b < STOCK_REST_BINS; b++) {
        below += rest->count[b];
        while (k < STOCK_REST_PERCENTILES &&
               (double)below > share[k] * (double)(rest->points - 1) + 0.5)
            sum.part[k++] = fmin(((double)b + (b > 0 ? 0.5 : 0)) * rest->bin, sum.worst);
    }
    return sum;
}

struct stock_rest_sum stock_rest_update(struct stock_rest *rest, struct stock *s)
{
    for (int j = 0; j < s->tiles_y; j++)
        for (int i = 0; i < s->tiles_x; i++)
            if (cut_near(s, i, j))
                measure_tile(rest, s, (size_t)j * (size_t)s->tiles_x + (size_t)i);
    for (int k = 0; k < s->tiles_x * s->tiles_y; k++)
        s->changed[k] &= (unsigned char)~STOCK_FOR_LEFT;
    return sum_up(rest);
}

/* stock_block - see stock_block.h. */
#include "simulate/stock_block.h"

#include <stdbool.h>
#include <stdlib.h>

#include "math/box.h"
#include "math/height_pyramid.h"
#include "math/kdtree.h"
#include "math/quadric.h"

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
    size_t *column = mem_alloc(n, sizeof *column);
    double *highest = stock_highest(s, point, n, column);
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

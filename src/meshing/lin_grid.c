/* lin_grid - see lin_grid.h. */
#include "meshing/lin_grid.h"

#include <stdlib.h>

#include "base/array.h"

static const double NODES_A_POINT = 50, NODES_MORE = 1000;
static const double NARROW = 0.5; /* of the points' spacing: a slope needs a base as long */
static const double STEEP = 2.75; /* a wall does not go on: a slope of 70 degrees */

/* The points in the grid's axes, band by band and in each by rising x. */
struct bands {
    size_t n;
    size_t *from; /* n + 1 */
    struct vec3 *point;
};

static size_t band_of(const struct plan_extent *f, double high, size_t bands, double y)
{
    double k = floor((y - f->ymin) / high + 0.5);

    return k < 0 ? 0 : k >= (double)bands ? bands - 1 : (size_t)k;
}

static int compare_along(const void *a, const void *b)
{
    const struct vec3 *p = a, *q = b;
    double d[3] = {p->x - q->x, p->y - q->y, p->z - q->z};

    for (int i = 0; i < 3; i++)
        if (d[i] < 0 || d[i] > 0)
            return d[i] < 0 ? -1 : 1;
    return 0;
}

static struct bands bands_make(const struct plan_extent *f, const struct vec3 *point, size_t n,
                               double mean)
{
    double steps = fmax(1, floor((f->ymax - f->ymin) / mean + 0.5));
    double high = (f->ymax - f->ymin) / steps;
    size_t count = (size_t)steps + 1; /* the first and the last have their middles on the border */
    struct bands b = {count, mem_alloc(count + 2, sizeof *b.from), mem_alloc(n, sizeof *b.point)};

    for (size_t i = 0; i < n; i++)
        b.from[band_of(f, high, count, plan_extent_turn(f, point[i]).y) + 2]++;
    for (size_t k = 2; k <= count; k++)
        b.from[k] += b.from[k - 1];
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = plan_extent_turn(f, point[i]);
        b.point[b.from[band_of(f, high, count, p.y) + 1]++] = p;
    }
    for (size_t k = 0; k < count; k++)
        qsort(b.point + b.from[k], b.from[k + 1] - b.from[k], sizeof *b.point, compare_along);
    return b;
}

static void bands_free(struct bands *b)
{
    free(b->from);
    free(b->point);
}

/* The straight line through a and b, at x; they are not at one. */
static struct vec3 line_at(struct vec3 a, struct vec3 b, double x)
{
    return vec_mix(a, b, (x - a.x) / (b.x - a.x));
}

/* The place of a row of points beyond its first (step 1) or last (-1) point: along the line to the
 * next one that is far enough for a slope. */
static bool row_beyond(const struct vec3 *end, size_t n, int step,
                       const struct lin_grid_options *options, double x, struct vec3 *place)
{
    if (fabs(x - end->x) > options->reach)
        return false;
    for (size_t k = 1; k < n; k++) {
        struct vec3 next = end[step * (long)k];
        double base = fabs(next.x - end->x);
        if (base > options->gap)
            return false;
        if (base >= fmax(NARROW * options->mean, fabs(x - end->x) / 2)) {
            if (fabs(next.z - end->z) > STEEP * base)
                return false;
            *place = line_at(*end, next, x);
            return true;
        }
    }
    return false;
}

/* Where a row of n points crosses a column; *at: a point at or before it, found from the last
 * column on. */
static bool row_at(const struct vec3 *p, size_t n, size_t *at,
                   const struct lin_grid_options *options, double x, struct vec3 *place)
{
    if (n == 0)
        return false;
    while (*at + 1 < n && p[*at + 1].x <= x)
        ++*at;
    if (x < p[0].x)
        return row_beyond(p, n, 1, options, x, place);
    if (*at + 1 == n && x > p[*at].x)
        return row_beyond(p + n - 1, n, -1, options, x, place);
    if (*at + 1 == n || p[*at].x >= x) {
        *place = p[*at];
        return true;
    }
    if (p[*at + 1].x - p[*at].x <= options->gap) {
        *place = line_at(p[*at], p[*at + 1], x);
        return true;
    }
    return row_beyond(p + *at, *at + 1, -1, options, x, place) ||
           row_beyond(p + *at + 1, n - *at - 1, 1, options, x, place);
}

/* A height beyond the first or last of the places on a column, as row_beyond with y for x. */
static double height_beyond(const struct vec3 *end, size_t n, int step,
                            const struct lin_grid_options *options, double y)
{
    if (fabs(y - end->y) > options->reach)
        return NAN;
    for (size_t k = 1; k < n; k++) {
        struct vec3 next = end[step * (long)k];
        double base = fabs(next.y - end->y);
        if (base > options->gap)
            return NAN;
        if (base >= fmax(NARROW * options->mean, fabs(y - end->y) / 2)) {
            double slope = (next.z - end->z) / (next.y - end->y);
            return fabs(slope) > STEEP ? NAN : end->z + slope * (y - end->y);
        }
    }
    return NAN;
}

/* The height at y on a column that rows cross at n places by rising y. */
static double height_at(const struct vec3 *p, size_t n, size_t *at,
                        const struct lin_grid_options *options, double y)
{
    if (n == 0)
        return NAN;
    while (*at + 1 < n && p[*at + 1].y <= y)
        ++*at;
    if (y < p[0].y)
        return height_beyond(p, n, 1, options, y);
    if (*at + 1 == n)
        return y > p[*at].y ? height_beyond(p + *at, n, -1, options, y) : p[*at].z;
    double wide = p[*at + 1].y - p[*at].y;
    if (wide <= options->gap)
        return wide > 0 ? p[*at].z + (p[*at + 1].z - p[*at].z) * (y - p[*at].y) / wide : p[*at].z;
    double z = height_beyond(p + *at, *at + 1, -1, options, y);
    return isnan(z) ? height_beyond(p + *at + 1, n - *at - 1, 1, options, y) : z;
}

static double node_x(const struct lin_grid *grid, size_t column)
{
    const struct plan_extent *f = &grid->extent;

    return column + 1 == grid->columns ? f->xmax : f->xmin + (double)column * grid->dx;
}

static double node_y(const struct lin_grid *grid, size_t row)
{
    const struct plan_extent *f = &grid->extent;

    return row + 1 == grid->rows ? f->ymax : f->ymin + (double)row * grid->dy;
}

/* Rows that go on beyond their ends may cross others. */
static void sort_upwards(struct vec3 *crossing, size_t n)
{
    for (size_t k = 1; k < n; k++)
        for (size_t i = k; i > 0 && crossing[i].y < crossing[i - 1].y; i--) {
            struct vec3 swap = crossing[i];
            crossing[i] = crossing[i - 1];
            crossing[i - 1] = swap;
        }
}

static void fill_column(const struct bands *b, const struct lin_grid_options *options,
                        size_t column, size_t *at, struct vec3 *crossing, struct lin_grid *grid)
{
    size_t n = 0, before = 0;

    for (size_t k = 0; k < b->n; k++)
        n += row_at(b->point + b->from[k], b->from[k + 1] - b->from[k], &at[k], options,
                    node_x(grid, column), &crossing[n]);
    sort_upwards(crossing, n);
    for (size_t row = 0; row < grid->rows; row++)
        grid->z[row * grid->columns + column] =
            height_at(crossing, n, &before, options, node_y(grid, row));
}

static int lay_out(const struct plan_extent *f, size_t n, double spacing, struct lin_grid *grid,
                   struct error *error)
{
    double columns = fmax(2, ceil((f->xmax - f->xmin) / spacing * (1 - 1e-12)) + 1);
    double rows = fmax(2, ceil((f->ymax - f->ymin) / spacing * (1 - 1e-12)) + 1);

    if (!(columns * rows <= NODES_A_POINT * (double)n + NODES_MORE))
        return error_set(error,
                         "a grid of spacing %g mm over %g x %g mm has %.3g nodes for %zu points, "
                         "expected a wider spacing (-t)",
                         spacing, f->xmax - f->xmin, f->ymax - f->ymin, columns * rows, n);
    *grid = (struct lin_grid){*f,
                              (f->xmax - f->xmin) / (columns - 1),
                              (f->ymax - f->ymin) / (rows - 1),
                              (size_t)columns,
                              (size_t)rows,
                              mem_alloc((size_t)(columns * rows), sizeof *grid->z)};
    return 0;
}

int lin_grid_make(const struct plan_extent *extent, const struct vec3 *point, size_t n,
                  const struct lin_grid_options *options, struct lin_grid *grid,
                  struct error *error)
{
    if (lay_out(extent, n, options->spacing, grid, error) < 0)
        return -1;
    struct bands b = bands_make(extent, point, n, options->mean);
    size_t *at = mem_alloc(b.n, sizeof *at);
    struct vec3 *crossing = mem_alloc(b.n, sizeof *crossing);

    for (size_t column = 0; column < grid->columns; column++)
        fill_column(&b, options, column, at, crossing, grid);
    free(crossing);
    free(at);
    bands_free(&b);
    return 0;
}

void lin_grid_free(struct lin_grid *grid)
{
    free(grid->z);
    grid->z = NULL;
}

struct vec3 lin_grid_node(const struct lin_grid *grid, size_t column, size_t row)
{
    struct vec3 p =
        vec(node_x(grid, column), node_y(grid, row), grid->z[row * grid->columns + column]);

    return plan_extent_turn_back(&grid->extent, p);
}

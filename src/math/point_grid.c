/* point_grid - see point_grid.h. */
#include "math/point_grid.h"

#include <stdbool.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "math/pair.h"
#include "point_grid_sort.h"

static const double CELLS_WIDE = 3; /* a cell, in spacings */

static double coordinate(struct vec3 p, int axis)
{
    return axis == 0 ? p.x : p.y;
}

/* The box of the points seen from above. */
static void range_of(const struct vec3 *point, size_t n, pair *low, pair *high)
{
    *low = *high = pair_at(&point[0].x);
    for (size_t i = 1; i < n; i++) {
        pair at = pair_at(&point[i].x);
        *low = pair_lesser(at, *low);
        *high = pair_greater(at, *high);
    }
}

/* The range without the few points far out: a histogram of it, cut from both ends as long as that
 * takes no more than a five hundredth of the points, and again while it gets much narrower. */
static void core_of(const struct vec3 *point, size_t n, int axis, double *low, double *high)
{
    enum { BINS = 256, ROUNDS = 8, PART = 500 };
    for (int round = 0; round<ROUNDS && * high> * low; round++) {
        size_t bin[BINS] = {0}, cut[2] = {0, 0};
        double width = (*high - *low) / BINS;
        for (size_t i = 0; i < n; i++) {
            double v = (coordinate(point[i], axis) - *low) / width;
            bin[v > 0 ? (v < BINS - 1 ? (size_t)v : BINS - 1) : 0]++;
        }
        size_t from = 0, to = BINS;
        while (from < to && (cut[0] += bin[from]) <= n / PART)
            from++;
        while (to > from && (cut[1] += bin[to - 1]) <= n / PART)
            to--;
        *high = *low + width * (double)to;
        *low += width * (double)from;
        if (to - from > BINS / 2)
            break;
    }
}

/* Columns and rows up to there, of wider cells where these would be too many. */
static void count_cells(struct point_grid *b, double x1, double y1, double most)
{
    double columns, rows;

    while ((columns = floor((x1 - b->x) / b->cell) + 1) *
               (rows = floor((y1 - b->y) / b->cell) + 1) >
           most)
        b->cell *= 2;
    b->columns = (size_t)columns;
    b->rows = (size_t)rows;
}

/* Cells over the box of the points; over their core where the box is mostly empty. */
static void lay_out(struct point_grid *b, double spacing)
{
    double most = fmin((double)b->n + 64, UINT32_MAX);
    pair low, high;
    range_of(b->point, b->n, &low, &high);
    double x1 = high[0], y1 = high[1];
    b->x = low[0];
    b->y = low[1];
    b->cell = CELLS_WIDE * spacing;
    if ((floor((x1 - b->x) / b->cell) + 1) * (floor((y1 - b->y) / b->cell) + 1) > most) {
        core_of(b->point, b->n, 0, &b->x, &x1);
        core_of(b->point, b->n, 1, &b->y, &y1);
    }
    count_cells(b, x1, y1, most);
}

static size_t cell_from(double from, double cell, double v, size_t cells)
{
    double c = (v - from) / cell;
    if (!(c > 0))
        return 0;
    return c < (double)(cells - 1) ? (size_t)c : cells - 1;
}

size_t point_grid_column(const struct point_grid *b, double x)
{
    return cell_from(b->x, b->cell, x, b->columns);
}

size_t point_grid_row(const struct point_grid *b, double y)
{
    return cell_from(b->y, b->cell, y, b->rows);
}

static int check_count(size_t n, struct error *error)
{
    return n > 0 && n <= UINT32_MAX ? 0
                                    : error_set(error, "found %zu points, expected 1 to %lu", n,
                                                (unsigned long)UINT32_MAX);
}

int point_grid_make(struct vec3 *point, size_t n, double spacing, int threads,
                    struct point_grid *point_grid, struct error *error)
{
    if (check_count(n, error) < 0)
        return -1;
    *point_grid = (struct point_grid){.point = point, .n = n};
    lay_out(point_grid, spacing);
    point_grid_sort(point_grid, threads);
    return 0;
}

struct point_grid point_grid_lattice(struct vec3 low, struct vec3 high, size_t n, double spacing)
{
    const double room = 4; /* cells a point: of a box that is mostly empty */
    double most = fmin(room * (double)n + 64, UINT32_MAX);
    struct point_grid b = {.x = low.x, .y = low.y, .cell = CELLS_WIDE * spacing};

    count_cells(&b, high.x, high.y, most);
    return b;
}

int point_grid_make_in(const struct point_grid *lattice, struct vec3 *point, size_t n, int threads,
                       struct point_grid *point_grid, struct error *error)
{
    if (check_count(n, error) < 0)
        return -1;
    *point_grid = *lattice;
    point_grid->point = point;
    point_grid->n = n;
    point_grid_sort(point_grid, threads);
    return 0;
}

size_t point_grid_cell(const struct point_grid *b, struct vec3 place)
{
    return point_grid_row(b, place.y) * b->columns + point_grid_column(b, place.x);
}

double point_grid_spacing(const struct point_grid *b)
{
    return b->cell / CELLS_WIDE;
}

void point_grid_free(struct point_grid *point_grid)
{
    free(point_grid->first);
    point_grid->first = NULL;
}

static bool has_any(const unsigned char *out, size_t n)
{
    enum { BLOCK = 64 };
    unsigned char any = 0;
    for (size_t i = 0; i < n && !any; i += BLOCK)
        for (size_t k = i; k < n && k < i + BLOCK; k++)
            any |= out[k];
    return any != 0;
}

void point_grid_remove(struct point_grid *b, const unsigned char *out)
{
    size_t cells = b->columns * b->rows, kept = 0;
    if (!has_any(out, b->n))
        return;
    for (size_t c = 0; c < cells; c++) {
        size_t from = b->first[c], to = b->first[c + 1];
        b->first[c] = (uint32_t)kept;
        for (size_t i = from; i < to; i++)
            if (!out[i])
                b->point[kept++] = b->point[i];
    }
    b->first[cells] = (uint32_t)kept;
    b->n = kept;
}

struct point_grid_walk point_grid_about(const struct point_grid *b, struct vec3 place, double reach)
{
    return (struct point_grid_walk){.grid = b,
                                    .left = point_grid_column(b, place.x - reach),
                                    .right = point_grid_column(b, place.x + reach),
                                    .row = point_grid_row(b, place.y - reach),
                                    .high = point_grid_row(b, place.y + reach)};
}

void point_grid_over(const struct point_grid *k, struct vec3 a, struct vec3 b, struct vec3 c,
                     double border, struct sizes *found)
{
    size_t c0 = point_grid_column(k, fmin(a.x, fmin(b.x, c.x)));
    size_t c1 = point_grid_column(k, fmax(a.x, fmax(b.x, c.x)));
    size_t r0 = point_grid_row(k, fmin(a.y, fmin(b.y, c.y)));
    size_t r1 = point_grid_row(k, fmax(a.y, fmax(b.y, c.y)));

    for (size_t r = r0; r <= r1; r++)
        for (size_t i = k->first[r * k->columns + c0]; i < k->first[r * k->columns + c1 + 1]; i++)
            if (vec_orient_xy(a, b, k->point[i]) >= -border &&
                vec_orient_xy(b, c, k->point[i]) >= -border &&
                vec_orient_xy(c, a, k->point[i]) >= -border)
                *array_push(found) = i;
}

void point_grid_within(const struct point_grid *b, struct vec3 q, double radius,
                       struct sizes *found)
{
    if (b->n == 0)
        return;
    struct point_grid_walk about = point_grid_about(b, q, radius);

    for (size_t i; point_grid_next(&about, &i);) {
        struct vec3 d = vec_sub(b->point[i], q);
        if (vec_dot(d, d) <= radius * radius)
            *array_push(found) = i;
    }
}

/* point_grid - a counting sort, then each cell by value; see point_grid.h. */
#include "math/point_grid.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"

enum { PARTS = 4 }; /* of the cells, for threads to fill */

static const double CELLS_WIDE = 3; /* a cell, in spacings */

static double along(struct vec3 p, int axis)
{
    return axis == 0 ? p.x : p.y;
}

static void range_of(const struct vec3 *point, size_t n, int axis, double *low, double *high)
{
    *low = *high = along(point[0], axis);
    for (size_t i = 1; i < n; i++) {
        double v = along(point[i], axis);
        *low = v < *low ? v : *low;
        *high = v > *high ? v : *high;
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
            double v = (along(point[i], axis) - *low) / width;
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

/* Cells over the box of the points; over their core where the box is mostly empty. */
static void lay_out(struct point_grid *b, double spacing)
{
    double x1, y1, most = (double)b->n + 64;
    range_of(b->point, b->n, 0, &b->x, &x1);
    range_of(b->point, b->n, 1, &b->y, &y1);
    b->cell = CELLS_WIDE * spacing;
    if ((floor((x1 - b->x) / b->cell) + 1) * (floor((y1 - b->y) / b->cell) + 1) > most) {
        core_of(b->point, b->n, 0, &b->x, &x1);
        core_of(b->point, b->n, 1, &b->y, &y1);
    }
    double columns, rows;
    while ((columns = floor((x1 - b->x) / b->cell) + 1) *
               (rows = floor((y1 - b->y) / b->cell) + 1) >
           most)
        b->cell *= 2;
    b->columns = (size_t)columns;
    b->rows = (size_t)rows;
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

static size_t cell_of(const struct point_grid *b, struct vec3 p)
{
    return point_grid_row(b, p.y) * b->columns + point_grid_column(b, p.x);
}

/* What threads share to sort points into cells. */
struct sorting {
    const struct point_grid *b;
    uint32_t *cell, *next; /* of each point; where the next point of each cell goes */
    struct vec3 *sorted;
};

static void find_cells(void *context, size_t from, size_t to)
{
    const struct sorting *s = context;
    for (size_t i = from; i < to; i++)
        s->cell[i] = (uint32_t)cell_of(s->b, s->b->point[i]);
}

/* A part of the cells takes its points, from all of them. */
static void take_points(void *context, size_t from, size_t to)
{
    const struct sorting *s = context;
    size_t cells = s->b->columns * s->b->rows;
    size_t low = cells * from / PARTS, high = cells * to / PARTS;
    for (size_t i = 0; i < s->b->n; i++)
        if (s->cell[i] >= low && s->cell[i] < high)
            s->sorted[s->next[s->cell[i]]++] = s->b->point[i];
}

static void sort_into_cells(struct point_grid *b, int threads)
{
    size_t cells = b->columns * b->rows;
    struct sorting s = {b, mem_alloc(b->n, sizeof *s.cell), mem_alloc(cells, sizeof *s.next),
                        mem_alloc(b->n, sizeof *s.sorted)};
    b->first = mem_alloc(cells + 1, sizeof *b->first);
    parallel_for(threads, b->n, find_cells, &s);
    for (size_t i = 0; i < b->n; i++)
        b->first[s.cell[i] + 1]++;
    for (size_t c = 0; c < cells; c++)
        b->first[c + 1] += s.next[c] = b->first[c];
    parallel_for(threads, PARTS, take_points, &s);
    memcpy(b->point, s.sorted, b->n * sizeof *b->point);
    free(s.cell);
    free(s.next);
    free(s.sorted);
}

static int by_value(const void *a, const void *b)
{
    const struct vec3 *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->z > q->z) - (p->z < q->z);
}

static void sort_cells(void *context, size_t from, size_t to)
{
    enum { FEW = 24 };
    const struct point_grid *b = context;
    for (size_t c = from; c < to; c++) {
        struct vec3 *p = b->point + b->first[c];
        size_t n = b->first[c + 1] - b->first[c];
        if (n > FEW) {
            qsort(p, n, sizeof *p, by_value);
            continue;
        }
        for (size_t i = 1; i < n; i++) {
            struct vec3 v = p[i];
            size_t k = i;
            for (; k > 0 && by_value(&v, &p[k - 1]) < 0; k--)
                p[k] = p[k - 1];
            p[k] = v;
        }
    }
}

int point_grid_make(struct vec3 *point, size_t n, double spacing, int threads,
                    struct point_grid *point_grid, struct error *error)
{
    if (n == 0 || n > UINT32_MAX)
        return error_set(error, "found %zu points, expected 1 to %lu", n,
                         (unsigned long)UINT32_MAX);
    *point_grid = (struct point_grid){.point = point, .n = n};
    lay_out(point_grid, spacing);
    sort_into_cells(point_grid, threads);
    parallel_for(threads, point_grid->columns * point_grid->rows, sort_cells, point_grid);
    return 0;
}

void point_grid_free(struct point_grid *point_grid)
{
    free(point_grid->first);
    point_grid->first = NULL;
}

void point_grid_remove(struct point_grid *b, const unsigned char *out)
{
    size_t cells = b->columns * b->rows, kept = 0;
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

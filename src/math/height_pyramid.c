/* height_pyramid - see height_pyramid.h. */
#include "math/height_pyramid.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

enum { TO_A_CELL = 16, MOST_ACROSS = 8 };

static size_t cell_at(double from, double cell, double v, size_t cells)
{
    double c = (v - from) / cell;

    if (!(c > 0))
        return 0;
    return c < (double)(cells - 1) ? (size_t)c : cells - 1;
}

/* Each level half as wide and deep as the one before, all in one array. */
static void lay_levels(struct height_pyramid *r)
{
    size_t columns = r->columns, rows = r->rows, cells = 0;

    while (r->levels < HEIGHT_PYRAMID_LEVELS) {
        r->level[r->levels++] = (struct height_pyramid_level){columns, rows, NULL};
        cells += columns * rows;
        if (columns * rows == 1)
            break;
        columns = (columns + 1) / 2;
        rows = (rows + 1) / 2;
    }
    r->top = mem_alloc(cells, sizeof *r->top);
    for (size_t i = 0; i < cells; i++)
        r->top[i] = -INFINITY;
    cells = 0;
    for (size_t k = 0; k < r->levels; k++) {
        r->level[k].top = r->top + cells;
        cells += r->level[k].columns * r->level[k].rows;
    }
}

static void raise_level(const struct height_pyramid_level *fine,
                        struct height_pyramid_level *coarse)
{
    for (size_t row = 0; row < fine->rows; row++) {
        for (size_t c = 0; c < fine->columns; c++) {
            double z = fine->top[row * fine->columns + c];
            double *top = &coarse->top[row / 2 * coarse->columns + c / 2];
            *top = z > *top ? z : *top;
        }
    }
}

struct height_pyramid height_pyramid_over(const struct vec3 *point, size_t n)
{
    struct height_pyramid r = {.columns = 0};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

    if (n == 0)
        return r;
    for (size_t i = 0; i < n; i++) {
        low[0] = fmin(low[0], point[i].x);
        low[1] = fmin(low[1], point[i].y);
        high[0] = fmax(high[0], point[i].x);
        high[1] = fmax(high[1], point[i].y);
    }
    double most = (double)n / TO_A_CELL + 1, wide = high[0] - low[0], deep = high[1] - low[1];
    r.x = low[0];
    r.y = low[1];
    r.cell = fmax(sqrt(wide * deep / most), fmax(wide, deep) / most);
    if (!(r.cell > 0))
        r.cell = 1;
    r.columns = (size_t)(wide / r.cell) + 1;
    r.rows = (size_t)(deep / r.cell) + 1;
    lay_levels(&r);
    for (size_t i = 0; i < n; i++) {
        double *top = &r.level[0].top[cell_at(r.y, r.cell, point[i].y, r.rows) * r.columns +
                                      cell_at(r.x, r.cell, point[i].x, r.columns)];
        *top = point[i].z > *top ? point[i].z : *top;
    }
    for (size_t k = 1; k < r.levels; k++)
        raise_level(&r.level[k - 1], &r.level[k]);
    return r;
}

void height_pyramid_free(struct height_pyramid *height_pyramid)
{
    free(height_pyramid->top);
    height_pyramid->top = NULL;
}

double height_pyramid_top(const struct height_pyramid *r, struct vec3 a, struct vec3 b,
                          double radius)
{
    double top = -INFINITY;

    if (r->columns == 0)
        return top;
    size_t left = cell_at(r->x, r->cell, fmin(a.x, b.x) - radius, r->columns);
    size_t right = cell_at(r->x, r->cell, fmax(a.x, b.x) + radius, r->columns);
    size_t low = cell_at(r->y, r->cell, fmin(a.y, b.y) - radius, r->rows);
    size_t high = cell_at(r->y, r->cell, fmax(a.y, b.y) + radius, r->rows);
    size_t k = 0;
    while (k + 1 < r->levels &&
           ((right - left) >> k >= MOST_ACROSS || (high - low) >> k >= MOST_ACROSS))
        k++;
    const struct height_pyramid_level *level = &r->level[k];
    for (size_t row = low >> k; row <= high >> k; row++) {
        for (size_t c = left >> k; c <= right >> k; c++) {
            double z = level->top[row * level->columns + c];
            top = z > top ? z : top;
        }
    }
    return top;
}

/* roofs - see roofs.h. */
#include "roofs.h"

#include <math.h>
#include <stdlib.h>

#include "array.h"

enum { TO_A_CELL = 16, MOST_LOOKED_AT = 400 };

static size_t cell_at(double from, double cell, double v, size_t cells)
{
    double c = (v - from) / cell;

    if (!(c > 0))
        return 0;
    return c < (double)(cells - 1) ? (size_t)c : cells - 1;
}

struct roofs roofs_over(const struct vec3 *point, size_t n)
{
    struct roofs r = {.columns = 0};
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
    r.top = mem_alloc(r.columns * r.rows, sizeof *r.top);
    for (size_t i = 0; i < r.columns * r.rows; i++)
        r.top[i] = -INFINITY;
    for (size_t i = 0; i < n; i++) {
        double *top = &r.top[cell_at(r.y, r.cell, point[i].y, r.rows) * r.columns +
                             cell_at(r.x, r.cell, point[i].x, r.columns)];
        *top = point[i].z > *top ? point[i].z : *top;
    }
    return r;
}

void roofs_free(struct roofs *roofs)
{
    free(roofs->top);
    roofs->top = NULL;
}

double roofs_top(const struct roofs *r, struct vec3 a, struct vec3 b, double radius)
{
    double top = -INFINITY;

    if (r->columns == 0)
        return top;
    size_t left = cell_at(r->x, r->cell, fmin(a.x, b.x) - radius, r->columns);
    size_t right = cell_at(r->x, r->cell, fmax(a.x, b.x) + radius, r->columns);
    size_t low = cell_at(r->y, r->cell, fmin(a.y, b.y) - radius, r->rows);
    size_t high = cell_at(r->y, r->cell, fmax(a.y, b.y) + radius, r->rows);
    if ((right - left + 1) * (high - low + 1) > MOST_LOOKED_AT)
        return INFINITY;
    for (size_t row = low; row <= high; row++) {
        for (size_t c = left; c <= right; c++) {
            double z = r->top[row * r->columns + c];
            top = z > top ? z : top;
        }
    }
    return top;
}

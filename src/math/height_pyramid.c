/* height_pyramid - see height_pyramid.h. */
#include "math/height_pyramid.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/box.h"

enum { POINTS_IN_CELL = 16, CELLS_ACROSS = 8, BOXES_MOST = 64 };

static const struct height_range EMPTY = {HUGE_VAL, -HUGE_VAL};

struct height_pyramid height_pyramid_new(double x, double y, double dx, double dy, int columns,
                                         int rows)
{
    struct height_pyramid p = {.x = x, .y = y, .dx = dx, .dy = dy};

    while (p.levels < HEIGHT_PYRAMID_LEVELS) {
        size_t n = (size_t)columns * (size_t)rows;
        struct height_level *level = &p.level[p.levels++];
        *level = (struct height_level){columns, rows, mem_alloc(n, sizeof *level->cell)};
        for (size_t i = 0; i < n; i++)
            level->cell[i] = EMPTY;
        if (n == 1)
            break;
        columns = (columns + 1) / 2;
        rows = (rows + 1) / 2;
    }
    return p;
}

void height_pyramid_free(struct height_pyramid *pyramid)
{
    for (int k = 0; k < pyramid->levels; k++)
        free(pyramid->level[k].cell);
    pyramid->levels = 0;
}

static struct height_range *cell_at(const struct height_level *level, int i, int j)
{
    return &level->cell[(size_t)j * (size_t)level->columns + (size_t)i];
}

static void range_join(struct height_range *range, struct height_range other)
{
    range->low = other.low < range->low ? other.low : range->low;
    range->high = other.high > range->high ? other.high : range->high;
}

/* The range of cell (i, j) of a level from its four of the level before. */
static void join_four(struct height_pyramid *p, int level, int i, int j)
{
    const struct height_level *fine = &p->level[level - 1];
    struct height_range sum = EMPTY;

    for (int c = 0; c < 4; c++) {
        int ci = 2 * i + c % 2, cj = 2 * j + c / 2;
        if (ci < fine->columns && cj < fine->rows)
            range_join(&sum, *cell_at(fine, ci, cj));
    }
    *cell_at(&p->level[level], i, j) = sum;
}

void height_pyramid_set(struct height_pyramid *p, struct height_cell at, struct height_range range)
{
    *cell_at(&p->level[0], at.column, at.row) = range;
    for (int k = 1; k < p->levels; k++)
        join_four(p, k, at.column >> k, at.row >> k);
}

static int clamp(double x, int n)
{
    return !(x > 0) ? 0 : x < n - 1 ? (int)x : n - 1;
}

struct height_cell height_pyramid_cell(const struct height_pyramid *p, struct vec3 at)
{
    return (struct height_cell){clamp((at.x - p->x) / p->dx, p->level[0].columns),
                                clamp((at.y - p->y) / p->dy, p->level[0].rows)};
}

struct height_pyramid height_pyramid_over(const struct vec3 *point, size_t n)
{
    struct box box = box_around(point, n);

    if (n == 0)
        return (struct height_pyramid){.levels = 0};
    double most = (double)n / POINTS_IN_CELL + 1;
    double wide = box.high.x - box.low.x, deep = box.high.y - box.low.y;
    double cell = fmax(sqrt(wide * deep / most), fmax(wide, deep) / most);
    if (!(cell > 0))
        cell = 1;
    struct height_pyramid p = height_pyramid_new(box.low.x, box.low.y, cell, cell,
                                                 (int)(wide / cell) + 1, (int)(deep / cell) + 1);
    for (size_t i = 0; i < n; i++) {
        struct height_cell at = height_pyramid_cell(&p, point[i]);
        range_join(cell_at(&p.level[0], at.column, at.row),
                   (struct height_range){point[i].z, point[i].z});
    }
    for (int k = 1; k < p.levels; k++)
        for (int j = 0; j < p.level[k].rows; j++)
            for (int i = 0; i < p.level[k].columns; i++)
                join_four(&p, k, i, j);
    return p;
}

double height_pyramid_top(const struct height_pyramid *p, struct vec3 a, struct vec3 b,
                          double radius)
{
    double top = -INFINITY;
    int k = 0;

    if (p->levels == 0)
        return top;
    struct height_cell low =
        height_pyramid_cell(p, vec(fmin(a.x, b.x) - radius, fmin(a.y, b.y) - radius, 0));
    struct height_cell high =
        height_pyramid_cell(p, vec(fmax(a.x, b.x) + radius, fmax(a.y, b.y) + radius, 0));
    while (k + 1 < p->levels && ((high.column - low.column) >> k >= CELLS_ACROSS ||
                                 (high.row - low.row) >> k >= CELLS_ACROSS))
        k++;
    for (int j = low.row >> k; j <= high.row >> k; j++) {
        for (int i = low.column >> k; i <= high.column >> k; i++) {
            double z = cell_at(&p->level[k], i, j)->high;
            top = z > top ? z : top;
        }
    }
    return top;
}

/* Nothing over the cell is nearer than this; a tall box is several, one on top of the other. */
static double cell_bound(const struct height_pyramid *p, const struct height_search *search,
                         int level, int i, int j)
{
    const struct height_range *range = cell_at(&p->level[level], i, j);
    double dx = ldexp(p->dx, level), dy = ldexp(p->dy, level), tall = range->high - range->low;

    if (tall < 0)
        return HUGE_VAL;
    double boxes = fmin(fmax(1, ceil(tall / (dx + dy))), BOXES_MOST), least = HUGE_VAL;
    struct vec3 half = vec(dx / 2, dy / 2, tall / boxes / 2);
    for (int k = 0; k < (int)boxes; k++) {
        double z = range->low + (k + 0.5) * tall / boxes;
        struct vec3 middle = vec(p->x + (i + 0.5) * dx, p->y + (j + 0.5) * dy, z);
        least = fmin(least, search->bound(search->context, middle, half));
    }
    return least;
}

static void descend(const struct height_pyramid *p, struct height_search *search, int level, int i,
                    int j)
{
    struct child {
        double bound;
        int i, j;
    } child[4];
    int n = 0;

    if (level == 0) {
        search->nearest = search->visit(search->context, (struct height_cell){i, j});
        return;
    }
    for (int c = 0; c < 4; c++) {
        struct child next = {0, 2 * i + c % 2, 2 * j + c / 2};
        if (next.i >= p->level[level - 1].columns || next.j >= p->level[level - 1].rows)
            continue;
        next.bound = cell_bound(p, search, level - 1, next.i, next.j);
        int k = n++;
        for (; k > 0 && child[k - 1].bound > next.bound; k--)
            child[k] = child[k - 1];
        child[k] = next;
    }
    for (int k = 0; k < n && child[k].bound < search->nearest && search->nearest >= search->enough;
         k++)
        descend(p, search, level - 1, child[k].i, child[k].j);
}

void height_pyramid_search(const struct height_pyramid *p, struct height_search *search)
{
    int top = p->levels - 1;

    if (top >= 0 && cell_bound(p, search, top, 0, 0) < search->nearest)
        descend(p, search, top, 0, 0);
}

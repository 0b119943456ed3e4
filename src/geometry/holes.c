/*
 * holes - every point marks the cells within half the gap of it; a facet bridges a hole when it
 * has an unmarked cell; see holes.h.
 */
#include "holes.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "footprint.h"

enum { CELLS_A_GAP = 6, REACH = CELLS_A_GAP / 2 };

static const double MOST_CELLS = 2e8;

/* The raster with a border of REACH cells around the points, so that no mark falls outside. */
static int lay_out(const struct footprint *f, double gap, struct holes *h, struct error *error)
{
    double cell = gap / CELLS_A_GAP;
    double columns = floor((f->xmax - f->xmin) / cell) + 1 + 2 * REACH;
    double rows = floor((f->ymax - f->ymin) / cell) + 1 + 2 * REACH;
    if (!(columns * rows <= MOST_CELLS))
        return error_set(error,
                         "a largest gap of %g mm is too small for points that reach over "
                         "%g x %g mm, expected more than %.2g mm",
                         gap, f->xmax - f->xmin, f->ymax - f->ymin,
                         gap * sqrt(columns * rows / MOST_CELLS));
    *h = (struct holes){gap, cell, f->xmin, f->ymin, (size_t)columns, (size_t)rows, NULL};
    h->near = mem_alloc(h->columns * h->rows, 1);
    return 0;
}

/* Counted from the lowest leftmost point, so that rounding puts no point of the cloud into the
 * border; a place on a facet may lie before it by rounding. */
static size_t cell_of(const struct holes *h, double x, double y)
{
    size_t column = REACH + (size_t)fmax((x - h->x) / h->cell, 0);
    size_t row = REACH + (size_t)fmax((y - h->y) / h->cell, 0);
    return row * h->columns + column;
}

/* Half the width in cells of a disc of radius REACH, `away` rows from its middle. */
static size_t half_width(int away)
{
    return (size_t)sqrt((double)(REACH * REACH - away * away));
}

int holes_find(const struct vec3 *point, size_t n, double gap, struct holes *holes,
               struct error *error)
{
    struct footprint f = footprint_of(point, n, 0);
    if (lay_out(&f, gap, holes, error) < 0)
        return -1;
    size_t cells = holes->columns * holes->rows;
    unsigned char *taken = mem_alloc(cells, 1);
    for (size_t i = 0; i < n; i++)
        taken[cell_of(holes, point[i].x, point[i].y)] = 1;
    size_t width[2 * REACH + 1];
    for (int away = -REACH; away <= REACH; away++)
        width[away + REACH] = half_width(away);
    for (size_t i = 0; i < cells; i++) {
        if (!taken[i])
            continue;
        unsigned char *row = holes->near + i - REACH * holes->columns;
        for (int k = 0; k <= 2 * REACH; k++, row += holes->columns)
            memset(row - width[k], 1, 2 * width[k] + 1);
    }
    free(taken);
    return 0;
}

void holes_free(struct holes *holes)
{
    free(holes->near);
    holes->near = NULL;
}

static double distance2(struct vec3 a, struct vec3 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

bool holes_bridged(const struct holes *holes, struct vec3 a, struct vec3 b, struct vec3 c)
{
    double longest2 = fmax(distance2(a, b), fmax(distance2(b, c), distance2(c, a)));
    if (longest2 * 4 <=
        holes->gap * holes->gap * 3) /* no place in it is half a gap from a corner */
        return false;
    int steps = (int)ceil(sqrt(longest2) / holes->cell);
    for (int i = 0; i <= steps; i++)
        for (int j = 0; i + j <= steps; j++) {
            double s = (double)i / steps, t = (double)j / steps;
            double x = a.x + s * (b.x - a.x) + t * (c.x - a.x);
            double y = a.y + s * (b.y - a.y) + t * (c.y - a.y);
            if (!holes->near[cell_of(holes, x, y)])
                return true;
        }
    return false;
}

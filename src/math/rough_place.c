/* rough_place - see rough_place.h. */
#include "rough_place.h"

#include "math/side_fit.h"

/* Points of a cell that tell; cells that must. */
enum { POINTS = 6, CELLS = 3 };

/* The points of a cell, from the first of them. */
struct cell {
    struct side_sums sum;
    double hh; /* the sum of the squares of their heights */
};

static void add_point(struct cell *cell, double part, struct vec3 d)
{
    side_sums_add(&cell->sum, part, d);
    cell->hh += part * d.z * d.z;
}

/* What the heights of the points leave to each of those that a plane does not fix: mean square;
 * negative: they carry no plane. */
static double plane_leaves(const struct cell *cell)
{
    const double fixed = 3;
    const struct side_sums *s = &cell->sum;
    struct side_fit plane = {.q = {.c = {0}}};
    const double *c = plane.q.c;

    if (side_fit_plane_of(s, &plane) < 0)
        return -1;
    return fmax(cell->hh - c[0] * s->h - c[1] * s->uh - c[2] * s->vh, 0) / (s->n - fixed);
}

/* The same of the points of a cell, or of all of them but one, whichever leaves the least: one that
 * is far off its neighbours makes no rough place. */
static double least_left(const struct vec3 *point, size_t n, double enough)
{
    struct cell all = {.hh = 0};

    for (size_t i = 0; i < n; i++)
        add_point(&all, 1, vec_sub(point[i], point[0]));
    double least = plane_leaves(&all);
    for (size_t i = 0; i < n && least > enough; i++) {
        struct cell others = all;
        add_point(&others, -1, vec_sub(point[i], point[0]));
        double left = plane_leaves(&others);
        least = left >= 0 && left < least ? left : least;
    }
    return least;
}

bool rough_place(const struct point_grid *scan, struct vec3 place, double most)
{
    size_t column = point_grid_column(scan, place.x), row = point_grid_row(scan, place.y);
    size_t told = 0;

    for (size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < scan->rows; r++)
        for (size_t c = column > 0 ? column - 1 : 0; c <= column + 1 && c < scan->columns; c++) {
            const uint32_t *first = scan->first + r * scan->columns + c;
            size_t n = first[1] - first[0];
            double left = n < POINTS ? -1 : least_left(scan->point + first[0], n, most * most);
            if (left >= 0 && left <= most * most)
                return false;
            told += left >= 0;
        }
    return told >= CELLS;
}

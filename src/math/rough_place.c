/* rough_place - see rough_place.h. */
#include "rough_place.h"

#include "math/side_fit.h"

/* Points of a cell that tell; cells that must. */
enum { POINTS = 6, CELLS = 3 };

/* What the heights of the points leave to each of those that a plane does not fix: mean square;
 * negative: they carry no plane. */
static double plane_leaves(const struct vec3 *point, size_t n)
{
    const double fixed = 3;
    struct side_sums s = {.n = 0};
    struct side_fit plane = {.q = {.c = {0}}};
    const double *c = plane.q.c;
    double hh = 0;

    for (size_t i = 0; i < n; i++) {
        struct vec3 d = vec_sub(point[i], point[0]);
        side_sums_add(&s, 1, d);
        hh += d.z * d.z;
    }
    if (side_fit_plane_of(&s, &plane) < 0)
        return -1;
    return fmax(hh - c[0] * s.h - c[1] * s.uh - c[2] * s.vh, 0) / ((double)n - fixed);
}

bool rough_place(const struct point_grid *scan, struct vec3 place, double most)
{
    size_t column = point_grid_column(scan, place.x), row = point_grid_row(scan, place.y);
    size_t told = 0;

    for (size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < scan->rows; r++)
        for (size_t c = column > 0 ? column - 1 : 0; c <= column + 1 && c < scan->columns; c++) {
            const uint32_t *first = scan->first + r * scan->columns + c;
            size_t n = first[1] - first[0];
            double left = n < POINTS ? -1 : plane_leaves(scan->point + first[0], n);
            if (left >= 0 && left <= most * most)
                return false;
            told += left >= 0;
        }
    return told >= CELLS;
}

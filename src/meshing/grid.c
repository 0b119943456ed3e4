/* grid - see grid.h. */
#include "meshing/grid.h"

int grid_make(const struct plan_extent *plan_extent, size_t n, double t, struct grid *grid,
              struct error *error)
{
    enum { NODES_A_POINT = 50, NODES_FREE = 1000 };
    const double inside = 1e-9; /* a side that is a whole number of t needs no more */
    double width = plan_extent->xmax - plan_extent->xmin,
           height = plan_extent->ymax - plan_extent->ymin;
    double lean = height / tan(PI / 3);
    double columns = fmax(ceil((width + lean) / t - inside), 1) + 1;
    double rows = fmax(ceil(height / (t * GRID_SLANT) - inside), 1) + 1; /* eq 6, rounded up */
    double most = fmin((double)NODES_A_POINT * (double)n + NODES_FREE, 1e9);
    if (!(columns * rows <= most))
        return error_set(error,
                         "the points reach over %g x %g mm: a grid of spacing %g mm has %.3g nodes "
                         "for %zu points, expected a larger spacing or no points far outside",
                         width, height, t, columns * rows, n);
    *grid = (struct grid){*plan_extent, t,        plan_extent->xmin - lean, plan_extent->ymin,
                          (int)columns, (int)rows};
    return 0;
}

size_t grid_nodes(const struct grid *grid)
{
    return (size_t)grid->columns * (size_t)grid->rows;
}

struct vec3 grid_node(const struct grid *grid, int column, int row)
{
    return vec(grid->x + grid->t * (column + 0.5 * row), grid->y + grid->t * GRID_SLANT * row, 0);
}

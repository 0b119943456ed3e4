/* cell_surface - see cell_surface.h. */
#include "cell_surface.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/moment_fit.h"

enum { NEAR = 16, AROUND = 36 };

static const double LEAN = 0.25;  /* of the points about the middle of a cell, at most */
static const double CLOSE = 0.05; /* of the spacing: what a cubic may leave of them */

/* The point of a cell that is nearest to its middle, seen from above. */
static struct vec3 middle_point(const struct point_grid *b, size_t cell)
{
    size_t column = cell % b->columns, row = cell / b->columns;
    double x = b->x + ((double)column + 0.5) * b->cell, least = INFINITY;
    double y = b->y + ((double)row + 0.5) * b->cell;
    struct vec3 best = b->point[b->first[cell]];

    for (uint32_t i = b->first[cell]; i < b->first[cell + 1]; i++) {
        double dx = b->point[i].x - x, dy = b->point[i].y - y, away2 = dx * dx + dy * dy;
        if (away2 < least) {
            least = away2;
            best = b->point[i];
        }
    }
    return best;
}

static void fit_cells(void *context, size_t from, size_t to)
{
    const struct cell_surfaces *c = context;
    const struct point_grid *b = c->scan;
    const struct vec3 up = vec(0, 0, 1);
    double spacing = point_grid_spacing(b), radius = moment_fit_radius(AROUND, spacing, up);

    for (size_t cell = from; cell < to; cell++) {
        struct moment_fit fit;
        c->fitted[cell] = b->first[cell] < b->first[cell + 1] &&
                          moment_fit_ball(b, middle_point(b, cell), up, radius, &fit) == 0 &&
                          fit.lean < LEAN && fit.cubic_spread < CLOSE * spacing;
        if (c->fitted[cell])
            c->of[cell] = fit.cubic;
    }
}

struct cell_surfaces cell_surfaces_make(const struct point_grid *scan, int threads)
{
    size_t cells = scan->columns * scan->rows;
    struct cell_surfaces c = {scan, mem_alloc(cells, sizeof *c.of),
                              mem_alloc(cells, sizeof *c.fitted)};

    parallel_for(threads, cells, fit_cells, &c);
    return c;
}

void cell_surfaces_free(struct cell_surfaces *cells)
{
    free(cells->of);
    free(cells->fitted);
}

static double off_nearest(const struct point_grid *b, struct vec3 at)
{
    struct vec3 near[NEAR], mean = vec(0, 0, 0);
    struct quadric q;
    size_t n = point_grid_near(b, at, NEAR, near);

    for (size_t k = 0; k < n; k++)
        mean = vec_along(mean, 1 / (double)n, near[k]);
    if (quadric_fit(near, n, at, vec(0, 0, 1), &q) == 0)
        return quadric_distance(&q);
    return fabs(vec_dot(plane_normal(near, n), vec_sub(mean, at)));
}

double cell_surfaces_off(const struct cell_surfaces *c, struct vec3 at)
{
    const struct point_grid *b = c->scan;
    size_t cell = point_grid_row(b, at.y) * b->columns + point_grid_column(b, at.x);

    return c->fitted[cell] ? fabs(quadric_off(&c->of[cell], at)) : off_nearest(b, at);
}

/* sphere_grid - see sphere_grid.h. */
#include "math/sphere_grid.h"

#include <stdlib.h>

#include "base/array.h"

struct vec3 sphere_spiral(int k, double z)
{
    double r = sqrt(1 - z * z), turn = 2.399963229728653 * k;

    return vec(r * cos(turn), r * sin(turn), z);
}

static int ring_size(int ring)
{
    double around = 2 * PI * sin((ring + 0.5) * SPHERE_GRID_STEP) / SPHERE_GRID_STEP;

    return around > SPHERE_GRID_LEAST ? (int)round(around) : SPHERE_GRID_LEAST;
}

struct sphere_grid sphere_grid_new(struct vec3 pole)
{
    struct vec3 x = fabs(pole.z) > 0.9 ? vec(1, 0, 0) : vec(0, 0, 1);
    struct sphere_grid grid = {.x = vec_unit(vec_reject(x, pole)), .pole = pole};

    grid.y = vec_cross(pole, grid.x);
    for (int ring = 0; ring < SPHERE_GRID_RINGS; ring++)
        grid.start[ring + 1] = grid.start[ring] + ring_size(ring);
    grid.n = grid.start[SPHERE_GRID_RINGS];
    grid.at = mem_alloc((size_t)grid.n, sizeof *grid.at);
    for (int ring = 0; ring < SPHERE_GRID_RINGS; ring++) {
        int first = grid.start[ring], size = grid.start[ring + 1] - first;
        double lean = (ring + 0.5) * SPHERE_GRID_STEP;
        for (int k = 0; k < size; k++) {
            double turn = 2 * PI * k / size;
            struct vec3 side = vec_along(vec_scale(cos(turn), grid.x), sin(turn), grid.y);
            grid.at[first + k] = vec_along(vec_scale(cos(lean), pole), sin(lean), side);
        }
    }
    return grid;
}

void sphere_grid_level(struct sphere_grid *grid)
{
    const int middle = SPHERE_GRID_RINGS / 2;

    for (int i = grid->start[middle - 1]; i < grid->start[middle + 1]; i++)
        grid->at[i] = vec_unit(vec_reject(grid->at[i], grid->pole));
}

void sphere_grid_free(struct sphere_grid *grid)
{
    free(grid->at);
    grid->at = NULL;
}

void sphere_grid_corners(const struct sphere_grid *grid, struct vec3 a, int corner[4])
{
    double x = vec_dot(a, grid->x), y = vec_dot(a, grid->y), z = vec_dot(a, grid->pole);
    double lean = atan2(hypot(x, y), z), turn = atan2(y, x);
    int low = (int)floor(lean / SPHERE_GRID_STEP - 0.5);

    turn += turn < 0 ? 2 * PI : 0;
    for (int k = 0; k < 2; k++) {
        int ring = low + k < 0 ? 0 : low + k < SPHERE_GRID_RINGS ? low + k : SPHERE_GRID_RINGS - 1;
        int first = grid->start[ring], size = grid->start[ring + 1] - first;
        int at = (int)floor(turn * size / (2 * PI));
        corner[2 * k] = first + at % size;
        corner[2 * k + 1] = first + (at + 1) % size;
    }
}

/* wall_points - see wall_points.h. */
#include "cloud/wall_points.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "math/box.h"
#include "math/kdtree.h"
#include "base/parallel.h"
#include "math/plane_fit.h"

enum { NEAR = WALL_POINTS_NEAR, WIDER = 48, FEWEST = WALL_POINTS_FEWEST, WITHIN = 2 };

static const double CELL = 2;                    /* width of a cell, mean spacings */
static const double RISE = 2;                    /* of the cloud within one, by its width */
static const double STEEP = 0.25881904510252074; /* z of the normal: cos WALL_POINTS_STEEP */

/* What the cloud does in each cell of a raster. */
struct raster {
    double x, y, width;
    size_t columns, rows;
    double *low, *high;   /* z */
    unsigned char *near;  /* is a cell where the cloud rises so much, or beside one */
    unsigned char *steep; /* points on a wall in cells within WITHIN of it, FEWEST: or more */
};

/* Points to be looked at closely, and whether they lie on walls: by their neighbourhood, and in the
 * end. */
struct candidates {
    const struct raster *raster;
    const struct kdtree *tree;
    const struct vec3 *point;
    double spacing;
    bool *steep, *wall;
    struct plane_fit
        *plane; /* through the neighbourhood of each steep one; of the others nothing is
                                written, which takes no memory */
};

static size_t cell_of(const struct raster *r, struct vec3 p)
{
    return (size_t)((p.y - r->y) / r->width) * r->columns + (size_t)((p.x - r->x) / r->width);
}

/* False when there would be many more cells than points. */
static bool make_raster(const struct vec3 *point, size_t n, double spacing, struct raster *r)
{
    struct box box = box_around(point, n);

    *r = (struct raster){.x = box.low.x, .y = box.low.y, .width = CELL * spacing};
    double columns = floor((box.high.x - r->x) / r->width) + 1;
    double rows = floor((box.high.y - r->y) / r->width) + 1;
    if (!(columns * rows < 20.0 * (double)n + 1000))
        return false;
    r->columns = (size_t)columns;
    r->rows = (size_t)rows;
    r->low = mem_alloc(r->columns * r->rows, sizeof *r->low);
    r->high = mem_alloc(r->columns * r->rows, sizeof *r->high);
    r->near = mem_alloc(r->columns * r->rows, 1);
    for (size_t c = 0; c < r->columns * r->rows; c++) {
        r->low[c] = HUGE_VAL;
        r->high[c] = -HUGE_VAL;
    }
    for (size_t i = 0; i < n; i++) {
        size_t c = cell_of(r, point[i]);
        r->low[c] = point[i].z < r->low[c] ? point[i].z : r->low[c];
        r->high[c] = point[i].z > r->high[c] ? point[i].z : r->high[c];
    }
    return true;
}

/* Marks the cells that rise, and those around them for the neighbourhoods to be whole. */
static size_t mark_rises(struct raster *r)
{
    size_t marked = 0;

    for (size_t row = 0; row < r->rows; row++) {
        for (size_t column = 0; column < r->columns; column++) {
            size_t c = row * r->columns + column;
            if (!(r->high[c] - r->low[c] > RISE * r->width))
                continue;
            marked++;
            for (size_t j = row > 0 ? row - 1 : 0; j <= row + 1 && j < r->rows; j++)
                for (size_t i = column > 0 ? column - 1 : 0; i <= column + 1 && i < r->columns; i++)
                    r->near[j * r->columns + i] = 1;
        }
    }
    return marked;
}

/* z of the normal of the plane through the points, 1 where they carry none. */
static double plane_z(const struct vec3 *near, size_t n, struct plane_fit *plane)
{
    if (plane_fit(near, n, plane) < 0)
        plane->normal = vec(0, 0, 1);
    return plane->normal.z;
}

static void fit_planes(void *context, size_t from, size_t to)
{
    const struct candidates *l = context;

    for (size_t i = from; i < to; i++) {
        size_t index[NEAR];
        struct vec3 near[NEAR];
        struct plane_fit plane;
        size_t n = kdtree_nearest(l->tree, l->point[i], NEAR, index, NULL);
        for (size_t k = 0; k < n; k++)
            near[k] = l->point[index[k]];
        /* where two walls meet at a corner a plane leaves more */
        double most = fabs(plane_z(near, n, &plane)) < STEEP / 2 ? 0.75 : 0.5;
        l->steep[i] = n == NEAR && fabs(plane.normal.z) < STEEP && plane.rms < most * plane.width;
        if (l->steep[i])
            l->plane[i] = plane;
    }
}

static bool lies_on(const struct candidates *l, const struct plane_fit *plane, struct vec3 p)
{
    double off = fabs(vec_dot(vec_sub(p, plane->centre), plane->normal));

    return off < fmax(2.5 * plane->rms, 0.15 * l->spacing);
}

/* At the top and the foot of a wall a neighbourhood is half flat: there a point counts that lies
 * on the plane through the points of the wall next to it, or on those that some of these have for
 * themselves, for there may be two walls. */
static void grow_walls(void *context, size_t from, size_t to)
{
    const struct candidates *l = context;

    for (size_t i = from; i < to; i++) {
        size_t index[WIDER], walls = 0, on = 0;
        struct vec3 near[NEAR];
        struct plane_fit plane;
        l->wall[i] = l->steep[i];
        bool looked = l->wall[i] || l->raster->steep[cell_of(l->raster, l->point[i])] < FEWEST;
        size_t n = looked ? 0 : kdtree_nearest(l->tree, l->point[i], WIDER, index, NULL);
        for (size_t k = 0; k < n; k++) {
            const struct plane_fit *other = &l->plane[index[k]];
            if (!l->steep[index[k]])
                continue;
            if (k < NEAR)
                near[walls++] = l->point[index[k]];
            on += other->rms < other->width / 4 && lies_on(l, other, l->point[i]);
        }
        if (walls >= FEWEST && plane_fit(near, walls, &plane) == 0 &&
            fabs(plane.normal.z) < STEEP && plane.rms < plane.width / 2)
            l->wall[i] = lies_on(l, &plane, l->point[i]);
        l->wall[i] = l->wall[i] || on >= FEWEST;
    }
}

/* Counts the points of walls near to cells: the WIDER points nearest to those of others are as near
 * as WITHIN cells, so that too few of them are on a wall. */
static void mark_steep(struct raster *r, const struct candidates *l, size_t n)
{
    r->steep = mem_alloc(r->columns * r->rows, 1);
    for (size_t i = 0; i < n; i++) {
        size_t c = cell_of(r, l->point[i]), row = c / r->columns, column = c % r->columns;
        if (!l->steep[i])
            continue;
        for (size_t j = row > WITHIN ? row - WITHIN : 0; j <= row + WITHIN && j < r->rows; j++)
            for (size_t k = column > WITHIN ? column - WITHIN : 0;
                 k <= column + WITHIN && k < r->columns; k++)
                if (r->steep[j * r->columns + k] < FEWEST)
                    r->steep[j * r->columns + k]++;
    }
}

/* The wall points after the others; `wall` says which of those in marked cells are. */
static size_t move_walls_last(struct vec3 *point, size_t n, const struct raster *r,
                              const bool *wall)
{
    struct vec3s walls = {0};
    size_t kept = 0, looked = 0;

    for (size_t i = 0; i < n; i++) {
        bool on = r->near[cell_of(r, point[i])] && wall[looked++];
        if (on)
            *array_push(&walls) = point[i];
        else
            point[kept++] = point[i];
    }
    if (walls.n > 0)
        memcpy(point + kept, walls.item, walls.n * sizeof *point);
    array_free(&walls);
    return kept;
}

size_t wall_points_part(struct vec3 *point, size_t n, double spacing, int threads)
{
    struct raster raster;
    struct vec3s close = {0};

    if (n == 0 || !(spacing > 0) || !make_raster(point, n, spacing, &raster))
        return n;
    size_t flat = n;
    size_t rises = mark_rises(&raster);
    free(raster.low);
    free(raster.high);
    if (rises > 0) {
        for (size_t i = 0; i < n; i++)
            if (raster.near[cell_of(&raster, point[i])])
                *array_push(&close) = point[i];
        struct kdtree *tree = kdtree_new_by(close.item, close.n, threads);
        struct candidates looked = {&raster,
                                    tree,
                                    close.item,
                                    spacing,
                                    mem_alloc(close.n, sizeof(bool)),
                                    mem_alloc(close.n, sizeof(bool)),
                                    mem_alloc(close.n, sizeof(struct plane_fit))};
        parallel_for(threads, close.n, fit_planes, &looked);
        mark_steep(&raster, &looked, close.n);
        parallel_for(threads, close.n, grow_walls, &looked);
        free(raster.steep);
        flat = move_walls_last(point, n, &raster, looked.wall);
        free(looked.steep);
        free(looked.wall);
        free(looked.plane);
        kdtree_free(tree);
        array_free(&close);
    }
    free(raster.near);
    return flat;
}

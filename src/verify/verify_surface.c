/* verify_surface - the surface that the points of a scan stand for: see verify.h. */
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/believed.h"
#include "cloud/judged_scan.h"
#include "cloud/plan_extent.h"
#include "cloud/roof.h"
#include "cloud/steep_facets.h"
#include "math/point_grid.h"
#include "verify/verify.h"

/* Outliers go to `outliers`, the others stay in their order. */
static void part_outliers(struct vec3s *point, const unsigned char *out, struct vec3s *outliers)
{
    size_t kept = 0;
    for (size_t i = 0; i < point->n; i++) {
        if (out[i])
            *array_push(outliers) = point->item[i];
        else
            point->item[kept++] = point->item[i];
    }
    point->n = kept;
}

static void find_roof(const struct point_grid *grid, int threads, struct vec3s *roof)
{
    unsigned char *mark = mem_alloc(grid->n, 1);
    roof_find(grid, ROOF_JUDGE, threads, mark);
    for (size_t i = 0; i < grid->n; i++)
        if (mark[i])
            *array_push(roof) = grid->point[i];
    free(mark);
}

/* Points of steep flanks, seen as they were scanned and taken to be where the grid has them. */
static void find_steep(const struct point_grid *grid, double radius, int threads,
                       struct verify_surface *surface)
{
    struct point_grid seen = *grid;
    seen.point = surface->scanned.item;
    steep_facets_sure(&seen, grid->point, radius, surface->noise, threads, &surface->steep);
}

int verify_surface_find(struct vec3s *point, double noise, double radius, int threads,
                        struct verify_surface *surface, struct error *error)
{
    const struct believed_options options = {noise, threads};
    double rounded = believed_unround(point->item, point->n, noise, threads);
    struct believed believed;
    struct point_grid grid;
    unsigned char *out = mem_alloc(point->n, 1);
    int result = believed_find(point->item, point->n, &options, out, &believed, error);
    believed_keep_beneath(out, point->n);
    if (result == 0)
        part_outliers(point, out, &surface->outliers);
    free(out);
    if (result < 0)
        return -1;
    struct plan_extent extent = plan_extent_of(point->item, point->n, 0);
    double spacing = plan_extent_spacing(&extent, point->item, point->n);
    if (point_grid_make(point->item, point->n, spacing > 0 ? spacing : 1, threads, &grid, error) <
        0)
        return -1;
    surface->noise = believed.sigma;
    surface->rounded = rounded;
    surface->sheets = believed.sheets.places > 0 ? believed.sheets.distance : 0;
    surface->sheets_at = believed.sheets.at;
    surface->under = mem_alloc(point->n, 1);
    surface->spacing = point_grid_spacing(&grid);
    find_roof(&grid, threads, &surface->roof);
    vec3s_add(&surface->scanned, grid.point, grid.n);
    judged_scan_settle(&grid, radius, surface->noise, threads, surface->under, &surface->curtain);
    find_steep(&grid, radius, threads, surface);
    point_grid_free(&grid);
    return 0;
}

void verify_surface_unseen(const struct verify_surface *surface, double radius, int threads,
                           struct vec3s *place)
{
    struct vec3s point = {0};
    struct point_grid grid;
    struct error error;

    vec3s_add(&point, surface->scanned.item, surface->scanned.n);
    if (point_grid_make(point.item, point.n, surface->spacing, threads, &grid, &error) == 0) {
        judged_scan_unseen(&grid, radius, surface->noise, threads, place);
        point_grid_free(&grid);
    }
    array_free(&point);
}

void verify_surface_free(struct verify_surface *surface)
{
    array_free(&surface->outliers);
    array_free(&surface->roof);
    array_free(&surface->curtain);
    array_free(&surface->steep);
    array_free(&surface->scanned);
    free(surface->under);
    *surface = (struct verify_surface){0};
}

/*
 * grid_points - points of several kinds in a grid, for the tests of point_grid.
 */
#ifndef CLOUDMILL_GRID_POINTS_H
#define CLOUDMILL_GRID_POINTS_H

#include <check.h>

#include "math/point_grid.h"
#include "seed.h"

enum { N = 3000 };

static uint64_t state;
static struct vec3 point[N];
static struct point_grid point_grid;
static struct error error;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* 0 a sheet, 1 sheet and wall, 2 on a raster (many equally near), 3 a sheet and three points far
 * off, 4 a narrow band from corner to corner, 5 a sheet and very many on an upright line, 6 a sheet
 * and very many in one cell, on a raster. */
static void make_points(int kind)
{
    state = 5;
    for (int i = 0; i < N; i++) {
        double x = 60 * uniform(), y = 40 * uniform(), z = uniform();
        if (kind == 1 && i % 3 == 0)
            x = 30, z *= 40;
        if (kind == 2)
            x = floor(x), y = floor(y), z = 0;
        if (kind == 3 && i < 3)
            x = 1e7 * (i - 1), y = 3e6, z = 1e4;
        if (kind == 4)
            y = x + 0.1 * y;
        if (kind == 5 && i % 3 > 0)
            x = 30, y = 20, z = floor(300 * z) / 4;
        if (kind == 6 && i % 3 > 0)
            x = 30 + floor(x / 5) / 30, y = 20 + floor(y / 5) / 30, z = floor(10 * z) / 30;
        point[i] = vec(x, y, z);
    }
    ck_assert_int_eq(point_grid_make(point, N, 0.9, 2, &point_grid, &error), 0);
}

static void free_all(void)
{
    point_grid_free(&point_grid);
}

#endif

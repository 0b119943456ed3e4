/*
 * raster - a picture's plane in square cells: what lies nearest to the eye in each of them.
 *
 * Takes and gives projected points (view.h).
 */
#ifndef CLOUDMILL_RASTER_H
#define CLOUDMILL_RASTER_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

struct raster {
    double left, bottom, cell; /* mm */
    size_t columns, rows;
    double *depth; /* z of what is nearest, -INFINITY: the cell is empty */
    size_t *owner; /* the number that it was drawn with */
};

/* Covers [left, right] x [bottom, top], all cells empty. */
struct raster raster_new(double left, double bottom, double right, double top, double cell);
void raster_free(struct raster *raster);

/* The cell that holds (x, y): of the raster's rim when it is outside. */
size_t raster_cell(const struct raster *raster, double x, double y);

/* One point in its cell; true when the cell was empty. */
bool raster_point(struct raster *raster, struct vec3 p, size_t owner);

/* A disc that faces the eye, in all cells whose middle is inside. */
void raster_disc(struct raster *raster, struct vec3 p, double radius, size_t owner);

/* A triangle, in all cells whose middle is inside or on its edge. */
void raster_triangle(struct raster *raster, struct vec3 a, struct vec3 b, struct vec3 c,
                     size_t owner);

/* In some cell of the triangle there is what is more than `slack` nearer to the eye than it. */
bool raster_hides(const struct raster *raster, struct vec3 a, struct vec3 b, struct vec3 c,
                  double slack);

/* Nothing in the cell of p is more than `slack` nearer to the eye than p. */
bool raster_visible(const struct raster *raster, struct vec3 p, double slack);

#endif

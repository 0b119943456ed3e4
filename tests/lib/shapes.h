/*
 * shapes - meshes whose surface is known, for unit tests.
 */
#ifndef CLOUDMILL_SHAPES_H
#define CLOUDMILL_SHAPES_H

#include "mesh/mesh.h"

/* A surface over (x, y): height and unit normal there. */
typedef struct vec3 shape_point(double x, double y, struct vec3 *normal);

/* Columns by rows of square cells, each cut from its lower left to its upper right corner, over the
 * rectangle from (x0, y0) to (x1, y1); exact normals. */
struct mesh shape_grid(shape_point *at, double x0, double y0, double x1, double y1, int columns,
                       int rows);

/* The upper half of a sphere of radius 50 about the origin; a cylinder of radius 30 along x, seen
 * from above; a bicubic wave, 16 high at most. */
shape_point shape_sphere, shape_cylinder, shape_wave;

/* A cube from 0 to `size`, outside out, without normals; each face has two facets. */
struct mesh shape_cube(double size);

/* A whole sphere: parallels and meridians, poles too; exact normals. */
struct mesh shape_ball(double radius, int parallels, int meridians);

#endif

/*
 * sphere_grid - directions spread over the sphere in rings about a pole, about SPHERE_GRID_STEP
 * apart; near the poles rings have more, so that a way along a meridian stays on one.
 */
#ifndef CLOUDMILL_SPHERE_GRID_H
#define CLOUDMILL_SPHERE_GRID_H

#include "math/vec.h"

enum { SPHERE_GRID_RINGS = 30, SPHERE_GRID_LEAST = 24 };

/* Radians: half of it is how far the first ring is off the pole. */
#define SPHERE_GRID_STEP (PI / SPHERE_GRID_RINGS)

struct sphere_grid {
    struct vec3 x, y, pole;           /* an orthonormal, right-handed frame */
    int n;                            /* directions */
    int start[SPHERE_GRID_RINGS + 1]; /* of each ring among them; the last one is n */
    struct vec3 *at;                  /* unit */
};

/* The unit direction at height z that is the k-th of a spiral turning by the golden angle: with
 * heights evenly apart they are spread evenly. */
struct vec3 sphere_spiral(int k, double z);

struct sphere_grid sphere_grid_new(struct vec3 pole);

/* Moves the directions of the two rings beside the equator onto it: each is there twice. */
void sphere_grid_level(struct sphere_grid *grid);

void sphere_grid_free(struct sphere_grid *grid);

/* The directions around one: the corners of the cell it is in, two of each of two rings, or the
 * whole first or last ring's two nearest ones twice. */
void sphere_grid_corners(const struct sphere_grid *grid, struct vec3 a, int corner[4]);

#endif

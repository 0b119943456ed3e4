/*
 * known - NURBS patches whose points, normals and areas are known, for unit tests.
 */
#ifndef CLOUDMILL_KNOWN_H
#define CLOUDMILL_KNOWN_H

#include "nurbs/patch.h"

/* Corners a (u 0, v 0), b (u 1), c (v 1), d, over 0 to 1. */
struct patch known_flat(struct vec3 a, struct vec3 b, struct vec3 c, struct vec3 d);

/* A surface of revolution about z, closed in u from 0 to 4: a profile of radius, z and weight. */
struct patch known_turned(int degree, size_t n, const double *knot_v, const double (*profile)[3]);

/* About z from 0 to `height` for v from 0 to 1; a whole sphere, v from 0 to 2; a torus in the plane
 * z = 0, v from 0 to 4.  Their normals look outwards. */
struct patch known_cylinder(double radius, double height);
struct patch known_sphere(double radius);
struct patch known_torus(double radius, double pipe);

#endif

/*
 * cloudmesh_steps - what the ways from a cloud to its mesh share (cloudmesh.h).
 */
#ifndef CLOUDMILL_CLOUDMESH_STEPS_H
#define CLOUDMILL_CLOUDMESH_STEPS_H

#include "stage/cloudmesh.h"

/* The default spacing, three mean spacings of the points, mm; says so. */
double cloudmesh_default_spacing(double mean);

/* No facet came of it: the spacing, and the width and height of the points. */
#define CLOUDMESH_NO_FACET                                                                   \
    "no three neighbouring nodes of a grid of spacing %g mm have points on an area of %g x " \
    "%g mm, expected another spacing (-t) or a wider area"

/* Normals, and vertices moved where there is noise, from n points, which it sorts. */
int cloudmesh_normals(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error);

/* Noisy points moved onto the surface that they stand for; how far, mm, in *spent. */
int cloudmesh_smooth_points(const struct cloudmesh_options *options, struct vec3s *points,
                            double noise, int threads, double *spent, struct error *error);

/* The mesh by one of the ways that paper 1 reviews: options->method (cloudmesh_ways.c). */
int cloudmesh_by_way(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error);

#endif

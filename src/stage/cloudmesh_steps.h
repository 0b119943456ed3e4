/*
 * cloudmesh_steps - what the ways from a cloud to its mesh share (cloudmesh.h).
 */
#ifndef CLOUDMILL_CLOUDMESH_STEPS_H
#define CLOUDMILL_CLOUDMESH_STEPS_H

#include "stage/cloudmesh.h"

/* The cloud as wall_points_part put it in order. */
struct cloud_parts {
    double mean; /* spacing of the points, mm */
    size_t flat; /* so many of them lie on no wall */
};

/* Three mean spacings of the points, mm, to three digits: so that -t can say the same. */
double cloudmesh_three_spacings(double mean);

/* The same as the default spacing; says so. */
double cloudmesh_default_spacing(double mean);

/* No facet came of it: the spacing, and the width and height of the points. */
#define CLOUDMESH_NO_FACET                                                                   \
    "no three neighbouring nodes of a grid of spacing %g mm have points on an area of %g x " \
    "%g mm, expected another spacing (-t) or a wider area"

/* Normals, and vertices moved where there is noise, from n points, which it sorts. */
int cloudmesh_normals(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error);

/* Places of noisy points moved onto the surface that the points stand for; of very many points, the
 * surface at places of a grid in all of them.  How far, mm, in *spent.  The points are sorted. */
int cloudmesh_smooth_points(const struct cloudmesh_options *options, struct vec3s *points,
                            struct vec3s *places, double noise, int threads, double *spent,
                            struct error *error);

/* The grid's mesh of the points, without normals.  -1: as cloudmesh_make. */
int cloudmesh_place_nodes(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                          const struct vec3s *points, int threads, struct mesh *mesh,
                          struct cloudmesh *result, struct error *error);

/* Creases and walls put into a mesh that has normals; these to the side that is seen.  `sorted`:
 * the points on no wall, with their mean spacing; NULL: they get sorted. */
void cloudmesh_add_features(const struct cloudmesh_options *options,
                            const struct cloud_parts *parts, const struct vec3s *points,
                            const struct point_grid *sorted, double noise, int threads,
                            struct mesh *mesh, struct cloudmesh *result);

/* Two meshes, and what came of them, change places: always, or where the other is closer to the
 * points (squares, every so many of them). */
void cloudmesh_swap(struct mesh *other, struct cloudmesh *other_result, struct mesh *mesh,
                    struct cloudmesh *result);
void cloudmesh_keep_closer(const struct cloudmesh_options *options, const struct vec3s *points,
                           int threads, struct mesh *other, struct cloudmesh *other_result,
                           struct mesh *mesh, struct cloudmesh *result);

/* Where so much of a mesh seen from above is steep: leaves out the facets that face against the
 * points about them, for there the cloud folds under itself; how many.  *part: of the mesh's area;
 * of half of it and more none is left out. */
size_t cloudmesh_drop_turned(const struct vec3s *points, struct vec3 outside, double steep,
                             int threads, struct mesh *mesh, double *part);

/* Of a mesh that was only tried. */
void cloudmesh_drop(struct mesh *mesh, struct cloudmesh *result);

/* The mesh by a grid; result->edge is for the caller to free. */
int cloudmesh_on_grid(const struct cloudmesh_options *asked, struct vec3s *points, double noise,
                      int threads, struct mesh *mesh, struct cloudmesh *result,
                      struct error *error);

/* The mesh within an error; the same. */
int cloudmesh_within(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error);

/* The mesh by one of the ways that paper 1 reviews: options->method (cloudmesh_ways.c). */
int cloudmesh_by_way(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error);

#endif

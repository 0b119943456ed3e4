/*
 * smooth_nodes - the vertices of a mesh moved from noisy points of the scan onto the surface that
 * the scan stands for, with its normals and curvatures.
 *
 * A vertex goes to its foot on the surface that surface_fit.h has there; along ribs and grooves
 * too, unless there are too many vertices for that (EFFORT_ALONG).
 */
#ifndef CLOUDMILL_SMOOTH_NODES_H
#define CLOUDMILL_SMOOTH_NODES_H

#include "math/point_grid.h"
#include "math/surface_fit.h"
#include "mesh/mesh.h"

struct smooth_nodes {
    size_t moved;    /* vertices on a quadric now */
    size_t kept;     /* where no quadric explains the points (an edge): not moved */
    size_t thin;     /* too few points for a quadric: not moved, the facets' normal */
    size_t at;       /* the vertex that was moved farthest */
    double farthest; /* by so much, mm */
    double error;    /* one standard deviation of the moved vertices, mm, as the fits have it */
    size_t typical;  /* neighbourhood that most vertices begin with, ... */
    size_t wanted;   /* ... and would begin with, were there no EFFORT_NEIGHBOURS */
};

struct smooth_nodes_options {
    double sigma;      /* > 0: the noise, one standard deviation (noise.h), mm */
    size_t neighbours; /* so many points to begin with; 0: chosen, by a sample of the vertices and
                          then for each */
    double effort;     /* effort.h */
    int threads;       /* of which the result does not depend */
    bool first;        /* only where the first round of surface_fit.h explains the points */
};

/* The mesh gets normals and kmax. */
struct smooth_nodes smooth_nodes(struct mesh *mesh, const struct point_grid *point_grid,
                                 const struct smooth_nodes_options *options);

/* The same for a mesh part by part: how surfaces are fitted to the vertices of a mesh with so many,
 * by a sample of their places with a normal each; `r` gets what it says of that. */
struct surface_fit_options smooth_nodes_rule(const struct point_grid *point_grid,
                                             const struct smooth_nodes_options *options,
                                             size_t vertices, const struct vec3 *place,
                                             const struct vec3 *normal, size_t places,
                                             struct smooth_nodes *r);

/* ... the vertices of a part: variance[] of each that was moved, in sigma^2, negative: it was not;
 * distance[] by which, mm, negative: there was no surface; the mesh gets normals and kmax. */
void smooth_nodes_fit(struct mesh *mesh, const struct surface_fit_options *rule, int threads,
                      double *variance, double *distance);

/* ... what came of them added to `r`, the first of these n vertices being number `first`; and its
 * error, of the sum of their variances. */
void smooth_nodes_count(const double *variance, const double *distance, size_t n, size_t first,
                        struct smooth_nodes *r, double *sum);

#endif

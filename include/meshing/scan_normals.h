/*
 * scan_normals - normals and curvatures of a mesh's vertices from the whole scan that it was chosen
 * from.
 */
#ifndef CLOUDMILL_SCAN_NORMALS_H
#define CLOUDMILL_SCAN_NORMALS_H

#include "math/point_grid.h"
#include "mesh/mesh.h"

/* How far the vertices are off their quadrics. */
struct scan_normals {
    size_t fitted, thin; /* vertices with a quadric; without one, they keep the facets' normal */
    size_t at;           /* the vertex with the largest distance */
    double worst, rms;   /* of the distances, mm */
    double sigma;        /* one standard deviation of the vertices' distances, mm: from their
                            median (noise.h), so that a sharp edge, where a quadric is of no use,
                            does not count as noise */
};

struct scan_normals_options {
    int neighbours;  /* points that a surface goes through */
    int threads;     /* of which the result does not depend */
    double *certain; /* what is known already: node_heights.h; NULL: nothing.  It is changed */
};

/* What is said of the distances of vertices from their quadrics (not below 0 where there is one),
 * which are changed. */
struct scan_normals scan_normals_summary(double *distance, size_t n);

/* scan_normals_quadric without that: distance[] of each vertex, which may be options->certain. */
void scan_normals_fit(struct mesh *mesh, const struct point_grid *point_grid,
                      const struct scan_normals_options *options, double *distance);

/*
 * In a first round, the surface through the points of a ball (math/moment_fit.h): a cubic where it
 * explains them clearly better than a quadric does.  It counts where the points lie around the
 * vertex and it leaves no more of them than noise (mesh->origin.noise) or rounding does.  Else a
 * second round:
 *
 * A quadric through the `neighbours` points of the scan nearest to each vertex, or the nearer half
 * of them where these lie at least twice as close to theirs (a tight bend); where they do not
 * carry one (points on one or two laser lines), through twice, four times ... MOST_TIMES as
 * many.  Where a surface of the third degree through the points leaves less than half of what the
 * quadric leaves, it counts: without noise that is wherever the surface is smooth.
 * The normal at the vertex, on the side of the facets' normals or, where these are steep and
 * that fits better, on the upper side, goes to mesh->normal and
 * its larger principal curvature (hollow: positive) to mesh->kmax.  A vertex without a quadric
 * keeps the normal of its facets (eq 8), and 0.
 *
 * Vertices that are `certain` keep what they have.
 */
struct scan_normals scan_normals_quadric(struct mesh *mesh, const struct point_grid *point_grid,
                                         const struct scan_normals_options *options);

#endif

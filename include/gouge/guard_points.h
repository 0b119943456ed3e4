/*
 * guard_points - the surface of a part as points that are dense enough to keep a ball off it: of a
 * scan, of a mesh, of the sharp edges of a mesh.
 *
 * A ball sinks between points that are far apart, and rides on the crests of the noise of points
 * that are near.  So the points of a scan that noise spreads are moved to the surfaces of
 * surface_fit.h, one for all points in its middle; and where the scan is sparse, points are put
 * between (upsample.h).  Points that noise does not explain (edges, walls, hair) stay as they are.
 */
#ifndef CLOUDMILL_GUARD_POINTS_H
#define CLOUDMILL_GUARD_POINTS_H

#include "base/array.h"
#include "cloud/edge_points.h"
#include "math/point_grid.h"
#include "mesh/mesh.h"

struct guard_points_options {
    double radius; /* of the ball, mm */
    double sink;   /* how deep it may sink between points, mm */
    double noise;  /* standard deviation of what is taken out, mm (noise.h); 0: nothing */
    double vague;  /* mm: a surface between points that is off them by more is vague */
    double effort; /* effort.h */
    int threads;   /* as of parallel_for */
};

struct guard_points {
    struct vec3s point;
    struct vec3s certain, doubtful; /* points of the scan: does noise leave doubt of the surface? */
    size_t moved, added;            /* points moved to their surfaces, points put between */
    size_t edges;          /* points put on sharp edges that the scan has none on (edge_points.h) */
    struct edge_gaps gaps; /* edges that it does not resolve */
    size_t vague; /* of a scan without noise: points near which the surface is vague, ... */
    double worst; /* ... the most that it is off, mm, and where */
    struct vec3 at;
    bool sparse; /* the ball sinks in between points, and more of them would keep it off */
    size_t near; /* points that the surfaces would go through in all, where these are more than the
                    effort allows; else 0 */
};

/* Of a scan.  No point moves by more than FAR standard deviations.  What there are too many points
 * for: EFFORT_GUARD_BETWEEN, EFFORT_GUARD_NEAR, EFFORT_ALONG. */
struct guard_points guard_points_of_scan(const struct point_grid *point_grid,
                                         const struct guard_points_options *rule);

/*
 * Appends those of a mesh with vertex normals: each facet as the curved triangle that its vertices
 * and normals span (PN triangle, Vlachos et al. 2001, but with handles that make edges of a sphere
 * circular to the sixth order), sampled no coarser than `spacing` mm.  The flat facet would not do:
 * in a hollow it is above the surface by its sagitta.  Only a facet that is more than 30 degrees
 * off one of its vertices' normals, as at a step or an edge, is sampled flat.  Where that would be
 * more than `most` points beside the vertices, they are further apart.  Returns how far, mm.
 */
double guard_points_of_mesh(const struct mesh *mesh, double spacing, double most,
                            struct vec3s *points);

/*
 * Appends points no further than `spacing` mm apart on the convex edges of a mesh: those between
 * two facets that have vertices of their own there, at the same places, and fall off from each
 * other to both sides.  A scan seldom has points on its edges, and a ball that rolls over them
 * would sink in between the points beside.  With a scan only where its points about are on the two
 * facets: elsewhere the mesh bridges what the scan knows nothing of.
 */
void guard_points_of_edges(const struct mesh *mesh, double spacing, const struct point_grid *scan,
                           struct vec3s *points);

#endif

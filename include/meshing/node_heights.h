/*
 * node_heights - the vertices of a grid's mesh put at their nodes, at the height of the surface
 * that the scan stands for there; so that the rows of the grid are straight seen from above.
 *
 * Paper 1 moves each node to the point of the scan nearest to it (reposition.h): its rows wander by
 * up to half the spacing.  Here a vertex goes back to its node on the cubic through the NEAR points
 * about it, where that is certain: the node has points on all sides, a quadric through the FEWER
 * nearest agrees within the noise or CERTAIN of the points' spacing, and the surface is not too
 * steep to be crossed by the node's upright line.  Others keep their points: those on edges, walls,
 * ribs and at the border.
 *
 * In a first round cubic and quadric are one set of sums over a ball (math/moment_fit.h): where the
 * cubic explains its points and the quadric agrees, the vertex has its place, normal and curvature.
 * Only the others are looked at by their nearest points.
 */
#ifndef CLOUDMILL_NODE_HEIGHTS_H
#define CLOUDMILL_NODE_HEIGHTS_H

#include "math/point_grid.h"
#include "mesh/mesh.h"
#include "meshing/grid.h"

struct node_heights_options {
    double spacing; /* mean spacing of the points, mm */
    double noise;   /* their standard deviation, mm */
    int threads;    /* as of parallel_for */
};

/* Moves the vertices, whose rows and columns are those of the grid; returns how many stand at their
 * nodes.  certain[] (NULL: not asked for) gets one standard deviation of the place, mm, of those
 * vertices that the first round has also given their normal and kmax; -1 of the others, whose
 * normals are the facets'. */
size_t node_heights(struct mesh *mesh, const struct grid *grid, const struct point_grid *scan,
                    const struct node_heights_options *options, double *certain);

#endif

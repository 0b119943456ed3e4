/*
 * scan_edges - all edges of a scan that no point of it is on (edge_points.h), as its noise and the
 * rounding of its heights let them be found.
 *
 * Where noise is known by the sides of edges these are looked for in the points as they are, for
 * blunt ones are told by that alone; and by the noise, which makes sides certain, those that two
 * sides meet in: not what goes on unseen, which rough parts have much of, unless there are walls
 * nearly everywhere.  Where noise is faint both are asked, too: it hides blunt edges, and what no
 * point resolves, though sides tell of them.  Lengths in mm.
 */
#ifndef CLOUDMILL_SCAN_EDGES_H
#define CLOUDMILL_SCAN_EDGES_H

#include "base/array.h"
#include "cloud/edge_points.h"

struct scan_edges_options {
    const struct point_grid *scan; /* without outliers */
    double radius;                 /* of the ball */
    double sink;                   /* how deep it may sink between places on an edge */
    double noise;                  /* standard deviation of the points; 0: none */
    double rough; /* what smooth surfaces leave, where it cannot be told from noise; else 0 */
    bool edged;   /* the noise is known by the sides of edges */
    bool fill;    /* places on the flanks, too, up to their edges */
    int threads;  /* as of parallel_for */
    const struct near_lists *near; /* of the scan's points, or NULL */
};

struct scan_edges {
    struct vec3s point; /* places on the flanks and walls that go on, then those on edges */
    size_t edges;       /* how many are on edges */
    struct edge_gaps gaps;
};

/* The caller frees `point`. */
struct scan_edges scan_edges_find(const struct scan_edges_options *options);

#endif

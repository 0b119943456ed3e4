/*
 * crest - what the surface does over one edge of a mesh: the ridge or the groove that it crosses.
 *
 * A rounded rib is no crease, but where it is narrow against the edges of a mesh these cut off its
 * top.  The surface over the edge is followed in steps of half the spacing of the points; its
 * highest or lowest place against the plane of the neighbourhood is the crest, and it is looked at
 * again with a neighbourhood that is long the way the rib runs (neighbourhood_along.h).
 */
#ifndef CLOUDMILL_CREST_H
#define CLOUDMILL_CREST_H

#include "feature.h"

enum { CREST_MOST = 7 };

/* Points of the surface over an edge, from its first end to its second. */
struct crest {
    int n;                   /* 0: straight, or nothing that bends one way only */
    int top;                 /* which of them is on the crest, -1: none is */
    double part[CREST_MOST]; /* of the way, seen from above */
    struct vec3 place[CREST_MOST], normal[CREST_MOST];
    double kmax[CREST_MOST]; /* the larger principal curvature, as in quadric.h */
};

/* The surface bends over the edge from a to b by more than 4 % of its length, at a crest; beside it
 * or without one by more than 8 %, or 0.4 mean spacings.  Where it bends nearly as much along as
 * across, or has a radius of more than twice the edge, it is no rib. */
struct crest crest_find(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b);

#endif

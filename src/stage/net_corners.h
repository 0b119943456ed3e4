/*
 * net_corners - heights and slopes of a scan at the corners of a net (cloud_surface.h).
 */
#ifndef CLOUDMILL_NET_CORNERS_H
#define CLOUDMILL_NET_CORNERS_H

#include "math/kdtree.h"
#include "nurbs/net_patches.h"

struct net_corners {
    const struct vec3 *point;
    struct kdtree *tree; /* of the points seen from above */
    double mean;         /* spacing, mm */
    size_t neighbours;
};

/* Of n points, seen along z; noisy ones (mm) take more of them. */
struct net_corners net_corners_new(const struct vec3 *point, size_t n, double mean, double noise);
void net_corners_free(struct net_corners *corners);

/* Fills z, zx and zy of all nodes: from a surface of the third, or else the second, degree through
 * the points about it; where there are none within two spacings, on from the nodes beside it. */
void net_corners_find(const struct net_corners *corners, struct net_patches *net, int threads);

#endif

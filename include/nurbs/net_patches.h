/*
 * net_patches - bicubic patches between the nodes of a rectangular net: from what is known at their
 * corners.
 *
 * Over the places x, y of the plan a patch is fixed by height, two slopes and twist (z_xy) at each
 * corner; neighbours share them, so that their tangent planes agree everywhere.  Two ways to these:
 *
 *   Ferguson   slopes as they are measured at the corners, no twist (Lee, Chen, Lin 1990; paper 1,
 *              fig. 3)
 *   Bezier     two families of curves through the nodes, along the columns and the rows, that cross
 *              there: cubic splines, each span a Bezier curve, which give the slopes; the patches
 *              between four of them get the twist that the borders of the four about a node have
 *              (Kawabe, Kimura, Sata 1980; paper 1, fig. 4; Adini's twist: Farin, Curves and
 *              Surfaces, 15.3)
 */
#ifndef CLOUDMILL_NET_PATCHES_H
#define CLOUDMILL_NET_PATCHES_H

#include "nurbs/nurbs.h"

/* Node (i, j) is [j * columns + i]; 2 columns and rows at least. */
struct net_patches {
    size_t columns, rows;
    double x, y, dx, dy; /* of node (0, 0); from node to node, mm */
    double *z, *zx, *zy, *zxy;
};

struct net_patches net_patches_new(size_t columns, size_t rows);
void net_patches_free(struct net_patches *net);

/* Zero twist: heights and slopes are given. */
void net_patches_ferguson(struct net_patches *net);

/* Slopes and twist from the heights. */
void net_patches_bezier(struct net_patches *net);

/* The patches as one surface over the parameters x and y with double knots along their borders,
 * which has two poles for each node in each direction. */
struct nurbs net_patches_surface(const struct net_patches *net);

#endif

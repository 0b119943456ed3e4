/*
 * kdtree_parts - what the tree of kdtree.h is made of, for the searches that go through it.
 *
 * The tree is balanced and lies in the order of its points: the node of the range [from, to) is the
 * point in its middle; what stands before it is not above it along the node's axis, what stands
 * after it is not below.  So the tree needs no pointers: only the points in that order, where each
 * came from, the axis of each node, and the box around each node's points.  Ranges of up to KD_LEAF
 * points have no nodes under them.
 */
#ifndef CLOUDMILL_KDTREE_PARTS_H
#define CLOUDMILL_KDTREE_PARTS_H

#include <stddef.h>

#include "math/elementary.h"

enum { KD_LEAF = 12 };

struct kd_point {
    double c[3];
    size_t index; /* in the array that the tree was made from */
};

/* Around the points of a node. */
struct kd_box {
    double low[3], high[3];
};

struct kdtree {
    size_t n;
    struct kd_point *point;
    unsigned char *axis; /* of the node whose point stands here */
    struct kd_box *box;  /* the root's is number 1, those under number i are 2 i and 2 i + 1 */
};

/* How far the range from `first` to `last` is from a box along one axis, mm; 0 where they meet. */
static inline double kd_gap(const struct kd_box *box, int axis, double first, double last)
{
    double under = box->low[axis] - last, over = first - box->high[axis];
    double gap = under > over ? under : over;

    return 0.5 * (gap + fabs(gap)); /* without a jump that no one foretells */
}

/* How far a place is from a box, squared, mm^2; 0 inside. */
static inline double kd_gap2(const struct kd_box *box, const double at[3])
{
    double x = kd_gap(box, 0, at[0], at[0]), y = kd_gap(box, 1, at[1], at[1]);
    double z = kd_gap(box, 2, at[2], at[2]);

    return x * x + y * y + z * z;
}

static inline double kd_distance2(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

    return x * x + y * y + z * z;
}

static inline double square(double x)
{
    return x * x;
}

#endif

/*
 * kdtree - nearest neighbours and neighbourhoods among points in space.
 *
 * The tree holds its own copy of the points, in an order of its own; what it returns are indices
 * into the array it was made from.  Ties are broken by the smaller index, so that the answer does
 * not depend on the shape of the tree.
 */
#ifndef CLOUDMILL_KDTREE_H
#define CLOUDMILL_KDTREE_H

#include <stdbool.h>

#include "base/array.h"
#include "math/vec.h"

struct kdtree;

struct kdtree *kdtree_new(const struct vec3 *point, size_t n);

/* The same tree, made by several threads (as in parallel.h). */
struct kdtree *kdtree_new_by(const struct vec3 *point, size_t n, int threads);

void kdtree_free(struct kdtree *tree);

/* How many points it holds. */
size_t kdtree_points(const struct kdtree *tree);

/* The k nearest points to q, nearest first (fewer when there are fewer): index[], and their
 * squared distances when `distance2` is not NULL.  Returns how many. */
size_t kdtree_nearest(const struct kdtree *tree, struct vec3 q, size_t k, size_t *index,
                      double *distance2);

/* Appends the indices of all points within `radius` of q (<=), in no particular but repeatable
 * order.  The caller empties `found` (found->n = 0). */
void kdtree_within(const struct kdtree *tree, struct vec3 q, double radius, struct sizes *found);

/*
 * The distance of the segment from a to b (which may be one place) to the nearest point, and that
 * point in *index; if none is as near as `within`, `within` itself, and *index stays as it was.
 */
double kdtree_nearest_segment(const struct kdtree *tree, struct vec3 a, struct vec3 b,
                              double within, size_t *index);

/* The same of a place p, with the point itself: it stays as it was if none is as near. */
double kdtree_nearest_place(const struct kdtree *tree, struct vec3 p, double within,
                            struct vec3 *place);

/* The same distance for n points without a tree, digit by digit. */
double kdtree_nearest_among(const struct vec3 *point, size_t n, struct vec3 a, struct vec3 b,
                            double within);

/* Appends all points no farther than `within` from the segment from a to b. */
void kdtree_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within,
                   struct vec3s *found);

/* True if a point is nearer than `within` to the segment from a to b.  Ends at the first. */
bool kdtree_any_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within);

/* Points of a tree that a body touched. */
struct kdtree_touch {
    size_t n;
    struct vec3 p[2];
};

/* The same where many segments are asked about.  `touch`: points of the tree that are likely so
 * near, to be tried first (NULL: none); afterwards the one that was, if one is. */
bool kdtree_find_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within,
                        struct kdtree_touch *touch);

/* A value of each place. */
struct kdtree_field {
    /* At p, where it is lower than `below`; else anything that is not. */
    double (*value)(const void *context, struct vec3 p, double below);
    /* It is no lower anywhere in the box about `middle` that reaches `half` along each axis; what
     * is above `below` may be any such value. */
    double (*bound)(const void *context, struct vec3 middle, struct vec3 half, double below);
    const void *context;
};

/* The lowest value at a point, if that is below `below`; else `below`.  `touch`: points of the tree
 * that are likely the lowest, to be tried first (NULL: none); afterwards the one that is, if one
 * is below. */
double kdtree_lowest(const struct kdtree *tree, const struct kdtree_field *field, double below,
                     struct kdtree_touch *touch);

/* True if it is lower than `below` at any point.  Ends at the first.  `touch` (NULL: none): as of
 * kdtree_find_beside. */
bool kdtree_any_lower(const struct kdtree *tree, const struct kdtree_field *field, double below,
                      struct kdtree_touch *touch);

/*
 * Shows points and their indices to `point`, those of nearer boxes first, and leaves out the boxes
 * of points, from `middle` no further than `half` along each axis, that `box` says no to.  `depth`:
 * how many boxes this one or the point is in; all of these `box` has said yes to, the outer ones
 * first.
 */
enum { KDTREE_DEPTH = 32 };

struct kdtree_visitor {
    bool (*box)(void *context, int depth, struct vec3 middle, struct vec3 half);
    void (*point)(void *context, int depth, struct vec3 p, size_t index);
    void *context;
};

void kdtree_visit(const struct kdtree *tree, struct vec3 from,
                  const struct kdtree_visitor *visitor);

/*
 * The smallest h >= 0 that brings a ball of this radius with its centre at c + h * up (a unit
 * vector) clear of all points, up to SLACK; if that is above `limit`, something above it.  `touch`:
 * points of the tree that are likely in its way, to be tried first (NULL: none); afterwards the one
 * that the ball left last, if it left any.
 */
double kdtree_leave(const struct kdtree *tree, struct vec3 c, struct vec3 up, double radius,
                    double limit, struct kdtree_touch *touch);

/* The same of these points alone. */
double kdtree_leave_these(const struct kdtree_touch *these, struct vec3 c, struct vec3 up,
                          double radius);

/* The smallest h >= 0 from which on the ball is clear of all points, however far it goes. */
double kdtree_rise(const struct kdtree *tree, struct vec3 c, struct vec3 up, double radius);

/* True if a point is higher in z than c and nearer than `radius` to the upright line through it. */
bool kdtree_any_above(const struct kdtree *tree, struct vec3 c, double radius);

#endif

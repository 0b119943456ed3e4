/*
 * segment_tree - which segment of the ball's way is nearest to a point?
 *
 * Boxes around runs of segments, in the order of the way, halved again and again: a pass is one
 * long box, passes beside each other lie in one larger.
 */
#ifndef CLOUDMILL_SEGMENT_TREE_H
#define CLOUDMILL_SEGMENT_TREE_H

#include "simulate/centre_path.h"

struct segment_tree;

/* Keeps a pointer to the path. */
struct segment_tree *segment_tree_new(const struct centre_path *path);
void segment_tree_free(struct segment_tree *tree);

/*
 * The distance of p to the nearest segment and, when it is below `within`, that segment in
 * *nearest; else `within` itself.  *nearest on entry: a segment that may be near, to begin with.
 */
double segment_tree_nearest(const struct segment_tree *tree, struct vec3 p, double within,
                            size_t *nearest);

/*
 * Is p among places where the ball touches the part, or beside them?  Seen along the unit vector n,
 * the places within `reach` of p lie around it with no gap of 3/8 of a turn or more.
 */
bool segment_tree_surrounds(const struct segment_tree *tree, struct vec3 p, struct vec3 n,
                            double reach);

/* The point of a segment that is nearest to p. */
struct vec3 centre_segment_nearest(const struct centre_segment *segment, struct vec3 p);

#endif

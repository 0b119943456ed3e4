/*
 * balltree - which segment of the ball's way is nearest to a point?
 *
 * Boxes around runs of segments, in the order of the way, halved again and again: a pass is one
 * long box, passes beside each other lie in one larger.
 */
#ifndef CLOUDMILL_BALLTREE_H
#define CLOUDMILL_BALLTREE_H

#include "simulate/ballpath.h"

struct balltree;

/* Keeps a pointer to the path. */
struct balltree *balltree_new(const struct ball_path *path);
void balltree_free(struct balltree *tree);

/*
 * The distance of p to the nearest segment and, when it is below `within`, that segment in
 * *nearest; else `within` itself.  *nearest on entry: a segment that may be near, to begin with.
 */
double balltree_nearest(const struct balltree *tree, struct vec3 p, double within, size_t *nearest);

/*
 * Is p among places where the ball touches the part, or beside them?  Seen along the unit vector n,
 * the places within `reach` of p lie around it with no gap of 3/8 of a turn or more.
 */
bool balltree_surrounds(const struct balltree *tree, struct vec3 p, struct vec3 n, double reach);

/* The point of a segment that is nearest to p. */
struct vec3 ball_segment_nearest(const struct ball_segment *segment, struct vec3 p);

#endif

/*
 * path_arc - the arcs of a path stream: CIRCLE, then the GOTO at its end.
 */
#ifndef CLOUDMILL_PATH_ARC_H
#define CLOUDMILL_PATH_ARC_H

#include "path_parse.h"

/*
 * The row of CIRCLE/centre, axis[, radius]: without its radius the position now says it.  With
 * eleven numbers, of NX and MAKINO-FF, the arc runs clockwise about its axis, and TIMES,n are turns
 * of a helix.
 */
int path_read_circle(struct path_parse *p);

/* The arc that was said, to its end; -1 where its ends are off its circle. */
int path_arc_to(struct path_parse *p, struct pose to);

#endif

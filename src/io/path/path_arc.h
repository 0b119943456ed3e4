/*
 * path_arc - the arcs of a path stream: CIRCLE, then the GOTO at its end.
 */
#ifndef CLOUDMILL_PATH_ARC_H
#define CLOUDMILL_PATH_ARC_H

#include "path_parse.h"

/*
 * The row of CIRCLE/centre, axis[, radius]: without its radius the position now says it.  With
 * eleven numbers, of NX and MAKINO-FF, the arc runs clockwise about its axis, and TIMES,n says that
 * a helix comes to its end in its n-th turn.
 */
int path_read_circle(struct path_parse *p);

/* The arc that was said, to its end; -1 where its ends are off its circle. */
int path_arc_to(struct path_parse *p, struct pose to);

/*
 * Creo lists points of an arc behind its CIRCLE, without a word from the second on (PTC, CL Output
 * for Circular Interpolation): true where this one lies further on the arc that has just ended,
 * which is then open again.
 */
bool path_arc_goes_on(struct path_parse *p, struct vec3 point);

#endif

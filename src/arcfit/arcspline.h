/*
 * arcspline - arcs joined with common tangents, told by their joints.
 *
 * The joints and the tangent at the start say all: the tangent at the end of an arc is the one at
 * its start, mirrored in the arc's chord.  So a joint that moves turns every arc behind it.
 */
#ifndef CLOUDMILL_ARCSPLINE_H
#define CLOUDMILL_ARCSPLINE_H

#include "arcfit/arcfit.h"

struct arcspline {
    size_t n; /* arcs */
    struct joint {
        struct vec3 p, tangent, axis; /* the tool axis there; both unit */
        double place;                 /* on the trace, nearest to p */
        double side; /* mm that the axis takes the other end of the lever sideways, off the trace */
    } * joint;       /* n + 1 */
};

struct arcspline arcspline_new(size_t arcs);
void arcspline_free(struct arcspline *chain);
void arcspline_copy(struct arcspline *to, const struct arcspline *from); /* equally many arcs */

/* Sets the tangents behind joint `from` by the joints and the tangent there. */
void arcspline_turn(struct arcspline *chain, size_t from);

/* Sets place and axis of a joint by its p and side: the axis is the trace's there, turned by side.
 */
void arcspline_lean(struct arcspline *chain, const struct trace *trace, size_t joint);

/* Arc number i, between joints i and i + 1. */
struct arc arcspline_arc(const struct arcspline *chain, size_t i);

/* Appends the chain as pieces of the motion. */
void arcspline_pieces(const struct arcspline *chain, const struct trace *trace,
                      struct pieces *pieces);

#endif

/*
 * arcchain - arcs joined with common tangents, told by their joints.
 *
 * The joints and the tangent at the start say all: the tangent at the end of an arc is the one at
 * its start, mirrored in the arc's chord.  So a joint that moves turns every arc behind it.
 */
#ifndef CLOUDMILL_ARCCHAIN_H
#define CLOUDMILL_ARCCHAIN_H

#include "arcfit/arcfit.h"

struct arcchain {
    size_t n; /* arcs */
    struct joint {
        struct vec3 p, tangent, axis; /* the tool axis there; both unit */
        double place;                 /* on the trace, nearest to p */
        double side; /* mm that the axis takes the other end of the lever sideways, off the trace */
    } * joint;       /* n + 1 */
};

struct arcchain arcchain_new(size_t arcs);
void arcchain_free(struct arcchain *chain);
void arcchain_copy(struct arcchain *to, const struct arcchain *from); /* equally many arcs */

/* Sets the tangents behind joint `from` by the joints and the tangent there. */
void arcchain_turn(struct arcchain *chain, size_t from);

/* Sets place and axis of a joint by its p and side: the axis is the trace's there, turned by side.
 */
void arcchain_lean(struct arcchain *chain, const struct trace *trace, size_t joint);

/* Arc number i, between joints i and i + 1. */
struct arc arcchain_arc(const struct arcchain *chain, size_t i);

/* Appends the chain as pieces of the motion. */
void arcchain_pieces(const struct arcchain *chain, const struct trace *trace,
                     struct pieces *pieces);

#endif

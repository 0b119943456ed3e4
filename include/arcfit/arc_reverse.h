/*
 * arc_reverse - a trace followed from its end: a search for arcs that goes from joint to joint
 * finds others that way, and sometimes fewer.
 */
#ifndef CLOUDMILL_ARC_REVERSE_H
#define CLOUDMILL_ARC_REVERSE_H

#include "arcfit/arcfit.h"

/* The trace from its last point to its first; the caller frees it (trace_free). */
struct trace arc_reverse_trace(const struct trace *trace);

/* Turns round the pieces of a trace of `points` points that was turned round. */
void arc_reverse_pieces(struct pieces *pieces, size_t points);

#endif

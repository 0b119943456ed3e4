/*
 * arc_pole - arcs that lead through the pole of Z, where a rotary axis about Z has no turn of its
 * own: it passes there without turning if the tool axis leans in one vertical plane on both sides.
 */
#ifndef CLOUDMILL_ARC_POLE_H
#define CLOUDMILL_ARC_POLE_H

#include "arcfit/arc_piece.h"
#include "curve/run.h"

/* At point i of the run, neither its first nor its last, the axis goes through the pole of Z. */
bool arc_pole_at(const struct run *run, size_t i);

/* The horizontal direction, unit, that the axis leans along before point i, at which it is at the
 * pole, and against after it.  Zero: it turns there, too. */
struct vec3 arc_pole_plane(const struct run *run, size_t i);

/* The axis turned about Z into the vertical plane of a horizontal direction. */
struct vec3 arc_pole_into(struct vec3 axis, struct vec3 plane);

/* The first of two pieces or more (`end`: the last) leaves the pole (comes to it) in the plane: its
 * joint with its neighbour gets the axis there that is turned into it. */
void arc_pole_turn(struct pieces *pieces, bool end, struct vec3 plane);

/*
 * The same for a joint that is put onto that piece at s, 0 to 1, from the pole, where the axis of
 * the reference leans less; the rest of the piece goes on to the axis that it had.
 */
void arc_pole_divide(const struct reference *reference, struct pieces *pieces, bool end, double s,
                     struct vec3 plane);

#endif

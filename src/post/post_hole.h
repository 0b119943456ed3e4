/*
 * post_hole - holes that stay drilling cycles of the control: what every dialect needs to know of
 * them.  How a cycle is said stands in the dialect's file.
 */
#ifndef CLOUDMILL_POST_HOLE_H
#define CLOUDMILL_POST_HOLE_H

#include "dialect.h"

/* Heights along Z: bottom, where the feed begins, where the tool leaves. */
double nc_hole_bottom(const struct nc_hole *hole);
double nc_hole_clear(const struct nc_hole *hole);
double nc_hole_level(const struct nc_hole *hole);

/* The tool comes out at feed, to where it began. */
bool nc_hole_slow(const struct nc_hole *hole);

/* It has steps: the first and each that follows. */
bool nc_hole_steps(const struct nc_hole *hole);

/* Some cycle has steps of two sizes, or steps and a dwell. */
bool nc_hole_steps_differ(const struct path *path);

/* The hole that a move is. */
const struct nc_hole *nc_hole_of(const struct nc_program *p, const struct nc_move *move);

/*
 * The cycle that is on serves for this hole too: the same one, from the same height, and nothing
 * in between.  What the dialect says for each hole is then its place alone.
 */
bool nc_hole_goes_on(const struct nc_program *p, const struct nc_move *move);

/* Of a tap, mm a turn (or inches). */
double nc_hole_pitch(const struct nc_program *p, const struct nc_hole *hole);

/* X Y of the mouth, both: a place makes a hole, the same as well. */
void nc_hole_place(struct nc_program *p, const struct nc_hole *hole);

/* Remembers that the cycle is on and that the tool is where it leaves this hole. */
void nc_hole_done(struct nc_program *p, const struct nc_move *move);

#endif

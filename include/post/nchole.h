/*
 * nchole - holes that stay drilling cycles of the control: where the tool comes from, and what the
 * control is told.
 */
#ifndef CLOUDMILL_NCHOLE_H
#define CLOUDMILL_NCHOLE_H

#include "post/dialect.h"
#include "post/ncstep.h"

/* A hole of the path: at rapid above its mouth where it does not follow on one just like it, then
 * the cycle. */
int nc_hole(struct nc_step *step, const struct path_item *item);

/* The hole that a move is. */
const struct nc_hole *nc_hole_of(const struct nc_program *p, const struct nc_move *move);

/*
 * The cycle that is on serves for this hole too: the same one, from the same height, and nothing
 * in between.  What the dialect says for each hole is then its place alone.
 */
bool nc_hole_goes_on(const struct nc_program *p, const struct nc_move *move);

/* Some cycle has steps of two sizes, or steps and a dwell. */
bool nc_hole_steps_differ(const struct path *path);

/* Heights along Z: bottom, where the feed begins, where the tool leaves. */
double nc_hole_bottom(const struct nc_hole *hole);
double nc_hole_clear(const struct nc_hole *hole);
double nc_hole_level(const struct nc_hole *hole);

/* Of a tap, mm a turn (or inches). */
double nc_hole_pitch(const struct nc_program *p, const struct nc_hole *hole);

/* X Y of the mouth, both: a place makes a hole, the same as well. */
void nc_hole_place(struct nc_program *p, const struct nc_hole *hole);

/* Remembers that the cycle is on and that the tool is where it leaves this hole. */
void nc_hole_done(struct nc_program *p, const struct nc_move *move);

/* The tool comes out at feed, to where it began. */
bool nc_hole_slow(const struct nc_hole *hole);

/* It has steps: the first and each that follows. */
bool nc_hole_steps(const struct nc_hole *hole);

/*
 * The cycle and its place, or its place alone where it goes on; and the end of the cycle.  Fanuc
 * and LinuxCNC: G81 and its like, G80; `seconds`: dwells are seconds, else milliseconds.  Siemens:
 * MCALL CYCLE81 and its like, MCALL.  Heidenhain: CYCL DEF 200 and its like, a call by M99 at each
 * place.
 */
void nc_hole_g(struct nc_program *p, const struct nc_move *move, bool seconds);
void nc_hole_g_end(struct nc_program *p);
void nc_hole_siemens(struct nc_program *p, const struct nc_move *move);
void nc_hole_siemens_end(struct nc_program *p);
void nc_hole_heidenhain(struct nc_program *p, const struct nc_move *move);
void nc_hole_heidenhain_end(struct nc_program *p);

#endif

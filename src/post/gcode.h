/*
 * gcode - the G-code that controls share: blocks of ISO 6983, and the whole of a program as Fanuc,
 * and what is like it, has it.
 *
 * A control of that kind is a `struct gcode` with its own words and a dialect made of the functions
 * below, in place of those that it does otherwise (fanuc.c, linuxcnc.c).
 */
#ifndef CLOUDMILL_GCODE_H
#define CLOUDMILL_GCODE_H

#include "dialect.h"

/* The words that one control has and another has not. */
struct gcode {
    bool dwell_seconds; /* P of a drilling cycle is seconds, and G86 wants it; else
                                          milliseconds */
    bool level_at_feed; /* what leaves a hole at feed (G84, G85) goes on so up to the
                                          level of G98: a rapid of its own goes there instead */
};

/* Functions of a dialect that has a `struct gcode`. */
void gcode_line(struct nc_program *p, const struct nc_move *move);
void gcode_arc(struct nc_program *p, const struct nc_move *move);
void gcode_hole(struct nc_program *p, const struct nc_move *move);
void gcode_hole_end(struct nc_program *p);

/* ---- single blocks, for any control that has G-code */

/* G0 or G1 (in inverse time where the plan's feeds are); `address`: of a tool vector. */
void gcode_straight(struct nc_program *p, const struct nc_move *move, const char *const address[3]);

#endif

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
    const char *modal_mm, *modal_inch; /* the modal words at the start */
    const char *safe;                  /* what may still be on is switched off; "": nothing */
    bool length_moves;                 /* G49 alone may move Z, by a parameter */
    const char *home;                  /* the tool to a safe height */
    const char *end;                   /* of the program: M30 */
    const char *dwell;                 /* address of the seconds of G4 */
    bool dwell_seconds;                /* P of a drilling cycle is seconds, and G86 wants it; else
                                          milliseconds */
    bool level_at_feed;                /* what leaves a hole at feed (G84, G85) goes on so up to the
                                          level of G98: a rapid of its own goes there instead */
    bool tool_at_hand;                 /* G43 without H is the length of the tool in the spindle */
    /* Blocks where the machine file has none of its own (template.h); NULL: there is no such word.
     */
    const char *tcp_rotary, *tcp_vectors; /* tool-centre-point control on */
    const char *plane_on, *plane_off;
    const char *smooth_on, *smooth_off;
    void (*name)(struct nc_program *p);  /* number or name of the program, after % */
    void (*modes)(struct nc_program *p); /* more modes at the start; NULL: none */
};

/* Functions of a dialect that has a `struct gcode`. */
void gcode_start(struct nc_program *p);
void gcode_load(struct nc_program *p);
void gcode_engage(struct nc_program *p);
void gcode_line(struct nc_program *p, const struct nc_move *move);
void gcode_arc(struct nc_program *p, const struct nc_move *move);
void gcode_hole(struct nc_program *p, const struct nc_move *move);
void gcode_hole_end(struct nc_program *p);
void gcode_dwell(struct nc_program *p, double seconds);
void gcode_disengage(struct nc_program *p);
void gcode_finish(struct nc_program *p);

/* ---- single blocks, for any control that has G-code */

/* G0 or G1 (in inverse time where the plan's feeds are); `address`: of a tool vector. */
void gcode_straight(struct nc_program *p, const struct nc_move *move, const char *const address[3]);

/* G94, where feeds were inverse time. */
void gcode_minutes(struct nc_program *p);

/* G40, where the radius compensation is on. */
void gcode_cutcom_off(struct nc_program *p);

/* G0 with the rotary axes at zero; none without such axes. */
void gcode_rotary_home(struct nc_program *p);

#endif

/*
 * ncread_hole - drilling cycles of a program as the moves that the control makes of them (the
 * makers' manuals: Fanuc B-64484EN, LinuxCNC G-Codes, Siemens Programming Guide Cycles, Heidenhain
 * TNC 640 Cycle Programming).
 *
 * Over the hole at rapid as high as the tool is, down to the clear height at rapid, to the bottom
 * at feed, out.  Steps are not moves of their own: they stay on that line, and only their
 * dwells count; a dwell in turns of the spindle does not.
 */
#ifndef CLOUDMILL_NCREAD_HOLE_H
#define CLOUDMILL_NCREAD_HOLE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

struct ncread;
struct ncread_place;

enum { NCREAD_Q = 400 }; /* Q parameters of Klartext, by their number */

struct ncread_hole {
    bool on;                     /* each place is a hole */
    bool slow;                   /* out at feed */
    bool high;                   /* G98: back to where the tool was before the first hole */
    double bottom, clear, level; /* heights */
    double r, z;                 /* the words as they stand, which count ... */
    bool by;                     /* ... from the level and from R (G91) */
    double feed, back;           /* down, and out where that is slow; 0: the feed that is on */
    double dwell;                /* at one hole, seconds */
    bool waits;                  /* a P of this G word is its dwell ... */
    double pause;                /* ... that long */
    int cycle;                   /* number of a CYCL DEF, 0: none of these */
    double q[NCREAD_Q];
    size_t lines; /* of definitions that went on, so far */
};

/*
 * The block is a dwell, G4: X, F or P say how long, in seconds, P in `unit` of them; the motion
 * counts it.
 */
bool ncread_hole_dwell(struct ncread *c, double unit);

/* G73 to G89, G98, G99: true when the code (in tenths) is one. */
bool ncread_hole_code(struct ncread *c, int code);

/*
 * A block with a place under such a cycle: Z, R and P, where they stand in it, last; P in `unit`
 * seconds.
 */
int ncread_hole_block(struct ncread *c, struct ncread_place *to, double unit, struct error *error);

/* MCALL CYCLE81(...) and its like: the call's name; its arguments are in the text of the line. */
int ncread_hole_call(struct ncread *c, const char *name, struct error *error);

/* CYCL DEF number, its Q parameters on lines of their own, M99 at a place. */
void ncread_hole_define(struct ncread *c, const char *number);
int ncread_hole_parameter(struct ncread *c, const char *line, struct error *error);
int ncread_hole_m99(struct ncread *c, const struct ncread_place *to, struct error *error);

/* The hole at X Y of this place. */
int ncread_hole_down(struct ncread *c, const struct ncread_place *at, struct error *error);

#endif

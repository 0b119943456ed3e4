/*
 * ncwords - the words of a block that every control has: place, tool axis, feed.
 */
#ifndef CLOUDMILL_NCWORDS_H
#define CLOUDMILL_NCWORDS_H

#include "post/dialect.h"

/* The first motion with the tool in the spindle. */
const struct nc_move *nc_first_move(const struct nc_program *p);

/* X Y Z, those that change. */
void nc_place(struct nc_program *p, struct vec3 to);

/* The rotary words at q (radians), those that change; the address is the axis's letter. */
void nc_rotary(struct nc_program *p, const double q[]);

/* The tool to a safe height, by the machine's template or the control's own. */
void nc_home(struct nc_program *p, const char *usual);

/* Feeds are again along the way: G94, where they were inverse time. */
void nc_minutes(struct nc_program *p);

/* A block that takes the rotary axes to zero at the rapid; none without such axes. */
void nc_rotary_home(struct nc_program *p);

/* The tool axis as the program has it: rotary words, or a vector with these three addresses, all
 * of it or nothing. */
void nc_axis(struct nc_program *p, const struct nc_move *move, const char *const address[3]);

/* F, when it changes; inverse-time feeds always. */
void nc_feed(struct nc_program *p, const struct nc_move *move);

/* G17 G18 G19 where it changes, G2 or G3, place, tool axis and centre (I J K from the start) or R
 * of an arc; the block is not ended. */
void nc_plane_arc(struct nc_program *p, const struct nc_move *move, const char *const address[3]);

/* The work offset: the machine's or, where it says none, this one. */
void nc_offset(struct nc_program *p, const char *usual);

/* G40, where the radius compensation is on. */
void nc_cutcom_off(struct nc_program *p);

/* A whole straight block, G0 or G1 (in inverse time where the machine has no TCP). */
void nc_straight(struct nc_program *p, const struct nc_move *move, const char *const address[3]);

#endif

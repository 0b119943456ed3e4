/*
 * post_words - the words of a block that every control has: place, tool axis, feed.
 */
#ifndef CLOUDMILL_POST_WORDS_H
#define CLOUDMILL_POST_WORDS_H

#include "dialect.h"

/* The first motion with the tool in the spindle. */
const struct nc_move *nc_first_move(const struct nc_program *p);

/* X Y Z, those that change. */
void nc_place(struct nc_program *p, struct vec3 to);

/* The rotary words at q (radians), those that change, of all axes or of the first n; the address is
 * the axis's letter. */
void nc_rotary(struct nc_program *p, const double q[]);
void nc_rotary_axes(struct nc_program *p, int n, const double q[]);

/* Tool-centre-point control is switched on with the rotary axes at zero; they turn to the first
 * place when the tool is above it. */
bool nc_zero_first(const struct nc_program *p);

/* The rotary words with which the tool leaves home: at zero, or as at the first motion. */
void nc_rotary_start(struct nc_program *p, const struct nc_move *first);

/* Above the first place in the frame of the work, before the control tilts its plane: there X and Y
 * of the plane lead nowhere but to that place. */
struct vec3 nc_above_plane(const struct nc_program *p, const struct nc_move *first);

/* The tool axis as the program has it: rotary words, or a vector with these three addresses, all
 * of it or nothing. */
void nc_axis(struct nc_program *p, const struct nc_move *move, const char *const address[3]);

/* F, when it changes; inverse-time feeds always. */
void nc_feed(struct nc_program *p, const struct nc_move *move);

/* The work offset of the n-th tool's work, from 1 (0: none yet): offset.n of the machine, or that
 * of the largest number below it, or its `offset`. */
const char *nc_work_offset(const struct nc_program *p, size_t n);

/* The number of the tool that comes after the one in the spindle, 0: none, or it has no number. */
int nc_tool_after(const struct nc_program *p);

/* The name by which the tool is called (key tool.names), NULL: by its number. */
const char *nc_tool_name(const struct nc_program *p);

#endif

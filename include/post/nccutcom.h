/*
 * nccutcom - CUTCOM, the control's compensation of the tool's radius: G41 G42 G40, RL RR R0.
 *
 * A path holds the places of the tool's centre, so that compensation stays off; a machine whose
 * tool table holds but the difference from the programmed tool (wear) has the key `cutcom` and gets
 * it, where the rotary axes stand still.  It begins and ends with a straight move in X or Y.
 */
#ifndef CLOUDMILL_NCCUTCOM_H
#define CLOUDMILL_NCCUTCOM_H

#include "post/dialect.h"

enum { CUTCOM_OFF, CUTCOM_LEFT, CUTCOM_RIGHT };

/* The statement is CUTCOM: what it asks for is kept for the next move that can begin it. */
bool nc_cutcom_says(struct nc_program *p, const char *text);

/* What the block of a straight move to `to` must say, NULL: nothing.  `word`: of off, left,
 * right. */
const char *nc_cutcom_word(struct nc_program *p, const struct nc_move *move,
                           const char *const word[3]);

/* Off, where the tool leaves the work with it on: true when it was. */
bool nc_cutcom_end(struct nc_program *p);

/* The path asks for compensation to the left or right. */
bool nc_cutcom_asked(const struct path *path);

/* It does, and the program cannot have it or is not to. */
bool nc_cutcom_left_out(const struct path *path, const struct machine *machine,
                        const struct nc_ability *ability);

#endif

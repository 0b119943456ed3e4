/*
 * post_statement - what a path says between its motions: another tool, spindle, coolant, radius
 * compensation (CUTCOM), stops, comments.
 *
 * A path holds the places of the tool's centre, so that the control's radius compensation stays
 * off; a machine whose tool table holds only the difference from the programmed tool (wear) has the
 * key `cutcom` and gets it, where the rotary axes stand still.  It begins and ends with a straight
 * move in X or Y.
 */
#ifndef CLOUDMILL_POST_STATEMENT_H
#define CLOUDMILL_POST_STATEMENT_H

#include "dialect.h"

/* The tool, spindle and coolant at the start of the program: what its first motion is made with. */
void nc_tool_first(struct nc_program *p);

/* The same at a change of tools or planes, with what is said before the next motion. */
void nc_tool_change(struct nc_program *p, const struct nc_move *change);

/* No other tool before the next motion. */
bool nc_tool_stays(const struct nc_program *p, const struct nc_move *from);

enum { CUTCOM_OFF, CUTCOM_LEFT, CUTCOM_RIGHT };

/* What the block of a straight move must say, NULL: nothing.  `word`: of off, left, right. */
const char *nc_cutcom_word(struct nc_program *p, const struct nc_move *move,
                           const char *const word[3]);

/* Off, where the tool leaves the work with it on: true when it was. */
bool nc_cutcom_end(struct nc_program *p);

/* The path asks for compensation to the left or right. */
bool nc_cutcom_asked(const struct path *path);

/* It does, and the program cannot have it or is not to. */
bool nc_cutcom_left_out(const struct path *path, const struct machine *machine,
                        const struct nc_ability *ability);

/* S8000 M3, M8: what the tool in the spindle asks for, each a block. */
void nc_spindle(struct nc_program *p);
void nc_coolant(struct nc_program *p);

/* A statement of the path in the middle of the program, as the control has it; the seconds of a
 * dwell, which is left to the caller to word, 0: none. */
double nc_statement(struct nc_program *p, const char *text);

/* M3 or M4, M5, M9, M1, or what the machine has for them. */
void nc_spindle_on(struct nc_program *p);
void nc_spindle_off(struct nc_program *p);
void nc_coolant_off(struct nc_program *p);
void nc_stop_optional(struct nc_program *p);

/* A comment before the first cut that has no speed of the spindle; where a tool without a number
 * is to be taken. */
void nc_warn_standing(struct nc_program *p, const struct nc_move *move);
void nc_warn_no_tool(struct nc_program *p);

/* Its first cut is made without coolant: the path asks for none there, or the control's file has no
 * place for it. */
bool nc_cuts_dry(const struct nc_program *p);

/* The spindle turns anticlockwise in the first cut. */
bool nc_cuts_anticlockwise(const struct nc_program *p);

/* What the whole plan lacks and was not said to be left out. */
struct nc_missing {
    bool spindle, tool, coolant;
};
struct nc_missing nc_missing(const struct nc_program *p);

#endif

/*
 * nctool - the tools of a program one after another: which one is in the spindle where the program
 * starts, and what it finds when it changes.
 */
#ifndef CLOUDMILL_NCTOOL_H
#define CLOUDMILL_NCTOOL_H

#include "post/dialect.h"

/* The tool, spindle and coolant at the start of the program: what its first motion is made with. */
void nc_tool_first(struct nc_program *p);

/* The same at a change of tools or planes, with what is said before the next motion. */
void nc_tool_change(struct nc_program *p, const struct nc_move *change);

/* No other tool before the next motion. */
bool nc_tool_stays(const struct nc_program *p, const struct nc_move *from);

/* What a SPINDL or COOLNT statement says; false: it is none, or says no speed. */
bool nc_tool_says(const char *text, struct nc_tooling *said);

/* The statement holds this word somewhere, or starts with it, in capitals or not. */
bool nc_tool_holds(const char *text, const char *word);
bool nc_tool_starts(const char *text, const char *word);

#endif

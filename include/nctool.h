/*
 * nctool - the tools of a program one after another: which one is in the spindle where the program
 * starts, and what it finds when it changes.
 */
#ifndef CLOUDMILL_NCTOOL_H
#define CLOUDMILL_NCTOOL_H

#include "dialect.h"

/* The tool, spindle and coolant at the start of the program: what its first motion is made with. */
void nc_tool_first(struct nc_program *p);

/* The same at a change of tools, with what is said before the next motion. */
void nc_tool_change(struct nc_program *p, const struct nc_move *change);

/* What a SPINDL or COOLNT statement says; false: it is none, or says no speed. */
bool nc_tool_says(const char *text, struct nc_tooling *said);

#endif

/*
 * nchead - what stands in a program's head for people: tool, what X Y Z are, the ledger of the
 * tolerance, length and time; and the statements of the path that every control says alike.
 */
#ifndef CLOUDMILL_NCHEAD_H
#define CLOUDMILL_NCHEAD_H

#include "post/dialect.h"

/* Comments at the start of the program. */
void nc_head(struct nc_program *p, const char *control);

/* Sum of the ledger with ncpost's own share, mm. */
double nc_ledger_sum(const struct path *path, const struct nc_plan *plan);

/* S8000 M3, M8: what the path's head asks for, each a block. */
void nc_spindle(struct nc_program *p);
void nc_coolant(struct nc_program *p);

/* A statement of the path in the middle of the program: coolant, spindle, stops, comments. */
void nc_statement(struct nc_program *p, const struct dialect *dialect, const char *text);

#endif

/*
 * machine_tables - the keys of a machine that have a number in their name, and tables of tools.
 *
 *     tool.1.length = 120.5       tool.1.name = BALL_R5      tools = FILE
 *     offset.2 = G55              aux.88 = M88|G4 X1.
 *
 * A table of tools has a line for each: `1 120.5 BALL_R5`, its name last or not at all, or as
 * LinuxCNC has it: `T1 P1 Z120.5 D10 ;name`.  `;` at the start of a line, and `#`, start a comment.
 */
#ifndef CLOUDMILL_MACHINE_TABLES_H
#define CLOUDMILL_MACHINE_TABLES_H

#include "machine/machine.h"

/* Takes a line `key = value` if its key is one of these: 0; 1: it is none (and not changed); -1. */
int machine_tables_set(struct machine *machine, const char *text, const char *name, size_t line,
                       struct error *error);

#endif

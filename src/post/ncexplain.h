/*
 * ncexplain - where a block of a program comes from.
 */
#ifndef CLOUDMILL_NCEXPLAIN_H
#define CLOUDMILL_NCEXPLAIN_H

#include "post/dialect.h"

/*
 * The block of that number: its line of the program, line and pass of the path, its contact point
 * and the rule that made it, as text into a file (NULL or "-": standard output).  -1: it
 * has no such block.
 */
int nc_explain(const char *file, const struct dialect *dialect, struct nc_program *program,
               long number, struct error *error);

#endif

/*
 * post_output - a planned program into its file or files: the whole, from a pass on, divided, or
 * what is to be said of one of its blocks.
 *
 * A part of a plan is a program of its own with a safe start and end: what is before it that lasts
 * (tool, plane, coolant, spindle) is said again, and where the tool is in the cut at either end, it
 * comes from above and goes up along its axis.
 */
#ifndef CLOUDMILL_POST_OUTPUT_H
#define CLOUDMILL_POST_OUTPUT_H

#include "dialect.h"

/*
 * Writes the program to a file (NULL or "-": standard output), or to files with -1, -2 ... before
 * the ending of its name; *files is how many.  -1: there is no such pass or block, no room for a
 * block, or no way off the part within the travel.
 */
int nc_output(struct nc_program *p, struct post_extract extract, const char *file, size_t *files,
              struct error *error);

#endif

/*
 * ncoutput - a planned program into its file or files: the whole, from a pass on, divided, or what
 * is to be said of one of its blocks.
 */
#ifndef CLOUDMILL_NCOUTPUT_H
#define CLOUDMILL_NCOUTPUT_H

#include "post/ncpart.h"

struct nc_extract {
    int from;              /* the pass to begin with, -1: the start */
    int explain;           /* number of a block to be explained, -1: none */
    struct nc_limit limit; /* of each file; all 0: one file */
};

/*
 * Writes the program to a file (NULL or "-": standard output), or to files with -1, -2 ... before
 * the ending of its name; *files is how many.  -1: there is no such pass or block, no room for a
 * block, or no way off the part within the travel.
 */
int nc_output(const struct dialect *dialect, struct nc_program *p, struct nc_extract extract,
              const char *file, size_t *files, struct error *error);

#endif

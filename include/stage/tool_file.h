/*
 * tool_file - a cutter or a holder as a file of `key = value` lines (cloudmill-tool(5)).
 */
#ifndef CLOUDMILL_TOOL_FILE_H
#define CLOUDMILL_TOOL_FILE_H

#include "base/error.h"
#include "gouge/holder.h"

/* What files said so far; starts as all zero.  Lengths in mm, 0: not said. */
struct tool_file {
    double radius;   /* of the ball */
    double flute;    /* from the tip */
    double shank;    /* its radius */
    double length;   /* from the tip to the cutter's end */
    double stickout; /* from the tip to the holder's nose */
    char name[100];
    char holder[200]; /* from its nose upward, as in holder_text.h; "": none */
};

/* Reads NAME, found like a machine (library_file.h) in tools/ or $CLOUDMILL_TOOLS; a later file
 * overrules an earlier one, key by key. */
int tool_file_read(struct tool_file *tool, const char *name, struct error *error);

/* The tool above the centre of its ball, of this radius.  -1: what the files say does not make one.
 */
int tool_file_body(const struct tool_file *tool, double radius, struct tool_body *body,
                   struct error *error);

#endif

/*
 * path_tool - the tools of a path stream: CUTTER, LOADTL, TOOLNO, LOAD and the names of NX.
 *
 * The first tool stands in the path's head; each further one is an item where it is changed.  A
 * CUTTER before the tool has moved is this tool's, one behind is the next one's.
 */
#ifndef CLOUDMILL_PATH_TOOL_H
#define CLOUDMILL_PATH_TOOL_H

#include "path_parse.h"

/* Rows: CUTTER; LOADTL, TOOLNO, TLCHG; LOAD/TOOL. */
int path_read_cutter(struct path_parse *p);
int path_read_tool(struct path_parse *p);
int path_read_load(struct path_parse *p);

/* The shape of the tool that is in the spindle, or of the next one when that has moved. */
void path_tool_shape(struct path_parse *p, const double *cutter, int n);

/* Another tool by its name, of a system that gives no numbers. */
void path_tool_named(struct path_parse *p, const char *name);

/* Before a motion: a shape that came without a number is a change of tools too. */
void path_tool_move(struct path_parse *p);

#endif

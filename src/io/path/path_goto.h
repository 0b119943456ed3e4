/*
 * path_goto - the points of a path stream: GOTO, GODLTA, FROM, the axis between (TLAXIS), and the
 * contact before (CONTCT).
 */
#ifndef CLOUDMILL_PATH_GOTO_H
#define CLOUDMILL_PATH_GOTO_H

#include "path_parse.h"

/* Rows; path_read_goto also takes numbers alone, behind a GOTO. */
int path_read_goto(struct path_parse *p);
int path_read_godlta(struct path_parse *p);
int path_read_tlaxis(struct path_parse *p);
int path_read_from(struct path_parse *p);
int path_read_contact(struct path_parse *p);

/*
 * Takes the lines that wait in the reader as long as they are plain, `GOTO/x,y,z,i,j,k` and
 * contacts between them: most of a path, and in a tenth of the time that a statement takes
 * otherwise.  What stands behind them is for apt_read.
 */
int path_goto_run(struct path_parse *p);

/* -1: a coordinate that no machine has. */
int path_expect_reach(struct path_parse *p, struct vec3 v);

/* Gives a motion its line and the contact that was said for it. */
void path_take_contact(struct path_parse *p, struct path_item *item);

#endif

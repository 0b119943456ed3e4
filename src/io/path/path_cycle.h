/*
 * path_cycle - drilling cycles of a path stream: CYCLE/kind with its numbers, then a GOTO for each
 * hole, then CYCLE/OFF.
 *
 * Each system names the numbers in its own way (DEPTH or FEDTO, CLEAR or RAPTO, RTRCTO, STEP,
 * 1STPECK, SUBPECK, DWELL, feeds); numbers without a name are depth, feed and clearance.
 */
#ifndef CLOUDMILL_PATH_CYCLE_H
#define CLOUDMILL_PATH_CYCLE_H

#include "path_parse.h"

/* The row of CYCLE. */
int path_read_cycle(struct path_parse *p);

/* Adds the hole at this pose; the tool then is above it. */
int path_hole(struct path_parse *p, struct pose mouth);

/* The statement of a cycle, in `text` of CYCLE_TEXT bytes. */
enum { CYCLE_TEXT = 8 * 360 + 80 };
void path_cycle_text(const struct path_cycle *cycle, char *text);

#endif

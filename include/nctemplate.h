/*
 * nctemplate - blocks that a machine file words itself, or a control's own.
 *
 * A template is one block or more with `|` between.  {tool} stands for the tool's number, {offset}
 * for that of its length, {rpm} for
 * the spindle's speed, {tolerance} for ncpost's share of the tolerance in mm, {orientation} for
 * that of the tool axis in degrees, {level} for the tolerance as 1 (0.1 mm, for speed) to 10
 * (0.001 mm, for accuracy).  Of a tilted plane {a} {b} are the angles about X and the turned Y,
 * {i} {j} {k} Euler's about Z, the turned X and the turned Z, degrees.
 */
#ifndef CLOUDMILL_NCTEMPLATE_H
#define CLOUDMILL_NCTEMPLATE_H

#include "dialect.h"

/* -1: a word in braces that nobody here knows. */
int nc_template_check(const char *text, struct error *error);

/* Writes the blocks of the machine's template or, where that is empty, of the control's own. */
void nc_template(struct nc_program *p, const char *own, const char *usual);

#endif

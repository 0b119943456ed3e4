/*
 * holder_text - shank and holder as options and path streams give them.
 */
#ifndef CLOUDMILL_HOLDER_TEXT_H
#define CLOUDMILL_HOLDER_TEXT_H

#include "base/error.h"
#include "gouge/holder.h"

/*
 * Reads truncated cones from the ball's centre upward, joined by `+`, each R0:R1:L, radius at its
 * lower and its upper end and length, or R:L, a cylinder: 3:40+10:25:20+25:60.  Radii are 0 or
 * more, not both 0, lengths above 0, all in mm and no more than 10000.  -1: what was found instead.
 */
int holder_text_read(const char *text, struct holder *holder, struct error *error);

enum { HOLDER_TEXT = 1024 };

/* The same text of a stack of up to HOLDER_PARTS parts, lengths with 6 decimals. */
void holder_text_write(const struct holder *holder, char text[HOLDER_TEXT]);

#endif

/*
 * holder_options - shank and holder as an option gives them.
 */
#ifndef CLOUDMILL_HOLDER_OPTIONS_H
#define CLOUDMILL_HOLDER_OPTIONS_H

#include "base/error.h"
#include "gouge/holder.h"

/*
 * Reads truncated cones from the ball's centre upward, joined by `+`, each R0:R1:L, radius at its
 * lower and its upper end and length, or R:L, a cylinder: 3:40+10:25:20+25:60.  Radii are 0 or
 * more, not both 0, lengths above 0, all in mm and no more than 10000.  -1: what was found instead.
 */
int holder_options_read(const char *text, struct holder *holder, struct error *error);

#endif

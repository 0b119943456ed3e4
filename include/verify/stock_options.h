/*
 * stock_options - the stock as an option gives it.
 */
#ifndef CLOUDMILL_STOCK_OPTIONS_H
#define CLOUDMILL_STOCK_OPTIONS_H

#include "base/error.h"
#include "simulate/stock_init.h"

/*
 * Reads box (around the part), box,MM (so much larger on its sides and its top),
 * box:X0,Y0,Z0,X1,Y1,Z1 (two corners), or offset,MM (the surface and so much more).
 * -1: what was found instead.
 */
int stock_options_read(const char *text, struct stock_options *spec, struct error *error);

#endif

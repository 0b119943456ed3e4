/*
 * ncread_iso - the G words that Fanuc and LinuxCNC share.
 */
#ifndef CLOUDMILL_NCREAD_ISO_H
#define CLOUDMILL_NCREAD_ISO_H

#include "base/error.h"

struct ncread;

/*
 * Takes a G word, in tenths: straight moves and arcs, planes, units, absolute words, kind of feed,
 * and those that do not change where the tool goes.  1: taken, 0: it is none of these, -1: it must
 * not stand here.
 */
int ncread_iso_g(struct ncread *c, int tenths, struct error *error);

#endif

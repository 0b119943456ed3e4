/*
 * canon - what LinuxCNC's own interpreter makes of a program, as the programs themselves are read.
 */
#ifndef READBACK_CANON_H
#define READBACK_CANON_H

#include "ncread/ncread.h"

extern const struct ncread_dialect canon;

#endif

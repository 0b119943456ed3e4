/*
 * control - the names of the controls that programs are written for and read from.
 */
#ifndef CLOUDMILL_CONTROL_H
#define CLOUDMILL_CONTROL_H

#include <stdbool.h>

/* All of them, as a choice of cli.h. */
#define CONTROL_NAMES "fanuc|siemens|heidenhain|linuxcnc"

/* True if `name` is one of them. */
bool control_known(const char *name);

#endif

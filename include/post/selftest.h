/*
 * selftest - a short path that shows on the real machine whether the signs and the centres of its
 * rotary axes are right.
 *
 * The tip goes to a place 100 mm above the work's zero point and stays there while the rotary axes
 * tilt the tool, first to one side and then to the others, with a stop at each: a dial indicator
 * against a ball at that place must not move, and the tool must lean to where the comment says.
 */
#ifndef CLOUDMILL_SELFTEST_H
#define CLOUDMILL_SELFTEST_H

#include "machine/machine.h"
#include "io/path/path.h"

void selftest_path(struct path *path, const struct machine *machine);

#endif

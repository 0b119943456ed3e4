/*
 * post_tilted - whether the linear axes keep their travel in tilted planes.
 *
 * X Y Z of a plane are no axes of the machine: where these stand follows from the angles to which
 * the control turns the others, the nearest that bring the tool to the plane's Z.
 */
#ifndef CLOUDMILL_POST_TILTED_H
#define CLOUDMILL_POST_TILTED_H

#include "dialect.h"

/*
 * Each motion of the plan, and the place above a plane's first before the control turns, on the
 * machine as it is without planes, in mm.  -1: the error says line and axis.
 */
int post_tilted_check(const struct nc_program *program, const struct machine *machine,
                      struct error *error);

#endif

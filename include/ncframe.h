/*
 * ncframe - the frame that a program is written in: inches, or a tilted plane (3+2).
 *
 * Path, machine and wish are brought into that frame before anything is planned, so that what is
 * checked on printed digits is checked on those that are printed.
 */
#ifndef CLOUDMILL_NCFRAME_H
#define CLOUDMILL_NCFRAME_H

#include "ncplan.h"

/* All lengths in inches. */
void nc_frame_inch(struct path *path, struct machine *machine, struct nc_wish *wish);

/* There are holes of drilling cycles in it, and each has what a control must be told: of a tap its
 * pitch, or the speed of the spindle. */
bool nc_frame_holes(const struct path *path);

/* The tool axis where it is the same all over the path; false: it is not. */
bool nc_frame_fixed(const struct path *path, struct vec3 *axis);

/*
 * The path in the frame whose Z is the axis: the work's frame turned about X and then about the
 * turned Y, its zero point kept.  The machine becomes one of three axes, the others' work done by
 * the control.  -1: the machine cannot turn there.
 */
int nc_frame_plane(struct path *path, struct machine *machine, struct vec3 axis,
                   struct error *error);

/* The angles about X and the turned Y, radians, that bring Z onto the axis. */
void nc_frame_angles(struct vec3 axis, double *about_x, double *about_y);

#endif

/*
 * ncread_plane - a tilted plane, 3+2: what a program says in it, in the frame of the work.
 *
 * Fanuc G68.2 X Y Z I J K: origin, and Euler's angles about Z, the turned X and the turned Z; G53.1
 * brings the tool there, G69 ends it.  Siemens CYCLE800 in mode 57 and Heidenhain PLANE SPATIAL:
 * angles about X, the turned Y and the turned Z.
 */
#ifndef CLOUDMILL_NCREAD_PLANE_H
#define CLOUDMILL_NCREAD_PLANE_H

#include <stdbool.h>

#include "simulate/nc_motion.h"
#include "base/error.h"

struct ncread;

struct ncread_plane {
    bool on, brought; /* the rotary axes were turned to it */
    struct vec3 origin, x, y, z;
};

/* Each: 1 it was such a block, 0 it was none, -1 it is wrong.  Of G68.2 2, of G69 0, for it leaves
 * other words to be read. */
int ncread_plane_g(struct ncread *c, struct error *error);
int ncread_plane_cycle800(struct ncread *c, struct error *error);
int ncread_plane_spatial(struct ncread *c, struct error *error);

/* The tool stands upright in the plane that is on: it was brought there, or its rotary words say
 * so.  Of a plane that is off true. */
bool ncread_plane_reached(const struct ncread *c);

/* What was read in the plane, as it is in the work: a piece with its arc or polynomial; the poles
 * of the spline being read. */
void ncread_plane_turn(struct ncread *c, struct nc_piece *piece);
void ncread_plane_turn_poles(struct ncread *c);

#endif

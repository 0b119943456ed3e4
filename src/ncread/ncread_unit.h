/*
 * ncread_unit - programs in inches: words are read as they stand, what is made of them is in mm.
 */
#ifndef CLOUDMILL_NCREAD_UNIT_H
#define CLOUDMILL_NCREAD_UNIT_H

#include "simulate/nc_motion.h"
#include "base/error.h"

#define INCH 25.4 /* mm */

struct ncread;

/* The program's lengths are `mm` long from here on; once said it stays so. */
int ncread_unit(struct ncread *c, double mm, struct error *error);

/* Brings a piece, with its arc or polynomials, to mm. */
void ncread_unit_piece(struct ncread *c, struct nc_piece *piece);

/* Brings the poles of the spline that was read to mm. */
void ncread_unit_poles(struct ncread *c);

#endif

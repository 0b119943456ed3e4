/*
 * ncread_rounding - how far a control may leave the path at corners, as the blocks of a program say
 * it: a program of ncpost says in its head how far that is.
 *
 * LinuxCNC: G64 P (User Manual, G-code: path blending), without P as far as it likes; Siemens:
 * CYCLE832's first argument, ADIS= of G641, CTOL=; Haas: E of G187; Hurco: G64 P; Heidenhain:
 * T of CYCL DEF 32.1.  OTOL=, ATOL= and CYCLE832's third argument of Siemens and TA of CYCL DEF
 * 32.2 are how far the axis may be off, degrees.
 */
#ifndef CLOUDMILL_NCREAD_ROUNDING_H
#define CLOUDMILL_NCREAD_ROUNDING_H

struct ncread;

/* Remarks the block just read where it allows more than the program's head says: what was smoothed,
 * else its tolerance.  The largest of any program is kept in the motion. */
void ncread_rounding_watch(struct ncread *c);

#endif

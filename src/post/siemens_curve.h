/*
 * siemens_curve - B-splines of the Sinumerik: POLY or BSPLINE, the tool axis by ORICURVE.
 */
#ifndef CLOUDMILL_SIEMENS_CURVE_H
#define CLOUDMILL_SIEMENS_CURVE_H

#include "post/dialect.h"

/* The addresses of the tool vector. */
extern const char *const siemens_vector[3];

/*
 * Some curve of the plan has a second one for the head.  Both are to run on one parameter, UPATH;
 * with SPATH the head would follow the length of the way (Programming Manual Job Planning, Settable
 * path reference; 5-axis manual, Reference section).
 */
bool siemens_turning_curves(const struct nc_plan *plan);

/* The blocks of one curve. */
void siemens_curve(struct nc_program *p, const struct nc_move *move);

#endif

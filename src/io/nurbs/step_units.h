/*
 * step_units - the units that the context of a representation states (GLOBAL_UNIT_ASSIGNED_CONTEXT:
 * SI_UNIT with a prefix, or CONVERSION_BASED_UNIT, ISO 10303-41).
 */
#ifndef CLOUDMILL_STEP_UNITS_H
#define CLOUDMILL_STEP_UNITS_H

#include "step_source.h"

/*
 * mm in a unit of length, and radians in one of an angle, of the context that a value of `from`
 * refers to; 1 where none is stated.  With `given` above 0 lengths are in it, whatever is stated.
 * -1: a unit that there is not.
 */
int step_units(const struct step *step, double given, const struct step_values *from,
               const struct step_value *context, double *mm, double *angle, struct error *error);

#endif

/*
 * iges_parameters - the parameters that IGES gives to curves and to the surfaces made of them,
 * brought to those of their NURBS: a NURBS arc's parameter is no angle.
 */
#ifndef CLOUDMILL_IGES_PARAMETERS_H
#define CLOUDMILL_IGES_PARAMETERS_H

#include "iges.h"
#include "nurbs/patch.h"

/* The parameters from..to of the file along one curve of a loop; angles grow evenly along it, or
 * the curve's own parameter does. */
struct iges_range {
    double from, to;
    bool angle;
};

struct iges_ranges {
    size_t n, cap;
    struct iges_range *item;
};

/* The curve's own parameter at the file's t, and back. */
double iges_parameter(const struct nurbs_curve *c, const struct iges_range *r, double t);
double iges_parameter_back(const struct nurbs_curve *c, const struct iges_range *r, double own);

/* The curve of several that t is on. */
size_t iges_range_of(const struct iges_ranges *ranges, double t);

/*
 * Brings the loops of a patch that are in the parameters of a ruled surface (118), one of
 * revolution (120), a tabulated cylinder (122) or the offset of one (140) to those of
 * patch->surface.
 */
int iges_parameters(const struct iges *iges, const struct iges_entity *surface, struct patch *patch,
                    struct error *error);

#endif

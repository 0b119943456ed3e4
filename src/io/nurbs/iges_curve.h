/*
 * iges_curve - curves of an IGES file, in the plane of a surface's parameters or in space: entities
 * 110 (line), 100 (arc), 126 (rational B-spline), 106 (polyline, forms 11, 12, 63) and 102 (several
 * in one), with the transformations (124) that they point to.
 */
#ifndef CLOUDMILL_IGES_CURVE_H
#define CLOUDMILL_IGES_CURVE_H

#include "iges.h"
#include "iges_parameters.h"
#include "nurbs/patch.h"
#include "math/transform.h"

/* The transformation that an entity points to (`line` of the file says so), and those that this one
 * points to; identity for 0. */
int iges_matrix(const struct iges *iges, int number, size_t line, struct transform *matrix,
                struct error *error);

/* Appends the curve to the loop: 0, or -1, or 1 when it is, or holds, an entity that is no curve
 * known here: `unknown` then points to that. */
int iges_curve(const struct iges *iges, const struct iges_entity *entity, struct patch_loop *loop,
               const struct iges_entity **unknown, struct error *error);

/* The same, and the file's parameters along each of them. */
int iges_curve_ranges(const struct iges *iges, const struct iges_entity *entity,
                      struct patch_loop *loop, struct iges_ranges *ranges,
                      const struct iges_entity **unknown, struct error *error);

#endif

/*
 * iges_construct - the surfaces of an IGES file that are no B-splines, as NURBS: entities 108
 * (plane), 114 (parametric spline), 118 (ruled), 120 (of revolution), 122 (tabulated cylinder), and
 * those of solids: 190 (plane), 192 (cylinder), 194 (cone), 196 (sphere), 198 (torus).
 */
#ifndef CLOUDMILL_IGES_CONSTRUCT_H
#define CLOUDMILL_IGES_CONSTRUCT_H

#include "iges.h"
#include "math/transform.h"
#include "nurbs/patch.h"

/*
 * The surface of an entity, placed by `place` (its own transformation, what holds it, and the
 * unit), to patch->surface and ->rough. Planes, cylinders and cones have no ends: they reach as far
 * as the patch's loops in space. 0, 1 when the entity is of another kind, or has no end and no
 * loops, or -1.
 */
int iges_construct(const struct iges *iges, const struct iges_entity *entity,
                   const struct transform *place, struct patch *patch, struct error *error);

#endif

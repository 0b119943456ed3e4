/*
 * project - contact points of a mesh put on the NURBS surfaces that it was made from.
 */
#ifndef CLOUDMILL_PROJECT_H
#define CLOUDMILL_PROJECT_H

#include "curve/motion.h"
#include "nurbs/patch.h"

struct projection;

/* Prepares the surfaces; they must outlive it.  A place counts as on a surface up to `slack` mm
 * beyond what trims it. */
struct projection *project_new(const struct patches *patches, double slack);

void project_free(struct projection *on);

/*
 * Moves a contact point within the plane of this unit normal, square to its own nc_motion in it,
 * onto the nearest surface, inside its trimming, and gives it that surface's normal, to its own
 * side. Returns the number of the surface, or -1 when there is none within `reach` mm: the point is
 * then left as it is.
 */
int project_put(const struct projection *on, struct vec3 plane, double reach,
                struct contact *contact);

#endif

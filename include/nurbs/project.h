/*
 * project - contact points of a mesh moved onto the NURBS surfaces that the mesh was made from.
 */
#ifndef CLOUDMILL_PROJECT_H
#define CLOUDMILL_PROJECT_H

#include "curve/motion.h"
#include "nurbs/patch.h"

struct projection;

/* Prepares the surfaces; they must outlive it.  A point counts as on a surface up to `slack` mm
 * beyond its trimming. */
struct projection *project_new(const struct patches *patches, double slack);

void project_free(struct projection *on);

/*
 * Moves a contact point onto the nearest surface, inside its trimming, within the plane of this
 * unit normal and square to the direction of travel in it, and gives it that surface's normal, to
 * the side that it had.  Returns the number of the surface, or -1 when there is none within `reach`
 * mm; the point then stays as it is.
 */
int project_contact(const struct projection *on, struct vec3 plane, double reach,
                    struct contact *contact);

#endif

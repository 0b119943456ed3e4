/*
 * stitch - vertices of one patch put into the border edges of its neighbours.
 */
#ifndef CLOUDMILL_STITCH_H
#define CLOUDMILL_STITCH_H

#include "company.h"

/*
 * Where a vertex on one border edge lies between the ends of another (guests.h) and the two borders
 * run side by side, that edge gets a vertex of the same place, put on its surface with a normal of
 * its own, and its triangle is cut up anew.  `quilt` is the one that meets.
 */
void stitch(struct quilt *quilt, const struct meeting *meeting, const struct company *company);

#endif

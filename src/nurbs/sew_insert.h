/*
 * sew_insert - vertices of one patch put into the border edges of its neighbours.
 */
#ifndef CLOUDMILL_SEW_INSERT_H
#define CLOUDMILL_SEW_INSERT_H

#include "boundary_match.h"

/*
 * Where a vertex on one border edge lies between the ends of another (t_vertices.h) and the two
 * borders run side by side, that edge gets a vertex of the same place, put on its surface with a
 * normal of its own, and its triangle is cut up anew.  `patch_mesh` is the one that meets.
 */
void sew_insert(struct patch_mesh *patch_mesh, const struct meeting *meeting,
                const struct boundary_match *company);

#endif

/*
 * skin_measure - area and volume of bodies from their surfaces instead of their triangles.
 */
#ifndef CLOUDMILL_SKIN_MEASURE_H
#define CLOUDMILL_SKIN_MEASURE_H

#include "nurbs/skin.h"

/*
 * Replaces the area, and the volume of what is closed, of each body all of whose surfaces belong to
 * it alone and are clear (patch_measure.h), and sets `exact`.  A body that its triangles are more
 * than 20 % away from, as no tolerance that is of use leaves them, keeps what these say.
 */
void skin_measure(struct skin *skin, const struct patch_mesh *mesh, const struct patches *patches,
                  int threads);

#endif

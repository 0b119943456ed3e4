/*
 * feature_accept - which features bring a mesh closer to its scan.
 */
#ifndef CLOUDMILL_FEATURE_ACCEPT_H
#define CLOUDMILL_FEATURE_ACCEPT_H

#include "feature.h"
#include "mesh/mesh.h"

/*
 * Sets to FEATURE_NONE those of the n features about which the scan is further from the mesh `with`
 * them than from that `without`: the sum of the squared distances of the points within `reach` mm
 * of its place, and of those of other features within four times that, must be less, or no more by
 * a tenth of what `noise` (one standard deviation, mm) makes of it.
 */
void feature_accept(const struct mesh *without, const struct mesh *with, const struct vec3 *point,
                    size_t points, double reach, double noise, int threads, struct feature *feature,
                    size_t n);

#endif

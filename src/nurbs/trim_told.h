/*
 * trim_told - which side of its loops a patch is on, by what its file draws in the parameters.
 *
 * On a surface that closes, as a sphere or torus, a loop bounds two areas, and undirected curves in
 * space fit both: the seam, or a slit to a pole, is a way there and back.  Where the file draws the
 * same loops in the parameters too, their place in the range tells which area is meant.
 */
#ifndef CLOUDMILL_TRIM_TOLD_H
#define CLOUDMILL_TRIM_TOLD_H

#include "trim_loops.h"

/* True when patch->told, by the rule of even and odd, has inside what the loops have outside and
 * the other way round: at most places of the range.  False where nothing is told. */
bool trim_told_outside(const struct patch *patch, const struct uv_polygon *loops);

#endif

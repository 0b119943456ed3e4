/*
 * trim_loops - the curves that trim a patch as polygons in its parameters.
 *
 * Stages: each curve is followed span by span, halved until its chords are near enough (curves in
 * space by their foot points on the surface: pullback.h; at a pole a loop runs along the side of
 * the range that the pole is); on a surface that closes on itself the loops are moved into the
 * range and split at the seam (Sutherland and Hodgman 1974).
 */
#ifndef CLOUDMILL_TRIM_LOOPS_H
#define CLOUDMILL_TRIM_LOOPS_H

#include "nurbs/patch.h"
#include "uv_polygon.h"

/*
 * The loops of a patch as polygons whose sides, on the surface, stay within `tolerance` mm of the
 * curve; curves that run backwards are turned round.
 *
 * On a surface that closes on itself, a loop beyond the range is moved by whole turns; one that
 * crosses the seam is split there.  A loop that goes once round, without the seam as part of it,
 * bounds what is on its left; two of them bound what is between them.  Loops of less than three
 * corners are left out, and those that go round more than once, which loops->lost counts.
 */
void trim_loops(const struct patch *patch, double tolerance, struct uv_polygon *loops);

/* The same for what the loops bound: four sides for each, with corners a little beyond the curve,
 * so that the areas in the parameters agree to higher order. */
void trim_loops_bent(const struct patch *patch, double tolerance, struct uv_polygon *loops);

#endif

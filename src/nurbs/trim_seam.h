/*
 * trim_seam - loops on a surface that closes on itself, brought into the range of its parameters.
 */
#ifndef CLOUDMILL_TRIM_SEAM_H
#define CLOUDMILL_TRIM_SEAM_H

#include "pullback.h"
#include "nurbs/uv_polygon.h"

/*
 * Each loop (first place to last one, that one too where it is the first again) that lies beyond
 * the range of a closed parameter is moved by whole turns; one that crosses the seam is parted
 * there.  A loop that goes once round, without the seam as part of it, bounds what is on its left;
 * two of them bound what is between.  On a surface that does not close loops stay as they are.
 * Loops of less than three corners are left out, and those that go round more than once, which
 * to->lost counts.
 */
void trim_seam(const struct pullback *surface, const struct uv_polygon *from,
               struct uv_polygon *to);

#endif

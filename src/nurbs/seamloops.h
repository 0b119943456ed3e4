/*
 * seamloops - loops on a surface that closes on itself, brought into the range of its parameters.
 */
#ifndef CLOUDMILL_SEAMLOOPS_H
#define CLOUDMILL_SEAMLOOPS_H

#include "pullback.h"
#include "nurbs/uvloops.h"

/*
 * Each loop (first place to last one, that one too where it is the first again) that lies beyond
 * the range of a closed parameter is moved by whole turns; one that crosses the seam is parted
 * there.  A loop that goes once round, without the seam as part of it, bounds what is on its left;
 * two of them bound what is between.  On a surface that does not close loops stay as they are.
 * Loops of less than three corners are left out, and those that go round more than once, which
 * to->lost counts.
 */
void seamloops(const struct pullback *surface, const struct uvloops *from, struct uvloops *to);

#endif

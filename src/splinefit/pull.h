/*
 * pull - what one place of a target asks of a curve at its foot.
 *
 * It is the quadratic form  x' W x / 2 + g' x,  where x says how the curve moves there: its point,
 * and with a turning axis its head behind it.  off is the distance, and what shall become small is
 * the sum of off^power.  Moving a foot along the curve changes nothing of the first order, so that
 * only what is perpendicular to the curve counts; with d the direction of the distance
 * W = off^(power - 2) (I + (power - 2) dd'), perpendicular to the curve.
 */
#ifndef CLOUDMILL_PULL_H
#define CLOUDMILL_PULL_H

#include "feet.h"

enum { PULL_WIDTH = 6, PULL_SIZE = PULL_WIDTH * (PULL_WIDTH + 1) / 2 };

/* W's element (i, j), j <= i, stands at i (i + 1) / 2 + j: the point's own are the first six. */
struct pull {
    double w[PULL_SIZE], g[PULL_WIDTH];
};

/* Where element (i, j) stands, whichever of the two is larger. */
static inline int pull_at(int i, int j)
{
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/*
 * Of place k at the foot of the tracked point, or with `other` at that of the other end of the
 * radius; the axis counts at the one that leads.  Distances count in parts of the worst one.
 */
void pull_of(const struct target *target, const struct feet *feet, size_t k, bool other, int power,
             struct pull *pull);

#endif

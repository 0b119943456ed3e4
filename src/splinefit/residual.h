/*
 * residual - what one place of a target asks of a curve at its foot.
 *
 * It is the quadratic form  x' W x / 2 + g' x,  where x says how the curve moves there: its point,
 * and with a turning axis its head behind it.  off is the distance, and what shall become small is
 * the sum of off^power.  Moving a foot along the curve changes nothing of the first order, so that
 * only what is perpendicular to the curve counts; with d the direction of the distance
 * W = off^(power - 2) (I + (power - 2) dd'), perpendicular to the curve.
 */
#ifndef CLOUDMILL_RESIDUAL_H
#define CLOUDMILL_RESIDUAL_H

#include "footpoints.h"

enum { RESIDUAL_WIDTH = 6, RESIDUAL_SIZE = RESIDUAL_WIDTH * (RESIDUAL_WIDTH + 1) / 2 };

/* W's element (i, j), j <= i, stands at i (i + 1) / 2 + j: the point's own are the first six. */
struct residual {
    double w[RESIDUAL_SIZE], g[RESIDUAL_WIDTH];
};

/* Where element (i, j) stands, whichever of the two is larger. */
static inline int residual_at(int i, int j)
{
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/*
 * Of place k at the foot of the tracked point, or with `other` at that of the other end of the
 * radius; the axis counts at the one that leads.  Distances count in parts of the worst one.
 */
void residual_of(const struct target *target, const struct footpoints *feet, size_t k, bool other,
                 int power, struct residual *pull);

#endif

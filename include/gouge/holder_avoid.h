/*
 * holder_avoid - shank and holder kept clear of the part by leaning the tool axis.
 */
#ifndef CLOUDMILL_HOLDER_AVOID_H
#define CLOUDMILL_HOLDER_AVOID_H

#include "gouge/gouge.h"
#include "curve/run.h"

struct holder_avoid_options {
    const struct gouge_check *guard;
    const struct holder *holder;
    double limit; /* how far the axis may be leaned, radians */
    double slack; /* how deep a guard point may be in the holder, mm */
};

/* True if the holder is clear while the tool moves from one pose to the other, the ball's centre
 * straight and the axis on the great circle: proved by how far the holder can move between the
 * poses that are checked. */
bool holder_clear_between(const struct holder_avoid_options *rule, const struct run_point *from,
                          const struct run_point *to);

/*
 * Leans the axes of a run, without moving ball and contact, so that the holder is clear at the
 * points and between them: at each point that needs it by the least that clears it, in steps (STEP)
 * to any side, and before and after it evenly less (RAMP).  The tool stays on the outer side of the
 * surface. touches[i] becomes true where that did not help, at the point or between it and the one
 * before. Returns the largest lean, radians.
 */
double holder_avoid(const struct holder_avoid_options *rule, struct run *run, bool *touches);

#endif

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

/* True when the holder is clear on the way from one pose to the other, the ball's centre going
 * straight and the axis on the great circle: proven by how far it can move between the poses that
 * are looked at. */
bool holder_clear_between(const struct holder_avoid_options *rule, const struct run_point *from,
                          const struct run_point *to);

/*
 * Leans the axes of a run, ball and contact where they are, so that the holder is clear at the
 * points and between them: at each point that needs it by as little as will do, in steps of 2.5
 * degrees to any side, and before and behind it evenly less, 3 degrees a millimetre.  The tool
 * stays on the outer side of the surface.  touches[i] becomes true where that did not help, at the
 * point or on the way to it from the one before.  Returns the largest lean, radians.
 */
double holder_avoid(const struct holder_avoid_options *rule, struct run *run, bool *touches);

#endif

/*
 * holder_sweep - flute, shank and holder in motion: clear of the guard all the way between two
 * poses.
 */
#ifndef CLOUDMILL_HOLDER_SWEEP_H
#define CLOUDMILL_HOLDER_SWEEP_H

#include "curve/run.h"
#include "gouge/gouge.h"

/* What may not be touched by what, and how deep a guard point may be in it, mm. */
struct holder_sweep {
    const struct gouge_check *guard;
    const struct holder *holder;
    double slack;
};

/* True if it is clear while the tool moves from one pose to the other, the ball's centre straight
 * and the axis on the great circle: proved by how far the holder can move between the poses that
 * are checked. */
bool holder_sweep_clear(const struct holder_sweep *sweep, const struct run_point *from,
                        const struct run_point *to);

/* How far the tool is from the guard at a pose, mm; no more than `most`. */
double holder_sweep_clearance(const struct holder_sweep *sweep, const struct run_point *p,
                              double most);

/* The same between poses whose clearances are known. */
bool holder_sweep_clear_between(const struct holder_sweep *sweep, const struct run_point *from,
                                double clear_from, const struct run_point *to, double clear_to);

#endif

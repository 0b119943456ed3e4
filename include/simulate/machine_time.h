/*
 * machine_time - the least time that a machine takes for a program, under the largest speed,
 * acceleration and jerk of each axis, looking ahead without end.
 *
 * Each stretch at feed between two rapid moves, from standstill to standstill, is followed in even
 * steps of the tip; the places of all axes are averaged over the length that the control smooths.
 * With q the place of an axis over the tip's way s and v the speed of the tip, v |q'| keeps to its
 * speed, v^2 |q''| and what the change of v adds to its acceleration, v^3 |q'''| to its jerk (J. E.
 * Bobrow, S. Dubowsky, J. S. Gibson 1985; one pass forward and one back).  Starts and stops are
 * longer by what their jerk costs.  Rapid moves go from standstill to standstill.
 */
#ifndef CLOUDMILL_MACHINE_TIME_H
#define CLOUDMILL_MACHINE_TIME_H

#include "simulate/axis_limits.h"

enum { MACHINE_TIME_WORST = 5 };

struct machine_time_options {
    const struct axis_limits *limits;
    double acceleration[NC_AXES]; /* mm/s^2, degrees/s^2 */
    double jerk[NC_AXES];         /* mm/s^3, degrees/s^3 */
    double smoothing;             /* mm */
};

struct machine_time {
    double least, programmed;         /* minutes at feed: under the limits, and length by feed */
    double rapid;                     /* minutes of rapid moves */
    double slow;                      /* share of the way at feed below half the feed */
    double turn[NC_AXES];             /* degrees that each rotary axis turns in all */
    float *share;                     /* of each piece: mean speed by its feed; 1: rapid */
    size_t worst[MACHINE_TIME_WORST]; /* pieces that lose most time, the worst first ... */
    double lost[MACHINE_TIME_WORST];  /* ... seconds; 0: none */
};

struct machine_time machine_time_of(const struct nc_motion *motion,
                                    const struct machine_time_options *options);
void machine_time_free(struct machine_time *time);

#endif

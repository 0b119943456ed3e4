/*
 * axis_limits - what each axis of the machine does along a nc_motion: travel, turns, speeds, time.
 *
 * Axes in the order X Y Z A B C; mm and degrees, minutes.  With tool centre point control the
 * linear axes and, where the motion gives the tool axis as a vector, the rotary axes follow from
 * the machine as the control would make them: of two solutions the nearer one.
 */
#ifndef CLOUDMILL_AXIS_LIMITS_H
#define CLOUDMILL_AXIS_LIMITS_H

#include "simulate/nc_motion.h"

enum { LOAD_AXES = 6 };

struct axis_limits_limits {
    double min[LOAD_AXES], max[LOAD_AXES]; /* travel */
    double rapid[LOAD_AXES];               /* largest speed, a minute */
    bool combined; /* F counts mm and degrees of all axes alike (no tool centre point control) */
};

/* One axis over something: where, and by how much. */
struct axis_limits_peak {
    double value;
    int axis;
    size_t piece;
};

struct axis_limits {
    double low[LOAD_AXES], high[LOAD_AXES]; /* travel used; low > high: never moved */
    size_t beyond;                          /* pieces that leave the travel ... */
    struct axis_limits_peak travel;     /* ... the first of them: value is the place of the axis */
    size_t unreachable, unreachable_at; /* tool axes that the machine has no angles for */
    struct axis_limits_peak
        jump; /* largest turn of a rotary axis in one block that cuts, degrees */
    struct axis_limits_peak swing; /* largest turn for a mm of the tip in one such block, degrees */
    size_t fast;                   /* blocks in which an axis would be faster than it can ... */
    struct axis_limits_peak speed; /* ... the worst: value is the share of its largest speed */
    double cut_time, rapid_time;   /* minutes; blocks too fast take as long as the axis needs */
    double cut_length, rapid_length; /* of the tip, mm */
    size_t no_feed;                  /* pieces at feed without a feed */
};

struct axis_limits axis_limits_run(const struct nc_motion *nc_motion,
                                   const struct axis_limits_limits *limits);

#endif

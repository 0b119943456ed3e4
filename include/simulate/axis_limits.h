/*
 * axis_limits - what each axis of the machine does along a motion: travel, turns, speeds, time.
 *
 * Axes in the order X Y Z A B C; mm and degrees, minutes.  With tool centre point control the
 * linear axes and, where the motion gives the tool axis as a vector, the rotary axes follow from
 * the machine as the control would make them: of two solutions the nearer one.
 */
#ifndef CLOUDMILL_AXIS_LIMITS_H
#define CLOUDMILL_AXIS_LIMITS_H

#include "simulate/nc_motion.h"

enum { NC_AXES = 6 };

struct axis_limits {
    double min[NC_AXES], max[NC_AXES]; /* travel */
    double slack;                      /* beyond it that counts as within: places are rounded */
    double rapid[NC_AXES];             /* largest speed, a minute */
    bool strict;   /* the control does not slow down where F asks more of an axis than it can */
    bool combined; /* F counts mm and degrees of all axes alike (no tool centre point control) */
};

/* One axis over something: where, and by how much. */
struct axis_peak {
    double value;
    int axis;
    size_t piece;
};

struct axis_use {
    double low[NC_AXES], high[NC_AXES]; /* travel used; low > high: never moved */
    size_t beyond;                      /* pieces that leave the travel ... */
    struct axis_peak travel;            /* ... the first of them: value is the place of the axis */
    size_t unreachable, unreachable_at; /* tool axes that the machine has no angles for */
    struct axis_peak jump;       /* largest turn of a rotary axis in one block that cuts, degrees */
    struct axis_peak turn_rate;  /* largest turn for a mm of the tip in one such block, degrees */
    size_t fast;                 /* blocks in which an axis would be faster than it can ... */
    struct axis_peak speed;      /* ... the worst: value is the share of its largest speed */
    double cut_time, rapid_time; /* minutes; blocks too fast take as long as the axis needs */
    double cut_length, rapid_length; /* of the tip, mm */
    size_t no_feed;                  /* pieces at feed without a feed */
};

/* Where all axes stand; `turn` goes with it from place to place. */
struct axis_place {
    double axis[NC_AXES];
    struct vec3 tip;
};
struct axis_follow {
    const struct nc_motion *motion;
    double turn[VERIFY_KINEMATICS_AXES];
};

/* At s of a piece, the rotary axes by the nearer of their solutions. */
struct axis_place axis_limits_place(struct axis_follow *follow, size_t piece, double s);

struct axis_use axis_limits_check(const struct nc_motion *motion, const struct axis_limits *limits);

#endif

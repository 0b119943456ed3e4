/*
 * axis_time - how long the axes of a machine take along a way at feed, from standstill to
 * standstill: no axis is faster, or speeds up or slows down more, than it can.
 *
 * The way is given at places along it, straight between.  Where it bends, the control rounds it
 * over a length; there the speed is no more than the acceleration, and the jerk of the change of
 * acceleration over that length, allow.  Speeds are found forth and back along the way (Bobrow,
 * Dubowsky and Gibson 1985, on a way with limits of each axis).  The jerk of a change of speed
 * along a straight way is not counted.
 */
#ifndef CLOUDMILL_AXIS_TIME_H
#define CLOUDMILL_AXIS_TIME_H

#include "base/array.h"

enum { AXIS_TIME_AXES = 5 };

/* By second: mm and degrees of the way's axes. */
struct axis_time_limits {
    double speed[AXIS_TIME_AXES], acceleration[AXIS_TIME_AXES], jerk[AXIS_TIME_AXES];
    double smoothing; /* length of the way over which it is rounded, more than 0 */
};

struct axis_time_place {
    double axis[AXIS_TIME_AXES];
    double way;  /* along it, from the first place on */
    double feed; /* of the way up to here, a second */
    size_t mark; /* what its maker knows it by */
};

/* Seconds over n places; step[i]: of those from place i - 1 to i. */
double axis_time_run(const struct axis_time_limits *limits, const struct axis_time_place place[],
                     size_t n, double step[]);

/* The same of a way of millions of places while it is being made, of which those are kept from
 * which the axes cannot stop before the next one.  Starts as all zero but for the limits and, where
 * somebody asks for each step, who is told its seconds and the mark of the place that it leads to:
 * in their order, once they are certain. */
struct axis_time_way {
    struct axis_time_limits limits;
    void (*step)(void *context, size_t mark, double seconds);
    void *context;
    size_t n, cap; /* places that are kept: from the second on they count */
    struct axis_time_place *item;
    struct doubles speed; /* at each of them ... */
    size_t from, known;   /* ... the first that counts; before this one they are known */
    double seconds;       /* up to that place */
};

/* A place more, to be filled before the next one. */
struct axis_time_place *axis_time_add(struct axis_time_way *way);

/* Seconds over all of them; then another way may begin. */
double axis_time_end(struct axis_time_way *way);
void axis_time_free(struct axis_time_way *way);

/* Seconds of a straight way of all axes from standstill to standstill, as fast as they can. */
double axis_time_rapid(const struct axis_time_limits *limits, const double from[],
                       const double to[]);

#endif

/* axis_time - see axis_time.h. */
#include "machine/axis_time.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"

/* What each axis does for each length of the way about a place, and how much that changes there. */
struct rates {
    double slope[AXIS_TIME_AXES];
    double change[AXIS_TIME_AXES], over; /* of the slope, over so much of the way */
};

/* fmax and fmin for what is a number: one instruction. */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double bend_of(const struct rates *r, int k)
{
    return r->change[k] / r->over;
}

/* Of a bound that rounding might bring under what it bounds: beyond it, nothing does. */
static const double SURELY = 1 + 1e-12;

/* What each axis does for each length of the way up to a place. */
struct slopes {
    double axis[AXIS_TIME_AXES];
};

static inline struct slopes slopes_to(const struct axis_time_place *to)
{
    struct slopes s = {{0}};
    double length = to->way - to[-1].way;

    for (int k = 0; k < AXIS_TIME_AXES && length > 0; k++)
        s.axis[k] = (to->axis[k] - to[-1].axis[k]) / length;
    return s;
}

/* About a place between others, from the slopes up to it and after it. */
static inline struct rates rates_between(const struct axis_time_limits *limits,
                                         const struct axis_time_place *at, struct slopes before,
                                         struct slopes after)
{
    struct rates r = {.over = larger((at[1].way - at[-1].way) / 2, limits->smoothing)};

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        r.slope[k] = larger(fabs(before.axis[k]), fabs(after.axis[k]));
        r.change[k] = fabs(after.axis[k] - before.axis[k]);
    }
    return r;
}

static struct rates rates_at(const struct axis_time_limits *limits,
                             const struct axis_time_place place[], size_t i, size_t n)
{
    struct rates r = {.over = 1};

    if (i > 0 && i + 1 < n)
        return rates_between(limits, &place[i], slopes_to(&place[i]), slopes_to(&place[i + 1]));
    if (n > 1) {
        struct slopes s = slopes_to(&place[i > 0 ? i : 1]);
        for (int k = 0; k < AXIS_TIME_AXES; k++)
            r.slope[k] = fabs(s.axis[k]);
    }
    return r;
}

/* The fastest at a place.  Most bounds are far off: only what may be one is worked out, and no
 * quotient for it. */
static double speed_at(const struct axis_time_limits *limits, const struct rates *r, double feed)
{
    double v = feed, square = v * v, cube = v * v * v;
    int bound = 0;

    for (int k = 0; k < AXIS_TIME_AXES; k++) { /* mostly none is, which is told without a jump */
        double jerk = limits->jerk[k] * limits->smoothing, change = SURELY * r->change[k];
        bound |= (limits->speed[k] < SURELY * v * r->slope[k]) |
                 (limits->acceleration[k] * r->over < square * change) |
                 (jerk * r->over < cube * change);
    }
    if (!bound)
        return v;
    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double jerk = limits->jerk[k] * limits->smoothing, change = SURELY * r->change[k];
        if (limits->speed[k] < SURELY * v * r->slope[k])
            v = fmin(v, limits->speed[k] / r->slope[k]);
        if (limits->acceleration[k] * r->over < v * v * change)
            v = fmin(v, sqrt(limits->acceleration[k] / bend_of(r, k)));
        if (jerk * r->over < v * v * v * change)
            v = fmin(v, cbrt(jerk / bend_of(r, k)));
    }
    return v;
}

/* The fastest a length after (or before) a place where it is v, no more than `most`. */
static double speed_after(const struct axis_time_limits *limits, const struct rates *r, double v,
                          double length, double most)
{
    double change = HUGE_VAL;

    for (int k = 0; k < AXIS_TIME_AXES; k++)
        if (r->slope[k] > 0)
            change = fmin(change,
                          fmax(0, limits->acceleration[k] - bend_of(r, k) * v * v) / r->slope[k]);
    return change < HUGE_VAL ? fmin(most, sqrt(v * v + 2 * length * change)) : most;
}

/* Straight to a place, from v0 to v1: up to the feed or as far as the length allows, and down. */
static double step_seconds(const struct axis_time_limits *limits, const struct axis_time_place *to,
                           double v0, double v1)
{
    double length = to->way - to[-1].way, top = to->feed, change = HUGE_VAL;

    if (v0 == v1 && v0 > 0 && top > 0 && top <= v0 && length > 0) /* even: no axis bounds it */
        return length / v0;
    struct slopes s = slopes_to(to);
    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double slope = fabs(s.axis[k]);
        if (slope > 0) {
            top = fmin(top, limits->speed[k] / slope);
            change = fmin(change, limits->acceleration[k] / slope);
        }
    }
    if (!(length > 0) || !(top > 0))
        return 0;
    if (!(change < HUGE_VAL))
        return length / top;
    top = fmax(top, fmax(v0, v1));
    top = fmin(top, sqrt((2 * change * length + v0 * v0 + v1 * v1) / 2));
    double ramps = (2 * top * top - v0 * v0 - v1 * v1) / (2 * change);
    return (2 * top - v0 - v1) / change + fmax(length - ramps, 0) / top;
}

/* The speeds at all places, 0 at both ends, with no more than what was before them in mind: a way
 * that is no slower at the place before bounds nothing. */
static void speeds_forth(const struct axis_time_limits *limits,
                         const struct axis_time_place place[], size_t n, double v[])
{
    struct slopes before = slopes_to(&place[1]);

    for (size_t i = 1; i + 1 < n; i++) {
        struct slopes after = slopes_to(&place[i + 1]);
        struct rates r = rates_between(limits, &place[i], before, after);
        v[i] = speed_at(limits, &r, smaller(place[i].feed, place[i + 1].feed));
        if (v[i] > v[i - 1]) {
            struct rates last = rates_at(limits, place, i - 1, n);
            v[i] = speed_after(limits, &last, v[i - 1], place[i].way - place[i - 1].way, v[i]);
        }
        before = after;
    }
}

/* And with what comes after them; each becomes the seconds from the place before. */
static void seconds_back(const struct axis_time_limits *limits,
                         const struct axis_time_place place[], size_t n, double v[])
{
    for (size_t i = n; i-- > 1;) {
        if (v[i - 1] > v[i]) {
            struct rates r = rates_at(limits, place, i, n);
            v[i - 1] = speed_after(limits, &r, v[i], place[i].way - place[i - 1].way, v[i - 1]);
        }
        v[i] = step_seconds(limits, &place[i], v[i - 1], v[i]);
    }
}

double axis_time_run(const struct axis_time_limits *limits, const struct axis_time_place place[],
                     size_t n, double step[])
{
    double *v = mem_alloc(n + 1, sizeof *v), sum = 0;

    if (n > 1) {
        speeds_forth(limits, place, n, v);
        seconds_back(limits, place, n, v);
    }
    for (size_t i = 1; i < n; i++) {
        if (step)
            step[i] = v[i];
        sum += v[i];
    }
    free(v);
    return sum;
}

double axis_time_rapid(const struct axis_time_limits *limits, const double from[],
                       const double to[])
{
    double most = 0;

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double way = fabs(to[k] - from[k]), fast = limits->speed[k];
        double change = limits->acceleration[k];
        double seconds =
            way >= fast * fast / change ? way / fast + fast / change : 2 * sqrt(way / change);
        most = fmax(most, way > 0 ? seconds : 0);
    }
    return most;
}

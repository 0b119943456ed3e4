/* axis_time - see axis_time.h. */
#include "machine/axis_time.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"

/* What each axis does for each length of the way about a place, and how much that changes there. */
struct rates {
    double slope[AXIS_TIME_AXES], bend[AXIS_TIME_AXES];
};

/* Of a bound that rounding might bring under what it bounds: beyond it, nothing does. */
static const double SURELY = 1 + 1e-12;

static double slope_of(const struct axis_time_place *to, int k)
{
    double length = to->way - to[-1].way;

    return length > 0 ? (to->axis[k] - to[-1].axis[k]) / length : 0;
}

static struct rates rates_at(const struct axis_time_limits *limits,
                             const struct axis_time_place place[], size_t i, size_t n)
{
    struct rates r = {{0}, {0}};
    double half = i > 0 && i + 1 < n ? (place[i + 1].way - place[i - 1].way) / 2 : 0;

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double before = i > 0 ? slope_of(&place[i], k) : 0;
        double after = i + 1 < n ? slope_of(&place[i + 1], k) : before;
        r.slope[k] = fmax(fabs(before), fabs(after));
        if (i > 0 && i + 1 < n)
            r.bend[k] = fabs(after - before) / fmax(half, limits->smoothing);
    }
    return r;
}

/* The fastest at a place.  Most bounds are far off: only what may be one is worked out. */
static double speed_at(const struct axis_time_limits *limits, const struct rates *r, double feed)
{
    double v = feed;

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double jerk = limits->jerk[k] * limits->smoothing;
        if (limits->speed[k] < SURELY * v * r->slope[k])
            v = fmin(v, limits->speed[k] / r->slope[k]);
        if (limits->acceleration[k] < SURELY * v * v * r->bend[k])
            v = fmin(v, sqrt(limits->acceleration[k] / r->bend[k]));
        if (jerk < SURELY * v * v * v * r->bend[k])
            v = fmin(v, cbrt(jerk / r->bend[k]));
    }
    return v;
}

/* The fastest a length after (or before) place i where it is v, no more than `most`: a way that is
 * no slower there bounds nothing. */
static double speed_after(const struct axis_time_limits *limits,
                          const struct axis_time_place place[], size_t i, size_t n, double v,
                          double length, double most)
{
    double change = HUGE_VAL;

    if (most <= v)
        return most;
    struct rates r = rates_at(limits, place, i, n);
    for (int k = 0; k < AXIS_TIME_AXES; k++)
        if (r.slope[k] > 0)
            change =
                fmin(change, fmax(0, limits->acceleration[k] - r.bend[k] * v * v) / r.slope[k]);
    return change < HUGE_VAL ? fmin(most, sqrt(v * v + 2 * length * change)) : most;
}

/* Straight to a place, from v0 to v1: up to the feed or as far as the length allows, and down. */
static double step_seconds(const struct axis_time_limits *limits, const struct axis_time_place *to,
                           double v0, double v1)
{
    double length = to->way - to[-1].way, top = to->feed, change = HUGE_VAL;

    if (v0 == v1 && v0 > 0 && top > 0 && top <= v0 && length > 0) /* even: no axis bounds it */
        return length / v0;
    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double slope = fabs(slope_of(to, k));
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

double axis_time_run(const struct axis_time_limits *limits, const struct axis_time_place place[],
                     size_t n, double step[])
{
    double *v = mem_alloc(n + 1, sizeof *v), sum = 0;

    for (size_t i = 1; i + 1 < n; i++) { /* it stands at both ends */
        struct rates rates = rates_at(limits, place, i, n);
        v[i] = speed_at(limits, &rates, fmin(place[i].feed, place[i + 1].feed));
    }
    for (size_t i = 1; i < n; i++)
        v[i] =
            speed_after(limits, place, i - 1, n, v[i - 1], place[i].way - place[i - 1].way, v[i]);
    for (size_t i = n; i-- > 1;)
        v[i - 1] =
            speed_after(limits, place, i, n, v[i], place[i].way - place[i - 1].way, v[i - 1]);
    for (size_t i = 1; i < n; i++) {
        double seconds = step_seconds(limits, &place[i], v[i - 1], v[i]);
        if (step)
            step[i] = seconds;
        sum += seconds;
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

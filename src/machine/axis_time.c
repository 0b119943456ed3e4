/* axis_time - see axis_time.h. */
#include "machine/axis_time.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"

/* What each axis does for each length of the way before a place, and how much that changes there. */
struct rates {
    double slope[AXIS_TIME_AXES], bend[AXIS_TIME_AXES];
};

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

/* The fastest at a place. */
static double speed_at(const struct axis_time_limits *limits, const struct rates *r, double feed)
{
    double v = feed;

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        if (r->slope[k] > 0)
            v = fmin(v, limits->speed[k] / r->slope[k]);
        if (r->bend[k] > 0) {
            v = fmin(v, sqrt(limits->acceleration[k] / r->bend[k]));
            v = fmin(v, cbrt(limits->jerk[k] * limits->smoothing / r->bend[k]));
        }
    }
    return v;
}

/* The fastest a length after (or before) a place where it is v. */
static double speed_after(const struct axis_time_limits *limits, const struct rates *r, double v,
                          double length)
{
    double most = HUGE_VAL;

    for (int k = 0; k < AXIS_TIME_AXES; k++)
        if (r->slope[k] > 0)
            most = fmin(most, fmax(0, limits->acceleration[k] - r->bend[k] * v * v) / r->slope[k]);
    return most < HUGE_VAL ? sqrt(v * v + 2 * length * most) : HUGE_VAL;
}

/* Straight to a place, from v0 to v1: up to the feed or as far as the length allows, and down. */
static double step_seconds(const struct axis_time_limits *limits, const struct axis_time_place *to,
                           double v0, double v1)
{
    double length = to->way - to[-1].way, top = to->feed, change = HUGE_VAL;

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
    struct rates *rates = mem_alloc(n + 1, sizeof *rates);
    double *v = mem_alloc(n + 1, sizeof *v), sum = 0;

    for (size_t i = 0; i < n; i++) {
        double feed = i + 1 < n ? fmin(place[i].feed, place[i + 1].feed) : place[i].feed;
        rates[i] = rates_at(limits, place, i, n);
        v[i] = i == 0 || i + 1 == n ? 0 : speed_at(limits, &rates[i], feed);
    }
    for (size_t i = 1; i < n; i++)
        v[i] = fmin(v[i],
                    speed_after(limits, &rates[i - 1], v[i - 1], place[i].way - place[i - 1].way));
    for (size_t i = n; i-- > 1;)
        v[i - 1] =
            fmin(v[i - 1], speed_after(limits, &rates[i], v[i], place[i].way - place[i - 1].way));
    for (size_t i = 1; i < n; i++) {
        double seconds = step_seconds(limits, &place[i], v[i - 1], v[i]);
        if (step)
            step[i] = seconds;
        sum += seconds;
    }
    free(rates);
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

/* axis_time - see axis_time.h. */
#include "machine/axis_time.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/elementary.h"

/* What each axis does for each length of the way about a place, and how much that changes there. */
struct rates {
    double slope[AXIS_TIME_AXES];
    double change[AXIS_TIME_AXES], over; /* of the slope, over so much of the way */
};

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

/* What surely bounds no speed up to this feed: what each axis does for each length of the way, and
 * how much that changes over each length that it has for it.  Half of the feed and more are asked
 * about, for the feeds of a program are alike. */
struct unbound {
    double feed, slope[AXIS_TIME_AXES], change[AXIS_TIME_AXES];
    double rounding[AXIS_TIME_AXES]; /* of slopes no steeper */
};

static struct unbound unbound_at(const struct axis_time_limits *limits, double feed)
{
    const double spare = 1 + 1e-6; /* feeds that are alike but for rounding */
    struct unbound u = {.feed = feed * spare};
    double square = u.feed * u.feed, cube = square * u.feed;

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double jerk = limits->jerk[k] * limits->smoothing;
        u.slope[k] = limits->speed[k] / (spare * u.feed);
        u.change[k] = smaller(limits->acceleration[k] / square, jerk / cube) / spare;
        u.rounding[k] = 1e-12 * u.slope[k];
    }
    return u;
}

/* What each axis does up to a place, from the one before. */
struct step {
    double length, axis[AXIS_TIME_AXES];
};

static inline struct step step_to(const struct axis_time_place *to)
{
    struct step s = {.length = to->way - to[-1].way};

    for (int k = 0; k < AXIS_TIME_AXES; k++)
        s.axis[k] = to->axis[k] - to[-1].axis[k];
    return s;
}

/* In a step no axis is too fast. */
static inline bool is_slow(const struct unbound *u, const struct step *s)
{
    for (int k = 0; k < AXIS_TIME_AXES; k++)
        if (!(fabs(s->axis[k]) <= u->slope[k] * s->length))
            return false;
    return s->length > 0;
}

/* At a place between steps that are slow none changes too much: the slopes' difference times both
 * lengths, without a quotient. */
static inline bool is_even(const struct unbound *u, const struct axis_time_limits *limits,
                           const struct axis_time_place *at, const struct step *before,
                           const struct step *after)
{
    double both = before->length * after->length;
    double over = larger((at[1].way - at[-1].way) / 2, limits->smoothing);

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        double change = before->length * after->axis[k] - after->length * before->axis[k];
        if (!(fabs(change) <= (u->change[k] * over - u->rounding[k]) * both))
            return false;
    }
    return true;
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

/* The speeds at the places from `first` on but the last, with no more than what was before them in
 * mind: a way that is no slower at the place before bounds nothing.  At most places no axis bounds
 * it, which takes less to be told than the slopes. */
static void speeds_forth(const struct axis_time_limits *limits,
                         const struct axis_time_place place[], size_t first, size_t n, double v[])
{
    struct unbound u = {0};
    struct step before, after = {0};
    bool slow = false; /* up to this place */

    if (first + 1 < n)
        after = step_to(&place[first]);
    for (size_t i = first; i + 1 < n; i++) {
        double feed = smaller(place[i].feed, place[i + 1].feed);
        before = after;
        after = step_to(&place[i + 1]);
        if (!(feed <= u.feed && 2 * feed >= u.feed)) {
            u = unbound_at(limits, feed);
            slow = is_slow(&u, &before);
        }
        bool was_slow = slow;
        slow = is_slow(&u, &after);
        v[i] = feed;
        if (!was_slow || !slow || !is_even(&u, limits, &place[i], &before, &after)) {
            struct rates r = rates_at(limits, place, i, n);
            v[i] = speed_at(limits, &r, feed);
        }
        if (v[i] > v[i - 1]) {
            struct rates last = rates_at(limits, place, i - 1, n);
            v[i] = speed_after(limits, &last, v[i - 1], place[i].way - place[i - 1].way, v[i]);
        }
    }
}

/* And with what comes after them, from the speed at `to` back to that at `from`, which stays; each
 * becomes the seconds from the place before.  Returns their sum with the seconds before. */
static double seconds_back(const struct axis_time_limits *limits,
                           const struct axis_time_place place[], size_t n, size_t from, size_t to,
                           double v[], double sum)
{
    for (size_t i = to; i > from; i--) {
        if (v[i - 1] > v[i]) {
            struct rates r = rates_at(limits, place, i, n);
            v[i - 1] = speed_after(limits, &r, v[i], place[i].way - place[i - 1].way, v[i - 1]);
        }
        v[i] = step_seconds(limits, &place[i], v[i - 1], v[i]);
    }
    for (size_t i = from + 1; i <= to; i++)
        sum += v[i];
    return sum;
}

double axis_time_run(const struct axis_time_limits *limits, const struct axis_time_place place[],
                     size_t n, double step[])
{
    if (n < 2)
        return 0;
    step[0] = step[n - 1] = 0;
    speeds_forth(limits, place, 1, n, step);
    return seconds_back(limits, place, n, 0, n - 1, step, 0);
}

/* ---- the same while the way is being made */

enum { BLOCK = 256 }; /* places: they stay near */

/* Whatever comes, the speed at a place is not lowered by it: from there the axes come to any speed
 * up to the next one's before the next place.  The square of the speed that they may have is linear
 * in the next one's, in parts: it is least where these end. */
static bool is_settled(const struct axis_time_limits *limits, const struct axis_time_place place[],
                       size_t i, size_t n, const double v[])
{
    const double surely = 1 + 1e-9;
    struct rates r = rates_at(limits, place, i + 1, n);
    double length = place[i + 1].way - place[i].way;
    double wanted = surely * v[i] * v[i], most = v[i + 1] * v[i + 1];

    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        if (!(r.slope[k] > 0))
            continue;
        double a = limits->acceleration[k], b = bend_of(&r, k), twice = 2 * length / r.slope[k];
        double stop = twice * a, on = most + twice * fmax(0, a - b * most);
        if (stop < wanted || on < wanted || (a < b * most && a < b * wanted))
            return false;
    }
    return true;
}

/* The steps from one place that is kept to another: their seconds stand at their ends. */
static void tell_steps(const struct axis_time_way *w, size_t from, size_t to)
{
    for (size_t i = from + 1; i <= to && w->step; i++)
        w->step(w->context, w->item[i].mark, w->speed.item[i]);
}

/* The way up to the last settled place is done with. */
static void settle(struct axis_time_way *w)
{
    size_t n = w->n, last = n - 3;

    speeds_forth(&w->limits, w->item, w->known, n, w->speed.item);
    w->known = n - 1;
    while (last > w->from && !is_settled(&w->limits, w->item, last, n, w->speed.item))
        last--;
    if (last <= w->from)
        return;
    double v = w->speed.item[last];
    w->seconds = seconds_back(&w->limits, w->item, n, w->from, last, w->speed.item, w->seconds);
    tell_steps(w, w->from, last);
    w->speed.item[last] = v;
    w->n -= last - 1;
    w->known -= last - 1;
    w->from = 1;
    memmove(w->item, w->item + last - 1, w->n * sizeof *w->item);
    memmove(w->speed.item, w->speed.item + last - 1, w->n * sizeof *w->speed.item);
}

struct axis_time_place *axis_time_add(struct axis_time_way *w)
{
    if (w->n == w->cap) {
        if (w->n > 0)
            settle(w);
        array_reserve(w, w->n + w->n / 2 + BLOCK); /* half of them again, or it were square */
        array_reserve(&w->speed, w->cap);
    }
    if (w->n == 0)
        w->known = 1;
    w->speed.item[w->n] = 0;
    return &w->item[w->n++];
}

double axis_time_end(struct axis_time_way *w)
{
    double sum = w->seconds;

    if (w->n > 1) {
        speeds_forth(&w->limits, w->item, w->known, w->n, w->speed.item);
        w->speed.item[w->n - 1] = 0;
        sum = seconds_back(&w->limits, w->item, w->n, w->from, w->n - 1, w->speed.item, sum);
        tell_steps(w, w->from, w->n - 1);
    }
    w->n = w->from = 0;
    w->seconds = 0;
    return sum;
}

void axis_time_free(struct axis_time_way *w)
{
    array_free(w);
    array_free(&w->speed);
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

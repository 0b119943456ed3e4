/* machine_time - see machine_time.h. */
#include "simulate/machine_time.h"

#include <stdlib.h>

#include "base/array.h"

enum {
    WINDOW = 4,     /* steps in the length that is smoothed */
    RUN = 4000000,  /* steps after which a run ends as if the axes stood, so that memory does */
    MOST = 40000000 /* steps of a program, about: they are longer where it goes far */
};

#define STEP_LEAST 0.02 /* mm */
#define TIP_STANDS 1e-5 /* mm */
#define TURN_WAY 0.05   /* mm of way for each degree that the tool turns where the tip stands */

struct step {
    double q[NC_AXES];
    double feed; /* mm/s */
    size_t piece;
};

struct steps {
    size_t n, cap;
    struct step *item;
};

struct timing {
    const struct nc_motion *motion;
    const struct machine_time_options *options;
    struct axis_follow follow;
    double step; /* mm */
    struct steps steps;
    double *spent; /* of each piece: seconds */
    struct machine_time *time;
};

static double way_of(const struct axis_place *a, const struct axis_place *b)
{
    double turn = 0;
    for (int k = 3; k < NC_AXES; k++)
        turn = fmax(turn, fabs(b->axis[k] - a->axis[k]));
    return fmax(vec_distance(a->tip, b->tip), TURN_WAY * turn);
}

/* What F counts from one place to the next, mm: the tip's way, that of all axes, or degrees. */
static double said_way(const struct timing *t, bool tip, const struct axis_place *a,
                       const struct axis_place *b)
{
    double way = 0, degree = nc_motion_degree(t->motion);
    if (tip)
        return vec_distance(a->tip, b->tip);
    for (int k = t->options->limits->combined ? 0 : 3; k < NC_AXES; k++)
        way = hypot(way, (k < 3 ? 1 : degree) * (b->axis[k] - a->axis[k]));
    return way;
}

/* Lengths of a piece, from a few places on it, mm. */
struct ways {
    double way;  /* that it is followed by */
    double tip;  /* of the tip */
    double said; /* that F counts */
};

static struct ways ways_of_piece(const struct timing *t, size_t piece)
{
    enum { LOOKS = 8 };
    struct axis_follow follow = t->follow;
    struct axis_place place[LOOKS + 1];
    struct ways ways = {0};
    for (int i = 0; i <= LOOKS; i++)
        place[i] = axis_limits_place(&follow, piece, (double)i / LOOKS);
    for (int i = 0; i < LOOKS; i++) {
        ways.way += way_of(&place[i], &place[i + 1]);
        ways.tip += vec_distance(place[i].tip, place[i + 1].tip);
    }
    bool tip = !t->options->limits->combined && ways.tip > TIP_STANDS;
    for (int i = 0; i < LOOKS; i++)
        ways.said += said_way(t, tip, &place[i], &place[i + 1]);
    return ways;
}

/* Even steps along a piece at feed; what is left of the one before goes on in it.  The length. */
static double add_piece(struct timing *t, size_t piece, double *carry)
{
    const struct nc_piece *p = &t->motion->piece.item[piece];
    struct ways ways = ways_of_piece(t, piece);
    double way = ways.way, feed = p->feed * way / 60;
    if (!p->inverse)
        feed = ways.said > 0 ? feed / ways.said : 0;
    for (double at = t->step - *carry; at <= way; at += t->step) {
        struct axis_place place = axis_limits_place(&t->follow, piece, way > 0 ? at / way : 1);
        struct step *step = array_push(&t->steps);
        for (int k = 0; k < NC_AXES; k++)
            step->q[k] = place.axis[k];
        step->feed = feed;
        step->piece = piece;
    }
    axis_limits_place(&t->follow, piece, 1);
    *carry = fmod(*carry + way, t->step);
    if (feed > 0)
        t->time->programmed += ways.tip / feed / 60;
    return way;
}

/* Each place becomes the mean of those around it, as far as the control smooths. */
static void smooth_steps(struct timing *t)
{
    size_t n = t->steps.n;
    struct step *s = t->steps.item, *mean = mem_alloc(n, sizeof *mean);
    for (size_t i = 0; i < n; i++) {
        size_t half = WINDOW / 2, from, to;
        half = i < half ? i : half;
        half = n - 1 - i < half ? n - 1 - i : half;
        from = i - half;
        to = i + half;
        mean[i] = s[i];
        for (int k = 0; k < NC_AXES; k++) {
            double sum = 0;
            for (size_t j = from; j <= to; j++)
                sum += s[j].q[k];
            mean[i].q[k] = sum / (double)(to - from + 1);
        }
    }
    free(t->steps.item);
    t->steps.item = mean;
    t->steps.cap = n;
}

/* First to third difference quotients of an axis at a step. */
static void slopes(const struct timing *t, size_t i, int k, double d[3])
{
    const struct step *s = t->steps.item;
    size_t n = t->steps.n, a = i > 0 ? i - 1 : 0, b = i + 1 < n ? i + 1 : n - 1,
           c = i + 2 < n ? i + 2 : n - 1;
    double h = t->step;
    d[0] = b > a ? (s[b].q[k] - s[a].q[k]) / ((double)(b - a) * h) : 0;
    d[1] = b == i + 1 && a + 1 == i ? (s[b].q[k] - 2 * s[i].q[k] + s[a].q[k]) / (h * h) : 0;
    d[2] = c == i + 2 && a + 1 == i
               ? (s[c].q[k] - 3 * s[b].q[k] + 3 * s[i].q[k] - s[a].q[k]) / (h * h * h)
               : 0;
}

/* The fastest at a step, by feed, speeds, and what bends cost. */
static double speed_limit(const struct timing *t, size_t i)
{
    const struct machine_time_options *o = t->options;
    double v = t->steps.item[i].feed;
    for (int k = 0; k < NC_AXES; k++) {
        double d[3];
        slopes(t, i, k, d);
        if (d[0] != 0)
            v = fmin(v, o->limits->rapid[k] / 60 / fabs(d[0]));
        if (d[1] != 0)
            v = fmin(v, sqrt(o->acceleration[k] / fabs(d[1])));
        if (d[2] != 0)
            v = fmin(v, cbrt(o->jerk[k] / fabs(d[2])));
    }
    return v;
}

/* How fast v may change at a step, mm/s^2. */
static double change_limit(const struct timing *t, size_t i, double v)
{
    const struct machine_time_options *o = t->options;
    double most = HUGE_VAL;
    for (int k = 0; k < NC_AXES; k++) {
        double d[3];
        slopes(t, i, k, d);
        if (fabs(d[0]) > 1e-9)
            most = fmin(most, fmax(0, o->acceleration[k] - fabs(d[1]) * v * v) / fabs(d[0]));
    }
    return isfinite(most) ? most : 0;
}

/* What the jerk adds to the time of a change of speed by dv at so much acceleration, seconds. */
static double jerk_time(const struct timing *t, double dv, double seconds)
{
    double jerk = t->options->jerk[0], acceleration = seconds > 0 ? dv / seconds : 0;
    for (int k = 1; k < 3; k++)
        jerk = fmin(jerk, t->options->jerk[k]);
    if (acceleration <= 0)
        return 0;
    if (dv >= acceleration * acceleration / jerk)
        return acceleration / jerk;
    return fmax(0, 2 * sqrt(dv / jerk) - seconds);
}

static double step_seconds(double a, double b, double h)
{
    return 2 * h / fmax(a + b, 1e-9);
}

/* Speeds from standstill to standstill, and the time that they take. */
static void time_steps(struct timing *t)
{
    size_t n = t->steps.n;
    double h = t->step, ramp_from = 0, ramp_seconds = 0;
    int sense = 1;
    if (n < 2)
        return;
    double *v = mem_alloc(n, sizeof *v);
    for (size_t i = 0; i < n; i++)
        v[i] = speed_limit(t, i);
    v[0] = v[n - 1] = 0;
    for (size_t i = 1; i < n; i++)
        v[i] = fmin(v[i], sqrt(v[i - 1] * v[i - 1] + 2 * h * change_limit(t, i - 1, v[i - 1])));
    for (size_t i = n - 1; i > 0; i--)
        v[i - 1] = fmin(v[i - 1], sqrt(v[i] * v[i] + 2 * h * change_limit(t, i, v[i])));
    for (size_t i = 1; i < n; i++) {
        double seconds = step_seconds(v[i - 1], v[i], h), feed = t->steps.item[i].feed;
        int now = v[i] > v[i - 1] ? 1 : v[i] < v[i - 1] ? -1 : 0;
        if (now != sense || i + 1 == n) {
            bool stands = ramp_from == 0 || (i + 1 == n && v[i] == 0);
            double more = stands ? jerk_time(t, fabs(v[i - 1] - ramp_from), ramp_seconds) : 0;
            t->spent[t->steps.item[i].piece] += more;
            t->time->least += more / 60;
            ramp_from = v[i - 1];
            ramp_seconds = 0;
            sense = now;
        }
        ramp_seconds += seconds;
        t->spent[t->steps.item[i].piece] += seconds;
        t->time->least += seconds / 60;
        if ((v[i] + v[i - 1]) / 2 < feed / 2)
            t->time->slow += h;
    }
    free(v);
}

/* One rapid move, from standstill to standstill by its slowest axis. */
static void time_rapid(struct timing *t, size_t piece)
{
    const struct machine_time_options *o = t->options;
    struct axis_place a = axis_limits_place(&t->follow, piece, 0);
    struct axis_place b = axis_limits_place(&t->follow, piece, 1);
    double most = 0;
    for (int k = 0; k < NC_AXES; k++) {
        double way = fabs(b.axis[k] - a.axis[k]), fast = o->limits->rapid[k] / 60,
               acc = o->acceleration[k];
        double seconds = way >= fast * fast / acc ? way / fast + fast / acc : 2 * sqrt(way / acc);
        most = fmax(most, way > 0 ? seconds + acc / o->jerk[k] : 0);
    }
    t->time->rapid += most / 60;
}

static void end_run(struct timing *t, double *carry)
{
    if (t->steps.n > 0) {
        smooth_steps(t);
        time_steps(t);
    }
    t->steps.n = 0;
    *carry = 0;
}

/* Turns, the share of each piece, and which lose most. */
static void sum_pieces(struct timing *t, const double *ideal)
{
    struct machine_time *time = t->time;
    for (size_t i = 0; i < t->motion->piece.n; i++) {
        double lost = t->spent[i] - ideal[i];
        time->share[i] = (float)(t->spent[i] > ideal[i] ? ideal[i] / t->spent[i] : 1);
        int k = MACHINE_TIME_WORST - 1;
        if (lost <= time->lost[k])
            continue;
        for (; k > 0 && time->lost[k - 1] < lost; k--) {
            time->lost[k] = time->lost[k - 1];
            time->worst[k] = time->worst[k - 1];
        }
        time->lost[k] = lost;
        time->worst[k] = i;
    }
}

static void add_turns(struct timing *t, const struct axis_place *a, const struct axis_place *b)
{
    for (int k = 3; k < NC_AXES; k++)
        t->time->turn[k] += fabs(b->axis[k] - a->axis[k]);
}

/* By the ends of the pieces at feed: the steps of a program of many kilometres are longer. */
static double step_of(const struct nc_motion *motion, double smoothing)
{
    struct axis_follow follow = {motion, {0, 0}};
    double way = 0;

    for (size_t i = 0; i < motion->piece.n; i++) {
        struct axis_place a = axis_limits_place(&follow, i, 0),
                          b = axis_limits_place(&follow, i, 1);
        way += motion->piece.item[i].rapid ? 0 : way_of(&a, &b);
    }
    return fmax(fmax(smoothing / WINDOW, STEP_LEAST), way / MOST);
}

struct machine_time machine_time_of(const struct nc_motion *motion,
                                    const struct machine_time_options *options)
{
    struct machine_time time = {0};
    struct timing t = {.motion = motion, .options = options, .time = &time};
    size_t n = motion->piece.n;
    double carry = 0, cut = 0, *ideal = mem_alloc(n, sizeof *ideal);
    t.follow = (struct axis_follow){motion, {0, 0}};
    t.step = step_of(motion, options->smoothing);
    t.spent = mem_alloc(n, sizeof *t.spent);
    time.share = mem_alloc(n, sizeof *time.share);
    for (size_t i = 0; i < n; i++) {
        struct axis_follow before = t.follow;
        struct axis_place a = axis_limits_place(&before, i, 0),
                          b = axis_limits_place(&before, i, 1);
        double programmed = time.programmed;
        add_turns(&t, &a, &b);
        if (motion->piece.item[i].rapid) {
            end_run(&t, &carry);
            time_rapid(&t, i);
        } else {
            cut += add_piece(&t, i, &carry);
        }
        if (t.steps.n >= RUN)
            end_run(&t, &carry);
        ideal[i] = 60 * (time.programmed - programmed);
    }
    end_run(&t, &carry);
    time.slow = cut > 0 ? time.slow / cut : 0;
    sum_pieces(&t, ideal);
    array_free(&t.steps);
    free(ideal);
    free(t.spent);
    return time;
}

void machine_time_free(struct machine_time *time)
{
    free(time->share);
    *time = (struct machine_time){0};
}

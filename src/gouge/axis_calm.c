/* axis_calm - see axis_calm.h. */
#include "gouge/axis_calm.h"

#include <stdlib.h>

#include "gouge/axis_smooth.h"
#include "gouge/holder_sweep.h"
#include "machine/rotary_cost.h"

enum { SWEEPS = 4, ROUNDS = 4, HALVINGS = 7 };

static const double WIDEST = 24;       /* mm: first half length of averages, halved each time */
static const double NARROW = 4;        /* mm: from here on axes may use what is spared of play */
static const double NARROWEST = 1;     /* mm: none is shorter */
static const double OVER = 0.7;        /* of the radius: rules are averaged over so much, twice */
static const double AIR = RADIANS(60); /* how far axes in the air may be off those they had */
static const double STEEPEST = RADIANS(80); /* of an axis from the normal */
static const double RAMP = 1.5; /* radii of the ball: from a place that stays to what is calm */
static const double SPARE = RADIANS(0.6); /* of play, for rounding off where its bound turns */
static const double POLE = 1e-9; /* radians: an axis that leans less is at the pole, and stays */

/* A point of the chain. */
struct station {
    struct run_point *point;
    double along; /* the path of the ball's centre, mm */
    struct vec3 rule;
    double allow; /* how far the axis may be off it, radians */
    struct rotary_angles was, angles;
    bool begins; /* of a run */
    double part; /* of the way from `was` to `angles`, 0 to 1 */
};

struct chain {
    const struct axis_calm_options *options;
    struct rotary_frame frame;
    struct station *at;
    size_t n;
    double spare; /* how much further off its rule an axis may be now, radians */
};

/* The rules of a run, averaged. */
static struct vec3 *rules_of(const struct axis_calm_run *run, double half)
{
    struct vec3 *rule = mem_alloc(run->n, sizeof *rule);

    for (size_t i = 0; i < run->n; i++)
        rule[i] = run->rule[i];
    axis_smooth_rules(run->point, run->n, half, rule);
    return rule;
}

static struct chain chain_of(const struct axis_calm_options *options,
                             const struct axis_calm_run run[], size_t n)
{
    struct chain c = {.options = options, .frame = rotary_frame_of(&options->chain)};
    struct rotary_angles last = {0, 0};

    for (size_t k = 0; k < n; k++)
        c.n += run[k].n;
    c.at = mem_alloc(c.n, sizeof *c.at);
    for (size_t k = 0, i = 0; k < n; k++) {
        struct vec3 *rules = rules_of(&run[k], OVER * options->radius);
        for (size_t j = 0; j < run[k].n; j++, i++) {
            struct run_point *p = &run[k].point[j];
            struct vec3 rule = run_point_touches(p) ? rules[j] : p->axis;
            c.at[i] = (struct station){.point = p, .rule = rule, .begins = j == 0};
            if (i > 0)
                c.at[i].along = c.at[i - 1].along + vec_distance(c.at[i - 1].point->ball, p->ball);
            else
                last.turn = rotary_angles_near(&c.frame, p->axis, last).turn;
            c.at[i].was = c.at[i].angles = last = rotary_angles_near(&c.frame, p->axis, last);
        }
        free(rules);
    }
    for (size_t i = 0; i < c.n; i++) {
        const struct run_point *p = c.at[i].point;
        double play = run_point_touches(p) ? fmax(options->play - SPARE, 0) : AIR;
        c.at[i].allow = fmax(play, vec_angle(p->axis, c.at[i].rule));
    }
    return c;
}

/* The station may have the angles, as far as no guard is asked. */
static bool may_have(const struct chain *c, const struct station *s, struct rotary_angles a)
{
    struct vec3 axis = rotary_axis(&c->frame, a), normal = s->point->normal;

    if (a.lean * s->was.lean <= 0 || vec_dot(axis, s->rule) < cos(s->allow + c->spare))
        return false;
    return !run_point_touches(s->point) ||
           vec_dot(axis, normal) >= fmin(cos(STEEPEST), vec_dot(s->point->axis, normal));
}

/* The station's angles towards `to`, as far as it may have them. */
static void move_towards(const struct chain *c, struct station *s, struct rotary_angles to)
{
    struct rotary_angles was = s->angles;
    double from = 0, part = 1;

    if (fabs(to.lean - was.lean) + fabs(to.turn - was.turn) < 1e-9)
        return;
    for (int k = 0; k < HALVINGS && from < part; k++) { /* evenly along the bound, too */
        struct rotary_angles a = {was.lean + part * (to.lean - was.lean),
                                  was.turn + part * (to.turn - was.turn)};
        bool may = may_have(c, s, a);
        if (may)
            s->angles = a;
        if (may && k == 0)
            return;
        double half = fabs(part - from) / 2;
        from = may ? part : from;
        part = may ? part + half : part - half;
    }
}

/* The integral of the angles up to a place between the stations i and i + 1. */
static struct rotary_angles integral_at(const struct chain *c, const struct rotary_angles sum[],
                                        size_t i, double along)
{
    const struct station *a = &c->at[i], *b = i + 1 < c->n ? a + 1 : a;
    double length = b->along - a->along, by = along - a->along;
    double s = length > 0 ? by / length : 0;

    return (struct rotary_angles){
        sum[i].lean + by * (a->angles.lean + s / 2 * (b->angles.lean - a->angles.lean)),
        sum[i].turn + by * (a->angles.turn + s / 2 * (b->angles.turn - a->angles.turn))};
}

/* Each station's angles to the mean over `half` mm before and after it, less near the ends. */
static void average_angles(struct chain *c, double half)
{
    struct rotary_angles *sum = mem_alloc(c->n + 1, sizeof *sum);
    struct rotary_angles *mean = mem_alloc(c->n + 1, sizeof *mean);
    struct station *at = c->at;
    double end = at[c->n - 1].along;

    for (size_t i = 0; i + 1 < c->n; i++) { /* integrals up to station i */
        double length = at[i + 1].along - at[i].along;
        sum[i + 1].lean = sum[i].lean + length * (at[i].angles.lean + at[i + 1].angles.lean) / 2;
        sum[i + 1].turn = sum[i].turn + length * (at[i].angles.turn + at[i + 1].angles.turn) / 2;
    }
    for (size_t i = 0, low = 0, high = 0; i < c->n; i++) {
        double reach = fmin(half, fmin(at[i].along, end - at[i].along));
        double from = at[i].along - reach, to = at[i].along + reach;
        while (low > 0 && at[low].along > from)
            low--;
        while (low + 1 < c->n && at[low + 1].along <= from)
            low++;
        while (high > 0 && at[high].along > to)
            high--;
        while (high + 1 < c->n && at[high + 1].along <= to)
            high++;
        struct rotary_angles a = integral_at(c, sum, low, from), b = integral_at(c, sum, high, to);
        mean[i] = at[i].angles;
        if (reach > 1e-6)
            mean[i] = (struct rotary_angles){(b.lean - a.lean) / (2 * reach),
                                             (b.turn - a.turn) / (2 * reach)};
    }
    for (size_t i = 0; i < c->n; i++)
        if (fabs(at[i].was.lean) > POLE)
            move_towards(c, &at[i], mean[i]);
    free(sum);
    free(mean);
}

/* ---- kept clear */

/* The station's angles when it has gone so far from those that it had. */
static struct rotary_angles angles_at(const struct station *s, double part)
{
    return (struct rotary_angles){s->was.lean + part * (s->angles.lean - s->was.lean),
                                  s->was.turn + part * (s->angles.turn - s->was.turn)};
}

/* The point as it is for this part of the way. */
static struct run_point point_of(const struct chain *c, const struct station *s)
{
    struct run_point p = *s->point;

    if (s->part > 0) {
        p.axis = rotary_axis(&c->frame, angles_at(s, s->part));
        p.tip = vec_along(p.ball, -c->options->radius, p.axis);
    }
    return p;
}

/* The stations at which the tool would not be clear, or swing the ball off its straight line. */
static size_t find_bad(const struct chain *c, bool bad[])
{
    const double far = 1; /* mm: clearances beyond are all the same */
    const struct axis_calm_options *o = c->options;
    const struct holder_sweep sweep = {o->guard, o->holder, o->tolerance / 2};
    double before = 0, swing = sqrt(0.8 * o->tolerance / o->radius);
    struct run_point last = {.given = false};
    size_t found = 0;

    for (size_t i = 0; i < c->n; i++) {
        const struct station *s = &c->at[i];
        struct run_point p = point_of(c, s);
        bool joined = i > 0 && !s->begins && (s->part > 0 || s[-1].part > 0);
        double now = holder_sweep_clearance(&sweep, &p, far);
        bad[i] = s->part > 0 && (now < -sweep.slack || !rotary_reaches(&o->chain, p.axis));
        if (joined && !bad[i] && !(i > 0 && bad[i - 1])) {
            double turned = vec_angle(last.axis, p.axis);
            bool swings =
                turned > swing && turned > vec_angle(s[-1].point->axis, s->point->axis) + 1e-9;
            bad[i] = swings || (fmin(before, now) >= -sweep.slack &&
                                !holder_sweep_clear_between(&sweep, &last, before, &p, now));
        }
        found += bad[i];
        last = p;
        before = now;
    }
    return found;
}

/* The stations beside bad ones stay as they were, those further off by the ramp are calm. */
static void hold_back(struct chain *c, const bool bad[], double ramp)
{
    double last = -HUGE_VAL;

    for (size_t i = 0; i < c->n; i++) {
        if (bad[i] || (i + 1 < c->n && bad[i + 1]))
            last = c->at[i].along;
        c->at[i].part = fmin(c->at[i].part, fmax(0, (c->at[i].along - last) / ramp - 0.25));
    }
    last = HUGE_VAL;
    for (size_t i = c->n; i-- > 0;) {
        if (bad[i] || (i + 1 < c->n && bad[i + 1]))
            last = c->at[i].along;
        c->at[i].part = fmin(c->at[i].part, fmax(0, (last - c->at[i].along) / ramp - 0.25));
    }
}

/* How far the axes turn over the chain. */
static double travel_of(const struct chain *c, bool calm)
{
    double sum = 0;

    for (size_t i = 1; i < c->n; i++) {
        struct rotary_angles a = angles_at(&c->at[i - 1], calm ? c->at[i - 1].part : 0);
        struct rotary_angles b = angles_at(&c->at[i], calm ? c->at[i].part : 0);
        sum += fabs(a.lean - b.lean) + fabs(a.turn - b.turn);
    }
    return sum;
}

/* Runs with bad stations are as they were. */
static void put_back(struct chain *c, const bool bad[])
{
    for (size_t from = 0, to; from < c->n; from = to) {
        bool any = bad[from];
        for (to = from + 1; to < c->n && !c->at[to].begins; to++)
            any = any || bad[to];
        for (size_t i = from; i < to && any; i++)
            c->at[i].part = 0;
    }
}

static void keep_clear(struct chain *c)
{
    bool *bad = mem_alloc(c->n, sizeof *bad);
    size_t found = 1;

    for (size_t i = 0; i < c->n; i++)
        c->at[i].part = fabs(c->at[i].was.lean) > POLE ? 1 : 0;
    for (int round = 0; round < ROUNDS && found > 0; round++) {
        found = find_bad(c, bad);
        if (found > 0)
            hold_back(c, bad, RAMP * c->options->radius * (1 << round));
    }
    if (found > 0 && find_bad(c, bad) > 0)
        put_back(c, bad);
    if (travel_of(c, true) >= travel_of(c, false))
        for (size_t i = 0; i < c->n; i++)
            c->at[i].part = 0;
    free(bad);
}

void axis_calm_chain(const struct axis_calm_options *options, const struct axis_calm_run run[],
                     size_t n)
{
    struct chain c = chain_of(options, run, n);

    for (double half = WIDEST; half > NARROW; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(&c, half);
    c.spare = SPARE;
    for (double half = NARROW; half >= NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(&c, half);
    keep_clear(&c);
    for (size_t i = 0; i < c.n; i++)
        *c.at[i].point = point_of(&c, &c.at[i]);
    free(c.at);
}

/* axis_calm - see axis_calm.h. */
#include "gouge/axis_calm.h"

#include <stdlib.h>

#include "axis_chain.h"
#include "base/parallel.h"

enum { SWEEPS = 4, ROUNDS = 4, HALVINGS = 7 };

static const double WIDEST = 24;   /* mm: first half length of averages, halved each time */
static const double NARROW = 4;    /* mm: from here on axes may use what is spared of play */
static const double NARROWEST = 1; /* mm: none is shorter */
static const double RAMP = 1.5;    /* radii of the ball: from a place that stays to what is calm */
static const double TIGHTER = 0.4; /* of the way: that a bad station keeps, each time */
static const double SLACKENS = RADIANS(1); /* each mm from one */
static const double LOOSE = RADIANS(12);   /* as far as that */
static const double POLE_FLAT = 6;         /* mm: so near the pole the turn stays */
static const double POLE_WIDE = 20;        /* mm: so far it is led to that */

/* The station's angles towards `to`, as far as it may have them. */
static void move_towards(const struct axis_chain *c, struct axis_station *s,
                         struct rotary_angles to)
{
    struct rotary_angles was = s->angles;
    double from = 0, part = 1;

    if (fabs(to.lean - was.lean) + fabs(to.turn - was.turn) < 1e-9)
        return;
    for (int k = 0; k < HALVINGS && from < part; k++) { /* evenly along the bound, too */
        struct rotary_angles a = {was.lean + part * (to.lean - was.lean),
                                  was.turn + part * (to.turn - was.turn)};
        bool may = axis_chain_may_have(c, s, a);
        if (may)
            s->angles = a;
        if (may && k == 0)
            return;
        double half = fabs(part - from) / 2;
        from = may ? part : from;
        part = may ? part + half : part - half;
    }
}

/* What the threads share that move stations. */
struct averaging {
    struct axis_chain *chain;
    const struct rotary_angles *mean;
    bool held;
};

static void average_some(void *context, size_t from, size_t to)
{
    const struct averaging *a = context;
    struct axis_station *at = a->chain->at;

    for (size_t i = from; i < to; i++)
        if (!axis_chain_at_pole(&at[i]) && (!a->held || at[i].far < HUGE_VAL))
            move_towards(a->chain, &at[i], a->mean[i]);
}

/* Each station's angles to the mean, or those of the held ones alone. */
static void average_angles(struct axis_chain *c, double half, bool held)
{
    struct rotary_angles *mean = axis_chain_means(c, half);
    struct averaging averaging = {c, mean, held};

    parallel_for(axis_chain_threads(c), c->n, average_some, &averaging);
    free(mean);
}

/* ---- through the pole */

/* How much of its own turn an axis keeps at this distance from the pole: none beside it. */
static double own_turn(double away)
{
    double s = fmin(fmax((away - POLE_FLAT) / (POLE_WIDE - POLE_FLAT), 0), 1);

    return s * s * (3 - 2 * s);
}

/* The stations to one side of a station at the pole come to its turn. */
static void meet_turn(struct axis_chain *c, size_t pole, double turn, bool after)
{
    for (size_t k = 1; after ? pole + k < c->n : k <= pole; k++) {
        struct axis_station *s = &c->at[after ? pole + k : pole - k];
        double away = fabs(s->along - c->at[pole].along);
        struct rotary_angles to = {s->angles.lean, turn + own_turn(away) * (s->angles.turn - turn)};
        if (away >= POLE_WIDE || axis_chain_at_pole(s))
            return;
        move_towards(c, s, to);
    }
}

/* The pole is passed at one turn, which is that on both sides of it: else an axis would have to
 * turn there while the tool hardly moves. */
static void fix_poles(struct axis_chain *c)
{
    for (size_t i = 1; i + 1 < c->n; i++) {
        const struct axis_station *s = &c->at[i];
        double turn = (s[-1].angles.turn + s[1].angles.turn) / 2;
        if (!axis_chain_at_pole(s) || fabs(s[1].angles.turn - s[-1].angles.turn) > RADIANS(60))
            continue;
        meet_turn(c, i, turn, false);
        meet_turn(c, i, turn, true);
        c->at[i].angles.turn = turn;
    }
}

/* ---- kept clear */

/* How far each station is off the axis that it had, radians, and what the threads share for it. */
struct leaving {
    const struct axis_chain *chain;
    double *off;
};

static void measure_off(void *context, size_t from, size_t to)
{
    const struct leaving *l = context;

    for (size_t i = from; i < to; i++) {
        const struct axis_station *s = &l->chain->at[i];
        l->off[i] = vec_angle(rotary_axis(&l->chain->frame, s->angles), s->point->axis);
    }
}

/* Bad stations, and less and less those about them, may be no further off what they were than part
 * of the way that they have gone. */
static void tighten(struct axis_chain *c)
{
    double *far = mem_alloc(c->n, sizeof *far), *off = mem_alloc(c->n, sizeof *off);
    double last = HUGE_VAL;
    struct leaving leaving = {c, off};

    parallel_for(axis_chain_threads(c), c->n, measure_off, &leaving);
    for (size_t i = 0; i < c->n; i++) {
        const struct axis_station *s = &c->at[i];
        bool bad = s->bad || (i + 1 < c->n && s[1].bad);
        far[i] = bad ? TIGHTER * fmin(off[i], s->far) : s->far;
        far[i] = last = fmin(far[i], last + (i > 0 ? SLACKENS * (s->along - s[-1].along) : 0));
    }
    for (size_t i = c->n; i-- > 0;) {
        struct axis_station *s = &c->at[i];
        if (i + 1 < c->n)
            far[i] = fmin(far[i], far[i + 1] + SLACKENS * (s[1].along - s->along));
        s->far = far[i] < LOOSE ? far[i] : s->far;
        if (off[i] > s->far)
            s->angles = axis_chain_angles(s, 0.99 * s->far / off[i]);
    }
    free(far);
    free(off);
    for (double half = NARROW; half >= NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(c, half, true);
}

/* The stations beside bad ones stay as they were, those further off by the ramp are calm. */
static void hold_back(struct axis_chain *c, double ramp)
{
    double last = -HUGE_VAL;

    for (size_t i = 0; i < c->n; i++) {
        if (c->at[i].bad || (i + 1 < c->n && c->at[i + 1].bad))
            last = c->at[i].along;
        c->at[i].part = fmin(c->at[i].part, fmax(0, (c->at[i].along - last) / ramp - 0.25));
    }
    last = HUGE_VAL;
    for (size_t i = c->n; i-- > 0;) {
        if (c->at[i].bad || (i + 1 < c->n && c->at[i + 1].bad))
            last = c->at[i].along;
        c->at[i].part = fmin(c->at[i].part, fmax(0, (last - c->at[i].along) / ramp - 0.25));
    }
}

/* How far the axes turn over the chain. */
static double travel_of(const struct axis_chain *c, bool calm)
{
    double sum = 0;

    for (size_t i = 1; i < c->n; i++) {
        struct rotary_angles a = axis_chain_angles(&c->at[i - 1], calm ? c->at[i - 1].part : 0);
        struct rotary_angles b = axis_chain_angles(&c->at[i], calm ? c->at[i].part : 0);
        sum += fabs(a.lean - b.lean) + fabs(a.turn - b.turn);
    }
    return sum;
}

static void keep_clear(struct axis_chain *c)
{
    size_t found = 1;

    for (size_t i = 0; i < c->n; i++)
        c->at[i].part = axis_chain_at_pole(&c->at[i]) ? 0 : 1;
    for (int round = 0; round < ROUNDS && (found = axis_chain_find_bad(c)) > 0; round++)
        tighten(c);
    /* a ramp longer than the chain leaves nothing moved */
    for (double ramp = RAMP * c->options->radius; found > 0; ramp *= 2) {
        found = axis_chain_find_bad(c);
        if (found > 0)
            hold_back(c, ramp);
    }
    if (travel_of(c, true) >= travel_of(c, false))
        for (size_t i = 0; i < c->n; i++)
            c->at[i].part = 0;
    axis_chain_ease(c);
}

void axis_calm_chain(const struct axis_calm_options *options, const struct axis_calm_run run[],
                     size_t n)
{
    struct axis_chain c = axis_chain_of(options, run, n);

    for (double half = WIDEST; half > NARROW; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(&c, half, false);
    c.spare = AXIS_CHAIN_SPARE;
    for (double half = NARROW; half >= NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(&c, half, false);
    c.spare = 2 * AXIS_CHAIN_SPARE;
    fix_poles(&c);
    average_angles(&c, NARROWEST, false);
    keep_clear(&c);
    axis_chain_lead_to_lone(&c);
    for (size_t i = 0; i < c.n; i++)
        *c.at[i].point = axis_chain_point(&c, &c.at[i]);
    free(c.at);
}

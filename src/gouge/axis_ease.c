/* axis_ease - see axis_chain.h, axis_chain_ease. */
#include <stdlib.h>

#include "axis_chain.h"
#include "base/parallel.h"

enum { SWEEPS = 2 };

static const double WIDEST = 16;     /* mm: first half length of averages, halved each time */
static const double NARROWEST = 1;   /* mm: and none is shorter */
static const double BESIDE = 24;     /* mm: so near to a held station others are eased, too */
static const double BESIDE_POLE = 3; /* mm: and none is so near to the pole */
static const double SLACKENS =
    0.03; /* radians for each mm: from an axis that is far off its rule */

/* The station's angles, and the guard asked for them. */
static bool is_station_clear(const struct axis_chain *c, const struct holder_sweep *sweep,
                             struct axis_station *s)
{
    struct vec3 axis = axis_chain_point(c, s).axis;

    return axis_chain_clearance(c, sweep, s, axis, false) >= -sweep->slack &&
           rotary_reaches(&c->options->chain, axis);
}

/* A station as far towards the mean as it stays clear there. */
static void ease_station(const struct axis_chain *c, const struct holder_sweep *sweep,
                         struct axis_station *s, struct rotary_angles mean)
{
    enum { PARTS = 3 };
    struct rotary_angles old = s->angles;
    double part0 = s->part, part = 1;

    if (fabs(mean.lean - old.lean) + fabs(mean.turn - old.turn) < 1e-6)
        return;
    for (int k = 0; k < PARTS; k++, part /= 2) {
        struct rotary_angles to = {old.lean + part * (mean.lean - old.lean),
                                   old.turn + part * (mean.turn - old.turn)};
        if (!axis_chain_may_have(c, s, to))
            continue;
        s->angles = to;
        s->part = 1;
        if (is_station_clear(c, sweep, s))
            return;
    }
    s->angles = old;
    s->part = part0;
}

/* Those that are bad now, and those they are bad with, are as they were. */
static void take_back(struct axis_chain *c, const struct rotary_angles *old, const double *part)
{
    while (axis_chain_find_bad(c) > 0) {
        size_t back = 0;
        for (size_t i = 0; i < c->n; i++)
            for (size_t k = i > 0 ? i - 1 : i; c->at[i].bad && k <= i; k++) {
                back += !axis_chain_same(c->at[k].angles, old[k]) || c->at[k].part != part[k];
                c->at[k].angles = old[k];
                c->at[k].part = part[k];
            }
        if (back == 0)
            return;
    }
}

/* All as it was before, if any is bad now. */
static void take_all_back(struct axis_chain *c, const struct axis_station *before)
{
    if (axis_chain_find_bad(c) > 0)
        for (size_t i = 0; i < c->n; i++)
            c->at[i] = before[i];
}

/* What the threads share that ease stations. */
struct easing {
    struct axis_chain *chain;
    const bool *eased;
    const struct rotary_angles *mean;
    struct rotary_angles *old;
    double *part;
};

static void ease_some(void *context, size_t from, size_t to)
{
    const struct easing *e = context;
    const struct axis_calm_options *o = e->chain->options;
    const struct holder_sweep sweep = {o->guard, o->holder, o->tolerance / 2};

    for (size_t i = from; i < to; i++) {
        struct axis_station *s = &e->chain->at[i];
        e->old[i] = s->angles;
        e->part[i] = s->part;
        if (e->eased[i])
            ease_station(e->chain, &sweep, s, e->mean[i]);
    }
}

static void ease(struct axis_chain *c, const bool *eased)
{
    struct easing e = {.chain = c, .eased = eased};

    e.old = mem_alloc(c->n, sizeof *e.old);
    e.part = mem_alloc(c->n, sizeof *e.part);
    for (double half = WIDEST; half >= NARROWEST; half /= 2)
        for (int k = 0; k < SWEEPS; k++) {
            struct rotary_angles *mean = axis_chain_means(c, half);
            e.mean = mean;
            parallel_for(axis_chain_threads(c), c->n, ease_some, &e);
            take_back(c, e.old, e.part);
            free(mean);
        }
    free(e.old);
    free(e.part);
}

static bool is_held(const struct axis_station *s)
{
    return !axis_chain_at_pole(s) && (s->part < 1 || s->far < HUGE_VAL);
}

/* Marks the stations that are no further than `beside` from one for which `is` holds. */
static void mark_beside(const struct axis_chain *c, bool (*is)(const struct axis_station *),
                        double beside, bool *marked)
{
    double last = -HUGE_VAL;

    for (size_t i = 0; i < c->n; i++) {
        last = is(&c->at[i]) ? c->at[i].along : last;
        marked[i] = c->at[i].along - last < beside;
    }
    last = HUGE_VAL;
    for (size_t i = c->n; i-- > 0;) {
        last = is(&c->at[i]) ? c->at[i].along : last;
        marked[i] = marked[i] || last - c->at[i].along < beside;
    }
}

/* The stations near those that were held back, but for those beside the pole, where the turn is as
 * it has to be; false if there are none. */
static bool find_eased(const struct axis_chain *c, bool *eased)
{
    bool *by_pole = mem_alloc(c->n, sizeof *by_pole), any = false;

    mark_beside(c, is_held, BESIDE, eased);
    mark_beside(c, axis_chain_at_pole, BESIDE_POLE, by_pole);
    for (size_t i = 0; i < c->n; i++) {
        eased[i] = eased[i] && !by_pole[i];
        any = any || eased[i];
    }
    free(by_pole);
    return any;
}

/* How far the axes beside a station may be off their rule for its sake: in the air it has none. */
static double loosens(const struct axis_station *s)
{
    return run_point_touches(s->point) ? s->allow : 0;
}

static void slacken(struct axis_chain *c)
{
    struct axis_station *at = c->at;
    double from = 0;

    for (size_t i = 0; i < c->n; i++) {
        from -= i > 0 ? SLACKENS * (at[i].along - at[i - 1].along) : 0;
        from = fmax(from, loosens(&at[i]));
        at[i].allow = fmax(at[i].allow, from);
    }
    from = 0;
    for (size_t i = c->n; i-- > 0;) {
        from -= i + 1 < c->n ? SLACKENS * (at[i + 1].along - at[i].along) : 0;
        from = fmax(from, loosens(&at[i]));
        at[i].allow = fmax(at[i].allow, from);
    }
}

void axis_chain_ease(struct axis_chain *c)
{
    bool *eased = mem_alloc(c->n, sizeof *eased), any = find_eased(c, eased);

    for (size_t i = 0; i < c->n; i++) {
        struct axis_station *s = &c->at[i];
        s->angles = axis_chain_angles(s, s->part);
        s->part = s->part > 0 ? 1 : 0;
        s->far = HUGE_VAL;
    }
    slacken(c);
    if (any) {
        struct axis_station *before = mem_alloc(c->n, sizeof *before);
        for (size_t i = 0; i < c->n; i++)
            before[i] = c->at[i];
        ease(c, eased);
        take_all_back(c, before);
        free(before);
    }
    free(eased);
}

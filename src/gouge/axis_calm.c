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
static const double OVER = 1.4;        /* of the radius: rules are averaged over so much, twice */
static const double AIR = RADIANS(60); /* how far axes in the air may be off those they had */
static const double STEEPEST = RADIANS(80); /* of an axis from the normal */
static const double RAMP = 1.5; /* radii of the ball: from a place that stays to what is calm */
static const double SPARE = RADIANS(0.6);  /* of play, for rounding off where its bound turns */
static const double TIGHTER = 0.4;         /* of the way: that a bad station keeps, each time */
static const double SLACKENS = RADIANS(1); /* each mm from one */
static const double LOOSE = RADIANS(12);   /* as far as that */
static const double POLE_FLAT = 6;         /* mm: so near the pole the turn stays */
static const double POLE_WIDE = 20;        /* mm: so far it is led to that */
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
    double far;  /* how far the axis may be off the one it had: less where that is not clear */

    /* As it was looked at last. */
    struct rotary_angles seen;
    double clear; /* mm */
    bool bad;     /* not clear, or not from the station before */
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
        rule[i] = run->rule ? run->rule[i] : run->point[i].axis;
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
            c.at[i] = (struct station){.point = p,
                                       .rule = rule,
                                       .begins = j == 0 && !run[k].joined,
                                       .far = HUGE_VAL,
                                       .seen.lean = HUGE_VAL};
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
    if (s->far < PI && vec_dot(axis, s->point->axis) < cos(s->far))
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

/* Each station's angles to the mean over `half` mm before and after it, less near the ends; or
 * those of the held ones alone. */
static void average_angles(struct chain *c, double half, bool held)
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
        if (fabs(at[i].was.lean) > POLE && (!held || at[i].far < HUGE_VAL))
            move_towards(c, &at[i], mean[i]);
    free(sum);
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
static void meet_turn(struct chain *c, size_t pole, double turn, bool after)
{
    for (size_t k = 1; after ? pole + k < c->n : k <= pole; k++) {
        struct station *s = &c->at[after ? pole + k : pole - k];
        double away = fabs(s->along - c->at[pole].along);
        struct rotary_angles to = {s->angles.lean, turn + own_turn(away) * (s->angles.turn - turn)};
        if (away >= POLE_WIDE || fabs(s->was.lean) <= POLE)
            return;
        move_towards(c, s, to);
    }
}

/* The pole is passed at one turn, which is that on both sides of it: else an axis would have to
 * turn there while the tool hardly moves. */
static void fix_poles(struct chain *c)
{
    for (size_t i = 1; i + 1 < c->n; i++) {
        const struct station *s = &c->at[i];
        double turn = (s[-1].angles.turn + s[1].angles.turn) / 2;
        if (fabs(s->was.lean) > POLE || fabs(s[1].angles.turn - s[-1].angles.turn) > RADIANS(60))
            continue;
        meet_turn(c, i, turn, false);
        meet_turn(c, i, turn, true);
        c->at[i].angles.turn = turn;
    }
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

static bool same_angles(struct rotary_angles a, struct rotary_angles b)
{
    return a.lean == b.lean && a.turn == b.turn;
}

/* The tool is not clear, or would swing the ball off its straight line, on the way to a station. */
static bool is_way_bad(const struct chain *c, const struct holder_sweep *sweep,
                       const struct station *s, const struct run_point *last,
                       const struct run_point *p)
{
    const struct axis_calm_options *o = c->options;
    double turned = vec_angle(last->axis, p->axis), swing = sqrt(0.8 * o->tolerance / o->radius);

    if (turned > swing && turned > vec_angle(s[-1].point->axis, s->point->axis) + 1e-9)
        return true;
    return fmin(s[-1].clear, s->clear) >= -sweep->slack &&
           !holder_sweep_clear_between(sweep, last, s[-1].clear, p, s->clear);
}

/* Looks at the stations that have moved since: those at which the tool would not be clear, or to
 * which it would not come. */
static size_t find_bad(struct chain *c)
{
    const double far = 1; /* mm: clearances beyond are all the same */
    const struct axis_calm_options *o = c->options;
    const struct holder_sweep sweep = {o->guard, o->holder, o->tolerance / 2};
    struct run_point last = {.given = false};
    size_t found = 0;
    bool moved_before = false;

    for (size_t i = 0; i < c->n; i++) {
        struct station *s = &c->at[i];
        struct run_point p = point_of(c, s);
        struct rotary_angles now = angles_at(s, s->part);
        bool moved = !same_angles(now, s->seen), joined = i > 0 && !s->begins;
        joined = joined && (s->part > 0 || s[-1].part > 0);
        if (moved)
            s->clear = holder_sweep_clearance(&sweep, &p, far);
        if (moved || moved_before) {
            s->bad = s->part > 0 && (s->clear < -sweep.slack || !rotary_reaches(&o->chain, p.axis));
            if (joined && !s->bad && !s[-1].bad)
                s->bad = is_way_bad(c, &sweep, s, &last, &p);
        }
        s->seen = now;
        moved_before = moved;
        found += s->bad;
        last = p;
    }
    return found;
}

/* Bad stations, and less and less those about them, may be no further off what they were than part
 * of the way that they have gone. */
static void tighten(struct chain *c)
{
    double *far = mem_alloc(c->n, sizeof *far), last = HUGE_VAL;

    for (size_t i = 0; i < c->n; i++) {
        const struct station *s = &c->at[i];
        bool bad = s->bad || (i + 1 < c->n && s[1].bad);
        double off = vec_angle(rotary_axis(&c->frame, s->angles), s->point->axis);
        far[i] = bad ? TIGHTER * fmin(off, s->far) : s->far;
        far[i] = last = fmin(far[i], last + (i > 0 ? SLACKENS * (s->along - s[-1].along) : 0));
    }
    for (size_t i = c->n; i-- > 0;) {
        struct station *s = &c->at[i];
        if (i + 1 < c->n)
            far[i] = fmin(far[i], far[i + 1] + SLACKENS * (s[1].along - s->along));
        double off = vec_angle(rotary_axis(&c->frame, s->angles), s->point->axis);
        s->far = far[i] < LOOSE ? far[i] : s->far;
        if (off > s->far)
            s->angles = angles_at(s, 0.99 * s->far / off);
    }
    free(far);
    for (double half = NARROW; half >= NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(c, half, true);
}

/* The stations beside bad ones stay as they were, those further off by the ramp are calm. */
static void hold_back(struct chain *c, double ramp)
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

static void keep_clear(struct chain *c)
{
    size_t found = 1;

    for (size_t i = 0; i < c->n; i++)
        c->at[i].part = fabs(c->at[i].was.lean) > POLE ? 1 : 0;
    for (int round = 0; round < ROUNDS && (found = find_bad(c)) > 0; round++)
        tighten(c);
    /* a ramp longer than the chain leaves nothing moved */
    for (double ramp = RAMP * c->options->radius; found > 0; ramp *= 2) {
        found = find_bad(c);
        if (found > 0)
            hold_back(c, ramp);
    }
    if (travel_of(c, true) >= travel_of(c, false))
        for (size_t i = 0; i < c->n; i++)
            c->at[i].part = 0;
}

void axis_calm_chain(const struct axis_calm_options *options, const struct axis_calm_run run[],
                     size_t n)
{
    struct chain c = chain_of(options, run, n);

    for (double half = WIDEST; half > NARROW; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(&c, half, false);
    c.spare = SPARE;
    for (double half = NARROW; half >= NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(&c, half, false);
    c.spare = 2 * SPARE;
    fix_poles(&c);
    average_angles(&c, NARROWEST, false);
    keep_clear(&c);
    for (size_t i = 0; i < c.n; i++)
        *c.at[i].point = point_of(&c, &c.at[i]);
    free(c.at);
}

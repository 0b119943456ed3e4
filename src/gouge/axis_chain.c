/* axis_chain - see axis_chain.h. */
#include "axis_chain.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "gouge/axis_smooth.h"

static const double AIR = RADIANS(60);    /* how far axes in the air may be off those they had */
static const double TURNED = RADIANS(60); /* about the pole: those on both sides of it are alike */
static const double STEEPEST = RADIANS(80); /* of an axis from the normal */

/* The rules of a run, averaged. */
static struct vec3 *rules_of(const struct axis_calm_run *run,
                             const struct axis_calm_options *options)
{
    struct vec3 *rule = mem_alloc(run->n, sizeof *rule);

    for (size_t i = 0; i < run->n; i++)
        rule[i] = run->rule ? run->rule[i] : run->point[i].axis;
    axis_smooth_rules(run->point, run->n, options->radius, options->inward, rule);
    return rule;
}

/* From the play of its run to how far each station's axis may be off the rule. */
static void allow_some(void *context, size_t from, size_t to)
{
    const struct axis_chain *c = context;

    for (size_t i = from; i < to; i++) {
        struct axis_station *s = &c->at[i];
        double spare = run_point_touches(s->point) ? AXIS_CHAIN_SPARE : 0;
        s->allow = fmax(fmax(s->allow - spare, 0), vec_angle(s->point->axis, s->rule));
    }
}

bool axis_chain_at_pole(const struct axis_station *s)
{
    return fabs(s->was.lean) <= AXIS_CHAIN_POLE;
}

/* Where the axis comes to the pole and goes back to the side that it came from, it leans to that
 * side by as good as nothing, so that it may go with those about it. */
static void leave_pole(struct axis_chain *c)
{
    for (size_t i = 1, end; i + 1 < c->n; i = end + 1) {
        for (end = i; end < c->n && axis_chain_at_pole(&c->at[end]); end++)
            ;
        if (end == i || end == c->n || axis_chain_at_pole(&c->at[i - 1]))
            continue;
        struct rotary_angles before = c->at[i - 1].was, after = c->at[end].was;
        if (before.lean * after.lean <= 0 || fabs(before.turn - after.turn) > TURNED)
            continue;
        for (size_t k = i; k < end; k++) {
            double part = (double)(k + 1 - i) / (double)(end + 1 - i);
            c->at[k].was.lean = copysign(2 * AXIS_CHAIN_POLE, before.lean);
            c->at[k].was.turn = before.turn + part * (after.turn - before.turn);
            c->at[k].angles = c->at[k].was;
        }
    }
}

struct axis_chain axis_chain_of(const struct axis_calm_options *options,
                                const struct axis_calm_run run[], size_t n)
{
    struct axis_chain c = {.options = options,
                           .frame = rotary_frame_of(&options->chain),
                           .reach = holder_reach(options->holder)};
    struct rotary_angles last = {0, 0};

    for (size_t k = 0; k < n; k++)
        c.n += run[k].n;
    c.at = mem_alloc(c.n, sizeof *c.at);
    for (size_t k = 0, i = 0; k < n; k++) {
        struct vec3 *rules = rules_of(&run[k], options);
        for (size_t j = 0; j < run[k].n; j++, i++) {
            struct run_point *p = &run[k].point[j];
            struct vec3 rule = run_point_touches(p) ? rules[j] : p->axis;
            c.at[i] = (struct axis_station){.point = p,
                                            .rule = rule,
                                            .allow = run_point_touches(p) ? run[k].play : AIR,
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
    leave_pole(&c);
    parallel_for(axis_chain_threads(&c), c.n, allow_some, &c);
    return c;
}

/* The station may have the angles, as far as no guard is asked. */
bool axis_chain_may_have(const struct axis_chain *c, const struct axis_station *s,
                         struct rotary_angles a)
{
    struct vec3 axis = rotary_axis(&c->frame, a), normal = s->point->normal;

    if (a.lean * s->was.lean <= 0 || vec_dot(axis, s->rule) < cos(s->allow + c->spare))
        return false;
    if (s->far < PI && vec_dot(axis, s->point->axis) < cos(s->far))
        return false;
    return !run_point_touches(s->point) ||
           vec_dot(axis, normal) >= fmin(cos(STEEPEST), vec_dot(s->point->axis, normal));
}

/* Of a station what its means ask, for they ask it of many: side by side all of it stays near. */
struct angled {
    double along;
    struct rotary_angles angles, sum; /* integrals up to it */
};

/* The integral of the angles up to a place between the stations i and i + 1. */
static struct rotary_angles integral_at(const struct angled at[], size_t n, size_t i, double along)
{
    const struct angled *a = &at[i], *b = i + 1 < n ? a + 1 : a;
    double length = b->along - a->along, by = along - a->along;
    double s = length > 0 ? by / length : 0;

    return (struct rotary_angles){
        a->sum.lean + by * (a->angles.lean + s / 2 * (b->angles.lean - a->angles.lean)),
        a->sum.turn + by * (a->angles.turn + s / 2 * (b->angles.turn - a->angles.turn))};
}

/* What the threads share that take means. */
struct averages {
    const struct angled *at;
    size_t n;
    double half;
    struct rotary_angles *mean;
};

enum { PIECE = 4096 }; /* stations, which one thread takes */

static void average_piece(const struct averages *a, size_t begin, size_t last)
{
    const struct angled *at = a->at;
    double end = at[a->n - 1].along;

    for (size_t i = begin, low = begin, high = begin; i < last; i++) {
        double reach = fmin(a->half, fmin(at[i].along, end - at[i].along));
        double from = at[i].along - reach, to = at[i].along + reach;
        while (low > 0 && at[low].along > from)
            low--;
        while (low + 1 < a->n && at[low + 1].along <= from)
            low++;
        while (high > 0 && at[high].along > to)
            high--;
        while (high + 1 < a->n && at[high + 1].along <= to)
            high++;
        struct rotary_angles p = integral_at(at, a->n, low, from);
        struct rotary_angles q = integral_at(at, a->n, high, to);
        a->mean[i] = at[i].angles;
        if (reach > 1e-6)
            a->mean[i] = (struct rotary_angles){(q.lean - p.lean) / (2 * reach),
                                                (q.turn - p.turn) / (2 * reach)};
    }
}

static void average_pieces(void *context, size_t from, size_t to)
{
    const struct averages *a = context;

    for (size_t k = from; k < to; k++)
        average_piece(a, k * PIECE, k + 1 < (a->n + PIECE - 1) / PIECE ? (k + 1) * PIECE : a->n);
}

/* The mean of the angles over `half` mm before and after each station, less near the ends. */
struct rotary_angles *axis_chain_means(const struct axis_chain *c, double half)
{
    struct angled *at = mem_alloc(c->n + 1, sizeof *at);
    struct rotary_angles *mean = mem_alloc(c->n + 1, sizeof *mean);
    struct averages averages = {at, c->n, half, mean};

    for (size_t i = 0; i < c->n; i++) {
        at[i] = (struct angled){.along = c->at[i].along, .angles = c->at[i].angles};
        if (i == 0)
            continue;
        const struct angled *before = &at[i - 1];
        double length = at[i].along - before->along;
        at[i].sum.lean = before->sum.lean + length * (before->angles.lean + at[i].angles.lean) / 2;
        at[i].sum.turn = before->sum.turn + length * (before->angles.turn + at[i].angles.turn) / 2;
    }
    parallel_for(axis_chain_threads(c), (c->n + PIECE - 1) / PIECE, average_pieces, &averages);
    free(at);
    return mean;
}

/* The station's angles when it has gone so far from those that it had. */
struct rotary_angles axis_chain_angles(const struct axis_station *s, double part)
{
    return (struct rotary_angles){s->was.lean + part * (s->angles.lean - s->was.lean),
                                  s->was.turn + part * (s->angles.turn - s->was.turn)};
}

/* The point as it is for this part of the way. */
struct run_point axis_chain_point(const struct axis_chain *c, const struct axis_station *s)
{
    struct run_point p = *s->point;

    if (s->part > 0) {
        p.axis = rotary_axis(&c->frame, axis_chain_angles(s, s->part));
        p.tip = vec_along(p.ball, -c->options->radius, p.axis);
    }
    return p;
}

bool axis_chain_same(struct rotary_angles a, struct rotary_angles b)
{
    return a.lean == b.lean && a.turn == b.turn;
}

static const double ROUNDING = 1e-9; /* mm: of clearances, many times */

static bool is_same(struct vec3 a, struct vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

double axis_chain_clearance(const struct axis_chain *c, const struct holder_sweep *sweep,
                            struct axis_station *s, struct vec3 axis, bool exact)
{
    const struct run_point p = {.ball = s->point->ball, .axis = axis};
    double least = s->free.clear - c->reach * vec_distance(s->free.axis, axis) - ROUNDING;
    double most = s->hit.clear + c->reach * vec_distance(s->hit.axis, axis) + ROUNDING;

    if (s->free.given && is_same(s->free.axis, axis))
        return s->free.clear;
    if (s->hit.given && is_same(s->hit.axis, axis))
        return s->hit.clear;
    if (!exact && s->free.given && least >= -sweep->slack)
        return least;
    if (!exact && s->hit.given && most < -sweep->slack)
        return most;
    double clear = holder_sweep_clearance(sweep, &p, AXIS_CHAIN_FAR);
    *(clear >= -sweep->slack ? &s->free : &s->hit) = (struct axis_asked){true, axis, clear};
    return clear;
}

/* No more than the arc over the chord between two unit vectors, radians. */
static double angle_bound(struct vec3 a, struct vec3 b)
{
    double chord = vec_distance(a, b);

    return chord < 0.4 ? 1.01 * chord : PI / 2 * chord;
}

/* The tool is clear at two stations, but not on the way from one to the other. */
static bool is_between_bad(const struct axis_chain *c, const struct holder_sweep *sweep,
                           struct axis_station *from, struct axis_station *to)
{
    const struct run_point a = {.ball = from->point->ball, .axis = from->axis};
    const struct run_point b = {.ball = to->point->ball, .axis = to->axis};
    double moved = vec_distance(a.ball, b.ball) + c->reach * angle_bound(a.axis, b.axis);

    if (from->clear + to->clear + 2 * sweep->slack >= moved + ROUNDING)
        return false;
    from->clear = axis_chain_clearance(c, sweep, from, from->axis, true);
    to->clear = axis_chain_clearance(c, sweep, to, to->axis, true);
    return !holder_sweep_clear_between(sweep, &a, from->clear, &b, to->clear);
}

/* The tool is not clear, or would swing the ball off its straight line, or its axis would leave the
 * travel, on the way to a station. */
static bool is_way_bad(const struct axis_chain *c, const struct holder_sweep *sweep,
                       struct axis_station *s)
{
    const struct axis_calm_options *o = c->options;
    double swing = sqrt(0.8 * o->tolerance / o->radius);

    if (angle_bound(s[-1].axis, s->axis) > swing) {
        double turned = vec_angle(s[-1].axis, s->axis);
        if (turned > swing && turned > vec_angle(s[-1].point->axis, s->point->axis) + 1e-9)
            return true;
    }
    if (!rotary_reaches_between(&o->chain, s[-1].axis, s->axis))
        return true;
    /* one that stays may be deeper than that: only as it was has its way been judged */
    return fmin(s[-1].clear, s->clear) < -sweep->slack || is_between_bad(c, sweep, &s[-1], s);
}

/* The axis that the station has now; true if its angles are not those of the last look. */
static bool is_moved(const struct axis_chain *c, struct axis_station *s)
{
    struct rotary_angles now = axis_chain_angles(s, s->part);
    bool moved = !axis_chain_same(now, s->seen), own = s->part > 0;

    if (moved || own != s->moved)
        s->axis = own ? rotary_axis(&c->frame, now) : s->point->axis;
    s->moved = own;
    s->seen = now;
    return moved;
}

int axis_chain_threads(const struct axis_chain *c)
{
    enum { MANY = 2000 }; /* stations that are worth it */

    return c->n < MANY ? 1 : c->options->threads;
}

static struct holder_sweep sweep_of(const struct axis_chain *c)
{
    const struct axis_calm_options *o = c->options;

    return (struct holder_sweep){o->guard, o->holder, o->tolerance / 2};
}

/* How clear the tool is at stations that have moved. */
static void find_clearances(void *context, size_t from, size_t to)
{
    const struct axis_chain *c = context;
    const struct holder_sweep sweep = sweep_of(c);

    for (size_t i = from; i < to; i++) {
        struct axis_station *s = &c->at[i];
        s->fresh = is_moved(c, s);
        if (s->fresh)
            s->clear = axis_chain_clearance(c, &sweep, s, s->axis, false);
    }
}

/* Looks at the stations that have moved since: those at which the tool would not be clear, or to
 * which it would not come. */
size_t axis_chain_find_bad(struct axis_chain *c)
{
    const struct holder_sweep sweep = sweep_of(c);
    size_t found = 0;
    bool moved_before = false, bad_before = false; /* it: the way from there was not looked at */

    parallel_for(axis_chain_threads(c), c->n, find_clearances, c);
    for (size_t i = 0; i < c->n; i++) {
        struct axis_station *s = &c->at[i];
        bool moved = s->fresh, was_bad = s->bad;
        bool joined = i > 0 && !s->begins && (s->part > 0 || s[-1].part > 0);
        if (moved || moved_before || bad_before) {
            s->bad = s->part > 0 &&
                     (s->clear < -sweep.slack || !rotary_reaches(&c->options->chain, s->axis));
            if (joined && !s->bad && !s[-1].bad)
                s->bad = is_way_bad(c, &sweep, s);
        }
        moved_before = moved;
        bad_before = was_bad;
        found += s->bad;
    }
    return found;
}

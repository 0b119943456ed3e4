/* arcfit - greedy biarcs; see arcfit.h. */
#include "arcfit/arcfit.h"

#include <stdlib.h>

#include "curve/biarc.h"

static const double TURN_MAX = 2.6; /* of one arc, radians */

/* What reaches from one point of the trace to another. */
struct reach {
    size_t to; /* point reached */
    int n;     /* pieces: 1 or 2 */
    struct arc_piece piece[2];
};

struct greedy {
    const struct trace *trace;
    const struct arc_deviation *within;
    size_t at;                       /* point of the trace reached so far, */
    struct vec3 from, tangent, axis; /* where and in which direction */
    int favourite;                   /* ratio that held last */
};

/* A piece that starts where the chain has come to. */
static struct arc_piece start_piece(const struct greedy *g, struct arc arc, double to)
{
    struct arc_piece piece = arc_piece_of(g->trace, arc, (double)g->at, to);
    piece.axis = g->axis;
    return piece;
}

static bool holds(const struct greedy *g, const struct arc_piece *m)
{
    if (m->arc.angle > TURN_MAX)
        return false;
    struct arc_deviation stray = arc_piece_deviation(g->trace, m, 4, g->within);
    return arc_deviation_within(&stray, g->within);
}

static bool try_line(struct greedy *g, size_t to, struct reach *reach)
{
    const struct trace *t = g->trace;
    struct arc line = arc_line(g->from, t->p[to]);
    if (vec_angle(line.tangent, g->tangent) > ARCFIT_KINK)
        return false;
    struct arc_piece m = start_piece(g, line, (double)to);
    if (!holds(g, &m))
        return false;
    *reach = (struct reach){.to = to, .n = 1, .piece = {m}};
    return true;
}

/* A single arc whose end has the trace's direction too. */
static bool try_arc(struct greedy *g, size_t to, struct reach *reach)
{
    const struct trace *t = g->trace;
    struct arc arc = arc_to(g->from, g->tangent, t->p[to]);
    if (vec_angle(arc_tangent(&arc, 1), t->tangent[to]) > ARCFIT_KINK)
        return false;
    struct arc_piece m = start_piece(g, arc, (double)to);
    if (!holds(g, &m))
        return false;
    *reach = (struct reach){.to = to, .n = 1, .piece = {m}};
    return true;
}

static bool try_ratio(struct greedy *g, size_t to, double ratio, struct reach *reach)
{
    const struct trace *t = g->trace;
    struct biarc b;
    if (!biarc_of_ratio(g->from, g->tangent, t->p[to], t->tangent[to], ratio, &b))
        return false;
    double from = (double)g->at, end = (double)to;
    double joint = trace_place(t, b.joint, from + (end - from) * ratio / (1 + ratio));
    if (!(joint > from && joint < end))
        return false;
    struct reach r = {
        .to = to,
        .n = 2,
        .piece = {start_piece(g, b.first, joint), arc_piece_of(t, b.second, joint, end)}};
    r.piece[0].biarc = true;
    if (!holds(g, &r.piece[0]) || !holds(g, &r.piece[1]))
        return false;
    *reach = r;
    return true;
}

/* Ratios from 1 outward, 15 from 0.1 to 10; the one that held last goes first. */
static bool try_biarc(struct greedy *g, size_t to, struct reach *reach)
{
    enum { SIDE = 7 };
    for (int i = -1; i <= 2 * SIDE; i++) {
        int step = i < 0 ? g->favourite : i % 2 ? -(i + 1) / 2 : i / 2;
        if (i >= 0 && step == g->favourite)
            continue;
        if (try_ratio(g, to, pow(10, (double)step / SIDE), reach)) {
            g->favourite = step;
            return true;
        }
    }
    return false;
}

typedef bool attempt_fn(struct greedy *g, size_t to, struct reach *reach);

/* The furthest point that an attempt reaches: doubles the step, then halves the interval. */
static struct reach furthest(struct greedy *g, attempt_fn *attempt)
{
    struct reach best = {.to = g->at};
    size_t last = g->trace->n - 1, step = 1, bad = last + 1;
    while (best.to < last) {
        size_t to = g->at + step < last ? g->at + step : last;
        if (!attempt(g, to, &best)) {
            bad = to;
            break;
        }
        step *= 2;
    }
    while (best.to + 1 < bad) {
        size_t to = best.to + (bad - best.to) / 2;
        if (!attempt(g, to, &best))
            bad = to;
    }
    /* what fails at one length may hold again a little further on */
    size_t beyond = best.to + (best.to - g->at) / 4 + 1;
    for (size_t to = best.to + 1; to <= beyond && to <= last; to++)
        attempt(g, to, &best);
    return best;
}

static struct reach straight_on(struct greedy *g)
{
    const struct trace *t = g->trace;
    struct arc line = arc_line(g->from, t->p[g->at + 1]);
    struct reach r = {.to = g->at + 1, .n = 1};
    r.piece[0] = start_piece(g, line, (double)r.to);
    return r;
}

static struct reach best_reach(struct greedy *g)
{
    struct reach line = furthest(g, try_line);
    struct reach arc = furthest(g, try_arc);
    struct reach biarc = furthest(g, try_biarc);
    struct reach single = line.to >= arc.to ? line : arc;
    if (single.to > g->at && single.to >= biarc.to)
        return single;
    return biarc.to > g->at ? biarc : straight_on(g);
}

static struct vec3 end_direction(const struct trace *t, const struct reach *r)
{
    struct vec3 ahead = arc_tangent(&r->piece[r->n - 1].arc, 1);
    return vec_dot(ahead, t->tangent[r->to]) > 0.8 ? ahead : t->tangent[r->to];
}

size_t arcfit_step(const struct trace *trace, const struct arc_deviation *within,
                   const struct reached *from, struct pieces *pieces)
{
    struct greedy g = {.trace = trace,
                       .within = within,
                       .at = from->at,
                       .from = from->p,
                       .tangent = from->tangent,
                       .axis = from->axis};
    struct reach r = best_reach(&g);
    for (int i = 0; i < r.n; i++)
        *array_push(pieces) = r.piece[i];
    return r.to;
}

void arcfit_biarcs(const struct trace *trace, const struct arc_deviation *within,
                   struct pieces *pieces)
{
    if (trace->n < 2)
        return;
    struct greedy g = {.trace = trace,
                       .within = within,
                       .from = trace->p[0],
                       .tangent = trace->tangent[0],
                       .axis = trace->axis[0]};
    while (g.at + 1 < trace->n) {
        struct reach r = best_reach(&g);
        for (int i = 0; i < r.n; i++)
            *array_push(pieces) = r.piece[i];
        g.at = r.to;
        g.from = trace->p[r.to];
        g.tangent = end_direction(trace, &r);
        g.axis = trace->axis[r.to];
    }
}

size_t arcfit_each(const struct trace *t, struct pieces *pieces)
{
    size_t loops = 0;
    for (size_t i = 0; i + 1 < t->n; i++) {
        struct biarc b;
        double from = (double)i, to = (double)(i + 1);
        bool shortest = biarc_shortest(t->p[i], t->tangent[i], t->p[i + 1], t->tangent[i + 1], &b);
        if (!shortest) {
            loops++;
            if (!biarc_of_ratio(t->p[i], t->tangent[i], t->p[i + 1], t->tangent[i + 1], 1, &b)) {
                struct arc line = arc_line(t->p[i], t->p[i + 1]);
                *array_push(pieces) = arc_piece_of(t, line, from, to);
                continue;
            }
        }
        double joint = from + b.a / (b.a + b.b);
        struct arc_piece *first = array_push(pieces);
        *first = arc_piece_of(t, b.first, from, joint);
        first->biarc = true;
        *array_push(pieces) = arc_piece_of(t, b.second, joint, to);
    }
    return loops;
}

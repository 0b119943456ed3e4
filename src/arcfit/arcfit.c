/* arcfit - greedy biarcs; see arcfit.h. */
#include "arcfit/arcfit.h"

#include <stdlib.h>

#include "curve/biarc.h"

static const double TURN_MAX = 2.6; /* of one arc, radians */

/* What reaches from one point of the reference to another. */
struct reach {
    size_t to; /* point reached */
    int n;     /* pieces: 1 or 2 */
    struct arc_piece piece[2];
};

struct greedy {
    const struct reference *reference;
    const struct deviation *within;
    size_t at;                       /* point of the reference reached so far, */
    struct vec3 from, tangent, axis; /* where and in which direction */
    int favourite;                   /* ratio that held last */
};

/* A piece that starts where the chain has come to. */
static struct arc_piece start_piece(const struct greedy *g, struct arc arc, double to)
{
    struct arc_piece piece = arc_piece_of(g->reference, arc, (double)g->at, to);
    piece.axis = g->axis;
    return piece;
}

static bool is_within(const struct greedy *g, const struct arc_piece *m)
{
    if (m->arc.angle > TURN_MAX)
        return false;
    struct deviation off = arc_piece_decision(g->reference, m, 4, g->within);
    return deviation_within(&off, g->within);
}

static bool reach_by_line(struct greedy *g, size_t to, struct reach *reach)
{
    const struct reference *t = g->reference;
    struct arc line = arc_line(g->from, t->point[to]);
    bool stays = to <= polyline_stay_end(&t->point_stays, g->at); /* it has no direction then */
    if (!stays && vec_angle(line.tangent, g->tangent) > ARCFIT_KINK)
        return false;
    struct arc_piece m = start_piece(g, line, (double)to);
    if (!is_within(g, &m))
        return false;
    *reach = (struct reach){.to = to, .n = 1, .piece = {m}};
    return true;
}

/* A single arc whose end has the reference's direction too. */
static bool reach_by_arc(struct greedy *g, size_t to, struct reach *reach)
{
    const struct reference *t = g->reference;
    struct arc arc = arc_to(g->from, g->tangent, t->point[to]);
    if (vec_angle(arc_tangent(&arc, 1), t->tangent[to]) > ARCFIT_KINK)
        return false;
    struct arc_piece m = start_piece(g, arc, (double)to);
    if (!is_within(g, &m))
        return false;
    *reach = (struct reach){.to = to, .n = 1, .piece = {m}};
    return true;
}

static bool reach_by_ratio(struct greedy *g, size_t to, double ratio, struct reach *reach)
{
    const struct reference *t = g->reference;
    struct biarc b;
    if (!biarc_of_ratio(g->from, g->tangent, t->point[to], t->tangent[to], ratio, &b))
        return false;
    double from = (double)g->at, end = (double)to;
    double joint = reference_place(t, b.joint, from + (end - from) * ratio / (1 + ratio));
    if (!(joint > from && joint < end))
        return false;
    struct reach r = {
        .to = to,
        .n = 2,
        .piece = {start_piece(g, b.first, joint), arc_piece_of(t, b.second, joint, end)}};
    r.piece[0].biarc = true;
    if (!is_within(g, &r.piece[0]) || !is_within(g, &r.piece[1]))
        return false;
    *reach = r;
    return true;
}

/* Ratios from 1 outward, 15 from 0.1 to 10; the one that held last goes first. */
static bool reach_by_biarc(struct greedy *g, size_t to, struct reach *reach)
{
    enum { SIDE = 7 };
    for (int i = -1; i <= 2 * SIDE; i++) {
        int step = i < 0 ? g->favourite : i % 2 ? -(i + 1) / 2 : i / 2;
        if (i >= 0 && step == g->favourite)
            continue;
        if (reach_by_ratio(g, to, pow(10, (double)step / SIDE), reach)) {
            g->favourite = step;
            return true;
        }
    }
    return false;
}

typedef bool reach_fn(struct greedy *g, size_t to, struct reach *reach);

/* The furthest_reach point that a kind of piece reaches: doubles the step, then halves the
 * interval. */
static struct reach furthest_reach(struct greedy *g, reach_fn *reach_by)
{
    struct reach best = {.to = g->at};
    size_t last = g->reference->n - 1, step = 1, bad = last + 1;
    while (best.to < last) {
        size_t to = g->at + step < last ? g->at + step : last;
        if (!reach_by(g, to, &best)) {
            bad = to;
            break;
        }
        step *= 2;
    }
    while (best.to + 1 < bad) {
        size_t to = best.to + (bad - best.to) / 2;
        if (!reach_by(g, to, &best))
            bad = to;
    }
    /* what fails at one length may hold again a little further on */
    size_t beyond = best.to + (best.to - g->at) / 4 + 1;
    for (size_t to = best.to + 1; to <= beyond && to <= last; to++)
        reach_by(g, to, &best);
    return best;
}

static struct reach straight_on(struct greedy *g)
{
    const struct reference *t = g->reference;
    struct arc line = arc_line(g->from, t->point[g->at + 1]);
    struct reach r = {.to = g->at + 1, .n = 1};
    r.piece[0] = start_piece(g, line, (double)r.to);
    return r;
}

static struct reach best_reach(struct greedy *g)
{
    struct reach line = furthest_reach(g, reach_by_line);
    struct reach arc = furthest_reach(g, reach_by_arc);
    struct reach biarc = furthest_reach(g, reach_by_biarc);
    struct reach single = line.to >= arc.to ? line : arc;
    if (single.to > g->at && single.to >= biarc.to)
        return single;
    return biarc.to > g->at ? biarc : straight_on(g);
}

static struct vec3 end_direction(const struct reference *t, const struct reach *r)
{
    struct vec3 ahead = arc_tangent(&r->piece[r->n - 1].arc, 1);
    return vec_dot(ahead, t->tangent[r->to]) > 0.8 ? ahead : t->tangent[r->to];
}

size_t arcfit_step(const struct reference *reference, const struct deviation *within,
                   const struct chain_end *from, struct pieces *pieces)
{
    struct greedy g = {.reference = reference,
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

void arcfit_biarcs(const struct reference *reference, const struct deviation *within,
                   struct pieces *pieces)
{
    if (reference->n < 2)
        return;
    struct greedy g = {.reference = reference,
                       .within = within,
                       .from = reference->point[0],
                       .tangent = reference->tangent[0],
                       .axis = reference->axis[0]};
    while (g.at + 1 < reference->n) {
        struct reach r = best_reach(&g);
        for (int i = 0; i < r.n; i++)
            *array_push(pieces) = r.piece[i];
        g.at = r.to;
        g.from = reference->point[r.to];
        g.tangent = end_direction(reference, &r);
        g.axis = reference->axis[r.to];
    }
}

size_t arcfit_each(const struct reference *t, struct pieces *pieces)
{
    size_t loops = 0;
    for (size_t i = 0; i + 1 < t->n; i++) {
        struct biarc b;
        double from = (double)i, to = (double)(i + 1);
        bool shortest =
            biarc_shortest(t->point[i], t->tangent[i], t->point[i + 1], t->tangent[i + 1], &b);
        if (!shortest) {
            loops++;
            if (!biarc_of_ratio(t->point[i], t->tangent[i], t->point[i + 1], t->tangent[i + 1], 1,
                                &b)) {
                struct arc line = arc_line(t->point[i], t->point[i + 1]);
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

struct reference arcfit_reverse_reference(const struct reference *r)
{
    size_t n = r->n;
    struct reference back = *r;

    back.point = mem_alloc(n, sizeof *back.point);
    back.other = mem_alloc(n, sizeof *back.other);
    back.axis = mem_alloc(n, sizeof *back.axis);
    back.tangent = mem_alloc(n, sizeof *back.tangent);
    back.chord = mem_alloc(n, sizeof *back.chord);
    back.length = mem_alloc(n, sizeof *back.length);
    for (size_t i = 0; i < n; i++) {
        size_t k = n - 1 - i;
        back.point[i] = r->point[k];
        back.other[i] = r->other[k];
        back.axis[i] = r->axis[k];
        back.tangent[i] = vec_scale(-1, r->tangent[k]);
        back.length[i] = r->length[n - 1] - r->length[k];
        if (k > 0)
            back.chord[i] = r->chord[k - 1];
    }
    reference_find_stays(&back);
    return back;
}

static struct arc_piece reversed_piece(const struct arc_piece *p, double last)
{
    const struct arc *arc = &p->arc;
    struct vec3 tangent = vec_scale(-1, arc_tangent(arc, 1));

    return (struct arc_piece){.arc = arc_straight(arc) ? arc_line(arc->to, arc->from)
                                                       : arc_to(arc->to, tangent, arc->from),
                              .from = last - p->to,
                              .to = last - p->from,
                              .axis = p->axis_to,
                              .axis_to = p->axis};
}

void arcfit_reverse_pieces(struct pieces *pieces, size_t points)
{
    double last = (double)points - 1;

    for (size_t i = 0, k = pieces->n; i < k--; i++) {
        struct arc_piece first = reversed_piece(&pieces->item[k], last);
        pieces->item[k] = reversed_piece(&pieces->item[i], last);
        pieces->item[i] = first;
    }
}

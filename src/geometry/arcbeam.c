/* arcbeam - see arcbeam.h. */
#include "arcbeam.h"

#include <stdlib.h>

#include "num.h"
#include "outlook.h"

enum {
    BEAM = 24,   /* chains kept */
    SHORTER = 6, /* ends tried, each a sixteenth of the reach shorter than the one before */
    ACROSS = 5,  /* curvatures tried in the plane of the bend, */
    ASIDE = 3,   /* and out of it */
    TURNED = 3   /* directions tried at the start, to each side */
};

static const double SIDEWAYS = 0.85; /* of the tolerance: how far a joint may be off the trace */
static const double TURN_MAX = 2.6;  /* of one arc, radians */
static const double STRAIGHT = 1e-9; /* mm: an end this near to the line ahead is on it */

/* A chain of pieces, by its last one. */
struct link {
    struct piece piece; /* none in the links that start a chain */
    size_t before;      /* link */
    size_t at;          /* point of the trace reached, */
    struct vec3 p, t;   /* beside which, in which direction */
    size_t reach;       /* point that the next arc may reach */
    size_t order;       /* of the proposals, so that sorting has no ties */
};

struct links {
    size_t n, cap;
    struct link *item;
};

struct beam {
    const struct trace *trace;
    const struct stray *within;
    int digits;
    struct links done;      /* all that are part of chains */
    struct links next;      /* proposed, not proven yet */
    struct windows windows; /* for use within expand */
};

static size_t reach_of(const struct beam *b, const struct link *l)
{
    return outlook(b->trace, l->at, l->p, l->t, b->within->tracked, NULL);
}

/* An arc from link `before` to `to` beside point j. */
static void propose(struct beam *b, size_t before, size_t j, struct vec3 to)
{
    const struct link *l = &b->done.item[before];
    struct arc arc = arc_to(l->p, l->t, to);
    if (arc.angle > TURN_MAX || vec_distance(l->p, to) <= 0)
        return;
    if (arc.angle / 2 < ARCFIT_KINK)
        arc = arc_line(l->p, to);
    struct link next = {.before = before, .at = j, .p = to, .t = arc_tangent(&arc, 1)};
    next.piece = trace_piece(b->trace, arc, (double)l->at, (double)j);
    next.reach = reach_of(b, &next);
    next.order = b->next.n;
    *array_push(&b->next) = next;
}

/* The arc of curvature k up to where it is nearest to point j. */
static void propose_curvature(struct beam *b, size_t before, size_t j, struct vec3 k)
{
    const struct link *l = &b->done.item[before];
    struct vec3 aim = b->trace->p[j];
    double bent = vec_length(k), ahead = vec_dot(vec_sub(aim, l->p), l->t);
    struct vec3 to = vec_along(l->p, ahead, l->t);
    if (bent * ahead * ahead > STRAIGHT) {
        struct arc half = {.from = l->p,
                           .tangent = l->t,
                           .inward = vec_scale(1 / bent, k),
                           .radius = 1 / bent,
                           .angle = PI};
        to = arc_at(&half, arc_foot(&half, aim));
    }
    if (vec_distance(to, aim) > SIDEWAYS * b->within->tracked)
        return;
    propose(
        b, before, j,
        vec(num_round(to.x, b->digits), num_round(to.y, b->digits), num_round(to.z, b->digits)));
}

static void propose_window(struct beam *b, size_t before, const struct window *w)
{
    if (window_straight(w))
        propose_curvature(b, before, w->point, vec(0, 0, 0));
    for (int x = 0; x < ACROSS; x++) {
        for (int y = 0; y < ASIDE; y++) {
            double across = 0.02 + 0.96 * x / (ACROSS - 1), aside = 0.1 + 0.8 * y / (ASIDE - 1);
            propose_curvature(b, before, w->point, window_at(w, across, aside));
        }
    }
}

static void expand(struct beam *b, size_t before)
{
    const struct trace *t = b->trace;
    struct link l = b->done.item[before];
    b->windows.n = 0;
    size_t reach = outlook(t, l.at, l.p, l.t, b->within->tracked, &b->windows);
    if (reach + 1 == t->n)
        propose(b, before, reach, t->p[reach]);
    double whole = t->length[reach] - t->length[l.at];
    size_t i = b->windows.n;
    for (int k = 0; k < SHORTER; k++) {
        double most = t->length[l.at] + whole * (16 - k) / 16;
        while (i > 0 && (t->length[b->windows.item[i - 1].point] > most ||
                         b->windows.item[i - 1].point + 1 == t->n))
            i--;
        if (i-- == 0)
            break;
        propose_window(b, before, &b->windows.item[i]);
    }
}

static int by_reach(const void *a, const void *b)
{
    const struct link *l = a, *m = b;
    if (l->reach != m->reach)
        return l->reach > m->reach ? -1 : 1;
    if (l->at != m->at)
        return l->at > m->at ? -1 : 1;
    return l->order < m->order ? -1 : l->order > m->order;
}

static bool finished(const struct beam *b)
{
    return b->done.item[b->done.n - 1].at + 1 == b->trace->n;
}

/* The best of the proposals that are through: a line, else what strays least; false when none is.
 */
static bool keep_finished(struct beam *b)
{
    const struct link *best = NULL;
    struct stray least = *b->within;
    for (size_t i = 0; i < b->next.n; i++) {
        const struct link *l = &b->next.item[i];
        if (l->at + 1 < b->trace->n)
            continue;
        struct stray stray = trace_stray(b->trace, &l->piece, 1, b->within);
        if (!stray_within(&stray, b->within))
            continue;
        bool line = arc_straight(&l->piece.arc), had = best && arc_straight(&best->piece.arc);
        if (!best || line > had || (line == had && stray.tracked < least.tracked)) {
            best = l;
            least = stray;
        }
    }
    if (best)
        *array_push(&b->done) = *best;
    return best != NULL;
}

/* Moves the best of the proposals that hold into the chains; returns how many. */
static size_t keep_best(struct beam *b)
{
    size_t kept = keep_finished(b);
    if (b->next.n > 1)
        qsort(b->next.item, b->next.n, sizeof *b->next.item, by_reach);
    for (size_t i = 0; i < b->next.n && kept < BEAM && !finished(b); i++) {
        struct stray stray = trace_stray(b->trace, &b->next.item[i].piece, 1, b->within);
        if (!stray_within(&stray, b->within))
            continue;
        *array_push(&b->done) = b->next.item[i];
        kept++;
    }
    b->next.n = 0;
    return kept;
}

/* The chain goes on by greedy biarcs for one step, where no single arc will do. */
static void step_by_biarc(struct beam *b, size_t from)
{
    struct pieces m = {0};
    struct link l = b->done.item[from];
    arcfit_step(b->trace, b->within, l.at, l.p, l.t, &m);
    for (size_t i = 0; i < m.n; i++) {
        const struct arc *arc = &m.item[i].arc;
        struct link next = {.piece = m.item[i], .before = i ? b->done.n - 1 : from};
        next.at = (size_t)ceil(m.item[i].to);
        next.p = arc->to;
        next.t = arc_tangent(arc, 1);
        *array_push(&b->done) = next;
    }
    struct link *last = &b->done.item[b->done.n - 1];
    if (vec_dot(last->t, b->trace->tangent[last->at]) < 0.8)
        last->t = b->trace->tangent[last->at];
    array_free(&m);
}

/* Chains start at the first point, in directions around the trace's own. */
static void start(struct beam *b)
{
    const struct trace *t = b->trace;
    struct link l = {.p = t->p[0], .t = t->tangent[0]};
    double far = fmax(t->length[reach_of(b, &l)], b->within->tracked);
    double turn = b->within->tracked / far;
    struct vec3 u = vec_perpendicular(l.t), v = vec_cross(l.t, u);
    for (int x = -TURNED; x <= TURNED; x++) {
        for (int y = -TURNED; y <= TURNED; y++) {
            struct link turned = l;
            turned.t = vec_unit(vec_along(vec_along(l.t, x * turn, u), y * turn, v));
            *array_push(&b->done) = turned;
        }
    }
}

/* Pieces of the chain that ends in `link`, in order. */
static void chain_of(const struct beam *b, size_t link, size_t starts, struct pieces *pieces)
{
    struct sizes back = {0};
    for (; link >= starts; link = b->done.item[link].before)
        *array_push(&back) = link;
    while (back.n > 0)
        *array_push(pieces) = b->done.item[back.item[--back.n]].piece;
    array_free(&back);
}

/* Grows the chains until one is through. */
static void search(struct beam *b)
{
    size_t from = 0;
    while (!finished(b)) {
        size_t to = b->done.n;
        for (size_t i = from; i < to; i++)
            expand(b, i);
        if (keep_best(b) > 0) {
            from = to;
        } else {
            step_by_biarc(b, from);
            from = b->done.n - 1;
        }
    }
}

void arcbeam_fit(const struct trace *trace, const struct stray *within, int digits,
                 struct pieces *pieces)
{
    if (trace->n < 2)
        return;
    struct beam b = {.trace = trace, .within = within, .digits = digits};
    struct pieces biarcs = {0}, arcs = {0};
    arcfit_biarcs(trace, within, &biarcs);
    start(&b);
    size_t starts = b.done.n;
    search(&b);
    chain_of(&b, b.done.n - 1, starts, &arcs);
    const struct pieces *best = arcs.n <= biarcs.n ? &arcs : &biarcs;
    for (size_t i = 0; i < best->n; i++)
        *array_push(pieces) = best->item[i];
    array_free(&b.done);
    array_free(&b.next);
    array_free(&b.windows);
    array_free(&arcs);
    array_free(&biarcs);
}

/* arc_beam - see arc_beam.h. */
#include "arcfit/arc_beam.h"

#include <stdlib.h>

#include "arc_window.h"
#include "arc_axis.h"

enum {
    BEAM = 24,   /* chains kept where the axis stands still, */
    SWUNG = 8,   /* and where it turns: there each proof takes longer */
    SHORTER = 6, /* ends tried, each a sixteenth of the reach shorter than the one before */
    ACROSS = 5,  /* curvatures tried in the plane of the bend, */
    ASIDE = 3,   /* and out of it */
    TURNED = 3,  /* directions tried at the start, to each side */
    AXIS_DIGITS = 9
};

static const double SIDEWAYS = 0.85; /* of the tolerance: how far a joint may be off the trace */
static const double SWING = 0.6;    /* of the tolerances: how far an axis may be set off for them */
static const double TURN_MAX = 2.6; /* of one arc, radians */
static const double STRAIGHT = 1e-9; /* mm: an end this near to the line ahead is on it */

/* A chain of pieces, by its last one. */
struct link {
    struct arc_piece piece; /* none in the links that start a chain */
    size_t before;          /* link */
    struct reached end;
};

struct links {
    size_t n, cap;
    struct link *item;
};

/* A piece to come, not proven yet. */
struct proposal {
    size_t before;    /* link */
    size_t at;        /* point of the trace reached, */
    struct vec3 p, t; /* beside which, in which direction */
    bool straight;
    size_t reach; /* point that the next piece may reach */
    size_t order; /* of the proposals, so that sorting has no ties */
};

struct proposals {
    size_t n, cap;
    struct proposal *item;
};

struct beam {
    const struct trace *trace;
    const struct arc_deviation *within;
    int digits;
    size_t width;      /* chains kept */
    struct links done; /* all that are part of chains */
    struct proposals next;
    struct arc_windows windows; /* for use within expand */
    size_t stepped;             /* pieces that are no single arcs, where these would not do */
};

static size_t reach_of(const struct beam *b, size_t at, struct vec3 p, struct vec3 t)
{
    return arc_window(b->trace, at, p, t, b->within->tracked, NULL);
}

/* An arc from link `before` to `to` beside point j. */
static void propose(struct beam *b, size_t before, size_t j, struct vec3 to)
{
    const struct reached *from = &b->done.item[before].end;
    struct vec3 e = vec_sub(to, from->p);
    double chord = vec_length(e), ahead = vec_dot(e, from->tangent);
    if (chord <= 0 || ahead < cos(TURN_MAX / 2) * chord)
        return;
    e = vec_scale(1 / chord, e);
    struct proposal next = {.before = before, .at = j, .p = to, .order = b->next.n};
    /* half its turn is between the tangent and the chord */
    next.straight = ahead > 0 && vec_length(vec_reject(e, from->tangent)) < sin(ARCFIT_KINK);
    next.t = next.straight ? e : vec_along(vec_scale(-1, from->tangent), 2 * ahead / chord, e);
    next.reach = reach_of(b, j, to, next.t);
    *array_push(&b->next) = next;
}

/* The arc of curvature k up to where it is nearest to point j. */
static void propose_curvature(struct beam *b, size_t before, size_t j, struct vec3 k)
{
    const struct reached *from = &b->done.item[before].end;
    struct vec3 aim = b->trace->p[j], e = vec_sub(aim, from->p);
    double bent = vec_length(k), x = vec_dot(e, from->tangent);
    struct vec3 to = vec_along(from->p, x, from->tangent);
    if (bent * x * x > STRAIGHT) { /* from the centre in the direction of the aim */
        struct vec3 inward = vec_scale(1 / bent, k);
        double y = 1 / bent - vec_dot(e, inward), l = hypot(x, y);
        double sine = x / l, height = sine * x / (l + y);
        to = vec_along(from->p, sine / bent, from->tangent);
        to = vec_along(to, height / bent, inward);
    }
    if (vec_distance(to, aim) > SIDEWAYS * b->within->tracked)
        return;
    propose(b, before, j, vec_round(to, b->digits));
}

static void propose_window(struct beam *b, size_t before, const struct arc_window *w)
{
    if (arc_window_straight(w))
        propose_curvature(b, before, w->point, vec(0, 0, 0));
    for (int x = 0; x < ACROSS; x++) {
        for (int y = 0; y < ASIDE; y++) {
            double across = 0.02 + 0.96 * x / (ACROSS - 1), aside = 0.1 + 0.8 * y / (ASIDE - 1);
            propose_curvature(b, before, w->point, arc_window_at(w, across, aside));
        }
    }
}

static void expand(struct beam *b, size_t before)
{
    const struct trace *t = b->trace;
    struct reached l = b->done.item[before].end;
    b->windows.n = 0;
    size_t reach = arc_window(t, l.at, l.p, l.tangent, b->within->tracked, &b->windows);
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
    const struct proposal *l = a, *m = b;
    if (l->reach != m->reach)
        return l->reach > m->reach ? -1 : 1;
    if (l->at != m->at)
        return l->at > m->at ? -1 : 1;
    return l->order < m->order ? -1 : l->order > m->order;
}

static bool finished(const struct beam *b)
{
    return b->done.item[b->done.n - 1].end.at + 1 == b->trace->n;
}

/* The link that a proposal comes to; false when its piece strays too far. */
static bool prove(const struct beam *b, const struct proposal *n, struct link *link,
                  struct arc_deviation *stray)
{
    const struct trace *t = b->trace;
    const struct reached *from = &b->done.item[n->before].end;
    struct arc arc = n->straight ? arc_line(from->p, n->p) : arc_to(from->p, from->tangent, n->p);
    struct arc_piece piece = arc_piece_of(t, arc, (double)from->at, (double)n->at);
    piece.axis = from->axis;
    *stray = arc_piece_deviation(t, &piece, 4, b->within);
    if (stray->tracked <= b->within->tracked && stray->other > b->within->other &&
        n->at + 1 < t->n) {
        piece.axis_to = arc_axis_end(t, &piece, b->within, SWING, AXIS_DIGITS);
        *stray = arc_piece_deviation(t, &piece, 4, b->within);
    }
    *link = (struct link){.piece = piece,
                          .before = n->before,
                          .end = {n->at, n->p, arc_tangent(&arc, 1), piece.axis_to}};
    return arc_deviation_within(stray, b->within);
}

/* The best of the proposals that are through: a line, else what strays least; false when none is.
 */
static bool keep_finished(struct beam *b)
{
    struct link best = {0};
    struct arc_deviation least = *b->within;
    bool any = false;
    for (size_t i = 0; i < b->next.n; i++) {
        struct link l;
        struct arc_deviation stray;
        if (b->next.item[i].at + 1 < b->trace->n || !prove(b, &b->next.item[i], &l, &stray))
            continue;
        bool line = arc_straight(&l.piece.arc), had = any && arc_straight(&best.piece.arc);
        if (!any || line > had || (line == had && stray.tracked < least.tracked)) {
            best = l;
            least = stray;
            any = true;
        }
    }
    if (any)
        *array_push(&b->done) = best;
    return any;
}

/* Moves the best of the proposals that hold into the chains; returns how many. */
static size_t keep_best(struct beam *b)
{
    size_t kept = keep_finished(b);
    if (b->next.n > 1)
        qsort(b->next.item, b->next.n, sizeof *b->next.item, by_reach);
    for (size_t i = 0; i < b->next.n && kept < b->width && !finished(b); i++) {
        struct link l;
        struct arc_deviation stray;
        if (!prove(b, &b->next.item[i], &l, &stray))
            continue;
        *array_push(&b->done) = l;
        kept++;
    }
    b->next.n = 0;
    return kept;
}

/* The chain goes on by greedy biarcs for one step, where no single arc will do. */
static void step_by_biarc(struct beam *b, size_t from)
{
    struct pieces m = {0};
    struct reached start = b->done.item[from].end;
    arcfit_step(b->trace, b->within, &start, &m);
    for (size_t i = 0; i < m.n; i++) {
        const struct arc *arc = &m.item[i].arc;
        struct link next = {.piece = m.item[i], .before = i ? b->done.n - 1 : from};
        next.end = (struct reached){(size_t)ceil(m.item[i].to), arc->to, arc_tangent(arc, 1),
                                    m.item[i].axis_to};
        *array_push(&b->done) = next;
    }
    struct reached *last = &b->done.item[b->done.n - 1].end;
    if (vec_dot(last->tangent, b->trace->tangent[last->at]) < 0.8)
        last->tangent = b->trace->tangent[last->at];
    b->stepped += m.n;
    array_free(&m);
}

/* Chains start at the first point, in directions around the trace's own. */
static void start(struct beam *b)
{
    const struct trace *t = b->trace;
    struct vec3 ahead = t->tangent[0];
    double far = fmax(t->length[reach_of(b, 0, t->p[0], ahead)], b->within->tracked);
    double turn = b->within->tracked / far;
    struct vec3 u = vec_perpendicular(ahead), v = vec_cross(ahead, u);
    for (int x = -TURNED; x <= TURNED; x++) {
        for (int y = -TURNED; y <= TURNED; y++) {
            struct vec3 turned = vec_unit(vec_along(vec_along(ahead, x * turn, u), y * turn, v));
            *array_push(&b->done) = (struct link){.end = {0, t->p[0], turned, t->axis[0]}};
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

void arc_beam_fit(const struct trace *trace, const struct arc_deviation *within, int digits,
                  struct pieces *pieces)
{
    if (trace->n < 2)
        return;
    struct beam b = {.trace = trace, .within = within, .digits = digits};
    struct pieces biarcs = {0}, arcs = {0};
    b.width = trace_axis_still(trace, 0, trace->n - 1) ? BEAM : SWUNG;
    start(&b);
    size_t starts = b.done.n;
    search(&b);
    chain_of(&b, b.done.n - 1, starts, &arcs);
    if (4 * b.stepped > arcs.n)
        arcfit_biarcs(trace, within, &biarcs);
    const struct pieces *best = biarcs.n == 0 || arcs.n <= biarcs.n ? &arcs : &biarcs;
    for (size_t i = 0; i < best->n; i++)
        *array_push(pieces) = best->item[i];
    array_free(&b.done);
    array_free(&b.next);
    array_free(&b.windows);
    array_free(&arcs);
    array_free(&biarcs);
}

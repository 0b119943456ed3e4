/* arc_beam - see arcfit.h, arcfit_beam. */
#include <stdlib.h>

#include "arc_axis.h"
#include "arc_window.h"
#include "arcfit/arcfit.h"
#include "curve/biarc.h"

enum {
    SHORTER = 6, /* ends tried, each a sixteenth of the reach shorter than the one before */
    ACROSS = 5,  /* curvatures tried in the plane of the bend, */
    ASIDE = 3,   /* and out of it */
    TURNED = 3,  /* directions tried at the start, to each side, */
    ALL_STARTS = (2 * TURNED + 1) * (2 * TURNED + 1),
    STARTS = 16, /* of these, in a hurry */
    AXIS_DIGITS = 9
};

/* What a search of each enum arcfit_effort costs. */
static const struct beam_effort {
    size_t still, turning; /* chains kept where the axis stands still, and where it turns: there
                               each proof takes longer */
    double window, reach;  /* further away, the next point looked at */
    size_t starts;         /* directions of the first arc */
} EFFORT[] = {{24, 8, 1.0 / 40, 1.0 / 40, ALL_STARTS},
              {24, 8, 1.0 / 10, 1.0 / 6, ALL_STARTS},
              {4, 4, 1.0 / 10, 1.0 / 6, STARTS}};

static const double TURN_MAX = 2.6;  /* of one arc, radians */
static const double STRAIGHT = 1e-9; /* mm: an end this near to the line ahead is on it */

/* A chain of pieces: its last one, and the chain before that. */
struct node {
    struct arc_piece piece; /* none in the nodes that start a chain */
    size_t before;          /* node */
    struct chain_end end;
};

struct nodes {
    size_t n, cap;
    struct node *item;
};

/* A piece to come, not proven yet. */
struct proposal {
    size_t before;    /* node */
    size_t at;        /* point of the reference reached, */
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
    const struct reference *reference;
    const struct deviation *within;
    int digits;
    const struct beam_effort *effort;
    size_t width;                 /* chains kept */
    double most_turned, straight; /* cosine of half of TURN_MAX, sine of ARCFIT_KINK */
    struct nodes done;            /* all that are part of chains */
    struct proposals next;
    struct sizes heap;          /* of these */
    struct arc_windows windows; /* for use within propose_next */
    size_t stepped;             /* pieces that are no single arcs, where these would not do */
    const struct pieces *old;   /* a chain to be met (NULL: none), */
    size_t meet;                /* where this piece of it begins or a later one */
};

static size_t reach_from(const struct beam *b, size_t at, struct vec3 p, struct vec3 t)
{
    return arc_look_ahead(b->reference, at, p, t, b->within->point, b->effort->reach, NULL);
}

/* An arc from node `before` to `to` beside point j. */
static void propose_arc(struct beam *b, size_t before, size_t j, struct vec3 to)
{
    const struct chain_end *from = &b->done.item[before].end;
    struct vec3 e = vec_sub(to, from->p);
    double chord = vec_length(e), ahead = vec_dot(e, from->tangent);
    if (chord <= 0 || ahead < b->most_turned * chord)
        return;
    e = vec_scale(1 / chord, e);
    struct proposal next = {.before = before, .at = j, .p = to, .order = b->next.n};
    /* half its turn is between the tangent and the chord */
    next.straight = ahead > 0 && vec_length(vec_reject(e, from->tangent)) < b->straight;
    next.t = next.straight ? e : vec_along(vec_scale(-1, from->tangent), 2 * ahead / chord, e);
    next.reach = reach_from(b, j, to, next.t);
    *array_push(&b->next) = next;
}

/* An arc that is bent so, its centre x behind the aim and y beside it and the aim so far out of its
 * plane, is far off a joint whatever the last digits are: most are. */
static bool is_far_off(const struct beam *b, double bent, double x, double y, double out)
{
    const double rounding = 1e-14;
    double radius = 1 / bent, most = ARC_JOINT_OFF * b->within->point + rounding * radius + 1e-9;

    double off = sqrt(x * x + y * y) - radius;

    return off * off + out * out > most * most;
}

/* The arc of curvature k up to where it is nearest to point j. */
static void propose_curvature(struct beam *b, size_t before, size_t j, struct vec3 k)
{
    const struct chain_end *from = &b->done.item[before].end;
    struct vec3 aim = b->reference->point[j], e = vec_sub(aim, from->p);
    double bent = vec_length(k), x = vec_dot(e, from->tangent);
    struct vec3 to = vec_along(from->p, x, from->tangent);
    if (bent * x * x > STRAIGHT) { /* from the centre in the direction of the aim */
        struct vec3 inward = vec_scale(1 / bent, k);
        double y = 1 / bent - vec_dot(e, inward);
        if (is_far_off(b, bent, x, y, vec_dot(vec_cross(e, from->tangent), inward)))
            return;
        double l = hypot(x, y);
        double sine = x / l, height = sine * x / (l + y);
        to = vec_along(from->p, sine / bent, from->tangent);
        to = vec_along(to, height / bent, inward);
    }
    if (vec_distance(to, aim) > ARC_JOINT_OFF * b->within->point)
        return;
    propose_arc(b, before, j, vec_round(to, b->digits));
}

static void propose_window(struct beam *b, size_t before, const struct arc_window *w)
{
    if (arc_window_holds_line(w))
        propose_curvature(b, before, w->point, vec(0, 0, 0));
    for (int x = 0; x < ACROSS; x++) {
        for (int y = 0; y < ASIDE; y++) {
            double across = 0.02 + 0.96 * x / (ACROSS - 1), aside = 0.1 + 0.8 * y / (ASIDE - 1);
            propose_curvature(b, before, w->point, arc_window_curvature(w, across, aside));
        }
    }
}

static void propose_next(struct beam *b, size_t before)
{
    const struct reference *t = b->reference;
    struct chain_end l = b->done.item[before].end;
    b->windows.n = 0;
    size_t reach =
        arc_look_ahead(t, l.at, l.p, l.tangent, b->within->point, b->effort->window, &b->windows);
    if (reach + 1 == t->n)
        propose_arc(b, before, reach, t->point[reach]);
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

static bool beam_finished(const struct beam *b)
{
    return b->done.item[b->done.n - 1].end.at + 1 == b->reference->n;
}

/* The node that a proposal comes to; false when its piece is too far off.  *found: how far, by the
 * figures themselves where it is the last piece. */
static bool prove_piece(const struct beam *b, const struct proposal *n, struct node *node,
                        struct deviation *found)
{
    const struct reference *t = b->reference;
    bool last = n->at + 1 == t->n;
    const struct chain_end *from = &b->done.item[n->before].end;
    struct arc arc = n->straight ? arc_line(from->p, n->p) : arc_to(from->p, from->tangent, n->p);
    struct arc_piece piece = arc_piece_of(t, arc, (double)from->at, (double)n->at);
    piece.axis = from->axis;
    *found = last ? arc_piece_deviation(t, &piece, 4, b->within)
                  : arc_piece_decision(t, &piece, 4, b->within);
    if (found->point <= b->within->point && found->other > b->within->other && !last) {
        piece.axis_to = arc_axis_end(t, &piece, b->within, ARC_AXIS_OFF, AXIS_DIGITS);
        *found = arc_piece_decision(t, &piece, 4, b->within);
    }
    *node = (struct node){.piece = piece,
                          .before = n->before,
                          .end = {n->at, n->p, arc_tangent(&arc, 1), piece.axis_to}};
    return deviation_within(found, b->within);
}

/* The best of the proposals that reach the last point: a line, else what is least off; false when
 * none is.
 */
static bool keep_best_finished(struct beam *b)
{
    struct node best = {0};
    struct deviation least = *b->within;
    bool any = false;
    for (size_t i = 0; i < b->next.n; i++) {
        struct node l;
        struct deviation found;
        if (b->next.item[i].at + 1 < b->reference->n ||
            !prove_piece(b, &b->next.item[i], &l, &found))
            continue;
        bool line = arc_straight(&l.piece.arc), had = any && arc_straight(&best.piece.arc);
        if (!any || line > had || (line == had && found.point < least.point)) {
            best = l;
            least = found;
            any = true;
        }
    }
    if (any)
        *array_push(&b->done) = best;
    return any;
}

/* A heap of proposals by their number, the one that reaches furthest on top: few of them are
 * wanted in order. */
static void sift_down(const struct proposals *p, size_t *heap, size_t n, size_t at)
{
    size_t moved = heap[at];

    for (size_t child = 2 * at + 1; child < n; child = 2 * at + 1) {
        if (child + 1 < n && by_reach(&p->item[heap[child + 1]], &p->item[heap[child]]) < 0)
            child++;
        if (by_reach(&p->item[moved], &p->item[heap[child]]) < 0)
            break;
        heap[at] = heap[child];
        at = child;
    }
    heap[at] = moved;
}

static void heap_up(const struct proposals *p, struct sizes *heap)
{
    heap->n = 0;
    for (size_t i = 0; i < p->n; i++)
        *array_push(heap) = i;
    for (size_t i = heap->n / 2; i-- > 0;)
        sift_down(p, heap->item, heap->n, i);
}

/* Takes the one on top away. */
static const struct proposal *take_furthest(const struct proposals *p, struct sizes *heap)
{
    const struct proposal *furthest = &p->item[heap->item[0]];

    heap->item[0] = heap->item[--heap->n];
    if (heap->n > 0)
        sift_down(p, heap->item, heap->n, 0);
    return furthest;
}

/* Moves the best of the proposals that hold into the chains; returns how many. */
static size_t keep_best(struct beam *b)
{
    size_t kept = keep_best_finished(b);

    heap_up(&b->next, &b->heap);
    while (b->heap.n > 0 && kept < b->width && !beam_finished(b)) {
        struct node l;
        struct deviation found;
        if (!prove_piece(b, take_furthest(&b->next, &b->heap), &l, &found))
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
    struct chain_end start = b->done.item[from].end;
    arcfit_step(b->reference, b->within, &start, &m);
    for (size_t i = 0; i < m.n; i++) {
        const struct arc *arc = &m.item[i].arc;
        struct node next = {.piece = m.item[i], .before = i ? b->done.n - 1 : from};
        next.end = (struct chain_end){(size_t)ceil(m.item[i].to), arc->to, arc_tangent(arc, 1),
                                      m.item[i].axis_to};
        *array_push(&b->done) = next;
    }
    struct chain_end *last = &b->done.item[b->done.n - 1].end;
    if (vec_dot(last->tangent, b->reference->tangent[last->at]) < 0.8)
        last->tangent = b->reference->tangent[last->at];
    b->stepped += m.n;
    array_free(&m);
}

/* Chains start at the first point, in directions around the reference's own: in those that look
 * furthest ahead. */
static void add_starts(struct beam *b)
{
    const struct reference *t = b->reference;
    struct vec3 ahead = t->tangent[0];
    double far = fmax(t->length[reach_from(b, 0, t->point[0], ahead)], b->within->point);
    double turn = b->within->point / far;
    struct vec3 u = vec_perpendicular(ahead), v = vec_cross(ahead, u);
    for (int x = -TURNED; x <= TURNED; x++) {
        for (int y = -TURNED; y <= TURNED; y++) {
            struct vec3 turned = vec_unit(vec_along(vec_along(ahead, x * turn, u), y * turn, v));
            struct proposal start = {.p = t->point[0], .t = turned, .order = b->next.n};
            if (b->effort->starts < ALL_STARTS)
                start.reach = reach_from(b, 0, start.p, turned);
            *array_push(&b->next) = start;
        }
    }
    if (b->effort->starts < ALL_STARTS)
        qsort(b->next.item, b->next.n, sizeof *b->next.item, by_reach);
    for (size_t i = 0; i < b->effort->starts; i++)
        *array_push(&b->done) =
            (struct node){.end = {0, t->point[0], b->next.item[i].t, t->axis[0]}};
    b->next.n = 0;
}

/* Pieces of the chain that ends in `node`, in order. */
static void collect_chain(const struct beam *b, size_t node, size_t starts, struct pieces *pieces)
{
    struct sizes back = {0};
    for (; node >= starts; node = b->done.item[node].before)
        *array_push(&back) = node;
    while (back.n > 0)
        *array_push(pieces) = b->done.item[back.item[--back.n]].piece;
    array_free(&back);
}

/* Two pieces from a node to where an old one begins, in its direction; false: they are too far off.
 */
static bool try_biarc(const struct beam *b, size_t node, const struct arc_piece *next, double ratio,
                      struct arc_piece two[2])
{
    const struct reference *t = b->reference;
    const struct chain_end *end = &b->done.item[node].end;
    double start = (double)end->at, middle = start + (next->from - start) * ratio / (1 + ratio);
    struct biarc biarc;

    if (!biarc_of_ratio(end->p, end->tangent, next->arc.from, next->arc.tangent, ratio, &biarc))
        return false;
    double joint = reference_place(t, biarc.joint, middle);
    if (!(joint > start && joint < next->from))
        return false;
    two[0] = arc_piece_of(t, biarc.first, start, joint);
    two[1] = arc_piece_of(t, biarc.second, joint, next->from);
    two[0].axis = end->axis;
    two[0].biarc = true;
    two[1].axis_to = next->axis;
    for (int i = 0; i < 2; i++) {
        struct deviation off = arc_piece_decision(t, &two[i], 4, b->within);
        if (two[i].arc.angle > TURN_MAX || !deviation_within(&off, b->within))
            return false;
    }
    return true;
}

/* The node goes on to where an old piece begins, by a biarc as even as may be; false: by none. */
static bool meet_piece(struct beam *b, size_t node, const struct arc_piece *next)
{
    enum { SIDE = 3 };
    struct arc_piece two[2];
    bool met = false;

    for (int i = 0; i <= 2 * SIDE && !met; i++) {
        int step = i % 2 ? -(i + 1) / 2 : i / 2;
        met = try_biarc(b, node, next, pow(10, (double)step / (2 * SIDE)), two);
    }
    for (size_t i = 0; i < 2 && met; i++) {
        const struct arc *arc = &two[i].arc;
        struct node to = {.piece = two[i], .before = i ? b->done.n - 1 : node};
        to.end = (struct chain_end){(size_t)ceil(two[i].to), arc->to, arc_tangent(arc, 1),
                                    two[i].axis_to};
        *array_push(&b->done) = to;
    }
    return met;
}

/* One of the nodes [from, to) goes on to the old chain, by no more than it has come in its last
 * piece and half as much again: as far along that as may be.  *met: at which piece of it. */
static bool meet_old(struct beam *b, size_t from, size_t to, size_t *met)
{
    const double *length = b->reference->length;
    const struct arc_piece *old = b->old->item;

    for (size_t i = from; i < to; i++) {
        struct chain_end end = b->done.item[i].end,
                         before = b->done.item[b->done.item[i].before].end;
        double most = length[end.at] + 1.5 * (length[end.at] - length[before.at]);
        size_t first = b->meet, last;
        while (first < b->old->n && old[first].from < (double)end.at + 1)
            first++;
        for (last = first; last < b->old->n && length[(size_t)old[last].from] <= most;)
            last++;
        while (last-- > first)
            if (meet_piece(b, i, &old[last])) {
                *met = last;
                return true;
            }
    }
    return false;
}

/* Grows the chains until one is through, or has met the old one: returns at which piece of that. */
static size_t grow_chains(struct beam *b)
{
    size_t from = 0, met;
    while (!beam_finished(b)) {
        size_t to = b->done.n;
        for (size_t i = from; i < to; i++)
            propose_next(b, i);
        if (keep_best(b) > 0) {
            from = to;
            if (b->old && !beam_finished(b) && meet_old(b, from, b->done.n, &met))
                return met;
        } else {
            step_by_biarc(b, from);
            from = b->done.n - 1;
        }
    }
    return b->old ? b->old->n : 0;
}

static struct beam beam_of(const struct reference *reference, const struct deviation *within,
                           int digits, enum arcfit_effort effort)
{
    const struct beam_effort *e = &EFFORT[effort];
    bool still = reference_axis_still(reference, 0, reference->n - 1);

    return (struct beam){.reference = reference,
                         .within = within,
                         .digits = digits,
                         .effort = e,
                         .width = still ? e->still : e->turning,
                         .most_turned = cos(TURN_MAX / 2),
                         .straight = sin(ARCFIT_KINK)};
}

static void beam_free(struct beam *b)
{
    array_free(&b->done);
    array_free(&b->next);
    array_free(&b->heap);
    array_free(&b->windows);
}

void arcfit_beam(const struct reference *reference, const struct deviation *within, int digits,
                 enum arcfit_effort effort, struct pieces *pieces)
{
    if (reference->n < 2)
        return;
    struct beam b = beam_of(reference, within, digits, effort);
    struct pieces biarcs = {0}, arcs = {0};
    add_starts(&b);
    size_t starts = b.done.n;
    grow_chains(&b);
    collect_chain(&b, b.done.n - 1, starts, &arcs);
    if (4 * b.stepped > arcs.n)
        arcfit_biarcs(reference, within, &biarcs);
    const struct pieces *best = biarcs.n == 0 || arcs.n <= biarcs.n ? &arcs : &biarcs;
    for (size_t i = 0; i < best->n; i++)
        *array_push(pieces) = best->item[i];
    beam_free(&b);
    array_free(&arcs);
    array_free(&biarcs);
}

bool arcfit_again(const struct reference *reference, const struct deviation *within, int digits,
                  enum arcfit_effort effort, size_t from, size_t to, struct pieces *pieces)
{
    const struct arc_piece *first = &pieces->item[from];
    struct beam b = beam_of(reference, within, digits, effort);
    struct pieces all = {0};

    b.old = pieces;
    b.meet = to;
    if (from == 0)
        add_starts(&b);
    else
        *array_push(&b.done) = (struct node){
            .end = {(size_t)ceil(first->from), first->arc.from, first->arc.tangent, first->axis}};
    size_t starts = b.done.n, met = grow_chains(&b);
    for (size_t i = 0; i < from; i++)
        *array_push(&all) = pieces->item[i];
    collect_chain(&b, b.done.n - 1, starts, &all);
    for (size_t i = met; i < pieces->n; i++)
        *array_push(&all) = pieces->item[i];
    bool joined = met < pieces->n || to == pieces->n;
    beam_free(&b);
    array_free(pieces);
    *pieces = all;
    return joined;
}

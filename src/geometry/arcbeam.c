/* arcbeam - see arcbeam.h. */
#include "arcbeam.h"

#include <stdlib.h>

#include "num.h"

enum {
    BEAM = 24,       /* chains kept */
    SHORTER = 6,     /* ends tried before the furthest point within reach */
    ACROSS = 5,      /* curvatures tried in the plane of the bend, */
    ASIDE = 3,       /* and out of it */
    LOOK_POINTS = 96 /* points looked at over one reach: dense traces are thinned for the guess */
};

static const double SIDEWAYS = 0.85; /* of the tolerance: how far a joint may be off the trace */
static const double TURN_MAX = 2.6;  /* of one arc, radians */

/* A chain of pieces, by its last one. */
struct link {
    struct piece piece; /* none in the links that start a chain */
    size_t before;      /* link */
    size_t at;          /* point of the trace reached, */
    struct vec3 p, t;   /* beside which, in which direction */
    double reach;       /* length of the trace that the next arc may reach, mm */
};

struct links {
    size_t n, cap;
    struct link *item;
};

struct beam {
    const struct trace *trace;
    const struct stray *within;
    int digits;
    struct links done; /* all that are part of chains */
    struct links next; /* not proven yet */
};

/* The curvatures, across the direction of a link, that an arc to a point may have. */
struct window {
    struct vec3 u, v;    /* unit, across: in the plane of the bend and out of it */
    double lo[4], hi[4]; /* along u, v, u + v, u - v */
};

static void window_open(struct window *w, struct vec3 u, struct vec3 t)
{
    w->u = u;
    w->v = vec_cross(t, u);
    for (int i = 0; i < 4; i++) {
        w->lo[i] = -HUGE_VAL;
        w->hi[i] = HUGE_VAL;
    }
}

/* Narrows the window to a disc; false when nothing is left. */
static bool window_narrow(struct window *w, struct vec3 k, double radius)
{
    double u = vec_dot(k, w->u), v = vec_dot(k, w->v), half = sqrt(0.5);
    double along[4] = {u, v, half * (u + v), half * (u - v)};
    for (int i = 0; i < 4; i++) {
        double lo = along[i] - radius, hi = along[i] + radius;
        w->lo[i] = lo > w->lo[i] ? lo : w->lo[i];
        w->hi[i] = hi < w->hi[i] ? hi : w->hi[i];
        if (w->lo[i] > w->hi[i])
            return false;
    }
    return true;
}

/* One disc for a point of the trace ahead of a link; false when it is not ahead. */
static bool disc_of(struct vec3 p, struct vec3 t, struct vec3 ahead, double tolerance,
                    struct vec3 *k, double *radius)
{
    struct vec3 e = vec_sub(ahead, p);
    double e2 = vec_dot(e, e), along = vec_dot(e, t);
    if (along <= 0)
        return e2 <= tolerance * tolerance;
    *k = vec_scale(2 / e2, vec_along(e, -along, t));
    *radius = 2 * tolerance / e2;
    return true;
}

/* Direction of the bend ahead of a link, unit, across t. */
static struct vec3 bend(const struct trace *t, const struct link *l)
{
    double far = t->length[l->at] + 0.05 * (t->length[t->n - 1] - t->length[l->at]);
    size_t j = l->at + 1;
    while (j + 1 < t->n && t->length[j] < far && j < l->at + LOOK_POINTS)
        j++;
    struct vec3 across = vec_unit(vec_reject(vec_sub(t->p[j], l->p), l->t));
    return vec_dot(across, across) > 0.5 ? across : vec_perpendicular(l->t);
}

/*
 * The furthest point that an arc from the link may reach, by the windows alone.  window[0..n-1] are
 * those of the last *n points looked at, point[] these, the furthest last.
 */
struct outlook {
    size_t n;
    size_t point[LOOK_POINTS * 4];
    struct window window[LOOK_POINTS * 4];
};

static size_t look_stride(const struct trace *t, const struct link *l, double tolerance)
{
    /* the points on an arc of the radius that the next points have, or so: a third of them is
     * within the reach of an arc */
    (void)tolerance;
    size_t left = t->n - 1 - l->at;
    return left > LOOK_POINTS * 64 ? 1 + left / (LOOK_POINTS * 256) : 1;
}

static void look(const struct beam *b, const struct link *l, struct outlook *o)
{
    const struct trace *t = b->trace;
    double tolerance = b->within->tracked;
    struct window w;
    window_open(&w, bend(t, l), l->t);
    o->n = 0;
    size_t stride = look_stride(t, l, tolerance);
    for (size_t j = l->at + 1; j < t->n && o->n < LOOK_POINTS * 4; j += stride) {
        struct vec3 k;
        double radius = -1;
        if (!disc_of(l->p, l->t, t->p[j], tolerance, &k, &radius))
            break;
        if (radius >= 0 && !window_narrow(&w, k, radius))
            break;
        o->point[o->n] = j;
        o->window[o->n++] = w;
    }
}

static double reach_of(const struct beam *b, const struct link *l)
{
    const struct trace *t = b->trace;
    double tolerance = b->within->tracked;
    struct window w;
    window_open(&w, bend(t, l), l->t);
    size_t stride = look_stride(t, l, tolerance), j = l->at + 1;
    for (; j < t->n; j += stride) {
        struct vec3 k;
        double radius = -1;
        if (!disc_of(l->p, l->t, t->p[j], tolerance, &k, &radius))
            break;
        if (radius >= 0 && !window_narrow(&w, k, radius))
            break;
    }
    return t->length[j < t->n ? j - 1 : t->n - 1];
}

static struct vec3 rounded(const struct beam *b, struct vec3 p)
{
    return vec(num_round(p.x, b->digits), num_round(p.y, b->digits), num_round(p.z, b->digits));
}

/* Adds the link by an arc from `l` to `to` beside point j, to be proven later. */
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
    *array_push(&b->next) = next;
}

/* Where an arc of curvature k ends beside point j. */
static void propose_curvature(struct beam *b, size_t before, size_t j, struct vec3 k)
{
    const struct link *l = &b->done.item[before];
    struct vec3 aim = b->trace->p[j], to;
    double bent = vec_length(k), ahead = vec_dot(vec_sub(aim, l->p), l->t);
    if (bent * ahead < 1e-9) {
        to = vec_along(l->p, ahead, l->t);
    } else {
        struct arc arc = {.from = l->p,
                          .tangent = l->t,
                          .inward = vec_scale(1 / bent, k),
                          .radius = 1 / bent,
                          .angle = PI};
        to = arc_at(&arc, arc_foot(&arc, aim));
    }
    if (vec_distance(to, aim) <= SIDEWAYS * b->within->tracked)
        propose(b, before, j, rounded(b, to));
}

static void propose_window(struct beam *b, size_t before, size_t j, const struct window *w)
{
    if (w->lo[0] <= 0 && w->hi[0] >= 0 && w->lo[1] <= 0 && w->hi[1] >= 0)
        propose_curvature(b, before, j, vec(0, 0, 0));
    for (int x = 0; x < ACROSS; x++) {
        for (int y = 0; y < ASIDE; y++) {
            double fx = 0.02 + 0.96 * x / (ACROSS - 1), fy = 0.1 + 0.8 * y / (ASIDE - 1);
            struct vec3 k = vec_scale(w->lo[0] + fx * (w->hi[0] - w->lo[0]), w->u);
            k = vec_along(k, w->lo[1] + fy * (w->hi[1] - w->lo[1]), w->v);
            propose_curvature(b, before, j, k);
        }
    }
}

static void expand(struct beam *b, size_t before, struct outlook *o)
{
    struct link l = b->done.item[before];
    look(b, &l, o);
    if (o->n == 0)
        return;
    size_t end = b->trace->n - 1, span = o->n;
    if (o->point[o->n - 1] == end)
        propose(b, before, end, b->trace->p[end]);
    size_t step = 1 + span / 16;
    for (size_t i = 0; i < SHORTER && i * step < span; i++) {
        size_t at = span - 1 - i * step;
        if (o->point[at] != end)
            propose_window(b, before, o->point[at], &o->window[at]);
    }
}

static int by_reach(const void *a, const void *b)
{
    const struct link *l = a, *m = b;
    if (l->reach != m->reach)
        return l->reach > m->reach ? -1 : 1;
    if (l->at != m->at)
        return l->at > m->at ? -1 : 1;
    return l->before < m->before ? -1 : l->before > m->before;
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
    double far = reach_of(b, &l), tolerance = b->within->tracked;
    double tilt = tolerance / fmax(far, tolerance);
    struct vec3 u = bend(t, &l), v = vec_cross(l.t, u);
    for (int x = -3; x <= 3; x++) {
        for (int y = -1; y <= 1; y++) {
            struct link turned = l;
            turned.t = vec_unit(vec_along(vec_along(l.t, x * tilt, u), y * tilt, v));
            *array_push(&b->done) = turned;
        }
    }
}

/* Motions of the chain that ends in `link`, in order. */
static void chain_of(const struct beam *b, size_t link, size_t starts, struct pieces *pieces)
{
    struct sizes back = {0};
    for (; link >= starts; link = b->done.item[link].before)
        *array_push(&back) = link;
    while (back.n > 0)
        *array_push(pieces) = b->done.item[back.item[--back.n]].piece;
    array_free(&back);
}

void arcbeam_fit(const struct trace *trace, const struct stray *within, int digits,
                 struct pieces *pieces)
{
    struct pieces biarcs = {0}, arcs = {0};
    arcfit_biarcs(trace, within, &biarcs);
    struct beam b = {.trace = trace, .within = within, .digits = digits};
    struct outlook *outlook = mem_alloc(1, sizeof *outlook);
    if (trace->n > 1)
        start(&b);
    size_t starts = b.done.n, from = 0;
    while (b.done.n > 0 && !finished(&b)) {
        size_t to = b.done.n;
        for (size_t i = from; i < to; i++)
            expand(&b, i, outlook);
        if (keep_best(&b) == 0) {
            step_by_biarc(&b, from);
            from = b.done.n - 1;
        } else {
            from = to;
        }
    }
    if (b.done.n > 0)
        chain_of(&b, b.done.n - 1, starts, &arcs);
    const struct pieces *best = arcs.n > 0 && arcs.n <= biarcs.n ? &arcs : &biarcs;
    for (size_t i = 0; i < best->n; i++)
        *array_push(pieces) = best->item[i];
    free(outlook);
    array_free(&b.done);
    array_free(&b.next);
    array_free(&arcs);
    array_free(&biarcs);
}

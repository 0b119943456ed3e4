/* arcspline_refit - see arcspline_refit.h. */
#include "arcspline_refit.h"

#include <stdlib.h>

#include "arcspline_optimize.h"

enum {
    EACH = 8,       /* points looked at for each arc, */
    EACH_MOST = 80, /* and where these hold */
    CLOSER = 3,     /* stage (arcspline_optimize.h) at which that begins */
    EVENED = 5,     /* times that joints are spaced anew by what the arcs are off */
    LEFT_OUT = 6,   /* arcs tried without, or more, where the axis turns; else all of them */
    AXIS_DIGITS = 9
};

static const double POWER = 0.5; /* of an arc's stray, when joints are spaced by it */

static double length_at(const struct trace *t, double place)
{
    size_t i = (size_t)place < t->n - 1 ? (size_t)place : t->n - 2;
    return t->length[i] + (place - (double)i) * (t->length[i + 1] - t->length[i]);
}

/* The place on the trace at a length from its start, looked for from point `i` on. */
static double place_at(const struct trace *t, double length, size_t i)
{
    while (i + 2 < t->n && t->length[i + 1] < length)
        i++;
    double step = t->length[i + 1] - t->length[i];
    return (double)i + (step > 0 ? fmin(1, fmax(0, (length - t->length[i]) / step)) : 0);
}

/* Puts an inner joint onto the trace. */
static void put_joint(const struct arcspline_refit *part, struct arcspline *chain, size_t i,
                      double place)
{
    struct joint *j = &chain->joint[i];
    *j = (struct joint){.p = trace_point(part->trace, place), .place = place};
    arcspline_lean(chain, part->trace, i);
}

/* The ends of the chain: those of the old pieces. */
static void put_ends(const struct arcspline_refit *part, struct arcspline *chain)
{
    const struct arc_piece *first = &part->old[0], *last = &part->old[part->n - 1];
    chain->joint[0] = (struct joint){.p = first->arc.from,
                                     .tangent = first->arc.tangent,
                                     .axis = first->axis,
                                     .place = first->from};
    chain->joint[chain->n] =
        (struct joint){.p = last->arc.to, .axis = last->axis_to, .place = last->to};
}

/* To each arc falls the like share of the old ones. */
static void space_evenly(const struct arcspline_refit *part, struct arcspline *chain)
{
    const struct trace *t = part->trace;
    put_ends(part, chain);
    for (size_t i = 1; i < chain->n; i++) {
        double share = (double)(i * part->n) / (double)chain->n, rest = share - floor(share);
        const struct arc_piece *p = &part->old[(size_t)share];
        double a = length_at(t, p->from), b = length_at(t, p->to);
        put_joint(part, chain, i, place_at(t, a + rest * (b - a), (size_t)p->from));
    }
}

/* The joints of the old pieces but for one of them. */
static void leave_out(const struct arcspline_refit *part, size_t without, struct arcspline *chain)
{
    put_ends(part, chain);
    for (size_t i = 1; i < chain->n; i++) {
        const struct arc_piece *p = &part->old[i < without ? i : i + 1];
        put_joint(part, chain, i, p->from);
        chain->joint[i].p = p->arc.from;
    }
}

/* How far off the points are that each arc passes, as a part of the largest. */
static void strays(struct arcspline_optimize *m, double *stray)
{
    struct passing *passing = &m->passing;
    double *off = mem_alloc(4 * passing->n + 1, sizeof *off), most = 0;
    arcspline_residual(&m->chain, m->lever, passing, off);
    for (size_t i = 0; i < passing->n; i++) {
        const double *far = off + 2 * (passing->n + i);
        double *s = &stray[passing->item[i].arc], here = hypot(off[2 * i], off[2 * i + 1]);
        if (m->lever != 0)
            here = fmax(here, hypot(far[0], far[1]));
        *s = fmax(*s, here);
        most = fmax(most, here);
    }
    for (size_t i = 0; i < m->chain.n; i++)
        stray[i] = most > 0 ? stray[i] / most : 1;
    free(off);
}

/* Gives arcs that are nearer to the trace than others more of it. */
static void space_by_stray(const struct arcspline_refit *part, struct arcspline_optimize *m)
{
    const struct trace *t = part->trace;
    struct arcspline *chain = &m->chain;
    double *share = mem_alloc(chain->n, sizeof *share), old = 0, sum = 0;
    strays(m, share);
    double start = length_at(t, chain->joint[0].place), at = start;
    for (size_t i = 0; i < chain->n; i++) {
        double length = length_at(t, chain->joint[i + 1].place) - at;
        share[i] = length / pow(fmax(share[i], 0.2), POWER);
        at += length;
        old += length;
        sum += share[i];
    }
    put_ends(part, chain);
    chain->joint[0].tangent =
        part->start_held ? part->old[0].arc.tangent : t->tangent[(size_t)part->old[0].from];
    at = start;
    for (size_t i = 1; i < chain->n; i++) {
        at += share[i - 1] * old / sum;
        put_joint(part, chain, i, place_at(t, at, (size_t)part->old[0].from));
    }
    free(share);
}

/* The chain with rounded joints as pieces that hold; false when they don't. */
static bool prove(const struct arcspline_refit *part, const struct arcspline_optimize *m,
                  struct pieces *out)
{
    struct arcspline chain = arcspline_new(m->chain.n);
    arcspline_copy(&chain, &m->chain);
    for (size_t i = 1; i < chain.n; i++) {
        struct joint *j = &chain.joint[i];
        j->p = vec_round(j->p, part->digits);
        if (m->lever != 0)
            j->axis = vec_unit(vec_round(j->axis, AXIS_DIGITS));
    }
    arcspline_turn(&chain, 0);
    out->n = 0;
    arcspline_pieces(&chain, part->trace, out);
    struct vec3 end = chain.joint[chain.n].tangent;
    bool good = !m->end_held || vec_angle(end, m->end) < ARCFIT_KINK;
    for (size_t i = 0; i < out->n && good; i++) {
        struct arc_deviation stray =
            arc_piece_deviation(part->trace, &out->item[i], 4, part->within);
        good = arc_deviation_within(&stray, part->within);
    }
    arcspline_free(&chain);
    return good;
}

/* Looks at all points now, where those looked at so far hold and others don't. */
static void look_closer(const struct arcspline_refit *part, struct arcspline_optimize *m)
{
    size_t from = (size_t)part->old[0].from, to = (size_t)ceil(part->old[part->n - 1].to);
    passing_free(&m->passing);
    m->passing = passing_of(part->trace, from, to, EACH_MOST * part->n);
}

/* From the joints as they are spaced now. */
static bool settle(const struct arcspline_refit *part, struct arcspline_optimize *m,
                   struct pieces *out)
{
    m->stage = 0;
    for (int i = 0; i < 4; i++) {
        if (arcspline_optimize_settle(m, 0.995 - 0.005 * i) > 1)
            return false;
        if (prove(part, m, out))
            return true;
        if (i == 0)
            look_closer(part, m);
        m->stage = CLOSER;
    }
    return false;
}

/* Other spacings of the joints one after the other, until one does. */
static bool settle_others(const struct arcspline_refit *part, struct arcspline_optimize *m,
                          struct pieces *out)
{
    bool good = false;
    size_t stride = m->lever == 0 ? 1 : 1 + part->n / LEFT_OUT;

    for (int i = 0; i < EVENED && !good; i++) {
        space_by_stray(part, m);
        good = settle(part, m, out);
    }
    bool held = part->start_held || part->end_held;
    for (size_t i = (stride + 1) / 2; i < part->n && !good && !held; i += stride) {
        leave_out(part, i, &m->chain);
        good = settle(part, m, out);
    }
    return good;
}

bool arcspline_refit_fit(const struct arcspline_refit *part, size_t arcs, struct pieces *out)
{
    const struct arc_piece *last = &part->old[part->n - 1];
    size_t from = (size_t)part->old[0].from, to = (size_t)ceil(last->to);
    if (arcs == 0 || to > part->trace->n - 1)
        return false;
    struct arcspline_optimize m = {
        .trace = part->trace,
        .chain = arcspline_new(arcs),
        .passing = passing_of(part->trace, from, to, EACH * part->n),
        .tolerance = part->within->tracked,
        .lever = trace_axis_still(part->trace, from, to) ? 0 : part->trace->lever,
        .other = part->within->other,
        .start_held = part->start_held,
        .end_held = part->end_held,
        .end = arc_tangent(&last->arc, 1)};
    bool free = !part->start_held && !part->end_held && m.lever == 0;
    space_evenly(part, &m.chain);
    bool good = settle(part, &m, out);
    if (!good && arcs + 1 == part->n && (free || part->thorough))
        good = settle_others(part, &m, out);
    arcspline_free(&m.chain);
    passing_free(&m.passing);
    return good;
}

/* arcspline_reduce - see arcfit.h, arcfit_reduce. */
#include "arcfit/arcfit.h"

#include <stdlib.h>
#include <string.h>

#include "arcspline.h"

enum {
    EACH = 8,         /* points looked at for each arc, */
    EACH_MOST = 80,   /* and where these hold */
    RESPACED = 5,     /* times that joints are spaced anew by what the arcs are off */
    RESPACED_FEW = 2, /* so many where none of them came near */
    LEFT_OUT = 6,     /* arcs tried without, or a few more */
    AXIS_DIGITS = 9
};

/* Feet of points that were looked for so far; how many may be of each point of the reference, and
 * so up to where a window of pieces ends. */
struct asked {
    double feet, each, most;
};

/* Part of a chain of arcs, to be replaced by another number of arcs. */
struct refit {
    const struct reference *reference;
    const struct deviation *within;
    int digits;                  /* decimals of the joints */
    const struct arc_piece *old; /* what there is: where the part begins and ends, */
    size_t n;                    /* and how the reference is shared out among its pieces */
    bool start_held, end_held;   /* the direction there stays */
    bool thorough;               /* many spacings of the joints also where the axis turns */
    bool even;                   /* the joints begin spaced by length alone */
    bool moved;                  /* they begin where they are: the reference moved a little */
    struct asked *asked;         /* NULL: there is no bound */
};

static const double POWER = 0.5; /* of an arc's residual, when joints are spaced by it */
static const double NEAR =
    1.25; /* tolerances: no spacing of the joints has come from farther off */

static double length_at(const struct reference *t, double place)
{
    size_t i = (size_t)place < t->n - 1 ? (size_t)place : t->n - 2;
    return t->length[i] + (place - (double)i) * (t->length[i + 1] - t->length[i]);
}

/* The place on the reference at a length from its start, searched from point `i` on. */
static double place_at(const struct reference *t, double length, size_t i)
{
    while (i + 2 < t->n && t->length[i + 1] < length)
        i++;
    double step = t->length[i + 1] - t->length[i];
    return (double)i + (step > 0 ? fmin(1, fmax(0, (length - t->length[i]) / step)) : 0);
}

/* Puts an inner joint onto the reference. */
static void set_joint(const struct refit *part, struct arcspline *spline, size_t i, double place)
{
    struct joint *j = &spline->joint[i];
    *j = (struct joint){.p = reference_point(part->reference, place), .place = place};
    arcspline_set_axis(spline, part->reference, i);
}

/* The ends of the spline: those of the old pieces. */
static void set_ends(const struct refit *part, struct arcspline *spline)
{
    const struct arc_piece *first = &part->old[0], *last = &part->old[part->n - 1];
    spline->joint[0] = (struct joint){.p = first->arc.from,
                                      .tangent = first->arc.tangent,
                                      .axis = first->axis,
                                      .place = first->from};
    spline->joint[spline->n] =
        (struct joint){.p = last->arc.to, .axis = last->axis_to, .place = last->to};
}

/* To each arc falls the like share of the old ones. */
static void space_evenly(const struct refit *part, struct arcspline *spline)
{
    const struct reference *t = part->reference;
    set_ends(part, spline);
    for (size_t i = 1; i < spline->n; i++) {
        double share = (double)(i * part->n) / (double)spline->n, rest = share - floor(share);
        const struct arc_piece *p = &part->old[(size_t)share];
        double a = length_at(t, p->from), b = length_at(t, p->to);
        set_joint(part, spline, i, place_at(t, a + rest * (b - a), (size_t)p->from));
    }
}

/* All arcs equally long. */
static void space_by_length(const struct refit *part, struct arcspline *spline)
{
    const struct reference *t = part->reference;
    size_t first = (size_t)part->old[0].from;
    double a = length_at(t, part->old[0].from), b = length_at(t, part->old[part->n - 1].to);
    set_ends(part, spline);
    for (size_t i = 1; i < spline->n; i++) {
        double share = (double)i / (double)spline->n;
        set_joint(part, spline, i, place_at(t, a + share * (b - a), first));
    }
}

/* The joints of the old pieces but for one of them; those of all where there is no such one. */
static void space_without(const struct refit *part, size_t without, struct arcspline *spline)
{
    set_ends(part, spline);
    for (size_t i = 1; i < spline->n; i++) {
        const struct arc_piece *p = &part->old[i < without ? i : i + 1];
        set_joint(part, spline, i, p->from);
        spline->joint[i].p = p->arc.from;
    }
}

/* Where the old pieces are, with their axes. */
static void space_alike(const struct refit *part, struct arcspline *spline)
{
    space_without(part, part->n, spline);
    for (size_t i = 1; i < spline->n; i++)
        arcspline_lean_axis(spline, part->reference, i, part->old[i].axis);
}

/* How far off the points are that each arc passes, as a part of the largest. */
static void relative_residuals(struct arcspline_fit *m, double *part_of_worst)
{
    struct arc_feet *feet = &m->feet;
    double *off = mem_alloc(4 * feet->n + 1, sizeof *off), most = 0;
    arcspline_residual(&m->spline, m->offset, feet, off);
    for (size_t i = 0; i < feet->n; i++) {
        const double *far = off + 2 * (feet->n + i);
        double *s = &part_of_worst[feet->item[i].arc], here = hypot(off[2 * i], off[2 * i + 1]);
        if (m->offset != 0)
            here = fmax(here, hypot(far[0], far[1]));
        *s = fmax(*s, here);
        most = fmax(most, here);
    }
    for (size_t i = 0; i < m->spline.n; i++)
        part_of_worst[i] = most > 0 ? part_of_worst[i] / most : 1;
    free(off);
}

/* Gives arcs that are nearer to the reference than others more of it. */
static void space_by_residual(const struct refit *part, struct arcspline_fit *m)
{
    const struct reference *t = part->reference;
    struct arcspline *spline = &m->spline;
    double *share = mem_alloc(spline->n, sizeof *share), old = 0, sum = 0;
    relative_residuals(m, share);
    double start = length_at(t, spline->joint[0].place), at = start;
    for (size_t i = 0; i < spline->n; i++) {
        double length = length_at(t, spline->joint[i + 1].place) - at;
        share[i] = length / pow(fmax(share[i], 0.2), POWER);
        at += length;
        old += length;
        sum += share[i];
    }
    set_ends(part, spline);
    spline->joint[0].tangent =
        part->start_held ? part->old[0].arc.tangent : t->tangent[(size_t)part->old[0].from];
    at = start;
    for (size_t i = 1; i < spline->n; i++) {
        at += share[i - 1] * old / sum;
        set_joint(part, spline, i, place_at(t, at, (size_t)part->old[0].from));
    }
    free(share);
}

/* The spline with rounded joints as pieces that hold; false when they don't. */
static bool prove_rounded(const struct refit *part, const struct arcspline_fit *m,
                          struct pieces *out)
{
    struct arcspline spline = arcspline_new(m->spline.n);
    arcspline_copy(&spline, &m->spline);
    for (size_t i = 1; i < spline.n; i++) {
        struct joint *j = &spline.joint[i];
        j->p = vec_round(j->p, part->digits);
        if (m->offset != 0)
            j->axis = vec_unit(vec_round(j->axis, AXIS_DIGITS));
    }
    arcspline_set_tangents(&spline, 0);
    out->n = 0;
    arcspline_pieces(&spline, part->reference, out);
    struct vec3 end = spline.joint[spline.n].tangent;
    bool good = !m->end_held || vec_angle(end, m->end) < ARCFIT_KINK;
    for (size_t i = 0; i < out->n && good; i++) {
        struct deviation found =
            arc_piece_decision(part->reference, &out->item[i], 4, part->within);
        good = deviation_within(&found, part->within);
    }
    arcspline_free(&spline);
    return good;
}

/* Looks at all points now, where those looked at so far hold and others don't. */
static void use_all_points(const struct refit *part, struct arcspline_fit *m)
{
    size_t from = (size_t)part->old[0].from, to = (size_t)ceil(part->old[part->n - 1].to);
    arc_feet_free(&m->feet);
    m->feet = arc_feet_of(part->reference, from, to, EACH_MOST * part->n);
}

static void count_asked(const struct refit *part, struct arcspline_fit *m)
{
    if (part->asked)
        part->asked->feet += m->asked;
    m->asked = 0;
}

static bool is_spent(const struct refit *part)
{
    return part->asked && part->asked->feet > part->asked->most;
}

/* From the joints as they are spaced now.  Where that fails, *nearest becomes no more than what it
 * came to, in tolerances. */
static bool fit_and_prove(const struct refit *part, struct arcspline_fit *m, double *nearest,
                          struct pieces *out)
{
    double enough = ARC_ENOUGH;

    m->stage = part->moved ? ARCSPLINE_MOVED : 0;
    for (int i = 0; i < 4; i++) {
        double worst = arcspline_optimize(m, enough);
        *nearest = fmin(*nearest, worst);
        count_asked(part, m);
        if (worst > 1)
            return false;
        if (prove_rounded(part, m, out))
            return true;
        if (i == 0)
            use_all_points(part, m);
        m->stage = ARCSPLINE_NEARLY;
        if (i > 0 && worst <= enough - ARC_ENOUGH_STEP)
            return false; /* it would not move */
        enough -= ARC_ENOUGH_STEP;
    }
    return false;
}

/* Other spacings of the joints one after the other, until one does; `nearest` so far. */
static bool settle_from_other_spacings(const struct refit *part, struct arcspline_fit *m,
                                       double nearest, struct pieces *out)
{
    bool good = false, held = part->start_held || part->end_held;
    size_t stride = 1 + part->n / LEFT_OUT;

    for (int i = 0; i < RESPACED && !good && (i < RESPACED_FEW || nearest < NEAR); i++) {
        if (is_spent(part))
            return false;
        space_by_residual(part, m);
        good = fit_and_prove(part, m, &nearest, out);
    }
    for (size_t i = (stride + 1) / 2; i < part->n && !good && !held && nearest < NEAR;
         i += stride) {
        if (is_spent(part))
            return false;
        space_without(part, i, &m->spline);
        good = fit_and_prove(part, m, &nearest, out);
    }
    return good;
}

/*
 * So many arcs in the place of the old pieces, proven by arc_piece_deviation with rounded joints;
 * what was in `out` goes.  False when none was found that keep within.
 *
 * The joints begin spaced as evenly as the old pieces were.  For one arc fewer with both directions
 * free there are more tries: spaced anew by what each arc is off, and as the old ones without one
 * of them; where the axis turns only when `thorough`.  When that, and a direction is held, the
 * first of these two ways too.
 */
static bool refit_with(const struct refit *part, size_t arcs, struct pieces *out)
{
    const struct arc_piece *last = &part->old[part->n - 1];
    size_t from = (size_t)part->old[0].from, to = (size_t)ceil(last->to);
    if (arcs == 0 || to > part->reference->n - 1)
        return false;
    struct arcspline_fit m = {
        .reference = part->reference,
        .spline = arcspline_new(arcs),
        .feet = arc_feet_of(part->reference, from, to, EACH * part->n),
        .tolerance = part->within->point,
        .offset = reference_axis_still(part->reference, from, to) ? 0 : part->reference->offset,
        .other = part->within->other,
        .start_held = part->start_held,
        .end_held = part->end_held,
        .end = arc_tangent(&last->arc, 1)};
    bool free = !part->start_held && !part->end_held && m.offset == 0;
    if (part->even)
        space_by_length(part, &m.spline);
    else if (part->moved)
        space_alike(part, &m.spline);
    else
        space_evenly(part, &m.spline);
    double nearest = HUGE_VAL;
    bool good = fit_and_prove(part, &m, &nearest, out);
    if (!good && arcs + 1 == part->n && (free || part->thorough))
        good = settle_from_other_spacings(part, &m, nearest, out);
    arcspline_free(&m.spline);
    arc_feet_free(&m.feet);
    return good;
}

/* ---- fewer arcs */

enum {
    ALL_AT_ONCE = 32, /* arcs that are place_now all together; of more a window at a time */
    WINDOW = 6,       /* of so many arcs, */
    WIDE = 14         /* or so many where the axis stands still */
};

/* Puts `some` in the place of n pieces at `at`. */
static void replace_pieces(struct pieces *pieces, size_t at, size_t n, const struct pieces *some)
{
    size_t after = pieces->n - at - n;
    array_reserve(pieces, at + some->n + after);
    struct arc_piece *here = &pieces->item[at];
    memmove(here + some->n, here + n, after * sizeof *here);
    memcpy(here, some->item, some->n * sizeof *here);
    pieces->n = at + some->n + after;
}

/* The direction jumps where piece i begins. */
static bool kinks_at(const struct pieces *pieces, size_t i)
{
    struct vec3 before = arc_tangent(&pieces->item[i - 1].arc, 1);
    return vec_angle(before, pieces->item[i].arc.tangent) > 1.01 * ARCFIT_KINK;
}

bool arcfit_smooth(const struct pieces *pieces, size_t from, size_t to)
{
    for (size_t i = from + 1; i < to; i++)
        if (kinks_at(pieces, i))
            return false;
    return true;
}

/* End of the smooth part that starts with piece `from`: where the direction jumps. */
static size_t smooth_end(const struct pieces *pieces, size_t from)
{
    size_t i = from + 1;
    while (i < pieces->n && !kinks_at(pieces, i))
        i++;
    return i;
}

/* n pieces from `at` on, of the smooth part [from, end), with one fewer; false where none holds. */
static bool reduce_window(const struct refit *like, size_t from, size_t end, size_t at, size_t n,
                          struct pieces *pieces)
{
    struct refit part = *like;
    struct pieces some = {0};
    part.old = &pieces->item[at];
    part.n = n;
    part.start_held = at > from;
    part.end_held = at + n < end;
    if (part.asked)
        part.asked->most = part.asked->each * pieces->item[at + n - 1].to;
    bool good = n > 1 && !is_spent(&part) && refit_with(&part, n - 1, &some);

    if (good)
        replace_pieces(pieces, at, n, &some);
    array_free(&some);
    return good;
}

/* The smooth part [from, end) with fewer pieces; returns its new end.  Windows that hold no arc too
 * many come in rows (a scan's noise): the longer the row, the fewer of the next are tried. */
static size_t reduce_smooth_part(const struct refit *like, size_t from, size_t end,
                                 struct pieces *pieces)
{
    bool still = reference_axis_still(like->reference, (size_t)pieces->item[from].from,
                                      (size_t)pieces->item[end - 1].to);
    size_t window = still ? WIDE : WINDOW;
    /* of those that are moved all together too, half a window apart does */
    size_t least = still && end - from <= ALL_AT_ONCE ? WIDE / 2 : 1, stride = least;

    for (size_t i = from; end - from > window && i < end;) {
        size_t n = end - i < window ? end - i : window;
        if (reduce_window(like, from, end, i, n, pieces)) {
            end--;
            stride = least;
        } else {
            i = i + n < end ? i + stride : end;
            stride = stride < window ? stride + 1 : window;
        }
    }
    while (end - from <= ALL_AT_ONCE && reduce_window(like, from, end, from, end - from, pieces))
        end--;
    return end;
}

void arcfit_reduce(const struct reference *reference, const struct deviation *within, int digits,
                   double feet, struct pieces *pieces)
{
    struct asked asked = {.each = feet};
    struct refit like = {.reference = reference,
                         .within = within,
                         .digits = digits,
                         .thorough = feet > 0,
                         .asked = feet > 0 ? &asked : NULL};

    for (size_t from = 0; from < pieces->n;)
        from = reduce_smooth_part(&like, from, smooth_end(pieces, from), pieces);
}

/* ---- where the reference has moved */

enum { MORE = 2 }; /* pieces more there, at most */

bool arcfit_refit(const struct reference *reference, const struct deviation *within, int digits,
                  size_t from, size_t to, enum arcfit_effort effort, struct pieces *pieces)
{
    struct refit part = {.reference = reference,
                         .within = within,
                         .digits = digits,
                         .old = &pieces->item[from],
                         .n = to - from,
                         .start_held = from > 0 && !kinks_at(pieces, from),
                         .end_held = to < pieces->n && !kinks_at(pieces, to)};
    struct pieces some = {0};
    bool good = false;

    part.moved = true;
    good = refit_with(&part, part.n, &some);
    part.moved = false;
    size_t most = effort == ARCFIT_HURRIED ? 0 : part.n + MORE;
    for (size_t arcs = part.n; arcs <= most && !good; arcs++)
        good = refit_with(&part, arcs, &some);
    if (good)
        replace_pieces(pieces, from, part.n, &some);
    array_free(&some);
    return good;
}

/* ---- no arc shorter than a length */

enum { BESIDE = 2 }; /* pieces on each side of a short one that give it some of their length */

double arcfit_shortest(const struct pieces *pieces, size_t from, size_t to)
{
    double shortest = HUGE_VAL;
    for (size_t i = from; i < to; i++)
        shortest = fmin(shortest, arc_length(&pieces->item[i].arc));
    return shortest;
}

/* The short piece `at` of the smooth part [from, end) and those beside it with their joints moved
 * apart, one fewer where that holds.  True if the shortest of them is longer then. */
static bool lengthen_piece(const struct refit *like, size_t from, size_t end, size_t at,
                           struct pieces *pieces)
{
    size_t first = at > from + BESIDE ? at - BESIDE : from;
    size_t last = at + BESIDE < end ? at + BESIDE + 1 : end, n = last - first;
    double before = arcfit_shortest(pieces, first, last);
    struct refit part = *like;
    struct pieces some = {0};
    bool good = false;

    part.old = &pieces->item[first];
    part.n = n;
    part.even = true;
    part.start_held = first > from;
    part.end_held = last < end;
    for (size_t arcs = n - 1; arcs > 0 && arcs <= n && !good; arcs++)
        good = refit_with(&part, arcs, &some) && arcfit_shortest(&some, 0, some.n) > before;
    if (good)
        replace_pieces(pieces, first, n, &some);
    array_free(&some);
    return good;
}

void arcfit_lengthen(const struct reference *reference, const struct deviation *within, int digits,
                     double least, struct pieces *pieces)
{
    struct refit like = {.reference = reference, .within = within, .digits = digits};

    for (size_t from = 0, end; from < pieces->n; from = end) {
        end = smooth_end(pieces, from);
        for (size_t i = from; i < end; i++) {
            size_t n = pieces->n;
            if (arc_length(&pieces->item[i].arc) < least && end - from > 1 &&
                lengthen_piece(&like, from, end, i, pieces))
                end -= n - pieces->n;
        }
    }
}

/* post_feed - see post_feed.h. */
#include "post_feed.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/num.h"
#include "math/elementary.h"
#include "feed_division.h"
#include "post_ik.h"

enum { PIECES = 12, PIECES_MOST = 256, SPAN_PIECES = 24, MORE_DIGITS = 3, DIGITS_MAX = 9 };

static const double NOTHING = 1e-6;  /* mm and degrees */
static const double KEPT = 0.98;     /* of an axis' largest speed: for who looks at other places */
static const double SHORTEST = 0.02; /* mm: of a block that is made to be slow alone */
static const double AT_ONCE = 0.014; /* mm: and of a way that is looked at as one; 0.02 is asked */

static double rotary_minutes(const struct machine *m, const double a[], const double b[])
{
    double minutes = 0;
    for (int i = 0; i < m->chain.n; i++)
        minutes = larger(minutes, DEGREES(fabs(b[i] - a[i])) / m->rapid[m->letter[i]]);
    return minutes;
}

double post_feed_axes_minutes(const struct nc_planner *planner, const struct block_pose *a,
                              const struct block_pose *b)
{
    const struct machine *m = planner->machine;
    double minutes = rotary_minutes(m, a->q, b->q);
    if (planner->follow.mode == INTERPOLATE_JOINT)
        minutes = larger(minutes, vec_distance(a->p, b->p) / m->rapid[MACHINE_X]);
    return minutes;
}

static double degrees(const double a[], const double b[])
{
    return DEGREES(hypot(b[0] - a[0], b[1] - a[1]));
}

/* What one piece of a block asks for. */
struct sample {
    struct vec3 tip, linear;
    double q[ROTARY_MAX];
};

/* s of a NURBS as printed. */
static struct sample sample_of_spline(const struct kinematic_chain *chain,
                                      const struct nc_spline *spline, double s)
{
    const struct bspline *b = &spline->curve;
    double basis[BSPLINE_DEGREE_MAX + 1], from = b->knot[b->degree], to = b->knot[b->poles];
    double u = from + s * (to - from);
    size_t span = bspline_span(b->degree, b->poles, b->knot, u);
    struct sample sample = {.tip = bspline_at(b, b->pole, u)};
    bspline_basis(b->degree, b->knot, span, u, basis);
    for (int k = 0; k < chain->n; k++)
        for (int i = 0; i <= b->degree; i++)
            sample.q[k] +=
                basis[i] * RADIANS(spline->angle[k][span - (size_t)b->degree + (size_t)i]);
    sample.linear = chain_linear(chain, sample.tip, sample.q);
    return sample;
}

/* s of the way from where the program is; the angles come near those of the sample before. */
static struct sample sample_at(const struct nc_planner *planner, const struct block_pose *to,
                               const struct nc_along *along, double s, const double before[])
{
    const struct block_pose *from = &planner->state.at;
    const struct kinematic_chain *chain = &planner->machine->chain;
    int over;
    if (along && along->spline && along->spline->form == NC_NURBS && along->spline->turns)
        return sample_of_spline(chain, along->spline, s);
    struct pose at = along && along->spline && along->spline->turns
                         ? nc_spline_at(along->spline, from->p, s)
                     : along ? motion_at(along->motion, along->s0 + s * (along->s1 - along->s0))
                             : interpolation_pose(&planner->follow, from, to, s);
    if (planner->follow.mode == INTERPOLATE_VECTOR && along && !along->motion->curve)
        at.a = interpolation_pose(&planner->follow, from, to, s).a; /* as it is said */
    struct sample sample = {.tip = at.p};
    for (int i = 0; i < chain->n; i++)
        sample.q[i] = from->q[i] + s * (to->q[i] - from->q[i]);
    bool even_turn = planner->follow.mode == INTERPOLATE_ROTARY && !(along && along->motion->curve);
    if (!even_turn && ik_choose(chain, at.a, before, true, -1, sample.q, &over) != 0)
        sample.q[0] = before[0], sample.q[1] = before[1];
    sample.linear = chain_linear(chain, sample.tip, sample.q);
    return sample;
}

static double piece_minutes(const struct machine *m, const struct sample *a, const struct sample *b)
{
    struct vec3 way = vec_sub(b->linear, a->linear);
    double slides =
        larger(fabs(way.x) / m->rapid[MACHINE_X],
               larger(fabs(way.y) / m->rapid[MACHINE_Y], fabs(way.z) / m->rapid[MACHINE_Z]));
    return larger(slides, rotary_minutes(m, a->q, b->q));
}

/* The slides surely need no longer: a turn takes them no further than its angle times how far the
 * tip and the centres are from 0. */
static bool slides_keep_up(const struct nc_planner *planner, const struct block_pose *to,
                           double length, double turn, double minutes)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double arm = fabs(to->p.x) + fabs(to->p.y) + fabs(to->p.z) + length;
    for (int i = 0; i < chain->n; i++) {
        struct vec3 c = chain->rotary[i].centre;
        arm += 2 * (fabs(c.x) + fabs(c.y) + fabs(c.z));
    }
    return length + turn * arm <= minutes * planner->machine->rapid[MACHINE_X];
}

/*
 * The rotary axes surely need no longer: rotary words turn each at one speed; a vector no axis by
 * more than about the turn of the tool axis over the sine of its angle to the first one.
 */
static bool axes_keep_up(const struct nc_planner *planner, const struct block_pose *to,
                         double minutes)
{
    const struct machine *m = planner->machine;
    if (planner->follow.mode == INTERPOLATE_ROTARY || m->chain.n < 2)
        return true;
    double up = vec_dot(m->chain.rotary[0].axis, to->a), slowest = HUGE_VAL;
    for (int i = 0; i < m->chain.n; i++)
        slowest = fmin(slowest, m->rapid[m->letter[i]]);
    double great = DEGREES(vec_distance(planner->state.at.a, to->a)), sine2 = 1 - up * up;
    return 4 * great * great <= sine2 * minutes * minutes * slowest * slowest;
}

/* In how many pieces a block with vectors is looked at: beside the singular direction a peak is
 * narrow. */
static int pieces_of_vector(const struct nc_planner *planner, double length)
{
    double n = 2 * ceil(length * planner->options.unit / SHORTEST);
    return (int)fmin(fmax(n, 2 * PIECES), PIECES_MOST);
}

/* Where the span of a curve that begins at s ends, by the knots that are printed. */
static double next_knot(const struct nc_along *along, double s)
{
    return along->spline ? nc_spline_next(along->spline, s) : motion_next_knot(along->motion, s);
}

/* A piece of a block: how long it is, and what it takes at least, minutes. */
struct feed_piece {
    double way, minutes;
};

struct feed_pieces {
    size_t n, cap;
    bool still; /* the tip stands: ways are degrees */
    struct feed_piece *item;
};

/* A block from s to `end` in n even pieces; *a: the sample at s, then that at `end`. */
static void add_pieces(const struct nc_planner *planner, const struct block_pose *to,
                       const struct nc_along *along, double s, double end, int n, struct sample *a,
                       struct feed_pieces *pieces)
{
    for (int i = 1; i <= n; i++) {
        struct sample b = sample_at(planner, to, along, i < n ? s + (end - s) * i / n : end, a->q);
        double way = pieces->still ? degrees(a->q, b.q) : vec_distance(a->tip, b.tip);
        *array_push(pieces) = (struct feed_piece){way, piece_minutes(planner->machine, a, &b)};
        *a = b;
    }
}

/* What a mm, or a degree, takes at an even speed where it takes longest: over no less than AT_ONCE,
 * or `half` of a block, for a control that slows down by itself, to whom it is none that an axis is
 * fast over less. */
static double slowest_of(const struct nc_planner *planner, const struct feed_pieces *pieces,
                         double half)
{
    bool slows = planner->machine->slows && !pieces->still;
    double least = slows ? fmin(half, AT_ONCE / planner->options.unit) : 0;
    double way = 0, minutes = 0, most = 0;
    for (size_t i = 0, first = 0; i < pieces->n; i++) {
        way += pieces->item[i].way;
        minutes += pieces->item[i].minutes;
        for (; first < i && way - pieces->item[first].way >= least; first++) {
            way -= pieces->item[first].way;
            minutes -= pieces->item[first].minutes;
        }
        if ((way >= least || i + 1 == pieces->n) && way > 0)
            most = larger(most, minutes / way);
    }
    return most / KEPT;
}

/* The same over any way, however short: minutes that a mm, or a degree, takes. */
static double strictly_slowest(const struct feed_pieces *pieces)
{
    const double none = 1e-9;
    double most = 0;
    for (size_t i = 0; i < pieces->n; i++)
        if (pieces->item[i].way > none)
            most = larger(most, pieces->item[i].minutes / pieces->item[i].way);
    return most;
}

/* What the axes need for a block, minutes: as post_feed_minutes has it, and at the even speed at
 * which none is too fast over any part of it, however short. */
struct feed_need {
    double minutes, strict;
};

/* The same, where `need` is what the ends of the block say. */
static struct feed_need need_within(const struct nc_planner *planner, const struct machine_pose *to,
                                    double length, const struct nc_along *along, double turn,
                                    struct feed_need need)
{
    const struct block_pose *from = &planner->state.at;
    struct feed_pieces pieces = {.still = !(length > 0)};
    bool curve = along && along->motion->curve;
    double minutes = need.minutes, axes = need.strict;
    int n = PIECES * (1 + (int)(3 * turn));
    if (planner->follow.mode == INTERPOLATE_VECTOR)
        n = pieces_of_vector(planner, length);
    struct sample a = sample_at(planner, &to->at, along, 0, from->q);
    for (double s = 0; s < 1;) {
        double end = curve ? next_knot(along, s) : 1;
        add_pieces(planner, &to->at, along, s, end, curve ? SPAN_PIECES : n, &a, &pieces);
        s = end;
    }
    double way = length > 0 ? length : degrees(from->q, to->at.q);
    double half = curve ? length : 0.499 * length;
    need.minutes = larger(minutes, way * slowest_of(planner, &pieces, half));
    need.strict = larger(axes, way * strictly_slowest(&pieces));
    array_free(&pieces);
    return need;
}

static inline struct feed_need need_of(const struct nc_planner *planner,
                                       const struct machine_pose *to, double length,
                                       const struct nc_along *along, double least)
{
    const struct block_pose *from = &planner->state.at;
    const struct machine *m = planner->machine;
    double axes = post_feed_axes_minutes(planner, from, &to->at), turn = 0;
    struct feed_need need = {larger(least, axes), axes};
    bool curve = along && along->motion->curve;
    if (planner->follow.mode == INTERPOLATE_JOINT || m->chain.n == 0)
        return need;
    for (int i = 0; i < m->chain.n; i++)
        turn += fabs(to->at.q[i] - from->q[i]);
    if (!curve && axes_keep_up(planner, &to->at, need.minutes) &&
        slides_keep_up(planner, &to->at, length, turn, need.minutes))
        return need;
    return need_within(planner, to, length, along, turn, need);
}

double post_feed_minutes(const struct nc_planner *planner, const struct machine_pose *to,
                         double length, const struct nc_along *along, double least)
{
    return need_of(planner, to, length, along, least).minutes;
}

/* A curve in spans of which none is shorter than a block may be, but at its end: parts of those
 * between its knots, for beside the singular direction the axes are slow over a small part of one.
 * It is looked at where post_feed_minutes does: a peak that this alone saw would slow all of it. */
static struct feed_spans span_speeds(const struct nc_planner *planner, const struct motion *motion)
{
    const struct block_pose *at = &planner->state.at;
    const struct nc_along along = {motion, 0, 1, NULL, 0};
    const double least = SHORTEST / planner->options.unit;
    const double wished = 1 / (planner->state.feed * planner->state.faster);
    struct feed_spans spans = {0};
    struct feed_span span = {0};
    double minutes = 0;
    struct sample a = sample_at(planner, at, &along, 0, at->q);
    for (double s = 0; s < 1;) {
        double from = s, to = motion_next_knot(motion, s);
        for (int i = 1; i <= SPAN_PIECES; i++) {
            s = i < SPAN_PIECES ? from + (to - from) * i / SPAN_PIECES : to;
            struct sample b = sample_at(planner, at, &along, s, a.q);
            double length = vec_distance(a.tip, b.tip);
            span.s = s;
            span.length += length;
            minutes += piece_minutes(planner->machine, &a, &b);
            a = b;
            if (span.length < least && s < 1)
                continue;
            span.rate = span.length > 0 ? larger(wished, minutes / span.length) : wished;
            *array_push(&spans) = span;
            span = (struct feed_span){0};
            minutes = 0;
        }
    }
    return spans;
}

double post_feed_divide(const struct nc_planner *planner, const struct motion *motion)
{
    if (planner->follow.mode == INTERPOLATE_JOINT || planner->machine->chain.n == 0)
        return 1;
    struct feed_spans spans = span_speeds(planner, motion);
    double s = feed_division(&spans);
    array_free(&spans);
    return s;
}

/* As post_feed_divide, over even spans of a motion from s0 to s1, none shorter than may be. */
static struct feed_spans even_spans(const struct nc_planner *planner, const struct motion *motion,
                                    double s0, double s1, double length)
{
    enum { SPANS = 24 };
    const struct pose end = motion_at(motion, s1);
    const struct block_pose to = {.p = end.p, .a = end.a};
    const struct nc_along along = {motion, s0, s1, NULL, 0};
    double most = floor(length * planner->options.unit / SHORTEST);
    int n = (int)fmin(SPANS, most), looks = (int)fmax(1, fmin(8, most / n));
    struct feed_spans spans = {0};
    struct sample a = sample_at(planner, &to, &along, 0, planner->state.at.q);
    for (int i = 0; i < n; i++) {
        struct feed_span span = {.length = length / n,
                                 .rate = 1 / (planner->state.feed * planner->state.faster)};
        double minutes = 0;
        for (int k = 1; k <= looks; k++) {
            span.s = (i + (double)k / looks) / n;
            struct sample b = sample_at(planner, &to, &along, span.s, a.q);
            minutes = larger(minutes, looks * piece_minutes(planner->machine, &a, &b));
            a = b;
        }
        span.rate = larger(span.rate, minutes / span.length);
        *array_push(&spans) = span;
    }
    return spans;
}

/* A vector turns an axis no faster than the tool over the sine of its angle to the pole: nowhere
 * from one direction to the other does it take one longer than `minutes`. */
static bool turns_slowly(const struct nc_planner *planner, struct vec3 a, struct vec3 b,
                         double minutes)
{
    const struct machine *m = planner->machine;
    struct vec3 pole = m->chain.rotary[0].axis;
    double off = fmin(vec_length(vec_cross(pole, a)), vec_length(vec_cross(pole, b)));
    double turn = vec_distance(a, b), slowest = HUGE_VAL;
    for (int i = 0; i < m->chain.n; i++)
        slowest = fmin(slowest, m->rapid[m->letter[i]]);
    return turn == 0 || (off > turn && 2 * DEGREES(turn) <= (off - turn) * minutes * slowest);
}

double post_feed_divide_even(const struct nc_planner *planner, const struct motion *motion,
                             double s0, double s1)
{
    double length = (s1 - s0) * motion_length(motion);
    double minutes = length / (planner->state.feed * planner->state.faster);
    struct vec3 from = motion_at(motion, s0).a, to = motion_at(motion, s1).a;
    if (planner->follow.mode != INTERPOLATE_VECTOR || planner->machine->chain.n != 2 ||
        !(length * planner->options.unit >= 2 * SHORTEST) ||
        turns_slowly(planner, from, to, minutes) ||
        (post_ik_says_pole(planner, from) && post_ik_says_pole(planner, to)))
        return s1;
    struct feed_spans spans = even_spans(planner, motion, s0, s1, length);
    double s = feed_division(&spans);
    array_free(&spans);
    return s < 1 ? s0 + s * (s1 - s0) : s1;
}

int post_feed_digits(const struct nc_ability *ability, double feed)
{
    int digits = ability->digits.feed;
    if (ability->feeds == NC_FEEDS_INVERSE || feed >= 1)
        return digits;
    return digits + MORE_DIGITS < DIGITS_MAX ? digits + MORE_DIGITS : DIGITS_MAX;
}

/* How far all axes together go, mm and degrees. */
static double joint_length(const struct nc_planner *planner, const struct block_pose *a,
                           const struct block_pose *b)
{
    double way = vec_distance(a->p, b->p);
    for (int i = 0; i < planner->machine->chain.n; i++)
        way = hypot(way, DEGREES(b->q[i] - a->q[i]));
    return way;
}

/* The length that stands for a turn about a tip at rest, mm: one for each degree, or what the ball
 * goes. */
static double turn_length(const struct nc_planner *planner, const struct block_pose *a,
                          const struct block_pose *b)
{
    double way = 0;
    for (int i = 0; i < planner->machine->chain.n; i++)
        way = hypot(way, DEGREES(b->q[i] - a->q[i]));
    return larger(way / planner->options.unit,
                  fabs(planner->follow.ball) * vec_distance(a->a, b->a));
}

/* Notes a block that asks an axis for more than its largest speed: for `need` minutes' worth of it
 * in those that the block takes. */
static void note_fast(const struct nc_planner *planner, struct feed_need need, double takes)
{
    const double over = 1.002; /* digits of F, and places between those looked at */
    struct nc_total *total = &planner->plan->total;
    bool slows = planner->machine->slows;
    double asked = slows ? KEPT * need.minutes : need.strict, peak = need.strict;
    if (!(takes > 0) || !(peak > over * takes))
        return;
    bool fast = asked > over * takes;
    if (fast && total->fast++ == 0)
        total->fast_line = planner->state.line;
    if (fast)
        total->fastest = larger(total->fastest, asked / takes);
    total->peaks++;
    total->peak = larger(total->peak, peak / takes);
}

double post_feed_word(const struct nc_planner *planner, const struct machine_pose *target,
                      double length, const struct nc_along *along, double *minutes)
{
    const struct nc_ability *ability = &planner->plan->ability;
    const struct block_pose *from = &planner->state.at, *to = &target->at;
    bool tip = ability->feeds == NC_FEEDS_TIP;
    if (tip && !along)
        length = vec_distance(from->p, to->p);
    if (tip && along && along->length > 0)
        length = along->length;
    bool still = length < 1 / num_ten[ability->digits.linear], stays = tip && length == 0;
    double feed = planner->state.feed * planner->state.faster, wished = length / feed;
    if (still) /* else the tip alone says how fast it goes */
        wished = larger(length, turn_length(planner, from, to)) / feed;
    struct feed_need need = need_of(planner, target, length, along, wished);
    *minutes = need.minutes;
    bool slow = *minutes > wished;
    if (ability->feeds == NC_FEEDS_INVERSE)
        feed = 1 / larger(*minutes, 1e-9);
    else if (!tip || stays) {
        double way = joint_length(planner, from, to); /* nothing moves: the feed stays as it is */
        feed = way > NOTHING ? way / larger(*minutes, 1e-9) : feed;
    } else if (slow || still)
        feed = length / *minutes;
    for (int i = 0;
         stays && planner->follow.mode == INTERPOLATE_VECTOR && i < planner->machine->chain.n; i++)
        feed = fmin(feed,
                    planner->machine->rapid[planner->machine->letter[i]]); /* now one, now both */
    double may = feed < ability->feed_max ? feed : ability->feed_max;
    int digits = post_feed_digits(ability, may);
    double said = num_round(may, digits);
    if (slow && said > feed * (1 + 1e-9))
        said = num_round(said - 1 / num_ten[digits], digits);
    said = said > 0 ? said : 1 / num_ten[digits];
    double way = ability->feeds == NC_FEEDS_INVERSE ? 1
                 : !tip || stays                    ? joint_length(planner, from, to)
                                                    : length;
    note_fast(planner, need, way / said);
    return said;
}

/* arc_bridge - see arcfit.h, arcfit_bridge: short pieces gone round by a biarc. */
#include "arcfit/arcfit.h"

#include <stdlib.h>

#include "curve/biarc.h"

enum {
    WINDOWS = 7,
    JOINT_PLACES = 4, /* places between two points of the reference */
    OVER = 128, /* pieces that a way goes over on each side, at most: they may be of no length */
};

static const double FIRST = 2.6;    /* times the least length: the first way that is tried, ... */
static const double WIDER = 1.5;    /* ... and how much longer each next one is */
static const double JOINT_NEAR = 4; /* times the least length: so far a joint is moved, no more */
static const double SPARE = 1.1;    /* times the least length: no leg is shorter, so that digits are
                                    left to round */

/* The chain about a short piece, and what replaces it. */
struct bridge {
    const struct reference *reference;
    const struct deviation *within;
    int digits;
    double least;
    const struct pieces *old;
    size_t at;       /* the short piece */
    bool from, past; /* there is one before it, one after it, that goes on in its direction */
    bool straight;   /* the way is a line, with kinks at its ends */
    struct arc_piece some[4];
    size_t first, end, n; /* of the old pieces these are replaced, by so many */
};

static bool goes_on(const struct pieces *pieces, size_t i)
{
    return vec_angle(arc_tangent(&pieces->item[i - 1].arc, 1), pieces->item[i].arc.tangent) <=
           1.01 * ARCFIT_KINK;
}

/* How long a piece is, mm, in a straight line. */
static double ends_apart(const struct arc_piece *piece)
{
    return vec_distance(piece->arc.from, piece->arc.to);
}

/* The way may go on over the joint before piece i, past the piece at one side of it: no kink is
 * there, or one of a piece that is short itself. */
static bool leads_on(const struct bridge *b, const struct arc_piece *piece, size_t i)
{
    return ends_apart(piece) < b->least || goes_on(b->old, i);
}

/* A place on a piece. */
struct place_on {
    struct vec3 p, tangent, axis;
    double place;
};

static struct place_on place_on(const struct bridge *b, const struct arc_piece *piece, double s)
{
    struct place_on at = {vec_round(arc_at(&piece->arc, s), b->digits), arc_tangent(&piece->arc, s),
                          vec_slerp(piece->axis, piece->axis_to, s),
                          piece->from + s * (piece->to - piece->from)};

    if (s <= 0 || s >= 1)
        at.p = s <= 0 ? piece->arc.from : piece->arc.to;
    else
        at.place = reference_place(b->reference, at.p, at.place);
    at.place = fmin(fmax(at.place, piece->from), piece->to);
    return at;
}

/* Where the way begins: `by` mm before the short piece, or with a piece where less of that would be
 * left than may be, or at a kink. */
static struct place_on begin(struct bridge *b, double by)
{
    const struct arc_piece *piece = &b->old->item[b->at];

    b->first = b->at;
    if (!b->from)
        return place_on(b, piece, 0);
    double length = arc_length(&(--piece)->arc);
    for (b->first--;
         by > length && b->first > 0 && b->at - b->first < OVER && leads_on(b, piece, b->first);
         b->first--) {
        by -= length;
        length = arc_length(&(--piece)->arc);
    }
    double s = 1 - by / length;
    if (!(s * length >= SPARE * b->least)) /* or a piece of no length */
        return place_on(b, piece, 0);
    struct place_on at = place_on(b, piece, s);
    struct arc_piece *rest = &b->some[b->n++];
    *rest = *piece;
    rest->arc = arc_to(piece->arc.from, piece->arc.tangent, at.p);
    rest->to = at.place;
    rest->axis_to = at.axis;
    at.tangent = arc_tangent(&rest->arc, 1);
    return at;
}

/* Where it ends; `rest` is what is left of the piece there, if anything is. */
static struct place_on finish(struct bridge *b, double by, struct arc_piece *rest, bool *any)
{
    const struct arc_piece *piece = &b->old->item[b->at];

    *any = false;
    b->end = b->at + 1;
    if (!b->past)
        return place_on(b, piece, 1);
    double length = arc_length(&(++piece)->arc);
    for (b->end++;
         by > length && b->end < b->old->n && b->end - b->at < OVER && leads_on(b, piece, b->end);
         b->end++) {
        by -= length;
        length = arc_length(&(++piece)->arc);
    }
    double s = by / length;
    if (!((1 - s) * length >= SPARE * b->least))
        return place_on(b, piece, 1);
    struct place_on at = place_on(b, piece, s);
    *any = true;
    *rest = *piece;
    rest->arc = arc_to(at.p, at.tangent, piece->arc.to);
    rest->from = at.place;
    rest->axis = at.axis;
    return at;
}

static void add_arc(struct bridge *b, struct arc arc, const struct place_on *from,
                    const struct place_on *to)
{
    b->some[b->n++] = (struct arc_piece){
        .arc = arc, .from = from->place, .to = to->place, .axis = from->axis, .axis_to = to->axis};
}

/* With this direction an arc from one place comes to the other in the direction there: it is
 * mirrored on the chord. */
static struct vec3 tangent_to_meet(const struct place_on *from, const struct place_on *to)
{
    struct vec3 chord = vec_unit(vec_sub(to->p, from->p));

    return vec_along(vec_scale(-1, to->tangent), 2 * vec_dot(to->tangent, chord), chord);
}

/* One arc where an end's direction is free or met anyway, else a biarc.  False: there is none. */
static bool add_way(struct bridge *b, const struct place_on *from, const struct place_on *to)
{
    struct vec3 tangent = b->from ? from->tangent : tangent_to_meet(from, to);
    struct biarc biarc;

    if (vec_distance(from->p, to->p) < b->least)
        return false;
    if (b->straight) {
        add_arc(b, arc_line(from->p, to->p), from, to);
        return true;
    }
    struct arc one = arc_to(from->p, tangent, to->p);
    if (!b->past || vec_angle(arc_tangent(&one, 1), to->tangent) < ARCFIT_KINK / 2) {
        add_arc(b, one, from, to);
        return true;
    }
    if (!biarc_of_ratio(from->p, tangent, to->p, to->tangent, 1, &biarc))
        return false;
    struct place_on middle = {.p = vec_round(biarc.joint, b->digits),
                              .axis = vec_slerp(from->axis, to->axis, 0.5)};
    middle.place = reference_place(b->reference, middle.p, (from->place + to->place) / 2);
    middle.place = fmin(fmax(middle.place, from->place), to->place);
    struct arc first = arc_to(from->p, tangent, middle.p);
    add_arc(b, first, from, &middle);
    add_arc(b, arc_to(middle.p, arc_tangent(&first, 1), to->p), &middle, to);
    return true;
}

static bool turns(const struct arc_piece *before, const struct arc_piece *after)
{
    return vec_angle(arc_tangent(&before->arc, 1), after->arc.tangent) > ARCFIT_KINK;
}

/* The new pieces are long enough, keep the tolerance, and bring no kink but those of a line. */
static bool is_good(const struct bridge *b)
{
    const struct arc_piece *old = b->old->item;

    for (size_t i = 0; i < b->n; i++) {
        struct deviation off = arc_piece_decision(b->reference, &b->some[i], 4, b->within);
        if (!(ends_apart(&b->some[i]) >= b->least) || !deviation_within(&off, b->within) ||
            (i > 0 && !b->straight && turns(&b->some[i - 1], &b->some[i])))
            return false;
    }
    if (b->straight)
        return true;
    if (b->first > 0 && turns(&old[b->first - 1], b->some) && goes_on(b->old, b->first))
        return false;
    return b->end == b->old->n || !turns(&b->some[b->n - 1], &old[b->end]) ||
           !goes_on(b->old, b->end);
}

/* Ways of this length, more or less before or after the short piece. */
static bool find_way(struct bridge *b, double window)
{
    static const double shares[] = {0.5, 0.25, 0.75, 0, 1};
    double more = window - arc_length(&b->old->item[b->at].arc);

    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        double share = !b->from ? 0 : !b->past ? 1 : shares[i];
        struct arc_piece rest;
        bool any;
        b->n = 0;
        struct place_on from = begin(b, share * more),
                        to = finish(b, (1 - share) * more, &rest, &any);
        bool found = add_way(b, &from, &to);
        if (any)
            b->some[b->n++] = rest;
        if (found && is_good(b))
            return true;
    }
    return false;
}

static void replace(struct pieces *pieces, const struct bridge *b)
{
    struct pieces old = *pieces, all = {0};

    for (size_t i = 0; i < b->first; i++)
        *array_push(&all) = old.item[i];
    for (size_t i = 0; i < b->n; i++)
        *array_push(&all) = b->some[i];
    for (size_t i = b->end; i < old.n; i++)
        *array_push(&all) = old.item[i];
    *pieces = all;
    array_free(&old);
}

/* Ways that become longer. */
static bool find_ways(struct bridge *b)
{
    double window = FIRST * b->least;
    bool good = false;

    for (int k = 0; k < WINDOWS && !good && (b->from || b->past); k++, window *= WIDER)
        good = find_way(b, window);
    return good;
}

/* The joint of the short piece and its neighbour after it (`past`) or before it is put onto another
 * place of the reference near it: a line to there in place of the short one, and an arc that meets
 * the other end of its neighbour as that does. */
static bool move_joint(struct bridge *b, bool past)
{
    const struct arc_piece *a = &b->old->item[past ? b->at : b->at - 1], *z = a + 1;
    struct place_on ends[3] = {place_on(b, a, 0), {.place = a->to}, place_on(b, z, 1)};
    double by = 1.0 / JOINT_PLACES, near = JOINT_NEAR * b->least;

    b->first = past ? b->at : b->at - 1;
    b->end = b->first + 2;
    for (double at = a->from + by; at < z->to; at += by) {
        struct place_on *joint = &ends[1];
        *joint = (struct place_on){.p = vec_round(reference_point(b->reference, at), b->digits),
                                   .axis = reference_axis(b->reference, at),
                                   .place = at};
        if (vec_distance(joint->p, a->arc.to) > near)
            continue;
        b->n = 0;
        struct vec3 tangent = past ? tangent_to_meet(joint, &ends[2]) : ends[0].tangent;
        for (int k = 0; k < 2; k++) {
            struct vec3 from = ends[k].p, to = ends[k + 1].p;
            bool line = (k == 0) == past;
            add_arc(b, line ? arc_line(from, to) : arc_to(from, tangent, to), &ends[k],
                    &ends[k + 1]);
        }
        if (is_good(b))
            return true;
    }
    return false;
}

/* On each side the way goes on, or there is a kink where `straight` or nothing else is found. */
static bool find_any(struct bridge *b, bool straight)
{
    const struct pieces *pieces = b->old;
    bool before = b->at > 0, after = b->at + 1 < pieces->n;

    b->straight = straight;
    b->from = before && (straight || goes_on(pieces, b->at));
    b->past = after && (straight || goes_on(pieces, b->at + 1));
    bool good = find_ways(b);
    for (int side = 0; side < 2 && !good; side++) {
        b->past = side == 0 && after;
        b->from = side == 1 && before;
        good = find_ways(b);
    }
    return good ||
           (straight && ((after && move_joint(b, true)) || (before && move_joint(b, false))));
}

static size_t bridge_all(struct bridge *b, bool straight, struct pieces *pieces)
{
    size_t left = 0;

    b->old = pieces;
    for (b->at = 0; b->at < pieces->n; b->at++) {
        if (ends_apart(&pieces->item[b->at]) >= b->least)
            continue;
        bool good = find_any(b, straight);
        if (good) {
            replace(pieces, b);
            b->at = b->first + b->n - 1;
        }
        left += !good;
    }
    return left;
}

size_t arcfit_bridge(const struct reference *reference, const struct deviation *within, int digits,
                     double least, struct pieces *pieces)
{
    struct bridge b = {.reference = reference, .within = within, .digits = digits, .least = least};

    return bridge_all(&b, false, pieces);
}

size_t arcfit_cut(const struct reference *reference, const struct deviation *within, int digits,
                  double least, struct pieces *pieces)
{
    struct bridge b = {.reference = reference, .within = within, .digits = digits, .least = least};

    return bridge_all(&b, true, pieces);
}

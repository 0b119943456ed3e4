/* arc_link - see arc_link.h. */
#include "arcfit/arc_link.h"

#include "curve/biarc.h"

enum {
    CHAINED = 6,  /* biarcs at most, one after the other, */
    PLACES = 16,  /* each of which ends at one of so many places */
    LOOKED_AT = 8 /* parts of a piece */
};

/* Shares of ARC_LINK_KINK: so much the directions at the ends are turned out of the part. */
static const double TURNED[] = {0, 0.33, 0.67, 0.8, 1};

/* Of the length between two joints: so much higher inner joints are. */
static const double RAISED[] = {0, 0.05, 0.15};

static const double RATIO[] = {1, 0.5, 2}; /* of a biarc's legs */
static const double TURN_MAX = 3.7;        /* of one arc, radians: a little over half round */

/* No axis is farther off the one that was planned, which the machine is known to reach. */
static const double ASTRAY = RADIANS(2.5);

enum {
    TURNS = sizeof TURNED / sizeof *TURNED,
    RAISES = sizeof RAISED / sizeof *RAISED,
    RATIOS = sizeof RATIO / sizeof *RATIO
};

struct link_search {
    const struct reference *reference;
    const struct arc_link_options *options;
    struct vec3 leave, arrive; /* at the ends of the reference */
    struct vec3 out[2];
    struct pieces *pieces;
};

static size_t last_point(const struct link_search *s)
{
    return s->reference->n - 1;
}

/* The direction at an end turned out of the part. */
static struct vec3 turned_out(const struct link_search *s, bool end, double angle)
{
    struct vec3 t = end ? s->arrive : s->leave;
    struct vec3 up = vec_unit(vec_reject(s->out[end], t));

    return vec_unit(vec_along(t, end ? -tan(angle) : tan(angle), up));
}

static void add_piece(const struct link_search *s, struct arc arc, double from, double to)
{
    *array_push(s->pieces) = arc_piece_of(s->reference, arc, from, to);
}

/* Out of the part at a point of the way. */
static struct vec3 out_at(const struct link_search *s, size_t k)
{
    double length = s->reference->length[last_point(s)];

    return vec_slerp(s->out[0], s->out[1], length > 0 ? s->reference->length[k] / length : 0);
}

/* The piece is nowhere lower than the way it was planned on. */
static bool is_above(const struct link_search *s, const struct arc_piece *piece)
{
    const struct reference *r = s->reference;
    double place = piece->from;

    for (int i = 1; i < LOOKED_AT; i++) {
        struct vec3 p = arc_at(&piece->arc, (double)i / LOOKED_AT);
        place = reference_place(r, p, place);
        struct vec3 off = vec_sub(p, reference_point(r, place));
        if (vec_dot(off, out_at(s, (size_t)place)) < -s->options->below)
            return false;
    }
    return true;
}

/* What is tried, the pieces from `first` on: none too short or bent too much, none turns too far,
 * none is too far off, and the tool is clear. */
static bool is_good(const struct link_search *s, size_t first)
{
    const double off = s->options->off;
    const struct deviation within = {off, off, ASTRAY};
    const struct pieces some = {.n = s->pieces->n - first, .item = s->pieces->item + first};

    for (size_t i = 0; i < some.n; i++) {
        const struct arc_piece *piece = &some.item[i];
        if (piece->arc.angle > TURN_MAX || !(arc_length(&piece->arc) >= s->options->least) ||
            (!arc_straight(&piece->arc) && piece->arc.radius < s->options->least))
            return false;
        if (!is_above(s, piece))
            return false;
        struct deviation found = arc_piece_decision(s->reference, piece, 4, &within);
        if (!deviation_within(&found, &within))
            return false;
    }
    return some.n > 0 && s->options->clear(s->options->context, &some);
}

/* ---- one piece */

/* An arc that begins between the direction of the cut before it, and that from which it would end
 * in the direction of the one after it. */
static bool try_single(struct link_search *s)
{
    const struct reference *r = s->reference;
    struct vec3 from = r->point[0], to = r->point[last_point(s)];
    struct vec3 chord = vec_unit(vec_sub(to, from));
    struct vec3 back = vec_along(vec_scale(-1, s->arrive), 2 * vec_dot(s->arrive, chord), chord);
    struct vec3 mean = vec_unit(vec_add(s->leave, back));

    for (int k = 0; k < TURNS; k++) {
        struct vec3 up = vec_unit(vec_reject(s->out[0], mean));
        struct vec3 t = vec_unit(vec_along(mean, tan(TURNED[k] * ARC_LINK_KINK), up));
        struct arc arc = arc_to(from, t, to);
        if (vec_angle(arc.tangent, s->leave) > ARC_LINK_KINK ||
            vec_angle(arc_tangent(&arc, 1), s->arrive) > ARC_LINK_KINK)
            continue;
        s->pieces->n = 0;
        add_piece(s, arc, 0, (double)last_point(s));
        if (is_good(s, 0))
            return true;
    }
    return false;
}

/* ---- biarcs */

struct link_joint {
    struct vec3 p, tangent;
    size_t at; /* point of the reference */
};

/* Appends the biarc from joint to joint; false: there is none. */
static bool add_biarc(const struct link_search *s, const struct link_joint *a,
                      const struct link_joint *b, double ratio)
{
    struct biarc biarc;

    if (!biarc_of_ratio(a->p, a->tangent, b->p, b->tangent, ratio, &biarc))
        return false;
    struct vec3 joint = vec_round(biarc.joint, s->options->digits);
    double from = (double)a->at, to = (double)b->at;
    double place = reference_place(s->reference, joint, (from + to) / 2);
    struct arc first = arc_to(a->p, a->tangent, joint);
    place = fmin(to, fmax(from, place));
    add_piece(s, first, from, place);
    add_piece(s, arc_to(joint, arc_tangent(&first, 1), b->p), place, to);
    return true;
}

/* The point of the reference at so much of its length. */
static size_t point_at(const struct reference *r, double part)
{
    size_t k = 0;

    while (k + 1 < r->n && r->length[k] < part * r->length[r->n - 1])
        k++;
    return k;
}

/* A joint at so much of the length, `height` mm out of the part; at the end, the direction is
 * turned out. */
static struct link_joint joint_at(const struct link_search *s, double part, double height,
                                  double turned)
{
    const struct reference *r = s->reference;
    size_t k = point_at(r, part);

    if (part >= 1)
        return (struct link_joint){r->point[k], turned_out(s, true, turned), k};
    struct vec3 p = vec_along(r->point[k], height, out_at(s, k));
    return (struct link_joint){vec_round(p, s->options->digits), r->tangent[k], k};
}

/* Appends the biarc from joint to joint if it is good. */
static bool try_biarc(struct link_search *s, const struct link_joint *a, const struct link_joint *b,
                      double ratio)
{
    size_t n = s->pieces->n;

    if (b->at > a->at && add_biarc(s, a, b, ratio) && is_good(s, n))
        return true;
    s->pieces->n = n;
    return false;
}

/* From joint to end by one biarc. */
static bool try_end(struct link_search *s, const struct link_joint *a)
{
    for (int k = 0; k < TURNS; k++) {
        struct link_joint b = joint_at(s, 1, 0, TURNED[k] * ARC_LINK_KINK);
        for (int i = 0; i < RATIOS; i++)
            if (try_biarc(s, a, &b, RATIO[i]))
                return true;
    }
    return false;
}

/* By one biarc as far along the way as it goes; its end becomes the joint, at so many PLACES.
 * False: it goes nowhere. */
static bool try_on(struct link_search *s, struct link_joint *a, int *at)
{
    double length = s->reference->length[last_point(s)];

    for (int to = PLACES - 1; to > *at; to--)
        for (int raise = 0; raise < RAISES; raise++) {
            double height = RAISED[raise] * length * (to - *at) / PLACES;
            struct link_joint b = joint_at(s, (double)to / PLACES, height, 0);
            if (!try_biarc(s, a, &b, 1))
                continue;
            *a = b;
            *at = to;
            return true;
        }
    return false;
}

/* One biarc after the other, as far as they have come. */
struct link_chain {
    struct link_joint end;
    int at; /* of PLACES */
    bool stuck;
    size_t n;
    struct arc_piece piece[2 * CHAINED];
};

/* The chain, of `had` biarcs that do not come to the end, with up to `most` of them. */
static bool try_chain(struct link_search *s, struct link_chain *chain, int had, int most)
{
    s->pieces->n = 0;
    for (size_t i = 0; i < chain->n; i++)
        *array_push(s->pieces) = chain->piece[i];
    for (int i = had; i < most && !chain->stuck; i++) {
        chain->stuck = i > 0 && !try_on(s, &chain->end, &chain->at);
        if (!chain->stuck && try_end(s, &chain->end))
            return true;
    }
    chain->n = s->pieces->n;
    for (size_t i = 0; i < chain->n; i++)
        chain->piece[i] = s->pieces->item[i];
    return false;
}

/* From directions turned out, the shorter ones first. */
static bool try_chains(struct link_search *s)
{
    static const int most[] = {0, 1, 2, CHAINED};
    struct link_chain chain[TURNS];

    for (int k = 0; k < TURNS; k++) {
        double turned = TURNED[k] * ARC_LINK_KINK;
        chain[k].end = (struct link_joint){s->reference->point[0], turned_out(s, false, turned), 0};
        chain[k].at = 0;
        chain[k].stuck = false;
        chain[k].n = 0;
    }
    for (size_t i = 1; i < sizeof most / sizeof *most; i++)
        for (int k = 0; k < TURNS; k++)
            if (try_chain(s, &chain[k], most[i - 1], most[i]))
                return true;
    return false;
}

bool arcfit_link(const struct reference *reference, const struct arc_link_options *options,
                 struct pieces *pieces)
{
    struct link_search s = {.reference = reference, .options = options, .pieces = pieces};

    pieces->n = 0;
    if (reference->n < 2)
        return false;
    s.leave = vec_length(options->leave) > 0 ? options->leave : reference->tangent[0];
    s.arrive =
        vec_length(options->arrive) > 0 ? options->arrive : reference->tangent[last_point(&s)];
    for (int i = 0; i < 2; i++)
        s.out[i] = vec_length(options->out[i]) > 0 ? options->out[i]
                                                   : reference->axis[i ? last_point(&s) : 0];
    if (try_single(&s) || try_chains(&s))
        return true;
    pieces->n = 0;
    return false;
}

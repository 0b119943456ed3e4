/* arc_link - see arc_link.h. */
#include "arcfit/arc_link.h"

#include "curve/biarc.h"

enum { CHAINED = 6, JOINTS = CHAINED + 1 }; /* biarcs at most, one after the other */

/* Shares of ARC_LINK_KINK: so much the directions at the ends are turned out of the part. */
static const double TURNED[] = {0, 0.2, 0.5, 1};

/* Of the length between two joints: so much higher inner joints are. */
static const double RAISED[] = {0, 0.05, 0.15};

static const double RATIO[] = {1, 0.5, 2}; /* of a biarc's legs */
static const double TURN_MAX = 3.7;        /* of one arc, radians: a little over half round */

enum {
    TURNS = sizeof TURNED / sizeof *TURNED,
    RAISES = sizeof RAISED / sizeof *RAISED,
    RATIOS = sizeof RATIO / sizeof *RATIO
};

struct link_search {
    const struct reference *reference;
    const struct arc_link_options *options;
    struct vec3 leave, arrive; /* at the ends of the reference */
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
    struct vec3 up = vec_unit(vec_reject(s->reference->axis[end ? last_point(s) : 0], t));

    return vec_unit(vec_along(t, end ? -tan(angle) : tan(angle), up));
}

static void add_piece(const struct link_search *s, struct arc arc, double from, double to)
{
    *array_push(s->pieces) = arc_piece_of(s->reference, arc, from, to);
}

/* What is tried: no piece too short, none turns too far, none is too far off, and the tool is
 * clear. */
static bool is_good(const struct link_search *s)
{
    const double off = s->options->off;
    const struct deviation within = {off, off, HUGE_VAL};

    for (size_t i = 0; i < s->pieces->n; i++) {
        const struct arc_piece *piece = &s->pieces->item[i];
        if (piece->arc.angle > TURN_MAX || !(arc_length(&piece->arc) >= s->options->least))
            return false;
        struct deviation found = arc_piece_deviation(s->reference, piece, 4, &within);
        if (found.point > off || found.other > off)
            return false;
    }
    return s->pieces->n > 0 && s->options->clear(s->options->context, s->pieces);
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
        struct vec3 up = vec_unit(vec_reject(r->axis[0], mean));
        struct vec3 t = vec_unit(vec_along(mean, tan(TURNED[k] * ARC_LINK_KINK), up));
        struct arc arc = arc_to(from, t, to);
        if (vec_angle(arc.tangent, s->leave) > ARC_LINK_KINK ||
            vec_angle(arc_tangent(&arc, 1), s->arrive) > ARC_LINK_KINK)
            continue;
        s->pieces->n = 0;
        add_piece(s, arc, 0, (double)last_point(s));
        if (is_good(s))
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

/* Joints of `n` biarcs: the ends, and points of the reference between. */
static void set_joints(const struct link_search *s, int n, double turned, double raised,
                       struct link_joint *joint)
{
    const struct reference *r = s->reference;
    size_t last = last_point(s);
    double height = raised * r->length[last] / n;

    joint[0] = (struct link_joint){r->point[0], turned_out(s, false, turned), 0};
    joint[n] = (struct link_joint){r->point[last], turned_out(s, true, turned), last};
    for (int i = 1; i < n; i++) {
        size_t k = point_at(r, (double)i / n);
        struct vec3 p = vec_along(r->point[k], height, r->axis[k]);
        joint[i] = (struct link_joint){vec_round(p, s->options->digits), r->tangent[k], k};
    }
}

static bool try_chain(struct link_search *s, int n, double turned, double raised, double ratio)
{
    struct link_joint joint[JOINTS];
    bool good = true;

    set_joints(s, n, turned, raised, joint);
    s->pieces->n = 0;
    for (int i = 0; i < n && good; i++)
        good = add_biarc(s, &joint[i], &joint[i + 1], ratio);
    return good && is_good(s);
}

static bool try_chains(struct link_search *s, int n)
{
    for (int k = 0; k < TURNS; k++)
        for (int raise = 0; raise < (n > 1 ? RAISES : 1); raise++)
            for (int ratio = 0; ratio < (n > 1 ? 1 : RATIOS); ratio++)
                if (try_chain(s, n, TURNED[k] * ARC_LINK_KINK, RAISED[raise], RATIO[ratio]))
                    return true;
    return false;
}

bool arcfit_link(const struct reference *reference, const struct arc_link_options *options,
                 struct pieces *pieces)
{
    struct link_search s = {.reference = reference, .options = options, .pieces = pieces};
    bool good = false;

    pieces->n = 0;
    if (reference->n < 2)
        return false;
    s.leave = vec_length(options->leave) > 0 ? options->leave : reference->tangent[0];
    s.arrive =
        vec_length(options->arrive) > 0 ? options->arrive : reference->tangent[last_point(&s)];
    good = try_single(&s);
    for (int n = 1; n <= CHAINED && !good; n++)
        good = try_chains(&s, n);
    if (!good)
        pieces->n = 0;
    return good;
}

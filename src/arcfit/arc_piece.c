/* arc_piece - see arc_piece.h. */
#include "arcfit/arc_piece.h"

#include "curve/polyline.h"

enum { FINE_MAX = 64 };

static const double SAGITTA = 1.0 / 20; /* of the tolerance: between the places looked at */
static const double ROUNDING = 1e-9;    /* mm: more than what is computed may be off */

struct arc_piece arc_piece_of(const struct reference *reference, struct arc arc, double from,
                              double to)
{
    return (struct arc_piece){.arc = arc,
                              .from = from,
                              .to = to,
                              .axis = reference_axis(reference, from),
                              .axis_to = reference_axis(reference, to)};
}

/* Distances between matching places, mm. */
struct distances {
    double point, other;
};

/* Where the piece is at one place. */
struct position {
    struct vec3 p, axis, turn, other;
};

/* The measurement of one piece, from its start to its end. */
struct measurement {
    const struct reference *reference;
    const struct arc *arc;
    struct vec3 axis, aside; /* the axis at an angle u: axis cos u + aside sin u */
    double turn;             /* in all, radians */
    double length;           /* of the arc */
    bool alone; /* the other point is as far off as this one: no offset, or the axis is still */
    struct deviation found; /* its axis: the square of the chord between the unit vectors */
    size_t point, other;    /* segments of the reference where the last feet were */
    struct distances here;  /* at the foot of the last point */
    struct position at;     /* there */
    double enough; /* so near an other point is to the piece that no nearer place is sought */
};

static struct position position_at(const struct measurement *f, double s)
{
    struct position position = {.p = arc_at(f->arc, s)};
    if (f->alone)
        return position;
    struct sine_cosine u = elementary_sine_cosine(s * f->turn);
    position.axis = vec_along(vec_scale(u.cosine, f->axis), u.sine, f->aside);
    position.turn = vec_along(vec_scale(-u.sine, f->axis), u.cosine, f->aside);
    position.other = vec_along(position.p, f->reference->offset, position.axis);
    return position;
}

/* From a place of the piece to the reference. */
static void measure_to_reference(struct measurement *f, const struct position *at)
{
    const struct reference *t = f->reference;
    double d =
        polyline_descend((struct polyline){t->n, t->point}, &t->point_stays, at->p, &f->point);
    f->found.point = fmax(f->found.point, d);
    if (f->alone)
        return;
    d = polyline_descend((struct polyline){t->n, t->other}, &t->other_stays, at->other, &f->other);
    f->found.other = fmax(f->found.other, d);
}

/* From the other point k of the reference to the piece: near s, by Newton steps towards its foot.
 */
static void measure_from_other(struct measurement *f, size_t k, double s, struct position position)
{
    struct vec3 off = vec_sub(f->reference->other[k], position.other);
    double d = vec_length(off);
    for (int i = 0; i < 2 && d > f->found.other && d > f->enough; i++) {
        struct vec3 v = vec_scale(f->length, arc_tangent(f->arc, s));
        v = vec_along(v, f->reference->offset * f->turn, position.turn);
        double v2 = vec_dot(v, v);
        if (v2 <= 0)
            break;
        s = fmin(1, fmax(0, s + vec_dot(off, v) / v2));
        position = position_at(f, s);
        off = vec_sub(f->reference->other[k], position.other);
        d = fmin(d, vec_length(off));
    }
    f->found.other = fmax(f->found.other, d);
}

/* From point k of the reference, whose foot is s, to the piece. */
static void measure_from_point(struct measurement *f, size_t k, double s)
{
    const struct reference *t = f->reference;
    struct position position = position_at(f, s);
    f->at = position;
    f->here.point = vec_distance(t->point[k], position.p);
    f->found.point = fmax(f->found.point, f->here.point);
    if (f->alone)
        return;
    f->here.other = vec_distance(t->other[k], position.other);
    struct vec3 turned = vec_sub(t->axis[k], position.axis);
    f->found.axis = fmax(f->found.axis, vec_dot(turned, turned));
    measure_from_other(f, k, s, position);
}

/* Places between two feet that have to be looked at, by the sagitta between them. */
static int places_between(const struct arc *arc, double s0, double s1, int fine, double limit)
{
    double turn = (s1 - s0) * arc->angle, sagitta = arc->radius * turn * turn / 8;
    double need = ceil(sqrt(sagitta / (limit * SAGITTA)));
    return need > fine ? need < FINE_MAX ? (int)need : FINE_MAX : fine;
}

static struct measurement measurement_of(const struct reference *reference,
                                         const struct arc_piece *m)
{
    struct measurement f = {.reference = reference, .arc = &m->arc, .axis = m->axis};
    f.length = arc_length(&m->arc);
    f.turn = vec_angle(m->axis, m->axis_to);
    if (f.turn > 0) {
        f.aside = vec_unit(vec_reject(m->axis_to, m->axis));
        if (vec_dot(f.aside, f.aside) < 0.5)
            f.turn = 0;
    }
    double part;
    f.point = f.other = reference_interval(reference, m->from, &part);
    return f;
}

/* The axis stands still in the piece and in its part of the reference: both points found alike. */
static bool axis_still(const struct reference *t, const struct measurement *f, size_t from,
                       size_t to)
{
    if (f->turn > 0)
        return false;
    for (size_t k = from; k < to; k++)
        if (vec_distance(t->axis[k], f->axis) > 0)
            return false;
    return true;
}

/* A few points first: most pieces that are too far off fail here. */
static bool check_few(struct measurement *f, size_t first, size_t end,
                      const struct deviation *within)
{
    size_t stride = (end - first) / 8;
    for (size_t k = first + stride / 2; stride > 1 && k < end; k += stride) {
        measure_from_point(f, k, arc_foot(f->arc, f->reference->point[k]));
        if (!deviation_within(&f->found, within))
            return false;
    }
    return true;
}

/*
 * Nothing between two feet can be off by more than `within`: between the chords of the piece and
 * the straight line of the reference it is no more than at their ends, and a sagitta on top.
 */
static bool must_be_within(const struct measurement *f, struct distances before, double part,
                           const struct deviation *within)
{
    double turn = part * f->arc->angle, turn_of_axis = part * f->turn;
    double sagitta = f->arc->radius * turn * turn / 8;
    double most = fmax(before.point, f->here.point) + sagitta;
    if (most > within->point)
        return false;
    double turned = fabs(f->reference->offset) * turn_of_axis * turn_of_axis / 8;
    return f->alone || fmax(before.other, f->here.other) + sagitta + turned <= within->other;
}

/* How far a is off segment k of a polyline, or b if that is farther off. */
static double farther_off(const struct vec3 *line, size_t k, struct vec3 a, struct vec3 b)
{
    return fmax(vec_segment_distance(line[k], line[k + 1], a),
                vec_segment_distance(line[k], line[k + 1], b));
}

/*
 * The same between two places of the piece, beside the segments where f has come to: a chord of
 * the piece is nowhere farther off them than at its ends.
 */
static bool stays_beside(const struct measurement *f, const struct position *from,
                         const struct position *to, double part, const struct deviation *within)
{
    const struct reference *t = f->reference;
    double turn = part * f->arc->angle, turn_of_axis = part * f->turn;
    double sagitta = f->arc->radius * turn * turn / 8 + ROUNDING;
    double turned = fabs(t->offset) * turn_of_axis * turn_of_axis / 8;

    return farther_off(t->point, f->point, from->p, to->p) + sagitta <= within->point &&
           (f->alone ||
            farther_off(t->other, f->other, from->other, to->other) + sagitta + turned <=
                within->other);
}

/* From one foot to the next, at `fine` places between, or more. */
static void check_between(struct measurement *f, double from, double to, int fine, double limit)
{
    int parts = to > from ? places_between(f->arc, from, to, fine, limit) : 0;
    for (int i = 1; i <= parts; i++) {
        struct position at = position_at(f, from + (to - from) * i / (parts + 1));
        measure_to_reference(f, &at);
    }
}

/* How far the start of the piece, f->at, is from where it should be; unknown between two points. */
static struct distances distance_at_start(const struct measurement *f,
                                          const struct arc_piece *piece)
{
    size_t k = (size_t)piece->from;
    if ((double)k < piece->from)
        return (struct distances){HUGE_VAL, HUGE_VAL};
    return (struct distances){vec_distance(f->reference->point[k], f->at.p),
                              f->alone ? 0 : vec_distance(f->reference->other[k], f->at.other)};
}

/* Whether places between two feet are to be looked at. */
enum between {
    ALWAYS,   /* all */
    FIGURES,  /* those which what is found at the feet does not say to be within */
    DECISION, /* those which may not be within */
};

/* Nothing between two places has to be looked at. */
static bool may_pass(const struct measurement *f, enum between how, const struct position *from,
                     const struct position *to, double part, const struct deviation *within)
{
    if (how == DECISION)
        return stays_beside(f, from, to, part, within);
    return how == ALWAYS && stays_beside(f, from, to, part, &f->found);
}

/* All points of the piece's part of the reference, and places between their feet. */
static void check_all(struct measurement *f, const struct arc_piece *piece, int fine,
                      enum between how, const struct deviation *within)
{
    const struct position last = position_at(f, 1);
    double limit = fmin(within->point, 0.1), at = 0;
    size_t end = (size_t)piece->to + 1;
    f->at = position_at(f, 0);
    measure_to_reference(f, &f->at);
    f->here = distance_at_start(f, piece);
    for (size_t k = (size_t)piece->from + 1; k < end && deviation_within(&f->found, within); k++) {
        double foot = fmax(at, arc_foot(f->arc, f->reference->point[k]));
        struct distances before = f->here;
        struct position from = f->at;
        measure_from_point(f, k, foot);
        f->point = f->other = k - 1;
        if ((how == ALWAYS || !must_be_within(f, before, foot - at, within)) &&
            !may_pass(f, how, &from, &f->at, foot - at, within))
            check_between(f, at, foot, fine, limit);
        at = foot;
    }
    if (deviation_within(&f->found, within) && !may_pass(f, how, &f->at, &last, 1 - at, within))
        check_between(f, at, 1, fine, limit);
    measure_to_reference(f, &last);
}

static struct deviation deviation_of(const struct reference *reference,
                                     const struct arc_piece *piece, int fine, enum between how,
                                     const struct deviation *within)
{
    struct measurement f = measurement_of(reference, piece);
    size_t first = (size_t)piece->from + 1, end = (size_t)piece->to + 1;
    f.alone = reference->offset == 0 || axis_still(reference, &f, first, end);
    if (reference->n < 2)
        return f.found;
    struct deviation limit = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    if (within) {
        double chord = 2 * sin(fmin(within->axis, PI) / 2);
        limit = *within;
        limit.axis = chord * chord;
        f.enough = how == DECISION ? within->other : 0;
    }
    if (check_few(&f, first, end, &limit))
        check_all(&f, piece, fine, limit.point < HUGE_VAL ? how : ALWAYS, &limit);
    if (f.alone && reference->offset != 0)
        f.found.other = f.found.point;
    f.found.axis = 2 * asin(fmin(1, sqrt(f.found.axis) / 2));
    return f.found;
}

struct deviation arc_piece_deviation(const struct reference *reference,
                                     const struct arc_piece *piece, int fine,
                                     const struct deviation *within)
{
    return deviation_of(reference, piece, fine, FIGURES, within);
}

struct deviation arc_piece_decision(const struct reference *reference,
                                    const struct arc_piece *piece, int fine,
                                    const struct deviation *within)
{
    return deviation_of(reference, piece, fine, DECISION, within);
}

/* arc_piece - see arc_piece.h. */
#include "arcfit/arc_piece.h"

enum { FINE_MAX = 64 };

struct arc_piece arc_piece_of(const struct trace *trace, struct arc arc, double from, double to)
{
    return (struct arc_piece){.arc = arc,
                              .from = from,
                              .to = to,
                              .axis = trace_axis(trace, from),
                              .axis_to = trace_axis(trace, to)};
}

bool arc_deviation_within(const struct arc_deviation *stray, const struct arc_deviation *within)
{
    return stray->tracked <= within->tracked && stray->other <= within->other &&
           stray->axis <= within->axis;
}

struct arc_deviation arc_deviation_worst(struct arc_deviation a, struct arc_deviation b)
{
    return (struct arc_deviation){fmax(a.tracked, b.tracked), fmax(a.other, b.other),
                                  fmax(a.axis, b.axis)};
}

/* Distances between matching places, mm. */
struct apart {
    double tracked, other;
};

/* A piece made ready to be asked for many places. */
struct follower {
    const struct trace *trace;
    const struct arc *arc;
    struct vec3 axis, aside;    /* the axis at an angle u: axis cos u + aside sin u */
    double swing;               /* in all, radians */
    double length;              /* of the arc */
    bool lone;                  /* nobody at the other end: no lever, or the axis is still */
    struct arc_deviation stray; /* its axis: the square of the chord between the unit vectors */
    size_t tracked, other;      /* segments of the trace last met */
    struct apart here;          /* at the foot of the point last met */
};

/* Where the piece is at one place. */
struct spot {
    struct vec3 p, axis, turn, other;
};

static struct spot spot_at(const struct follower *f, double s)
{
    struct spot spot = {.p = arc_at(f->arc, s)};
    if (f->lone)
        return spot;
    double u = s * f->swing, c = cos(u), d = sin(u);
    spot.axis = vec_along(vec_scale(c, f->axis), d, f->aside);
    spot.turn = vec_along(vec_scale(-d, f->axis), c, f->aside);
    spot.other = vec_along(spot.p, f->trace->lever, spot.axis);
    return spot;
}

/* From the piece at s to the trace. */
static void meet_trace(struct follower *f, double s)
{
    const struct trace *t = f->trace;
    struct spot spot = spot_at(f, s);
    double d = trace_distance(t->p, t->n, spot.p, &f->tracked);
    f->stray.tracked = fmax(f->stray.tracked, d);
    if (f->lone)
        return;
    d = trace_distance(t->other, t->n, spot.other, &f->other);
    f->stray.other = fmax(f->stray.other, d);
}

/* From the other point k of the trace to the piece: near s, by Newton steps towards its foot. */
static void meet_other(struct follower *f, size_t k, double s, struct spot spot)
{
    struct vec3 off = vec_sub(f->trace->other[k], spot.other);
    double d = vec_length(off);
    for (int i = 0; i < 2 && d > f->stray.other; i++) {
        struct vec3 v = vec_scale(f->length, arc_tangent(f->arc, s));
        v = vec_along(v, f->trace->lever * f->swing, spot.turn);
        double v2 = vec_dot(v, v);
        if (v2 <= 0)
            break;
        s = fmin(1, fmax(0, s + vec_dot(off, v) / v2));
        spot = spot_at(f, s);
        off = vec_sub(f->trace->other[k], spot.other);
        d = fmin(d, vec_length(off));
    }
    f->stray.other = fmax(f->stray.other, d);
}

/* From point k of the trace, whose foot is s, to the piece. */
static void meet_point(struct follower *f, size_t k, double s)
{
    const struct trace *t = f->trace;
    struct spot spot = spot_at(f, s);
    f->here.tracked = vec_distance(t->p[k], spot.p);
    f->stray.tracked = fmax(f->stray.tracked, f->here.tracked);
    if (f->lone)
        return;
    f->here.other = vec_distance(t->other[k], spot.other);
    struct vec3 swung = vec_sub(t->axis[k], spot.axis);
    f->stray.axis = fmax(f->stray.axis, vec_dot(swung, swung));
    meet_other(f, k, s, spot);
}

/* Places between two feet that have to be looked at, by the sagitta between them. */
static int places_between(const struct arc *arc, double s0, double s1, int fine, double limit)
{
    double turn = (s1 - s0) * arc->angle, sagitta = arc->radius * turn * turn / 8;
    double need = ceil(sqrt(sagitta / (limit / 20)));
    return need > fine ? need < FINE_MAX ? (int)need : FINE_MAX : fine;
}

static struct follower follow(const struct trace *trace, const struct arc_piece *m)
{
    struct follower f = {.trace = trace, .arc = &m->arc, .axis = m->axis};
    f.length = arc_length(&m->arc);
    f.swing = vec_angle(m->axis, m->axis_to);
    if (f.swing > 0) {
        f.aside = vec_unit(vec_reject(m->axis_to, m->axis));
        if (vec_dot(f.aside, f.aside) < 0.5)
            f.swing = 0;
    }
    double part;
    f.tracked = f.other = trace_interval(trace, m->from, &part);
    return f;
}

/* The axis stands still in the piece and in its part of the trace: both points stray alike. */
static bool axis_still(const struct trace *t, const struct follower *f, size_t from, size_t to)
{
    if (f->swing > 0)
        return false;
    for (size_t k = from; k < to; k++)
        if (vec_distance(t->axis[k], f->axis) > 0)
            return false;
    return true;
}

/* A look at a few points first: most pieces that won't do end here. */
static bool glance(struct follower *f, size_t first, size_t end, const struct arc_deviation *within)
{
    size_t stride = (end - first) / 8;
    for (size_t k = first + stride / 2; stride > 1 && k < end; k += stride) {
        meet_point(f, k, arc_foot(f->arc, f->trace->p[k]));
        if (!arc_deviation_within(&f->stray, within))
            return false;
    }
    return true;
}

/*
 * Nothing between two feet can be off by more than `within`: between the chords of the piece and
 * the straight line of the trace it is no more than at their ends, and a sagitta on top.
 */
static bool surely_near(const struct follower *f, struct apart before, double part,
                        const struct arc_deviation *within)
{
    double turn = part * f->arc->angle, swing = part * f->swing;
    double sagitta = f->arc->radius * turn * turn / 8;
    double most = fmax(before.tracked, f->here.tracked) + sagitta;
    if (most > within->tracked)
        return false;
    double swung = fabs(f->trace->lever) * swing * swing / 8;
    return f->lone || fmax(before.other, f->here.other) + sagitta + swung <= within->other;
}

/* From one foot to the next, at `fine` places between, or more. */
static void step_on(struct follower *f, double from, double to, int fine, double limit)
{
    int parts = to > from ? places_between(f->arc, from, to, fine, limit) : 0;
    for (int i = 1; i <= parts; i++)
        meet_trace(f, from + (to - from) * i / (parts + 1));
}

/* How far the start of the piece is from where it should be; unknown between two points. */
static struct apart apart_at_start(const struct follower *f, const struct arc_piece *piece)
{
    size_t k = (size_t)piece->from;
    if ((double)k < piece->from)
        return (struct apart){HUGE_VAL, HUGE_VAL};
    struct spot spot = spot_at(f, 0);
    return (struct apart){vec_distance(f->trace->p[k], spot.p),
                          f->lone ? 0 : vec_distance(f->trace->other[k], spot.other)};
}

/*
 * All points of the piece's part of the trace, and places between their feet: all of them when
 * nothing bounds the stray, else those where it could be out of bounds.
 */
static void walk(struct follower *f, const struct arc_piece *piece, int fine,
                 const struct arc_deviation *within)
{
    double limit = fmin(within->tracked, 0.1), at = 0;
    size_t end = (size_t)piece->to + 1;
    bool bounded = within->tracked < HUGE_VAL;
    meet_trace(f, 0);
    f->here = apart_at_start(f, piece);
    for (size_t k = (size_t)piece->from + 1; k < end && arc_deviation_within(&f->stray, within);
         k++) {
        double foot = fmax(at, arc_foot(f->arc, f->trace->p[k]));
        struct apart before = f->here;
        meet_point(f, k, foot);
        f->tracked = f->other = k - 1;
        if (!bounded || !surely_near(f, before, foot - at, within))
            step_on(f, at, foot, fine, limit);
        at = foot;
    }
    if (arc_deviation_within(&f->stray, within))
        step_on(f, at, 1, fine, limit);
    meet_trace(f, 1);
}

struct arc_deviation arc_piece_deviation(const struct trace *trace, const struct arc_piece *piece,
                                         int fine, const struct arc_deviation *within)
{
    struct follower f = follow(trace, piece);
    size_t first = (size_t)piece->from + 1, end = (size_t)piece->to + 1;
    f.lone = trace->lever == 0 || axis_still(trace, &f, first, end);
    if (trace->n < 2)
        return f.stray;
    struct arc_deviation limit = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    if (within) {
        double chord = 2 * sin(fmin(within->axis, PI) / 2);
        limit = *within;
        limit.axis = chord * chord;
    }
    if (glance(&f, first, end, &limit))
        walk(&f, piece, fine, &limit);
    if (f.lone && trace->lever != 0)
        f.stray.other = f.stray.tracked;
    f.stray.axis = 2 * asin(fmin(1, sqrt(f.stray.axis) / 2));
    return f.stray;
}

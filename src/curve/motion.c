/* motion - see motion.h. */
#include "curve/motion.h"

struct motion motion_line(struct pose from, struct pose to)
{
    return (struct motion){.kind = MOTION_LINE, .from = from, .to = to};
}

struct motion motion_arc(struct pose from, struct pose to, struct vec3 centre, struct vec3 axis)
{
    struct motion m = {.kind = MOTION_ARC, .from = from, .to = to, .centre = centre, .axis = axis};
    struct vec3 r0 = vec_reject(vec_sub(from.p, centre), axis);
    struct vec3 r1 = vec_reject(vec_sub(to.p, centre), axis);
    m.sweep = atan2(vec_dot(axis, vec_cross(r0, r1)), vec_dot(r0, r1));
    if (vec_distance(from.p, to.p) < 1e-9)
        m.sweep = 2 * PI;
    else if (m.sweep < 0)
        m.sweep += 2 * PI;
    return m;
}

struct motion motion_spline(struct pose from, struct pose to, const struct bspline *curve)
{
    return (struct motion){.kind = MOTION_SPLINE, .from = from, .to = to, .curve = curve};
}

static struct vec3 arc_at(const struct motion *m, double s)
{
    struct vec3 d0 = vec_sub(m->from.p, m->centre), d1 = vec_sub(m->to.p, m->centre);
    double h0 = vec_dot(d0, m->axis), h1 = vec_dot(d1, m->axis);
    struct vec3 r0 = vec_reject(d0, m->axis);
    double l0 = vec_length(r0), l1 = vec_length(vec_reject(d1, m->axis));
    struct vec3 r = vec_turn(vec_unit(r0), m->axis, s * m->sweep);
    struct vec3 p = vec_along(m->centre, l0 + s * (l1 - l0), r);
    return vec_along(p, h0 + s * (h1 - h0), m->axis);
}

static double from_knot(const struct bspline *b)
{
    return b->knot[b->degree];
}

static double knot_range(const struct bspline *b)
{
    return b->knot[b->poles] - from_knot(b);
}

static struct pose spline_at(const struct motion *m, const struct great_circle *turn, double s)
{
    const struct bspline *b = m->curve;
    double u = from_knot(b) + s * knot_range(b);
    struct vec3 point, head;

    if (!b->head)
        return (struct pose){bspline_at(b, b->pole, u), great_circle_at(turn, s)};
    bspline_both_at(b, u, &point, &head);
    return (struct pose){point, vec_unit(vec_sub(head, point))};
}

struct pose motion_on(const struct motion *motion, const struct great_circle *turn, double s)
{
    if (motion->kind == MOTION_SPLINE)
        return spline_at(motion, turn, s);
    if (s <= 0)
        return motion->from;
    if (s >= 1)
        return motion->to;
    struct pose at = {.a = great_circle_at(turn, s)};
    at.p =
        motion->kind == MOTION_ARC ? arc_at(motion, s) : vec_mix(motion->from.p, motion->to.p, s);
    return at;
}

struct pose motion_at(const struct motion *motion, double s)
{
    bool asked = motion->kind == MOTION_SPLINE ? !motion->curve->head : s > 0 && s < 1;
    struct great_circle turn = {.angle = 0};

    if (asked)
        turn = great_circle_of(motion->from.a, motion->to.a);
    return motion_on(motion, &turn, s);
}

/* Five-point Gauss quadrature of the speed over one knot span. */
static double span_length(const struct bspline *b, double from, double to)
{
    static const double at[5] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                 0.9061798459386640};
    static const double weight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                     0.4786286704993665, 0.2369268850561891};
    double sum = 0;
    for (int i = 0; i < 5; i++) {
        struct vec3 d[2];
        bspline_derivatives(b, b->pole, from + (at[i] + 1) / 2 * (to - from), 1, d);
        sum += weight[i] * vec_length(d[1]);
    }
    return sum * (to - from) / 2;
}

double motion_length(const struct motion *motion)
{
    if (motion->kind == MOTION_LINE)
        return vec_distance(motion->from.p, motion->to.p);
    if (motion->kind == MOTION_ARC) {
        struct vec3 d0 = vec_sub(motion->from.p, motion->centre);
        struct vec3 d1 = vec_sub(motion->to.p, motion->centre);
        double rise = vec_dot(vec_sub(d1, d0), motion->axis);
        return hypot(vec_length(vec_reject(d0, motion->axis)) * motion->sweep, rise);
    }
    const struct bspline *b = motion->curve;
    double length = 0;
    for (size_t i = (size_t)b->degree; i < b->poles; i++)
        if (b->knot[i + 1] > b->knot[i])
            length += span_length(b, b->knot[i], b->knot[i + 1]);
    return length;
}

double motion_next_knot(const struct motion *motion, double s)
{
    if (motion->kind != MOTION_SPLINE)
        return 1;
    const struct bspline *b = motion->curve;
    for (size_t i = (size_t)b->degree; i < b->poles; i++) {
        double next = (b->knot[i] - from_knot(b)) / knot_range(b);
        if (next > s + 1e-12)
            return next;
    }
    return 1;
}

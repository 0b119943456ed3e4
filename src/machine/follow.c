/* follow - see follow.h. */
#include "machine/follow.h"

/* Pieces that a block is looked at in; a piece turns through no more than `piece_turn`, radians. */
enum { SAMPLES = 8, SAMPLES_SPLINE = 24, SAMPLES_MOST = 128 };
static const double piece_turn = 0.15;
static const double little_of = 0.05;  /* of what is allowed: a bound of it needs no closer look */
static const double most_ahead = 0.25; /* of a block, that its time may run ahead or behind */

bool deviation_within(struct deviation d, struct deviation allowed)
{
    return d.point <= allowed.point && d.axis <= allowed.axis;
}

struct deviation deviation_worst(struct deviation a, struct deviation b)
{
    return (struct deviation){fmax(a.point, b.point), fmax(a.axis, b.axis)};
}

static struct vec3 ball_of(const struct follow *f, struct pose at)
{
    return vec_along(at.p, f->ball, at.a);
}

/* vec_angle, quick for the small ones: the sine's series ends behind its second term. */
static double angle(struct vec3 a, struct vec3 b)
{
    struct vec3 cross = vec_cross(a, b);
    double sine2 = vec_dot(cross, cross), cosine = vec_dot(a, b);
    if (cosine > 0 && sine2 < 1e-6)
        return sqrt(sine2) * (1 + sine2 / 6);
    return atan2(sqrt(sine2), cosine);
}

struct deviation follow_difference(const struct follow *f, struct pose a, struct pose b)
{
    double point = vec_distance(a.p, b.p);
    if (f->ball != 0)
        point = fmax(point, vec_distance(ball_of(f, a), ball_of(f, b)));
    return (struct deviation){point, angle(a.a, b.a)};
}

struct pose follow_pose(const struct follow *f, const struct station *from,
                        const struct station *to, double s)
{
    struct pose at = {.p = vec_mix(from->p, to->p, s)};
    double q[ROTARY_MAX] = {0};
    if (f->mode == FOLLOW_VECTOR) {
        at.a = vec_slerp(vec_unit(from->a), vec_unit(to->a), s);
        return at;
    }
    for (int i = 0; i < f->chain->n; i++)
        q[i] = from->q[i] + s * (to->q[i] - from->q[i]);
    at.a = chain_axis(f->chain, q);
    if (f->mode == FOLLOW_JOINT)
        at.p = chain_tip(f->chain, at.p, q);
    return at;
}

/* The pose at a station itself. */
static struct pose station_pose(const struct follow *f, const struct station *at)
{
    if (f->mode == FOLLOW_ROTARY)
        return (struct pose){at->p, at->a};
    return follow_pose(f, at, at, 0);
}

/*
 * The pose of the block beside `wanted`, first looked for at s: where the tracked point is beside
 * it; where that hardly moves, the ball counts too.  Never far from s: a block that hardly moves
 * but turns would else be taken for its ends alone.
 */
static struct pose beside(const struct follow *f, const struct station *from,
                          const struct station *to, struct pose wanted, double s)
{
    struct pose start = follow_pose(f, from, to, 0), end = follow_pose(f, from, to, 1);
    struct pose at = follow_pose(f, from, to, s);
    struct vec3 way = vec_sub(end.p, start.p);
    struct vec3 ball_way = vec_sub(ball_of(f, end), ball_of(f, start));
    double length2 = vec_dot(way, way), ball2 = vec_dot(ball_way, ball_way);
    double ahead = vec_dot(vec_sub(wanted.p, at.p), way);
    if (length2 < 0.01 * ball2) {
        length2 += ball2;
        ahead += vec_dot(vec_sub(ball_of(f, wanted), ball_of(f, at)), ball_way);
    }
    if (!(length2 > 0))
        return at;
    s += fmax(-most_ahead, fmin(most_ahead, ahead / length2));
    return follow_pose(f, from, to, s < 0 ? 0 : s > 1 ? 1 : s);
}

/* How far the rotary axes turn in a block, all together. */
static double turn_of(const struct follow *f, const double from[], const double to[])
{
    double sum = 0;
    for (int i = 0; i < f->chain->n; i++)
        sum += fabs(to[i] - from[i]);
    return sum;
}

/* Point, ball and axis at one place of a block, less those of the motion at the same time. */
struct error3 {
    struct vec3 point, ball, axis;
};

static struct error3 error_of(const struct follow *f, struct pose at, struct pose wanted)
{
    struct error3 e = {.point = vec_sub(at.p, wanted.p), .axis = vec_sub(at.a, wanted.a)};
    e.ball = vec_along(e.point, f->ball, e.axis);
    return e;
}

/* How far a parabola through three errors leaves the straight line. */
static struct vec3 bend(struct vec3 start, struct vec3 middle, struct vec3 end)
{
    return vec_sub(middle, vec_mix(start, end, 0.5));
}

/* The worse of two errors; of the axis the chord, made the angle. */
static struct deviation worse(const struct follow *f, const struct error3 *a,
                              const struct error3 *b)
{
    double point = fmax(vec_dot(a->point, a->point), vec_dot(b->point, b->point));
    double axis = fmax(vec_dot(a->axis, a->axis), vec_dot(b->axis, b->axis));
    if (f->ball != 0)
        point = fmax(point, fmax(vec_dot(a->ball, a->ball), vec_dot(b->ball, b->ball)));
    double angle = axis < 1e-4 ? sqrt(axis) * (1 + axis / 24) : 2 * asin(fmin(1, sqrt(axis) / 2));
    return (struct deviation){sqrt(point), angle};
}

/* The pose at a stance. */
static struct pose stance_pose(const struct follow *f, const struct stance *s)
{
    if (f->mode == FOLLOW_VECTOR)
        return (struct pose){s->at.p, vec_unit(s->at.a)};
    if (f->mode == FOLLOW_JOINT)
        return (struct pose){chain_tip_of(f->chain, s->at.p, &s->turned), s->at.a};
    return (struct pose){s->at.p, s->at.a};
}

/* Half-way along the block. */
static struct pose middle_pose(const struct follow *f, const struct stance *from,
                               const struct stance *to)
{
    struct pose at = {.p = vec_mix(from->at.p, to->at.p, 0.5)};
    if (f->mode == FOLLOW_VECTOR) {
        at.a = vec_unit(vec_add(vec_unit(from->at.a), vec_unit(to->at.a)));
        return at;
    }
    struct turned t = chain_turned_mid(f->chain, from->turned, to->turned);
    at.a = chain_axis_of(f->chain, &t);
    if (f->mode == FOLLOW_JOINT)
        at.p = chain_tip_of(f->chain, at.p, &t);
    return at;
}

/* The third derivative of the tip's place, where linear and rotary axes move at even speed: of its
 * arm and of its way, each turned. */
static double tip_jerk(const struct follow *f, const struct stance *from, const struct stance *to,
                       double turn)
{
    double arm = fmax(vec_length(from->at.p), vec_length(to->at.p));
    for (int i = 0; i < f->chain->n; i++)
        arm += 2 * vec_length(f->chain->rotary[i].centre);
    return turn * turn * (turn * arm + 3 * vec_distance(from->at.p, to->at.p));
}

/* No shorter than the vector, without a root. */
static inline double at_most(struct vec3 a)
{
    return fabs(a.x) + fabs(a.y) + fabs(a.z);
}

struct deviation follow_bend(const struct follow *f, const struct station *from,
                             const struct station *to)
{
    double turn = turn_of(f, from->q, to->q);
    struct deviation most = {fabs(f->ball) * turn * turn / 4, turn * turn / 4};
    if (f->mode == FOLLOW_JOINT) {
        double way = at_most(vec_sub(to->p, from->p)), arm = at_most(to->p) + way;
        for (int i = 0; i < f->chain->n; i++)
            arm += 2 * at_most(f->chain->rotary[i].centre);
        most.point += turn * (turn * arm + 2 * way) / 8;
    }
    return most;
}

struct deviation follow_line(const struct follow *f, const struct stance *from,
                             const struct stance *to, struct pose start, struct pose goal,
                             struct deviation allowed)
{
    static const double remainder = 0.00802; /* sqrt(3) / 216 */
    double turn = turn_of(f, from->at.q, to->at.q), ball = fabs(f->ball);
    struct error3 e0 = error_of(f, stance_pose(f, from), start);
    struct error3 e1 = error_of(f, stance_pose(f, to), goal);
    struct deviation ends = worse(f, &e0, &e1);
    if (f->mode == FOLLOW_VECTOR)
        return ends;
    /* both axes stay within turn^2 / 8 of the straight line between their ends */
    struct deviation most = {f->mode == FOLLOW_JOINT ? HUGE_VAL : ball * turn * turn / 4,
                             turn * turn / 4};
    struct deviation little = {little_of * allowed.point, little_of * allowed.axis};
    if (!deviation_within(most, little)) {
        double great = 1.05 * vec_distance(start.a, goal.a); /* no less than the angle, up to 1 */
        double rest = remainder * (turn * turn * turn + great * great * great);
        if (!(great <= 1 && rest <= little.axis))
            return (struct deviation){HUGE_VAL, HUGE_VAL};
        struct pose wanted = {vec_mix(start.p, goal.p, 0.5), vec_unit(vec_add(start.a, goal.a))};
        struct error3 e = error_of(f, middle_pose(f, from, to), wanted);
        struct vec3 point = bend(e0.point, e.point, e1.point);
        struct vec3 centre = bend(e0.ball, e.ball, e1.ball);
        most.axis = 1.001 * (vec_length(bend(e0.axis, e.axis, e1.axis)) + rest);
        most.point = fmax(vec_length(point), vec_length(centre) + ball * rest);
        if (f->mode == FOLLOW_JOINT) {
            double jerk = remainder * tip_jerk(f, from, to, turn);
            struct vec3 way = vec_sub(goal.p, start.p);
            double length = vec_length(way);
            double ahead = (fabs(vec_dot(point, way)) / length + jerk + ends.point) / length;
            most.point += jerk;
            most.axis += fmin(1, ahead) * (great + 4 * most.axis); /* at one place, not one time */
        }
    }
    return (struct deviation){ends.point + most.point, ends.axis + most.axis};
}

/* The top of the parabola through three samples in a row, where the middle one is the highest: the
 * deviation between samples, which the samples themselves understate by some percent. */
static double top(double before, double here, double after)
{
    double bend = 2 * here - before - after;
    if (here < before || here < after || !(bend > 0))
        return here;
    return here + (after - before) * (after - before) / (8 * bend);
}

struct deviation follow_peak(const struct deviation *d, int n)
{
    struct deviation worst = deviation_worst(d[0], d[n - 1]);
    for (int i = 1; i + 1 < n; i++) {
        struct deviation between = {top(d[i - 1].point, d[i].point, d[i + 1].point),
                                    top(d[i - 1].axis, d[i].axis, d[i + 1].axis)};
        worst = deviation_worst(worst, between);
    }
    return worst;
}

struct deviation follow_block(const struct follow *f, const struct station *from,
                              const struct station *to, const struct motion *motion, double s0,
                              double s1)
{
    double turn = f->mode == FOLLOW_VECTOR ? 0 : turn_of(f, from->q, to->q);
    int samples = motion->kind == MOTION_SPLINE ? SAMPLES_SPLINE : SAMPLES;
    samples = (int)fmin(SAMPLES_MOST, fmax(samples, ceil(turn / piece_turn)));
    struct deviation d[SAMPLES_MOST + 1];
    d[0] = follow_difference(f, station_pose(f, from), motion_at(motion, s0));
    d[samples] = follow_difference(f, station_pose(f, to), motion_at(motion, s1));
    for (int i = 1; i < samples; i++) {
        double s = (double)i / samples;
        struct pose wanted = motion_at(motion, s0 + s * (s1 - s0));
        d[i] = follow_difference(f, beside(f, from, to, wanted, s), wanted);
    }
    return follow_peak(d, samples + 1);
}

struct deviation follow_curve(const struct follow *f, const struct station *from,
                              const struct station *to, const struct motion *printed,
                              const struct motion *motion, double s0, double s1, double *point)
{
    struct deviation d[SAMPLES + 1];
    *point = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double s = (double)i / SAMPLES;
        struct pose at = follow_pose(f, from, to, s),
                    wanted = motion_at(motion, s0 + s * (s1 - s0));
        at.p = motion_at(printed, s).p;
        *point = fmax(*point, vec_distance(at.p, wanted.p));
        d[i] = follow_difference(f, at, wanted);
    }
    return follow_peak(d, SAMPLES + 1);
}

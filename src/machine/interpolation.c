/* interpolation - see interpolation.h. */
#include "machine/interpolation.h"

/* Pieces that a block is looked at in; a piece turns through no more than `piece_turn`, radians. */
enum { SAMPLES = 8, SAMPLES_SPLINE = 24, SAMPLES_MOST = 128 };
static const double piece_turn = 0.15;
static const double little_of = 0.05;  /* of what is allowed: a bound of it needs no closer look */
static const double most_ahead = 0.25; /* of a block, that its time may run ahead or behind */

static struct vec3 ball_of(const struct interpolation *f, struct pose at)
{
    return vec_along(at.p, f->ball, at.a);
}

/* vec_angle, quick for the small ones: two terms of the series. */
static double quick_angle(struct vec3 a, struct vec3 b)
{
    struct vec3 cross = vec_cross(a, b);
    double sine2 = vec_dot(cross, cross), cosine = vec_dot(a, b);
    if (cosine > 0 && sine2 < 1e-6)
        return sqrt(sine2) * (1 + sine2 / 6);
    return atan2(sqrt(sine2), cosine);
}

struct pose_deviation interpolation_difference(const struct interpolation *f, struct pose a,
                                               struct pose b)
{
    double point = vec_distance(a.p, b.p);
    if (f->ball != 0)
        point = fmax(point, vec_distance(ball_of(f, a), ball_of(f, b)));
    return (struct pose_deviation){point, quick_angle(a.a, b.a)};
}

struct pose interpolation_pose(const struct interpolation *f, const struct block_pose *from,
                               const struct block_pose *to, double s)
{
    struct pose at = {.p = vec_mix(from->p, to->p, s)};
    double q[ROTARY_MAX] = {0};
    if (f->mode == INTERPOLATE_VECTOR) {
        at.a = vec_slerp(vec_unit(from->a), vec_unit(to->a), s);
        return at;
    }
    for (int i = 0; i < f->chain->n; i++)
        q[i] = from->q[i] + s * (to->q[i] - from->q[i]);
    at.a = chain_axis(f->chain, q);
    if (f->mode == INTERPOLATE_JOINT)
        at.p = chain_tip(f->chain, at.p, q);
    return at;
}

/* The pose of a block's end. */
static struct pose end_pose(const struct interpolation *f, const struct block_pose *at)
{
    if (f->mode == INTERPOLATE_ROTARY)
        return (struct pose){at->p, at->a};
    return interpolation_pose(f, at, at, 0);
}

/*
 * The pose of the block beside `wanted`, first searched at s: where the tracked point is beside
 * it; where that hardly moves, the ball counts too.  Never far from s: a block that hardly moves
 * but turns would else be taken for its ends alone.
 */
static struct pose pose_beside(const struct interpolation *f, const struct block_pose *from,
                               const struct block_pose *to, struct pose wanted, double s)
{
    struct pose start = interpolation_pose(f, from, to, 0),
                end = interpolation_pose(f, from, to, 1);
    struct pose at = interpolation_pose(f, from, to, s);
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
    return interpolation_pose(f, from, to, s < 0 ? 0 : s > 1 ? 1 : s);
}

/* How far the rotary axes turn in a block, all together. */
static double turn_of(const struct interpolation *f, const double from[], const double to[])
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

static struct error3 error_of(const struct interpolation *f, struct pose at, struct pose wanted)
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
static struct pose_deviation worse_error(const struct interpolation *f, const struct error3 *a,
                                         const struct error3 *b)
{
    double point = fmax(vec_dot(a->point, a->point), vec_dot(b->point, b->point));
    double axis = fmax(vec_dot(a->axis, a->axis), vec_dot(b->axis, b->axis));
    if (f->ball != 0)
        point = fmax(point, fmax(vec_dot(a->ball, a->ball), vec_dot(b->ball, b->ball)));
    double angle = axis < 1e-4 ? sqrt(axis) * (1 + axis / 24) : 2 * asin(fmin(1, sqrt(axis) / 2));
    return (struct pose_deviation){sqrt(point), angle};
}

/* The same where the cosines and sines of its angles are known. */
static struct pose known_pose(const struct interpolation *f, const struct machine_pose *s)
{
    if (f->mode == INTERPOLATE_VECTOR)
        return (struct pose){s->at.p, vec_unit(s->at.a)};
    if (f->mode == INTERPOLATE_JOINT)
        return (struct pose){chain_tip_of(f->chain, s->at.p, &s->turned), s->at.a};
    return (struct pose){s->at.p, s->at.a};
}

/* Half-way along the block. */
static struct pose middle_pose(const struct interpolation *f, const struct machine_pose *from,
                               const struct machine_pose *to)
{
    struct pose at = {.p = vec_mix(from->at.p, to->at.p, 0.5)};
    if (f->mode == INTERPOLATE_VECTOR) {
        at.a = vec_unit(vec_add(vec_unit(from->at.a), vec_unit(to->at.a)));
        return at;
    }
    struct turned t = chain_turned_mid(f->chain, from->turned, to->turned);
    at.a = chain_axis_of(f->chain, &t);
    if (f->mode == INTERPOLATE_JOINT)
        at.p = chain_tip_of(f->chain, at.p, &t);
    return at;
}

/* The third derivative of the tip's place, where linear and rotary axes move at even speed: of its
 * arm and of its way, each turned. */
static double tip_jerk(const struct interpolation *f, const struct machine_pose *from,
                       const struct machine_pose *to, double turn)
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

struct pose_deviation interpolation_bend(const struct interpolation *f,
                                         const struct block_pose *from, const struct block_pose *to)
{
    double turn = turn_of(f, from->q, to->q);
    struct pose_deviation most = {fabs(f->ball) * turn * turn / 4, turn * turn / 4};
    if (f->mode == INTERPOLATE_JOINT) {
        double way = at_most(vec_sub(to->p, from->p)), arm = at_most(to->p) + way;
        for (int i = 0; i < f->chain->n; i++)
            arm += 2 * at_most(f->chain->rotary[i].centre);
        most.point += turn * (turn * arm + 2 * way) / 8;
    }
    return most;
}

struct pose_deviation interpolation_line(const struct interpolation *f,
                                         const struct machine_pose *from,
                                         const struct machine_pose *to, struct pose start,
                                         struct pose goal, struct pose_deviation allowed)
{
    static const double remainder = 0.00802; /* sqrt(3) / 216 */
    double turn = turn_of(f, from->at.q, to->at.q), ball = fabs(f->ball);
    struct error3 e0 = error_of(f, known_pose(f, from), start);
    struct error3 e1 = error_of(f, known_pose(f, to), goal);
    struct pose_deviation ends = worse_error(f, &e0, &e1);
    if (f->mode == INTERPOLATE_VECTOR)
        return ends;
    /* both axes stay within turn^2 / 8 of the straight line between their ends */
    struct pose_deviation most = {f->mode == INTERPOLATE_JOINT ? HUGE_VAL : ball * turn * turn / 4,
                                  turn * turn / 4};
    struct pose_deviation little = {little_of * allowed.point, little_of * allowed.axis};
    if (!pose_deviation_within(most, little)) {
        double great = 1.05 * vec_distance(start.a, goal.a); /* no less than the angle, up to 1 */
        double rest = remainder * (turn * turn * turn + great * great * great);
        if (!(great <= 1 && rest <= little.axis))
            return (struct pose_deviation){HUGE_VAL, HUGE_VAL};
        struct pose wanted = {vec_mix(start.p, goal.p, 0.5), vec_unit(vec_add(start.a, goal.a))};
        struct error3 e = error_of(f, middle_pose(f, from, to), wanted);
        struct vec3 point = bend(e0.point, e.point, e1.point);
        struct vec3 centre = bend(e0.ball, e.ball, e1.ball);
        most.axis = 1.001 * (vec_length(bend(e0.axis, e.axis, e1.axis)) + rest);
        most.point = fmax(vec_length(point), vec_length(centre) + ball * rest);
        if (f->mode == INTERPOLATE_JOINT) {
            double jerk = remainder * tip_jerk(f, from, to, turn);
            struct vec3 way = vec_sub(goal.p, start.p);
            double length = vec_length(way);
            double ahead = (fabs(vec_dot(point, way)) / length + jerk + ends.point) / length;
            /* at one place, not one time: the axis there is another, and so is where the ball is */
            double other = fmin(1, ahead) * (great + 4 * most.axis);
            most.point = fmax(vec_length(point), vec_length(centre) + ball * (rest + other)) + jerk;
            most.axis += other;
        }
    }
    return (struct pose_deviation){ends.point + most.point, ends.axis + most.axis};
}

/* The top of the parabola through three samples in a row, where the middle one is the highest: the
 * deviation between samples, which the samples themselves understate by some percent. */
static double parabola_top(double before, double here, double after)
{
    double bend = 2 * here - before - after;
    if (here < before || here < after || !(bend > 0))
        return here;
    return here + (after - before) * (after - before) / (8 * bend);
}

struct pose_deviation interpolation_peak(const struct pose_deviation *d, int n)
{
    struct pose_deviation worst = pose_deviation_worst(d[0], d[n - 1]);
    for (int i = 1; i + 1 < n; i++) {
        struct pose_deviation between = {parabola_top(d[i - 1].point, d[i].point, d[i + 1].point),
                                         parabola_top(d[i - 1].axis, d[i].axis, d[i + 1].axis)};
        worst = pose_deviation_worst(worst, between);
    }
    return worst;
}

struct pose_deviation interpolation_block(const struct interpolation *f,
                                          const struct block_pose *from,
                                          const struct block_pose *to, const struct motion *motion,
                                          double s0, double s1)
{
    double turn = f->mode == INTERPOLATE_VECTOR ? 0 : turn_of(f, from->q, to->q);
    int samples = motion->kind == MOTION_SPLINE ? SAMPLES_SPLINE : SAMPLES;
    samples = (int)fmin(SAMPLES_MOST, fmax(samples, ceil(turn / piece_turn)));
    struct pose_deviation d[SAMPLES_MOST + 1];
    d[0] = interpolation_difference(f, end_pose(f, from), motion_at(motion, s0));
    d[samples] = interpolation_difference(f, end_pose(f, to), motion_at(motion, s1));
    for (int i = 1; i < samples; i++) {
        double s = (double)i / samples;
        struct pose wanted = motion_at(motion, s0 + s * (s1 - s0));
        d[i] = interpolation_difference(f, pose_beside(f, from, to, wanted, s), wanted);
    }
    return interpolation_peak(d, samples + 1);
}

struct pose_deviation interpolation_curve(const struct interpolation *f,
                                          const struct block_pose *from,
                                          const struct block_pose *to, const struct motion *printed,
                                          const struct motion *motion, double s0, double s1,
                                          double *point)
{
    struct pose_deviation d[SAMPLES + 1];
    *point = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double s = (double)i / SAMPLES;
        struct pose at = interpolation_pose(f, from, to, s),
                    wanted = motion_at(motion, s0 + s * (s1 - s0));
        at.p = motion_at(printed, s).p;
        *point = fmax(*point, vec_distance(at.p, wanted.p));
        d[i] = interpolation_difference(f, at, wanted);
    }
    return interpolation_peak(d, SAMPLES + 1);
}

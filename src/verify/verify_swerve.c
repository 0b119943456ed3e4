/* verify_swerve - see verify_swerve.h. */
#include "verify_swerve.h"

#include <string.h>

#include "math/elementary.h"
#include "verify_finding.h"

#define OFF 0.25 /* mm that the ball is off at least, or as many tolerances: */
#define TOLERANCES 3
#define EVEN 15.0  /* degrees that the course is other before, across and after it, at most */
#define BEND 15.0  /* degrees that the course bends where it leaves the even one and where it is */
#define SHARP 45.0 /* back on it, at least, and at the place itself */
#define SWING 3.0  /* degrees that the axis is off at least, in a block between such as ... */
#define STEADY 6   /* ... turn so many times less, and so do all four from end to end, or ... */
#define HALF 2     /* ... so many times less, ... */
#define SMOOTH 15  /* ... while it is so many times less off at the blocks' other ends */
#define OVER 120.0 /* degrees between how it turns there and back, at least */
#define GOES_ON 60.0 /* degrees that the ball's course is other after it, at most */
#define STANDS 0.001 /* mm: a block that goes no further has no course */

/* A block of a cut: the ball's centre and the axis at its ends, its course there, and how the axis
 * would turn all along as it does there. */
struct step {
    size_t piece;
    struct vec3 p[2], a[2], t[2], turn[2];
    double length;
    bool on; /* the part */
};

/* The last steps of a cut: of millions no more than are looked at together. */
enum { LOOKED = 4, AROUND = LOOKED + 2 };

struct steps {
    size_t n; /* of the cut so far; the last AROUND of them are at the end of `last` */
    struct step last[AROUND];
};

struct swerves {
    size_t count, piece;
    double most;
    struct vec3 at;
};

static struct nc_motion_pose ball_at(const struct verdict *v, size_t piece, double s)
{
    return nc_motion_ball(v->program.motion, piece, s, v->options.radius);
}

static struct step step_of(const struct verdict *v, size_t piece, bool on)
{
    const double parts = 64;
    struct nc_motion_pose a = ball_at(v, piece, 0), b = ball_at(v, piece, 1);
    struct nc_motion_pose from = ball_at(v, piece, 1 / parts);
    struct nc_motion_pose to = ball_at(v, piece, 1 - 1 / parts);
    return (struct step){
        .piece = piece,
        .p = {a.p, b.p},
        .a = {a.a, b.a},
        .t = {vec_unit(vec_sub(from.p, a.p)), vec_unit(vec_sub(b.p, to.p))},
        .turn = {vec_scale(parts, vec_sub(from.a, a.a)), vec_scale(parts, vec_sub(b.a, to.a))},
        .length = vec_distance(a.p, b.p),
        .on = on};
}

static void add_swerve(struct swerves *s, double much, const struct step *at)
{
    s->piece = much > s->most ? at->piece : s->piece;
    s->at = much > s->most ? at->p[1] : s->at;
    s->most = fmax(s->most, much);
    s->count++;
}

/* The ball at the end of the second of four steps. */
static void look_at_ball(const struct verdict *v, const struct step s[4], struct swerves *found)
{
    struct vec3 before = s[0].t[1], after = s[3].t[0];
    struct vec3 across = vec_unit(vec_sub(s[2].p[1], s[1].p[0]));
    double off = vec_segment_distance(s[1].p[0], s[2].p[1], s[1].p[1]);
    double least = fmax(OFF, TOLERANCES * v->options.tolerance);
    double other =
        fmax(vec_angle(before, after), fmax(vec_angle(before, across), vec_angle(across, after)));
    double bend = fmin(vec_angle(before, s[1].t[0]), vec_angle(s[2].t[1], after));
    if (off > least && other < RADIANS(EVEN) && bend > RADIANS(BEND) &&
        vec_angle(s[1].t[1], s[2].t[0]) > RADIANS(SHARP))
        add_swerve(found, off, &s[1]);
}

/* How far the axis is off an even turn between a step and the next, radians. */
static double axis_off(const struct step s[2])
{
    struct vec3 even = vec_mix(s[0].a[0], s[1].a[1], s[0].length / (s[0].length + s[1].length));
    return vec_angle(vec_unit(even), s[0].a[1]);
}

/* A step turns the axis as the one before or after it does, by the millimetre and to half of it: so
 * a row may end, where the axis turns back on the way that leaves it. */
static bool turns_as(const struct step *s, const struct step *other)
{
    struct vec3 by = vec_scale(1 / s->length, vec_sub(s->a[1], s->a[0]));
    struct vec3 by_other = vec_scale(1 / other->length, vec_sub(other->a[1], other->a[0]));
    return vec_distance(by, by_other) < vec_length(by) / HALF;
}

/* The axis there; `amid`: a step is before the four, and one after them. */
static void look_at_axis(const struct step *s, bool amid, struct swerves *found)
{
    double off = axis_off(s + 1), around = vec_angle(s[1].a[0], s[2].a[1]);
    around = fmax(around, vec_angle(s[0].a[0], s[0].a[1]));
    around = fmax(around, vec_angle(s[3].a[0], s[3].a[1]));
    bool steady = off > STEADY * around;
    bool smooth = amid && off > HALF * around &&
                  off > SMOOTH * fmax(axis_off(s - 1), axis_off(s + 3)) && !turns_as(s + 1, s) &&
                  !turns_as(s + 2, s + 3);
    struct vec3 out = s[1].turn[1],
                back = s[2].turn[0]; /* a curve turns over, if it does, evenly */
    bool turns_over = vec_length(out) > off / HALF && vec_length(back) > off / HALF &&
                      vec_angle(out, back) > RADIANS(OVER);
    bool goes_on = vec_angle(s[0].t[1], s[3].t[0]) < RADIANS(GOES_ON); /* no row ends here */
    if (off > RADIANS(SWING) && goes_on && turns_over && (steady || smooth))
        add_swerve(found, off, &s[1]);
}

/* Four blocks of a cut one after the other. */
static void look(const struct verdict *v, const struct step s[LOOKED], bool amid,
                 struct swerves *ball, struct swerves *axis)
{
    if (!s[0].on && !s[1].on && !s[2].on && !s[3].on)
        return;
    look_at_ball(v, s, ball);
    look_at_axis(s, amid, axis);
}

static void shift(struct steps *steps)
{
    memmove(steps->last, steps->last + 1, (AROUND - 1) * sizeof *steps->last);
}

/* One block more: the four before it are looked at, which have one behind them now. */
static void go_on(const struct verdict *v, struct steps *steps, const struct step *next,
                  struct swerves *ball, struct swerves *axis)
{
    shift(steps);
    steps->last[AROUND - 1] = *next;
    steps->n++;
    if (steps->n > LOOKED)
        look(v, steps->last + 1, steps->n > LOOKED + 1, ball, axis);
}

/* The cut ends: behind its last four blocks there is none. */
static void end(const struct verdict *v, struct steps *steps, struct swerves *ball,
                struct swerves *axis)
{
    shift(steps);
    if (steps->n >= LOOKED)
        look(v, steps->last + 1, false, ball, axis);
    steps->n = 0;
}

void verify_swerve(struct verdict *v)
{
    const struct nc_motion *m = v->program.motion;
    struct steps steps = {.n = 0};
    struct swerves ball = {0}, axis = {0};
    size_t k = 0;
    for (size_t i = 0; i < m->piece.n; i++) {
        bool on = false;
        for (; k < v->cut.n && v->cut.item[k].piece <= i; k++)
            on = on || v->cut.item[k].on;
        if (m->piece.item[i].rapid) {
            end(v, &steps, &ball, &axis);
            continue;
        }
        struct step step = step_of(v, i, on);
        if (step.length > STANDS) /* what goes nowhere is left out */
            go_on(v, &steps, &step, &ball, &axis);
    }
    end(v, &steps, &ball, &axis);
    if (ball.count > 0)
        finding_add(v, true, ball.piece,
                    "the ball swerves by %.3f mm at %.3f %.3f %.3f and comes back to its course "
                    "(blocks: %zu)",
                    ball.most, ball.at.x, ball.at.y, ball.at.z, ball.count);
    if (axis.count > 0)
        finding_add(v, true, axis.piece,
                    "the tool axis turns by %.3f degrees at %.3f %.3f %.3f and back, and is steady "
                    "before and after (blocks: %zu)",
                    DEGREES(axis.most), axis.at.x, axis.at.y, axis.at.z, axis.count);
}

/* post_even - see post_even.h. */
#include "post_even.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "curve/motion.h"
#include "math/elementary.h"

enum { STEPS = 4 };

/* A reader takes less for a fault than this finds.  The ball: mm off a straight way across; degrees
 * that its courses before and after are other; that it bends there and back, and at the place. */
static const double OFF = 0.15, EVEN = RADIANS(25), BEND = RADIANS(10);
static const double COS_SHARP = 0.81915204428899178; /* 35 degrees */

/* The axis: degrees off an even turn; so many times more than it turns beside it. */
static const double SWING = RADIANS(2), COS_SWING = 0.99939082701909576, STEADY = 1.5;

static const double STANDS = 0.001; /* mm: a step that goes no further has no course */

/* A line, an arc or a span of a B-spline: the ball's centre and the tool axis at its ends, the
 * course of the first. */
struct step {
    size_t item;
    double s[2]; /* part of the item's motion */
    struct vec3 p[2], a[2], course[2];
    double length;
    bool halved;
};

struct halves {
    struct path *path;
    double ball;             /* from the tracked point to the ball's centre, mm */
    struct step step[STEPS]; /* the last of a cut, ... */
    size_t n;                /* ... so many */
    bool *item;              /* of each item: it goes in halves */
    size_t halved;           /* items and spans */
};

/* The ball at the end of the second of four steps. */
static bool ball_swerves(const struct step s[STEPS])
{
    if (vec_dot(s[1].course[1], s[2].course[0]) > COS_SHARP)
        return false;
    struct vec3 before = s[0].course[1], after = s[3].course[0];
    struct vec3 across = vec_unit(vec_sub(s[2].p[1], s[1].p[0]));
    double other =
        fmax(vec_angle(before, after), fmax(vec_angle(before, across), vec_angle(across, after)));

    return other < EVEN && vec_angle(before, s[1].course[0]) > BEND &&
           vec_angle(s[2].course[1], after) > BEND &&
           vec_segment_distance(s[1].p[0], s[2].p[1], s[1].p[1]) > OFF;
}

/* The axis there. */
static bool axis_swings(const struct step s[STEPS])
{
    if (vec_dot(s[1].a[0], s[1].a[1]) > COS_SWING && vec_dot(s[2].a[0], s[2].a[1]) > COS_SWING)
        return false;
    struct vec3 even = vec_mix(s[1].a[0], s[2].a[1], s[1].length / (s[1].length + s[2].length));
    double off = vec_angle(vec_unit(even), s[1].a[1]), around = vec_angle(s[1].a[0], s[2].a[1]);

    around = fmax(around, vec_angle(s[0].a[0], s[0].a[1]));
    around = fmax(around, vec_angle(s[3].a[0], s[3].a[1]));
    return off > SWING && off > STEADY * around;
}

/* The longer one of the two steps in the middle, once. */
static void halve(struct halves *h)
{
    struct step *step = &h->step[h->step[1].length >= h->step[2].length ? 1 : 2];
    const struct path_item *item = &h->path->item.item[step->item];

    h->halved += !step->halved;
    if (item->kind != PATH_SPLINE) {
        h->item[step->item] = true;
    } else if (!step->halved) {
        struct bspline *curve = &h->path->spline.item[item->index].curve;
        double from = curve->knot[curve->degree], to = curve->knot[curve->poles];
        bspline_insert(curve, from + (step->s[0] + step->s[1]) / 2 * (to - from));
    }
    step->halved = true;
}

static void add_step(struct halves *h, const struct step *step)
{
    if (step->length <= STANDS)
        return;
    if (h->n == STEPS)
        memmove(h->step, h->step + 1, (STEPS - 1) * sizeof *h->step);
    else
        h->n++;
    h->step[h->n - 1] = *step;
    if (h->n == STEPS && (ball_swerves(h->step) || axis_swings(h->step)))
        halve(h);
}

static struct vec3 ball_of(const struct halves *h, struct pose pose)
{
    return vec_along(pose.p, h->ball, pose.a);
}

/* A step without its courses. */
static struct step step_between(const struct halves *h, size_t item, double s0, double s1,
                                struct pose from, struct pose to)
{
    struct step step = {
        .item = item, .s = {s0, s1}, .p = {ball_of(h, from), ball_of(h, to)}, .a = {from.a, to.a}};

    step.length = vec_distance(step.p[0], step.p[1]);
    return step;
}

/* A line: the course of its ball is straight, or nearly so. */
static void add_line(struct halves *h, size_t item, struct pose from, struct pose to)
{
    struct step step = step_between(h, item, 0, 1, from, to);

    step.course[0] = step.course[1] = vec_unit(vec_sub(step.p[1], step.p[0]));
    add_step(h, &step);
}

static void add_curve(struct halves *h, const struct motion *motion, size_t item, double s0,
                      double s1)
{
    const double near = (s1 - s0) / 64;
    struct step step = step_between(h, item, s0, s1, motion_at(motion, s0), motion_at(motion, s1));

    step.course[0] = vec_unit(vec_sub(ball_of(h, motion_at(motion, s0 + near)), step.p[0]));
    step.course[1] = vec_unit(vec_sub(step.p[1], ball_of(h, motion_at(motion, s1 - near))));
    add_step(h, &step);
}

/* Each span of a B-spline, on the knots that it came with. */
static void add_spans(struct halves *h, size_t item, struct pose at)
{
    const struct path_item *it = &h->path->item.item[item];
    struct bspline b = bspline_copy(&h->path->spline.item[it->index].curve);
    struct motion motion = motion_spline(at, it->to, &b);
    double from = b.knot[b.degree], range = b.knot[b.poles] - from;

    for (size_t k = (size_t)b.degree; k < b.poles; k++)
        if (b.knot[k] < b.knot[k + 1])
            add_curve(h, &motion, item, (b.knot[k] - from) / range, (b.knot[k + 1] - from) / range);
    bspline_free(&b);
}

static void find(struct halves *h)
{
    struct path *path = h->path;
    struct pose at = {.a = {0, 0, 1}};
    bool begun = false;

    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (!path_moves(item))
            continue;
        if (!begun || path_is_rapid(item) || item->kind == PATH_HOLE) {
            h->n = 0;
        } else if (item->kind == PATH_POINT) {
            add_line(h, i, at, item->to);
        } else if (item->kind == PATH_ARC) {
            struct motion motion = path_item_motion(path, item, at);
            add_curve(h, &motion, i, 0, 1);
        } else {
            add_spans(h, i, at);
        }
        at = item->to;
        begun = true;
    }
}

static unsigned copy_arc(struct path *path, size_t index)
{
    struct path_arc arc = path->arc.item[index];

    *array_push(&path->arc) = arc;
    return (unsigned)(path->arc.n - 1);
}

/* The items once more, those that are marked in halves. */
static void divide(struct halves *h)
{
    struct path *path = h->path;
    struct path_item *old = path->item.item;
    size_t n = path->item.n, spent = 0;
    struct pose at = {.a = {0, 0, 1}};

    path->item.item = NULL;
    path->item.n = path->item.cap = 0;
    for (size_t i = 0; i < n; i++) {
        for (; spent < path->spent.n && path->spent.item[spent].before <= i; spent++)
            path->spent.item[spent].before += path->item.n - i;
        if (h->item[i]) {
            struct motion motion = path_item_motion(path, &old[i], at);
            struct path_item *half = array_push(&path->item);
            *half = old[i];
            half->to = motion_at(&motion, 0.5);
            half->touches = false;
            if (old[i].kind == PATH_ARC) /* one of its own, for who turns or scales them all */
                half->index = copy_arc(path, old[i].index);
        }
        *array_push(&path->item) = old[i];
        at = path_moves(&old[i]) ? old[i].to : at;
    }
    for (; spent < path->spent.n; spent++)
        path->spent.item[spent].before += path->item.n - n;
    free(old);
}

size_t post_even(struct path *path)
{
    if (path->head.ledger.n == 0)
        return 0;
    double radius = path_ball(path);
    struct halves h = {.path = path,
                       .ball = radius > 0 && path->head.track != TRACK_CENTRE ? radius : 0,
                       .item = mem_alloc(path->item.n + 1, sizeof *h.item)};

    find(&h);
    if (h.halved > 0)
        divide(&h);
    free(h.item);
    return h.halved;
}

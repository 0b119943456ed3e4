/* post_even - see post_even.h. */
#include "post_even.h"

#include <stdlib.h>

#include "base/array.h"
#include "curve/motion.h"
#include "math/elementary.h"

/* A reader takes less for a fault than this finds.  The ball: mm off a straight way across; degrees
 * that its courses before and after are other; that it bends there and back, and at the place. */
static const double OFF = 0.15, EVEN = RADIANS(25), BEND = RADIANS(10), SHARP = RADIANS(35);

/* The axis: degrees off an even turn; so many times more than it turns beside it. */
static const double SWING = RADIANS(2), STEADY = 1.5;

static const double STANDS = 0.001; /* mm: a step that goes no further has no course */

/* A line, an arc or a span of a B-spline: the ball's centre and the tool axis at its ends, the
 * course of the first. */
struct step {
    size_t item;
    double s[2]; /* part of the item's motion */
    struct vec3 p[2], a[2], course[2];
    double length;
};

struct steps {
    size_t n, cap;
    struct step *item;
};

struct halves {
    struct path *path;
    double ball; /* from the tracked point to the ball's centre, mm */
    struct steps steps;
    bool *item;    /* of each item: it goes in halves */
    size_t halved; /* items and spans */
};

static void add_step(struct halves *h, const struct motion *motion, size_t item, double s0,
                     double s1)
{
    const double near = 1.0 / 64;
    struct step step = {.item = item, .s = {s0, s1}};
    const double at[4] = {s0, s1, s0 + near * (s1 - s0), s1 - near * (s1 - s0)};
    struct vec3 p[4], a[4];

    for (int k = 0; k < 4; k++) {
        struct pose pose = motion_at(motion, at[k]);
        p[k] = vec_along(pose.p, h->ball, pose.a);
        a[k] = pose.a;
    }
    for (int k = 0; k < 2; k++) {
        step.p[k] = p[k];
        step.a[k] = a[k];
    }
    step.course[0] = vec_unit(vec_sub(p[2], p[0]));
    step.course[1] = vec_unit(vec_sub(p[1], p[3]));
    step.length = vec_distance(p[0], p[1]);
    if (step.length > STANDS)
        *array_push(&h->steps) = step;
}

static void add_steps(struct halves *h, const struct motion *motion, size_t item)
{
    const struct bspline *b = motion->curve;

    if (motion->kind != MOTION_SPLINE) {
        add_step(h, motion, item, 0, 1);
        return;
    }
    double from = b->knot[b->degree], range = b->knot[b->poles] - from;
    for (size_t k = (size_t)b->degree; k < b->poles; k++)
        if (b->knot[k] < b->knot[k + 1])
            add_step(h, motion, item, (b->knot[k] - from) / range, (b->knot[k + 1] - from) / range);
}

/* The ball at the end of the second of four steps. */
static bool ball_swerves(const struct step s[4])
{
    struct vec3 before = s[0].course[1], after = s[3].course[0];
    struct vec3 across = vec_unit(vec_sub(s[2].p[1], s[1].p[0]));
    double other =
        fmax(vec_angle(before, after), fmax(vec_angle(before, across), vec_angle(across, after)));

    return vec_angle(s[1].course[1], s[2].course[0]) > SHARP && other < EVEN &&
           vec_angle(before, s[1].course[0]) > BEND && vec_angle(s[2].course[1], after) > BEND &&
           vec_segment_distance(s[1].p[0], s[2].p[1], s[1].p[1]) > OFF;
}

/* The axis there. */
static bool axis_swings(const struct step s[4])
{
    struct vec3 even = vec_mix(s[1].a[0], s[2].a[1], s[1].length / (s[1].length + s[2].length));
    double off = vec_angle(vec_unit(even), s[1].a[1]), around = vec_angle(s[1].a[0], s[2].a[1]);

    around = fmax(around, vec_angle(s[0].a[0], s[0].a[1]));
    around = fmax(around, vec_angle(s[3].a[0], s[3].a[1]));
    return off > SWING && off > STEADY * around;
}

/* The longer one of the two steps in the middle. */
static void halve(struct halves *h, const struct step s[4])
{
    const struct step *step = s[1].length >= s[2].length ? &s[1] : &s[2];
    const struct path_item *item = &h->path->item.item[step->item];

    h->halved++;
    if (item->kind != PATH_SPLINE) {
        h->item[step->item] = true;
        return;
    }
    struct bspline *curve = &h->path->spline.item[item->index].curve;
    double from = curve->knot[curve->degree], to = curve->knot[curve->poles];
    bspline_insert(curve, from + (step->s[0] + step->s[1]) / 2 * (to - from));
}

static void look(struct halves *h)
{
    for (size_t i = 0; i + 4 <= h->steps.n; i++) {
        const struct step *s = &h->steps.item[i];
        if (ball_swerves(s) || axis_swings(s))
            halve(h, s);
    }
    h->steps.n = 0;
}

static void find(struct halves *h)
{
    struct path *path = h->path;
    struct pose at = {.a = {0, 0, 1}};
    bool begun = false;

    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        bool cuts = (item->kind == PATH_POINT && !item->rapid) || item->kind == PATH_ARC ||
                    item->kind == PATH_SPLINE;
        if (!path_moves(item))
            continue;
        if (cuts && begun) {
            struct motion motion = path_item_motion(path, item, at);
            add_steps(h, &motion, i);
        } else {
            look(h);
        }
        at = item->to;
        begun = true;
    }
    look(h);
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
    array_free(&h.steps);
    free(h.item);
    return h.halved;
}

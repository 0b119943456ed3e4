/* path_compare - see path_compare.h. */
#include "simulate/path_compare.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/box_tree.h"
#include "simulate/axis_limits.h"

enum { LINE_STEPS = 4, CURVE_STEPS = 16, DEEPEST = 10 };

#define FLAT 0.0002  /* mm: how straight a piece is followed */
#define STEADY 0.005 /* radians that the axis turns in a step, at most */
#define EVEN 3e-5    /* radians that it may be off an even turn there */
#define STILL 0.005  /* mm: a tip that moves no further stands, and the axes turn about it */
#define SHORT 0.05   /* mm: shorter pieces may be slow, and their inverse time says little, ... */
#define WAIT (1 / 60.0) /* ... if they take no more than that, minutes */
#define ROUNDED 6 /* tolerances of the tip: so long a piece may be half longer by its digits */

/* A straight bit of a motion at feed, with the tool axis at its ends. */
struct stretch {
    struct nc_motion_pose a, b;
    size_t piece;
    double feed; /* of the tip, mm/min; 0: not known */
    bool brief;  /* its piece is too short for its feed to be one that was asked for */
};

struct stretches {
    size_t n, cap;
    struct stretch *item;
};

static struct nc_motion_pose tip_at(const struct nc_motion *m, size_t piece, double s,
                                    double radius)
{
    struct nc_motion_pose pose = nc_motion_at(m, &m->piece.item[piece], s);
    if (m->track == NC_MOTION_CENTRE)
        pose.p = vec_along(pose.p, -radius, pose.a);
    return pose;
}

struct walk {
    const struct nc_motion *motion;
    size_t piece;
    bool combined;
    double radius, feed;
    double tolerance; /* of the tip, mm, for what digits say of short pieces */
    struct stretches *to;
};

static void add_stretches(const struct walk *w, double s0, struct nc_motion_pose a, double s1,
                          struct nc_motion_pose b, int depth)
{
    struct nc_motion_pose m = tip_at(w->motion, w->piece, (s0 + s1) / 2, w->radius);
    struct vec3 even = vec_unit(vec_mix(a.a, b.a, vec_segment_foot(a.p, b.p, m.p)));
    bool fine = vec_segment_distance(a.p, b.p, m.p) <= FLAT && vec_angle(a.a, b.a) <= STEADY &&
                vec_angle(a.a, m.a) <= STEADY &&
                (vec_angle(even, m.a) <= EVEN || vec_distance(a.p, b.p) <= STILL);
    if (depth >= DEEPEST || fine) {
        *array_push(w->to) = (struct stretch){a, b, w->piece, w->feed, false};
        return;
    }
    add_stretches(w, s0, a, (s0 + s1) / 2, m, depth + 1);
    add_stretches(w, (s0 + s1) / 2, m, s1, b, depth + 1);
}

/* The ball's centre is what X Y Z say, and stands: the tip turns about it. */
static bool centre_stands(const struct walk *w)
{
    const struct nc_piece *p = &w->motion->piece.item[w->piece];
    struct vec3 a = nc_motion_at(w->motion, p, 0).p;
    double length = 0;
    if (w->motion->track != NC_MOTION_CENTRE)
        return false;
    for (int i = 1; i <= LINE_STEPS; i++) {
        struct vec3 b = nc_motion_at(w->motion, p, (double)i / LINE_STEPS).p;
        length += vec_distance(a, b);
        a = b;
    }
    return length <= STILL;
}

/* mm: no longer, a piece may have had half its length before it was rounded, and the time that is
 * said for it, by itself or for the way of all axes, tells little. */
static double least_timed(const struct walk *w)
{
    double rounded = ROUNDED * w->tolerance;

    if (w->motion->piece.item[w->piece].inverse)
        return fmax(SHORT, rounded);
    if (w->combined)
        return w->tolerance > SHORT ? rounded : fmin(rounded, SHORT);
    return 0;
}

/* Feed of the tip, mm/min; 0: not known. */
static double tip_feed(const struct walk *w, double length)
{
    const struct nc_piece *p = &w->motion->piece.item[w->piece];
    if (length <= STILL)
        return 0; /* F counts degrees */
    if (length <= least_timed(w))
        return 0;
    if (p->inverse)
        return p->feed * length;
    if (!w->combined)
        return centre_stands(w) ? 0 : p->feed; /* degrees, too */
    struct axis_follow follow = {w->motion, {0, 0}};
    struct axis_place a = axis_limits_place(&follow, w->piece, 0);
    double way = 0;
    for (int i = 1; i <= CURVE_STEPS; i++) { /* a line of all axes is as long in steps */
        struct axis_place b = axis_limits_place(&follow, w->piece, (double)i / CURVE_STEPS);
        double step = 0;
        for (int k = 0; k < NC_AXES; k++)
            step = hypot(step, (k < 3 ? 1 : nc_motion_degree(w->motion)) * (b.axis[k] - a.axis[k]));
        way += step;
        a = b;
    }
    return way > 0 ? p->feed * length / way : 0;
}

static void follow(const struct nc_motion *m, const struct path_compare_options *options,
                   bool combined, struct stretches *to)
{
    double radius = options->radius;

    for (size_t i = 0; i < m->piece.n; i++) {
        struct walk w = {m, i, combined, radius, 0, options->tolerance, to};
        size_t first = to->n;
        double length = 0;
        if (m->piece.item[i].rapid)
            continue;
        int parts = m->piece.item[i].shape == SHAPE_LINE ? LINE_STEPS : CURVE_STEPS;
        for (int k = 0; k < parts; k++) {
            double s0 = (double)k / parts, s1 = (k + 1.0) / parts;
            add_stretches(&w, s0, tip_at(m, i, s0, radius), s1, tip_at(m, i, s1, radius), 0);
        }
        for (size_t k = first; k < to->n; k++)
            length += vec_distance(to->item[k].a.p, to->item[k].b.p);
        for (size_t k = first; k < to->n; k++)
            to->item[k].feed = tip_feed(&w, length);
        for (size_t k = first; k < to->n; k++)
            to->item[k].brief = length <= SHORT && length <= WAIT * to->item[k].feed;
    }
}

/* ---- one place beside the other motion */

struct beside {
    const struct stretches *on;
    struct nc_motion_pose pose;
    double tolerance;
    double turn;             /* least of the axis among the stretches within the tolerance */
    size_t least;            /* that one */
    double slowest, fastest; /* feeds of these */
    size_t nearest;          /* of all stretches; SIZE_MAX: there is none */
};

static double stretch_distance2(const void *items, size_t item, struct vec3 p)
{
    const struct stretch *s = (const struct stretch *)items + item;
    double d = vec_segment_distance(s->a.p, s->b.p, p);
    return d * d;
}

/* The least angle to the axis on the part of a stretch that is within the tolerance of the tip. */
static double least_turn(const struct stretch *s, const struct beside *b)
{
    struct vec3 way = vec_sub(s->b.p, s->a.p), to = vec_sub(b->pose.p, s->a.p);
    double length2 = vec_dot(way, way), first = 0, last = 1;
    if (length2 > 0) {
        double foot = vec_dot(to, way) / length2;
        struct vec3 off = vec_along(to, -foot, way);
        double reach = sqrt(fmax(0, b->tolerance * b->tolerance - vec_dot(off, off)) / length2);
        first = fmin(1, fmax(0, foot - reach));
        last = fmax(0, fmin(1, foot + reach));
    }
    struct vec3 near = vec_segment_nearest(vec_mix(s->a.a, s->b.a, first),
                                           vec_mix(s->a.a, s->b.a, last), b->pose.a);
    return vec_angle(vec_unit(near), b->pose.a);
}

static bool visit_stretch(void *context, size_t item)
{
    struct beside *b = context;
    const struct stretch *s = &b->on->item[item];
    double foot = vec_segment_foot(s->a.p, s->b.p, b->pose.p);
    if (vec_distance(vec_mix(s->a.p, s->b.p, foot), b->pose.p) > b->tolerance)
        return false;
    double turn = least_turn(s, b);
    /* where the tip stands still the axis is anywhere between both */
    if (vec_distance(s->a.p, s->b.p) < b->tolerance)
        turn = fmin(turn, fmin(vec_angle(s->a.a, b->pose.a), vec_angle(s->b.a, b->pose.a)));
    b->slowest = fmin(b->slowest, s->feed);
    b->fastest = fmax(b->fastest, s->feed);
    if (turn < b->turn) {
        b->turn = turn;
        b->least = item;
    }
    return false;
}

static struct box_tree *tree_of(const struct stretches *s)
{
    struct box *box = mem_alloc(s->n, sizeof *box);
    for (size_t i = 0; i < s->n; i++) {
        box[i] = box_empty();
        box_add(&box[i], s->item[i].a.p);
        box_add(&box[i], s->item[i].b.p);
    }
    struct box_tree *tree = box_tree_new(box, s->n);
    free(box);
    return tree;
}

static void note_fault(struct path_fault *fault, double value, size_t piece, struct vec3 at)
{
    if (fault->count++ == 0 || value > fault->value) {
        fault->value = value;
        fault->piece = piece;
        fault->at = at;
    }
}

/* ---- both ways */

struct compare {
    const struct nc_motion *motion; /* the program's */
    const struct path_compare_options *options;
    struct stretches program, path;
    struct box_tree *program_tree, *path_tree;
    struct path_compare found;
};

/* How far off the other motion; within the tolerance by how much the axis is turned. */
static double look_beside(const struct compare *c, bool path, struct nc_motion_pose pose,
                          struct beside *b)
{
    const struct stretches *on = path ? &c->path : &c->program;
    const struct box_tree *tree = path ? c->path_tree : c->program_tree;
    *b = (struct beside){on, pose, c->options->tolerance, PI, 0, HUGE_VAL, 0, SIZE_MAX};
    double off = box_tree_nearest(tree, on->item, stretch_distance2, pose.p, HUGE_VAL, &b->nearest);
    if (off <= c->options->tolerance)
        box_tree_each(tree, pose.p, c->options->tolerance, visit_stretch, b);
    return off;
}

/* Where the axes stand before a piece: an axis straight up leaves one of them where it was. */
static struct axis_follow follow_before(const struct compare *c, size_t piece)
{
    enum { BEFORE = 64, STEPS = 4 };
    struct axis_follow follow = {c->motion, {0, 0}};
    size_t from = piece > BEFORE ? piece - BEFORE : 0;
    for (size_t i = from; i < piece; i++)
        for (int k = 1; k <= STEPS; k++)
            axis_limits_place(&follow, i, (double)k / STEPS);
    return follow;
}

/* The fastest that the tip can go all along a piece of the program, as no axis is faster than it
 * can be. */
static double piece_allows(const struct compare *c, size_t piece)
{
    enum { PIECES = 64 };
    const struct axis_limits *limits = c->options->limits;
    struct axis_follow follow = follow_before(c, piece);
    struct axis_place a = axis_limits_place(&follow, piece, 0);
    double feed = HUGE_VAL;
    for (int i = 1; limits && i <= PIECES; i++) {
        struct axis_place b = axis_limits_place(&follow, piece, (double)i / PIECES);
        double minutes = 0, length = vec_distance(a.tip, b.tip);
        for (int k = 0; k < NC_AXES; k++)
            minutes = fmax(minutes, fabs(b.axis[k] - a.axis[k]) / limits->rapid[k]);
        if (minutes > 0)
            feed = fmin(feed, length / minutes);
        a = b;
    }
    return feed;
}

/* Pieces of one curve; polynomials, each of which is a block, go on with the feed of the first. */
static bool same_curve(const struct nc_piece *a, const struct nc_piece *b)
{
    if (a->shape == SHAPE_POLYNOMIAL)
        return b->shape == SHAPE_POLYNOMIAL && a->feed == b->feed;
    return a->shape == SHAPE_SPLINE && b->shape == SHAPE_SPLINE && a->index == b->index;
}

/* The same over the whole curve that it is a piece of, for which there is one F. */
static double allowed_feed(const struct compare *c, size_t piece)
{
    const struct nc_piece *all = c->motion->piece.item;
    size_t from = piece, to = piece + 1;
    double feed = HUGE_VAL;
    while (from > 0 && same_curve(&all[from - 1], &all[piece]))
        from--;
    while (to < c->motion->piece.n && same_curve(&all[to], &all[piece]))
        to++;
    for (size_t i = from; i < to; i++)
        feed = fmin(feed, piece_allows(c, i));
    return feed;
}

static void compare_feed(struct compare *c, const struct stretch *s, const struct beside *path)
{
    const struct path_compare_options *o = c->options;
    if (!(path->slowest > 0) || !(s->feed > 0))
        return;
    if (s->feed > o->fast * path->fastest)
        note_fault(&c->found.fast, s->feed / path->fastest, s->piece, s->b.p);
    if (!s->brief && s->feed * o->slow < path->slowest &&
        s->feed * o->slow < allowed_feed(c, s->piece))
        note_fault(&c->found.slow, path->slowest / s->feed, s->piece, s->b.p);
}

/* The stretches of the program from one rapid move to the next: what is off the path before the
 * first that is on it, and after the last, is approach and retract. */
static void compare_run(struct compare *c, size_t from, size_t to)
{
    size_t first = to, last = from;
    double *off = mem_alloc(to - from, sizeof *off);
    for (size_t i = from; i < to; i++) {
        struct beside b;
        const struct stretch *s = &c->program.item[i];
        off[i - from] = look_beside(c, true, s->b, &b);
        if (off[i - from] > c->options->tolerance)
            continue;
        first = first == to ? i : first;
        last = i;
        if (b.turn > c->options->axis)
            note_fault(&c->found.turned, b.turn, s->piece, s->b.p);
        compare_feed(c, s, &b);
    }
    for (size_t i = first; i < last; i++)
        if (off[i - from] > c->options->tolerance)
            note_fault(&c->found.off, off[i - from], c->program.item[i].piece,
                       c->program.item[i].b.p);
    free(off);
}

static void compare_program(struct compare *c, const struct nc_motion *program)
{
    for (size_t i = 0; i < c->program.n;) {
        size_t from = i++;
        while (i < c->program.n) {
            size_t a = c->program.item[i - 1].piece, b = c->program.item[i].piece;
            bool apart = false;
            for (size_t k = a + 1; k < b && !apart; k++)
                apart = program->piece.item[k].rapid;
            if (apart)
                break;
            i++;
        }
        compare_run(c, from, i);
    }
}

/* True if it is the worst so far. */
static bool note_missed(struct compare *c, double off, const struct stretch *s, size_t nearest)
{
    bool worst = c->found.missed.count == 0 || off > c->found.missed.value;
    if (worst)
        c->found.missed.near = nearest < c->program.n ? c->program.item[nearest].piece : 0;
    note_fault(&c->found.missed, off, s->piece, s->b.p);
    return worst;
}

/* Of the pieces from..to of the program, the one nearest to a place. */
static size_t nearest_between(const struct compare *c, size_t from, size_t to, struct vec3 place)
{
    double least = HUGE_VAL;
    size_t nearest = to;
    for (size_t i = 0; i < c->program.n; i++) {
        const struct stretch *s = &c->program.item[i];
        double d = vec_segment_distance(s->a.p, s->b.p, place);
        if (s->piece < from || s->piece > to || d >= least)
            continue;
        least = d;
        nearest = s->piece;
    }
    return nearest;
}

/* The part does not go along this stretch of the path; another may. */
static bool is_beyond(struct compare *c, const struct stretch *s)
{
    struct beside b;
    double off = look_beside(c, false, s->b, &b);
    if (off > c->options->tolerance)
        note_fault(&c->found.beyond, off, s->piece, s->b.p);
    return off > c->options->tolerance;
}

/* What is missed is told at the nearest piece between those where the path was on the program
 * before and is on it again, or there: not on a row beside. */
static void compare_path(struct compare *c)
{
    size_t last = 0, from = 0, to = c->path.n;
    bool waits = false;
    while (c->options->part && from < to && is_beyond(c, &c->path.item[from]))
        from++;
    while (c->options->part && from < to && is_beyond(c, &c->path.item[to - 1]))
        to--;
    for (size_t i = from; i < to; i++) {
        struct beside b;
        const struct stretch *s = &c->path.item[i];
        double off = look_beside(c, false, s->b, &b);
        if (off > c->options->tolerance) {
            waits = note_missed(c, off, s, b.nearest) || waits;
            continue;
        }
        size_t piece = c->program.item[b.least].piece;
        if (waits && (c->found.missed.near < last || c->found.missed.near > piece))
            c->found.missed.near = nearest_between(c, last, piece, c->found.missed.at);
        waits = false;
        last = piece;
        if (b.turn > c->options->axis)
            note_fault(&c->found.turned, b.turn, piece, s->b.p);
    }
    if (waits && c->found.missed.near < last)
        c->found.missed.near = last;
}

struct path_compare path_compare_run(const struct nc_motion *program, const struct nc_motion *path,
                                     const struct path_compare_options *options)
{
    struct compare c = {.motion = program, .options = options};
    follow(program, options, (options->limits && options->limits->combined), &c.program);
    follow(path, options, false, &c.path);
    c.program_tree = tree_of(&c.program);
    c.path_tree = tree_of(&c.path);
    compare_program(&c, program);
    compare_path(&c);
    box_tree_free(c.program_tree);
    box_tree_free(c.path_tree);
    array_free(&c.program);
    array_free(&c.path);
    return c.found;
}

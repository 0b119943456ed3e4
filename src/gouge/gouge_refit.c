/* gouge_refit - see gouge_refit.h. */
#include "gouge/gouge_refit.h"

#include <stdlib.h>
#include <string.h>

#include "holder_glance.h"

enum { HALVINGS = 16, SWEPT_HALVINGS = 24, ROUNDS = 8 };
enum { MOTIONS_AHEAD = 256 }; /* looked at for one that was found before */

static const double PIECE = 1;       /* mm: of a motion, looked at as one place */
static const double FINER = 1.0 / 8; /* of the chord error, where that decides */
static const double ROUNDING = 1e-9; /* mm: more than a place of the ball is off by it */
static const double USELESS = 0.95;  /* of the depth before: it did not help */
static const double ROUGHLY = 0.1;   /* of its depth, a holder may move at a deep place unseen */
static const double ASTRAY = 1.2;    /* times the tolerance, deeper than a fit near the line is */
static const double SHORT = 1.0 / 8; /* of the tool's reach, a part of a motion may move it */
static const double NEAR = 0.5;      /* mm: points this near to a place are lifted all the way */

struct walk {
    const struct gouge_refit_options *options;
    const struct motion *motion;
    struct great_circle turn; /* of the motion's axis */
    /* mm: no part of it is farther off its chord, but for the square of how much of the motion it
     * is */
    double bend;
    struct gouge_track *track;
    double chord_error;
    struct gouges *gouges;
};

/* All that was asked for is known. */
static bool is_found(const struct gouge_refit_options *options, const struct gouges *gouges)
{
    return options->any && gouges->n > 0;
}

static struct vec3 ball_at(const struct walk *w, double s)
{
    struct pose pose = motion_on(w->motion, &w->turn, s);

    return w->options->centre ? pose.p : vec_along(pose.p, w->options->radius, pose.a);
}

/* An eighth of the most that the speed of the ball changes by. */
static double bend_of(const struct gouge_refit_options *options, const struct motion *motion,
                      double turn)
{
    double bend = options->centre ? 0 : options->radius * turn * turn;

    if (motion->kind == MOTION_SPLINE)
        return HUGE_VAL;
    if (motion->kind == MOTION_ARC) { /* its radius may change */
        struct vec3 from = vec_sub(motion->from.p, motion->centre),
                    to = vec_sub(motion->to.p, motion->centre);
        double r0 = vec_length(vec_reject(from, motion->axis)),
               r1 = vec_length(vec_reject(to, motion->axis));
        bend += (fmax(r0, r1) * motion->sweep + 2 * fabs(r1 - r0)) * motion->sweep;
    }
    return bend / 8;
}

/* The ball's way from a to b is short, and straight within w->chord_error; else *m is where it is
 * in the middle. */
static bool is_straight(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                        struct vec3 *m)
{
    double s = (s0 + s1) / 2;
    bool near = vec_distance(a, b) <= PIECE;

    if (near && w->bend * (s1 - s0) * (s1 - s0) + ROUNDING <= w->chord_error)
        return true;
    *m = ball_at(w, s);
    return near && vec_line_distance(a, b, *m) <= w->chord_error &&
           vec_line_distance(a, b, ball_at(w, (s0 + s) / 2)) <= w->chord_error &&
           vec_line_distance(a, b, ball_at(w, (s + s1) / 2)) <= w->chord_error;
}

static void check_halves(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                         int halvings);

/* A piece of the motion, straight within w->chord_error.  Where that much decides, it is looked at
 * more closely. */
static void check_piece(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                        int halvings)
{
    double tolerance = GOUGE_SAFE * w->options->tolerance, may = tolerance - w->chord_error;
    double deeper = gouge_track_depth(w->track, w->options->guard, a, b, w->options->radius - may);

    if (deeper <= 0)
        return;
    if (deeper > 2 * w->chord_error || w->chord_error < GOUGE_FINEST * tolerance || halvings == 0) {
        *array_push(w->gouges) = (struct gouge){vec_mix(a, b, 0.5), deeper + may, TOOL_BALL};
        return;
    }
    struct walk closer = *w;
    closer.chord_error *= FINER;
    check_halves(&closer, s0, a, s1, b, halvings);
}

static void check_halves(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                         int halvings)
{
    if (is_found(w->options, w->gouges))
        return;
    double s = (s0 + s1) / 2;
    struct vec3 m;

    if (is_straight(w, s0, a, s1, b, &m) || halvings == 0) {
        check_piece(w, s0, a, s1, b, halvings);
        return;
    }
    check_halves(w, s0, a, s, m, halvings - 1);
    check_halves(w, s, m, s1, b, halvings - 1);
}

static void check_ball(const struct gouge_refit_options *options, const struct motion *motion,
                       struct gouge_track *track, struct gouges *gouges)
{
    struct walk w = {.options = options,
                     .motion = motion,
                     .turn = great_circle_of(motion->from.a, motion->to.a),
                     .track = track,
                     .chord_error = options->tolerance * GOUGE_CHORD,
                     .gouges = gouges};
    double s0 = 0;

    w.bend = bend_of(options, motion, w.turn.angle);
    while (s0 < 1) {
        double s1 = motion_next_knot(motion, s0), middle = (s0 + s1) / 2;
        struct vec3 m = ball_at(&w, middle);
        /* halved once at least: a full turn ends where it begins */
        check_halves(&w, s0, ball_at(&w, s0), middle, m, HALVINGS);
        check_halves(&w, middle, m, s1, ball_at(&w, s1), HALVINGS);
        s0 = s1;
    }
}

/* ---- shank and holder */

/* A pose of the motion, and how far the holder is from the guard there, as far as it matters. */
struct station {
    double s;
    struct vec3 ball, axis;
    double clear;
};

/* The way of the holder on one motion, and the guard points that it may come near to. */
struct sweep {
    const struct gouge_refit_options *options;
    const struct motion *motion;
    struct great_circle turn; /* of its axis */
    struct vec3s *near; /* a pile: those of a part of the motion on top of those of the whole */
    struct gouges *gouges;
};

static struct pose ball_pose(const struct sweep *sweep, double s)
{
    const struct gouge_refit_options *options = sweep->options;
    struct pose pose = motion_on(sweep->motion, &sweep->turn, s);
    double up = options->centre ? 0 : options->radius;

    return (struct pose){vec_along(pose.p, up, pose.a), pose.a};
}

static struct station station_of(double s, const struct pose *pose)
{
    return (struct station){s, pose->p, pose->a, 0};
}

/* No place of the holder moves farther than this between two poses, with three more in between:
 * each `stride` behind the one before.  A curve is looked at between them too. */
static double most_moved(const struct sweep *sweep, const struct pose *pose, int stride)
{
    const struct gouge_refit_options *options = sweep->options;
    const double longer = 1.12; /* than its chord is a quarter turn, as long as it is halved */
    bool line = sweep->motion->kind == MOTION_LINE;
    double lever = holder_reach(&options->holder) + (options->centre ? 0 : 2 * options->radius);
    double moved = 0;

    stride = line ? 4 * stride : stride;
    for (int i = 0; i < (line ? 1 : 4); i++, pose += stride)
        moved += vec_distance(pose->p, pose[stride].p) + lever * vec_angle(pose->a, pose[stride].a);
    return line ? moved : longer * moved;
}

/* Is it the shank, no wider than the ball, that is so deep? */
static enum tool_part part_at(const struct gouge_refit_options *options, const struct station *at)
{
    struct holder shaft = options->holder;

    for (shaft.n = 0; shaft.n < options->holder.n; shaft.n++)
        if (options->holder.part[shaft.n].high > options->radius * (1 + 1e-6))
            break;
    if (shaft.n == options->holder.n)
        return TOOL_SHAFT;
    double clear = gouge_holder(options->guard, &shaft, at->ball, at->axis, 0);
    return clear <= at->clear + 1e-9 ? TOOL_SHAFT : TOOL_HOLDER;
}

static void add_station(const struct gouge_refit_options *options, const struct station *at,
                        struct gouges *gouges)
{
    if (-at->clear > GOUGE_SAFE * options->tolerance)
        *array_push(gouges) = (struct gouge){at->ball, -at->clear, part_at(options, at)};
}

/* A part of the motion, and the points on the pile that are near to it. */
struct swept_part {
    struct station a, b;
    const struct pose *pose; /* evenly from a to b, as in a glance */
    size_t from, to;
};

static void measure(const struct sweep *s, const struct swept_part *part, double below,
                    struct station *at)
{
    at->clear = below;
    for (size_t i = part->from; i < part->to; i++)
        at->clear = fmin(at->clear, holder_distance_below(&s->options->holder, at->ball, at->axis,
                                                          s->near->item[i], at->clear));
}

enum { MIDDLE = GLANCE_PARTS };

/* With the poses that half of a part has in common with all of it, `known`, if there are any. */
static struct holder_glance glance_at(const struct sweep *s, double from, double to,
                                      const struct pose *known)
{
    struct holder_glance glance = {.holder = &s->options->holder,
                                   .least = -GOUGE_SAFE * s->options->tolerance};

    for (int i = 0; i < GLANCE_POSES; i++) {
        double part = (double)i / (GLANCE_POSES - 1);
        glance.pose[i] =
            known && i % 2 == 0 ? known[i / 2] : ball_pose(s, from + part * (to - from));
    }
    holder_glance_measure(&glance);
    return glance;
}

static void check_between(const struct sweep *s, const struct swept_part *part, int halvings);

/* Half of a part, by the points of the whole that it may come near to: without any it is clear. */
static void check_half(const struct sweep *s, const struct swept_part *whole, struct station a,
                       struct station b, int halvings)
{
    if (is_found(s->options, s->gouges))
        return;
    const struct pose *known = a.s > whole->a.s ? &whole->pose[MIDDLE] : whole->pose;
    struct holder_glance glance = glance_at(s, a.s, b.s, known);
    struct swept_part half = {a, b, glance.pose, whole->to, whole->to};

    s->near->n = whole->to;
    holder_glance_choose(&glance, whole->from, whole->to, s->near);
    half.to = s->near->n;
    if (half.to > half.from)
        check_between(s, &half, halvings);
}

static void check_between(const struct sweep *s, const struct swept_part *part, int halvings)
{
    const struct gouge_refit_options *options = s->options;
    const struct station *a = &part->a, *b = &part->b;
    double moved = most_moved(s, part->pose, 2), may = GOUGE_SAFE * options->tolerance;

    if (fmin(a->clear, moved) + fmin(b->clear, moved) + 2 * may >= moved)
        return;
    double deep = -fmin(a->clear, b->clear), enough = GOUGE_SWEPT * options->tolerance;
    bool certain = options->any && deep > 2 * may; /* no halving lets it by */
    if (certain || moved <= fmax(enough, deep > may ? ROUGHLY * deep : 0) || halvings == 0) {
        add_station(options, a->clear < b->clear ? a : b, s->gouges);
        return;
    }
    struct station m = station_of((a->s + b->s) / 2, &part->pose[MIDDLE]);
    measure(s, part, moved, &m);
    check_half(s, part, *a, m, halvings - 1);
    check_half(s, part, m, *b, halvings - 1);
}

/* A part of the motion by the points it may come near to, with the poses of a glance at it. */
static void check_near(const struct sweep *s, double from, double to, const struct pose *pose)
{
    struct swept_part part = {station_of(from, pose), station_of(to, &pose[GLANCE_POSES - 1]), pose,
                              0, s->near->n};
    struct station m = station_of((from + to) / 2, &pose[MIDDLE]);
    double below = most_moved(s, pose, 1) + most_moved(s, &pose[MIDDLE], 1);

    measure(s, &part, below, &part.a);
    measure(s, &part, below, &m);
    measure(s, &part, below, &part.b);
    check_half(s, &part, part.a, m, SWEPT_HALVINGS);
    check_half(s, &part, m, part.b, SWEPT_HALVINGS);
}

/* A part of the motion; a long one by its halves, for on its whole way the tool comes near to more
 * points than on all of its short parts. */
static void check_part(const struct sweep *s, double from, double to, const struct pose *known,
                       int halvings)
{
    struct holder_glance glance = glance_at(s, from, to, known);
    double most = SHORT * holder_reach(&s->options->holder), middle = (from + to) / 2;

    if (is_found(s->options, s->gouges))
        return;
    if (glance.part_moved > most && halvings > 0) {
        check_part(s, from, middle, glance.pose, halvings - 1);
        check_part(s, middle, to, &glance.pose[MIDDLE], halvings - 1);
        return;
    }
    s->near->n = 0;
    holder_glance_gather(s->options->guard, &glance, s->near);
    if (s->near->n > 0)
        check_near(s, from, to, glance.pose);
}

static void check_holder(const struct gouge_refit_options *options, const struct motion *motion,
                         struct gouge_track *track, struct gouges *gouges)
{
    struct sweep s = {options, motion, great_circle_of(motion->from.a, motion->to.a), &track->near,
                      gouges};
    double from = 0;

    while (from < 1 && !is_found(options, gouges)) {
        double to = motion_next_knot(motion, from);
        check_part(&s, from, to, NULL, HALVINGS);
        from = to;
    }
}

const char *tool_part_name(enum tool_part part)
{
    return part == TOOL_BALL ? "ball" : part == TOOL_SHAFT ? "shaft" : "holder";
}

void gouge_refit_motion(const struct gouge_refit_options *options, const struct motion *motion,
                        struct gouge_track *track, struct gouges *gouges)
{
    if (!options->guard)
        return;
    check_ball(options, motion, track, gouges);
    if (options->holder.n > 0)
        check_holder(options, motion, track, gouges);
}

/* ---- what was found before */

void gouge_memo_free(struct gouge_memo *memo)
{
    gouge_track_free(&memo->track);
    array_free(&memo->seen);
    array_free(&memo->found);
    *memo = (struct gouge_memo){0};
}

static bool is_same(const struct motion *a, const struct motion *b)
{
    return a->kind == b->kind && a->sweep == b->sweep && vec_compare(&a->from.p, &b->from.p) == 0 &&
           vec_compare(&a->to.p, &b->to.p) == 0 && vec_compare(&a->from.a, &b->from.a) == 0 &&
           vec_compare(&a->to.a, &b->to.a) == 0 && vec_compare(&a->centre, &b->centre) == 0 &&
           vec_compare(&a->axis, &b->axis) == 0;
}

/* The same motion among the next ones, from the start again behind the last; NULL: not there. */
static const struct gouge_seen *find_seen(struct gouge_memo *memo, const struct motion *motion)
{
    for (size_t i = 0; i < MOTIONS_AHEAD && i < memo->seen.n; i++) {
        size_t k = (memo->at + i) % memo->seen.n;
        if (!is_same(&memo->seen.item[k].motion, motion))
            continue;
        memo->at = k + 1;
        return &memo->seen.item[k];
    }
    return NULL;
}

/* Before the next one: so they stay in the order of the way. */
static void insert_seen(struct gouge_memo *memo, struct gouge_seen seen)
{
    size_t at = memo->at, after = memo->seen.n - at;

    array_push(&memo->seen);
    struct gouge_seen *here = &memo->seen.item[at];
    memmove(here + 1, here, after * sizeof *here);
    *here = seen;
    memo->at = at + 1;
}

void gouge_refit_once(const struct gouge_refit_options *options, const struct motion *motion,
                      struct gouge_memo *memo, struct gouges *gouges)
{
    const struct gouge_seen *seen = motion->kind == MOTION_SPLINE ? NULL : find_seen(memo, motion);

    for (size_t i = 0; seen && i < seen->n; i++)
        *array_push(gouges) = memo->found.item[seen->first + i];
    if (seen)
        return;
    size_t before = gouges->n;
    gouge_refit_motion(options, motion, &memo->track, gouges);
    if (motion->kind == MOTION_SPLINE)
        return;
    insert_seen(memo, (struct gouge_seen){*motion, memo->found.n, gouges->n - before});
    for (size_t i = before; i < gouges->n; i++)
        *array_push(&memo->found) = gouges->item[i];
}

/* So far from a place there are points on both sides of it. */
static double reach_around(const struct run *run, struct vec3 place)
{
    double nearest = HUGE_VAL, apart = 0;

    for (size_t i = 0; i < run->n; i++) {
        double distance = vec_distance(run->item[i].ball, place);
        if (distance >= nearest)
            continue;
        nearest = distance;
        apart = 0;
        if (i > 0)
            apart = vec_distance(run->item[i].ball, run->item[i - 1].ball);
        if (i + 1 < run->n)
            apart = fmax(apart, vec_distance(run->item[i].ball, run->item[i + 1].ball));
    }
    return fmax(NEAR, nearest + apart);
}

/* The points are as they should be there: the smooth curve between two of them, *at the first, goes
 * astray, for a fit within the tolerance of the straight line would go less deep. */
static bool goes_astray(const struct gouge_refit_options *options, const struct gouge *gouge,
                        const struct run *run, size_t *at)
{
    double within = options->radius - GOUGE_SAFE * options->tolerance;

    if (gouge->part != TOOL_BALL || !(gouge->depth > ASTRAY * options->tolerance))
        return false;
    *at = run_motion_at(run, 0, run->n - 1, gouge->ball);
    const struct run_point *from = &run->item[*at];
    return !from->straight &&
           gouge_depth_along(options->guard, from->ball, from[1].ball, within) <= 0;
}

bool gouge_refit_straighten(const struct gouge_refit_options *options, struct gouges *gouges,
                            struct run *run)
{
    struct sizes astray = {0};
    size_t others = 0;

    for (size_t k = 0; run->n > 1 && k < gouges->n; k++) {
        struct gouge gouge = gouges->item[k];
        size_t i;
        if (goes_astray(options, &gouge, run, &i))
            *array_push(&astray) = i;
        else
            gouges->item[others++] = gouge;
    }
    gouges->n = others;
    for (size_t k = 0; k < astray.n; k++)
        run->item[astray.item[k]].straight = true;
    bool any = astray.n > 0;
    array_free(&astray);
    return any;
}

double gouge_refit_lift(const struct gouge_refit_options *options, const struct gouges *gouges,
                        struct run *run)
{
    double *lift = mem_alloc(run->n, sizeof *lift), highest = 0;

    for (size_t i = 0; i < run->n; i++)
        lift[i] = 0;
    for (size_t k = 0; k < gouges->n; k++) {
        const struct gouge *gouge = &gouges->item[k];
        if (gouge->part != TOOL_BALL)
            continue;
        double reach = reach_around(run, gouge->ball),
               whole = gouge->depth - GOUGE_LIFTED * options->tolerance;
        for (size_t i = 1; i + 1 < run->n; i++) {
            double beyond = vec_distance(run->item[i].ball, gouge->ball) / reach - 1;
            double share = beyond <= 0 ? 1 : beyond >= 2 ? 0 : (1 + cos(beyond * PI / 2)) / 2;
            lift[i] = fmax(lift[i], share * whole);
        }
    }
    for (size_t i = 0; i < run->n; i++) {
        struct run_point *p = &run->item[i];
        struct vec3 up = vec_length(p->normal) > 0.5 ? p->normal : p->axis;
        p->ball = vec_along(p->ball, lift[i], up);
        p->tip = vec_along(p->tip, lift[i], up);
        highest = fmax(highest, lift[i]);
    }
    free(lift);
    return highest;
}

struct gouge gouge_refit_deepest(const struct gouges *gouges)
{
    struct gouge deepest = {.depth = 0};

    for (size_t i = 0; i < gouges->n; i++)
        if (gouges->item[i].depth > deepest.depth)
            deepest = gouges->item[i];
    return deepest;
}

struct gouge gouge_refit_beyond(const struct gouge_refit_options *options,
                                const struct gouges *gouges)
{
    struct gouge deepest = gouge_refit_deepest(gouges);

    if (deepest.depth <= (1 + GOUGE_PRINTED) * options->tolerance)
        deepest.depth = 0;
    return deepest;
}

struct gouge_refit_result
gouge_refit_fit(const struct gouge_refit_options *options, struct run *run,
                void (*fit)(void *context, const struct run *run, struct gouges *gouges),
                void *context)
{
    struct gouge_refit_result result = {.lift = 0};
    struct gouges gouges = {0};

    fit(context, run, &gouges);
    for (int round = 1; round < ROUNDS && gouges.n > 0; round++) {
        size_t before = gouges.n;
        double depth = gouge_refit_deepest(&gouges).depth;
        bool straighter = gouge_refit_straighten(options, &gouges, run);
        double lift = gouge_refit_lift(options, &gouges, run);
        if (lift == 0 && !straighter)
            break;
        result.lift += lift;
        gouges.n = 0;
        fit(context, run, &gouges);
        if (gouges.n >= before && gouge_refit_deepest(&gouges).depth > USELESS * depth && round > 2)
            break; /* as at an end */
    }
    result.deepest = gouge_refit_beyond(options, &gouges);
    if (result.deepest.depth > 0)
        result.left = gouges;
    else
        array_free(&gouges);
    return result;
}

void gouge_refit_free(struct gouge_refit_options *options)
{
    gouge_free((struct gouge_check *)options->guard);
    options->guard = NULL;
}

/* post_motion - see post_motion.h. */
#include "post_motion.h"

#include "base/array.h"
#include "base/num.h"
#include "machine/rotary_cost.h"
#include "post_feed.h"
#include "post_ik.h"

enum {
    DEPTH_MAX = 22, /* halvings of a straight motion: beside the singular direction */
    PARTS_MAX = 512 /* equal parts of one, before they are halved */
};

/* ---- one more block */

/* fmax for what is a number, without a call. */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

struct nc_move *post_motion_append(struct nc_planner *planner, enum nc_kind kind,
                                   const struct machine_pose *target)
{
    const struct block_pose *to = &target->at;
    struct nc_plan *plan = planner->plan;
    struct nc_state *state = &planner->state;
    struct nc_move *move = array_push_inline(&plan->move);
    *move = (struct nc_move){.kind = kind,
                             .why = state->why,
                             .line = state->line,
                             .p = to->p,
                             .q = {to->q[0], to->q[1]}};
    if (planner->follow.mode == INTERPOLATE_VECTOR) {
        move->vector = (unsigned)plan->vector.n;
        *array_push(&plan->vector) = to->a;
    }
    state->at = *to;
    state->turned = target->turned;
    state->off.point = state->off.axis = NAN;
    planner->off_part = false;
    return move;
}

static void add_move(struct nc_planner *planner, enum nc_kind kind,
                     const struct machine_pose *target, double length, size_t index,
                     const struct nc_along *along)
{
    struct nc_total *total = &planner->plan->total;
    double minutes, feed = 0;
    if (kind == NC_RAPID) {
        minutes = post_feed_axes_minutes(planner, &planner->state.at, &target->at);
        minutes = larger(minutes, length / planner->machine->rapid[MACHINE_X]);
        total->rapid += length;
        total->rapids++;
    } else {
        feed = post_feed_word(planner, target, length, along, &minutes);
        total->cut += length;
        total->lines += kind == NC_LINE;
        total->arcs += kind == NC_ARC;
        total->splines += kind == NC_SPLINE;
    }
    total->minutes += minutes;
    struct nc_move *move = post_motion_append(planner, kind, target);
    move->feed = feed;
    move->index = (unsigned)index;
}

/* Both say the same; of vectors with the tip at rest no more than the last digit may differ: a path
 * that is read and written again says one direction in two ways. */
static bool says_the_same(const struct nc_planner *planner, const struct block_pose *to)
{
    const struct block_pose *at = &planner->state.at;
    double last = 1 / num_ten[planner->plan->ability.digits.vector];
    if (at->p.x != to->p.x || at->p.y != to->p.y || at->p.z != to->p.z)
        return false;
    if (planner->follow.mode == INTERPOLATE_VECTOR)
        return vec_distance(at->a, to->a) < 2 * last;
    return at->q[0] == to->q[0] && at->q[1] == to->q[1];
}

static void add_straight(struct nc_planner *planner, enum nc_kind kind,
                         const struct machine_pose *to, const struct pose *goal)
{
    struct nc_state *state = &planner->state;
    if (!says_the_same(planner, &to->at))
        add_move(planner, kind, to, vec_distance(state->pose.p, goal->p), 0, NULL);
    state->off.point = state->off.axis = NAN;
    state->pose = *goal;
}

enum { TURN_STEP = 2 /* degrees */ };

static const double BESIDE_POLE = 0.002; /* radians */

/* The rotary axes turn to q in n blocks alike, the tip at rest. */
static void turn_standing(struct nc_planner *planner, enum nc_kind kind, const double q[], int n)
{
    double from[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    for (int k = 1; k <= n; k++) {
        double part[ROTARY_MAX];
        for (int i = 0; i < ROTARY_MAX; i++)
            part[i] = from[i] + (q[i] - from[i]) * k / n;
        struct machine_pose to = post_ik_pose(planner, planner->state.pose, part);
        add_move(planner, kind, &to, 0, 0, NULL);
    }
}

void post_motion_turn(struct nc_planner *planner, const double q[])
{
    double from[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    double far = DEGREES(ik_most_turn(&planner->machine->chain, q, from));
    int n = planner->follow.mode == INTERPOLATE_JOINT ? (int)ceil(far / TURN_STEP) : 1;
    turn_standing(planner, NC_RAPID, q, n);
}

/* ---- a straight motion as one block */

/*
 * The block is surely no further off than what blocks before it have spent: so much by the digits
 * at its ends, and so much more between them.  False says nothing.
 */
static bool within_spent(const struct nc_planner *planner, const struct machine_pose *to,
                         const struct pose *goal, struct pose_deviation off)
{
    const struct nc_state *state = &planner->state;
    struct pose_deviation spent = planner->plan->total.spent, d = state->off, bend = {0, 0};
    if (!(d.point >= 0 && off.point >= 0)) /* not known */
        return false;
    if (planner->follow.mode != INTERPOLATE_VECTOR || planner->plan->ability.doubtful)
        bend = interpolation_bend(&planner->follow, &state->at, &to->at);
    d.axis = bend.axis + larger(d.axis, off.axis);
    d.point = bend.point + larger(d.point, off.point) + fabs(planner->follow.ball) * d.axis;
    if (planner->follow.mode ==
        INTERPOLATE_JOINT) { /* the tip runs ahead of the axis by so much at most */
        double length = vec_distance(state->pose.p, goal->p);
        double other = d.point / length * (1.05 * vec_distance(state->pose.a, goal->a) + bend.axis);
        d.axis += other;
        d.point += fabs(planner->follow.ball) * other;
    }
    return pose_deviation_within(d, spent) && pose_deviation_within(d, planner->allowed);
}

/* A bound from a closer look, for each way in which the control may turn the axis. */
static struct pose_deviation deviation_bound(const struct nc_planner *planner,
                                             const struct machine_pose *to, const struct pose *goal)
{
    const struct nc_state *state = &planner->state;
    const struct machine_pose from = {state->at, state->turned};
    struct interpolation f = planner->follow;
    struct pose_deviation d =
        interpolation_line(&f, &from, to, state->pose, *goal, planner->allowed);
    f.mode = INTERPOLATE_ROTARY;
    if (planner->plan->ability.doubtful && pose_deviation_within(d, planner->allowed))
        d = pose_deviation_worst(
            d, interpolation_line(&f, &from, to, state->pose, *goal, planner->allowed));
    return d;
}

/* With vectors the control may be led to turn back: see turns_back. */
static bool turns_far(const struct nc_planner *planner, const struct machine_pose *to)
{
    const double *q = planner->state.at.q;
    return planner->follow.mode == INTERPOLATE_VECTOR &&
           (fabs(to->at.q[0] - q[0]) >= PI / 2 || fabs(to->at.q[1] - q[1]) >= PI / 2);
}

int post_motion_one_block(struct nc_planner *planner, const struct pose *to)
{
    struct machine_pose target;
    struct pose_deviation off = {NAN, NAN};
    if (post_ik_reach_near(planner, to, &target, &off)
            ? post_ik_check_linear(planner, &target) != 0
            : post_ik_reach(planner, *to, 1, &target) != 0)
        return 1;
    if (turns_far(planner, &target))
        return 1;
    if (planner->follow.mode == INTERPOLATE_VECTOR) {
        struct motion line = motion_line(planner->state.pose, *to);
        if (post_ik_pole_between(planner, &line, 0, 1) < 1 ||
            post_feed_divide_even(planner, &line, 0, 1) < 1 ||
            !post_ik_follow(planner, &line, 0, 1, &target))
            return 1;
    }
    if (!within_spent(planner, &target, to, off)) {
        struct pose_deviation d = deviation_bound(planner, &target, to);
        if (!pose_deviation_within(d, planner->allowed))
            return 1;
        planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, d);
    }
    add_straight(planner, NC_LINE, &target, to);
    planner->state.off = off;
    return 0;
}

/* ---- a straight motion as straight blocks */

/* How far the block to a target is off the motion. */
static struct pose_deviation deviation_in_mode(const struct nc_planner *planner,
                                               const struct interpolation *f,
                                               const struct machine_pose *to,
                                               const struct motion *motion, double s0, double s1,
                                               struct pose_deviation allowed)
{
    const struct nc_state *state = &planner->state;
    if (motion->kind == MOTION_LINE) {
        struct machine_pose from = {state->at, state->turned};
        struct pose goal = motion_at(motion, s1);
        struct pose_deviation most = interpolation_line(f, &from, to, state->pose, goal, allowed);
        if (pose_deviation_within(most, allowed))
            return most;
    }
    return interpolation_block(f, &state->at, &to->at, motion, s0, s1);
}

/*
 * Vectors leave the rotary axes to the control, which goes on with them as they stand: where they
 * could only follow by way of another solution or whole turns back, the block cannot be.  Beside
 * the singular direction they may turn far while the tool hardly does.
 */
static bool turns_back(const struct nc_planner *planner, const struct machine_pose *to,
                       const struct motion *motion, double s0, double s1)
{
    const struct block_pose *at = &planner->state.at;
    struct interpolation rotary = planner->follow;
    double most = 0;
    for (int i = 0; i < rotary.chain->n; i++)
        most = fmax(most, fabs(to->at.q[i] - at->q[i]));
    if (planner->follow.mode != INTERPOLATE_VECTOR || most < PI / 2)
        return false;
    rotary.mode = INTERPOLATE_ROTARY;
    double great = vec_angle(motion_at(motion, s0).a, motion_at(motion, s1).a);
    return interpolation_block(&rotary, at, &to->at, motion, s0, s1).axis > great + RADIANS(1);
}

/* The same for every way in which the control may turn the axis. */
static struct pose_deviation deviation_of(const struct nc_planner *planner,
                                          const struct machine_pose *to,
                                          const struct motion *motion, double s0, double s1,
                                          struct pose_deviation allowed)
{
    struct interpolation other = planner->follow;
    if (allowed.axis < HUGE_VAL && turns_back(planner, to, motion, s0, s1))
        return (struct pose_deviation){HUGE_VAL, HUGE_VAL};
    struct pose_deviation d = deviation_in_mode(planner, &other, to, motion, s0, s1, allowed);
    if (planner->plan->ability.doubtful && pose_deviation_within(d, allowed)) {
        other.mode = INTERPOLATE_ROTARY;
        d = pose_deviation_worst(d,
                                 deviation_in_mode(planner, &other, to, motion, s0, s1, allowed));
    }
    return d;
}

/* The axis that would have to turn furthest is to blame. */
static int no_way_on(struct nc_planner *planner, struct pose goal, const struct machine_pose *to)
{
    const struct machine *m = planner->machine;
    const double *from = planner->state.at.q;
    int i = m->chain.n > 1 && fabs(to->at.q[1] - from[1]) > fabs(to->at.q[0] - from[0]);
    int axis = m->letter[i];
    planner->plan->unmet = true;
    return error_at(planner->error, planner->path->name, planner->state.line,
                    "pass %zu: axis %c of %s: cannot continue from %.3f at the point %.3f %.3f "
                    "%.3f, expected one within its travel %g to %g and the tolerance "
                    "(meshnorm and planecut plan a path for a machine: -m)",
                    planner->state.pass, machine_letter(axis), m->name, DEGREES(from[i]), goal.p.x,
                    goal.p.y, goal.p.z, m->min[axis], m->max[axis]);
}

/* So far does the axis nearest the work turn in one block at the pole: the linear axes go straight
 * where the tip, this far from it, would be led on an arc. */
static double pole_step(const struct nc_planner *planner)
{
    const struct rotary *r = &planner->machine->chain.rotary[0];
    double far = vec_distance(planner->state.pose.p, r->centre);
    double arc = planner->allowed.point / 2;
    if (planner->follow.mode != INTERPOLATE_JOINT || far <= arc)
        return PI;
    return fmin(sqrt(8 * arc / far), RADIANS(TURN_STEP));
}

/* How far the tool axis is off the singular direction, radians; below 0: too far to be said as it.
 */
static double off_pole(const struct nc_planner *planner)
{
    double off =
        vec_length(vec_cross(planner->machine->chain.rotary[0].axis, planner->state.pose.a));
    bool at =
        chain_free(&planner->machine->chain, planner->state.pose.a) || off < planner->near_pole;
    return at ? off : -1;
}

/*
 * In the singular direction the axis nearest the work turns about the tool itself: to where the
 * motion that follows needs it, at feed, with the tip at rest.  False: the tool is tilted, or the
 * axis stands there already.
 */
static bool turn_at_pole(struct nc_planner *planner, const struct machine_pose *to)
{
    struct nc_state *state = &planner->state;
    const double q[ROTARY_MAX] = {to->at.q[0], state->at.q[1]};
    double step = pole_step(planner), turn = q[0] - state->at.q[0];
    if (planner->machine->chain.n != 2 || planner->follow.mode == INTERPOLATE_VECTOR || turn == 0)
        return false;
    double off = off_pole(planner);
    if (off < 0)
        return false;
    int n = (int)ceil(fabs(turn) / step);
    turn_standing(planner, NC_LINE, q, n);
    struct pose_deviation spent = {planner->allowed.point / 2, 2 * off};
    if (n > 1 || step < PI || off > 0)
        planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, spent);
    return true;
}

/* The same for a motion that is too far off as one block, to where it leaves the pole: an axis that
 * stands askew turns further with the tilt. */
static bool turn_out_of_pole(struct nc_planner *planner, const struct motion *motion, double s0,
                             double s1)
{
    double turn = vec_angle(motion_at(motion, s0).a, motion_at(motion, s1).a);
    struct machine_pose beside;
    if (!(turn > 0))
        return false;
    double s = s0 + (s1 - s0) * fmin(1, BESIDE_POLE / turn);
    return post_ik_reach(planner, motion_at(motion, s), s, &beside) == 0 &&
           turn_at_pole(planner, &beside);
}

/*
 * The rotary axes cannot go on as they stand: the next pose is out of their travel, or it takes a
 * turn that no block in the cut can make.  Off the part they turn where they are.
 */
static int go_on_turned(struct nc_planner *planner, const struct motion *motion, double s0,
                        double s1, enum nc_kind kind, struct machine_pose *to)
{
    struct pose goal = motion_at(motion, s1);
    if (kind == NC_RAPID) {
        if (post_ik_reach(planner, goal, s1, to) != 0)
            return -1;
        post_motion_turn(planner, to->at.q);
        return 0;
    }
    bool turned = planner->rewind && planner->rewind(planner, goal) == 0;
    if (turned && post_ik_reach(planner, goal, s1, to) == 0 &&
        pose_deviation_within(deviation_of(planner, to, motion, s0, s1, planner->allowed),
                              planner->allowed))
        return 0;
    if (planner->plan->unmet)
        return -1;
    return no_way_on(planner, goal, to);
}

static void add_block(struct nc_planner *planner, const struct machine_pose *to, struct pose goal,
                      enum nc_kind kind, struct pose_deviation d)
{
    struct nc_total *total = &planner->plan->total;
    add_straight(planner, kind, to, &goal);
    if (kind == NC_LINE)
        total->spent = pose_deviation_worst(total->spent, d);
}

/* Into how many equal parts to divide what is so far off: a chord's error falls with the square of
 * its length. */
static int parts_for(struct pose_deviation d, struct pose_deviation allowed)
{
    const double spare = 1.02;
    double off = larger(d.point / allowed.point, d.axis / allowed.axis);
    double parts = ceil(spare * sqrt(off));

    return parts >= 2 && parts <= PARTS_MAX ? (int)parts
                                            : 2; /* 2: it may be infinite, or no number */
}

/* The part of a motion at feed from s0 to s1 in n equal blocks.  False: one of them is not within
 * what is allowed, and nothing is done. */
static bool divide_evenly(struct nc_planner *planner, const struct motion *motion, double s0,
                          double s1, int n)
{
    struct nc_plan *plan = planner->plan;
    const struct nc_state state = planner->state;
    const struct nc_total total = plan->total;
    const size_t moves = plan->move.n, vectors = plan->vector.n;
    const bool off_part = planner->off_part, doubtful = planner->doubtful, unmet = plan->unmet;
    double from = s0;

    for (int i = 1; i <= n; i++) {
        double end = i < n ? s0 + (s1 - s0) * i / n : s1;
        struct pose goal = motion_at(motion, end);
        struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
        struct machine_pose to;
        if (post_ik_reach(planner, goal, end, &to) == 0 &&
            post_ik_follow(planner, motion, from, end, &to))
            d = deviation_of(planner, &to, motion, from, end, planner->allowed);
        if (!pose_deviation_within(d, planner->allowed)) {
            planner->state = state;
            plan->total = total;
            plan->move.n = moves;
            plan->vector.n = vectors;
            planner->off_part = off_part;
            planner->doubtful = doubtful;
            plan->unmet = unmet;
            return false;
        }
        add_block(planner, &to, goal, NC_LINE, d);
        from = end;
    }
    return true;
}

/* The same in as few equal blocks as may be, from `least` on to less than twice as many: halves of
 * so many would be more. */
static bool divide_in_few(struct nc_planner *planner, const struct motion *motion, double s0,
                          double s1, int least)
{
    enum { STEPS = 8 };
    int step = least < STEPS ? 1 : least / STEPS;
    bool found = false;

    for (int n = least; n < 2 * least && !found; n += step)
        found = divide_evenly(planner, motion, s0, s1, n);
    return found;
}

static int divide(struct nc_planner *planner, const struct motion *motion, double s0, double s1,
                  enum nc_kind kind, struct pose_deviation allowed, int depth)
{
    struct pose goal = motion_at(motion, s1);
    struct machine_pose to;
    struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
    bool reached = post_ik_reach(planner, goal, s1, &to) == 0;
    if (!reached && !planner->rewind)
        return -1; /* with it: as far as it goes, then turn */
    if (reached && (kind != NC_LINE || post_ik_follow(planner, motion, s0, s1, &to)))
        d = deviation_of(planner, &to, motion, s0, s1, allowed);
    bool first = reached && kind == NC_LINE && depth == 0;
    if (first && !pose_deviation_within(d, allowed) && turn_out_of_pole(planner, motion, s0, s1)) {
        if (post_ik_reach(planner, goal, s1, &to) != 0)
            return -1;
        d = deviation_of(planner, &to, motion, s0, s1, allowed);
    }
    if (!pose_deviation_within(d, allowed) && depth < DEPTH_MAX) {
        int parts = depth == 0 ? parts_for(d, allowed) : 2;
        if (planner->state.why == NC_WHY_PATH)
            planner->state.why = NC_WHY_DIVIDED;
        if (first && divide_in_few(planner, motion, s0, s1, parts))
            return 0;
        for (int i = 0; i < parts; i++) {
            double from = s0 + (s1 - s0) * i / parts,
                   to_s = i + 1 < parts ? s0 + (s1 - s0) * (i + 1) / parts : s1;
            if (divide(planner, motion, from, to_s, kind, allowed, depth + 1) != 0)
                return -1;
        }
        return 0;
    }
    if (!pose_deviation_within(d, allowed)) {
        if (go_on_turned(planner, motion, s0, s1, kind, &to) != 0)
            return -1;
        d = kind == NC_LINE ? deviation_of(planner, &to, motion, s0, s1, allowed) : d;
    }
    add_block(planner, &to, goal, kind, d);
    return 0;
}

/* The first end, between s0 and s1, of a block past the singular direction that was planned. */
static double crossing_end(const struct nc_aim *aim, double s0, double s1)
{
    for (size_t i = 1; i + 1 < aim->n; i++)
        if (!aim->place[i].passed && (aim->place[i - 1].passed || aim->place[i + 1].passed) &&
            aim->s[i] > s0 && aim->s[i] < s1)
            return aim->s[i];
    return s1;
}

static int straight_blocks(struct nc_planner *planner, const struct motion *motion, double s0,
                           double s1, enum nc_kind kind, struct pose_deviation allowed)
{
    for (double s = s0, next; s < s1; s = next) {
        next = crossing_end(&planner->aim, s, s1);
        if (divide(planner, motion, s, next, kind, allowed, 0) != 0)
            return -1;
    }
    return 0;
}

/* ---- arcs, B-splines, rapids */

enum { ARC_DEPTH_MAX = 5, LEAST_CURVE = 10 /* last digits: the poles of less are no curve */ };
static const double rapid_chord = 1; /* mm, where a rapid has to be split at all */

/*
 * Where the tool axis goes by way of, half-way on: between two directions that both lean far, the
 * control turns a vector the shortest way, which leans further than either.  Half as far as the
 * mean of the two, each half of the way leans less than its end.
 */
static struct pose less_leant(const struct nc_planner *planner, struct pose to, const double q[])
{
    const double *from = planner->state.at.q;
    const double via[ROTARY_MAX] = {(from[0] + q[0]) / 2, (from[1] + q[1]) / 4};
    return (struct pose){vec_mix(planner->state.pose.p, to.p, 0.5),
                         chain_axis(&planner->machine->chain, via)};
}

static int rapid_from_here(struct nc_planner *planner, struct pose to)
{
    double chord =
        planner->follow.mode == INTERPOLATE_JOINT ? rapid_chord / planner->options.unit : HUGE_VAL;
    struct pose_deviation any = {chord, HUGE_VAL};
    struct motion motion = motion_line(planner->state.pose, to);
    return straight_blocks(planner, &motion, 0, 1, NC_RAPID, any);
}

int post_motion_rapid(struct nc_planner *planner, struct pose to)
{
    struct machine_pose target;
    if (!planner->state.begun) {
        if (post_ik_reach(planner, to, 1, &target) != 0)
            return -1;
        add_move(planner, NC_RAPID, &target, 0, 0, NULL);
        planner->state.pose = to;
        planner->state.begun = true;
        return 0;
    }
    if (planner->follow.mode == INTERPOLATE_VECTOR &&
        !rotary_reaches_between(&planner->machine->chain, planner->state.pose.a, to.a)) {
        if (post_ik_reach(planner, to, 1, &target) != 0 ||
            rapid_from_here(planner, less_leant(planner, to, target.at.q)) != 0)
            return -1;
    }
    return rapid_from_here(planner, to);
}

static int arc_piece(struct nc_planner *planner, const struct motion *motion, double s0, double s1,
                     int depth)
{
    const struct nc_ability *ability = &planner->plan->ability;
    struct machine_pose to;
    struct nc_arc words;
    struct pose_deviation d;
    double point = 0;
    struct pose goal = motion_at(motion, s1);
    bool fits =
        post_ik_reach(planner, goal, s1, &to) == 0 && post_ik_follow(planner, motion, s0, s1, &to);
    fits = fits &&
           nc_arc_words(&words, ability->arcs, ability->digits.linear, ability->radius_error,
                        &planner->follow, &planner->state.at, &to.at, motion, s0, s1, &d, &point);
    if (fits && !pose_deviation_within(d, planner->allowed) && point <= planner->allowed.point &&
        depth < ARC_DEPTH_MAX) { /* it is the tool axis: it may be right in halves */
        double mid = (s0 + s1) / 2;
        if (arc_piece(planner, motion, s0, mid, depth + 1) != 0)
            return -1;
        return arc_piece(planner, motion, mid, s1, depth + 1);
    }
    if (!fits || !pose_deviation_within(d, planner->allowed)) {
        planner->plan->total.chorded++;
        planner->state.why = NC_WHY_CHORD;
        return straight_blocks(planner, motion, s0, s1, NC_LINE, planner->allowed);
    }
    if (post_ik_check_between(planner, motion, s0, s1) != 0)
        return -1;
    *array_push(&planner->plan->arc) = words;
    /* a small one is not as long as its path, and the feed counts on it as it is read */
    const struct motion printed = nc_arc_motion(&words, &planner->state.at, &to.at);
    const struct nc_along along = {&printed, 0, 1, NULL,
                                   nc_arc_length(&words, &planner->state.at, &to.at)};
    add_move(planner, NC_ARC, &to, (s1 - s0) * motion_length(motion), planner->plan->arc.n - 1,
             &along);
    planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, d);
    planner->state.pose = goal;
    return 0;
}

/* An arc from s0 to s1, in as many pieces as the control wants. */
static int whole_arc(struct nc_planner *planner, const struct motion *motion, double s0, double s1)
{
    double most = nc_arc_most(planner->plan->ability.arcs), share = s1 - s0;
    int n = (int)fmax(1, ceil(share * motion->sweep / most - 1e-9));
    for (int i = 0; i < n; i++)
        if (arc_piece(planner, motion, s0 + share * i / n, s0 + share * (i + 1) / n, 0) != 0)
            return -1;
    return 0;
}

static int one_curve(struct nc_planner *planner, const struct motion *motion)
{
    const struct nc_ability *ability = &planner->plan->ability;
    struct nc_spline_digits digits = {ability->digits.linear, ability->digits.angle,
                                      ability->digits.knot};
    struct nc_spline words;
    struct machine_pose to, checked;
    struct pose_deviation d;
    bool still = motion_length(motion) < LEAST_CURVE / num_ten[digits.linear];
    if (!still && nc_spline_words(&words, ability->splines, digits, &planner->follow,
                                  &planner->state.at, motion, planner->allowed, &to.at, &d)) {
        *array_push(&planner->plan->spline) = words;
        if (planner->follow.mode == INTERPOLATE_VECTOR &&
            post_ik_reach(planner, motion->to, 1, &checked) == 0)
            to.at.q[0] = checked.at.q[0], to.at.q[1] = checked.at.q[1];
        to.turned = chain_turned(&planner->machine->chain, to.at.q);
        if (!post_ik_follow(planner, motion, 0, 1, &to))
            return no_way_on(planner, motion->to, &to);
        if (post_ik_check_linear(planner, &to) != 0 ||
            post_ik_check_between(planner, motion, 0, 1) != 0)
            return -1;
        const struct nc_along along = {motion, 0, 1, &words, 0};
        add_move(planner, NC_SPLINE, &to, motion_length(motion), planner->plan->spline.n - 1,
                 &along);
        planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, d);
        planner->state.pose = motion_at(motion, 1);
        return 0;
    }
    planner->plan->total.chorded += motion->curve->degree > 1;
    planner->state.why = NC_WHY_CHORD;
    for (double s = 0; s < 1;) {
        double next = motion_next_knot(motion, s);
        if (straight_blocks(planner, motion, s, next, NC_LINE, planner->allowed) != 0)
            return -1;
        s = next;
    }
    return 0;
}

static int curve_between(struct nc_planner *planner, const struct motion *motion, double s0,
                         double s1);

/* A spline in as many curves as keep its slow places from slowing all of it. */
static int add_curves(struct nc_planner *planner, const struct motion *motion)
{
    double s =
        planner->plan->ability.splines == NC_SPLINES_NONE ? 1 : post_feed_divide(planner, motion);
    if (s >= 1)
        return one_curve(planner, motion);
    return curve_between(planner, motion, 0, s) != 0 ? -1 : curve_between(planner, motion, s, 1);
}

/* A spline from s0 to s1 as a curve of its own, to which the look-ahead over the whole says
 * nothing.
 */
static int curve_between(struct nc_planner *planner, const struct motion *motion, double s0,
                         double s1)
{
    const struct bspline *b = motion->curve;
    struct nc_aim aim = planner->aim;
    double from = b->knot[b->degree], range = b->knot[b->poles] - from;
    struct bspline part = bspline_part(b, from + s0 * range, from + s1 * range);
    struct motion piece = motion_spline(motion_at(motion, s0), motion_at(motion, s1), &part);
    planner->aim.n = 0;
    int result = add_curves(planner, &piece);
    planner->aim = aim;
    bspline_free(&part);
    return result;
}

static int spline_along(struct nc_planner *planner, const struct motion *motion, double s0,
                        double s1)
{
    struct motion lead = motion_line(planner->state.pose, motion_at(motion, s0));
    struct nc_aim aim = planner->aim;
    planner->aim.n = 0;
    if (straight_blocks(planner, &lead, 0, 1, NC_LINE, planner->allowed) != 0)
        return -1;
    planner->aim = aim;
    return s0 <= 0 && s1 >= 1 ? add_curves(planner, motion)
                              : curve_between(planner, motion, s0, s1);
}

int post_motion_along(struct nc_planner *planner, const struct motion *motion, double s0, double s1)
{
    if (motion->kind == MOTION_SPLINE)
        return spline_along(planner, motion, s0, s1);
    double end = post_ik_pole_between(planner, motion, s0, s1);
    if (end == s1)
        end = post_feed_divide_even(planner, motion, s0, s1);
    if (end < s1)
        return post_motion_along(planner, motion, s0, end) != 0
                   ? -1
                   : post_motion_along(planner, motion, end, s1);
    if (motion->kind == MOTION_ARC && planner->plan->ability.arcs != NC_ARCS_NONE)
        return whole_arc(planner, motion, s0, s1);
    planner->plan->total.chorded += motion->kind == MOTION_ARC;
    if (motion->kind == MOTION_ARC)
        planner->state.why = NC_WHY_CHORD;
    return straight_blocks(planner, motion, s0, s1, NC_LINE, planner->allowed);
}

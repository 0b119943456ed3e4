/* ncstep - see ncstep.h. */
#include "ncstep.h"

#include "nconeblock.h"
#include "ncmove.h"
#include "ncreach.h"
#include "ncturn.h"
#include "num.h"

enum { DEPTH_MAX = 14, ARC_DEPTH_MAX = 5 };
static const double rapid_chord = 1; /* mm, where a rapid has to be split at all */

/* How far the block to a stance is off the motion. */
static struct deviation block_deviation(const struct nc_step *step, const struct follow *f,
                                        const struct stance *to, const struct motion *motion,
                                        double s0, double s1, struct deviation allowed)
{
    const struct nc_state *state = &step->state;
    if (motion->kind == MOTION_LINE) {
        struct stance from = {state->at, state->turned};
        struct pose goal = motion_at(motion, s1);
        struct deviation most = follow_line(f, &from, to, state->pose, goal, allowed);
        if (deviation_within(most, allowed))
            return most;
    }
    return follow_block(f, &state->at, &to->at, motion, s0, s1);
}

/*
 * Vectors leave the rotary axes to the control, which goes on with them as they stand: where they
 * could only follow by way of another solution or whole turns back, the block cannot be.  Beside
 * the singular direction they may turn far while the tool hardly does.
 */
static bool turns_back(const struct nc_step *step, const struct stance *to,
                       const struct motion *motion, double s0, double s1)
{
    const struct station *at = &step->state.at;
    struct follow rotary = step->follow;
    double most = 0;
    for (int i = 0; i < rotary.chain->n; i++)
        most = fmax(most, fabs(to->at.q[i] - at->q[i]));
    if (step->follow.mode != FOLLOW_VECTOR || most < PI / 2)
        return false;
    rotary.mode = FOLLOW_ROTARY;
    double great = vec_angle(motion_at(motion, s0).a, motion_at(motion, s1).a);
    return follow_block(&rotary, at, &to->at, motion, s0, s1).axis > great + RADIANS(1);
}

/* The same for every way in which the control may turn the axis. */
static struct deviation deviation_of(const struct nc_step *step, const struct stance *to,
                                     const struct motion *motion, double s0, double s1,
                                     struct deviation allowed)
{
    struct follow other = step->follow;
    if (allowed.axis < HUGE_VAL && turns_back(step, to, motion, s0, s1))
        return (struct deviation){HUGE_VAL, HUGE_VAL};
    struct deviation d = block_deviation(step, &other, to, motion, s0, s1, allowed);
    if (step->plan->ability.doubtful && deviation_within(d, allowed)) {
        other.mode = FOLLOW_ROTARY;
        d = deviation_worst(d, block_deviation(step, &other, to, motion, s0, s1, allowed));
    }
    return d;
}

/* The axis that would have to turn furthest is to blame. */
static int no_way_on(struct nc_step *step, struct pose goal, const struct stance *to)
{
    const struct machine *m = step->machine;
    const double *from = step->state.at.q;
    int i = m->chain.n > 1 && fabs(to->at.q[1] - from[1]) > fabs(to->at.q[0] - from[0]);
    int axis = m->letter[i];
    step->plan->unmet = true;
    return error_at(step->error, step->path->name, step->state.line,
                    "pass %zu: axis %c of %s: found no way on from %.3f at the point %.3f %.3f "
                    "%.3f, expected one within its travel %g to %g and the tolerance",
                    step->state.pass, machine_letter(axis), m->name, DEGREES(from[i]), goal.p.x,
                    goal.p.y, goal.p.z, m->min[axis], m->max[axis]);
}

/*
 * The rotary axes cannot go on as they stand: the next pose is out of their travel, or it takes a
 * turn that no block in the cut can make.  Off the part they turn where they are.
 */
static int go_on_turned(struct nc_step *step, const struct motion *motion, double s0, double s1,
                        enum nc_kind kind, struct stance *to)
{
    struct pose goal = motion_at(motion, s1);
    if (kind == NC_RAPID) {
        if (nc_reach(step, goal, s1, to) != 0)
            return -1;
        nc_turn_to(step, to->at.q);
        return 0;
    }
    bool turned = step->may_turn && nc_turn_for(step, goal) == 0;
    if (turned && nc_reach(step, goal, s1, to) == 0 &&
        deviation_within(deviation_of(step, to, motion, s0, s1, step->allowed), step->allowed))
        return 0;
    if (step->plan->unmet)
        return -1;
    return no_way_on(step, goal, to);
}

static void take(struct nc_step *step, const struct stance *to, struct pose goal,
                 enum nc_kind kind, struct deviation d)
{
    struct nc_total *total = &step->plan->total;
    nc_add_straight(step, kind, to, &goal);
    if (kind == NC_LINE)
        total->spent = deviation_worst(total->spent, d);
}

/* Straight blocks along the motion from s0, where the program is, to s1. */
static int straight(struct nc_step *step, const struct motion *motion, double s0, double s1,
                    enum nc_kind kind, struct deviation allowed, int depth)
{
    struct pose goal = motion_at(motion, s1);
    struct stance to;
    struct deviation d = {HUGE_VAL, HUGE_VAL};
    bool reached = nc_reach(step, goal, s1, &to) == 0;
    if (!reached && !step->may_turn)
        return -1; /* with it: as far as it goes, then turn */
    if (reached)
        d = deviation_of(step, &to, motion, s0, s1, allowed);
    if (!deviation_within(d, allowed) && depth < DEPTH_MAX) {
        double mid = (s0 + s1) / 2;
        if (step->state.why == NC_WHY_PATH)
            step->state.why = NC_WHY_DIVIDED;
        if (straight(step, motion, s0, mid, kind, allowed, depth + 1) != 0)
            return -1;
        return straight(step, motion, mid, s1, kind, allowed, depth + 1);
    }
    if (!deviation_within(d, allowed)) {
        if (go_on_turned(step, motion, s0, s1, kind, &to) != 0)
            return -1;
        d = kind == NC_LINE ? deviation_of(step, &to, motion, s0, s1, allowed) : d;
    }
    take(step, &to, goal, kind, d);
    return 0;
}

int nc_step_rapid(struct nc_step *step, struct pose to)
{
    double chord = step->follow.mode == FOLLOW_JOINT ? rapid_chord / step->wish.unit : HUGE_VAL;
    struct deviation any = {chord, HUGE_VAL};
    struct stance stance;
    if (step->state.begun) {
        struct motion motion = motion_line(step->state.pose, to);
        return straight(step, &motion, 0, 1, NC_RAPID, any, 0);
    }
    if (nc_reach(step, to, 1, &stance) != 0)
        return -1;
    nc_add_move(step, NC_RAPID, &stance, 0, 0, NULL);
    step->state.pose = to;
    step->state.begun = true;
    return 0;
}

static int arc(struct nc_step *step, const struct motion *motion, double s0, double s1, int depth)
{
    const struct nc_ability *ability = &step->plan->ability;
    struct stance to;
    struct nc_arc words;
    struct deviation d;
    double point = 0;
    struct pose goal = motion_at(motion, s1);
    bool fits = nc_reach(step, goal, s1, &to) == 0;
    fits =
        fits && nc_arc_words(&words, ability->arcs, ability->digits.linear, ability->radius_error,
                             &step->follow, &step->state.at, &to.at, motion, s0, s1, &d, &point);
    if (fits && !deviation_within(d, step->allowed) && point <= step->allowed.point &&
        depth < ARC_DEPTH_MAX) { /* it is the tool axis: it may be right in halves */
        double mid = (s0 + s1) / 2;
        if (arc(step, motion, s0, mid, depth + 1) != 0)
            return -1;
        return arc(step, motion, mid, s1, depth + 1);
    }
    if (!fits || !deviation_within(d, step->allowed)) {
        step->plan->total.chorded++;
        step->state.why = NC_WHY_CHORD;
        return straight(step, motion, s0, s1, NC_LINE, step->allowed, 0);
    }
    *array_push(&step->plan->arc) = words;
    const struct nc_along along = {motion, s0, s1, NULL};
    nc_add_move(step, NC_ARC, &to, (s1 - s0) * motion_length(motion), step->plan->arc.n - 1,
                &along);
    step->plan->total.spent = deviation_worst(step->plan->total.spent, d);
    step->state.pose = goal;
    return 0;
}

/* An arc from s0 to s1, in as many pieces as the control wants. */
static int arcs(struct nc_step *step, const struct motion *motion, double s0, double s1)
{
    double most = nc_arc_most(step->plan->ability.arcs), share = s1 - s0;
    int n = (int)fmax(1, ceil(share * motion->sweep / most - 1e-9));
    for (int i = 0; i < n; i++)
        if (arc(step, motion, s0 + share * i / n, s0 + share * (i + 1) / n, 0) != 0)
            return -1;
    return 0;
}

static int spline(struct nc_step *step, const struct motion *motion)
{
    const struct nc_ability *ability = &step->plan->ability;
    struct nc_spline_digits digits = {ability->digits.linear, ability->digits.angle,
                                      ability->digits.knot};
    struct nc_spline words;
    struct stance to, checked;
    struct deviation d;
    if (nc_spline_words(&words, ability->splines, digits, &step->follow, &step->state.at, motion,
                        step->allowed, &to.at, &d)) {
        *array_push(&step->plan->spline) = words;
        if (step->follow.mode == FOLLOW_VECTOR && nc_reach(step, motion->to, 1, &checked) == 0)
            to.at.q[0] = checked.at.q[0], to.at.q[1] = checked.at.q[1];
        to.turned = chain_turned(&step->machine->chain, to.at.q);
        if (nc_check_linear(step, &to) != 0)
            return -1;
        const struct nc_along along = {motion, 0, 1, &words};
        nc_add_move(step, NC_SPLINE, &to, motion_length(motion), step->plan->spline.n - 1, &along);
        step->plan->total.spent = deviation_worst(step->plan->total.spent, d);
        step->state.pose = motion_at(motion, 1);
        return 0;
    }
    step->plan->total.chorded += motion->curve->degree > 1;
    step->state.why = NC_WHY_CHORD;
    for (double s = 0; s < 1;) {
        double next = motion_next_knot(motion, s);
        if (straight(step, motion, s, next, NC_LINE, step->allowed, 0) != 0)
            return -1;
        s = next;
    }
    return 0;
}

int nc_step_line(struct nc_step *step, struct pose to)
{
    if (step->stops.n == 0 && nc_one_block(step, &to) == 0)
        return 0;
    step->plan->unmet = false;
    struct motion motion = motion_line(step->state.pose, to);
    return nc_step_motion(step, &motion);
}

static int spline_between(struct nc_step *step, const struct motion *motion, double s0, double s1);

/* A spline in as many curves as keep its slow places from slowing all of it. */
static int splines(struct nc_step *step, const struct motion *motion)
{
    double s = step->plan->ability.splines == NC_SPLINES_NONE ? 1 : nc_curve_part(step, motion);
    if (s >= 1)
        return spline(step, motion);
    return spline_between(step, motion, 0, s) != 0 ? -1 : spline_between(step, motion, s, 1);
}

/* A spline from s0 to s1 as a curve of its own, to which the course of the whole says nothing. */
static int spline_between(struct nc_step *step, const struct motion *motion, double s0, double s1)
{
    const struct bspline *b = motion->curve;
    struct nc_course course = step->course;
    double from = b->knot[b->degree], range = b->knot[b->poles] - from;
    struct bspline part = bspline_part(b, from + s0 * range, from + s1 * range);
    struct motion piece = motion_spline(motion_at(motion, s0), motion_at(motion, s1), &part);
    step->course.n = 0;
    int result = splines(step, &piece);
    step->course = course;
    bspline_free(&part);
    return result;
}

static int spline_part(struct nc_step *step, const struct motion *motion, double s0, double s1)
{
    struct motion lead = motion_line(step->state.pose, motion_at(motion, s0));
    struct nc_course course = step->course;
    step->course.n = 0;
    if (straight(step, &lead, 0, 1, NC_LINE, step->allowed, 0) != 0)
        return -1;
    step->course = course;
    return s0 <= 0 && s1 >= 1 ? splines(step, motion) : spline_between(step, motion, s0, s1);
}

static int motion_part(struct nc_step *step, const struct motion *motion, double s0, double s1)
{
    if (motion->kind == MOTION_SPLINE)
        return spline_part(step, motion, s0, s1);
    if (motion->kind == MOTION_ARC && step->plan->ability.arcs != NC_ARCS_NONE)
        return arcs(step, motion, s0, s1);
    step->plan->total.chorded += motion->kind == MOTION_ARC;
    if (motion->kind == MOTION_ARC)
        step->state.why = NC_WHY_CHORD;
    return straight(step, motion, s0, s1, NC_LINE, step->allowed, 0);
}

int nc_step_motion(struct nc_step *step, const struct motion *motion)
{
    size_t stops = step->stops.n;
    double s = 0;
    step->stops.n = 0; /* a turn has motions of its own */
    for (size_t i = 0; i < stops; i++) {
        struct nc_stop stop = step->stops.item[i];
        if (motion_part(step, motion, s, stop.s) != 0 || nc_step_turn(step, stop.q) != 0)
            return -1;
        s = stop.s;
    }
    return motion_part(step, motion, s, 1);
}

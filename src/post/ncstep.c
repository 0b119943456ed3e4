/* ncstep - see ncstep.h. */
#include "post/ncstep.h"

#include "nconeblock.h"
#include "ncmove.h"
#include "post_ik.h"
#include "ncstraight.h"
#include "post_rewind.h"

enum { ARC_DEPTH_MAX = 5 };
static const double rapid_chord = 1; /* mm, where a rapid has to be split at all */

int nc_step_rapid(struct nc_step *step, struct pose to)
{
    double chord =
        step->follow.mode == INTERPOLATE_JOINT ? rapid_chord / step->wish.unit : HUGE_VAL;
    struct pose_deviation any = {chord, HUGE_VAL};
    struct machine_pose stance;
    if (step->state.begun) {
        struct motion motion = motion_line(step->state.pose, to);
        return nc_step_straight(step, &motion, 0, 1, NC_RAPID, any);
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
    struct machine_pose to;
    struct nc_arc words;
    struct pose_deviation d;
    double point = 0;
    struct pose goal = motion_at(motion, s1);
    bool fits = nc_reach(step, goal, s1, &to) == 0;
    fits =
        fits && nc_arc_words(&words, ability->arcs, ability->digits.linear, ability->radius_error,
                             &step->follow, &step->state.at, &to.at, motion, s0, s1, &d, &point);
    if (fits && !pose_deviation_within(d, step->allowed) && point <= step->allowed.point &&
        depth < ARC_DEPTH_MAX) { /* it is the tool axis: it may be right in halves */
        double mid = (s0 + s1) / 2;
        if (arc(step, motion, s0, mid, depth + 1) != 0)
            return -1;
        return arc(step, motion, mid, s1, depth + 1);
    }
    if (!fits || !pose_deviation_within(d, step->allowed)) {
        step->plan->total.chorded++;
        step->state.why = NC_WHY_CHORD;
        return nc_step_straight(step, motion, s0, s1, NC_LINE, step->allowed);
    }
    *array_push(&step->plan->arc) = words;
    const struct nc_along along = {motion, s0, s1, NULL};
    nc_add_move(step, NC_ARC, &to, (s1 - s0) * motion_length(motion), step->plan->arc.n - 1,
                &along);
    step->plan->total.spent = pose_deviation_worst(step->plan->total.spent, d);
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
    struct machine_pose to, checked;
    struct pose_deviation d;
    if (nc_spline_words(&words, ability->splines, digits, &step->follow, &step->state.at, motion,
                        step->allowed, &to.at, &d)) {
        *array_push(&step->plan->spline) = words;
        if (step->follow.mode == INTERPOLATE_VECTOR && nc_reach(step, motion->to, 1, &checked) == 0)
            to.at.q[0] = checked.at.q[0], to.at.q[1] = checked.at.q[1];
        to.turned = chain_turned(&step->machine->chain, to.at.q);
        if (nc_check_linear(step, &to) != 0)
            return -1;
        const struct nc_along along = {motion, 0, 1, &words};
        nc_add_move(step, NC_SPLINE, &to, motion_length(motion), step->plan->spline.n - 1, &along);
        step->plan->total.spent = pose_deviation_worst(step->plan->total.spent, d);
        step->state.pose = motion_at(motion, 1);
        return 0;
    }
    step->plan->total.chorded += motion->curve->degree > 1;
    step->state.why = NC_WHY_CHORD;
    for (double s = 0; s < 1;) {
        double next = motion_next_knot(motion, s);
        if (nc_step_straight(step, motion, s, next, NC_LINE, step->allowed) != 0)
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

/* A spline from s0 to s1 as a curve of its own, to which the look-ahead over the whole says
 * nothing.
 */
static int spline_between(struct nc_step *step, const struct motion *motion, double s0, double s1)
{
    const struct bspline *b = motion->curve;
    struct nc_course nc_motion = step->nc_motion;
    double from = b->knot[b->degree], range = b->knot[b->poles] - from;
    struct bspline part = bspline_part(b, from + s0 * range, from + s1 * range);
    struct motion piece = motion_spline(motion_at(motion, s0), motion_at(motion, s1), &part);
    step->nc_motion.n = 0;
    int result = splines(step, &piece);
    step->nc_motion = nc_motion;
    bspline_free(&part);
    return result;
}

static int spline_part(struct nc_step *step, const struct motion *motion, double s0, double s1)
{
    struct motion lead = motion_line(step->state.pose, motion_at(motion, s0));
    struct nc_course nc_motion = step->nc_motion;
    step->nc_motion.n = 0;
    if (nc_step_straight(step, &lead, 0, 1, NC_LINE, step->allowed) != 0)
        return -1;
    step->nc_motion = nc_motion;
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
    return nc_step_straight(step, motion, s0, s1, NC_LINE, step->allowed);
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

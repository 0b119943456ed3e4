/* post_motion - see post_motion.h. */
#include "post_motion.h"

#include "base/array.h"
#include "base/num.h"
#include "machine/rotary_cost.h"
#include "post_block.h"
#include "post_ik.h"
#include "post_straight.h"
#include "post_way.h"

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
    return post_straight_blocks(planner, &motion, 0, 1, NC_RAPID, any);
}

/*
 * A rapid way along which the tool axis stays, but a rotary axis turns back far about it, as at the
 * end of its travel: the tool sweeps round, and does so where the way is highest.  1: it is none,
 * and nothing is done.
 */
static int rapid_turned(struct nc_planner *planner, const struct pose *to)
{
    const struct nc_state *state = &planner->state;
    const struct kinematic_chain *chain = &planner->machine->chain;
    const double q[ROTARY_MAX] = {state->at.q[0], state->at.q[1]};
    struct machine_pose target;
    if (planner->follow.mode == INTERPOLATE_VECTOR || vec_distance(state->pose.a, to->a) > 0 ||
        post_ik_linear_over(planner, to->p, q) >= 0)
        return 1;
    if (post_ik_reach(planner, *to, 1, &target) != 0)
        return -1;
    if (ik_most_turn(chain, target.at.q, q) < POST_FAR_TURN)
        return 1;
    bool rises = to->p.z > state->pose.p.z;
    struct machine_pose still = rises ? post_ik_pose(planner, *to, q) : target;
    if (!rises)
        post_block_turn(planner, target.at.q);
    post_block_straight(planner, NC_RAPID, &still, to);
    if (rises)
        post_block_turn(planner, target.at.q);
    return 0;
}

/* The first motion of a tool: to where the rotary axes may turn, and on from there. */
static int rapid_from_home(struct nc_planner *planner, struct pose to)
{
    struct machine_pose target, by;
    if (post_ik_reach(planner, to, 1, &target) != 0)
        return -1;
    by = target;
    struct nc_over over = post_way_from_home(planner, &target.at, to.a, &by.at);
    if (over.is)
        return post_way_tell(planner, &over, "on the way from home a position of");
    post_block_add(planner, NC_RAPID, &by, 0, 0, NULL);
    planner->state.begun = true;
    planner->state.pose = (struct pose){by.at.p, to.a};
    post_block_straight(planner, NC_RAPID, &target, &to);
    return 0;
}

int post_motion_rapid(struct nc_planner *planner, struct pose to)
{
    struct machine_pose target;
    if (!planner->state.begun)
        return rapid_from_home(planner, to);
    int turned = rapid_turned(planner, &to);
    if (turned <= 0)
        return turned;
    if (planner->follow.mode == INTERPOLATE_VECTOR &&
        !rotary_reaches_between(&planner->machine->chain, planner->state.pose.a, to.a)) {
        if (post_ik_reach(planner, to, 1, &target) != 0 ||
            rapid_from_here(planner, less_leant(planner, to, target.at.q)) != 0)
            return -1;
    }
    return rapid_from_here(planner, to);
}

int post_motion_leave(struct nc_planner *planner, struct pose to)
{
    planner->leaves = true;
    int result = post_motion_rapid(planner, to);
    planner->leaves = false;
    return result;
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
        return post_straight_blocks(planner, motion, s0, s1, NC_LINE, planner->allowed);
    }
    if (post_ik_check_between(planner, motion, s0, s1) != 0)
        return -1;
    *array_push(&planner->plan->arc) = words;
    /* a small one is not as long as its path, and the feed counts on it as it is read */
    const struct motion printed = nc_arc_motion(&words, &planner->state.at, &to.at);
    const struct nc_along along = {&printed, 0, 1, NULL,
                                   nc_arc_length(&words, &planner->state.at, &to.at)};
    post_block_add(planner, NC_ARC, &to, (s1 - s0) * motion_length(motion),
                   planner->plan->arc.n - 1, &along);
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
            return post_straight_no_way(planner, motion->to, &to);
        if (post_ik_check_linear(planner, &to) != 0 ||
            post_ik_check_between(planner, motion, 0, 1) != 0)
            return -1;
        const struct nc_along along = {motion, 0, 1, &words, 0};
        post_block_add(planner, NC_SPLINE, &to, motion_length(motion), planner->plan->spline.n - 1,
                       &along);
        planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, d);
        planner->state.pose = motion_at(motion, 1);
        return 0;
    }
    planner->plan->total.chorded += motion->curve->degree > 1;
    planner->state.why = NC_WHY_CHORD;
    for (double s = 0; s < 1;) {
        double next = motion_next_knot(motion, s);
        if (post_straight_blocks(planner, motion, s, next, NC_LINE, planner->allowed) != 0)
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
    if (post_straight_blocks(planner, &lead, 0, 1, NC_LINE, planner->allowed) != 0)
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
    return post_straight_blocks(planner, motion, s0, s1, NC_LINE, planner->allowed);
}

/* nconeblock - see nconeblock.h. */
#include "nconeblock.h"

#include "ncmove.h"
#include "post_ik.h"

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/*
 * The block is surely no further off than what blocks before it have spent: so much by the digits
 * at its ends, and so much more between them.  False says nothing.
 */
static bool spends_nothing(const struct nc_step *step, const struct machine_pose *to,
                           const struct pose *goal, struct pose_deviation off)
{
    const struct nc_state *state = &step->state;
    struct pose_deviation spent = step->plan->total.spent, d = state->off, bend = {0, 0};
    if (!(d.point >= 0 && off.point >= 0)) /* not known */
        return false;
    if (step->follow.mode != INTERPOLATE_VECTOR || step->plan->ability.doubtful)
        bend = interpolation_bend(&step->follow, &state->at, &to->at);
    d.axis = bend.axis + larger(d.axis, off.axis);
    d.point = bend.point + larger(d.point, off.point) + fabs(step->follow.ball) * d.axis;
    if (step->follow.mode ==
        INTERPOLATE_JOINT) { /* the tip runs ahead of the axis by so much at most */
        double length = vec_distance(state->pose.p, goal->p);
        d.axis += d.point / length * (1.05 * vec_distance(state->pose.a, goal->a) + bend.axis);
    }
    return pose_deviation_within(d, spent) && pose_deviation_within(d, step->allowed);
}

/* A bound from a closer look, for each way in which the control may turn the axis. */
static struct pose_deviation spends(const struct nc_step *step, const struct machine_pose *to,
                                    const struct pose *goal)
{
    const struct nc_state *state = &step->state;
    const struct machine_pose from = {state->at, state->turned};
    struct interpolation f = step->follow;
    struct pose_deviation d = interpolation_line(&f, &from, to, state->pose, *goal, step->allowed);
    f.mode = INTERPOLATE_ROTARY;
    if (step->plan->ability.doubtful && pose_deviation_within(d, step->allowed))
        d = pose_deviation_worst(
            d, interpolation_line(&f, &from, to, state->pose, *goal, step->allowed));
    return d;
}

/* With vectors the control may be led to turn back: see ncstep.c. */
static bool turns_far(const struct nc_step *step, const struct machine_pose *to)
{
    const double *q = step->state.at.q;
    return step->follow.mode == INTERPOLATE_VECTOR &&
           (fabs(to->at.q[0] - q[0]) >= PI / 2 || fabs(to->at.q[1] - q[1]) >= PI / 2);
}

int nc_one_block(struct nc_step *step, const struct pose *to)
{
    struct machine_pose stance;
    struct pose_deviation off = {NAN, NAN};
    if (nc_reach_beside(step, to, &stance, &off) ? nc_check_linear(step, &stance) != 0
                                                 : nc_reach(step, *to, 1, &stance) != 0)
        return 1;
    if (turns_far(step, &stance))
        return 1;
    if (!spends_nothing(step, &stance, to, off)) {
        struct pose_deviation d = spends(step, &stance, to);
        if (!pose_deviation_within(d, step->allowed))
            return 1;
        step->plan->total.spent = pose_deviation_worst(step->plan->total.spent, d);
    }
    nc_add_straight(step, NC_LINE, &stance, to);
    step->state.off = off;
    return 0;
}

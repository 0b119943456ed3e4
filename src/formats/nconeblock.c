/* nconeblock - see nconeblock.h. */
#include "nconeblock.h"

#include "ncmove.h"
#include "ncreach.h"

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/*
 * The block is surely no further off than what blocks before it have spent: so much by the digits
 * at its ends, and so much more between them.  False says nothing.
 */
static bool spends_nothing(const struct nc_step *step, const struct stance *to,
                           const struct pose *goal, struct deviation off)
{
    const struct nc_state *state = &step->state;
    struct deviation spent = step->plan->total.spent, d = state->off;
    struct deviation bend = follow_bend(&step->follow, &state->at, &to->at);
    if (!(d.point >= 0 && off.point >= 0)) /* not known */
        return false;
    d.axis = bend.axis + larger(d.axis, off.axis);
    d.point = bend.point + larger(d.point, off.point) + fabs(step->follow.ball) * d.axis;
    if (step->follow.mode == FOLLOW_JOINT) { /* the tip runs ahead of the axis by so much at most */
        double length = vec_distance(state->pose.p, goal->p);
        d.axis += d.point / length * (1.05 * vec_distance(state->pose.a, goal->a) + bend.axis);
    }
    return deviation_within(d, spent) && deviation_within(d, step->allowed);
}

int nc_one_block(struct nc_step *step, const struct pose *to)
{
    struct nc_state *state = &step->state;
    struct stance stance;
    struct deviation off = {NAN, NAN};
    if (step->follow.mode == FOLLOW_VECTOR)
        return 1;
    if (nc_reach_beside(step, to, &stance, &off) ? nc_check_linear(step, &stance) != 0
                                                 : nc_reach(step, *to, 1, &stance) != 0)
        return 1;
    if (!spends_nothing(step, &stance, to, off)) {
        const struct stance from = {state->at, state->turned};
        struct deviation d =
            follow_line(&step->follow, &from, &stance, state->pose, *to, step->allowed);
        if (!deviation_within(d, step->allowed))
            return 1;
        step->plan->total.spent = deviation_worst(step->plan->total.spent, d);
    }
    nc_add_straight(step, NC_LINE, &stance, to);
    state->off = off;
    return 0;
}

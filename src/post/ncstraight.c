/* ncstraight - see ncstraight.h. */
#include "ncstraight.h"

#include "ncmove.h"
#include "post_ik.h"
#include "post_rewind.h"

enum { DEPTH_MAX = 14 };

/* How far the block to a stance is off the motion. */
static struct pose_deviation block_deviation(const struct nc_step *step,
                                             const struct interpolation *f,
                                             const struct machine_pose *to,
                                             const struct motion *motion, double s0, double s1,
                                             struct pose_deviation allowed)
{
    const struct nc_state *state = &step->state;
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
static bool turns_back(const struct nc_step *step, const struct machine_pose *to,
                       const struct motion *motion, double s0, double s1)
{
    const struct block_pose *at = &step->state.at;
    struct interpolation rotary = step->follow;
    double most = 0;
    for (int i = 0; i < rotary.chain->n; i++)
        most = fmax(most, fabs(to->at.q[i] - at->q[i]));
    if (step->follow.mode != INTERPOLATE_VECTOR || most < PI / 2)
        return false;
    rotary.mode = INTERPOLATE_ROTARY;
    double great = vec_angle(motion_at(motion, s0).a, motion_at(motion, s1).a);
    return interpolation_block(&rotary, at, &to->at, motion, s0, s1).axis > great + RADIANS(1);
}

/* The same for every way in which the control may turn the axis. */
static struct pose_deviation deviation_of(const struct nc_step *step, const struct machine_pose *to,
                                          const struct motion *motion, double s0, double s1,
                                          struct pose_deviation allowed)
{
    struct interpolation other = step->follow;
    if (allowed.axis < HUGE_VAL && turns_back(step, to, motion, s0, s1))
        return (struct pose_deviation){HUGE_VAL, HUGE_VAL};
    struct pose_deviation d = block_deviation(step, &other, to, motion, s0, s1, allowed);
    if (step->plan->ability.doubtful && pose_deviation_within(d, allowed)) {
        other.mode = INTERPOLATE_ROTARY;
        d = pose_deviation_worst(d, block_deviation(step, &other, to, motion, s0, s1, allowed));
    }
    return d;
}

/* The axis that would have to turn furthest is to blame. */
static int no_way_on(struct nc_step *step, struct pose goal, const struct machine_pose *to)
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
                        enum nc_kind kind, struct machine_pose *to)
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
        pose_deviation_within(deviation_of(step, to, motion, s0, s1, step->allowed), step->allowed))
        return 0;
    if (step->plan->unmet)
        return -1;
    return no_way_on(step, goal, to);
}

static void take(struct nc_step *step, const struct machine_pose *to, struct pose goal,
                 enum nc_kind kind, struct pose_deviation d)
{
    struct nc_total *total = &step->plan->total;
    nc_add_straight(step, kind, to, &goal);
    if (kind == NC_LINE)
        total->spent = pose_deviation_worst(total->spent, d);
}

static int straight(struct nc_step *step, const struct motion *motion, double s0, double s1,
                    enum nc_kind kind, struct pose_deviation allowed, int depth)
{
    struct pose goal = motion_at(motion, s1);
    struct machine_pose to;
    struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
    bool reached = nc_reach(step, goal, s1, &to) == 0;
    if (!reached && !step->may_turn)
        return -1; /* with it: as far as it goes, then turn */
    if (reached)
        d = deviation_of(step, &to, motion, s0, s1, allowed);
    if (!pose_deviation_within(d, allowed) && depth < DEPTH_MAX) {
        double mid = (s0 + s1) / 2;
        if (step->state.why == NC_WHY_PATH)
            step->state.why = NC_WHY_DIVIDED;
        if (straight(step, motion, s0, mid, kind, allowed, depth + 1) != 0)
            return -1;
        return straight(step, motion, mid, s1, kind, allowed, depth + 1);
    }
    if (!pose_deviation_within(d, allowed)) {
        if (go_on_turned(step, motion, s0, s1, kind, &to) != 0)
            return -1;
        d = kind == NC_LINE ? deviation_of(step, &to, motion, s0, s1, allowed) : d;
    }
    take(step, &to, goal, kind, d);
    return 0;
}

int nc_step_straight(struct nc_step *step, const struct motion *motion, double s0, double s1,
                     enum nc_kind kind, struct pose_deviation allowed)
{
    return straight(step, motion, s0, s1, kind, allowed, 0);
}

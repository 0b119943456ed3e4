/* post_rewind - see post_rewind.h. */
#include "post_rewind.h"

#include "ncmove.h"
#include "post_ik.h"

enum { TURN_STEP = 2 /* degrees */ };
static const double return_height = 2; /* mm above the part, down to which the return is a rapid */

static double most_turn(const struct kinematic_chain *chain, const double a[], const double b[])
{
    double most = 0;
    for (int i = 0; i < chain->n; i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

/* Angles for the pose where the program is, in the middle of the travel as far as can be, from
 * which the goal is in reach too. */
static bool turned_angles(const struct nc_step *step, struct pose goal, double q[])
{
    const struct kinematic_chain *chain = &step->machine->chain;
    double middle[ROTARY_MAX] = {0}, next[ROTARY_MAX];
    int over;
    for (int i = 0; i < chain->n; i++) {
        double span = chain->rotary[i].max - chain->rotary[i].min;
        if (span < 8 * PI)
            middle[i] = chain->rotary[i].min + span / 2;
    }
    for (int only = 0; only < 2; only++)
        if (ik_choose(chain, step->state.pose.a, middle, false, only, q, &over) == 0 &&
            ik_choose(chain, goal.a, q, true, -1, next, &over) == 0 &&
            most_turn(chain, q, step->state.at.q) > RADIANS(1) &&
            most_turn(chain, q, next) < RADIANS(90))
            return true;
    return false;
}

void nc_turn_to(struct nc_step *step, const double q[])
{
    double from[ROTARY_MAX] = {step->state.at.q[0], step->state.at.q[1]};
    double far = DEGREES(most_turn(&step->machine->chain, q, from));
    int n = step->follow.mode == INTERPOLATE_JOINT ? (int)ceil(far / TURN_STEP) : 1;
    for (int k = 1; k <= n; k++) {
        double part[ROTARY_MAX];
        for (int i = 0; i < ROTARY_MAX; i++)
            part[i] = from[i] + (q[i] - from[i]) * k / n;
        struct machine_pose to = nc_station(step, step->state.pose, part);
        nc_add_move(step, NC_RAPID, &to, 0, 0, NULL);
    }
}

struct pose nc_pose_off(const struct nc_step *step)
{
    struct pose off = step->state.pose;
    double far = step->machine->retract;
    if (off.a.z > 0.2 && step->clear > off.p.z)
        far = fmax(far, (step->clear - off.p.z) / off.a.z);
    off.p = vec_along(off.p, far, off.a);
    return off;
}

/* Retract, turn, return. */
static int retract_turn_return(struct nc_step *step, const double q[])
{
    struct pose here = step->state.pose, up = nc_pose_off(step), near = here;
    double low = fmin(return_height / step->wish.unit, vec_distance(up.p, here.p));
    near.p = vec_along(here.p, low, here.a);
    enum nc_why why = step->state.why;
    double faster = step->state.faster;
    struct nc_course nc_motion = step->nc_motion;
    step->state.why = NC_WHY_TURN;
    step->state.faster = 1;
    step->nc_motion.n = 0;
    if (nc_step_rapid(step, up) != 0)
        return -1;
    nc_turn_to(step, q);
    struct motion back = motion_line(near, here);
    step->plan->total.turns++;
    int result = nc_step_rapid(step, near) == 0 ? nc_step_motion(step, &back) : -1;
    step->nc_motion = nc_motion;
    step->state.why = why;
    step->state.faster = faster;
    return result;
}

int nc_step_turn(struct nc_step *step, const double q[])
{
    double at[ROTARY_MAX] = {0};
    int over;
    if (ik_choose(&step->machine->chain, step->state.pose.a, q, true, -1, at, &over) != 0)
        return 0;
    return retract_turn_return(step, at);
}

int nc_turn_for(struct nc_step *step, struct pose goal)
{
    double q[ROTARY_MAX] = {0};
    if (step->follow.mode == INTERPOLATE_VECTOR || !turned_angles(step, goal, q))
        return -1;
    return retract_turn_return(step, q);
}

/* post_rewind - see post_rewind.h. */
#include "post_rewind.h"

#include "post_block.h"
#include "post_motion.h"
#include "post_straight.h"
#include "post_ik.h"

static const double return_height = 2; /* mm above the part, down to which the return is a rapid */

/* Angles for the pose where the program is, in the middle of the travel as far as can be, from
 * which the goal is in reach too. */
static bool turned_angles(const struct nc_planner *planner, struct pose goal, double q[])
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double middle[ROTARY_MAX] = {0}, next[ROTARY_MAX];
    int over;
    for (int i = 0; i < chain->n; i++) {
        double span = chain->rotary[i].max - chain->rotary[i].min;
        if (span < 8 * PI)
            middle[i] = chain->rotary[i].min + span / 2;
    }
    for (int only = 0; only < 2; only++)
        if (ik_choose(chain, planner->state.pose.a, middle, false, only, q, &over) == 0 &&
            ik_choose(chain, goal.a, q, true, -1, next, &over) == 0 &&
            ik_most_turn(chain, q, planner->state.at.q) > RADIANS(1) &&
            ik_most_turn(chain, q, next) < RADIANS(90))
            return true;
    return false;
}

/* Most points of a path are. */
static inline bool is_within(const struct box *box, struct vec3 p)
{
    return p.x >= box->low.x && p.x <= box->high.x && p.y >= box->low.y && p.y <= box->high.y &&
           p.z >= box->low.z && p.z <= box->high.z;
}

struct nc_extent post_rewind_extent(const struct path *path)
{
    struct nc_extent extent = {.cut = box_empty(), .rapid = NAN};
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (path_is_rapid(item))
            extent.rapid = fmax(extent.rapid, item->to.p.z);
        else if (path_moves(item) && !is_within(&extent.cut, item->to.p))
            box_add(&extent.cut, item->to.p);
        extent.planes = extent.planes || item->kind == PATH_PLANE;
    }
    return extent;
}

/* How far along a tool axis that leads down the tool is beside all that is cut, by `gap`. */
static double beside(const struct box *cut, struct pose from, double gap)
{
    const double p[2] = {from.p.x, from.p.y}, a[2] = {from.a.x, from.a.y};
    const double low[2] = {cut->low.x, cut->low.y}, high[2] = {cut->high.x, cut->high.y};
    double far = HUGE_VAL;
    for (int i = 0; i < 2; i++)
        if (fabs(a[i]) > 1e-3)
            far = fmin(far, ((a[i] > 0 ? high[i] + gap : low[i] - gap) - p[i]) / a[i]);
    return far;
}

struct pose post_rewind_retracted(const struct nc_planner *planner)
{
    struct pose off = planner->state.pose;
    double far = planner->machine->retract;
    if (off.a.z > 0.2 && planner->clearance > off.p.z)
        far = fmax(far, (planner->clearance - off.p.z) / off.a.z);
    if (off.a.z < 0 && machine_has_head(planner->machine)) /* home is straight up from there */
        far = fmax(far, beside(&planner->cut, off, planner->machine->retract));
    off.p = vec_along(off.p, far, off.a);
    return off;
}

struct pose post_rewind_above(const struct nc_planner *planner, struct pose pose)
{
    double rise = planner->plan->top - pose.p.z;
    if (!(rise > 1e-6))
        return pose;
    bool leads_up = pose.a.z > 0.2;
    struct vec3 way = leads_up ? pose.a : vec(0, 0, 1);
    pose.p = vec_along(pose.p, leads_up ? rise / pose.a.z : rise, way);
    return pose;
}

/* Retract, turn, return: by a way that takes no such turn itself, or there is none. */
static int retract_turn_return(struct nc_planner *planner, const double q[])
{
    struct pose here = planner->state.pose, up = post_rewind_retracted(planner), near = here;
    double low = fmin(return_height / planner->options.unit, vec_distance(up.p, here.p));
    near.p = vec_along(here.p, low, here.a);
    enum nc_why why = planner->state.why;
    double faster = planner->state.faster;
    struct nc_aim aim = planner->aim;
    planner->state.why = NC_WHY_TURN;
    planner->state.faster = 1;
    planner->aim.n = 0;
    if (post_motion_leave(planner, up) != 0)
        return -1;
    post_block_turn(planner, q);
    struct motion back = motion_line(near, here);
    planner->plan->total.turns++;
    int (*rewind)(struct nc_planner *, struct pose) = planner->rewind;
    planner->rewind = NULL;
    int result = post_motion_rapid(planner, near) == 0 ? post_rewind_motion(planner, &back) : -1;
    planner->rewind = rewind;
    planner->aim = aim;
    planner->state.why = why;
    planner->state.faster = faster;
    return result;
}

int post_rewind_to(struct nc_planner *planner, const double q[])
{
    double at[ROTARY_MAX] = {0};
    int over;
    if (ik_choose(&planner->machine->chain, planner->state.pose.a, q, true, -1, at, &over) != 0)
        return 0;
    return retract_turn_return(planner, at);
}

int post_rewind_for(struct nc_planner *planner, struct pose goal)
{
    double q[ROTARY_MAX] = {0};
    if (planner->follow.mode == INTERPOLATE_VECTOR || !turned_angles(planner, goal, q))
        return -1;
    return retract_turn_return(planner, q);
}

int post_rewind_line(struct nc_planner *planner, struct pose to)
{
    if (planner->rewinds.n == 0 && post_straight_one(planner, &to) == 0)
        return 0;
    planner->plan->unmet = false;
    struct motion motion = motion_line(planner->state.pose, to);
    return post_rewind_motion(planner, &motion);
}

int post_rewind_motion(struct nc_planner *planner, const struct motion *motion)
{
    size_t stops = planner->rewinds.n;
    double s = 0;
    planner->rewinds.n = 0; /* a turn has motions of its own */
    for (size_t i = 0; i < stops; i++) {
        struct nc_rewind stop = planner->rewinds.item[i];
        if (post_motion_along(planner, motion, s, stop.s) != 0 ||
            post_rewind_to(planner, stop.q) != 0)
            return -1;
        s = stop.s;
    }
    return post_motion_along(planner, motion, s, 1);
}

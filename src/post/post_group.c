/* post_group - see post_group.h. */
#include "post_group.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/num.h"
#include "post_block.h"
#include "post_ik.h"
#include "post_item.h"
#include "post_lookahead.h"
#include "post_motion.h"
#include "post_rewind.h"
#include "post_travel.h"
#include "post_way.h"

/* ---- a group: planned with each block the nearest way, or along what the look ahead found */

/* What a group that is planned again has to take back. */
struct checkpoint {
    struct nc_state state;
    struct nc_total total;
    struct nc_group_start since;
    size_t vectors, arcs, splines, holes;
};

static struct checkpoint checkpoint_of(const struct nc_planner *planner)
{
    const struct nc_plan *plan = planner->plan;
    const double *q = planner->state.at.q;
    return (struct checkpoint){planner->state, plan->total, {plan->move.n, {q[0], q[1]}},
                               plan->vector.n, plan->arc.n, plan->spline.n,
                               plan->hole.n};
}

static void restore_checkpoint(struct nc_planner *planner, const struct checkpoint *checkpoint)
{
    struct nc_plan *plan = planner->plan;
    for (size_t i = checkpoint->splines; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    planner->state = checkpoint->state;
    plan->total = checkpoint->total;
    plan->unmet = false;
    plan->move.n = checkpoint->since.moves;
    plan->vector.n = checkpoint->vectors;
    plan->arc.n = checkpoint->arcs;
    plan->spline.n = checkpoint->splines;
    plan->hole.n = checkpoint->holes;
    post_item_length(planner); /* it was known before */
}

static bool goes_home(const struct path_item *item)
{
    return item->kind == PATH_TOOL || item->kind == PATH_PLANE;
}

/* The item is the first of another group, where this one is, or not, in the part already. */
static inline bool begins_group(const struct path_item *item, bool cutting)
{
    return (path_is_rapid(item) && cutting) || goes_home(item);
}

/* The end of the group that starts at the item `from`. */
static size_t end_of_group(const struct path *path, size_t from)
{
    bool cutting = false;
    for (size_t i = from; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (i > from && begins_group(item, cutting))
            return i;
        cutting = cutting || (path_moves(item) && !path_is_rapid(item));
    }
    return path->item.n;
}

/* The tool is in the part: the last motion was a cut. */
static bool in_cut(const struct nc_planner *planner)
{
    size_t last = planner->plan->move.n;
    while (last && !nc_moves(&planner->plan->move.item[last - 1]))
        last--;
    const struct nc_move *move = last ? &planner->plan->move.item[last - 1] : NULL;
    return planner->state.begun && move && move->kind != NC_RAPID && move->kind != NC_HOLE;
}

/* The turns strictly inside of the motion between two places. */
static void add_rewinds(struct nc_planner *planner, const struct lookahead *ahead, size_t from,
                        size_t to)
{
    planner->rewinds.n = 0;
    for (size_t i = from + 1; i < to; i++) {
        const double *q = ahead->item[i + 1].q;
        if (ahead->item[i].turn)
            *array_push(&planner->rewinds) = (struct nc_rewind){ahead->s.item[i], {q[0], q[1]}};
    }
}

/* The part of what was found that is the item's; where the tool turns before it, it does. */
static int set_aim(struct nc_planner *planner, const struct lookahead *ahead, size_t from, size_t i)
{
    size_t place = ahead->start.item[i - from], end = ahead->start.item[i - from + 1];
    planner->aim.n = 0;
    if (!path_moves(&planner->path->item.item[i]))
        return 0;
    if (end > place && ahead->item[place].turn &&
        post_rewind_to(planner, ahead->item[place + 1].q) != 0)
        return -1;
    planner->aim = (struct nc_aim){end - place + 1, ahead->item + place, ahead->s.item + place};
    add_rewinds(planner, ahead, place, end);
    return 0;
}

/* The rapid that leads out of the part keeps the angles, or follows on from them; where it cannot,
 * the tool goes off the part first. */
static int leave_part(struct nc_planner *planner, const struct path_item *item)
{
    struct machine_pose to;
    planner->off_part = false;
    planner->leaves = true;
    planner->aim.n = 0;
    int result = post_ik_reach(planner, item->to, 1, &to);
    if (result == 0 && ik_travel(&planner->machine->chain, planner->state.at.q, to.at.q) >
                           2 * vec_angle(planner->state.pose.a, item->to.a) + POST_FAR_TURN) {
        planner->state.why = NC_WHY_RETRACT;
        result = post_motion_leave(planner, post_rewind_retracted(planner));
    }
    result = result == 0 ? post_item(planner, item) : -1;
    planner->leaves = false;
    planner->off_part = true;
    return result;
}

/*
 * Without tool-centre-point control a rapid is many blocks: where it leads to another solution, the
 * axes turn before it, where the tool stands off the part; or after it, where it leads up and the
 * tool axis stays (post_motion_rapid).
 */
static void turn_before_rapid(struct nc_planner *planner, const struct path_item *item)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    struct machine_pose to;
    bool doubt = planner->doubtful;
    int over;
    bool rises = vec_distance(planner->state.pose.a, item->to.a) == 0 &&
                 item->to.p.z > planner->state.pose.p.z;
    if (planner->follow.mode == INTERPOLATE_JOINT && planner->off_part && planner->state.begun &&
        !rises && post_ik_reach(planner, item->to, 1, &to) == 0 &&
        ik_choose(chain, planner->state.pose.a, to.at.q, true, -1, q, &over) == 0 &&
        ik_travel(chain, q, planner->state.at.q) > POST_FAR_TURN)
        post_block_turn(planner, q);
    planner->off_part = true;
    planner->doubtful = doubt;
}

/* The rapids have led to the part: there the axes turn to where the way that was found begins. */
static void turn_at_part(struct nc_planner *planner, const struct lookahead *ahead)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {0};
    int over;
    if (planner->off_part && ahead && planner->state.begun &&
        ik_choose(chain, planner->state.pose.a, ahead->item[0].q, true, -1, q, &over) == 0 &&
        ik_travel(chain, q, planner->state.at.q) > RADIANS(0.01))
        post_block_turn(planner, q);
    planner->off_part = planner->off_part && !planner->state.begun;
}

/* The tool is above all that is cut. */
static bool is_at_top(const struct nc_planner *planner)
{
    return planner->state.begun && planner->state.pose.p.z > planner->plan->top - 1e-6;
}

/* -1: a linear axis has left its travel on the way of a block. */
static int check_way(struct nc_planner *planner)
{
    const struct nc_over *over = &planner->state.over;
    return over->is ? post_way_tell(planner, over, "on the way a position of") : 0;
}

/* Up to *to at most, which becomes where the group ends.  ahead: what was found by looking ahead
 * over the group, NULL: nothing. */
static int plan_items(struct nc_planner *planner, const struct lookahead *ahead, size_t from,
                      size_t *to)
{
    bool leading = true, leaving = in_cut(planner);
    planner->off_part = true;
    planner->doubtful = false;
    planner->next_tilted = from;
    planner->aim.n = planner->rewinds.n = 0;
    for (size_t i = from; i < *to; i++) {
        const struct path_item *item = &planner->path->item.item[i];
        if (i > from && begins_group(item, !leading)) {
            *to = i;
            break;
        }
        planner->next = i + 1;
        if (leading && path_moves(item) && !path_is_rapid(item)) {
            turn_at_part(planner, ahead);
            leading = false;
        }
        if (ahead && set_aim(planner, ahead, from, i) != 0)
            return -1;
        bool leaves = leaving && path_is_rapid(item);
        if (leading && path_is_rapid(item) && !leaves)
            turn_before_rapid(planner, item);
        if ((leaves ? leave_part(planner, item) : post_item(planner, item)) != 0)
            return -1;
        if (leading && path_is_rapid(item) && !leaves && is_at_top(planner))
            turn_at_part(planner, ahead);
        leaving = leaving && !path_moves(item);
    }
    return check_way(planner);
}

/* Once more along the way that was found: 0 when it is planned and no worse. */
static int plan_along(struct nc_planner *planner, const struct lookahead *ahead, size_t from,
                      size_t to, const struct checkpoint *checkpoint, double way)
{
    restore_checkpoint(planner, checkpoint);
    planner->rewind = post_rewind_for;
    if (plan_items(planner, ahead, from, &to) != 0)
        return -1;
    bool more = planner->plan->total.turns > checkpoint->total.turns && way < HUGE_VAL;
    return more || post_travel_since(planner, &checkpoint->since) > way ? -1 : 0;
}

/* Where the group starts, whatever of it is planned by now. */
static bool look_ahead(struct nc_planner *planner, struct lookahead *ahead,
                       const struct checkpoint *checkpoint, size_t from, size_t to)
{
    struct nc_state now = planner->state;
    planner->state = checkpoint->state;
    bool found = post_lookahead_over(ahead, planner, from, to);
    planner->state = now;
    return found;
}

/* Plans the group of items from `from` on; *end: where it ends.  -1: the error is filled. */
static int plan_group(struct nc_planner *planner, size_t from, size_t *end)
{
    struct checkpoint checkpoint = checkpoint_of(planner);
    struct lookahead ahead;
    planner->rewind = NULL;
    *end = planner->path->item.n;
    int nearest = plan_items(planner, NULL, from, end);
    size_t to = nearest == 0 ? *end : (*end = end_of_group(planner->path, from));
    if (nearest == 0 ? post_travel_is_least(planner, &checkpoint.since, from, to)
                     : !planner->plan->unmet)
        return nearest;
    double way = nearest == 0 ? post_travel_since(planner, &checkpoint.since) : HUGE_VAL;
    bool found = look_ahead(planner, &ahead, &checkpoint, from, to);
    bool better = found && (nearest != 0 ||
                            (ahead.cost.turns == 0 && post_travel_saves(ahead.cost.travel, way)));
    int result = better ? plan_along(planner, &ahead, from, to, &checkpoint, way) : -1;
    post_lookahead_free(&ahead);
    planner->aim.n = planner->rewinds.n = 0;
    if (result == 0 || (nearest == 0 && !better))
        return 0;
    restore_checkpoint(planner, &checkpoint);
    planner->rewind = nearest != 0 ? post_rewind_for : NULL;
    return plan_items(planner, NULL, from, &to);
}

/* ---- a whole path */

/* The height of the first rapid of a program: the clearance plane or the highest rapid, but above
 * all that is cut, and above that by the machine's `retract` where the path has no rapid. */
static double top_of(const struct nc_planner *planner, bool planes)
{
    double cut = planner->cut.high.z, clear = planner->clearance;
    if (planes) /* heights of several frames */
        return NAN;
    return isnan(clear) ? cut + planner->machine->retract : fmax(clear, cut);
}

/* The travel to the last digit within it, and what is rounded to that or beyond it by so little
 * that it is taken for it (post_ik.c): no angle is beyond it once it is printed, not even by the
 * rounding that ik_branch.c allows, and none is refused for what the digits of most controls do not
 * show. */
static void trim_travel(struct kinematic_chain *chain, int digits)
{
    const double slack = 1e-9, half = fmax(0.5, POST_IK_AT_END * num_ten[digits]) - 1e-3;
    for (int i = 0; i < chain->n; i++) {
        struct rotary *r = &chain->rotary[i];
        double min = DEGREES(r->min) * num_ten[digits], max = DEGREES(r->max) * num_ten[digits];
        if (fabs(min) < 1e12 && fabs(max) < 1e12 && ceil(min - slack) <= floor(max + slack)) {
            r->min = RADIANS((ceil(min - slack) - half) / num_ten[digits]);
            r->max = RADIANS((floor(max + slack) + half) / num_ten[digits]);
        }
    }
}

/* Memory for so many blocks at once: no array of millions is moved while it grows. */
static void reserve_blocks(struct nc_plan *plan, size_t n)
{
    array_reserve(&plan->move, n);
    if (plan->ability.mode == INTERPOLATE_VECTOR)
        array_reserve(&plan->vector, n);
}

int nc_plan_make(struct nc_plan *plan, const struct path *path, const struct machine *machine,
                 struct nc_ability ability, struct nc_plan_options options, struct error *error)
{
    *plan = (struct nc_plan){.ability = ability};
    struct nc_planner planner = {
        .path = path, .machine = machine, .plan = plan, .options = options, .error = error};
    if (path->head.track == TRACK_CONTACT)
        return error_set(error,
                         "%s: found a path of contact points (TRACK/CONTACT), expected one of tool "
                         "tips or ball centres",
                         path->name);
    struct machine own = *machine;
    trim_travel(&own.chain, ability.digits.angle);
    chain_measure(&own.chain);
    planner.machine = planner.own = &own;
    planner.base = machine;
    planner.follow = (struct interpolation){.mode = ability.mode, .chain = &own.chain};
    struct nc_extent extent = post_rewind_extent(path);
    planner.cut = extent.cut;
    planner.clearance = isnan(path->head.clearance) ? extent.rapid : path->head.clearance;
    plan->top = top_of(&planner, extent.planes);
    reserve_blocks(plan, path->item.n + path->item.n / 16); /* most are blocks as they are */
    planner.near = ik_near_table(&own.chain);
    planner.safe_radius = post_ik_safe_radius(machine);
    planner.state.faster = 1;
    planner.state.off = (struct pose_deviation){NAN, NAN};
    chain_zero(&own.chain, planner.state.at.q);
    planner.state.turned = chain_turned(&machine->chain, planner.state.at.q);
    post_item_tool(&planner, path_ball(path));
    planner.state.tool = path->head.tool;
    int result = post_item_length(&planner);
    for (size_t from = 0; from < path->item.n && result == 0;) {
        size_t to;
        result = plan_group(&planner, from, &to);
        from = to;
    }
    array_free(&planner.rewinds);
    if (result == 0 && !planner.state.begun)
        return error_set(error, "%s: found no motion, expected at least one GOTO", path->name);
    return result == 0 && post_item_retract(&planner) == 0 ? check_way(&planner) : -1;
}

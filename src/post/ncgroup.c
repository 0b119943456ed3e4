/* ncgroup - see ncgroup.h. */
#include "ncgroup.h"

#include "ncahead.h"
#include "ncitem.h"
#include "post_ik.h"
#include "post_rewind.h"
#include "ncway.h"

static const double far_turn = PI / 6; /* radians: to another solution, or whole turns */

/* What a group that is planned again has to take back. */
struct mark {
    struct nc_state state;
    struct nc_total total;
    struct nc_since since;
    size_t vectors, arcs, splines, holes;
};

static struct mark mark_of(const struct nc_step *step)
{
    const struct nc_plan *plan = step->plan;
    const double *q = step->state.at.q;
    return (struct mark){step->state,    plan->total, {plan->move.n, {q[0], q[1]}},
                         plan->vector.n, plan->arc.n, plan->spline.n,
                         plan->hole.n};
}

static void back_to(struct nc_step *step, const struct mark *mark)
{
    struct nc_plan *plan = step->plan;
    for (size_t i = mark->splines; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    step->state = mark->state;
    plan->total = mark->total;
    plan->unmet = false;
    plan->move.n = mark->since.moves;
    plan->vector.n = mark->vectors;
    plan->arc.n = mark->arcs;
    plan->spline.n = mark->splines;
    plan->hole.n = mark->holes;
}

static bool begins_anew(const struct path_item *item)
{
    return item->kind == PATH_TOOL || item->kind == PATH_PLANE;
}

size_t nc_group_end(const struct path *path, size_t from)
{
    bool cutting = false;
    for (size_t i = from; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if ((path_is_rapid(item) && cutting) || (begins_anew(item) && i > from))
            return i;
        cutting = cutting || (path_moves(item) && !path_is_rapid(item));
    }
    return path->item.n;
}

/* The tool is in the part: the last motion was a cut. */
static bool in_cut(const struct nc_step *step)
{
    size_t last = step->plan->move.n;
    while (last && !nc_moves(&step->plan->move.item[last - 1]))
        last--;
    const struct nc_move *move = last ? &step->plan->move.item[last - 1] : NULL;
    return step->state.begun && move && move->kind != NC_RAPID && move->kind != NC_HOLE;
}

/* The turns strictly inside of the motion between two places. */
static void add_stops(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t to)
{
    step->stops.n = 0;
    for (size_t i = from + 1; i < to; i++) {
        const double *q = ahead->item[i + 1].q;
        if (ahead->item[i].turn)
            *array_push(&step->stops) = (struct nc_stop){ahead->s.item[i], {q[0], q[1]}};
    }
}

/* The part of what was found that is the item's; where the tool turns before it, it does. */
static int set_course(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t i)
{
    size_t place = ahead->start.item[i - from], end = ahead->start.item[i - from + 1];
    step->nc_motion.n = 0;
    if (!path_moves(&step->path->item.item[i]))
        return 0;
    if (end > place && ahead->item[place].turn && nc_step_turn(step, ahead->item[place + 1].q) != 0)
        return -1;
    step->nc_motion =
        (struct nc_course){end - place + 1, ahead->item + place, ahead->s.item + place};
    add_stops(step, ahead, place, end);
    return 0;
}

/* The rapid that leads out of the part keeps the angles, or follows on from them; where it cannot,
 * the tool goes off the part first. */
static int leave(struct nc_step *step, const struct path_item *item)
{
    struct machine_pose to;
    int result = 0;
    step->first = false;
    step->nc_motion.n = 0;
    if (nc_reach(step, item->to, 1, &to) != 0)
        return -1;
    double turn = ik_travel(&step->machine->chain, step->state.at.q, to.at.q);
    if (turn > 2 * vec_angle(step->state.pose.a, item->to.a) + far_turn) {
        step->state.why = NC_WHY_RETRACT;
        result = nc_step_rapid(step, nc_pose_off(step));
    }
    result = result == 0 ? nc_item(step, item) : -1;
    step->first = true;
    return result;
}

/*
 * Without tool-centre-point control a rapid is many blocks: where it leads to another solution, the
 * axes turn before it, where the tool stands off the part.
 */
static void turn_before(struct nc_step *step, const struct path_item *item)
{
    const struct kinematic_chain *chain = &step->machine->chain;
    double q[ROTARY_MAX] = {step->state.at.q[0], step->state.at.q[1]};
    struct machine_pose to;
    bool doubt = step->doubt;
    int over;
    if (step->follow.mode == INTERPOLATE_JOINT && step->first && step->state.begun &&
        nc_reach(step, item->to, 1, &to) == 0 &&
        ik_choose(chain, step->state.pose.a, to.at.q, true, -1, q, &over) == 0 &&
        ik_travel(chain, q, step->state.at.q) > far_turn)
        nc_turn_to(step, q);
    step->first = true;
    step->doubt = doubt;
}

/* The rapids have led to the part: there the axes turn to where the way that was found begins. */
static void arrive(struct nc_step *step, const struct nc_ahead *ahead)
{
    const struct kinematic_chain *chain = &step->machine->chain;
    double q[ROTARY_MAX] = {0};
    int over;
    if (step->first && ahead && step->state.begun &&
        ik_choose(chain, step->state.pose.a, ahead->item[0].q, true, -1, q, &over) == 0 &&
        ik_travel(chain, q, step->state.at.q) > RADIANS(0.01))
        nc_turn_to(step, q);
    step->first = step->first && !step->state.begun;
}

/* ahead: what was found by looking ahead over the group, NULL: nothing. */
static int plan_items(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t to)
{
    bool leading = true, leaving = in_cut(step);
    step->first = true;
    step->doubt = false;
    step->tilted = from;
    step->nc_motion.n = step->stops.n = 0;
    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &step->path->item.item[i];
        step->next = i + 1;
        if (leading && path_moves(item) && !path_is_rapid(item)) {
            arrive(step, ahead);
            leading = false;
        }
        if (ahead && set_course(step, ahead, from, i) != 0)
            return -1;
        bool leaves = leaving && path_is_rapid(item);
        if (leading && path_is_rapid(item) && !leaves)
            turn_before(step, item);
        if ((leaves ? leave(step, item) : nc_item(step, item)) != 0)
            return -1;
        leaving = leaving && !path_moves(item);
    }
    return 0;
}

/* Once more along the way that was found: 0 when it is planned and no worse. */
static int plan_along(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t to,
                      const struct mark *mark, double way)
{
    back_to(step, mark);
    step->may_turn = true;
    if (plan_items(step, ahead, from, to) != 0)
        return -1;
    bool more = step->plan->total.turns > mark->total.turns && way < HUGE_VAL;
    return more || nc_way_since(step, &mark->since) > way ? -1 : 0;
}

/* Where the group starts, whatever of it is planned by now. */
static bool look_ahead(struct nc_step *step, struct nc_ahead *ahead, const struct mark *mark,
                       size_t from, size_t to)
{
    struct nc_state now = step->state;
    step->state = mark->state;
    bool found = nc_ahead_make(ahead, step, from, to);
    step->state = now;
    return found;
}

int nc_group_plan(struct nc_step *step, size_t from, size_t to)
{
    struct mark mark = mark_of(step);
    struct nc_ahead ahead;
    step->may_turn = false;
    int nearest = plan_items(step, NULL, from, to);
    if (nearest == 0 ? nc_way_surely_shortest(step, &mark.since, from, to) : !step->plan->unmet)
        return nearest;
    double way = nearest == 0 ? nc_way_since(step, &mark.since) : HUGE_VAL;
    bool found = look_ahead(step, &ahead, &mark, from, to);
    bool better =
        found && (nearest != 0 || (ahead.cost.turns == 0 && nc_way_saves(ahead.cost.way, way)));
    int result = better ? plan_along(step, &ahead, from, to, &mark, way) : -1;
    nc_ahead_free(&ahead);
    step->nc_motion.n = step->stops.n = 0;
    if (result == 0 || (nearest == 0 && !better))
        return 0;
    back_to(step, &mark);
    step->may_turn = nearest != 0;
    return plan_items(step, NULL, from, to);
}

/*
 * ncplan - see ncplan.h.
 *
 * A path is planned in groups: from a rapid, where the tool is off the part and the rotary axes
 * may go to either solution, up to the next rapid.  A group that runs out of a rotary axis's
 * travel with one solution is planned again with the other; when neither serves, a look ahead over
 * the whole group finds with which to start and where the tool retracts, turns and returns.
 */
#include "ncplan.h"

#include <stdlib.h>

#include "ncahead.h"
#include "nchole.h"
#include "ncturn.h"

/* Of a tolerance: the worst place of a block may lie between those that are looked at. */
static const double sampled = 0.9;

/* What a group that is planned again has to take back. */
struct mark {
    struct nc_state state;
    struct nc_total total;
    size_t moves, vectors, arcs, splines, holes;
};

static struct mark mark_of(const struct nc_step *step)
{
    const struct nc_plan *plan = step->plan;
    return (struct mark){step->state, plan->total,    plan->move.n, plan->vector.n,
                         plan->arc.n, plan->spline.n, plan->hole.n};
}

static void back_to(struct nc_step *step, const struct mark *mark)
{
    struct nc_plan *plan = step->plan;
    for (size_t i = mark->splines; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    step->state = mark->state;
    plan->total = mark->total;
    plan->unmet = false;
    plan->move.n = mark->moves;
    plan->vector.n = mark->vectors;
    plan->arc.n = mark->arcs;
    plan->spline.n = mark->splines;
    plan->hole.n = mark->holes;
}

void nc_plan_free(struct nc_plan *plan)
{
    for (size_t i = 0; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    array_free(&plan->move);
    array_free(&plan->vector);
    array_free(&plan->arc);
    array_free(&plan->spline);
    array_free(&plan->hole);
}

struct station nc_plan_station(const struct nc_plan *plan, const struct chain *chain,
                               const struct nc_move *move)
{
    struct station at = {.p = move->p, .q = {move->q[0], move->q[1]}};
    at.a = plan->ability.mode == FOLLOW_VECTOR ? plan->vector.item[move->vector]
                                               : chain_axis(chain, move->q);
    return at;
}

static bool is_motion(const struct path_item *item)
{
    return item->kind <= PATH_HOLE;
}

/* A note among the blocks: a pass, or a statement that the dialect may know. */
static void add_note(struct nc_step *step, enum nc_kind kind, const struct path_item *item)
{
    struct nc_move *move = array_push(&step->plan->move);
    *move = (struct nc_move){
        .kind = kind, .line = item->line, .index = item->index};
}

/* A path that starts with a cut: above its first point first, along the tool axis. */
static int approach(struct nc_step *step, struct pose first)
{
    struct pose above = first;
    above.p = vec_along(first.p, step->machine->retract, first.a);
    step->plan->total.approach_made = true;
    step->state.why = NC_WHY_APPROACH;
    return nc_step_rapid(step, above);
}

/*
 * How much faster than its feed the tracked point must go for the contact point to keep it: the
 * ratio of their ways, from a tenth to ten.
 */
static double contact_factor(const struct nc_step *step, const struct path_item *item)
{
    if (!step->wish.contact_feed || !item->touches || !step->state.touches)
        return 1;
    double tip = vec_distance(step->state.pose.p, item->to.p);
    struct contact at = step->path->contact.item[item->contact];
    double contact = vec_distance(step->state.contact.p, at.p);
    return tip > 0 && contact > 0 ? fmin(10, fmax(0.1, tip / contact)) : 1;
}

static int cut(struct nc_step *step, const struct path_item *item)
{
    const struct path *path = step->path;
    if (!step->state.begun) {
        if (item->kind != PATH_POINT)
            return error_at(step->error, path->name, item->line,
                            "found a curve before any point, expected a GOTO first");
        if (approach(step, item->to) != 0)
            return -1;
    }
    if (step->state.feed <= 0) {
        step->state.feed = step->wish.feed;
        step->plan->total.feed_assumed = true;
    }
    struct motion motion = nc_item_motion(path, item, step->state.pose);
    step->state.faster = contact_factor(step, item);
    step->state.why = NC_WHY_PATH;
    int result = nc_step_motion(step, &motion);
    step->state.faster = 1;
    step->state.touches = item->touches;
    if (item->touches)
        step->state.contact = path->contact.item[item->contact];
    return result;
}

/* Where the path, or a tool's part of it, ends in the cut: off the part along the tool axis. */
static int depart(struct nc_step *step)
{
    struct pose up = step->state.pose;
    size_t last = step->plan->move.n;
    while (last && !nc_moves(&step->plan->move.item[last - 1]))
        last--;
    if (!last || step->plan->move.item[last - 1].kind == NC_RAPID ||
        step->plan->move.item[last - 1].kind == NC_HOLE)
        return 0;
    double far = step->machine->retract;
    if (up.a.z > 0.2 && step->clear > up.p.z)
        far = fmax(far, (step->clear - up.p.z) / up.a.z);
    up.p = vec_along(up.p, far, up.a);
    step->plan->total.retract_made = true;
    step->state.why = NC_WHY_RETRACT;
    return nc_step_rapid(step, up);
}

/* Half of the last digit of each word, at the tracked point and at the ball. */
static struct deviation rounding(const struct nc_step *step)
{
    const struct nc_ability *ability = &step->plan->ability;
    double linear = sqrt(3) * 0.5 * pow(10, -ability->digits.linear);
    double axis = ability->mode == FOLLOW_VECTOR
                      ? sqrt(3) * 0.5 * pow(10, -ability->digits.vector)
                      : RADIANS(sqrt(2) * 0.5 * pow(10, -ability->digits.angle));
    return (struct deviation){linear + fabs(step->follow.ball) * axis, axis};
}

/* The ball of the tool in the spindle, and what rounding leaves of the tolerance with it. */
static void measure_tool(struct nc_step *step, double ball)
{
    bool centre = step->path->head.track == TRACK_CENTRE;
    step->follow.ball = ball > 0 ? centre ? -ball : ball : 0;
    struct deviation last = rounding(step);
    step->allowed = (struct deviation){sampled * step->wish.chord + last.point,
                                       sampled * step->wish.axis_tolerance + last.axis};
}

/* Another tool or plane: home from here, and from home to the motion that follows, if there is
 * one. */
static int begin_anew(struct nc_step *step, const struct path_item *item)
{
    const struct path *path = step->path;
    const struct path_item *end = path->item.item + path->item.n, *next = item;
    while (next < end && !is_motion(next))
        next++;
    if (next == end)
        return 0;
    if (step->state.begun && depart(step) != 0)
        return -1;
    step->state.begun = false;
    step->state.touches = false;
    if (item->kind == PATH_TOOL)
        measure_tool(step, path_tool_ball(&path->tool.item[item->index]));
    add_note(step, item->kind == PATH_TOOL ? NC_TOOL : NC_PLANE, item);
    return 0;
}

static int plan_item(struct nc_step *step, const struct path_item *item)
{
    if (item->line)
        step->state.line = item->line;
    step->state.why = NC_WHY_PATH;
    switch (item->kind) {
    case PATH_PASS:
        step->state.pass = item->index;
        step->plan->total.passes++;
        add_note(step, NC_PASS, item);
        return 0;
    case PATH_TEXT:
        add_note(step, NC_TEXT, item);
        return 0;
    case PATH_FEED:
        step->state.feed = item->feed;
        return 0;
    case PATH_POINT:
        if (!item->rapid)
            return cut(step, item);
        step->state.touches = false;
        return nc_step_rapid(step, item->to);
    case PATH_ARC:
    case PATH_SPLINE:
        break;
    case PATH_HOLE:
        return nc_hole(step, item);
    case PATH_TOOL:
    case PATH_PLANE:
        return begin_anew(step, item);
    }
    return cut(step, item);
}

static bool begins_anew(const struct path_item *item)
{
    return item->kind == PATH_TOOL || item->kind == PATH_PLANE;
}

/* Behind the group that starts at `from`: the next rapid that comes after a cut, or tool. */
static size_t group_end(const struct path *path, size_t from)
{
    bool cutting = false;
    for (size_t i = from; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        bool rapid = item->kind == PATH_POINT && item->rapid;
        if ((rapid && cutting) || (begins_anew(item) && i > from))
            return i;
        cutting = cutting || (is_motion(item) && !rapid);
    }
    return path->item.n;
}

/* The first motion from item i on whose tool axis is not singular, else the path's end. */
static size_t next_tilted(const struct nc_step *step, size_t i)
{
    const struct path *path = step->path;
    while (i < path->item.n && (!is_motion(&path->item.item[i]) ||
                                chain_free(&step->machine->chain, path->item.item[i].to.a)))
        i++;
    return i;
}

/* ahead: what was found by looking ahead over the group, NULL: nothing. */
static int plan_items(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t to)
{
    size_t tilted = from;
    step->first = true;
    for (size_t i = from; i < to; i++) {
        if (tilted <= i)
            tilted = next_tilted(step, i + 1);
        step->ahead = tilted < step->path->item.n ? &step->path->item.item[tilted].to.a : NULL;
        size_t place = ahead ? ahead->start.item[i - from] : 0;
        bool moves = is_motion(&step->path->item.item[i]);
        step->aim = ahead && place == 0 ? ahead->item[0].q : NULL;
        if (ahead && moves && place + 1 < ahead->n && ahead->item[place].turn &&
            nc_step_turn(step, ahead->item[place + 1].q) != 0)
            return -1;
        if (plan_item(step, &step->path->item.item[i]) != 0)
            return -1;
    }
    return 0;
}

static int plan_group(struct nc_step *step, size_t from, size_t to)
{
    static const struct nc_branch attempt[] = {{-1, -1, 0},  {0, -1, 0}, {1, -1, 0}, {-1, -1, 1},
                                               {-1, -1, -1}, {0, 0, 0},  {1, 1, 0}};
    struct mark mark = mark_of(step);
    step->may_turn = false;
    for (size_t i = 0; i < sizeof attempt / sizeof *attempt; i++) {
        step->branch = attempt[i];
        if (plan_items(step, NULL, from, to) == 0)
            return 0;
        if (!step->plan->unmet)
            return -1;
        back_to(step, &mark);
    }
    step->branch = attempt[0];
    step->may_turn = true;
    struct nc_ahead ahead;
    bool found = nc_ahead_make(&ahead, step, from, to);
    int result = found ? plan_items(step, &ahead, from, to) : -1;
    nc_ahead_free(&ahead);
    step->aim = NULL;
    if (found && (result == 0 || !step->plan->unmet))
        return result;
    back_to(step, &mark);
    return plan_items(step, NULL, from, to);
}

/* The clearance plane or, where the path names none, its highest rapid. */
static double clear_height(const struct path *path)
{
    double z = path->head.clearance;
    for (size_t i = 0; i < path->item.n && isnan(path->head.clearance); i++)
        if (path->item.item[i].kind == PATH_POINT && path->item.item[i].rapid)
            z = fmax(z, path->item.item[i].to.p.z);
    return z;
}

int nc_plan_make(struct nc_plan *plan, const struct path *path, const struct machine *machine,
                 struct nc_ability ability, struct nc_wish wish, struct error *error)
{
    *plan = (struct nc_plan){.ability = ability};
    struct nc_step step = {.path = path,
                           .machine = machine,
                           .plan = plan,
                           .wish = wish,
                           .error = error,
                           .branch = {-1, -1, 0}};
    if (path->head.track == TRACK_CONTACT)
        return error_set(error,
                         "%s: found a path of contact points (TRACK/CONTACT), expected one of tool "
                         "tips or ball centres",
                         path->name);
    step.follow = (struct follow){.mode = ability.mode, .chain = &machine->chain};
    step.clear = clear_height(path);
    array_reserve(&plan->move, path->item.n + path->item.n / 16); /* most are blocks as they are */
    step.state.faster = 1;
    step.state.turned = chain_turned(&machine->chain, step.state.at.q);
    measure_tool(&step, path_ball(path));
    for (size_t from = 0; from < path->item.n;) {
        size_t to = group_end(path, from);
        if (plan_group(&step, from, to) != 0)
            return -1;
        from = to;
    }
    if (!step.state.begun)
        return error_set(error, "%s: found no motion, expected at least one GOTO", path->name);
    return depart(&step);
}

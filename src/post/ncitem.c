/* ncitem - see ncitem.h. */
#include "ncitem.h"

#include "base/array.h"
#include "ncahead.h"
#include "post/nchole.h"
#include "post_rewind.h"

/* Of a tolerance: the worst place of a block may lie between those that are looked at. */
static const double sampled = 0.9;

/* A note among the blocks: a pass, or a statement that the dialect may know. */
static void add_note(struct nc_step *step, enum nc_kind kind, const struct path_item *item)
{
    struct nc_move *move = array_push(&step->plan->move);
    *move = (struct nc_move){.kind = kind, .line = item->line, .index = item->index};
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
    step->state.faster = contact_factor(step, item);
    step->state.why = NC_WHY_PATH;
    int result = 0;
    if (item->kind == PATH_POINT) {
        result = nc_step_line(step, item->to);
    } else {
        struct motion motion = path_item_motion(path, item, step->state.pose);
        result = nc_step_motion(step, &motion);
    }
    step->state.faster = 1;
    step->state.touches = item->touches;
    if (item->touches)
        step->state.contact = path->contact.item[item->contact];
    return result;
}

int nc_item_depart(struct nc_step *step)
{
    size_t last = step->plan->move.n;
    while (last && !nc_moves(&step->plan->move.item[last - 1]))
        last--;
    if (!last || step->plan->move.item[last - 1].kind == NC_RAPID ||
        step->plan->move.item[last - 1].kind == NC_HOLE)
        return 0;
    step->plan->total.retract_made = true;
    step->state.why = NC_WHY_RETRACT;
    return nc_step_rapid(step, nc_pose_off(step));
}

/* Half of the last digit of each word, at the tracked point and at the ball. */
static struct pose_deviation rounding(const struct nc_step *step)
{
    const struct nc_ability *ability = &step->plan->ability;
    double linear = sqrt(3) * 0.5 * pow(10, -ability->digits.linear);
    double axis = ability->mode == INTERPOLATE_VECTOR
                      ? sqrt(3) * 0.5 * pow(10, -ability->digits.vector)
                      : RADIANS(sqrt(2) * 0.5 * pow(10, -ability->digits.angle));
    return (struct pose_deviation){linear + fabs(step->follow.ball) * axis, axis};
}

void nc_item_tool(struct nc_step *step, double ball)
{
    bool centre = step->path->head.track == TRACK_CENTRE;
    step->follow.ball = ball > 0 ? centre ? -ball : ball : 0;
    struct pose_deviation last = rounding(step);
    step->allowed = (struct pose_deviation){sampled * step->wish.chord + last.point,
                                            sampled * step->wish.axis_tolerance + last.axis};
}

/* Another tool or plane: home from here, and from home to the motion that follows, if there is
 * one. */
static int begin_anew(struct nc_step *step, const struct path_item *item)
{
    const struct path *path = step->path;
    const struct path_item *end = path->item.item + path->item.n, *next = item;
    bool tool = item->kind == PATH_TOOL;
    while (next < end && !path_moves(next))
        next++;
    if (next == end)
        return 0;
    if (step->state.begun && nc_item_depart(step) != 0)
        return -1;
    step->state.begun = false;
    step->state.touches = false;
    if (tool)
        nc_item_tool(step, path_tool_ball(&path->tool.item[item->index]));
    add_note(step, tool ? NC_TOOL : NC_PLANE, item);
    return 0;
}

int nc_item(struct nc_step *step, const struct path_item *item)
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

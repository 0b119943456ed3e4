/* post_item - see post_item.h. */
#include "post_item.h"

#include "base/array.h"
#include "base/num.h"
#include "post_hole.h"
#include "post_ik.h"
#include "post_block.h"
#include "post_motion.h"
#include "post_rewind.h"

/* Of a tolerance: the worst place of a block may lie between those that are looked at. */
static const double sampled = 0.9;

/* A note among the blocks: a pass, or a statement that the dialect may know. */
static void add_note(struct nc_planner *planner, enum nc_kind kind, const struct path_item *item)
{
    struct nc_move *move = array_push(&planner->plan->move);
    *move = (struct nc_move){.kind = kind, .line = item->line, .index = item->index};
}

/* The first motion of a tool: at the top of the path, from where it goes down along its axis.  A
 * top out of the machine's travel is left out: then the way down is straight from home. */
static void start_above(struct nc_planner *planner, struct pose first)
{
    struct pose above = post_rewind_above(planner, first);
    struct error *error = planner->error, unheard;
    if (above.p.z <= first.p.z)
        return;
    planner->state.why = NC_WHY_APPROACH;
    planner->error = &unheard;
    if (post_motion_rapid(planner, above) != 0)
        planner->plan->unmet = false;
    planner->error = error;
    planner->state.why = NC_WHY_PATH;
}

/* A path that starts with a cut: above its first point first, along the tool axis. */
static int approach_above(struct nc_planner *planner, struct pose first)
{
    struct pose above = first;
    above.p = vec_along(first.p, planner->machine->retract, first.a);
    planner->plan->total.approach_made = true;
    start_above(planner, above);
    planner->state.why = NC_WHY_APPROACH;
    return post_motion_rapid(planner, above);
}

/*
 * How much faster than its feed the tracked point must go for the contact point to keep it: the
 * ratio of their ways, from a tenth to ten.
 */
static double contact_factor(const struct nc_planner *planner, const struct path_item *item)
{
    if (!planner->options.contact_feed || !item->touches || !planner->state.touches)
        return 1;
    double tip = vec_distance(planner->state.pose.p, item->to.p);
    struct contact at = planner->path->contact.item[item->contact];
    double contact = vec_distance(planner->state.contact.p, at.p);
    return tip > 0 && contact > 0 ? fmin(10, fmax(0.1, tip / contact)) : 1;
}

static int plan_cut(struct nc_planner *planner, const struct path_item *item)
{
    const struct path *path = planner->path;
    if (!planner->state.begun) {
        if (item->kind != PATH_POINT)
            return error_at(planner->error, path->name, item->line,
                            "found a curve before any point, expected a GOTO first");
        if (approach_above(planner, item->to) != 0)
            return -1;
    }
    if (planner->state.feed <= 0) {
        planner->state.feed = planner->options.feed;
        planner->plan->total.feed_assumed = true;
    }
    planner->state.faster = contact_factor(planner, item);
    planner->state.why = NC_WHY_PATH;
    int result = 0;
    if (item->kind == PATH_POINT) {
        result = post_rewind_line(planner, item->to);
    } else {
        struct motion motion = path_item_motion(path, item, planner->state.pose);
        result = post_rewind_motion(planner, &motion);
    }
    planner->state.faster = 1;
    planner->state.touches = item->touches;
    if (item->touches)
        planner->state.contact = path->contact.item[item->contact];
    return result;
}

/* The tool has been led out of the part, though not at rapid: it stands over the clearance plane
 * that the path names. */
static bool is_out(const struct nc_planner *planner)
{
    return !planner->state.touches &&
           planner->state.pose.p.z >= planner->path->head.clearance - 1e-6; /* NAN: none is named */
}

int post_item_retract(struct nc_planner *planner)
{
    size_t last = planner->plan->move.n;
    while (last && !nc_moves(&planner->plan->move.item[last - 1]))
        last--;
    if (!last || planner->plan->move.item[last - 1].kind == NC_RAPID ||
        planner->plan->move.item[last - 1].kind == NC_HOLE || is_out(planner))
        return 0;
    planner->plan->total.retract_made = true;
    planner->state.why = NC_WHY_RETRACT;
    struct pose off = post_rewind_retracted(planner);
    if (isfinite(off.p.x))
        return post_motion_leave(planner, off);
    planner->plan->unmet = true;
    return error_at(planner->error, planner->path->name, planner->state.line,
                    "pass %zu: found no way home from a cut with the tool upside down, expected a "
                    "rapid from there",
                    planner->state.pass);
}

/* Half of the last digit of each word, at the tracked point and at the ball. */
static struct pose_deviation rounding_deviation(const struct nc_planner *planner)
{
    const struct nc_ability *ability = &planner->plan->ability;
    double linear = sqrt(3) * 0.5 * pow(10, -ability->digits.linear);
    double axis = ability->mode == INTERPOLATE_VECTOR
                      ? sqrt(3) * 0.5 * pow(10, -ability->digits.vector)
                      : RADIANS(sqrt(2) * 0.5 * pow(10, -ability->digits.angle));
    return (struct pose_deviation){linear + fabs(planner->follow.ball) * axis, axis};
}

int post_item_length(struct nc_planner *planner)
{
    bool known = post_ik_chain(planner->base, planner->state.tool, planner->options.unit,
                               &planner->own->chain);
    planner->safe_radius = post_ik_safe_radius(planner->own);
    if (known || planner->follow.mode != INTERPOLATE_JOINT || !machine_has_head(planner->base))
        return 0;
    return error_set(planner->error,
                     "%s: found no length of tool %d in the machine file, expected tool.%d.length "
                     "or a table of tools",
                     planner->path->name, planner->state.tool, planner->state.tool);
}

void post_item_tool(struct nc_planner *planner, double ball)
{
    bool centre = planner->path->head.track == TRACK_CENTRE;
    planner->follow.ball = ball > 0 ? centre ? -ball : ball : 0;
    struct pose_deviation last = rounding_deviation(planner);
    planner->allowed =
        (struct pose_deviation){sampled * planner->options.chord + last.point,
                                sampled * planner->options.axis_tolerance + last.axis};
    planner->near_pole = post_ik_near_pole(planner);
}

/* Another tool or plane: home from here, and from home to the motion that follows, if there is
 * one. */
static int change_tool_or_plane(struct nc_planner *planner, const struct path_item *item)
{
    const struct path *path = planner->path;
    const struct path_item *end = path->item.item + path->item.n, *next = item;
    bool tool = item->kind == PATH_TOOL;
    while (next < end && !path_moves(next))
        next++;
    if (next == end)
        return 0;
    if (planner->state.begun && post_item_retract(planner) != 0)
        return -1;
    planner->state.begun = false;
    planner->state.touches = false;
    if (tool) {
        post_item_tool(planner, path_tool_ball(&path->tool.item[item->index]));
        planner->state.tool = path->tool.item[item->index].number;
        if (post_item_length(planner) != 0)
            return -1;
    }
    add_note(planner, tool ? NC_TOOL : NC_PLANE, item);
    return 0;
}

/* The tool stands where it left a hole of the same cycle with its mouth as high. */
static bool follows_same_cycle(const struct nc_planner *planner, const struct nc_hole *hole)
{
    const struct nc_plan *plan = planner->plan;
    size_t last = plan->move.n;
    while (last && !nc_moves(&plan->move.item[last - 1]))
        last--;
    if (!planner->state.begun || !last || plan->move.item[last - 1].kind != NC_HOLE)
        return false;
    const struct nc_hole *before = &plan->hole.item[plan->move.item[last - 1].index];
    return before->cycle == hole->cycle && before->mouth.z == hole->mouth.z;
}

/* Above the mouth, no lower than now and than where the tool leaves; down to there. */
static int move_above_hole(struct nc_planner *planner, struct pose above)
{
    struct pose over = above;
    if (!planner->state.begun)
        start_above(planner, above);
    if (planner->state.begun && planner->state.pose.p.z > above.p.z)
        over.p.z = planner->state.pose.p.z;
    if (planner->state.begun && planner->state.pose.p.z < above.p.z) {
        struct pose up = planner->state.pose;
        up.p.z = above.p.z;
        if (post_motion_rapid(planner, up) != 0)
            return -1;
    }
    if (post_motion_rapid(planner, over) != 0)
        return -1;
    return over.p.z > above.p.z ? post_motion_rapid(planner, above) : 0;
}

/* Length and time of the way down and out. */
static void count_hole(struct nc_planner *planner, const struct nc_hole *hole, double over)
{
    const struct path_cycle *c = hole->cycle;
    struct nc_total *total = &planner->plan->total;
    bool slow = nc_hole_slow(hole);
    double down = hole->depth + hole->clear, out = hole->depth + hole->retract;
    double lift = hole->retract - hole->clear, rapid = over + lift + (slow ? lift : out);
    total->holes++;
    total->cut += slow ? 2 * down : down;
    total->rapid += rapid;
    total->minutes += (slow ? 2 * down : down) / hole->feed + c->dwell / 60 +
                      rapid / planner->machine->rapid[MACHINE_X];
}

static struct vec3 printed_point(const struct nc_planner *planner, struct vec3 p)
{
    return vec_round(p, planner->plan->ability.digits.linear);
}

static int drill_hole(struct nc_planner *planner, const struct path_item *item)
{
    const struct path_cycle *c = &planner->path->cycle.item[item->index];
    int digits = planner->plan->ability.digits.linear;
    struct nc_hole hole = {.mouth = printed_point(planner, item->to.p),
                           .cycle = c,
                           .depth = num_round(c->depth, digits),
                           .clear = num_round(c->clear, digits),
                           .retract = num_round(c->retract, digits)};
    struct pose above = {hole.mouth, item->to.a}, bottom = above;
    above.p.z = nc_hole_level(&hole);
    bottom.p.z = nc_hole_bottom(&hole);
    double over = 0;
    if (c->feed <= 0 && planner->state.feed <= 0) {
        planner->state.feed = planner->options.feed;
        planner->plan->total.feed_assumed = true;
    }
    hole.feed = fmin(c->feed > 0 ? c->feed : planner->state.feed, planner->plan->ability.feed_max);
    if (follows_same_cycle(planner, &hole))
        over = vec_distance(planner->state.pose.p, above.p);
    else if (move_above_hole(planner, above) != 0)
        return -1;
    struct machine_pose deep = post_ik_pose(planner, bottom, planner->state.at.q);
    struct machine_pose to = post_ik_pose(planner, above, planner->state.at.q);
    if (post_ik_check_linear(planner, &deep) != 0 || post_ik_check_linear(planner, &to) != 0)
        return -1;
    struct nc_move *move = post_block_append(planner, NC_HOLE, &to);
    move->why = NC_WHY_PATH;
    move->feed = hole.feed;
    move->index = (unsigned)planner->plan->hole.n;
    *array_push(&planner->plan->hole) = hole;
    count_hole(planner, &hole, over);
    planner->state.pose = above;
    planner->state.touches = false;
    return 0;
}

int post_item(struct nc_planner *planner, const struct path_item *item)
{
    if (item->line)
        planner->state.line = item->line;
    planner->state.why = NC_WHY_PATH;
    switch (item->kind) {
    case PATH_PASS:
        planner->state.pass = item->index;
        planner->plan->total.passes++;
        add_note(planner, NC_PASS, item);
        return 0;
    case PATH_TEXT:
        add_note(planner, NC_TEXT, item);
        return 0;
    case PATH_FEED:
        planner->state.feed = item->feed;
        return 0;
    case PATH_POINT:
        if (!item->rapid)
            return plan_cut(planner, item);
        planner->state.touches = false;
        if (!planner->state.begun)
            start_above(planner, item->to);
        return post_motion_rapid(planner, item->to);
    case PATH_ARC:
    case PATH_SPLINE:
        break;
    case PATH_HOLE:
        return drill_hole(planner, item);
    case PATH_TOOL:
    case PATH_PLANE:
        return change_tool_or_plane(planner, item);
    }
    return plan_cut(planner, item);
}

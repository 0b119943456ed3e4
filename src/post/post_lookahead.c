/* post_lookahead - see post_lookahead.h. */
#include "post_lookahead.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/num.h"
#include "machine/ik_plan.h"
#include "post_ik.h"
#include "post_item.h"
#include "post_block.h"
#include "post_motion.h"
#include "post_rewind.h"
#include "post_travel.h"

/* ---- the look ahead: the places of a group, and the shortest way through them (ik_plan.h) */

/* A part of a motion, from s0 to s1, that may be one block past the singular direction: it ends at
 * that place. */
struct crossing {
    size_t end;
    struct motion motion;
    double s0, s1;
};

struct lookahead {
    size_t n, cap;
    struct ik_plan_place *item; /* along the group, from where its rapids have led to */
    struct doubles s;           /* of each place: how far along its motion, 0 to 1 */
    struct sizes start;         /* of each item of the group: the place where it starts; then that
                                   where the last one ends */
    struct {
        size_t n, cap;
        struct crossing *item;
    } crossing;
    struct chain_solutions found; /* at the last place */
    const struct nc_planner *planner;
    struct ik_plan_cost cost; /* of the way that was found */
};

static const double CROSSING_SHARE = 0.7; /* of what is allowed; the rest is for the chords */

enum { DEPTH = 12, SPAN_PIECES = 8, HALVINGS = 45, PLACES_MAX = 10000000 };

static void add_place_found(struct lookahead *ahead, struct pose at, double s, bool may_turn,
                            const struct chain_solutions *found)
{
    const struct nc_planner *planner = ahead->planner;
    struct ik_plan_place place = {
        .axis = at.a, .may_turn = may_turn, .known = true, .solutions = *found};
    if (vec_dot(at.p, at.p) >= planner->safe_radius * planner->safe_radius)
        for (int k = 0; k < found->n && !found->free; k++)
            place.shut[k] = post_ik_linear_over(planner, at.p, found->q[k]) >= 0;
    *array_push(ahead) = place;
    *array_push(&ahead->s) = s;
}

static void add_place(struct lookahead *ahead, struct pose at, double s, bool may_turn)
{
    struct chain_solutions found = chain_angles(&ahead->planner->machine->chain, at.a);
    add_place_found(ahead, at, s, may_turn, &found);
}

/* Where between two places, by one of the solutions, an axis comes to an end of its travel; s0: it
 * does not. */
static double end_between(const struct kinematic_chain *chain, const struct motion *motion,
                          double s0, double s1, const struct chain_solutions *a,
                          const struct chain_solutions *b, int solution)
{
    double low = s0, high = s1, share;
    if (!ik_branch_end(chain, a, b, solution, &share))
        return s0;
    for (int i = 0; i < HALVINGS; i++) { /* before the end, by less than the last digit */
        double mid = (low + high) / 2;
        struct chain_solutions at = chain_angles(chain, motion_at(motion, mid).a);
        *(ik_branch_end(chain, a, &at, solution, &share) ? &high : &low) = mid;
    }
    return low;
}

/* A place of its own there, before s1 where the direction is a1: the tool may turn, though rather
 * at the end of a motion. */
static void add_ends_of_travel(struct lookahead *ahead, const struct kinematic_chain *chain,
                               const struct motion *motion, double s0, double s1, struct vec3 a1)
{
    struct chain_solutions a = ahead->found, b = chain_angles(chain, a1);
    double end[2];
    for (int k = 0; k < 2; k++)
        end[k] = end_between(chain, motion, s0, s1, &a, &b, k);
    for (int i = 0; i < 2; i++) {
        double s = i ? fmax(end[0], end[1]) : fmin(end[0], end[1]);
        if (s <= s0)
            continue;
        add_place(ahead, motion_at(motion, s), s, true);
        ahead->item[ahead->n - 1].inside = true;
        s0 = s;
    }
    ahead->found = b;
}

/* Two directions are no further apart than a small angle; mostly their sine says it. */
static bool is_close(struct vec3 a, struct vec3 b, double angle)
{
    struct vec3 across = vec_cross(a, b);
    return (vec_dot(a, b) > 0 && vec_dot(across, across) < 0.98 * angle * angle) ||
           vec_angle(a, b) <= angle;
}

/* Places of a motion after s0, where the direction is a0, up to s1. */
static void add_places(struct lookahead *ahead, const struct kinematic_chain *chain,
                       const struct motion *motion, double s0, struct vec3 a0, double s1, int depth)
{
    struct pose to = motion_at(motion, s1);
    double close = fmin(ik_branch_step(chain, a0), ik_branch_step(chain, to.a));
    if (is_close(a0, to.a, close) || depth == DEPTH || ahead->n > PLACES_MAX) {
        add_ends_of_travel(ahead, chain, motion, s0, s1, to.a);
        add_place_found(ahead, to, s1, false, &ahead->found);
        return;
    }
    double mid = (s0 + s1) / 2;
    add_places(ahead, chain, motion, s0, a0, mid, depth + 1);
    add_places(ahead, chain, motion, mid, motion_at(motion, mid).a, s1, depth + 1);
}

/* The motion is, or may be, straight blocks of any length. */
static bool is_in_blocks(const struct lookahead *ahead, const struct motion *motion)
{
    const struct nc_ability *ability = &ahead->planner->plan->ability;
    return motion->kind == MOTION_LINE ||
           (motion->kind == MOTION_ARC && ability->arcs == NC_ARCS_NONE) ||
           (motion->kind == MOTION_SPLINE && ability->splines == NC_SPLINES_NONE);
}

/* How far a place is off the singular direction: the sine. */
static double off_singular(const struct lookahead *ahead, size_t i)
{
    return vec_length(
        vec_cross(ahead->planner->machine->chain.rotary[0].axis, ahead->item[i].axis));
}

/* The end of a block at s of the motion, the tip as a control with tool-centre-point control has
 * it.
 */
static struct block_pose turned_at(const struct kinematic_chain *chain, const struct motion *motion,
                                   double s, const double q[])
{
    struct block_pose at = {.p = motion_at(motion, s).p, .a = chain_axis(chain, q)};
    for (int i = 0; i < ROTARY_MAX; i++)
        at.q[i] = q[i];
    return at;
}

/*
 * From the angles q0 to q1 in one block it is near enough to the motion; without tool-centre-point
 * control in a row of blocks, in which the angles turn evenly, with room for the chords.
 */
static bool crosses_within(const struct lookahead *ahead, const struct crossing *c,
                           const double q0[], const double q1[])
{
    const struct nc_planner *planner = ahead->planner;
    struct interpolation follow = planner->follow;
    struct pose_deviation allowed = planner->allowed;
    if (follow.mode == INTERPOLATE_JOINT) {
        follow.mode = INTERPOLATE_ROTARY;
        allowed.point *= CROSSING_SHARE;
        allowed.axis *= CROSSING_SHARE;
    }
    struct block_pose from = turned_at(follow.chain, &c->motion, c->s0, q0),
                      to = turned_at(follow.chain, &c->motion, c->s1, q1);
    return pose_deviation_within(interpolation_block(&follow, &from, &to, &c->motion, c->s0, c->s1),
                                 allowed);
}

/* The same from one solution to the other. */
static bool changes_within(const struct lookahead *ahead, const struct crossing *c)
{
    const struct kinematic_chain *chain = &ahead->planner->machine->chain;
    struct chain_solutions from = chain_angles(chain, motion_at(&c->motion, c->s0).a),
                           to = chain_angles(chain, motion_at(&c->motion, c->s1).a);
    double q[ROTARY_MAX];
    if (from.n < 2 || to.n < 2)
        return false;
    for (int i = 0; i < ROTARY_MAX; i++)
        q[i] = angle_nearest(to.q[1][i], from.q[0][i]);
    return crosses_within(ahead, c, from.q[0], q);
}

/*
 * The widest part of the motion about its place `nearest`, of its places from `first` to `last`,
 * that is one block: the whole, or as many places to both sides as may be.  None: the whole of a
 * straight motion, and else false.
 */
static bool widest_crossing(const struct lookahead *ahead, const struct motion *motion,
                            size_t first, size_t nearest, size_t last, struct crossing *crossing)
{
    struct crossing c = {.end = last, .motion = *motion, .s1 = 1};
    bool straight = motion->kind == MOTION_LINE, any = false;
    *crossing = c;
    if (straight && changes_within(ahead, &c))
        return true;
    for (size_t by = 1; first + by <= nearest || nearest + by <= last; by++) {
        size_t from = nearest > first + by ? nearest - by : first;
        c.end = nearest + by < last ? nearest + by : last;
        c.s0 = from > first ? ahead->s.item[from] : 0;
        c.s1 = ahead->s.item[c.end];
        if (changes_within(ahead, &c)) {
            *crossing = c;
            any = true;
        } else if (any) {
            break;
        }
    }
    return any || straight;
}

/* Within twice what the tool axis may be off, it may go past the singular direction in one block.
 */
static void add_crossing(struct lookahead *ahead, const struct motion *motion, size_t start)
{
    double near = 2 * ahead->planner->allowed.axis;
    size_t nearest = start, last = ahead->n - 1;
    struct crossing crossing;
    if (ahead->planner->machine->chain.n != 2 || !is_in_blocks(ahead, motion))
        return;
    for (size_t i = start + 1; i < last; i++)
        if (off_singular(ahead, i) < near &&
            (nearest == start || off_singular(ahead, i) < off_singular(ahead, nearest)))
            nearest = i;
    if (nearest == start || !widest_crossing(ahead, motion, start, nearest, last, &crossing))
        return;
    size_t first = start;
    while (crossing.s0 > 0 && ahead->s.item[first + 1] <= crossing.s0)
        first++;
    ahead->item[crossing.end].crossing = (unsigned)(crossing.end - first);
    *array_push(&ahead->crossing) = crossing;
}

/* To the bit: a zero of the other sign has other angles. */
static bool is_same_axis(struct vec3 a, struct vec3 b)
{
    return vec_compare(&a, &b) == 0 && signbit(a.x) == signbit(b.x) &&
           signbit(a.y) == signbit(b.y) && signbit(a.z) == signbit(b.z);
}

static void add_motion(struct lookahead *ahead, const struct kinematic_chain *chain,
                       const struct motion *motion)
{
    double s = 0;
    struct vec3 a = motion_at(motion, 0).a;
    size_t start = ahead->n - 1;
    const struct ik_plan_place *last = &ahead->item[start];
    ahead->found = is_same_axis(a, last->axis) ? last->solutions : chain_angles(chain, a);
    while (s < 1) {
        double from = s, next = motion_next_knot(motion, s);
        int pieces = motion->kind == MOTION_SPLINE ? SPAN_PIECES : 1;
        for (int i = 1; i <= pieces; i++) {
            double to = from + (next - from) * i / pieces;
            add_places(ahead, chain, motion, s, a, to, 0);
            a = ahead->item[ahead->n - 1].axis;
            s = to;
        }
        s = next;
    }
    ahead->item[ahead->n - 1].may_turn = true;
    if (ahead->n > start + 2)
        add_crossing(ahead, motion, start);
}

/* May one block lead from one end of a crossing to the other? */
static bool may_cross(const void *with, size_t from, size_t to, const double q0[],
                      const double q1[])
{
    const struct lookahead *ahead = with;
    size_t low = 0, high = ahead->crossing.n - 1;
    (void)from; /* the end of a crossing says which it is */
    while (low < high) {
        size_t mid = (low + high) / 2;
        if (ahead->crossing.item[mid].end < to)
            low = mid + 1;
        else
            high = mid;
    }
    const struct crossing *c = &ahead->crossing.item[low];
    return crosses_within(ahead, c, q0, q1);
}

static void add_items(struct lookahead *ahead, size_t from, size_t to)
{
    const struct nc_planner *planner = ahead->planner;
    const struct path *path = planner->path;
    bool cutting = false, begun = planner->state.begun;
    struct pose pose = planner->state.pose;
    if (begun)
        add_place(ahead, pose, 1, true);
    for (size_t i = from; i < to && ahead->n < PLACES_MAX; i++) {
        const struct path_item *item = &path->item.item[i];
        bool moves =
            item->kind == PATH_POINT || item->kind == PATH_ARC || item->kind == PATH_SPLINE;
        *array_push(&ahead->start) = ahead->n ? ahead->n - 1 : 0;
        if (!moves)
            continue;
        cutting = cutting || !item->rapid || item->kind != PATH_POINT;
        if (!cutting || !begun) { /* in the clear: only where it leads to matters */
            ahead->n = ahead->s.n = 0;
            add_place(ahead, item->to, 1, true);
        } else {
            struct motion motion = path_item_motion(path, item, pose);
            add_motion(ahead, &planner->machine->chain, &motion);
        }
        pose = item->to;
        begun = true;
    }
    *array_push(&ahead->start) = ahead->n ? ahead->n - 1 : 0;
}

static bool look_ahead_over(struct lookahead *ahead, const struct nc_planner *planner, size_t from,
                            size_t to)
{
    *ahead = (struct lookahead){.planner = planner};
    if (planner->follow.mode == INTERPOLATE_VECTOR || planner->machine->chain.n == 0)
        return false;
    array_reserve(ahead, to - from + (to - from) / 16); /* most items have one place */
    array_reserve(&ahead->s, ahead->cap);
    add_items(ahead, from, to);
    struct ik_plan plan = {.chain = &planner->machine->chain,
                           .cone = planner->allowed.axis / 2,
                           .may_cross = may_cross,
                           .with = ahead};
    return ahead->n > 1 && ahead->n < PLACES_MAX &&
           ik_plan_make(&plan, ahead->item, ahead->n, planner->state.at.q, &ahead->cost) == 0;
}

static void lookahead_free(struct lookahead *ahead)
{
    array_free(&ahead->crossing);
    array_free(&ahead->start);
    array_free(&ahead->s);
    array_free(ahead);
}

/* ---- a group: planned with each block the nearest way, or along what the look ahead found */

static const double far_turn = PI / 6; /* radians: to another solution, or whole turns */

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

/* The end of the group that starts at the item `from`. */
static size_t end_of_group(const struct path *path, size_t from)
{
    bool cutting = false;
    for (size_t i = from; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if ((path_is_rapid(item) && cutting) || (goes_home(item) && i > from))
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
    int result = 0;
    planner->off_part = false;
    planner->aim.n = 0;
    if (post_ik_reach(planner, item->to, 1, &to) != 0)
        return -1;
    double turn = ik_travel(&planner->machine->chain, planner->state.at.q, to.at.q);
    if (turn > 2 * vec_angle(planner->state.pose.a, item->to.a) + far_turn) {
        planner->state.why = NC_WHY_RETRACT;
        result = post_motion_rapid(planner, post_rewind_retracted(planner));
    }
    result = result == 0 ? post_item(planner, item) : -1;
    planner->off_part = true;
    return result;
}

/*
 * Without tool-centre-point control a rapid is many blocks: where it leads to another solution, the
 * axes turn before it, where the tool stands off the part.
 */
static void turn_before_rapid(struct nc_planner *planner, const struct path_item *item)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    struct machine_pose to;
    bool doubt = planner->doubtful;
    int over;
    if (planner->follow.mode == INTERPOLATE_JOINT && planner->off_part && planner->state.begun &&
        post_ik_reach(planner, item->to, 1, &to) == 0 &&
        ik_choose(chain, planner->state.pose.a, to.at.q, true, -1, q, &over) == 0 &&
        ik_travel(chain, q, planner->state.at.q) > far_turn)
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

/* ahead: what was found by looking ahead over the group, NULL: nothing. */
static int plan_items(struct nc_planner *planner, const struct lookahead *ahead, size_t from,
                      size_t to)
{
    bool leading = true, leaving = in_cut(planner);
    planner->off_part = true;
    planner->doubtful = false;
    planner->next_tilted = from;
    planner->aim.n = planner->rewinds.n = 0;
    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &planner->path->item.item[i];
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
    return 0;
}

/* Once more along the way that was found: 0 when it is planned and no worse. */
static int plan_along(struct nc_planner *planner, const struct lookahead *ahead, size_t from,
                      size_t to, const struct checkpoint *checkpoint, double way)
{
    restore_checkpoint(planner, checkpoint);
    planner->rewind = post_rewind_for;
    if (plan_items(planner, ahead, from, to) != 0)
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
    bool found = look_ahead_over(ahead, planner, from, to);
    planner->state = now;
    return found;
}

/* Plans the items [from, to) of the path; -1: the error is filled. */
static int plan_group(struct nc_planner *planner, size_t from, size_t to)
{
    struct checkpoint checkpoint = checkpoint_of(planner);
    struct lookahead ahead;
    planner->rewind = NULL;
    int nearest = plan_items(planner, NULL, from, to);
    if (nearest == 0 ? post_travel_is_least(planner, &checkpoint.since, from, to)
                     : !planner->plan->unmet)
        return nearest;
    double way = nearest == 0 ? post_travel_since(planner, &checkpoint.since) : HUGE_VAL;
    bool found = look_ahead(planner, &ahead, &checkpoint, from, to);
    bool better = found && (nearest != 0 ||
                            (ahead.cost.turns == 0 && post_travel_saves(ahead.cost.travel, way)));
    int result = better ? plan_along(planner, &ahead, from, to, &checkpoint, way) : -1;
    lookahead_free(&ahead);
    planner->aim.n = planner->rewinds.n = 0;
    if (result == 0 || (nearest == 0 && !better))
        return 0;
    restore_checkpoint(planner, &checkpoint);
    planner->rewind = nearest != 0 ? post_rewind_for : NULL;
    return plan_items(planner, NULL, from, to);
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
    array_reserve(&plan->move, path->item.n + path->item.n / 16); /* most are blocks as they are */
    planner.near = ik_near_table(&own.chain);
    planner.safe_radius = post_ik_safe_radius(machine);
    planner.state.faster = 1;
    planner.state.off = (struct pose_deviation){NAN, NAN};
    for (int i = 0; i < own.chain.n; i++) /* at zero, or as near as the travel lets them be */
        planner.state.at.q[i] = fmin(fmax(0, own.chain.rotary[i].min), own.chain.rotary[i].max);
    planner.state.turned = chain_turned(&machine->chain, planner.state.at.q);
    post_item_tool(&planner, path_ball(path));
    planner.state.tool = path->head.tool;
    int result = post_item_length(&planner);
    for (size_t from = 0; from < path->item.n && result == 0;) {
        size_t to = end_of_group(path, from);
        result = plan_group(&planner, from, to);
        from = to;
    }
    array_free(&planner.rewinds);
    if (result == 0 && !planner.state.begun)
        return error_set(error, "%s: found no motion, expected at least one GOTO", path->name);
    return result == 0 ? post_item_retract(&planner) : -1;
}

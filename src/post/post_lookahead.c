/* post_lookahead - see post_lookahead.h. */
#include "post_lookahead.h"

#include <stdlib.h>

#include "base/array.h"
#include "post_ik.h"

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

bool post_lookahead_over(struct lookahead *ahead, const struct nc_planner *planner, size_t from,
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

void post_lookahead_free(struct lookahead *ahead)
{
    array_free(&ahead->crossing);
    array_free(&ahead->start);
    array_free(&ahead->s);
    array_free(ahead);
}
